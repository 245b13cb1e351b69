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
// lies.
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

  Flat_face_index face() const { return Chart_mesh::face(exit.halfedge); }
};

// The running component where an isocurve crosses the edge of a halfedge.
inline Exact_rational running_on_edge(const Chart_mesh& mesh, const Corner_index h,
                                      const Direction direction, const Exact_level& level)
{
  const std::size_t c = constant_component(direction);
  const Exact_rational a(mesh.uv(Chart_mesh::prev(h))[c]), b(mesh.uv(h)[c]);
  return component_on_edge(mesh, h, Exact_rational((level.exact() - a) / (b - a)),
                           running_component(direction));
}

// The running component at an end.
inline Exact_rational running_at(const Chart_mesh& mesh, const Chart_segment& segment,
                                 const Segment_end& end)
{
  if(end.place != Isocurve_place::VERTEX)
    return running_on_edge(mesh, end.halfedge, segment.direction, segment.level);
  return Exact_rational(mesh.uv(end.halfedge)[running_component(segment.direction)]);
}

// Invariant: after a call of advance() that returned CONTINUES, the segment is the last one so far.
class Segment_walker
{
  using Walk = Isocurve_walk<Exact_decisions>;
  using State = Walk::State;

public:
  // Along a ray from a vertex. The mesh and the limits have to outlive the walker. Needs rounding
  // to nearest, as do all functions.
  Segment_walker(const Chart_mesh& mesh, const Walk_limits& limits, const Vertex_ray& ray)
    : m_mesh(&mesh), m_walk(mesh, limits, Exact_decisions(mesh))
  {
    m_segment.entry.halfedge = ray.corner;
    m_segment.origin = Exact_level(mesh.uv(ray.corner)[running_component(ray.direction)]);
    m_walk.begin_at_vertex(ray);
  }

  // Goes on to the next segment. Otherwise the curve has ended, where the last segment ends.
  Isocurve_status advance()
  {
    if(m_status != Isocurve_status::CONTINUES)
      return m_status;
    if(m_has_segment) {
      const State before = m_walk.state();
      m_status = m_walk.step();
      if(m_status != Isocurve_status::CONTINUES)
        return m_status;
      carry_origin(before);
    }
    m_has_segment = true;
    update_segment();
    return m_status;
  }

  Isocurve_status status() const { return m_status; }
  const Chart_segment& segment() const { return m_segment; }

private:
  void update_segment()
  {
    const State& state = m_walk.state();
    m_segment.exit = {state.is_at_vertex ? Isocurve_place::VERTEX : Isocurve_place::EDGE,
                      state.halfedge};
    m_segment.direction = state.direction;
    m_segment.level = state.level;
    m_segment.along = edge_along(state);
  }

  // The halfedge of the state's face on which the curve has come to its vertex, if it has.
  Corner_index edge_along(const State& state) const
  {
    if(!state.is_at_vertex || state.arrival_key == no_index)
      return no_index;
    return m_mesh->edge_key(state.halfedge) == state.arrival_key
             ? state.halfedge : Chart_mesh::next(state.halfedge);
  }

  // From the chart in front of an edge or vertex to that behind it; sets the entry.
  void carry_origin(const State& before)
  {
    const State& state = m_walk.state();
    const std::size_t r = running_component(before.direction);
    if(!before.is_at_vertex) {
      m_segment.entry = {Isocurve_place::EDGE, m_mesh->opposite(before.halfedge)};
      carry_over_edge(*m_mesh, before.halfedge, r, m_segment.origin);
      return;
    }
    const Corner_index corner = corner_left_by(state);
    m_segment.entry = {Isocurve_place::VERTEX, corner};
    const int sign = running_sign(before.direction) * running_sign(state.direction);
    m_segment.origin.transform(
      sign, offset<Quarter_turns>(m_mesh->component(before.halfedge, r), sign,
                                  m_mesh->component(corner, running_component(state.direction))));
  }

  // The corner of the state's face at the vertex that the curve has left.
  Corner_index corner_left_by(const State& state) const
  {
    if(!state.is_at_vertex)
      return Chart_mesh::next(state.halfedge);
    const Corner_index along = edge_along(state);
    return along == state.halfedge ? Chart_mesh::prev(along) : along;
  }

  const Chart_mesh* m_mesh;
  Walk m_walk;
  Chart_segment m_segment;
  Isocurve_status m_status = Isocurve_status::CONTINUES;
  bool m_has_segment = false;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_SEGMENT_WALKER_H
