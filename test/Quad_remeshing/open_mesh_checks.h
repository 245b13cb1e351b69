// Checks with meshes of the library OpenMesh, where the build system has found it.

#ifndef SEAMLESS_SNAPPING_TEST_OPEN_MESH_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_OPEN_MESH_CHECKS_H

#include "quad_reference.h"

// in this order: CGAL's traits of these meshes take OpenMesh's readers to be known
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace open_mesh {

using namespace quad_reference;
namespace QR = CGAL::Quad_remeshing;

struct Traits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using Open_mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
using Open_halfedge = boost::graph_traits<Open_mesh>::halfedge_descriptor;

// CGAL 5 writes points of these meshes in single precision, whatever their type.
inline void round_points(Mesh& mesh)
{
  for(const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    mesh.point(v) = Point_3(float(p.x()), float(p.y()), float(p.z()));
  }
}

inline void check_quads(const Open_mesh& quads, Mesh expected)
{
  Mesh copy;
  CGAL::copy_face_graph(quads, copy);
  CHECK(CGAL::is_valid_polygon_mesh(quads));
  CHECK(are_isomorphic(copy, expected));
  round_points(copy);
  round_points(expected);
  CHECK(rounded_quads(copy) == rounded_quads(expected));
}

// Extraction and snapping give the same for this mesh as for its copy.
template <typename UVMap>
void check(const Mesh& original, const UVMap& original_uv)
{
  Mesh mesh = original;
  round_points(mesh);
  Open_mesh copy;
  std::vector<std::pair<Halfedge, Open_halfedge> > pairs;
  CGAL::copy_face_graph(mesh, copy, CGAL::parameters::halfedge_to_halfedge_output_iterator(
                                      std::back_inserter(pairs)));
  auto uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), copy);
  for(const auto& [h, g] : pairs)
    put(uv, g, original_uv[h]);

  Mesh expected, quads_of_copy;
  Open_mesh quads, both;
  CHECK(bool(QR::extract_quad_mesh(mesh, original_uv, expected)));
  CHECK(bool(QR::extract_quad_mesh(mesh, original_uv, quads)));
  check_quads(quads, expected);
  CHECK(bool(QR::extract_quad_mesh(copy, uv, quads_of_copy)));
  CHECK(are_isomorphic(quads_of_copy, expected));
  CHECK(rounded_quads(quads_of_copy) == rounded_quads(expected));
  CHECK(bool(QR::extract_quad_mesh(copy, uv, both)));
  check_quads(both, expected);

  int i = 0; // noise, which snapping takes away
  for(const auto& [h, g] : pairs)
    put(uv, g, Point_2(original_uv[h].x() + 1e-9 * (++i % 100), original_uv[h].y()));
  CHECK(!QR::is_seamless(copy, uv));
  CHECK(bool(QR::snap_to_seamless(copy, uv)));
  CHECK(QR::is_seamless(copy, uv));
  double largest_change = 0;
  for(const auto& [h, g] : pairs)
    if(!mesh.is_border(h))
      for(int c = 0; c < 2; ++c)
        largest_change = (std::max)(largest_change,
                                    std::abs(get(uv, g)[c] - original_uv[h][c]));
  CHECK(largest_change < 1e-6);
}

} // namespace open_mesh

#endif // SEAMLESS_SNAPPING_TEST_OPEN_MESH_CHECKS_H
