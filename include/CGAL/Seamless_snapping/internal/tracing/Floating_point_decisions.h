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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_FLOATING_POINT_DECISIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_FLOATING_POINT_DECISIONS_H

#include <CGAL/license/Seamless_snapping.h>

// What naive code decides, in floating point, on a map that is not exactly seamless: the same
// questions as on an exact one, but the answers of two charts need not agree. What goes wrong is
// classified as in Sec. 6.2 of the paper.

#include <CGAL/Seamless_snapping/Isocurve_status.h>
#include <CGAL/Seamless_snapping/internal/tracing/Chart_mesh.h>
#include <CGAL/Seamless_snapping/internal/tracing/Vertex_rays.h>
#include <CGAL/Seamless_snapping/internal/tracing/Walk_state.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Floating_point_decisions
{
public:
  using Level = double;
  using State = Walk_state<Level>;

  // A curve that comes closer than `near_distance` to a singular vertex or a target is meant to
  // meet it. A loop should return to `start`, in this direction, unless that is no_index.
  Floating_point_decisions(const Chart_mesh& mesh, const Walk_limits& limits,
                           const Corner_index start, const Direction start_direction,
                           const double near_distance)
    : m_mesh(mesh), m_limits(limits), m_start(start), m_start_direction(start_direction),
      m_near(near_distance)
  { }

  // The translation and the sum are rounded.
  static void cross(const Chart_transition& transition, State& state)
  {
    const Signed_functional constant =
      Quarter_turns::act(transition.rotation, int(constant_component(state.direction)));
    state.direction = turned(state.direction, transition.rotation);
    state.level = constant.sign * state.level +
                  transition.translation[std::size_t(constant.index)].rounded;
  }

  static double approximation(const Level level) { return level; }
  static int side_of(const Level level, const double coordinate)
  { return compare(coordinate, level); }

  bool enters(const State& state)
  {
    const std::size_t c = constant_component(state.direction);
    const int left = left_sign(state.direction);
    const double source = m_mesh.uv(Chart_mesh::prev(state.halfedge))[c];
    const double target = m_mesh.uv(state.halfedge)[c];
    if(left * compare(source, target) <= 0)
      m_failure = Isocurve_status::STUCK_AT_CUT; // here the edge faces the other way
    else if(left * side_of(state.level, source) < 0 || left * side_of(state.level, target) > 0)
      m_failure = Isocurve_status::FELL_INTO_GAP;
    else
      m_failure = near_miss(state);
    return m_failure == Isocurve_status::CONTINUES;
  }

  Isocurve_status failure() const { return m_failure; }

  // Every ray in the direction of the curve is a way out.
  Isocurve_status choose_ray(const State& state, const Isocurve_rays& around,
                             Vertex_ray& chosen) const
  {
    std::size_t count = 0;
    for(std::size_t i = 0; i < around.rays.size(); ++i)
      if(around.is_forward[i]) {
        chosen = around.rays[i];
        ++count;
      }
    if(count == 1)
      return Isocurve_status::CONTINUES;
    if(count > 1)
      return Isocurve_status::SEVERAL_WAYS_OUT;
    if(!m_mesh.is_border[m_mesh.vertex(state.halfedge)])
      return Isocurve_status::NO_WAY_OUT;
    return border_continues(state) ? Isocurve_status::FELL_OFF_BORDER : Isocurve_status::BORDER;
  }

  // After one turn, beside where it began.
  Isocurve_status return_beside_start(const State& state, const State& start) const
  {
    return std::abs(state.level - start.level) <= m_near ? Isocurve_status::SPIRALS
                                                         : Isocurve_status::CONTINUES;
  }

  Isocurve_status leave_over_border(const State& state) const
  {
    return is_nearly_along(state.halfedge, state.direction) ||
           is_nearly_along(state.halfedge, reversed(state.direction))
             ? Isocurve_status::FELL_OFF_BORDER : Isocurve_status::BORDER;
  }

private:
  // Whether the edge was meant to run in this direction.
  bool is_nearly_along(const Corner_index h, const Direction direction) const
  {
    const Uv a = m_mesh.uv(Chart_mesh::prev(h)), b = m_mesh.uv(h);
    const std::size_t c = constant_component(direction), r = running_component(direction);
    const double along = running_sign(direction) * (b[r] - a[r]);
    const double across = std::abs(b[c] - a[c]);
    return across <= m_near && along > 4 * across;
  }

  // Whether one of the border edges at the vertex was meant to continue the curve.
  bool border_continues(const State& state) const
  {
    Direction direction = state.direction;
    Corner_index corner = first_corner(m_mesh, state.halfedge, direction);
    if(is_nearly_along(Chart_mesh::next(corner), direction))
      return true;
    while(m_mesh.opposite(corner) != no_index) {
      direction = turned(direction, m_mesh.rotation(corner));
      corner = m_mesh.counterclockwise(corner);
    }
    return is_nearly_along(corner, reversed(direction));
  }

  // Whether the curve is about to pass beside a vertex that it should meet.
  Isocurve_status near_miss(const State& state) const
  {
    const Corner_index apex = Chart_mesh::next(state.halfedge);
    const std::size_t v = m_mesh.vertex(apex);
    const double distance =
      std::abs(m_mesh.uv(apex)[constant_component(state.direction)] - state.level);
    if(distance == 0 || distance > m_near)
      return Isocurve_status::CONTINUES;
    const bool is_singular = m_mesh.is_singular[v] != 0;
    if(!is_singular && is_start(apex, state.direction))
      return Isocurve_status::SPIRALS;
    return is_singular || m_limits.is_target(v) ? Isocurve_status::MISSED_TARGET
                                                : Isocurve_status::CONTINUES;
  }

  // Whether the curve started from the vertex of this corner, in this direction.
  bool is_start(Corner_index corner, Direction direction) const
  {
    if(m_start == no_index || m_mesh.vertex(corner) != m_mesh.vertex(m_start))
      return false;
    while(corner != m_start && m_mesh.opposite(corner) != no_index) {
      direction = turned(direction, m_mesh.rotation(corner));
      corner = m_mesh.counterclockwise(corner);
    }
    return corner == m_start && direction == m_start_direction;
  }

  const Chart_mesh& m_mesh;
  const Walk_limits& m_limits;
  Corner_index m_start;
  Direction m_start_direction;
  double m_near;
  Isocurve_status m_failure = Isocurve_status::CONTINUES;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_FLOATING_POINT_DECISIONS_H
