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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_ISOCURVE_WALK_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_ISOCURVE_WALK_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The walk along an isocurve, from edge to edge and through vertices, a step at a time. The
// template argument decides exactly or in floating point, so that both kinds of tracing are this
// same walk.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Invariant: once it has begun, and until it ends, the state is the edge that the curve is about to
// cross, or the vertex that it is about to pass, as seen from the face that it comes through.
template <typename Decisions, typename Group = Quarter_turns>
class Isocurve_walk
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  using Level = typename Decisions::Level;
  using State = Walk_state<Level>;

  // The arguments have to outlive the walk.
  Isocurve_walk(const Mesh& mesh, const Walk_limits& limits, const Decisions& decisions)
    : m_mesh(&mesh), m_limits(&limits), m_decisions(decisions)
  { }

  // Along a ray from a vertex.
  void begin_at_vertex(const Vertex_ray& ray)
  {
    m_start_ray = ray;
    m_starts_at_vertex = true;
    take(ray);
  }

  // Through the edge or vertex `state` that the curve is about to meet.
  void begin(const State& state) { m_state = state; }

  // Begins at a point of its face whose running coordinate is `start`.
  void begin(const State& state, const double start)
  {
    m_state = state;
    if(has_length())
      m_length = m_length_before = length_between(
        start, state.is_at_vertex ? running(state.halfedge) : running_on_edge(state.halfedge));
  }

  // From a border edge into the face that `state` gives.
  Isocurve_status begin_at_border(const State& state)
  {
    m_state = state;
    return traverse_face();
  }

  // Passes the edge or vertex of the state, and goes on to the next one.
  Isocurve_status step()
  {
    const Isocurve_status status = m_state.is_at_vertex ? pass_vertex() : cross_edge();
    if(status == Isocurve_status::CLOSED)
      m_length -= m_length_before; // it went round to the first edge or vertex, beyond the start
    return status;
  }

  std::size_t number_of_crossings() const { return m_crossings; }
  double length() const { return m_length; }
  const State& state() const { return m_state; }

private:
  Isocurve_status cross_edge()
  {
    Isocurve_status status = compare_with_start();
    if(status != Isocurve_status::CONTINUES)
      return status;
    const Chart_corner& exit = m_mesh->corner(m_state.halfedge);
    if(exit.opposite == no_index)
      return m_decisions.leave_over_border(m_state);
    ++m_crossings;
    status = compare_with_bounds();
    if(status != Isocurve_status::CONTINUES)
      return status;
    if(exit.transition != no_index)
      m_decisions.cross(m_mesh->transitions[std::size_t(exit.transition)], m_state);
    m_state.halfedge = exit.opposite;
    return traverse_face();
  }

  // One comparison tells which way the curve leaves a face: the edge it enters by has one end on
  // each side, so that the third corner decides.
  Isocurve_status traverse_face()
  {
    if(!m_decisions.enters(m_state)) // never, where decisions are exact
      return m_decisions.failure();
    const Corner_index entry = m_state.halfedge;
    const Corner_index apex = Mesh::next(entry);
    const int side = m_decisions.side_of(
      m_state.level, m_mesh->component(apex, constant_component<Group>(m_state.direction)));
    if(has_length())
      m_length += length_through(entry, side);
    if(side == 0)
      arrive(apex, no_index);
    else
      m_state.halfedge = (side == left_sign<Group>(m_state.direction)) ? apex : Mesh::next(apex);
    return Isocurve_status::CONTINUES;
  }

  Isocurve_status pass_vertex()
  {
    const std::size_t v = m_mesh->vertex(m_state.halfedge);
    if(m_limits->is_target(v))
      return Isocurve_status::TARGET;
    if(m_mesh->is_singular[v])
      return Isocurve_status::SINGULAR_VERTEX;
    ++m_crossings;
    m_rays.collect(*m_mesh, m_state.halfedge, m_state.direction);
    Vertex_ray ray;
    Isocurve_status status = m_decisions.choose_ray(m_state, m_rays, ray);
    if(status != Isocurve_status::CONTINUES)
      return status;
    if(m_starts_at_vertex && ray == m_start_ray) {
      m_crossings -= m_is_start_counted ? 1 : 0;
      return Isocurve_status::CLOSED;
    }
    status = compare_with_bounds();
    if(status == Isocurve_status::CONTINUES) {
      remember_start_ray(ray);
      take(ray);
    }
    return status;
  }

  // At the edge or vertex that the curve has met, once it has no other reason to end there.
  Isocurve_status compare_with_bounds() const
  {
    if(m_crossings >= m_limits->maximum_number)
      return Isocurve_status::MAXIMUM_NUMBER;
    return m_length >= m_limits->maximum_length ? Isocurve_status::MAXIMUM_LENGTH
                                               : Isocurve_status::CONTINUES;
  }

  void take(const Vertex_ray& ray)
  {
    m_state.direction = ray.direction;
    m_state.level =
      make_level<Level>(m_mesh->component(ray.corner, constant_component<Group>(ray.direction)));
    if(ray.kind == Ray_kind::THROUGH_FACE) {
      m_state.is_at_vertex = false;
      m_state.halfedge = Mesh::prev(ray.corner);
      if(has_length())
        m_length += length_between(running(ray.corner), running_on_edge(m_state.halfedge));
      return;
    }
    const bool is_first = ray.kind == Ray_kind::ALONG_FIRST_EDGE;
    const Corner_index end = is_first ? Mesh::next(ray.corner) : Mesh::prev(ray.corner);
    if(has_length())
      m_length += length_between(running(ray.corner), running(end));
    arrive(end, m_mesh->edge_key(is_first ? end : ray.corner));
  }

  void arrive(const Corner_index corner, const Corner_index along_key)
  {
    m_state.is_at_vertex = true;
    m_state.halfedge = corner;
    m_state.arrival_key = along_key;
  }

  // A loop closes where it began: the map is reversible, so that no curve runs into the middle of
  // another.
  Isocurve_status compare_with_start()
  {
    if(m_starts_at_vertex)
      return Isocurve_status::CONTINUES;
    if(m_start.halfedge == no_index) {
      m_start = m_state;
      return Isocurve_status::CONTINUES;
    }
    if(m_state.halfedge != m_start.halfedge || m_state.direction != m_start.direction)
      return Isocurve_status::CONTINUES;
    return m_state.level == m_start.level ? Isocurve_status::CLOSED
                                          : m_decisions.return_beside_start(m_state, m_start);
  }

  // The first vertex that a curve leaves which did not start at a vertex.
  void remember_start_ray(const Vertex_ray& ray)
  {
    if(!m_starts_at_vertex && m_start.halfedge == no_index) {
      m_starts_at_vertex = m_is_start_counted = true;
      m_start_ray = ray;
    }
  }

  // Lengths are measured in floating point: they bound a walk, and decide nothing else.
  bool has_length() const
  { return m_limits->maximum_length < std::numeric_limits<double>::infinity(); }

  double running(const Corner_index corner) const
  {
    return m_mesh->rounded_component(corner, running_component<Group>(m_state.direction));
  }

  double running_on_edge(const Corner_index h) const
  {
    const std::size_t c = constant_component<Group>(m_state.direction);
    const Corner_index source = Mesh::prev(h);
    const double a = m_mesh->rounded_component(source, c), b = m_mesh->rounded_component(h, c);
    const double parameter = (Decisions::approximation(m_state.level) - a) / (b - a);
    return running(source) + parameter * (running(h) - running(source));
  }

  static double length_between(const double a, const double b) { return std::abs(b - a); }

  double length_through(const Corner_index entry, const int apex_side) const
  {
    const Corner_index apex = Mesh::next(entry);
    const double end = apex_side == 0
      ? running(apex)
      : running_on_edge(apex_side == left_sign<Group>(m_state.direction) ? apex : Mesh::next(apex));
    return length_between(running_on_edge(entry), end);
  }

  const Mesh* m_mesh;
  const Walk_limits* m_limits;
  Decisions m_decisions;

  State m_state;
  Isocurve_rays m_rays;
  std::size_t m_crossings = 0;
  double m_length = 0;
  double m_length_before = 0; // the first edge or vertex

  bool m_starts_at_vertex = false;
  bool m_is_start_counted = false; // as a crossing: it is the first vertex, after another start
  Vertex_ray m_start_ray{no_index, 0, Ray_kind::THROUGH_FACE};
  State m_start; // where it left its first face, if it did not start at a vertex
};

// To the end of the curve. `add` is called with the states, one for each edge crossed and vertex
// met.
template <typename Walk, typename Function>
Isocurve_status run(Walk& walk, const Function& add)
{
  Isocurve_status status;
  do {
    add(walk.state());
    status = walk.step();
  } while(status == Isocurve_status::CONTINUES);
  return status;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_ISOCURVE_WALK_H
