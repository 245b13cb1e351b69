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

#ifndef CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// The surface function: makes an approximately seamless parametrization exactly seamless. And from
// and to the lattice coordinates that parametrizations of symmetry 3 and 6 have.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/snapping/snap_surface.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

// `snap_to_seamless()` with a plain chain, which may have more than it reads.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Parameters>
Snapping_report snap_with_plain_parameters(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                           const Parameters& np)
{
  const Protect_exact_arithmetic protect;
  if(const auto refusal = inexact_arithmetic())
    return refused<Snapping_report>(*refusal);
  check_parameters<Parameters>();
  const Progress progress(np);
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return snap_surface<Symmetry_group<Parameters> >(tmesh, uv_map, np);
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingRef

moves an approximately seamless parametrization to a nearby one that is exactly seamless.

After success, for each interior edge with ends \f$ a, b \f$,
\f[ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f]
holds in exact arithmetic. Here \f$ \mathbf{u} \f$ and \f$ \mathbf{u}' \f$ are the coordinates in
the charts of the two faces, and \f$ R \f$ is the rotation by a multiple of 90 degrees that fits the
input best. If the transition is the identity, both sides have the same coordinates, bit for bit.
All coordinates remain ordinary floating point numbers.

The mesh may have any number of components of any genus, with or without border. Charts may be
arranged in any way. The function computes cuts, rotations, and singular vertices from the
coordinates, unless you pass them (see `seam_transitions()`).

The result approximates the least-squares optimum: the exactly seamless parametrization that
minimizes the sum of squared changes of the sectors at cut vertices (see \ref SSnappingBackground).
A parametrization that is exactly seamless already does not change. Otherwise, corners without
constraints change only to prevent a flipped face. (0 and -0 at one vertex may become equal.) The
function verifies the result exactly before it writes it; on failure, the map is as before.

The function keeps positive faces positive if it can, and decides this exactly. If a face would
be flipped, the function moves one of its vertices, with all its sectors, into the kernel of its
1-ring. If this is not possible, it searches for the closest exact solution that keeps the face.
`Snapping_report` counts such faces, and lists the faces that the function could not save.

The method follows Mandad and Campen \cgalCite{cgal:mc-ecstsp-19}.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh. Its points in space may coincide.
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Values of border halfedges are neither read nor written. Corners at one vertex
       may share a place in memory if no cut runs between them; all other corners need their own.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that are to lie on isocurves, such as feature edges. Along each, the
                          function makes the coordinate constant that changes less in the input.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether all border edges are to lie on isocurves}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_cut_map}
    \cgalParamDescription{the cut edges, if you know them. The two sides of all other edges get
                          equal coordinates.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{computed from the uv map}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_rotation_map}
    \cgalParamDescription{the rotation of the transition across each halfedge, if you know it: the
                          number of counterclockwise turns by \f$ 360 / N \f$ degrees, which are
                          quarter turns by default. Numbers count modulo \f$ N \f$; opposite
                          halfedges have inverse numbers.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and an
                   integer type as value type}
    \cgalParamDefault{computed from the uv map}
  \cgalParamNEnd
  \cgalParamNBegin{rotational_symmetry}
    \cgalParamDescription{the angles by which charts are turned across cuts: multiples of
                          \f$ 360 / N \f$ degrees. For \f$ N = 3, 6 \f$ the coordinates are
                          lattice coordinates, see `Rotational_symmetry`.}
    \cgalParamType{`Rotational_symmetry<N>`}
    \cgalParamDefault{`Rotational_symmetry<4>()`}
    \cgalParamExtra{If the map fits another symmetry, the status is `NOT_SEAMLESS`, and the message
                    names that symmetry.}
  \cgalParamNEnd
  \cgalParamNBegin{connection_constraints}
    \cgalParamDescription{pairs of corners that are to be connected by an isocurve}
    \cgalParamType{a range of `Connection_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
    \cgalParamExtra{`intercepted_connections()` finds connections with a vertex in their way.}
  \cgalParamNEnd
  \cgalParamNBegin{cycle_constraints}
    \cgalParamDescription{isocurves that are to close}
    \cgalParamType{a range of `Cycle_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{connection_tolerance}
    \cgalParamDescription{the largest distance by which the isocurve of a connection or a cycle may
                          miss its end before snapping, relative to the extent of the coordinates. A
                          larger distance is an error, because a wrong path would distort the map.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
  \cgalParamNBegin{corner_constraints}
    \cgalParamDescription{linear equations on the coordinates of corners}
    \cgalParamType{a range of `Corner_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the largest violation of a transition or alignment in the input that
                          counts as noise, relative to the extent of the coordinates. A larger
                          violation is an error.}
    \cgalParamType{`double`}
    \cgalParamDefault{1e-4}
  \cgalParamNEnd
  \cgalParamNBegin{repair_flips}
    \cgalParamDescription{whether to make faces positive that are flipped or degenerate in the
                          input, if this is possible nearby and flips no other face. This may also
                          change a parametrization that is seamless already.}
    \cgalParamType{Boolean, or `Flip_repair`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{With `Flip_repair::UNTANGLE`, the function untangles the remaining faces under
                    all constraints. Vertices may move any distance, which
                    `Snapping_report::largest_change` tells. Untangling needs rotations by multiples
                    of 90 degrees, takes seconds, and is not guaranteed to succeed. If faces stay
                    flipped, the status is `FLIPS_REMAIN`.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_untangling_iterations}
    \cgalParamDescription{bounds the work of repairs: the largest number of Newton iterations over
                          all faces. Quadratic programs count as iterations, too. With 0, only
                          single vertices move. A call with this parameter does not compile, unless
                          `repair_flips` or `integer_grid` is passed, too.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{400}
    \cgalParamExtra{`Flip_repair` says how many iterations were needed in tests.}
  \cgalParamNEnd
  \cgalParamNBegin{integer_grid}
    \cgalParamDescription{whether to make an integer-grid map: translations, cones, and the constant
                          coordinates of aligned edges become integers that agree with each other;
                          with \f$ N = 3, 6 \f$, points and lines of the triangular lattice. If the
                          nearest integers are farther away than noise, the function also tries
                          integers one after another, with all vertices following, and other places
                          of the charts (but not with corner constraints, or a rounding tolerance of
                          0). It returns the result with the fewest flipped faces, and among such
                          results the one that changes edges least.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive factor: the function first multiplies all coordinates by it}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_tolerance}
    \cgalParamDescription{the largest distance of a translation, a cone, or an aligned edge from its
                          integer. A larger distance is an error, because the map is then probably
                          not meant to be an integer-grid map. For a map of any scale, pass a large
                          value, such as 10 units of the grid. A call with this parameter does not
                          compile, unless `integer_grid` is passed, too.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
    \cgalParamExtra{Large roundings may flip faces: see `Snapping_report::lost_faces`. The end
                    of a slit moves along its line as far as necessary.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index
                          between `0` and `num_vertices(tmesh) - 1`; the indices appear in messages
                          and determine the order of processing}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points in space to the vertices of `tmesh`. The
                          function only counts border edges that coincide in space, for a note in
                          the message.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`; without this property, the function
                      counts no edges}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress as lines of text, in the calling thread. If it
                          throws, the exception propagates, and the map is as before.}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and measurements. The report converts to `true` if and only if the
        parametrization is exactly seamless and aligned. If `repair_flips` was passed and faces stay
        flipped, the status is `FLIPS_REMAIN`, which converts to `true`. On failure,
        `Snapping_report::status` is
        - `NOT_TRIANGULAR`: a face has more or less than three corners;
        - `NOT_FINITE`: a coordinate is NaN, infinite, or beyond 1e300;
        - `NOT_SEAMLESS`: no rotation fits the two sides of an edge up to the tolerance;
        - `NOT_ALIGNED`: an edge that is to be aligned follows no isocurve up to the tolerance;
        - `NOT_CONNECTED`: a connection or cycle constraint misses by more than its tolerance;
        - `NOT_INTEGER`: a rounding to an integer-grid map is larger than the tolerance; or repairs
          of faces make cones that can't be moved to points of the grid; or, with `grid_scale`, so
          much collapses that the result covers no cell of the grid;
        - `INVALID_ROTATIONS`: the given rotations of opposite halfedges are not inverse to each
          other, or an edge that is given as no cut has a rotation;
        - `INVALID_ARGUMENT`: the mesh has no face, a path is not connected or crosses the border,
          a corner has no face, a tolerance is negative, the scale is not positive, or the given
          indices of vertices are not unique or out of range;
        - `INCONSISTENT`: the constraints contradict each other; the message names them;
        - `NOT_REPRESENTABLE`: the number type holds no nearby solution. This can happen if a
          corner constraint has a right-hand side other than 0, if coordinates would exceed the
          largest number, or, with `integer_grid`, if a coordinate is beyond \f$ 2^{46} \f$;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`;
        - `INTERNAL_ERROR`: the result failed its verification, or `uv_map` does not keep the values
          that the function writes (for example, because it stores `float`s). The function has then
          restored the old coordinates.
        .
        The message names the place and the remedy.

\par Complexity
A few passes over the edges and faces, and the elimination of a sparse system. The size of the
system depends only on the numbers of nodes and branches of the cuts;
`snap_to_linear_constraints()` has the complexity of the elimination.

\sa `is_seamless()`
\sa `seam_transitions()`
\sa `snap_to_linear_constraints()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report snap_to_seamless(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::snap_with_plain_parameters(
    tmesh, uv_map, internal::strip(np, internal::surface_parameters));
}

namespace internal {

constexpr double lattice_height = 0.86602540378443864676; // sqrt(3) / 2

// Replaces the coordinates of all corners.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Conversion>
void convert_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                         const Conversion& conversion)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
    using Number = std::decay_t<decltype(std::declval<const Point&>().x())>;
    for(const auto f : faces(tmesh))
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
        const Point p = get(uv_map, h);
        const std::pair<double, double> q = conversion(double(p.x()), double(p.y()));
        put(uv_map, h, Point(Number(q.first), Number(q.second)));
      }
  }
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingSymmetry

converts a parametrization from Cartesian coordinates \f$ (x, y) \f$ to the lattice coordinates of
\f$ N = 3, 6 \f$, which are \f$ (x - y / \sqrt 3, 2 y / \sqrt 3) \f$, rounded. Faces that are not
nearly degenerate keep their orientation. Corners with equal coordinates get equal coordinates.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`,
        in which each corner has its own place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner; changed in place

\par Complexity
Linear in the number of faces.

\sa `convert_to_cartesian_coordinates()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
void convert_to_lattice_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map)
{
  internal::convert_coordinates(tmesh, uv_map, [](const double x, const double y) {
    const double b = y / internal::lattice_height;
    return std::make_pair(x - b / 2, b);
  });
}

/*!
\ingroup PkgSeamlessSnappingSymmetry

converts a parametrization from lattice coordinates \f$ (a, b) \f$ to the Cartesian coordinates
\f$ (a + b / 2, b \sqrt 3 / 2) \f$, rounded. The result is not exactly seamless in general. Convert
for pictures and measurements only.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`,
        in which each corner has its own place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner; changed in place

\par Complexity
Linear in the number of faces.

\sa `convert_to_lattice_coordinates()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
void convert_to_cartesian_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map)
{
  internal::convert_coordinates(tmesh, uv_map, [](const double a, const double b) {
    return std::make_pair(a + b / 2, b * internal::lattice_height);
  });
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H
