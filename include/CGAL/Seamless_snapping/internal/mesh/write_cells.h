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
#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_WRITE_CELLS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_WRITE_CELLS_H

#include <CGAL/license/Seamless_snapping.h>

// From polygons glued along edges to a face graph.

#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Point>
Point point_at(const Place& place)
{
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  return Point(FT(place[0]), FT(place[1]), FT(place[2]));
}

// Adds vertices, edges, and cells to a graph, in this order. `Cells` knows number_of_vertices(),
// number_of_cells(), and number_of_darts(); and of a dart, that is a side of an edge:
// - is_edge(d), whether it is one of the result at all;
// - twin(d), the other side;
// - next(d), around the same cell, or along the border;
// - target(d), a vertex;
// - cell(d), negative outside.
template <typename Graph, typename Cells>
class Cell_writer
{
  using Graph_traits = boost::graph_traits<Graph>;
  using size_type = typename Graph_traits::vertices_size_type;

public:
  Cell_writer(const Cells& cells, Graph& graph) : m_cells(cells), m_graph(graph)
  {
    reserve(graph, size_type(num_vertices(graph) + cells.number_of_vertices()),
            size_type(num_edges(graph) + cells.number_of_darts() / 2),
            size_type(num_faces(graph) + cells.number_of_cells()));
    m_vertices.reserve(cells.number_of_vertices());
  }

  // The next vertex; one call for each.
  typename Graph_traits::vertex_descriptor new_vertex()
  {
    m_vertices.push_back(add_vertex(m_graph));
    return m_vertices.back();
  }

  // Calls at_edge(descriptor, dart), with one dart of each edge, and at_face(descriptor, cell).
  template <typename AtEdge, typename AtFace>
  void add_edges_and_faces(const AtEdge& at_edge, const AtFace& at_face)
  {
    m_halfedges.resize(m_cells.number_of_darts());
    for(std::size_t d = 0; d < m_halfedges.size(); ++d)
      if(represents_edge(d)) {
        const auto edge = add_edge(m_graph);
        m_halfedges[d] = halfedge(edge, m_graph);
        m_halfedges[m_cells.twin(d)] = opposite(m_halfedges[d], m_graph);
        at_edge(edge, d);
      }
    m_faces.reserve(m_cells.number_of_cells());
    for(std::size_t c = 0; c < m_cells.number_of_cells(); ++c) {
      m_faces.push_back(add_face(m_graph));
      at_face(m_faces.back(), c);
    }
    std::vector<std::size_t> border;
    for(std::size_t d = 0; d < m_halfedges.size(); ++d)
      if(m_cells.cell(d) >= 0)
        link(d);
      else if(m_cells.is_edge(d))
        border.push_back(d);
    for(const std::size_t d : border)
      link(d); // last, since the halfedge of a border vertex is one of the border
  }

private:
  bool represents_edge(const std::size_t d) const
  { return m_cells.is_edge(d) && d < m_cells.twin(d); }

  void link(const std::size_t d)
  {
    // all is looked up before the first change, since compilers then look up common parts once
    const auto h = m_halfedges[d], next = m_halfedges[m_cells.next(d)];
    const auto v = m_vertices[m_cells.target(d)];
    const auto cell = m_cells.cell(d);
    set_next(h, next, m_graph);
    set_target(h, v, m_graph);
    set_halfedge(v, h, m_graph);
    set_face(h, cell < 0 ? Graph_traits::null_face() : m_faces[std::size_t(cell)], m_graph);
    if(cell >= 0)
      set_halfedge(m_faces[std::size_t(cell)], h, m_graph);
  }

  const Cells& m_cells;
  Graph& m_graph;
  std::vector<typename Graph_traits::vertex_descriptor> m_vertices;
  std::vector<typename Graph_traits::halfedge_descriptor> m_halfedges; // per dart
  std::vector<typename Graph_traits::face_descriptor> m_faces;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_WRITE_CELLS_H
