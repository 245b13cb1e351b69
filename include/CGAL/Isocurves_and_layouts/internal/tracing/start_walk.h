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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_START_WALK_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_START_WALK_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The first step of a walk: from a point on the surface and a direction to the first edge or vertex
// that the isocurve meets.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Isocurve_walk.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// The ray from a vertex that is the fewest corners away when the direction is carried around it,
// both ways, starting with the corner. Every direction occurs within a full turn, which around a
// cone takes several rounds.
template <typename Group>
bool find_ray(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
              const Direction direction, Vertex_ray& ray)
{
  bool found = false;
  const auto look_at = [&](const Corner_index c, const int d) {
    if(c != no_index && !found)
      for_ray_at_corner(mesh, c, d, [&](const Vertex_ray& r) { ray = r; found = true; });
  };
  Corner_index left = corner, right = corner;
  Direction left_direction = direction, right_direction = direction;
  look_at(corner, direction);
  for(int rounds = 0; !found && rounds < Group::order && (left != no_index || right != no_index);) {
    if(left != no_index) {
      left_direction = turned<Group>(left_direction, mesh.rotation(left));
      left = mesh.counterclockwise(left);
      look_at(left, left_direction);
      rounds += (left == corner) ? 1 : 0;
    }
    if(right != no_index) {
      right_direction = turned<Group>(right_direction, mesh.rotation(mesh.next(right)));
      right = mesh.clockwise(right);
      look_at(right, right_direction);
    }
  }
  return found;
}

// The sides of the three corners of a face: 1 at the left of the curve, -1 at the right.
template <typename Decisions, typename Group>
int side_of_corner(const Basic_chart_mesh<Group>& mesh, const typename Decisions::State& state,
                   const Corner_index h)
{
  return left_sign<Group>(state.direction) *
         Decisions::side_of(state.level,
                            mesh.component(h, constant_component<Group>(state.direction)));
}

// `state.halfedge` lies on the curve, in full: to the end that has the face at the left.
template <typename Decisions, typename Group>
bool go_along_edge(const Basic_chart_mesh<Group>& mesh, typename Decisions::State& state)
{
  const Corner_index h = state.halfedge;
  const int apex_side = side_of_corner<Decisions>(mesh, state, mesh.next(h));
  state.is_at_vertex = true;
  state.arrival_key = mesh.edge_key(h);
  state.halfedge = apex_side > 0 ? h : mesh.prev(h);
  return apex_side != 0;
}

// From a point inside of the edge, whose level is known in the chart of its face. Afterwards the
// state is at the edge that the curve crosses, at a vertex at its end, or, if `enters` is set, in
// the face of the border edge. Returns `false` if the coordinate is constant on the face.
template <typename Decisions, typename Group>
bool leave_edge_point(const Basic_chart_mesh<Group>& mesh, Decisions& decisions,
                      typename Decisions::State& state, bool& enters)
{
  const Corner_index h = state.halfedge;
  const int source_side = side_of_corner<Decisions>(mesh, state, mesh.prev(h));
  enters = false;
  if(source_side == 0)
    return go_along_edge<Decisions>(mesh, state);
  if(source_side < 0)
    return true;
  if(mesh.opposite(h) == no_index) {
    enters = true;
    return true;
  }
  // the same crossing, seen from the other face
  if(mesh.corner(h).transition != no_index)
    decisions.cross(mesh.transitions[std::size_t(mesh.corner(h).transition)], state);
  state.halfedge = mesh.opposite(h);
  return true;
}

// From a point of the face of `state.halfedge`. Returns `false` if the coordinate is constant on
// the face.
template <typename Decisions, typename Group>
bool leave_face_point(const Basic_chart_mesh<Group>& mesh, typename Decisions::State& state)
{
  const Corner_index first = state.halfedge;
  for(Corner_index h = first, i = 0; i < 3; ++i, h = mesh.next(h)) {
    const int source = side_of_corner<Decisions>(mesh, state, mesh.prev(h));
    const int target = side_of_corner<Decisions>(mesh, state, h);
    const int apex = side_of_corner<Decisions>(mesh, state, mesh.next(h));
    state.halfedge = h;
    if(source < 0 && target > 0)
      return true;
    if(source == 0 && target == 0)
      return go_along_edge<Decisions>(mesh, state);
    if(target == 0 && apex > 0 && source < 0) {
      state.is_at_vertex = true;
      state.arrival_key = no_index;
      return true;
    }
  }
  CGAL_precondition_msg(false, "the start point must lie in its face");
  return false;
}

// The start of a curve, in the chart of the face of `halfedge`.
struct Chart_start
{
  Isocurve_place place;
  Corner_index halfedge;
  Exact_rational parameter; // on an edge
  Uv uv;                    // in a face
};

// A walk at its start. Invariant: where the status is CONTINUES, the walk has begun.
template <typename Decisions>
struct Walk_beginning
{
  typename Decisions::State start; // the point, as a state
  Exact_rational running{0};       // its running component, unless it is a vertex
  bool is_first_state = false;     // the walk's state is the start itself, not the next point
  Isocurve_status status = Isocurve_status::CONTINUES;
};

template <typename Group>
Exact_rational component_on_edge(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                                 const Exact_rational& t, const std::size_t c)
{
  const Exact_rational a = exact_value(mesh.component(mesh.prev(h), c)),
                       b = exact_value(mesh.component(h, c));
  return Exact_rational(a + t * (b - a));
}

template <typename Number>
Number rounded_level(const Exact_rational& level)
{
  if constexpr(std::is_same_v<Number, double>)
    return CGAL::to_double(level);
  else
    return Number(level);
}

template <typename Group, typename Decisions>
void begin_at_vertex(const Basic_chart_mesh<Group>& mesh, Isocurve_walk<Decisions, Group>& walk,
                     Walk_beginning<Decisions>& beginning)
{
  auto& state = beginning.start;
  Vertex_ray ray{state.halfedge, state.direction, Ray_kind::THROUGH_FACE};
  const bool leaves = find_ray(mesh, state.halfedge, state.direction, ray);
  state.is_at_vertex = true;
  state.halfedge = ray.corner;
  state.direction = ray.direction;
  state.level = make_level<typename Decisions::Level>(
    mesh.component(ray.corner, constant_component<Group>(ray.direction)));
  if(leaves)
    walk.begin_at_vertex(ray);
  else
    beginning.status = mesh.is_border[mesh.vertex(ray.corner)] ? Isocurve_status::BORDER
                                                               : Isocurve_status::CONSTANT_ON_FACE;
}

template <typename Group, typename Decisions>
void begin_on_edge(const Basic_chart_mesh<Group>& mesh, const Exact_rational& t,
                   Decisions& decisions, Isocurve_walk<Decisions, Group>& walk,
                   Walk_beginning<Decisions>& beginning)
{
  auto& point = beginning.start;
  point.level = rounded_level<typename Decisions::Level>(
    component_on_edge(mesh, point.halfedge, t, constant_component<Group>(point.direction)));
  beginning.running =
    component_on_edge(mesh, point.halfedge, t, running_component<Group>(point.direction));
  auto state = point;
  bool enters = false;
  if(!leave_edge_point(mesh, decisions, state, enters)) {
    beginning.status = Isocurve_status::CONSTANT_ON_FACE;
  } else if(enters) {
    beginning.status = walk.begin_at_border(state);
  } else if(state.is_at_vertex) {
    walk.begin(state, CGAL::to_double(beginning.running));
  } else {
    beginning.is_first_state = true;
    walk.begin(state);
  }
}

template <typename Group, typename Decisions>
Walk_beginning<Decisions> begin_walk(const Basic_chart_mesh<Group>& mesh, const Chart_start& start,
                                     const Direction direction, Decisions& decisions,
                                     Isocurve_walk<Decisions, Group>& walk)
{
  CGAL_precondition_msg(start.halfedge != no_index,
                        "the halfedge that an isocurve starts at must have a face");
  Walk_beginning<Decisions> beginning;
  beginning.start.halfedge = start.halfedge;
  beginning.start.direction = direction;
  switch(start.place) {
  case Isocurve_place::VERTEX:
    begin_at_vertex(mesh, walk, beginning);
    return beginning;
  case Isocurve_place::EDGE:
    CGAL_precondition_msg(start.parameter > 0 && start.parameter < 1,
                          "the point that an isocurve starts at must lie inside of its edge");
    begin_on_edge(mesh, start.parameter, decisions, walk, beginning);
    return beginning;
  case Isocurve_place::FACE:
    break;
  }
  const auto running = component<Group>(start.uv, running_component<Group>(direction));
  beginning.start.level = make_level<typename Decisions::Level>(
    component<Group>(start.uv, constant_component<Group>(direction)));
  beginning.running = exact_value(running);
  auto state = beginning.start;
  if(leave_face_point<Decisions>(mesh, state))
    walk.begin(state, nearest_double(running));
  else
    beginning.status = Isocurve_status::CONSTANT_ON_FACE;
  return beginning;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_START_WALK_H
