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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H

#include <CGAL/license/Seamless_snapping.h>

// The points of the domain whose coordinates repairs of orientations may change, and the spacing of
// their coordinates.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The few faces whose orientation the moves of sectors can change. A face whose corners all move by
// no more than its height allows needs no second look; what is left is checked exactly, as often as
// it takes. Invariant: contains each face once.
class Watched_faces
{
public:
  void add(const Face_index f)
  {
    if(m_is_known.size() <= std::size_t(f))
      m_is_known.resize(std::size_t(f) + 1, false);
    if(!m_is_known[std::size_t(f)])
      m_faces.push_back(f);
    m_is_known[std::size_t(f)] = true;
  }

  void add(const std::vector<Face_index>& faces)
  {
    for(const Face_index f : faces)
      add(f);
  }

  const std::vector<Face_index>& faces() const { return m_faces; }

  // The faces that are not positive, among the positive faces of the input, or all others.
  template <typename Points>
  std::vector<Face_index> not_positive(const Points& points, const Uv_state& state,
                                       const bool were_positive) const
  {
    std::vector<Face_index> result;
    for(const Face_index f : m_faces)
      if(points.domain_face(f).was_positive == were_positive && !points.is_positive(state, f))
        result.push_back(f);
    return result;
  }

private:
  std::vector<Face_index> m_faces;
  std::vector<bool> m_is_known; // per face that was met
};

// Invariant: what is computed when it is first asked for is kept; most runs repair nothing.
template <typename Group_>
class Movable_points
{
public:
  using Group = Group_;

  Movable_points(const Cut_complex<Group>& complex, const Complex_solver<Group>& solver,
                 Point_stars& stars)
    : m_complex(complex), m_solver(solver), m_stars(stars)
  { }

  const Cut_complex<Group>& complex() const { return m_complex; }
  Point_stars& stars() const { return m_stars; }
  bool is_sector(const Point_index p) const { return std::size_t(p) < m_stars.number_of_sectors(); }

  // The links between sectors.
  const Sector_links<Group>& links() const
  {
    if(!m_links)
      m_links.emplace(m_complex);
    return *m_links;
  }

  const Domain_face& domain_face(const Face_index f) const { return m_stars.domain_face(f); }

  const Uv& uv(const Uv_state& state, const Point_index p) const
  {
    return std::size_t(p) < state.size() ? state[std::size_t(p)] : m_stars.free_input(p);
  }

  Uv_triangle triangle(const Uv_state& state, const Domain_face& f) const
  {
    return {{uv(state, f.points[0]), uv(state, f.points[1]), uv(state, f.points[2])}};
  }

  bool is_positive(const Uv_state& state, const Face_index f) const
  {
    return orientation(triangle(state, domain_face(f))) == CGAL::POSITIVE;
  }

  void set_uv(Uv_state& state, const Point_index p, const Uv& u) const
  {
    while(state.size() <= std::size_t(p))
      state.push_back(m_stars.free_input(Point_index(state.size())));
    state[std::size_t(p)] = u;
  }

  // Whether no constraint concerns it.
  bool is_free(const Point_index p) const { return !is_sector(p) || grid_step(p) == 0; }

  // A multiple of the distance of neighboring numbers that the point can take: those of the coarser
  // of its grids or, where no constraint concerns it, of its coordinates' type, anywhere in the
  // ring around it.
  double spacing(const Point_index p) const
  {
    if(!is_free(p))
      return grid_step(p);
    double largest = 0;
    for(const Face_corner& corner : m_stars.star(p))
      for(const Uv& u : domain_face(corner.face).input)
        largest = (std::max)({largest, std::abs(u[0]), std::abs(u[1])});
    return Grid::finest(m_solver.format(), largest).step();
  }

private:
  // 0 for sectors of merged corners only.
  double grid_step(const Sector_index s) const
  {
    if(m_grid_steps.empty()) {
      m_grid_steps.assign(m_stars.number_of_sectors(), 0);
      m_solver.components().for_each_sector([&](const Sector_index t, const auto& components) {
        double& step = m_grid_steps[std::size_t(t)];
        for(const Component_index k : components)
          if(k >= 0)
            step = (std::max)(step, m_solver.grids()[std::size_t(k)].step());
      });
    }
    return m_grid_steps[std::size_t(s)];
  }

  const Cut_complex<Group>& m_complex;
  const Complex_solver<Group>& m_solver;
  Point_stars& m_stars;
  mutable std::optional<Sector_links<Group> > m_links;
  mutable std::vector<double> m_grid_steps; // per sector
};

// How a vertex can move while all else stays ([MC19] Sec. 5.4). The sectors around it that cuts
// link move together, each turned by the cuts' rotations, so that translations of branches are
// kept; alignments fix a functional; cones and ends of further constraints can't move.

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
    for(const auto& link : links.links(here.point)) {
      move.is_on_grid = true;
      const auto element = Group::compose(link.element, here.element);
      if(const auto* member = move.find(link.sector)) {
        if(member->element != element) // a cone: only d = 0 returns to itself
          move.freedom = Vertex_move<Group>::NONE;
      } else {
        move.members.push_back({link.sector, element});
      }
    }
  }
  for(const auto& member : move.members) {
    if(links.is_pinned(member.point))
      move.freedom = Vertex_move<Group>::NONE;
    for(const int f : links.functionals(member.point)) {
      const auto fixed = Group::functional(Group::act(Group::inverse(member.element), f).index);
      move.restrict_to({{-fixed[1], fixed[0]}});
    }
  }
  return move;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
