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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_START_WALK_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_START_WALK_H

#include <CGAL/license/Seamless_snapping.h>

// The first step of a walk: from a point on the surface and a direction to the first edge or vertex
// that the isocurve meets.

#include <CGAL/Seamless_snapping/internal/tracing/Isocurve_walk.h>
#include <CGAL/Seamless_snapping/internal/tracing/Vertex_rays.h>

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The ray from a vertex that is the fewest corners away when the direction is carried around it,
// both ways, starting with the corner. Every direction occurs within a full turn, which around a
// cone takes several rounds.
inline bool find_ray(const Chart_mesh& mesh, const Corner_index corner, const Direction direction,
                     Vertex_ray& ray)
{
  bool found = false;
  const auto look_at = [&](const Corner_index c, const int d) {
    if(c != no_index && !found)
      for_ray_at_corner(mesh, c, d, [&](const Vertex_ray& r) { ray = r; found = true; });
  };
  Corner_index left = corner, right = corner;
  Direction left_direction = direction, right_direction = direction;
  look_at(corner, direction);
  for(int rounds = 0; !found && rounds < Quarter_turns::order &&
                      (left != no_index || right != no_index);) {
    if(left != no_index) {
      left_direction = turned(left_direction, mesh.rotation(left));
      left = mesh.counterclockwise(left);
      look_at(left, left_direction);
      rounds += (left == corner) ? 1 : 0;
    }
    if(right != no_index) {
      right_direction = turned(right_direction, mesh.rotation(Chart_mesh::next(right)));
      right = mesh.clockwise(right);
      look_at(right, right_direction);
    }
  }
  return found;
}

// The sides of the three corners of a face: 1 at the left of the curve, -1 at the right.
template <typename Decisions>
int side_of_corner(const Chart_mesh& mesh, const typename Decisions::State& state,
                   const Corner_index h)
{
  return left_sign(state.direction) *
         Decisions::side_of(state.level, mesh.uv(h)[constant_component(state.direction)]);
}

// `state.halfedge` lies on the curve, in full: to the end that has the face at the left.
template <typename Decisions>
bool go_along_edge(const Chart_mesh& mesh, typename Decisions::State& state)
{
  const Corner_index h = state.halfedge;
  const int apex_side = side_of_corner<Decisions>(mesh, state, Chart_mesh::next(h));
  state.is_at_vertex = true;
  state.arrival_key = mesh.edge_key(h);
  state.halfedge = apex_side > 0 ? h : Chart_mesh::prev(h);
  return apex_side != 0;
}

// From a point inside of the edge, whose level is known in the chart of its face. Afterwards the
// state is that of the edge being crossed, of a vertex at its end, or, if `enters` is set, of the
// face of a border edge being entered. Returns `false` if the coordinate is constant on the face.
template <typename Decisions>
bool leave_edge_point(const Chart_mesh& mesh, Decisions& decisions,
                      typename Decisions::State& state, bool& enters)
{
  const Corner_index h = state.halfedge;
  const int source_side = side_of_corner<Decisions>(mesh, state, Chart_mesh::prev(h));
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
template <typename Decisions>
bool leave_face_point(const Chart_mesh& mesh, typename Decisions::State& state)
{
  const Corner_index first = state.halfedge;
  for(Corner_index h = first, i = 0; i < 3; ++i, h = Chart_mesh::next(h)) {
    const int source = side_of_corner<Decisions>(mesh, state, Chart_mesh::prev(h));
    const int target = side_of_corner<Decisions>(mesh, state, h);
    const int apex = side_of_corner<Decisions>(mesh, state, Chart_mesh::next(h));
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_START_WALK_H
