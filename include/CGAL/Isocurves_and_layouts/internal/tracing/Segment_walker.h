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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_SEGMENT_WALKER_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_SEGMENT_WALKER_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Isocurves of exactly seamless maps as sequences of segments, one in each face that is crossed and
// one along each edge. The running component of the start is carried through transitions, as the
// level of the curve is: so the length up to any point is a difference of two numbers in one chart,
// and exact.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/decisions.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Isocurve_walk.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/start_walk.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>

#include <CGAL/Exact_rational.h>

#include <cstddef>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// An end of a segment: the corner of its face at a vertex, or the halfedge of its face on which it
// lies. Inside of a face, `halfedge` is one of the face.
struct Segment_end
{
  Isocurve_place place = Isocurve_place::VERTEX;
  Corner_index halfedge = no_index;
};

// Invariant: both ends, and `along` if it is set, are of one face; all coordinates belong to
// its chart.
struct Chart_segment
{
  Segment_end entry, exit;
  Corner_index along = no_index; // the halfedge on which the segment lies, if it lies on an edge
  Direction direction = 0;
  Exact_level level;             // of the constant component
  Exact_level origin;            // the running component of the start of the curve
  bool is_first = false;         // its entry is the start of the curve
  bool is_closing = false;       // its exit is the start, which is no vertex, and its running
  Exact_level closing;           // component is this

  Flat_face_index face() const { return Flat_mesh<Flat_corner>::face(exit.halfedge); }
};

// The running component where an isocurve crosses the edge of a halfedge.
template <typename Group>
Exact_rational running_on_edge(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                               const Direction direction, const Exact_level& level)
{
  const std::size_t c = constant_component<Group>(direction);
  const Exact_rational a = exact_value(mesh.component(mesh.prev(h), c));
  const Exact_rational b = exact_value(mesh.component(h, c));
  return component_on_edge(mesh, h, Exact_rational((level.exact() - a) / (b - a)),
                           running_component<Group>(direction));
}

// The running component at an end that is not a start inside of a face or edge.
template <typename Group>
Exact_rational running_at(const Basic_chart_mesh<Group>& mesh, const Chart_segment& segment,
                          const Segment_end& end)
{
  if(end.place != Isocurve_place::VERTEX)
    return running_on_edge(mesh, end.halfedge, segment.direction, segment.level);
  return exact_value(mesh.component(end.halfedge, running_component<Group>(segment.direction)));
}

template <typename Group>
Exact_rational running_to(const Basic_chart_mesh<Group>& mesh, const Chart_segment& segment)
{
  return segment.is_closing ? segment.closing.exact() : running_at(mesh, segment, segment.exit);
}

// Invariant: after a call of advance() that returned CONTINUES, the segment is the last one so far.
template <typename Group>
class Basic_segment_walker
{
  using Mesh = Basic_chart_mesh<Group>;
  using Decisions = Basic_exact_decisions<Group>;
  using Walk = Isocurve_walk<Decisions, Group>;
  using State = typename Walk::State;

public:
  // The arguments have to outlive the walker. Needs rounding to nearest, as do all functions.
  Basic_segment_walker(const Mesh& mesh, const Walk_limits& limits, const Chart_start& start,
                       const Direction direction)
    : m_mesh(&mesh), m_walk(mesh, limits, Decisions(mesh))
  {
    Decisions decisions(mesh);
    const auto beginning = begin_walk(mesh, start, direction, decisions, m_walk);
    m_status = beginning.status;
    m_is_at_first_state = beginning.is_first_state;
    m_may_close_inside = start.place != Isocurve_place::VERTEX && !beginning.is_first_state;
    if(m_is_at_first_state) // maybe in the chart of the other face of its edge
      set_start(m_walk.state(), start.place,
                running_on_edge(mesh, m_walk.state().halfedge, m_walk.state().direction,
                                m_walk.state().level));
    else
      set_start(beginning.start, start.place, beginning.running);
  }

  // Along a ray from a vertex.
  Basic_segment_walker(const Mesh& mesh, const Walk_limits& limits, const Vertex_ray& ray)
    : m_mesh(&mesh), m_walk(mesh, limits, Decisions(mesh))
  {
    State start;
    start.is_at_vertex = true;
    start.halfedge = ray.corner;
    start.direction = ray.direction;
    set_start(start, Isocurve_place::VERTEX, Exact_rational(0));
    m_walk.begin_at_vertex(ray);
  }

  // Goes on to the next segment. Otherwise the curve has ended, where the last segment ends.
  Isocurve_status advance()
  {
    if(m_status != Isocurve_status::CONTINUES)
      return m_status;
    if(m_is_first_segment && !m_is_at_first_state) {
      m_segment.entry = m_start;
    } else if(m_segment.is_closing) {
      return m_status = Isocurve_status::CLOSED;
    } else {
      const State before = m_walk.state();
      m_status = m_walk.step();
      if(m_status != Isocurve_status::CONTINUES)
        return m_status;
      carry_origin(before);
    }
    update_segment();
    return m_status;
  }

  Isocurve_status status() const { return m_status; }
  const Chart_segment& segment() const { return m_segment; }

private:
  void set_start(const State& start, const Isocurve_place place, const Exact_rational& running)
  {
    m_start = {place, start.halfedge};
    m_segment.direction = start.direction;
    m_segment.origin =
      place == Isocurve_place::VERTEX
        ? Exact_level(m_mesh->component(start.halfedge,
                                        running_component<Group>(start.direction)))
        : Exact_level(running);
    m_segment.closing = m_segment.origin;
  }

  void update_segment()
  {
    const State& state = m_walk.state();
    m_segment.exit = {state.is_at_vertex ? Isocurve_place::VERTEX : Isocurve_place::EDGE,
                      state.halfedge};
    m_segment.direction = state.direction;
    m_segment.level = state.level;
    m_segment.along = edge_along(state);
    m_segment.is_first = m_is_first_segment;
    if(m_is_first_segment)
      m_first_state = state;
    else if(m_may_close_inside && is_first_state(state))
      close();
    m_is_first_segment = false;
  }

  // The segment leads to the start only, and is in its chart also where it lies along an edge and
  // the curve has come through the other face.
  void close()
  {
    m_segment.is_closing = true;
    m_segment.exit = m_start;
    if(m_segment.along == no_index || m_segment.along == m_start.halfedge)
      return;
    carry_over_edge(*m_mesh, m_segment.along, running_component<Group>(m_segment.direction),
                    m_segment.origin);
    m_segment.along = m_start.halfedge;
    m_segment.entry.halfedge = m_first_state.halfedge == m_start.halfedge
                                 ? Mesh::prev(m_start.halfedge) : m_start.halfedge;
    m_segment.direction = m_first_state.direction;
    m_segment.level = m_first_state.level;
  }

  // The halfedge of the state's face on which the curve has come to its vertex, if it has.
  Corner_index edge_along(const State& state) const
  {
    if(!state.is_at_vertex || state.arrival_key == no_index)
      return no_index;
    return m_mesh->edge_key(state.halfedge) == state.arrival_key ? state.halfedge
                                                                 : Mesh::next(state.halfedge);
  }

  bool is_first_state(const State& state) const
  {
    if(state.is_at_vertex && state.arrival_key != no_index)
      return state.arrival_key == m_first_state.arrival_key &&
             m_mesh->vertex(state.halfedge) == m_mesh->vertex(m_first_state.halfedge);
    return state.halfedge == m_first_state.halfedge && state.direction == m_first_state.direction &&
           state.is_at_vertex == m_first_state.is_at_vertex &&
           state.level == m_first_state.level;
  }

  // From the chart in front of an edge or vertex to that behind it; sets the entry.
  void carry_origin(const State& before)
  {
    const State& state = m_walk.state();
    if(!before.is_at_vertex) {
      m_segment.entry = {Isocurve_place::EDGE, m_mesh->opposite(before.halfedge)};
      carry_over_edge(*m_mesh, before.halfedge, running_component<Group>(before.direction),
                      m_segment.origin);
      return;
    }
    const Corner_index corner = corner_left_by(state);
    m_segment.entry = {Isocurve_place::VERTEX, corner};
    const int sign = running_sign<Group>(before.direction) * running_sign<Group>(state.direction);
    m_segment.origin.transform(
      sign, offset<Group>(m_mesh->component(before.halfedge,
                                            running_component<Group>(before.direction)),
                          sign,
                          m_mesh->component(corner, running_component<Group>(state.direction))));
  }

  // The corner of the state's face at the vertex that the curve has left.
  Corner_index corner_left_by(const State& state) const
  {
    if(!state.is_at_vertex)
      return Mesh::next(state.halfedge);
    const Corner_index along = edge_along(state);
    return along == state.halfedge ? Mesh::prev(along) : along;
  }

  const Mesh* m_mesh;
  Walk m_walk;
  Segment_end m_start;
  State m_first_state;
  Chart_segment m_segment;
  Isocurve_status m_status = Isocurve_status::CONTINUES;
  bool m_is_first_segment = true;
  bool m_is_at_first_state = false; // the walk has begun at the start, not behind the first segment
  bool m_may_close_inside = false;  // of a segment
};

using Segment_walker = Basic_segment_walker<Quarter_turns>;

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_SEGMENT_WALKER_H
