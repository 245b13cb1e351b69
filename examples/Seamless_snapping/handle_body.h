// Closed and open surfaces of any genus to try a parametrization on: a flat box with a row of
// holes, as it is (with sharp edges) or rounded, meshed by CGAL. The result depends on the arguments
// alone.

#ifndef SEAMLESS_SNAPPING_EXAMPLES_HANDLE_BODY_H
#define SEAMLESS_SNAPPING_EXAMPLES_HANDLE_BODY_H

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

// The boundary of 2 g + 1 by 3 unit cubes, without those in the g holes, as quadrangles.
template <typename Mesh>
void add_box_with_holes(const int genus, Mesh& mesh)
{
  using Point = typename Mesh::Point;
  using Cell = std::array<int, 3>;
  const int length = 2 * genus + 1;
  const auto is_solid = [&](const Cell& c)
  {
    const bool is_hole = c[1] == 1 && c[0] % 2 == 1;
    return c[0] >= 0 && c[0] < length && c[1] >= 0 && c[1] < 3 && c[2] == 0 && !is_hole;
  };

  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > quads;
  std::map<Cell, std::size_t> index;
  const auto corner = [&](const Cell& c)
  {
    const auto inserted = index.emplace(c, points.size());
    if(inserted.second)
      points.emplace_back(c[0], c[1], c[2]);
    return inserted.first->second;
  };
  for(int x = 0; x < length; ++x)
    for(int y = 0; y < 3; ++y)
      for(std::size_t axis = 0; axis < 3; ++axis)
        for(const int side : {-1, 1}) {
          Cell cell{x, y, 0}, neighbor = cell;
          neighbor[axis] += side;
          if(!is_solid(cell) || is_solid(neighbor))
            continue;
          cell[axis] += (side + 1) / 2;
          const std::size_t u = (axis + (side > 0 ? 1 : 2)) % 3;
          const std::size_t v = (axis + (side > 0 ? 2 : 1)) % 3;
          Cell a = cell, b = cell, c = cell;
          ++a[u];
          ++b[u];
          ++b[v];
          ++c[v];
          quads.push_back({corner(cell), corner(a), corner(b), corner(c)});
        }
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, quads, mesh);
}

struct Handle_body_options
{
  int genus = 2;
  bool is_sharp = false;        // keep the edges of the box
  int number_of_borders = 0;    // 0, 1, or 2: ends of the box that are cut off
  double edge_length = 0.25;    // of the triangles; the box is one unit thick
};

template <typename Mesh>
void make_handle_body(const Handle_body_options& options, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Plane = typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::Plane_3;
  add_box_with_holes(options.genus, mesh);
  if(!options.is_sharp)
    CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(3));
  PMP::triangulate_faces(mesh);

  // Off the vertices of the box, and not along its edges.
  const double length = 2 * options.genus + 1;
  if(options.number_of_borders > 0)
    PMP::clip(mesh, Plane(1, 0.03, 0, 0.37 - length));
  if(options.number_of_borders > 1)
    PMP::clip(mesh, Plane(-1, 0.05, 0, 0.36));

  auto is_feature = mesh.template add_property_map<typename Mesh::Edge_index, bool>(
    "e:feature", false).first;
  if(options.is_sharp)
    PMP::detect_sharp_edges(mesh, 60, is_feature);
  PMP::isotropic_remeshing(faces(mesh), options.edge_length, mesh,
                           CGAL::parameters::number_of_iterations(5)
                                            .number_of_relaxation_steps(3)
                                            .edge_is_constrained_map(is_feature));
  mesh.collect_garbage();
}

#endif // SEAMLESS_SNAPPING_EXAMPLES_HANDLE_BODY_H
