// What the tests of reading and writing share: meshes with their maps, and all that a file says
// about one, for comparison.

#ifndef SEAMLESS_SNAPPING_TEST_OBJ_MODELS_H
#define SEAMLESS_SNAPPING_TEST_OBJ_MODELS_H

#include "checking.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;

// A mesh with its maps, of either data structure.
template <typename Mesh_, typename Point_2>
struct Model
{
  using Mesh = Mesh_;
  using Halfedge_uv_map =
    typename boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<Point_2> >::type;
  using Edge_bool_map =
    typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool> >::type;

  Mesh mesh;
  Halfedge_uv_map uv_map = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
  Edge_bool_map feature_map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);

  SS::IO::File_status read(const std::string& text)
  {
    std::istringstream is(text);
    return SS::IO::read_OBJ(is, mesh, uv_map,
                            SS::parameters::edge_is_constrained_map(feature_map));
  }

  std::string write() const
  {
    std::ostringstream os;
    CHECK(SS::IO::write_OBJ(os, mesh, uv_map, "a comment\nof two lines",
                            CGAL::parameters::edge_is_constrained_map(feature_map)));
    return os.str();
  }

  std::size_t number_of_features() const
  {
    std::size_t n = 0;
    for(const auto e : edges(mesh))
      n += get(feature_map, e) ? 1 : 0;
    return n;
  }
};

using Surface_model = Model<CGAL::Surface_mesh<Kernel::Point_3>, Kernel::Point_2>;
using Polyhedron_model = Model<CGAL::Polyhedron_3<Kernel>, Kernel::Point_2>;
using Float_model = Model<CGAL::Surface_mesh<Float_kernel::Point_3>, Float_kernel::Point_2>;

// Of a float, the bits of the double of the same value.
inline std::uint64_t bits(double x)
{
  std::uint64_t result;
  std::memcpy(&result, &x, sizeof(double));
  return result;
}

// All that a file says about a mesh: bits of points, triangles, bits of corners, features.
struct Content
{
  std::vector<std::uint64_t> points, uvs;
  std::vector<std::size_t> triangles;
  std::vector<std::array<std::size_t, 2> > features;

  bool operator==(const Content& other) const
  {
    return points == other.points && uvs == other.uvs && triangles == other.triangles
           && features == other.features;
  }
};

template <typename AnyModel>
Content content(const AnyModel& model)
{
  const auto& mesh = model.mesh;
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  Content result;
  std::size_t n = 0;
  for(const auto v : vertices(mesh)) {
    put(index, v, n++);
    const auto p = get(CGAL::vertex_point, mesh, v);
    result.points.insert(result.points.end(), {bits(p.x()), bits(p.y()), bits(p.z())});
  }
  for(const auto f : faces(mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      const auto uv = get(model.uv_map, h);
      result.uvs.insert(result.uvs.end(), {bits(uv.x()), bits(uv.y())});
      result.triangles.push_back(get(index, target(h, mesh)));
    }
  for(const auto e : edges(mesh))
    if(get(model.feature_map, e)) {
      const std::size_t u = get(index, source(e, mesh)), v = get(index, target(e, mesh));
      result.features.push_back({(std::min)(u, v), (std::max)(u, v)});
    }
  std::sort(result.features.begin(), result.features.end());
  return result;
}

// CGAL's check takes a vertex without faces for an error. Removes them.
template <typename Mesh>
bool is_valid_but_for_isolated_vertices(Mesh& mesh)
{
  using Graph_traits = boost::graph_traits<Mesh>;
  std::vector<typename Graph_traits::vertex_descriptor> isolated;
  for(const auto v : vertices(mesh))
    if(halfedge(v, mesh) == Graph_traits::null_halfedge())
      isolated.push_back(v);
  for(const auto v : isolated)
    remove_vertex(v, mesh);
  return CGAL::is_valid_polygon_mesh(mesh);
}

// A band of n squares around a cylinder, or around a Moebius strip if `twisted`.
inline std::string band(std::size_t n, bool twisted)
{
  std::ostringstream os;
  for(std::size_t i = 0; i < 2 * n; ++i)
    os << "v " << i / 2 << ' ' << i % 2 << " 0\n";
  os << "vt 0 0\n";
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, c = 2 * ((i + 1) % n);
    const std::size_t flip = (twisted && i + 1 == n) ? 1 : 0;
    os << "f " << a + 1 << "/1 " << c + flip + 1 << "/1 " << a + 2 << "/1\n"
       << "f " << c + flip + 1 << "/1 " << c + 2 - flip << "/1 " << a + 2 << "/1\n";
  }
  return os.str();
}

#endif // SEAMLESS_SNAPPING_TEST_OBJ_MODELS_H
