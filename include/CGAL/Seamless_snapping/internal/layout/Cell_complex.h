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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_CELL_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_CELL_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// Polygons glued along edges, as plain arrays; and their way into a face graph.

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Darts 2 e and 2 e + 1 are the two sides of edge e.
struct Cell_complex
{
  std::size_t number_of_vertices = 0, number_of_cells = 0;
  std::vector<std::int32_t> targets; // per dart
  std::vector<std::int32_t> nexts;   // around the same cell, or along the border
  std::vector<std::int32_t> cells;   // -1 outside

  std::size_t number_of_darts() const { return targets.size(); }
};

// Whether no edge is a loop or has the same cell on both sides, and no two have the same ends, as
// polygon meshes must have it.
inline bool is_simple(const Cell_complex& complex)
{
  std::vector<std::pair<std::int32_t, std::int32_t> > ends;
  for(std::size_t d = 0; d < complex.number_of_darts(); d += 2) {
    ends.push_back(std::minmax(complex.targets[d], complex.targets[d + 1]));
    if(ends.back().first == ends.back().second || complex.cells[d] == complex.cells[d + 1])
      return false;
  }
  std::sort(ends.begin(), ends.end());
  return std::adjacent_find(ends.begin(), ends.end()) == ends.end();
}

// Adds the cells to a graph. Calls at_vertex(descriptor, vertex), at_edge(descriptor, edge), and
// at_face(descriptor, cell) for what is new.
template <typename Graph, typename AtVertex, typename AtEdge, typename AtFace>
void write_cells(const Cell_complex& complex, Graph& graph, const AtVertex& at_vertex,
                 const AtEdge& at_edge, const AtFace& at_face)
{
  using Graph_traits = boost::graph_traits<Graph>;
  using size_type = typename Graph_traits::vertices_size_type;
  const std::size_t n = complex.number_of_darts();
  reserve(graph, size_type(num_vertices(graph) + complex.number_of_vertices),
          size_type(num_edges(graph) + n / 2),
          size_type(num_faces(graph) + complex.number_of_cells));
  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  for(std::size_t v = 0; v < complex.number_of_vertices; ++v) {
    vertices.push_back(add_vertex(graph));
    at_vertex(vertices.back(), v);
  }
  std::vector<typename Graph_traits::halfedge_descriptor> halfedges;
  for(std::size_t e = 0; e < n / 2; ++e) {
    const auto edge = add_edge(graph);
    halfedges.push_back(halfedge(edge, graph));
    halfedges.push_back(opposite(halfedges.back(), graph));
    at_edge(edge, e);
  }
  std::vector<typename Graph_traits::face_descriptor> faces;
  for(std::size_t c = 0; c < complex.number_of_cells; ++c) {
    faces.push_back(add_face(graph));
    at_face(faces.back(), c);
  }
  for(const bool is_outside : {false, true}) // the halfedge of a border vertex is one of the border
    for(std::size_t d = 0; d < n; ++d) {
      if((complex.cells[d] < 0) != is_outside)
        continue;
      const auto h = halfedges[d];
      const auto v = vertices[std::size_t(complex.targets[d])];
      const auto f = is_outside ? Graph_traits::null_face() : faces[std::size_t(complex.cells[d])];
      set_next(h, halfedges[std::size_t(complex.nexts[d])], graph);
      set_target(h, v, graph);
      set_halfedge(v, h, graph);
      set_face(h, f, graph);
      if(!is_outside)
        set_halfedge(f, h, graph);
    }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_CELL_COMPLEX_H
