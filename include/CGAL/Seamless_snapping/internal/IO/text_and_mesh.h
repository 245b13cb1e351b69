// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// From the text of a file to a mesh, and from a mesh to a text, in any format.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/Soup_edges.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/internal/IO/mesh_texts.h>
#include <CGAL/Seamless_snapping/internal/IO/weld_soup.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The parameters of the functions that read and write meshes.
constexpr auto file_parameters =
  named<CGAL::internal_np::edge_is_constrained, CGAL::internal_np::vertex_point,
        CGAL::internal_np::weld_borders>;

// The type that a file's numbers are rounded to, once, on their way to a point map.
template <typename PointMap>
using File_number =
  std::conditional_t<std::is_same_v<typename CGAL::Kernel_traits<
                                      typename boost::property_traits<PointMap>::value_type
                                    >::Kernel::FT, float>, float, double>;

// The segments of polylines as the sides of triangles that they are. Throws if one is none.
template <typename Triangle, typename Segment>
std::vector<Side_index> sides_of_segments(const Soup_edges<Triangle>& edges,
                                          const std::vector<Segment>& segments)
{
  std::vector<Side_index> sides;
  sides.reserve(segments.size());
  for(const Segment& segment : segments) {
    sides.push_back(edges.find(segment.vertices[0], segment.vertices[1]));
    if(sides.back() == Soup_edges<Triangle>::no_side)
      throw File_refusal(segment.line, "line element " + std::to_string(segment.vertices[0] + 1)
                                      + " " + std::to_string(segment.vertices[1] + 1)
                                      + " is not an edge of the mesh");
  }
  return sides;
}

// Returns the new vertex of each point; the null vertex for points that welding has left without
// faces.
template <typename Points, typename TriangleMesh, typename VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
add_vertices(const Points& points, const Vertex_changes& changes, TriangleMesh& tmesh,
             VertexPointMap vpm)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;

  using Graph_traits = boost::graph_traits<TriangleMesh>;

  std::vector<typename Graph_traits::vertex_descriptor> vertices(points.size(),
                                                                 Graph_traits::null_vertex());
  const auto add = [&](const std::size_t i) {
    vertices[i] = add_vertex(tmesh);
    put(vpm, vertices[i], Point(FT(points[i][0]), FT(points[i][1]), FT(points[i][2])));
  };
  const std::size_t n = points.size() - changes.number_of_split_vertices; // in the file
  std::for_each(changes.file_vertices.begin(),
                changes.file_vertices.end()
                  - static_cast<std::ptrdiff_t>(changes.number_of_split_vertices), add);
  for(std::size_t i = n; i < points.size(); ++i)
    add(i);
  return vertices;
}

// Returns the halfedge of each side.
template <typename Soup, typename Vertices, typename TriangleMesh, typename HalfedgeUVMap>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
add_triangles(const Soup& soup, const Vertices& vertices, TriangleMesh& tmesh,
              HalfedgeUVMap uv_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;

  std::vector<typename Graph_traits::halfedge_descriptor> halfedges;
  halfedges.reserve(3 * soup.triangles.size());
  for(const auto& triangle : soup.triangles) {
    const std::array<typename Graph_traits::vertex_descriptor, 3> corners
      = { vertices[triangle.vertices[0]], vertices[triangle.vertices[1]],
          vertices[triangle.vertices[2]] };
    const auto f = CGAL::Euler::add_face(corners, tmesh);
    CGAL_assertion(f != Graph_traits::null_face());

    auto h = halfedge(f, tmesh);
    while(target(h, tmesh) != corners[0])
      h = next(h, tmesh);
    set_halfedge(f, h, tmesh);
    for(std::size_t i = 0; i < 3; ++i) {
      const auto& uv = soup.uvs[triangle.uvs[i]];
      put(uv_map, h, Point_2(uv[0], uv[1]));
      h = next(h, tmesh);
      halfedges.push_back(h); // from corner i to the next
    }
  }
  return halfedges;
}

// Adds the soup to the mesh; the soup is changed. Throws `File_refusal` before it touches the mesh.
template <typename Soup, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Vertex_changes build_mesh(Soup& soup, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                          const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  auto vpm = chosen(np, CGAL::internal_np::vertex_point,
                    CGAL::get_property_map(CGAL::vertex_point, tmesh));
  constexpr bool wants_features =
    is_given<NamedParameters, CGAL::internal_np::edge_is_constrained_t>;

  Vertex_changes changes;
  const bool weld = chosen(np, CGAL::internal_np::weld_borders, false);
  const auto edges = connect_soup(weld, soup, changes);
  std::vector<Side_index> features;
  if(wants_features)
    features = sides_of_segments(edges, soup.segments);

  const std::size_t n = soup.triangles.size();
  using size_type = typename boost::graph_traits<TriangleMesh>::vertices_size_type;
  reserve(tmesh, size_type(num_vertices(tmesh) + soup.points.size()),
          size_type(num_edges(tmesh) + n + n / 2 + n / 8), size_type(num_faces(tmesh) + n));
  const auto vertices = add_vertices(soup.points, changes, tmesh, vpm);
  const auto halfedges = add_triangles(soup, vertices, tmesh, uv_map);
  if constexpr(wants_features) {
    auto eicm = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(const auto h : halfedges)
      put(eicm, edge(h, tmesh), false);
    for(const Side_index s : features)
      put(eicm, edge(halfedges[s], tmesh), true);
  }
  return changes;
}

// Throws `File_refusal`.
template <template <typename, typename> class Parser, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters>
Vertex_changes read_text(const std::string_view text, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                         const NamedParameters& np)
{
  using VPM = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::type;
  auto soup = Parser<File_number<VPM>, File_number<HalfedgeUVMap> >(text).parse();
  return build_mesh(soup, tmesh, uv_map, np);
}

// From a stream, or the file of a name.
template <template <typename, typename> class Parser, typename Source, typename TriangleMesh,
          typename HalfedgeUVMap, typename NamedParameters>
IO::File_status read_mesh(Source& source, TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                          const NamedParameters& np)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return status_of_reading([&] { return read_text<Parser>(text_of(source), tmesh, uv_map,
                                                            strip(np, file_parameters)); });
}

// Throws `File_refusal` if a coordinate is not finite, or the mesh is too large for the format.
template <typename Text, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
std::string text_of_surface(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                            const std::string& comments, const NamedParameters& np)
{
  CGAL_precondition(CGAL::is_triangle_mesh(tmesh));
  const auto points =
    chosen(np, CGAL::internal_np::vertex_point,
           CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);
  Text text(vertices(tmesh).size());
  std::size_t number_of_vertices = 0;
  for(const auto v : vertices(tmesh)) {
    put(index, v, number_of_vertices++);
    text.add_point(place_of(get(points, v)));
  }
  std::vector<Corner_to_write> corners;
  for(const auto f : faces(tmesh)) {
    corners.clear();
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      const auto& uv = get(uv_map, h);
      corners.push_back({get(index, target(h, tmesh)),
                         {CGAL::to_double(uv.x()), CGAL::to_double(uv.y())}});
    }
    text.add_face(corners);
  }
  if constexpr(is_given<NamedParameters, CGAL::internal_np::edge_is_constrained_t>) {
    const auto is_feature =
      CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(const auto e : edges(tmesh))
      if(get(is_feature, e))
        text.add_edge(get(index, source(e, tmesh)), get(index, target(e, tmesh)));
  }
  return text.text(comments);
}

// To a stream, or the file of a name; that is emptied when `text()` has returned the whole text.
template <typename Target, typename Text>
IO::File_status write_mesh(Target& target, const Text& text)
{
  return status_of_writing([&] { write_text(target, text()); });
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H
