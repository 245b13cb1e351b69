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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_BRANCHES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_BRANCHES_H

#include <CGAL/license/Seamless_snapping.h>

// The branches of Sec. 5.3: the chains into which nodes divide the cut edges and the aligned edges.

#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Directed edges, 2 i + (0 for the halfedge that represents edge i, 1 for its opposite), each branch in
// the order in which they follow each other from node to node.
class Branch_list
{
public:
  Branch_list() : m_begin(1, 0) { }

  void add_edge(const std::int32_t directed_edge) { m_edges.push_back(directed_edge); }
  void finish_branch(const Edge_ends& nodes)
  {
    m_begin.push_back(m_edges.size());
    m_nodes.push_back(nodes);
  }

  std::size_t size() const { return m_begin.size() - 1; }
  const std::int32_t* begin(const std::size_t b) const { return m_edges.data() + m_begin[b]; }
  const std::int32_t* end(const std::size_t b) const { return m_edges.data() + m_begin[b + 1]; }

  const Edge_ends& nodes(const std::size_t b) const { return m_nodes[b]; } // at its ends

private:
  std::vector<std::int32_t> m_edges;
  std::vector<std::size_t> m_begin;
  std::vector<Edge_ends> m_nodes;
};

// Walks along the chains of one set of edges.
class Branch_tracer
{
public:
  Branch_tracer(const Vertex_incidences& incidences, const std::vector<Edge_ends>& ends)
    : m_incidences(incidences), m_ends(ends), m_is_done(ends.size(), false)
  { }

  // First the branches that begin at a node, then closed ones, which receive a node where they begin.
  Branch_list trace(std::vector<bool>& is_node)
  {
    Branch_list branches;
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      for(int side = 0; side < 2 && !m_is_done[i]; ++side) {
        const std::int32_t d = static_cast<std::int32_t>(2 * i) + side;
        if(is_node[std::size_t(source(d))])
          walk(d, is_node, branches);
      }
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      if(!m_is_done[i]) {
        const std::int32_t d = static_cast<std::int32_t>(2 * i);
        is_node[std::size_t(source(d))] = true;
        walk(d, is_node, branches);
      }
    return branches;
  }

private:
  Vertex_index source(const std::int32_t d) const
  {
    const Edge_ends& ends = m_ends[std::size_t(d / 2)];
    return d % 2 == 0 ? ends.source : ends.target;
  }

  Vertex_index target(const std::int32_t d) const { return source(d ^ 1); }

  // At a vertex that is no node, two edges meet; this is the other one, away from the vertex.
  std::int32_t continuation(const std::int32_t d) const
  {
    const Incidence* ends = m_incidences.begin(target(d));
    const bool first_is_here = ends[0].edge == d / 2 && ends[0].points_to_vertex == (d % 2 == 0);
    const Incidence& other = ends[first_is_here ? 1 : 0];
    return 2 * other.edge + (other.points_to_vertex ? 1 : 0);
  }

  void walk(std::int32_t d, const std::vector<bool>& is_node, Branch_list& branches)
  {
    const Vertex_index start = source(d);
    for(;;) {
      m_is_done[std::size_t(d / 2)] = true;
      branches.add_edge(d);
      if(is_node[std::size_t(target(d))])
        break;
      d = continuation(d);
    }
    branches.finish_branch({start, target(d)});
  }

  const Vertex_incidences& m_incidences;
  const std::vector<Edge_ends>& m_ends;
  std::vector<bool> m_is_done;
};

// Invariant: complete after construction. The nodes are those of the sector map, and one vertex of each
// closed branch without any.
struct Branches
{
  template <typename TriangleMesh, typename HalfedgeUVMap>
  explicit Branches(const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors)
    : is_node(sectors.number_of_vertices())
  {
    for(std::size_t v = 0; v < is_node.size(); ++v)
      is_node[v] = sectors.is_node(Vertex_index(v));
    cut = Branch_tracer(sectors.cuts(), sectors.cut_ends()).trace(is_node);
    aligned = Branch_tracer(sectors.aligned(), sectors.align_ends()).trace(is_node);
  }

  std::vector<bool> is_node; // per vertex of the sector map
  Branch_list cut, aligned;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_BRANCHES_H
