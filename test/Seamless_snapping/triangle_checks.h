#ifndef SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H

// Triangle meshes out of integer-grid maps in lattice coordinates, against surfaces whose triangles
// are known, and against areas in rationals.

#include "checking.h"
#include "hexagonal_maps.h"
#include "quad_reference.h"

#include <CGAL/Seamless_snapping/Rotational_symmetry.h>
#include <CGAL/Seamless_snapping/extract_triangle_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace triangle_checks {

namespace SS = CGAL::Seamless_snapping;
using namespace hexagonal_maps;
using quad_reference::are_isomorphic;
using Face = Mesh::Face_index;
using Status = SS::Extraction_status;

template <int N>
auto symmetry()
{
  return SS::parameters::rotational_symmetry(SS::Rotational_symmetry<N>());
}

// --- surfaces whose triangles are known ----------------------------------------------------------

// The triangles are those of `expected`, up to the numbering; vertices lie on lattice points of the
// map, and cones are told.
template <typename NamedParameters>
void check_triangles(const Mesh& mesh, const UV_map uv, const Mesh& expected,
                     const NamedParameters& np, const std::string& context)
{
  Mesh triangles;
  auto cones = triangles.add_property_map<Vertex, int>("v:cone", 77).first;
  using Location = std::pair<Face, std::array<double, 3> >;
  auto locations = triangles.add_property_map<Vertex, Location>("v:location").first;
  const auto report = SS::extract_triangle_mesh(
    mesh, uv, triangles, np, SS::parameters::cone_index_map(cones).vertex_location_map(locations));
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, CGAL::is_valid_polygon_mesh(triangles) && CGAL::is_triangle_mesh(triangles));
  CHECK_IN(context, report.area == double(expected.number_of_faces()));
  CHECK_IN(context, report.number_of_faces == expected.number_of_faces());
  CHECK_IN(context, report.number_of_vertices == expected.number_of_vertices());
  CHECK_IN(context, report.number_of_other_polygons == 0 && report.number_of_cut_cells == 0);
  CHECK_IN(context, are_isomorphic(triangles, expected));
  const double scale = std::sqrt(report.area / double(mesh.number_of_faces())); // of unit edges
  CHECK_IN(context, scale > 0);
  for(const Vertex v : triangles.vertices()) {
    CHECK_IN(context,
             cones[v] == (triangles.is_border(v) ? 0 : 6 - int(triangles.degree(v))));
    const auto& [f, weights] = locations[v];
    CHECK_IN(context, (std::min)({weights[0], weights[1], weights[2]}) >= 0);
    CHECK_IN(context, std::abs(weights[0] + weights[1] + weights[2] - 1) < 1e-12);
  }
}

// Lays the faces out so that the first vertex is a point of the lattice at any scale.
inline void unfold_from_first(const Mesh& mesh, UV_map uv)
{
  unfold(mesh, uv);
  Halfedge first = mesh.halfedge(*mesh.vertices().begin());
  if(mesh.is_border(first))
    first = mesh.prev(mesh.opposite(first));
  const Vector back = vector(uv[first], Kernel::Point_2(0, 0));
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      uv[h] = moved(uv[h], back);
}

// The map of a subdivided mesh that is the lattice on the mesh before, warped.
template <int N>
void test_surface(const Mesh& coarse, const unsigned int levels, const std::string& name)
{
  Mesh mesh = subdivided(coarse, levels);
  const UV_map uv = uv_map(mesh);
  std::mt19937 random(levels);
  for(int i = 0; i < 3; ++i) {
    const std::string context = "triangles, " + name + ", N = " + std::to_string(N) + ", levels " +
                                std::to_string(levels) + ", warp " + std::to_string(i);
    unfold_from_first(mesh, uv);
    if(i > 0 && CGAL::is_closed(mesh)) {
      warp<N>(mesh, uv, 0.125, random);
      const std::vector<int> orientations = signs(mesh, uv);
      CHECK_IN(context, std::count(orientations.begin(), orientations.end(), 1) ==
                          std::ptrdiff_t(orientations.size()));
    }
    const double unit = std::ldexp(1., -int(levels));
    const auto scaled = [&](const double s) { return symmetry<N>().grid_scale(s); };
    check_triangles(mesh, uv, coarse, scaled(unit), context);
    check_triangles(mesh, uv, subdivided(coarse, 1), scaled(2 * unit), context);
    check_triangles(mesh, uv, subdivided(coarse, 2), scaled(4 * unit), context);
    Mesh three;
    const auto report = SS::extract_triangle_mesh(mesh, uv, three, scaled(3 * unit));
    CHECK_IN(context, bool(report) && three.number_of_faces() == 9 * coarse.number_of_faces());
    CHECK_IN(context, quad_reference::euler_characteristic(three) ==
                        quad_reference::euler_characteristic(coarse));
  }
}

} // namespace triangle_checks

#endif // SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H
