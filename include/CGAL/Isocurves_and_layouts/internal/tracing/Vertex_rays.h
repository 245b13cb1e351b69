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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_VERTEX_RAYS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_VERTEX_RAYS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The isocurves that leave a vertex, by signs alone. Whether a point of the star lies left or right
// of an isocurve through its center is a comparison of two components in one chart; a ray leaves
// where this changes from right to left, counterclockwise.
//
// In a star without folds these are the rays in all directions of the group. With folds, the
// isocurves are still the level sets of a piecewise linear function; the direction of a ray then
// tells its sides, not where it points to: in a flipped triangle, that is the opposite.
//
// And where a walk along an isocurve is, and at which of the rays it has arrived.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/axis_directions.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

enum class Ray_kind : char
{
  THROUGH_FACE,     // to the edge opposite to the corner
  ALONG_FIRST_EDGE, // along next(corner)
  ALONG_LAST_EDGE   // along corner, backwards: the last edge of a star that ends at the border
};

struct Vertex_ray
{
  Corner_index corner;
  Direction direction; // in the chart of the corner's face
  Ray_kind kind;

  friend bool operator==(const Vertex_ray& a, const Vertex_ray& b)
  { return a.corner == b.corner && a.direction == b.direction && a.kind == b.kind; }
};

// 1 if the corner `other` of the same face lies at the left of the isocurve in this direction from
// `corner`; -1 at the right; 0 on it.
template <typename Group>
int side_of_ray(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
                const Direction direction, const Corner_index other)
{
  const std::size_t c = constant_component<Group>(direction);
  return left_sign<Group>(direction) *
         compare(mesh.component(other, c), mesh.component(corner, c));
}

// The side of the first link vertex of the corner before this one, clockwise; -1 beyond the border.
template <typename Group>
int side_before(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
                const Direction direction)
{
  const Corner_index before = mesh.clockwise(corner);
  if(before == no_index)
    return -1;
  return side_of_ray(mesh, before, turned<Group>(direction, mesh.rotation(mesh.next(corner))),
                     mesh.next(before));
}

// Calls f(ray) for the ray of this direction that starts along the first edge of the corner, inside
// it, or along its last edge if that is on the border, if there is one.
template <typename Group, typename Function>
void for_ray_at_corner(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
                       const Direction direction, const Function& f)
{
  const int first = side_of_ray(mesh, corner, direction, mesh.next(corner));
  const int second = side_of_ray(mesh, corner, direction, mesh.prev(corner));
  if(first < 0 && second > 0)
    f(Vertex_ray{corner, direction, Ray_kind::THROUGH_FACE});
  else if(first == 0 && second > 0 && side_before(mesh, corner, direction) < 0)
    f(Vertex_ray{corner, direction, Ray_kind::ALONG_FIRST_EDGE});
  else if(second == 0 && first < 0 && mesh.opposite(corner) == no_index)
    f(Vertex_ray{corner, direction, Ray_kind::ALONG_LAST_EDGE});
}

// The first corner of the star counterclockwise, if it starts at the border; else `corner`.
// `direction` is carried along.
template <typename Group>
Corner_index first_corner(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
                          Direction& direction)
{
  Corner_index c = corner;
  for(Corner_index before = mesh.clockwise(c); before != no_index; before = mesh.clockwise(c)) {
    direction = turned<Group>(direction, mesh.rotation(mesh.next(c)));
    c = before;
    if(c == corner)
      break;
  }
  return c;
}

// The rays of a vertex; most vertices have so few that they need no memory of their own.
using Vertex_rays = boost::container::small_vector<Vertex_ray, 8>;

// Appends the rays that start at a corner, counterclockwise: directions follow each other, the
// first after the last. In a flipped face, whose sides are exchanged, the order is descending.
template <typename Group>
void add_rays_at_corner(const Basic_chart_mesh<Group>& mesh, const Corner_index corner,
                        Vertex_rays& rays)
{
  const std::size_t begin = rays.size();
  for(int turns = 0; turns < Group::order; ++turns)
    for_ray_at_corner(mesh, corner, Group::element(turns),
                      [&](const Vertex_ray& r) { rays.push_back(r); });
  if(rays.size() < begin + 2)
    return;
  const auto first = rays.begin() + std::ptrdiff_t(begin);
  const auto gap = std::adjacent_find(first, rays.end(), [](const auto& a, const auto& b)
                     { return b.direction != turned<Group>(a.direction, Group::element(1)); });
  if(gap != rays.end())
    std::rotate(first, gap + 1, rays.end());
  if(orientation({{mesh.uv(corner), mesh.uv(mesh.next(corner)), mesh.uv(mesh.prev(corner))}}) ==
     CGAL::NEGATIVE)
    std::reverse(first, rays.end());
}

// All rays from a vertex, counterclockwise, each in the chart of its corner.
template <typename Group>
Vertex_rays rays_from_vertex(const Basic_chart_mesh<Group>& mesh, const std::size_t vertex)
{
  Vertex_rays rays;
  for_each_corner(mesh, vertex,
                  [&](const Corner_index corner) { add_rays_at_corner(mesh, corner, rays); });
  return rays;
}

// The rays along both directions of the isocurve that runs in `direction` in the chart of `corner`:
// one turn around a regular vertex, or over the star of a border vertex. `is_forward` tells which
// of the two directions each ray has.
struct Isocurve_rays
{
  std::vector<Vertex_ray> rays;
  std::vector<char> is_forward;

  template <typename Group>
  void collect(const Basic_chart_mesh<Group>& mesh, const Corner_index corner, Direction direction)
  {
    rays.clear();
    is_forward.clear();
    const Corner_index start = first_corner(mesh, corner, direction);
    Corner_index c = start;
    do {
      for(const bool forward : {true, false})
        for_ray_at_corner(mesh, c, forward ? direction : reversed<Group>(direction),
                          [&](const Vertex_ray& ray) {
                            rays.push_back(ray);
                            is_forward.push_back(forward);
                          });
      direction = turned<Group>(direction, mesh.rotation(c));
      c = mesh.counterclockwise(c);
    } while(c != no_index && c != start);
  }
};

// The state of a walk along an isocurve.
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

// Which of some rays around the vertex where a walk is leads back to where it came from; their
// number, if none does.
template <typename Group, typename Level, typename Rays>
std::size_t slot_of_arrival(const Basic_chart_mesh<Group>& mesh, const Walk_state<Level>& state,
                            const Rays& rays)
{
  return std::size_t(std::find_if(rays.begin(), rays.end(), [&](const Vertex_ray& ray)
                                  { return state.arrived_by(mesh, ray); }) - rays.begin());
}

// Searches all rays at the end of a segment in the same way.
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
  return slot_of_arrival(mesh, state, rays_from_vertex(mesh, mesh.vertex(state.halfedge)));
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

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_TRACING_VERTEX_RAYS_H
