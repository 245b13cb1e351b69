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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_EXACT_DECISIONS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_EXACT_DECISIONS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// What a walk on an exactly seamless map decides, exactly. None of it can fail: what is true in one
// chart is true in the next.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Walk_state.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

template <typename Group>
class Basic_exact_decisions
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  using Level = Exact_level;
  using State = Walk_state<Level>;

  explicit Basic_exact_decisions(const Mesh& mesh) : m_mesh(&mesh) { }

  // From the chart of the transition's one face to that of the other.
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

  // The ray that continues the curve straight on: the opposite one, as many to its left as to its
  // right. In a star without folds that is the only one but that of arrival.
  template <typename AnyLevel>
  static Isocurve_status straight_ray(const Mesh& mesh, const Walk_state<AnyLevel>& state,
                                      const Isocurve_rays& around, Vertex_ray& chosen)
  {
    const std::size_t n = around.rays.size();
    const std::size_t arrival = std::size_t(
      std::find_if(around.rays.begin(), around.rays.end(),
                   [&](const Vertex_ray& ray) { return state.arrived_by(mesh, ray); }) -
      around.rays.begin());
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

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_EXACT_DECISIONS_H
