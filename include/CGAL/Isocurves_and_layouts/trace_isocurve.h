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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_TRACE_ISOCURVE_H
#define CGAL_ISOCURVES_AND_LAYOUTS_TRACE_ISOCURVE_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Isocurves traced by one call, and constraints made of them.

#include <CGAL/Isocurves_and_layouts/Isocurve.h>
#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

// The tolerance means something else where the mesh is read.
template <typename NamedParameters>
auto symmetry_only(const NamedParameters&)
{
  constexpr int order = order_of_symmetry<Plain_parameters<NamedParameters> >;
  return parameters::rotational_symmetry(Rotational_symmetry<order>());
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

traces an isocurve of an exactly seamless parametrization, from a point on the surface in one of the
directions \f$ +u, -u, +v, -v \f$ of its chart; or, in lattice coordinates, of its six directions
(see `Isocurve_direction`).

The curve crosses cuts by their exact transitions, passes exactly through vertices, and runs along
edges where these lie on it. It ends at the target, at a singular vertex, at the border, where it
closes, or when a bound is reached. All decisions are comparisons that are exact, so that on an
exactly seamless map there is no other end, with one exception: degenerate faces on which a
coordinate is constant (`Isocurve_status::CONSTANT_ON_FACE`). A curve that is traced backwards from
its end takes the same way. On a map that is not exactly seamless, nothing is traced: the status is
`Isocurve_status::NOT_EXACT`.

- At a regular vertex a curve goes straight on.
- At the border it goes on where a border edge or a reentrant corner allows it to go straight on. At
  a border vertex with an angle of 360 degrees or more, several continuations may be straight, as
  along both sides of a slit: there it ends with `Isocurve_status::SINGULAR_VERTEX`. Where one
  continuation is straight, it goes on also there.
- An edge without length in the domain, whose vertices have the same coordinates, is part of each
  isocurve through them: a curve that meets one of them may run along the edge and leave from the
  other. Its faces have no area; where a coordinate is constant on one of them, the isocurves along
  which it is constant end at the edge, with `Isocurve_status::CONSTANT_ON_FACE`.
- Where faces are flipped, an isocurve is traced as the level set of a piecewise linear function: it
  goes back in flipped faces, and may pass a vertex several times. In a folded star more than two
  rays of an isocurve may leave the vertex: it goes on along the opposite one, as many rays to its
  left as to its right, so that no two curves join and the way back is the same.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam PointOutputIterator a model of `OutputIterator` for `Isocurve_point<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: that of halfedge `h` is the corner of `face(h)` at
       `target(h)`. Values of border halfedges are not read.
\param start where the curve starts; `Isocurve_tracer::outgoing()` lists the curves that leave a
       vertex
\param direction the direction in which it starts, in the chart of `face(start.halfedge)`
\param output receives the points of the curve: the start, the edges crossed and vertices met, the
       end
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_vertex}
    \cgalParamDescription{a vertex at which the curve ends}
    \cgalParamType{`boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{further vertices at which curves end}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no vertex is}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of crossed edges and passed vertices after which the curve
                          ends}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{three times the number of faces}
    \cgalParamExtra{isocurves that meet nothing can be very long}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_length}
    \cgalParamDescription{the length in the domain after which the curve ends, at the next edge or
                          vertex that it meets. It is measured from the start, in floating point.}
    \cgalParamType{`double`}
    \cgalParamDefault{unbounded; the length is not measured then}
  \cgalParamNEnd
  \cgalParamNBegin{decide_exactly}
    \cgalParamDescription{`false` has all decisions made in floating point, as code would do that
                          knows nothing of exact maps; then the parametrization need not be exactly
                          seamless. Where this goes wrong, the curve ends, and its status says why.
                          Meant for demonstration.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{rotational_symmetry}
    \cgalParamDescription{the rotations that transitions may have. With N = 3 and 6, coordinates are
                          lattice coordinates, and there are six directions. Not read by the
                          functions of `Isocurve_tracer`, but for its constructor.}
    \cgalParamType{`Rotational_symmetry<N>`}
    \cgalParamDefault{`Rotational_symmetry<4>()`}
  \cgalParamNEnd
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{in floating point only: the distance, relative to the extent of the
                          coordinates, below which a curve is taken to have missed what it passes
                          by. It does not tell which violations are accepted, as the `tolerance` of
                          other functions does.}
    \cgalParamType{`double`}
    \cgalParamDefault{100 times the largest violation of a transition divided by the extent, and at
                      least 1e-12}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return how the curve ends. Its member `points` is empty: the points are written to `output`. If the
        map is not exactly seamless (`is_seamless()`) and `decide_exactly` is not `false`, or if it
        is not seamless up to the default tolerance of `seam_transitions()`, the status is
        `Isocurve_status::NOT_EXACT`: snap the map first, with `snap_to_seamless()`.

\pre `start` is as `Isocurve_start` asks for

\par Complexity
One pass over the mesh, and constant time for each edge crossed. To trace many curves, use
`Isocurve_tracer`, which makes the pass once; it also lets cuts and rotations be given.

\sa `trace_all_separatrices()`
\sa `snap_to_seamless()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap, typename PointOutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Isocurve<TriangleMesh> trace_isocurve(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                      const Isocurve_start<TriangleMesh>& start,
                                      const Isocurve_direction direction,
                                      PointOutputIterator output,
                                      const NamedParameters& np =
                                        CGAL::parameters::default_values())
{
  const Isocurve_tracer tracer(tmesh, uv_map, internal::symmetry_only(np));
  Isocurve<TriangleMesh> curve = tracer.trace(start, direction, np);
  for(const auto& point : curve.points)
    *output++ = point;
  curve.points.clear();
  return curve;
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

traces all isocurves that leave singular vertices: the separatrices, from which motorcycle graphs
and base complexes are built. A vertex is singular here if its angle in the domain is not 360
degrees; see `Isocurve_tracer::is_singular()`. Each curve ends at a singular vertex, at the border,
at a vertex that was given, at a bound, or at degenerate faces on which its coordinate is constant;
if it is traced in floating point, possibly by a failure (see `Isocurve_status`).

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_if_available_tag`, or
       `CGAL::Parallel_tag`, which does not compile unless TBB is linked
\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap as for `trace_isocurve()`
\tparam CurveOutputIterator a model of `OutputIterator` for `Isocurve<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner
\param output receives the curves in the order of the vertices of the mesh, counterclockwise around
       each. The order does not depend on the number of threads. All threads read the property
       map `vertex_is_constrained_map`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
       `trace_isocurve()`

\return the past-the-end output iterator. Where `trace_isocurve()` would return the status
        `Isocurve_status::NOT_EXACT`, a single curve with this status is written.


\par Complexity
One pass over the mesh, and constant time for each edge crossed.

\sa `trace_isocurve()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename CurveOutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
CurveOutputIterator trace_all_separatrices(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                           CurveOutputIterator output,
                                           const NamedParameters& np =
                                             CGAL::parameters::default_values())
{
  const Isocurve_tracer tracer(tmesh, uv_map, internal::symmetry_only(np));
  for(auto& curve : tracer.template separatrices<ConcurrencyTag>(np))
    *output++ = std::move(curve);
  return output;
}

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
\ingroup PkgIsocurvesAndLayoutsConstraints

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
\ingroup PkgIsocurvesAndLayoutsConstraints

returns the constraint that the isocurve from the vertex where a curve starts meets the vertex where
it ends; or, if the status of the curve is `Isocurve_status::MISSED_TARGET`, the vertex that it has
missed. To follow an isocurve on an approximately seamless parametrization, see the parameter
`decide_exactly` of `trace_isocurve()`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`
\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and ends at a vertex or has missed one

\par Complexity
Linear in the number of edges crossed, and of faces around the vertices met.

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
\ingroup PkgIsocurvesAndLayoutsConstraints

returns the constraint that the isocurve from the vertex where a curve starts closes there. The
status of the curve is `Isocurve_status::CLOSED` or, if it passes by this vertex,
`Isocurve_status::SPIRALS`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`
\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and has one of these statuses

\par Complexity
Linear in the number of edges crossed, and of faces around the vertices met.

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

#endif // CGAL_ISOCURVES_AND_LAYOUTS_TRACE_ISOCURVE_H
