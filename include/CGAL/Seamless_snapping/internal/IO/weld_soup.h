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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_WELD_SOUP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_WELD_SOUP_H

#include <CGAL/license/Seamless_snapping.h>

// Closes the seams of a mesh that was cut open, as the writers of many programs do: vertices are
// doubled along the cuts, since a vertex has room for one pair of coordinates there. The two sides
// of a seam are border edges between equal points. Only such edges are welded, never vertices that
// merely lie in one place. `Polygon_mesh_processing::stitch_borders()` does the like on a mesh, and
// drops the coordinates of the halfedges that it removes.

#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/Soup_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Segments_in_space.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The pairs of border sides that are two sides of a seam, and how many sides lie on others.
struct Coinciding_sides
{
  std::vector<std::array<Side_index, 2> > seams;
  std::size_t number = 0; // all edges that lie on others, also on seams
};

// Three sides or more in one place leave open which belong together, and two of the same direction
// would make a surface that is not oriented: these are no seams.
template <typename Soup>
Coinciding_sides find_coinciding_sides(const Soup& soup, const std::vector<Side_index>& border)
{
  using Point = typename decltype(soup.points)::value_type;
  Segments_in_space<typename Point::value_type> segments;
  for(const Side_index s : border) {
    const auto& v = soup.triangles[s / 3].vertices;
    segments.add(soup.points[v[s % 3]], soup.points[v[next_side(s) % 3]], s);
  }

  Coinciding_sides result;
  segments.for_each_coincidence([&result](const auto first, const auto last) {
    const auto a = Side_index(first->index), b = Side_index((last - 1)->index);
    result.number += static_cast<std::size_t>(last - first);
    if(last - first == 2 && first->runs_upwards != (last - 1)->runs_upwards && a / 3 != b / 3)
      result.seams.push_back({a, b});
  });
  return result;
}

// For each vertex the vertex that it becomes: among welded vertices, the first one in the
// file.
template <typename Soup>
std::vector<std::size_t>
welded_vertices(const Soup& soup, const std::vector<std::array<Side_index, 2> >& seams)
{
  const std::size_t n = soup.points.size();
  boost::disjoint_sets_with_storage<> sets(n);
  const auto vertex = [&soup](const Side_index s) {
    return soup.triangles[s / 3].vertices[s % 3];
  };
  for(const std::array<Side_index, 2>& seam : seams) {
    sets.union_set(vertex(seam[0]), vertex(next_side(seam[1])));
    sets.union_set(vertex(next_side(seam[0])), vertex(seam[1]));
  }

  std::vector<std::size_t> first(n, n), result(n);
  for(std::size_t v = 0; v < n; ++v) {
    std::size_t& first_of_set = first[sets.find_set(v)];
    first_of_set = (std::min)(first_of_set, v);
    result[v] = first_of_set;
  }
  return result;
}

// Puts the welded vertices in place of the others, which stay in `points` without a face.
template <typename Soup>
void replace_vertices(const std::vector<std::size_t>& welded, Soup& soup)
{
  for(auto& triangle : soup.triangles) {
    auto& v = triangle.vertices;
    for(Soup_index& vertex : v)
      vertex = Soup_index(welded[vertex]);
    if(v[0] == v[1] || v[0] == v[2] || v[1] == v[2]) {
      const Message face = triangle.line == 0
                             ? name_of_face(std::size_t(&triangle - &soup.triangles[0]))
                             : "the face";
      throw File_refusal(triangle.line, face + " has no area, and welding makes two of its corners "
                                               "one vertex; remove it first");
    }
  }
  for(auto& segment : soup.segments)
    for(std::size_t& vertex : segment.vertices)
      vertex = welded[vertex];
}

// Makes the soup a surface that a halfedge data structure can hold: welds it, if asked to, and
// splits vertices with several fans. Returns the edges of the surface. Throws `File_refusal`.
template <typename Soup>
Soup_edges<typename Soup::Triangle> connect_soup(const bool weld, Soup& soup,
                                                 Vertex_changes& changes)
{
  using Edges = Soup_edges<typename Soup::Triangle>;
  Edges edges(soup.triangles, soup.vertex_names);
  edges.check_manifold();
  const Coinciding_sides coinciding = find_coinciding_sides(soup, edges.border_sides());
  changes.number_of_coinciding_border_edges = coinciding.number;
  const std::size_t number_of_seams = weld ? coinciding.seams.size() : 0;
  std::vector<std::size_t> welded(soup.points.size());
  std::iota(welded.begin(), welded.end(), std::size_t(0));
  if(number_of_seams > 0) {
    welded = welded_vertices(soup, coinciding.seams);
    replace_vertices(welded, soup);
    edges = Edges(soup.triangles, soup.vertex_names);
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_WELD_SOUP_H
