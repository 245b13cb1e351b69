// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_INTEGER_DECISIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_INTEGER_DECISIONS_H

#include <CGAL/license/Seamless_snapping.h>

// What a walk of one unit along a line of the grid decides, exactly: levels and the end of the walk
// are integers, which stay exact in a `double` through all transitions. The walk ends where the
// next face, edge, or vertex contains the end.

#include <CGAL/Seamless_snapping/Isocurve_status.h>
#include <CGAL/Seamless_snapping/internal/quads/Lattice_points.h>
#include <CGAL/Seamless_snapping/internal/exact/orientation.h>
#include <CGAL/Seamless_snapping/internal/tracing/Exact_decisions.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// From the chart of a corner to that of another one at the same vertex. Both charts differ by whole
// units, so that rounding is none.
inline Uv carried(const Uv& u, const int rotation, const Uv& from, const Uv& to)
{
  const Uv r = Quarter_turns::apply(rotation, u), origin = Quarter_turns::apply(rotation, from);
  return {r[0] + Exact_difference(to[0], origin[0]).rounded,
          r[1] + Exact_difference(to[1], origin[1]).rounded};
}

inline Uv unit_step(const Uv& u, const int direction)
{
  Uv end = u;
  end[running_component(direction)] += running_sign(direction);
  return end;
}

// A walk of one unit: its end, in the chart where the walk is; and once it has arrived, where that
// lies, if it is not a vertex.
struct Unit_step
{
  Uv end{};
  Lattice_place place = Lattice_place::VERTEX;
  Corner_index corner = no_index;                  // of the face, or on the edge
  Direction direction = Quarter_turns::identity(); // of the walk
  bool ran_along_feature = false;
};

// Copies share the step.
class Integer_decisions
{
public:
  using Level = double;
  using State = Walk_state<Level>;

  // `is_feature` tells of corners whether their edge is one.
  Integer_decisions(const Chart_mesh& mesh, const std::vector<char>& is_feature, Unit_step& step)
    : m_mesh(&mesh), m_is_feature(&is_feature), m_step(&step)
  { }

  // Whether the end comes before the walk leaves the face of the state's halfedge over this edge,
  // or by this vertex.
  bool ends_before(const State& state) const
  {
    if(!state.is_at_vertex) {
      const Corner_index h = state.halfedge;
      const auto side = orientation({m_mesh->uv(Chart_mesh::prev(h)), m_mesh->uv(h), m_step->end});
      return side != CGAL::NEGATIVE &&
             arrive(side == CGAL::ZERO ? Lattice_place::EDGE : Lattice_place::FACE, h,
                    state.direction);
    }
    return comes_before(state.halfedge, state.direction) &&
           arrive(Lattice_place::FACE, state.halfedge, state.direction);
  }

  // The same for a walk along `edge` to the corner `vertex` of the same face.
  bool ends_on_edge(const Corner_index edge, const Corner_index vertex,
                    const Direction direction) const
  {
    m_step->ran_along_feature = m_step->ran_along_feature ||
                          (!m_is_feature->empty() && (*m_is_feature)[std::size_t(edge)]);
    return comes_before(vertex, direction) && arrive(Lattice_place::EDGE, edge, direction);
  }

  // The same for a walk that leaves a vertex.
  bool ends_on_first_step(const Vertex_ray& ray) const
  {
    const Corner_index c = ray.corner;
    if(ray.kind == Ray_kind::ALONG_FIRST_EDGE)
      return ends_on_edge(Chart_mesh::next(c), Chart_mesh::next(c), ray.direction);
    if(ray.kind == Ray_kind::ALONG_LAST_EDGE)
      return ends_on_edge(c, Chart_mesh::prev(c), ray.direction);
    State state;
    state.halfedge = Chart_mesh::prev(c);
    state.direction = ray.direction;
    return ends_before(state);
  }

  // The interface of the walk's template argument.

  void cross(const Chart_transition& transition, State& state) const
  {
    const Uv r = Quarter_turns::apply(transition.rotation, m_step->end);
    m_step->end = {r[0] + transition.translation[0].rounded,
                    r[1] + transition.translation[1].rounded};
    state.direction = turned(state.direction, transition.rotation);
    state.level = m_step->end[constant_component(state.direction)];
  }

  static double approximation(const Level level) { return level; }
  static int side_of(const Level level, const double coordinate)
  { return compare(coordinate, level); }

  // Whether the curve leads through the next face. If not, the end lies there.
  bool enters(const State& state) const
  {
    const Corner_index apex = Chart_mesh::next(state.halfedge);
    const int side = side_of(state.level, m_mesh->uv(apex)[constant_component(state.direction)]);
    State exit = state;
    exit.is_at_vertex = side == 0;
    exit.halfedge = side == -left_sign(state.direction) ? Chart_mesh::next(apex) : apex;
    return !ends_before(exit);
  }
  static Isocurve_status failure() { return Isocurve_status::TARGET; }

  Isocurve_status choose_ray(const State& state, const Isocurve_rays& around,
                             Vertex_ray& chosen) const
  {
    const Isocurve_status status = Exact_decisions::straight_ray(*m_mesh, state, around, chosen);
    if(status != Isocurve_status::CONTINUES)
      return status;
    const Quarter_turns::Element turn =
      turned(chosen.direction, Quarter_turns::inverse(state.direction));
    m_step->end =
      carried(m_step->end, turn, m_mesh->uv(state.halfedge), m_mesh->uv(chosen.corner));
    return ends_on_first_step(chosen) ? Isocurve_status::TARGET : Isocurve_status::CONTINUES;
  }

  static Isocurve_status return_beside_start(const State&, const State&)
  { return Isocurve_status::CONTINUES; }
  static Isocurve_status leave_over_border(const State&) { return Isocurve_status::BORDER; }

private:
  bool comes_before(const Corner_index vertex, const int direction) const
  {
    const std::size_t c = running_component(direction);
    return running_sign(direction) * compare(m_step->end[c], m_mesh->uv(vertex)[c]) < 0;
  }

  bool arrive(const Lattice_place place, const Corner_index corner,
              const Direction direction) const
  {
    m_step->place = place;
    m_step->corner = corner;
    m_step->direction = direction;
    return true;
  }

  const Chart_mesh* m_mesh;
  const std::vector<char>* m_is_feature;
  Unit_step* m_step;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_INTEGER_DECISIONS_H
