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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh, its uv map, and its transitions to plain arrays.

#include <CGAL/Seamless_snapping/internal/exact/orientation.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/tracing/Chart_mesh.h>
#include <CGAL/Seamless_snapping/internal/tracing/axis_directions.h>


#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The quadrant that contains the vector from a to b, which is not null, each with the axis at its
// clockwise end.
inline Direction quadrant(const Uv& a, const Uv& b)
{
  const int x = compare(b[0], a[0]), y = compare(b[1], a[1]);
  if(x > 0 && y >= 0)
    return Quarter_turns::element(0);
  if(x <= 0 && y > 0)
    return Quarter_turns::element(1);
  return Quarter_turns::element((x < 0 && y <= 0) ? 2 : 3);
}

// By how many axes a vector passes that turns from the first to the second edge of a corner;
// negative where the face is flipped. These add up to the angle around a vertex, in quarter turns,
// since the seams map axes to axes.
inline int axes_passed(const Uv& p, const Uv& q, const Uv& r)
{
  const Direction passed = turned(quadrant(p, r), Quarter_turns::inverse(quadrant(p, q)));
  for(const int axes : {0, 1, -1})
    if(passed == Quarter_turns::element(axes))
      return axes;
  return orientation({{p, q, r}}) == CGAL::NEGATIVE ? -2 : 2;
}

// The same angle where the seams are not exact; the sum is then near to an integer only.
inline double quarter_turns_between(const Uv& p, const Uv& q, const Uv& r)
{
  const Uv a{q[0] - p[0], q[1] - p[1]}, b{r[0] - p[0], r[1] - p[1]};
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / std::acos(0.);
}

// Vertices whose angle is not 360 degrees. Unlike rotations alone, this also finds those of 720
// degrees. An edge without length has no angle with others: at its ends, the rotations decide.
inline void mark_singular_vertices(Chart_mesh& mesh)
{
  const std::size_t n = mesh.corner_at_vertex.size();
  std::vector<double> angles(n, 0); // in quarter turns
  std::vector<Quarter_turns::Element> rotations(n, Quarter_turns::identity());
  std::vector<char> has_angle(n, true);
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const std::size_t v = mesh.vertex(h);
    const Uv &p = mesh.uv(h), &q = mesh.uv(Chart_mesh::next(h)), &r = mesh.uv(Chart_mesh::prev(h));
    rotations[v] = Quarter_turns::compose(mesh.rotation(h), rotations[v]);
    if(p == q || p == r)
      has_angle[v] = false;
    else
      angles[v] += mesh.is_exact ? axes_passed(p, q, r) : quarter_turns_between(p, q, r);
  }
  mesh.is_singular.assign(n, false);
  for(std::size_t v = 0; v < n; ++v) {
    const bool is_regular = has_angle[v] ? std::lround(angles[v]) == Quarter_turns::order
                                         : rotations[v] == Quarter_turns::identity();
    mesh.is_singular[v] = !mesh.is_border[v] && !is_regular;
  }
}

// Sets the transition across a halfedge whose rotation is known.
inline void add_transition(Chart_mesh& mesh, const Corner_index h,
                           const Quarter_turns::Element rotation)
{
  const Corner_index p = Chart_mesh::prev(h);
  const Corner_index g = mesh.opposite(h);
  if(rotation == Quarter_turns::identity() && mesh.uv(h) == mesh.uv(Chart_mesh::prev(g)) &&
     mesh.uv(p) == mesh.uv(g))
    return;
  const Uv turned_source = Quarter_turns::apply(rotation, mesh.uv(p));
  mesh.corners[std::size_t(h)].transition = std::int32_t(mesh.transitions.size());
  mesh.transitions.push_back({rotation, {{Exact_difference(mesh.uv(g)[0], turned_source[0]),
                                          Exact_difference(mesh.uv(g)[1], turned_source[1])}}});
}

// `seams` are the transitions that were read off `uv_map`. Vertices with several fans of faces do
// no harm here: the border keeps their fans apart.
template <typename TriangleMesh, typename HalfedgeUVMap, typename SeamTransitions>
Chart_mesh build_chart_mesh(const TriangleMesh& tmesh,
                            const Flat_numbering<TriangleMesh>& numbering,
                            const HalfedgeUVMap& uv_map, const SeamTransitions& seams)
{
  static_assert(Quarter_turns::order % SeamTransitions::order == 0,
                "isocurves are traced for rotational symmetries of order 1, 2, and 4");
  constexpr int quarters = Quarter_turns::order / SeamTransitions::order; // in each turn
  Chart_mesh mesh;
  mesh.extent = seams.extent();
  mesh.violation = seams.violation();
  mesh.is_exact = seams.is_exact();
  read_flat_mesh(tmesh, numbering, mesh);
  const auto& halfedges = numbering.halfedges_of_corners();
  for(std::size_t i = 0; i < halfedges.size(); ++i)
    mesh.corners[i].uv = get_uv(uv_map, halfedges[i]);
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!mesh.is_border_edge(h))
      add_transition(mesh, h,
                     Quarter_turns::element(quarters * seams.rotation(halfedges[std::size_t(h)])));
  mark_singular_vertices(mesh);
  return mesh;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H
