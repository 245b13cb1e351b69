// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_MESH_BUILDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_MESH_BUILDER_H

#include <CGAL/license/Seamless_snapping.h>

// From the text of an OBJ file to a mesh with its property maps: the steps of `read_OBJ()`.

#include <CGAL/Seamless_snapping/internal/IO/OBJ_statements.h>
#include <CGAL/Seamless_snapping/internal/IO/Soup_edges.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <ios>
#include <istream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Reads a stream to its end. Throws if that fails. Reads from its buffer, since members of the
// stream would take the end for a failure, for which it may have been asked to throw.
inline std::string text_of_stream(std::istream& is)
{
  if(!is)
    throw OBJ_refusal(0, "cannot read the stream");
  std::string text;
  std::vector<char> buffer(std::size_t(1) << 20);
  const std::streamsize size = static_cast<std::streamsize>(buffer.size());
  try {
    for(std::streamsize count = size; count == size;) {
      count = is.rdbuf()->sgetn(buffer.data(), size);
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
  } catch(const std::ios_base::failure&) { // how some libraries tell that a file cannot be read
    is.setstate(std::ios::badbit);
    throw OBJ_refusal(0, "cannot read the stream");
  }
  if((is.exceptions() & std::ios::eofbit) == 0)
    is.setstate(std::ios::eofbit);
  return text;
}

// The type that a file's numbers are rounded to, once, on their way to a point map.
template <typename PointMap>
using OBJ_number =
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
      throw OBJ_refusal(segment.line, "line element " + std::to_string(segment.vertices[0] + 1)
                                      + " " + std::to_string(segment.vertices[1] + 1)
                                      + " is not an edge of the mesh");
  }
  return sides;
}

template <typename Points, typename TriangleMesh, typename VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
add_vertices(const Points& points, TriangleMesh& tmesh, VertexPointMap vpm)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;

  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  vertices.reserve(points.size());
  for(const auto& p : points) {
    vertices.push_back(add_vertex(tmesh));
    put(vpm, vertices.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  return vertices;
}

// Returns the halfedge of each side.
template <typename Statements, typename Vertices, typename TriangleMesh, typename HalfedgeUVMap>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
add_triangles(const Statements& statements, const Vertices& vertices, TriangleMesh& tmesh,
              HalfedgeUVMap uv_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;

  std::vector<typename Graph_traits::halfedge_descriptor> halfedges;
  halfedges.reserve(3 * statements.triangles.size());
  for(const auto& triangle : statements.triangles) {
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
      const auto& uv = statements.uvs[triangle.uvs[i]];
      put(uv_map, h, Point_2(uv[0], uv[1]));
      h = next(h, tmesh);
      halfedges.push_back(h); // from corner i to the next
    }
  }
  return halfedges;
}

// Returns the number of split vertices. Throws `OBJ_refusal` before it touches the mesh.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
std::size_t build_mesh_from_OBJ(const std::string& text, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                const NamedParameters& np)
{
  using VPM = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::type;
  VPM vpm = CGAL::parameters::choose_parameter(
              CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
              CGAL::get_property_map(CGAL::vertex_point, tmesh));
  constexpr bool wants_features = !CGAL::parameters::is_default_parameter<
                                     NamedParameters, CGAL::internal_np::edge_is_constrained_t
                                   >::value;

  auto statements = OBJ_statement_parser<OBJ_number<VPM>, OBJ_number<HalfedgeUVMap> >(text).parse();
  const Soup_edges edges(statements.triangles);
  edges.check_manifold();
  std::vector<Side_index> features;
  if(wants_features)
    features = sides_of_segments(edges, statements.segments);
  const std::size_t number_of_split_vertices
    = split_non_manifold_vertices(edges.mates(), statements.triangles, statements.points);

  const auto vertices = add_vertices(statements.points, tmesh, vpm);
  const auto halfedges = add_triangles(statements, vertices, tmesh, uv_map);
  if constexpr(wants_features) {
    auto eicm = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(const auto h : halfedges)
      put(eicm, edge(h, tmesh), false);
    for(const Side_index s : features)
      put(eicm, edge(halfedges[s], tmesh), true);
  }
  return number_of_split_vertices;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_MESH_BUILDER_H
