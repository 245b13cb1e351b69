// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_DECISIONS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_DECISIONS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The decisions of a walk: exact ones on an exactly seamless map, and on other maps decisions as
// naive code makes them.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// On an exactly seamless map. None of it can fail: what is true in one chart is true in the next.
template <typename Group>
class Basic_exact_decisions
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  using Level = Exact_level;
  using State = Walk_state<Level>;

  explicit Basic_exact_decisions(const Mesh& mesh) : m_mesh(&mesh) { }

  // From the chart of the first face of the transition to the chart of the second face.
  static void cross(const Basic_chart_transition<Group>& transition, State& state)
  {
    const Signed_functional constant =
      Group::act(transition.rotation, int(constant_component<Group>(state.direction)));
    state.direction = turned<Group>(state.direction, transition.rotation);
    state.level.transform(constant.sign, transition.translation[std::size_t(constant.index)]);
  }

  static double approximation(const Level& level) { return level.approximation(); }
  static int side_of(const Level& level, const Component<Group>& component)
  { return level.side_of(component); }

  // Whether the curve leads into the face whose halfedge it has just crossed: its source lies at
  // the left, its target at the right.
  bool enters(const State& state) const
  {
    const std::size_t c = constant_component<Group>(state.direction);
    CGAL_USE(c);
    CGAL_assertion_code(const int left = left_sign<Group>(state.direction));
    CGAL_assertion(state.level.side_of(m_mesh->component(Mesh::prev(state.halfedge), c)) == left);
    CGAL_assertion(state.level.side_of(m_mesh->component(state.halfedge, c)) == -left);
    return true;
  }

  Isocurve_status choose_ray(const State& state, const Isocurve_rays& around,
                             Vertex_ray& chosen) const
  {
    return straight_ray(*m_mesh, state, around, chosen);
  }

  // The ray that continues the curve straight on: it has as many rays on its left as on its right,
  // counted from the ray of arrival. In a star without folds, it is the only other ray.
  template <typename AnyLevel>
  static Isocurve_status straight_ray(const Mesh& mesh, const Walk_state<AnyLevel>& state,
                                      const Isocurve_rays& around, Vertex_ray& chosen)
  {
    const std::size_t n = around.rays.size();
    const std::size_t arrival = slot_of_arrival(mesh, state, around.rays);
    const bool is_border = mesh.is_border[mesh.vertex(state.halfedge)];
    if(arrival == n || (!is_border && n % 2 != 0))
      return Isocurve_status::CONSTANT_ON_FACE;
    if(is_border && n == 1)
      return Isocurve_status::BORDER;
    if(is_border && n > 2)
      return Isocurve_status::SINGULAR_VERTEX;
    chosen = around.rays[(arrival + n / 2) % n];
    return Isocurve_status::CONTINUES;
  }

  // Curves may well return beside their start, and spiral.
  static Isocurve_status return_beside_start(const State&, const State&)
  { return Isocurve_status::CONTINUES; }

  static Isocurve_status leave_over_border(const State&) { return Isocurve_status::BORDER; }

  // Not called: the walk always enters the next face.
  static Isocurve_status failure() { return Isocurve_status::CONTINUES; }

private:
  const Mesh* m_mesh;
};

using Exact_decisions = Basic_exact_decisions<Quarter_turns>;

// In floating point: the same questions, but the answers of two charts need not agree. What goes
// wrong is classified as in [MC19] Sec. 6.2.
template <typename Group>
class Basic_floating_point_decisions
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  using Level = double;
  using State = Walk_state<Level>;

  // A curve that comes closer than `near_distance` to a singular vertex or a target is meant to
  // meet it. A loop should return to `start`, in this direction, unless that is no_index.
  Basic_floating_point_decisions(const Mesh& mesh, const Walk_limits& limits,
                                 const Corner_index start, const Direction start_direction,
                                 const double near_distance)
    : m_mesh(mesh), m_limits(limits), m_start(start), m_start_direction(start_direction),
      m_near(near_distance)
  { }

  // The translation and the sum are rounded.
  static void cross(const Basic_chart_transition<Group>& transition, State& state)
  {
    const Signed_functional constant =
      Group::act(transition.rotation, int(constant_component<Group>(state.direction)));
    state.direction = turned<Group>(state.direction, transition.rotation);
    state.level = constant.sign * state.level +
                  nearest_double(transition.translation[std::size_t(constant.index)]);
  }

  static double approximation(const Level level) { return level; }
  static int side_of(const Level level, const Component<Group>& component)
  { return compare(nearest_double(component), level); }

  bool enters(const State& state)
  {
    const std::size_t c = constant_component<Group>(state.direction);
    const int left = left_sign<Group>(state.direction);
    const double source = m_mesh.rounded_component(Mesh::prev(state.halfedge), c);
    const double target = m_mesh.rounded_component(state.halfedge, c);
    if(left * compare(source, target) <= 0)
      m_failure = Isocurve_status::STUCK_AT_CUT; // here the edge faces the other way
    else if(left * compare(source, state.level) < 0 || left * compare(target, state.level) > 0)
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
           is_nearly_along(state.halfedge, reversed<Group>(state.direction))
             ? Isocurve_status::FELL_OFF_BORDER : Isocurve_status::BORDER;
  }

private:
  // Whether the edge was meant to run in this direction.
  bool is_nearly_along(const Corner_index h, const Direction direction) const
  {
    const auto change = [&](const std::size_t c)
    { return m_mesh.rounded_component(h, c) - m_mesh.rounded_component(Mesh::prev(h), c); };
    const double along =
      running_sign<Group>(direction) * change(running_component<Group>(direction));
    const double across = std::abs(change(constant_component<Group>(direction)));
    return across <= m_near && along > 4 * across;
  }

  // Whether one of the border edges at the vertex was meant to continue the curve.
  bool border_continues(const State& state) const
  {
    Direction direction = state.direction;
    Corner_index corner = first_corner(m_mesh, state.halfedge, direction);
    if(is_nearly_along(Mesh::next(corner), direction))
      return true;
    while(m_mesh.opposite(corner) != no_index) {
      direction = turned<Group>(direction, m_mesh.rotation(corner));
      corner = m_mesh.counterclockwise(corner);
    }
    return is_nearly_along(corner, reversed<Group>(direction));
  }

  // Whether the curve is about to pass beside a vertex that it should meet.
  Isocurve_status near_miss(const State& state) const
  {
    const Corner_index apex = Mesh::next(state.halfedge);
    const std::size_t v = m_mesh.vertex(apex);
    const double distance = std::abs(
      m_mesh.rounded_component(apex, constant_component<Group>(state.direction)) - state.level);
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
      direction = turned<Group>(direction, m_mesh.rotation(corner));
      corner = m_mesh.counterclockwise(corner);
    }
    return corner == m_start && direction == m_start_direction;
  }

  const Mesh& m_mesh;
  const Walk_limits& m_limits;
  Corner_index m_start;
  Direction m_start_direction;
  double m_near;
  Isocurve_status m_failure = Isocurve_status::CONTINUES;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_DECISIONS_H
