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

#include <CGAL/Linear_snapping/internal/exact/orientation.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The angle of the corner `h`, in turns of the group.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
double corner_angle(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const Halfedge h,
                    const double scale)
{
  const auto scaled = [&](const Halfedge corner) -> Uv {
    const Uv u = get_uv(uv_map, corner);
    return Group::to_cartesian({u[0] * scale, u[1] * scale});
  };
  const Uv p = scaled(h), q = scaled(next(h, tmesh)), r = scaled(prev(h, tmesh));
  const Uv a{q[0] - p[0], q[1] - p[1]}, b{r[0] - p[0], r[1] - p[1]};
  const double angle = std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]);
  return angle / (2 * std::acos(-1.)) * Group::order;
}

// The product of the rotations of the cuts around a vertex, counterclockwise. It is the rotation of
// the index: crossing counterclockwise over an edge leads from the face of the halfedge that points
// to the vertex to the opposite one, and the angles of the sectors make up the rest of a full turn.
template <typename Group, typename Halfedge>
typename Group::Element holonomy(const Vertex_incidences& incidences,
                                 const std::vector<Mismatched_edge<Halfedge> >& edges,
                                 const Vertex_index v)
{
  auto product = Group::identity(); // of elements that commute, as those of the plane do
  for(const Incidence* i = incidences.begin(v); i != incidences.end(v); ++i) {
    const auto g = edges[std::size_t(i->edge)].rotation;
    product = Group::compose(i->points_to_vertex ? g : Group::inverse(g), product);
  }
  return product;
}

// The singular vertices and their indices, in the order of the cut edges.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, int> >
singular_vertices(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const double scale,
                  const std::vector<Mismatched_edge<Halfedge> >& edges)
{
  Vertex_numbers numbers(num_vertices(tmesh));
  numbers.mark_ends(edges);
  numbers.assign_numbers();
  const Vertex_incidences incidences(numbers.size(), numbers.ends(edges));
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, int>> result;
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    const int turns = Group::turns(holonomy<Group>(incidences, edges, Vertex_index(i)));
    if(turns == 0)
      continue;
    const Incidence& incidence = *incidences.begin(Vertex_index(i));
    const Halfedge any = edges[std::size_t(incidence.edge)].halfedge;
    const auto v = incidence.points_to_vertex ? target(any, tmesh) : source(any, tmesh);
    if(CGAL::is_border(v, tmesh))
      continue;
    double angles = 0;
    for(const Halfedge h : CGAL::halfedges_around_target(v, tmesh))
      angles += corner_angle<Group>(tmesh, uv_map, h, scale);
    const double estimate = Group::order - angles;
    const int full_turns = static_cast<int>(std::lround((estimate - turns) / Group::order));
    result.emplace_back(v, turns + Group::order * full_turns);
  }
  return result;
}

// Those without holonomy: of 720 degrees, and other multiples of 360, in positive faces. In the
// order of the mesh; all faces are looked at.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Result>
void add_full_turns(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const double scale,
                    Result& result)
{
  for(const auto v : vertices(tmesh)) {
    double angles = 0;
    bool is_unfolded = halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge();
    if(is_unfolded)
      for(const auto h : CGAL::halfedges_around_target(v, tmesh)) {
        is_unfolded = !is_border(h, tmesh) &&
                      orientation({get_uv(uv_map, prev(h, tmesh)), get_uv(uv_map, h),
                                   get_uv(uv_map, next(h, tmesh))}) == CGAL::POSITIVE;
        if(!is_unfolded)
          break;
        angles += corner_angle<Group>(tmesh, uv_map, h, scale);
      }
    const double full_turns = std::round(angles / Group::order);
    if(is_unfolded && full_turns > 1 && std::abs(angles - full_turns * Group::order) < 0.5)
      result.emplace_back(v, Group::order * (1 - static_cast<int>(full_turns)));
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SINGULAR_VERTICES_H
