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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_WALK_STATE_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_WALK_STATE_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Where a walk along an isocurve is.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

template <typename Level>
struct Walk_state
{
  bool is_at_vertex = false;           // else on an edge
  Corner_index halfedge = no_index;    // points to the vertex; or lies on the edge being crossed
  Direction direction = 0;             // in the chart of the halfedge's face
  Level level{};                       // of the constant component, in the same chart
  Corner_index arrival_key = no_index; // at a vertex: the edge that the curve came along, if it did

  // Whether the ray points back to where the curve came from. A loop has two ends at the vertex.
  template <typename Group>
  bool arrived_by(const Basic_chart_mesh<Group>& mesh, const Vertex_ray& ray) const
  {
    if(arrival_key == no_index)
      return ray.kind == Ray_kind::THROUGH_FACE && ray.corner == halfedge &&
             ray.direction == reversed<Group>(direction);
    const bool came_along_halfedge = mesh.edge_key(halfedge) == arrival_key;
    const Corner_index back =
      came_along_halfedge ? mesh.opposite(halfedge) : mesh.next(halfedge);
    return (ray.kind == Ray_kind::ALONG_FIRST_EDGE && mesh.next(ray.corner) == back) ||
           (ray.kind == Ray_kind::ALONG_LAST_EDGE && came_along_halfedge && ray.corner == halfedge);
  }
};

// Which of the rays around the vertex that a segment ends at leads back along it; their number, if
// none does.
template <typename Group, typename Segment>
std::size_t slot_of_arrival(const Basic_chart_mesh<Group>& mesh, const Segment& segment,
                            const Direction direction)
{
  Walk_state<double> state;
  state.is_at_vertex = true;
  state.halfedge = segment.exit.halfedge;
  state.direction = direction;
  if(segment.along != no_index)
    state.arrival_key = mesh.edge_key(segment.along);
  const auto rays = rays_from_vertex(mesh, mesh.vertex(state.halfedge));
  return std::size_t(std::find_if(rays.begin(), rays.end(), [&](const Vertex_ray& ray)
                                  { return state.arrived_by(mesh, ray); }) - rays.begin());
}

// A component as a level: rounded where that is a `double`.
template <typename Level, typename Component>
Level make_level(const Component& component)
{
  if constexpr(std::is_same_v<Level, double>)
    return nearest_double(component);
  else
    return Level(component);
}

struct Walk_limits
{
  std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)(); // of crossings
  double maximum_length = std::numeric_limits<double>::infinity();        // in the domain
  std::size_t target = (std::numeric_limits<std::size_t>::max)();         // a vertex
  std::function<bool(std::size_t)> is_stop;                               // further ones, if given

  bool is_target(const std::size_t v) const { return v == target || (is_stop && is_stop(v)); }
};

inline const Walk_limits& no_limits()
{
  static const Walk_limits limits;
  return limits;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_WALK_STATE_H
