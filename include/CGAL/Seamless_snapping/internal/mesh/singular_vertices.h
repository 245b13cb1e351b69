// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SINGULAR_VERTICES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SINGULAR_VERTICES_H

#include <CGAL/license/Seamless_snapping.h>

// Singular vertices from the product of the rotations around them, the holonomy. Angle sums alone
// miscount wherever a fold touches a vertex; they only choose among indices that differ by full
// turns, and find those without holonomy where all faces are positive.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The angle of the corner `h`, in turns by 360 / n degrees.
template <typename Group, typename Surface>
double corner_angle(const Surface& surface, const typename Surface::Halfedge h, const double scale,
                    const int n)
{
  const auto scaled = [&](const auto corner) -> Uv {
    const Uv u = surface.uv(corner);
    return Group::to_cartesian({u[0] * scale, u[1] * scale});
  };
  const Uv p = scaled(h), q = scaled(surface.next(h)), r = scaled(surface.prev(h));
  const Uv a{q[0] - p[0], q[1] - p[1]}, b{r[0] - p[0], r[1] - p[1]};
  const double angle = std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]);
  return angle / (2 * std::acos(-1.)) * n;
}

// The angle of the corners from `first` on, clockwise, to the border or all around, in turns by
// 360 / n degrees; 0 at folds, where angles don't add up.
template <typename Group, typename Surface>
double unfolded_angle(const Surface& surface, const typename Surface::Halfedge first,
                      const double scale, const int n)
{
  double angle = 0;
  if(first == surface.null_halfedge() || surface.is_border(first))
    return 0;
  auto h = first;
  do {
    if(orientation(uv_triangle(surface, h)) != CGAL::POSITIVE)
      return 0;
    angle += corner_angle<Group>(surface, h, scale, n);
    h = surface.opposite(surface.next(h));
  } while(h != first && !surface.is_border(h));
  return angle;
}

// The singular vertices, each by a halfedge towards it, and their indices, in the order of the cut
// edges.
template <typename Group, typename Surface, typename Halfedge>
std::vector<std::pair<Halfedge, int> >
singular_vertices(const Surface& surface, const double scale, const int n,
                  const std::vector<Mismatched_edge<Halfedge> >& edges)
{
  const Vertex_numbers numbers(surface.number_of_vertices(), edges);
  const Vertex_incidences incidences = vertex_incidences(numbers.size(), numbers.ends(edges));
  std::vector<std::pair<Halfedge, int> > result;
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    const int turns = Group::turns(holonomy<Group>(incidences, edges, Vertex_index(i)), n);
    if(turns == 0)
      continue;
    const Halfedge first = halfedge_towards(surface, edges, incidences[i].front());
    if(has_border_at_target(surface, first))
      continue;
    double angles = 0;
    for_each_around_target(surface, first, [&](const Halfedge h) {
      angles += corner_angle<Group>(surface, h, scale, n);
    });
    const double estimate = n - angles;
    const int full_turns = static_cast<int>(std::lround((estimate - turns) / n));
    result.emplace_back(first, turns + n * full_turns);
  }
  return result;
}

// The singular vertices without holonomy: cones of 720 degrees, and other multiples of 360, in
// positive faces. In the order of the mesh; all faces are visited.
template <typename Group, typename Surface, typename Halfedge>
void add_full_turns(const Surface& surface, const double scale, const int n,
                    std::vector<std::pair<Halfedge, int> >& result)
{
  for(const Halfedge first : surface.one_per_vertex()) {
    const double angles = unfolded_angle<Group>(surface, first, scale, n);
    const double full_turns = std::round(angles / n);
    if(full_turns > 1 && std::abs(angles - full_turns * n) < 0.5 &&
       !has_border_at_target(surface, first))
      result.emplace_back(first, n * (1 - static_cast<int>(full_turns)));
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SINGULAR_VERTICES_H
