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

#ifndef CGAL_SEAMLESS_SNAPPING_ISOCURVE_CONSTRAINTS_H
#define CGAL_SEAMLESS_SNAPPING_ISOCURVE_CONSTRAINTS_H

#include <CGAL/license/Seamless_snapping.h>

// Constraints from traced isocurves: that one meets the vertex that it meets nearly, or closes
// where it nearly does.

#include <CGAL/Seamless_snapping/Isocurve_point.h>
#include <CGAL/Seamless_snapping/surface_constraints.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

// Appends the edges between two corners of a vertex: counterclockwise, or clockwise where the
// border is in the way.
template <typename TriangleMesh, typename Halfedge>
void turn_around_vertex(const TriangleMesh& tmesh, const Halfedge from, const Halfedge to,
                        std::vector<Halfedge>& path)
{
  const std::size_t n = path.size();
  Halfedge h = from;
  while(h != to && !is_border(opposite(h, tmesh), tmesh)) {
    path.push_back(h);
    h = prev(opposite(h, tmesh), tmesh);
  }
  if(h == to)
    return;
  path.resize(n);
  for(h = from; h != to; h = opposite(path.back(), tmesh))
    path.push_back(next(h, tmesh));
}

// The corner of the face of `h` at a vertex.
template <typename TriangleMesh, typename Halfedge, typename Vertex>
Halfedge corner_at(const TriangleMesh& tmesh, Halfedge h, const Vertex v)
{
  while(target(h, tmesh) != v)
    h = next(h, tmesh);
  return h;
}

// The corner that a curve ends at or, if it has missed a vertex, is about to pass by.
template <typename TriangleMesh>
auto corner_at_end(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  const Isocurve_point<TriangleMesh>& end = curve.points.back();
  if(end.place() == Isocurve_place::VERTEX)
    return end.halfedge();
  return next(opposite(end.halfedge(), tmesh), tmesh);
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingConstraints

returns the edges that a curve crosses, as the path of a `Connection_constraint` or
`Cycle_constraint`: `h` leads from `face(h)` to `face(opposite(h))`. The path begins in the face of
the first point of the curve and ends in that of its last point. It leads around the vertices that
the curve passes.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`

\par Complexity
Linear in the number of points of the curve and of faces around the vertices that it passes.
*/
template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
isocurve_face_path(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> path;
  const auto go_on = [&](const Isocurve_point<TriangleMesh>& from, const auto to) {
    const auto h = from.halfedge();
    if(face(h, tmesh) == face(to, tmesh))
      return;
    if(from.place() == Isocurve_place::VERTEX)
      internal::turn_around_vertex(tmesh, h, internal::corner_at(tmesh, to, target(h, tmesh)),
                                   path);
    else
      path.push_back(h);
  };
  for(std::size_t i = 1; i < curve.points.size(); ++i)
    go_on(curve.points[i - 1], curve.points[i].halfedge());
  return path;
}

/*!
\ingroup PkgSeamlessSnappingConstraints

returns the constraint that the isocurve from the vertex where a curve starts meets the vertex where
it ends; or, if the status of the curve is `Isocurve_status::MISSED_TARGET`, the vertex that it has
missed. To follow an isocurve on an approximately seamless parametrization, see the parameter
`decide_exactly` of `trace_isocurve()`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`
\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and ends at a vertex or has missed one

\sa `cycle_along_isocurve()`
*/
template <typename TriangleMesh>
Connection_constraint<TriangleMesh>
connection_along_isocurve(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  CGAL_precondition(!curve.points.empty());
  const Isocurve_point<TriangleMesh>& start = curve.points.front();
  CGAL_precondition(start.place() == Isocurve_place::VERTEX);
  CGAL_precondition(curve.status == Isocurve_status::MISSED_TARGET ||
                    curve.points.back().place() == Isocurve_place::VERTEX);
  Connection_constraint<TriangleMesh> result;
  result.a = start.halfedge();
  result.b = internal::corner_at_end(tmesh, curve);
  result.component = int(internal::constant_component(start.direction()));
  result.path = isocurve_face_path(tmesh, curve);
  if(curve.points.back().place() == Isocurve_place::EDGE)
    result.path.push_back(curve.points.back().halfedge());
  return result;
}

/*!
\ingroup PkgSeamlessSnappingConstraints

returns the constraint that the isocurve from the vertex where a curve starts closes there. The
status of the curve is `Isocurve_status::CLOSED` or, if it passes by this vertex,
`Isocurve_status::SPIRALS`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`
\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and has one of these statuses

\sa `connection_along_isocurve()`
*/
template <typename TriangleMesh>
Cycle_constraint<TriangleMesh>
cycle_along_isocurve(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  CGAL_precondition(!curve.points.empty());
  const Isocurve_point<TriangleMesh>& start = curve.points.front();
  CGAL_precondition(start.place() == Isocurve_place::VERTEX);
  CGAL_precondition(curve.status == Isocurve_status::CLOSED ||
                    curve.status == Isocurve_status::SPIRALS);
  Cycle_constraint<TriangleMesh> result;
  result.corner = start.halfedge();
  result.component = int(internal::constant_component(start.direction()));
  result.path = isocurve_face_path(tmesh, curve);
  if(curve.points.back().place() == Isocurve_place::EDGE)
    result.path.push_back(curve.points.back().halfedge());
  internal::turn_around_vertex(tmesh, internal::corner_at_end(tmesh, curve), result.corner,
                               result.path);
  return result;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_ISOCURVE_CONSTRAINTS_H
