// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_INTEGER_DECISIONS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_INTEGER_DECISIONS_H

#include <CGAL/license/Quad_remeshing.h>

// The decisions of a walk of one unit along a line of the grid, which are exact: levels and the end
// of the walk are integers, which stay exact in a `double` through all transitions. The walk ends
// in the face, edge, or vertex that contains its end.

#include <CGAL/Isocurves_and_layouts/internal/tracing/decisions.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// From the chart of a corner to the chart of another corner at the same vertex. Both charts differ
// by whole units, so nothing is rounded.
template <typename Group = Quarter_turns>
Uv carried(const Uv& u, const typename Group::Element rotation, const Uv& from, const Uv& to)
{
  const Uv r = Group::apply(rotation, u);
  if constexpr(Group::is_signed_permutation) {
    const Uv origin = Group::apply(rotation, from);
    return {r[0] + Exact_difference(to[0], origin[0]).rounded,
            r[1] + Exact_difference(to[1], origin[1]).rounded};
  } else {
    const auto translation = [&](const int c) {
      const Signed_functional here = Group::act(Group::inverse(rotation), c);
      return nearest_double(offset<Group>(component<Group>(from, std::size_t(here.index)),
                                          here.sign, component<Group>(to, std::size_t(c))));
    };
    return {r[0] + translation(0), r[1] + translation(1)};
  }
}

template <typename Group = Quarter_turns>
Uv unit_step(const Uv& u, const Direction direction)
{
  const Uv step = Group::apply(direction, Uv{1, 0});
  return {u[0] + step[0], u[1] + step[1]};
}

// A walk of one unit: its end, in the chart where the walk is; and once it has arrived, where that
// lies, if it is not a vertex.
struct Unit_step
{
  Uv end{};
  Lattice_place place = Lattice_place::VERTEX;
  Corner_index corner = no_index;                  // of the face, or on the edge
  Direction direction = 0;                         // of the walk
  bool ran_along_feature = false;
};

// Copies share the step.
template <typename Group>
class Basic_integer_decisions
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  using Level = double;
  using State = Walk_state<Level>;

  // `is_feature` tells of corners whether their edge is one.
  Basic_integer_decisions(const Mesh& mesh, const std::vector<char>& is_feature, Unit_step& step)
    : m_mesh(&mesh), m_is_feature(&is_feature), m_step(&step)
  { }

  // Whether the end comes before the walk leaves the face of the state's halfedge over this edge,
  // or by this vertex.
  bool ends_before(const State& state) const
  {
    if(!state.is_at_vertex) {
      const Corner_index h = state.halfedge;
      const auto side = orientation({m_mesh->uv(Mesh::prev(h)), m_mesh->uv(h), m_step->end});
      return side != CGAL::NEGATIVE &&
             arrive(side == CGAL::ZERO ? Lattice_place::EDGE : Lattice_place::FACE, h,
                    state.direction);
    }
    return comes_before(state.halfedge, state.direction) &&
           arrive(Lattice_place::FACE, state.halfedge, state.direction);
  }

  // Whether a walk along `edge` to the corner `vertex` of its face ends before.
  bool ends_on_edge(const Corner_index edge, const Corner_index vertex,
                    const Direction direction) const
  {
    m_step->ran_along_feature = m_step->ran_along_feature ||
                          (!m_is_feature->empty() && (*m_is_feature)[std::size_t(edge)]);
    return comes_before(vertex, direction) && arrive(Lattice_place::EDGE, edge, direction);
  }

  // Whether a walk that leaves a vertex ends on its first step.
  bool ends_on_first_step(const Vertex_ray& ray) const
  {
    const Corner_index c = ray.corner;
    if(ray.kind == Ray_kind::ALONG_FIRST_EDGE)
      return ends_on_edge(Mesh::next(c), Mesh::next(c), ray.direction);
    if(ray.kind == Ray_kind::ALONG_LAST_EDGE)
      return ends_on_edge(c, Mesh::prev(c), ray.direction);
    State state;
    state.halfedge = Mesh::prev(c);
    state.direction = ray.direction;
    return ends_before(state);
  }

  // The interface of the walk's template argument.

  void cross(const Basic_chart_transition<Group>& transition, State& state) const
  {
    const Uv r = Group::apply(transition.rotation, m_step->end);
    m_step->end = {r[0] + nearest_double(transition.translation[0]),
                   r[1] + nearest_double(transition.translation[1])};
    state.direction = turned<Group>(state.direction, transition.rotation);
    state.level = Group::value(int(constant_component<Group>(state.direction)), m_step->end);
  }

  static double approximation(const Level level) { return level; }
  static int side_of(const Level level, const double coordinate)
  { return compare(coordinate, level); }
  static int side_of(const Level level, const Exact_difference& coordinate)
  { return compare(coordinate, Exact_difference(level, 0)); }

  // Whether the curve leads through the next face. If not, the end lies there.
  bool enters(const State& state) const
  {
    const Corner_index apex = Mesh::next(state.halfedge);
    const int side = side_of(
      state.level, m_mesh->component(apex, constant_component<Group>(state.direction)));
    State exit = state;
    exit.is_at_vertex = side == 0;
    exit.halfedge = side == -left_sign<Group>(state.direction) ? Mesh::next(apex) : apex;
    return !ends_before(exit);
  }
  static Isocurve_status failure() { return Isocurve_status::TARGET; }

  Isocurve_status choose_ray(const State& state, const Isocurve_rays& around,
                             Vertex_ray& chosen) const
  {
    const Isocurve_status status =
      Basic_exact_decisions<Group>::straight_ray(*m_mesh, state, around, chosen);
    if(status != Isocurve_status::CONTINUES)
      return status;
    const typename Group::Element turn =
      turned<Group>(chosen.direction, Group::inverse(state.direction));
    m_step->end =
      carried<Group>(m_step->end, turn, m_mesh->uv(state.halfedge), m_mesh->uv(chosen.corner));
    return ends_on_first_step(chosen) ? Isocurve_status::TARGET : Isocurve_status::CONTINUES;
  }

  static Isocurve_status return_beside_start(const State&, const State&)
  { return Isocurve_status::CONTINUES; }
  static Isocurve_status leave_over_border(const State&) { return Isocurve_status::BORDER; }

private:
  bool comes_before(const Corner_index vertex, const int direction) const
  {
    const std::size_t c = running_component<Group>(direction);
    return running_sign<Group>(direction) * side_of(Group::value(int(c), m_step->end),
                                                    m_mesh->component(vertex, c)) > 0;
  }

  bool arrive(const Lattice_place place, const Corner_index corner,
              const Direction direction) const
  {
    m_step->place = place;
    m_step->corner = corner;
    m_step->direction = direction;
    return true;
  }

  const Mesh* m_mesh;
  const std::vector<char>* m_is_feature;
  Unit_step* m_step;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_INTEGER_DECISIONS_H
