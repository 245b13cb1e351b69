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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_BUILDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_BUILDER_H

#include <CGAL/license/Seamless_snapping.h>

// From what a file holds to a mesh with its property maps: the steps that all readers share.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/Soup_edges.h>
#include <CGAL/Seamless_snapping/internal/IO/weld_soup.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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

// What was done to the vertices, and could have been done.
struct Vertex_changes
{
  std::size_t number_of_split_vertices = 0;
  std::size_t number_of_welded_edges = 0;
  std::size_t number_of_coinciding_border_edges = 0; // that are left
  std::vector<std::size_t> file_vertices; // the index in the file of each new vertex of the mesh
};

// Makes the soup a surface that a halfedge data structure can hold: welds it, if asked to, and
// splits vertices with several fans. Returns the edges of the surface. Throws `File_refusal`.
template <typename Soup>
Soup_edges<typename Soup::Triangle> connect_soup(const bool weld, Soup& soup,
                                                 Vertex_changes& changes)
{
  using Edges = Soup_edges<typename Soup::Triangle>;
  Edges edges(soup.triangles);
  edges.check_manifold();
  const Coinciding_sides coinciding = find_coinciding_sides(soup, edges.border_sides());
  changes.number_of_coinciding_border_edges = coinciding.number;
  const std::size_t number_of_seams = weld ? coinciding.seams.size() : 0;
  std::vector<std::size_t> welded(soup.points.size());
  std::iota(welded.begin(), welded.end(), std::size_t(0));
  if(number_of_seams > 0) {
    welded = welded_vertices(soup, coinciding.seams);
    replace_vertices(welded, soup);
    edges = Edges(soup.triangles);
    edges.check_manifold("once welded, ");
    changes.number_of_welded_edges = number_of_seams;
    changes.number_of_coinciding_border_edges -= 2 * number_of_seams;
  }
  for(std::size_t v = 0; v < welded.size(); ++v)
    if(welded[v] == v)
      changes.file_vertices.push_back(v);

  const std::vector<std::size_t> origins
    = split_non_manifold_vertices(edges.mates(), soup.triangles, soup.points);
  changes.number_of_split_vertices = origins.size();
  changes.file_vertices.insert(changes.file_vertices.end(), origins.begin(), origins.end());
  return edges;
}

// Returns the new vertex of each point; the null vertex for those that welding has left without
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
  const std::size_t n = points.size() - changes.number_of_split_vertices; // of the file
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_BUILDER_H
