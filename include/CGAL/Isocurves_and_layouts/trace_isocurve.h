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

// Single isocurves, or all that leave singular vertices; and the places of their points.

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Isocurves_and_layouts {

namespace internal {

// The mesh is read in the same way whatever else is asked for: so less is compiled.
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
edges that lie on it. All decisions are exact comparisons. A curve that is traced back from its end
takes the same way. The curve ends
- at the target, at a singular vertex, or at the border;
- if it closes;
- if it reaches `maximum_number` or `maximum_length`;
- at a degenerate face on which its coordinate is constant (`Isocurve_status::CONSTANT_ON_FACE`).

If the map is not exactly seamless, nothing is traced, and the status is
`Isocurve_status::NOT_EXACT`. Rules for special cases:

- At a regular vertex, a curve goes straight on.
- At the border, a curve goes on if a border edge or a reentrant corner allows one straight
  continuation. If several continuations are straight, as along both sides of a slit, it ends with
  `Isocurve_status::SINGULAR_VERTEX`.
- An edge without length in the domain is part of each isocurve through its two vertices. A curve
  that meets one of them may leave from the other. If a coordinate is constant on a face of such an
  edge, isocurves of this coordinate end there with `Isocurve_status::CONSTANT_ON_FACE`.
- In a flipped face, a curve runs backward, so it may pass a vertex several times. More than two
  rays of an isocurve can then leave a vertex. A curve goes on along the opposite ray, which has as
  many rays on its left as on its right. So no two curves join, and the way back is the same.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam PointOutputIterator a model of `OutputIterator` for `Isocurve_point<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Border halfedges are not read.
\param start the start of the curve; `Isocurve_tracer::outgoing()` lists the curves that leave a
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
    \cgalParamDefault{no vertex is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of crossed edges and passed vertices after which the curve
                          ends}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{three times the number of faces}
    \cgalParamExtra{Isocurves that meet nothing can be very long.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_length}
    \cgalParamDescription{the length in the domain after which the curve ends, at the next edge or
                          vertex that it meets. It is measured from the start, in floating point.}
    \cgalParamType{`double`}
    \cgalParamDefault{unbounded; the length is not measured then}
  \cgalParamNEnd
  \cgalParamNBegin{decide_exactly}
    \cgalParamDescription{whether comparisons are exact. If `false`, they are in floating point, and
                          the parametrization need not be exactly seamless. If a decision fails, the
                          curve ends, and its status says why. Use this for demonstrations, and for
                          the paths of connections.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{rotational_symmetry}
    \cgalParamDescription{the rotations that transitions may have. With N = 3 and 6, coordinates are
                          lattice coordinates, and there are six directions. For an
                          `Isocurve_tracer`, pass it to the constructor.}
    \cgalParamType{`Rotational_symmetry<N>`}
    \cgalParamDefault{`Rotational_symmetry<4>()`}
  \cgalParamNEnd
  \cgalParamNBegin{near_distance}
    \cgalParamDescription{in floating point only: the distance, relative to the extent of the
                          coordinates, below which a curve counts as having missed a vertex}
    \cgalParamType{`double`}
    \cgalParamDefault{100 times the largest violation of a transition divided by the extent, and at
                      least 1e-12}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the curve, without points: these are written to `output`. Its `status` tells how it ends;
        test it with `is_failure()`. If the map is not exactly seamless (`is_seamless()`) and
        `decide_exactly` is not `false`, or if it is not seamless up to the default tolerance of
        `seam_transitions()`, the status is `Isocurve_status::NOT_EXACT`: snap the map first, with
        `snap_to_seamless()`.

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\pre `start` is as `Isocurve_start` asks for

\par Complexity
One pass over the mesh, and constant time for each edge crossed. To trace many curves, use
`Isocurve_tracer`, which makes the pass once. It also takes `edge_is_cut_map` and
`halfedge_rotation_map`.

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
       `CGAL::Parallel_tag`, which does not compile unless TBB is linked. With several threads, all
       of them read the property map `vertex_is_constrained_map`.
\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap as for `trace_isocurve()`
\tparam CurveOutputIterator a model of `OutputIterator` for `Isocurve<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner
\param output receives the curves in the order of the vertices of the mesh, counterclockwise around
       each. The order does not depend on the number of threads.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" of
       `trace_isocurve()`

\return the past-the-end output iterator. If `trace_isocurve()` would return the status
        `Isocurve_status::NOT_EXACT`, a single curve with this status and without points is written.
        Before you count curves, call `is_failure()` with the status of each.

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

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

// u, v, or u + v.
inline Exact_rational exact_component(const Uv& u, const std::size_t c)
{
  return c < 2 ? Exact_rational(u[c]) : Exact_rational(Exact_rational(u[0]) + Exact_rational(u[1]));
}

inline double rounded_component(const Uv& u, const std::size_t c)
{
  return c < 2 ? u[c] : u[0] + u[1];
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the position of a point on an edge.

The position is exact if the curve crosses the edge. If the curve starts on the edge and runs along
it, the position comes from the rounded coordinates of the start.

\tparam TriangleMesh the type of the mesh
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner

\return 0 at the source of `point.halfedge()`, 1 at its target

\pre `point.place()` is `Isocurve_place::EDGE`, and the ends of the edge differ in the domain

\par Complexity
Constant.
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
Exact_rational isocurve_parameter(const Isocurve_point<TriangleMesh>& point,
                                  const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  const internal::Uv a = internal::get_uv(uv_map, prev(point.halfedge(), tmesh)),
                     b = internal::get_uv(uv_map, point.halfedge());
  const auto parameter = [](const Exact_rational& x, const Exact_rational& from,
                            const Exact_rational& to)
  { return Exact_rational((x - from) / (to - from)); };
  const std::size_t c = internal::constant_component(point.direction());
  const Exact_rational from = internal::exact_component(a, c), to = internal::exact_component(b, c);
  if(from != to)
    return parameter(point.constant_coordinate(), from, to);
  const std::size_t k = internal::other_coordinate(point.direction());
  return parameter(Exact_rational(point.running_coordinate()), Exact_rational(a[k]),
                   Exact_rational(b[k]));
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the coordinates of a point in the chart of `face(point.halfedge())`.

\tparam TriangleMesh the type of the mesh
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner

\return the coordinates, rounded to `double`

\par Complexity
Constant.
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
std::array<double, 2> isocurve_uv(const Isocurve_point<TriangleMesh>& point,
                                  const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  const internal::Protect_exact_arithmetic protect;
  const std::size_t c = internal::constant_component(point.direction()),
                    k = internal::other_coordinate(point.direction());
  const internal::Uv b = internal::get_uv(uv_map, point.halfedge());
  if(point.place() == Isocurve_place::VERTEX)
    return b;
  const double level = point.approximate_constant_coordinate();
  double running = point.running_coordinate();
  if(point.place() == Isocurve_place::EDGE) {
    const internal::Uv a = internal::get_uv(uv_map, prev(point.halfedge(), tmesh));
    const double from = internal::rounded_component(a, c), to = internal::rounded_component(b, c);
    if(from != to) // else the curve starts here, and runs along the edge
      running = a[k] + (level - from) / (to - from) * (b[k] - a[k]);
  }
  internal::Uv result;
  result[k] = running;
  result[1 - k] = c < 2 ? level
                        : point.level().minus(internal::Exact_level(running)).approximation();
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the place of a point in space.

\tparam TriangleMesh the type of the mesh
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional
        point as value type

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner
\param vertex_point_map the points of the vertices

\return the point, rounded to the number type of the points

\par Complexity
Constant.
*/
template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexPointMap>
typename boost::property_traits<VertexPointMap>::value_type
isocurve_point_3(const Isocurve_point<TriangleMesh>& point, const TriangleMesh& tmesh,
                 const HalfedgeUVMap& uv_map, const VertexPointMap& vertex_point_map)
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point_3>::Kernel::FT;
  const internal::Protect_exact_arithmetic protect;
  const auto h = point.halfedge();
  const Point_3 q = get(vertex_point_map, target(h, tmesh));
  if(point.place() == Isocurve_place::VERTEX)
    return q;
  const Point_3 p = get(vertex_point_map, source(h, tmesh));
  const Point_3 r = get(vertex_point_map, target(next(h, tmesh), tmesh));
  const internal::Uv a = internal::get_uv(uv_map, prev(h, tmesh)), b = internal::get_uv(uv_map, h),
                     c = internal::get_uv(uv_map, next(h, tmesh)),
                     x = isocurve_uv(point, tmesh, uv_map);
  // barycentric coordinates of b and c
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  double s = ((x[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (x[1] - a[1])) / area;
  double t = ((b[0] - a[0]) * (x[1] - a[1]) - (x[0] - a[0]) * (b[1] - a[1])) / area;
  if(point.place() == Isocurve_place::EDGE) {
    std::size_t k = 1 - internal::other_coordinate(point.direction());
    k = (a[k] == b[k]) ? 1 - k : k;
    s = (a[k] == b[k]) ? 0.5 : (x[k] - a[k]) / (b[k] - a[k]);
    t = 0;
  }
  return Point_3(p + FT(s) * (q - p) + FT(t) * (r - p));
}

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_TRACE_ISOCURVE_H
