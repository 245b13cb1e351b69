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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_MOVES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_MOVES_H

#include <CGAL/license/Seamless_snapping.h>

// How a vertex can move while all else stays ([MC19] Sec. 5.4). The sectors around it that cuts
// link move together, each turned by the cuts' rotations, so that translations of branches are
// kept; alignments fix a functional; cones and ends of further constraints can't move.

#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Points that move together: by g d, for a displacement d along one direction, or any.
template <typename Group>
struct Vertex_move
{
  struct Member { Point_index point; typename Group::Element element; };
  enum Freedom { ANY_DIRECTION, ONE_DIRECTION, NONE };

  std::vector<Member> members;
  Freedom freedom = ANY_DIRECTION;
  std::array<int, 2> direction{{0, 0}}; // if there is one
  bool is_on_grid = false; // whether coordinates must remain elements of the grid

  bool is_possible() const { return freedom != NONE; }

  // The displacement along the one direction is a multiple of it.
  void restrict_to(const std::array<int, 2>& only)
  {
    const bool is_parallel = only[0] * direction[1] == only[1] * direction[0];
    freedom = freedom == ANY_DIRECTION || (freedom == ONE_DIRECTION && is_parallel) ? ONE_DIRECTION
                                                                                    : NONE;
    direction = only;
  }

  const Member* find(const Point_index p) const
  {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const Member& m) { return m.point == p; });
    return found == members.end() ? nullptr : &*found;
  }
};

// How a point can move.
template <typename Group>
Vertex_move<Group> find_vertex_move(const Movable_points<Group>& points, const Point_index p)
{
  Vertex_move<Group> move;
  move.members.push_back({p, Group::identity()});
  if(!points.is_sector(p))
    return move;
  const Sector_links<Group>& links = points.links();
  for(std::size_t i = 0; i < move.members.size(); ++i) {
    const auto here = move.members[i];
    for(auto link = links.begin(here.point); link != links.end(here.point); ++link) {
      move.is_on_grid = true;
      const auto element = Group::compose(link->element, here.element);
      if(const auto* member = move.find(link->sector)) {
        if(member->element != element) // a cone: only d = 0 returns to itself
          move.freedom = Vertex_move<Group>::NONE;
      } else {
        move.members.push_back({link->sector, element});
      }
    }
  }
  for(const auto& member : move.members) {
    if(links.is_pinned(member.point))
      move.freedom = Vertex_move<Group>::NONE;
    for(auto f = links.functionals_begin(member.point); f != links.functionals_end(member.point);
        ++f) {
      const auto fixed = Group::functional(Group::act(Group::inverse(member.element), *f).index);
      move.restrict_to({{-fixed[1], fixed[0]}});
    }
  }
  return move;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_MOVES_H
