// Copies a test mesh into a CGAL::Polyhedron_3, corners and features included.

#ifndef SEAMLESS_SNAPPING_TEST_POLYHEDRON_COPY_H
#define SEAMLESS_SNAPPING_TEST_POLYHEDRON_COPY_H

#include "Square_complex_mesh.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <iterator>
#include <utility>
#include <vector>

namespace test_meshes {

using square_complex::feature_map;
using square_complex::uv_map;

// The same surface as a polyhedron, whose uv map is a dynamic property and whose feature edges are
// another.
template <typename Kernel>
class Polyhedron_copy
{
public:
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  using UV_map = typename boost::property_map<
    Polyhedron, CGAL::dynamic_halfedge_property_t<typename Kernel::Point_2> >::type;
  using Feature_map =
    typename boost::property_map<Polyhedron, CGAL::dynamic_edge_property_t<bool> >::type;

  explicit Polyhedron_copy(const CGAL::Surface_mesh<typename Kernel::Point_3>& original)
  {
    using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
    using Pair = std::pair<typename boost::graph_traits<Mesh>::halfedge_descriptor,
                           typename boost::graph_traits<Polyhedron>::halfedge_descriptor>;
    Mesh mesh = original;
    std::vector<Pair> halfedge_pairs;
    CGAL::copy_face_graph(
      mesh, polyhedron,
      CGAL::parameters::halfedge_to_halfedge_output_iterator(std::back_inserter(halfedge_pairs)));
    CGAL::set_halfedgeds_items_id(polyhedron);
    uv = get(CGAL::dynamic_halfedge_property_t<typename Kernel::Point_2>(), polyhedron);
    is_feature = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
    const auto original_uv = uv_map(mesh);
    const auto original_features = feature_map(mesh);
    for(const Pair& pair : halfedge_pairs) {
      put(uv, pair.second, original_uv[pair.first]);
      put(is_feature, CGAL::edge(pair.second, polyhedron),
          original_features[mesh.edge(pair.first)]);
    }
  }

  Polyhedron_copy(const Polyhedron_copy&) = delete; // the maps refer to the member
  Polyhedron_copy& operator=(const Polyhedron_copy&) = delete;

  Polyhedron polyhedron;
  UV_map uv;
  Feature_map is_feature;
};

} // namespace test_meshes

#endif // SEAMLESS_SNAPPING_TEST_POLYHEDRON_COPY_H
