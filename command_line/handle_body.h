// Closed and open surfaces of any genus to try a parametrization on: a flat box with a row of
// holes, as it is (with sharp edges) or rounded, meshed by CGAL. The result depends on the
// arguments alone.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_HANDLE_BODY_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_HANDLE_BODY_H

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/subdivision_method_3.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
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

// Splits each face with four corners.
template <typename Mesh>
void split_quads(Mesh& mesh)
{
  const std::vector<typename Mesh::Face_index> quads(mesh.faces().begin(), mesh.faces().end());
  for(const auto f : quads) {
    const auto h = mesh.halfedge(f);
    if(mesh.next(mesh.next(mesh.next(h))) != h)
      CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  }
}

// Removes what lies on the positive side of a plane that goes through no vertex: the faces that it
// crosses are split along it.
template <typename Mesh, typename Plane>
void cut_off(const Plane& plane, Mesh& mesh)
{
  using Halfedge = typename Mesh::Halfedge_index;
  const auto is_positive = [&](const typename Mesh::Vertex_index v)
  { return plane.has_on_positive_side(mesh.point(v)); };
  const auto height = [&](const typename Mesh::Vertex_index v)
  {
    const auto& p = mesh.point(v);
    return plane.a() * p.x() + plane.b() * p.y() + plane.c() * p.z() + plane.d();
  };

  // Each crossed edge gets a vertex, to which the first of the two halfedges then leads.
  std::vector<Halfedge> crossed;
  for(const auto e : mesh.edges())
    if(is_positive(mesh.vertex(e, 0)) != is_positive(mesh.vertex(e, 1)))
      crossed.push_back(mesh.halfedge(e));
  std::vector<typename Mesh::Face_index> crossed_faces;
  std::set<typename Mesh::Vertex_index> on_plane;
  for(const Halfedge h : crossed) {
    for(const Halfedge side : {h, mesh.opposite(h)})
      if(!mesh.is_border(side))
        crossed_faces.push_back(mesh.face(side));
    const auto u = mesh.source(h), v = mesh.target(h);
    const auto a = mesh.point(u), b = mesh.point(v);
    const double at = height(u) / (height(u) - height(v));
    const auto middle = mesh.target(CGAL::Euler::split_edge(h, mesh));
    mesh.point(middle) = a + at * (b - a);
    on_plane.insert(middle);
  }

  for(const auto f :
      std::set<typename Mesh::Face_index>(crossed_faces.begin(), crossed_faces.end())) {
    Halfedge h = mesh.halfedge(f);
    while(on_plane.count(mesh.target(h)) == 0)
      h = mesh.next(h);
    Halfedge other = mesh.next(h);
    while(on_plane.count(mesh.target(other)) == 0)
      other = mesh.next(other);
    CGAL::Euler::split_face(h, other, mesh);
  }
  split_quads(mesh);
  const std::vector<typename Mesh::Face_index> all(mesh.faces().begin(), mesh.faces().end());
  for(const auto f : all)
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      if(on_plane.count(v) == 0 && is_positive(v)) {
        CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
        break;
      }
}

struct Handle_body_options
{
  int genus = 2;
  bool is_sharp = false;        // keep the edges of the box
  int number_of_borders = 0;    // 0, 1, or 2: ends of the box that are cut off
  double edge_length = 0.25;    // of the triangles; the box is one unit thick
};

// About how many faces the surface has, by those that it had in trials.
inline double expected_number_of_faces(const Handle_body_options& options)
{ return (26 + 43. * options.genus) / (options.edge_length * options.edge_length); }

template <typename Mesh>
void make_handle_body(const Handle_body_options& options, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Plane = typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::Plane_3;
  add_box_with_holes(options.genus, mesh);
  if(!options.is_sharp)
    CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(3));
  split_quads(mesh);

  // Off the vertices of the box, and not along its edges.
  const double length = 2 * options.genus + 1;
  if(options.number_of_borders > 0)
    cut_off(Plane(1, 0.03, 0, 0.37 - length), mesh);
  if(options.number_of_borders > 1)
    cut_off(Plane(-1, 0.05, 0, 0.36), mesh);

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

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_HANDLE_BODY_H
