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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_DART_TRACER_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_DART_TRACER_H

#include <CGAL/license/Quad_remeshing.h>

// From a dart to its twin: a walk of one unit, by exact decisions.
//
// Which darts are traced does not depend on the number of threads. First come the darts in the
// first half of the directions of their charts, which is one of each pair in a single chart; then
// the darts whose twin has not been found yet.

#include <CGAL/Isocurves_and_layouts/internal/tracing/start_walk.h>
#include <CGAL/Quad_remeshing/internal/cells/Grid_darts.h>
#include <CGAL/Quad_remeshing/internal/cells/Integer_decisions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// One for each thread.
template <typename Group>
class Basic_dart_tracer
{
  using Mesh = Basic_chart_mesh<Group>;
  using Decisions = Basic_integer_decisions<Group>;
  using Walk = Isocurve_walk<Decisions, Group>;
  using State = typename Decisions::State;

public:
  Basic_dart_tracer(const Mesh& mesh, const Lattice_points& points, const Grid_darts& darts,
                    const std::vector<char>& is_feature)
    : m_mesh(mesh), m_points(points), m_darts(darts), m_decisions(mesh, is_feature, m_step)
  {
    m_limits.is_stop = [&mesh](const std::size_t v)
                       { return is_lattice_point(mesh.uv(mesh.corner_at_vertex[v])); };
  }

  Basic_dart_tracer(const Basic_dart_tracer&) = delete; // its members refer to each other
  Basic_dart_tracer& operator=(const Basic_dart_tracer&) = delete;

  // The twin, `open_dart`, or `untraced_dart`: then the dart meets a vertex that it can't pass.
  Dart_index trace(const std::size_t p, const int k)
  {
    switch(m_points[p].place) {
    case Lattice_place::VERTEX: return trace_from_vertex(m_points[p], k);
    case Lattice_place::EDGE:   return trace_from_edge(m_points[p], k);
    case Lattice_place::FACE:   break;
    }
    return trace_through_face(m_points[p].corner, unit_step<Group>(m_points[p].uv, k), k);
  }

  // The twin of the dart that runs through a face of the chart, in this direction to `end`.
  Dart_index trace_through_face(const Corner_index corner, const Uv& end, const int direction)
  {
    State state;
    state.halfedge = corner;
    state.direction = direction;
    state.level = Group::value(int(constant_component<Group>(direction)), end);
    m_step = {};
    m_step.end = end;
    leave_face_point<Decisions>(m_mesh, state);
    if(m_decisions.ends_before(state))
      return twin_at_arrival();
    return walk([&](Walk& w) { return begin(w, state); });
  }

  // Traces the dart that runs along a halfedge.
  Dart_index trace_along_edge(const Corner_index h, const Uv& end, const int direction)
  {
    State state;
    state.is_at_vertex = true;
    state.halfedge = h;
    state.direction = direction;
    state.level = Group::value(int(constant_component<Group>(direction)), end);
    state.arrival_key = m_mesh.edge_key(h);
    m_step = {};
    m_step.end = end;
    if(m_decisions.ends_on_edge(h, h, direction))
      return twin_at_arrival();
    return walk([&](Walk& w) { return begin(w, state); });
  }

  bool ran_along_feature() const { return m_step.ran_along_feature; }

  // Where it was met.
  std::size_t obstacle() const { return m_obstacle; }

private:
  Dart_index trace_from_edge(const Lattice_point& p, const int k)
  {
    const int direction = turned<Group>(Edge_directions(m_mesh, p.corner).first, k);
    State state;
    state.halfedge = p.corner;
    state.direction = direction;
    state.level = Group::value(int(constant_component<Group>(direction)), p.uv);
    m_step = {};
    m_step.end = unit_step<Group>(p.uv, direction);
    bool enters = false;
    leave_edge_point(m_mesh, m_decisions, state, enters);
    if(state.is_at_vertex && m_decisions.ends_on_edge(p.corner, state.halfedge, direction))
      return twin_at_arrival();
    return walk([&](Walk& w) { return enters ? w.begin_at_border(state) : begin(w, state); });
  }

  Dart_index trace_from_vertex(const Lattice_point& p, const int k)
  {
    const Vertex_ray ray = rays_from_vertex(m_mesh, m_mesh.vertex(p.corner))[std::size_t(k)];
    m_step = {};
    m_step.end = unit_step<Group>(m_mesh.uv(ray.corner), ray.direction);
    if(m_decisions.ends_on_first_step(ray))
      return twin_at_arrival();
    return walk([&](Walk& w) {
      w.begin_at_vertex(ray);
      return Isocurve_status::CONTINUES;
    });
  }

  static Isocurve_status begin(Walk& walk, const State& state)
  {
    walk.begin(state);
    return Isocurve_status::CONTINUES;
  }

  template <typename Begin>
  Dart_index walk(const Begin& begin_walk)
  {
    Walk walk(m_mesh, m_limits, m_decisions);
    Isocurve_status status = begin_walk(walk);
    while(status == Isocurve_status::CONTINUES)
      status = walk.step();
    if(status == Isocurve_status::TARGET)
      return m_step.place == Lattice_place::VERTEX ? twin_at_vertex(walk.state())
                                                               : twin_at_arrival();
    m_obstacle = m_mesh.vertex(walk.state().halfedge);
    return status == Isocurve_status::BORDER || m_mesh.is_border[m_obstacle] ? open_dart
                                                                             : untraced_dart;
  }

  Dart_index twin_at_vertex(const State& state) const
  {
    const std::size_t v = m_mesh.vertex(state.halfedge);
    const Corner_index c = m_mesh.corner_at_vertex[v];
    return dart(face_of(c), m_mesh.uv(c),
                int(slot_of_arrival(m_mesh, state, rays_from_vertex(m_mesh, v))));
  }

  Dart_index twin_at_arrival() const
  {
    const Direction back = reversed<Group>(m_step.direction);
    if(m_step.place == Lattice_place::FACE)
      return dart(face_of(m_step.corner), m_step.end, back);
    const Corner_index h = m_mesh.edge_key(m_step.corner);
    if(h == m_step.corner)
      return dart(face_of(h), m_step.end,
                  turned<Group>(back, Group::inverse(Edge_directions(m_mesh, h).first)));
    const Corner_index from = m_step.corner, to = Mesh::prev(h); // corners at the same vertex
    const typename Group::Element rotation = m_mesh.rotation(from);
    return dart(face_of(h), carried<Group>(m_step.end, rotation, m_mesh.uv(from), m_mesh.uv(to)),
                turned<Group>(back, rotation));
  }

  // Dart k of the point of a face; `untraced_dart` if there is none.
  Dart_index dart(const std::size_t face, const Uv& uv, const int k) const
  {
    const std::size_t p = m_points.find(face, uv);
    return p < m_points.size() && std::size_t(k) < m_darts.degree(p)
             ? Dart_index(m_darts.first(p) + std::size_t(k)) : untraced_dart;
  }

  const Mesh& m_mesh;
  const Lattice_points& m_points;
  const Grid_darts& m_darts;
  Unit_step m_step;
  Decisions m_decisions;
  Walk_limits m_limits;
  std::size_t m_obstacle = 0;
};

// The failures of a dart.
struct Dart_failure
{
  bool is_obstacle = false;  // it meets a vertex that it can't pass
  bool is_ambiguous = false; // two darts have the same twin: an internal error
  std::size_t vertex = 0;

  explicit operator bool() const { return is_obstacle || is_ambiguous; }
};

// Gives darts whose twin is known to that twin. Twins are an involution if and only if this
// succeeds for all.
inline bool complete_twins(Grid_darts& darts)
{
  for(std::size_t d = 0; d < darts.size(); ++d) {
    if(darts.twins[d] < 0)
      continue;
    const std::size_t t = std::size_t(darts.twins[d]);
    if(darts.twins[t] == untraced_dart) {
      darts.twins[t] = Dart_index(d);
      if(darts.is_feature(d))
        darts.mark_feature(t);
    } else if(darts.twins[t] != Dart_index(d)) {
      return false;
    }
  }
  return true;
}

template <typename ConcurrencyTag, typename Group>
Dart_failure pair_darts(const Basic_chart_mesh<Group>& mesh, const Lattice_points& points,
                        const std::vector<char>& is_feature, Grid_darts& darts)
{
  const std::vector<Chunk> chunks = chunks_of(points.size());
  std::vector<Dart_failure> failures(chunks.size());
  for(const bool is_first_round : {true, false}) {
    for_each_chunk<ConcurrencyTag>(chunks, [&](const Chunk& chunk) {
      Basic_dart_tracer<Group> tracer(mesh, points, darts, is_feature);
      for(std::size_t p = chunk.begin; p < chunk.end; ++p)
        for(std::size_t k = 0; k < darts.degree(p); ++k) {
          const std::size_t d = darts.first(p) + k;
          if(is_first_round ? k >= std::size_t(Group::order / 2) : darts.twins[d] != untraced_dart)
            continue;
          darts.twins[d] = tracer.trace(p, int(k));
          if(tracer.ran_along_feature())
            darts.mark_feature(d);
          if(darts.twins[d] == untraced_dart && !failures[chunk.index])
            failures[chunk.index] = {true, false, tracer.obstacle()};
        }
    });
    for(const Dart_failure& failure : failures)
      if(failure)
        return failure;
    if(!complete_twins(darts))
      return {false, true, 0};
  }
  return {};
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_DART_TRACER_H
