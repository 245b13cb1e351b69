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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_VERTEX_MOVES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_VERTEX_MOVES_H

#include <CGAL/license/Seamless_snapping.h>

// How a vertex can move while all else stays (Sec. 5.4). The sectors around it that cuts link move together,
// each turned by the cuts' rotations, so that translations of branches are kept; alignments fix a component;
// cones and ends of further constraints can't move.

#include <CGAL/Seamless_snapping/internal/surface/Uv_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Points that move together: by R_k d for a displacement d that has the value 0 in fixed components.
struct Vertex_move
{
  struct Member { Point_index point; int rotation; };

  std::vector<Member> members;
  std::array<bool, 2> is_fixed{{false, false}};
  bool is_on_grid = false; // whether coordinates must remain elements of the grid

  bool is_possible() const { return !is_fixed[0] || !is_fixed[1]; }

  const Member* find(const Point_index p) const
  {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const Member& m) { return m.point == p; });
    return found == members.end() ? nullptr : &*found;
  }
};

template <typename Points>
class Vertex_move_finder
{
public:
  using TriangleMesh = std::decay_t<decltype(std::declval<Points>().mesh())>;

  Vertex_move_finder(const Points& points, const Transition_data<TriangleMesh>& transitions,
                     const Align_edges<TriangleMesh>& align_edges)
    : m_points(points), m_transitions(transitions), m_align_edges(align_edges),
      m_pinned(points.sectors().node_corner_sectors())
  {
    std::sort(m_pinned.begin(), m_pinned.end());
  }

  Vertex_move operator()(const Point_index p) const
  {
    Vertex_move move;
    move.members.push_back({p, 0});
    if(!m_points.is_sector(p))
      return move;
    const Vertex_index v = m_points.vertex_of(p);
    if(!add_linked_sectors(v, move)) // a cone: only d = 0 returns to itself
      move.is_fixed = {{true, true}};
    fix_components(v, move);
    return move;
  }

private:
  // Returns false if the rotations around the vertex contradict each other.
  bool add_linked_sectors(const Vertex_index v, Vertex_move& move) const
  {
    const auto& sectors = m_points.sectors();
    for(std::size_t i = 0; i < move.members.size(); ++i)
      for(const Incidence* c = sectors.cuts().begin(v); c != sectors.cuts().end(v); ++c) {
        const Directed_cut towards = 2 * c->edge + (c->points_to_vertex ? 0 : 1);
        const int k = m_transitions.edges[std::size_t(c->edge)].rotation;
        const int turn = c->points_to_vertex ? k : inverse_rotation(k);
        const Sector_index here = sectors.target_sector(towards);
        const Sector_index there = sectors.source_sector(opposite_cut(towards));
        if(!link(here, turn, there, i, move) || !link(there, inverse_rotation(turn), here, i, move))
          return false;
      }
    return true;
  }

  // The displacement of `b` is that of `a`, turned; `a` may be the i-th member.
  static bool link(const Sector_index a, const int turn, const Sector_index b, const std::size_t i,
                   Vertex_move& move)
  {
    if(move.members[i].point != a)
      return true;
    move.is_on_grid = true;
    const int rotation = (move.members[i].rotation + turn) % number_of_rotations;
    if(const Vertex_move::Member* member = move.find(b))
      return member->rotation == rotation;
    move.members.push_back({b, rotation});
    return true;
  }

  void fix_components(const Vertex_index v, Vertex_move& move) const
  {
    const auto& sectors = m_points.sectors();
    for(const Incidence* a = sectors.aligned().begin(v); a != sectors.aligned().end(v); ++a) {
      const Sector_index s = a->points_to_vertex ? sectors.align_target_sector(a->edge)
                                                 : sectors.align_source_sector(a->edge);
      if(const Vertex_move::Member* member = move.find(s))
        move.is_fixed[std::size_t(rotated_component(inverse_rotation(member->rotation),
                                                    m_align_edges.component(a->edge)))] = true;
    }
    for(const Vertex_move::Member& member : move.members)
      if(std::binary_search(m_pinned.begin(), m_pinned.end(), member.point))
        move.is_fixed = {{true, true}};
  }

  const Points& m_points;
  const Transition_data<TriangleMesh>& m_transitions;
  const Align_edges<TriangleMesh>& m_align_edges;
  std::vector<Sector_index> m_pinned; // in further constraints
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_VERTEX_MOVES_H
