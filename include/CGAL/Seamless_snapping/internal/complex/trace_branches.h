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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_TRACE_BRANCHES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_TRACE_BRANCHES_H

#include <CGAL/license/Seamless_snapping.h>

// The branches of [MC19] Sec. 5.3: the chains into which nodes divide a set of edges, cut or
// aligned. Adds the branches of a mesh to a complex.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Edge_index = std::int32_t; // the index of an edge in a list

// An edge and a direction: 2 i for the direction from the source of edge i to its target, 2 i + 1
// for the other.
using Directed_edge = std::int32_t;

inline Directed_edge opposite_edge(const Directed_edge d) { return d ^ 1; }

// The ends of an edge, by the numbers of their vertices.
struct Edge_ends
{
  Vertex_index source, target;
};

// An end of an edge at a vertex: `points_to_vertex` tells whether it is the target.
struct Incidence
{
  Edge_index edge;
  bool points_to_vertex;
};

// Which edges of a list end at each numbered vertex, in the order of the list.
using Vertex_incidences = Lists<Incidence>;

inline Vertex_incidences vertex_incidences(const std::size_t number_of_vertices,
                                           const std::vector<Edge_ends>& ends)
{
  return Vertex_incidences(number_of_vertices, [&](const auto& add) {
    for(std::size_t i = 0; i < ends.size(); ++i) {
      add(ends[i].source, Incidence{Edge_index(i), false});
      add(ends[i].target, Incidence{Edge_index(i), true});
    }
  });
}

// The directed edges of each branch, in the order in which they follow each other from node to
// node.
using Branch_list = Lists<Directed_edge>;

// Walks along the branches of one set of edges.
class Branch_tracer
{
public:
  Branch_tracer(const Vertex_incidences& incidences, const std::vector<Edge_ends>& ends)
    : m_incidences(incidences), m_ends(ends), m_is_done(ends.size(), false)
  { }

  // First the branches that begin at a node, then closed ones, which receive a node where they
  // begin.
  // \param is_node per vertex
  Branch_list trace(std::vector<char>& is_node)
  {
    Branch_list branches;
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      for(int side = 0; side < 2 && !m_is_done[i]; ++side) {
        const Directed_edge d = static_cast<Directed_edge>(2 * i) + side;
        if(is_node[std::size_t(source(d))])
          walk(d, is_node, branches);
      }
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      if(!m_is_done[i]) {
        const Directed_edge d = static_cast<Directed_edge>(2 * i);
        is_node[std::size_t(source(d))] = true;
        walk(d, is_node, branches);
      }
    return branches;
  }

private:
  Vertex_index source(const Directed_edge d) const
  {
    const Edge_ends& ends = m_ends[std::size_t(d / 2)];
    return d % 2 == 0 ? ends.source : ends.target;
  }

  Vertex_index target(const Directed_edge d) const { return source(opposite_edge(d)); }

  // At a vertex that is no node, two edges meet; this is the other one, away from the vertex.
  Directed_edge continuation(const Directed_edge d) const
  {
    const auto ends = m_incidences[target(d)];
    const bool first_is_here = ends[0].edge == d / 2 && ends[0].points_to_vertex == (d % 2 == 0);
    const Incidence& other = ends[first_is_here ? 1 : 0];
    return 2 * other.edge + (other.points_to_vertex ? 1 : 0);
  }

  void walk(Directed_edge d, const std::vector<char>& is_node, Branch_list& branches)
  {
    for(;;) {
      m_is_done[std::size_t(d / 2)] = true;
      branches.push_back(d);
      if(is_node[std::size_t(target(d))])
        break;
      d = continuation(d);
    }
    branches.end_list();
  }

  const Vertex_incidences& m_incidences;
  const std::vector<Edge_ends>& m_ends;
  std::vector<bool> m_is_done;
};

// Adds the branches of cut edges to a complex.
// \param element(d) of the transition across a directed edge, from its left
// \param sector(d, at_target) at its left
template <typename Group, typename ElementOf, typename SectorAt>
Branch_list add_branches(const Vertex_incidences& cuts, const std::vector<Edge_ends>& ends,
                         const ElementOf& element, const SectorAt& sector,
                         Cut_complex<Group>& complex)
{
  const Branch_list branches = Branch_tracer(cuts, ends).trace(complex.is_node);
  complex.pairs.reserve(branches.size(), ends.size() + branches.size());
  for(std::size_t b = 0; b < branches.size(); ++b) {
    const Directed_edge first = branches[b].front();
    complex.element.push_back(element(first));
    complex.pairs.push_back({sector(first, false), sector(opposite_edge(first), true)});
    for(const Directed_edge d : branches[b])
      complex.pairs.push_back({sector(d, true), sector(opposite_edge(d), false)});
    complex.pairs.end_list();
  }
  return branches;
}

// Adds the chains of aligned edges.
// \param functional(edge) that is constant along an edge
// \param sector(d, at_target) of a directed edge, at that side of the edge
template <typename Group, typename FunctionalOf, typename SectorAt>
Branch_list add_chains(const Vertex_incidences& aligned, const std::vector<Edge_ends>& ends,
                       const FunctionalOf& functional, const SectorAt& sector,
                       Cut_complex<Group>& complex)
{
  const Branch_list chains = Branch_tracer(aligned, ends).trace(complex.is_node);
  for(std::size_t c = 0; c < chains.size(); ++c) {
    const Directed_edge first = chains[c].front();
    complex.functional.push_back(functional(first / 2));
    complex.links.push_back(sector(first, false));
    for(const Directed_edge d : chains[c])
      complex.links.push_back(sector(d, true));
    complex.links.end_list();
  }
  return chains;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_TRACE_BRANCHES_H
