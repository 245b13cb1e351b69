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

/*!
\ingroup PkgSeamlessSnappingRef

moves an approximately seamless parametrization to a nearby one that is exactly seamless.

A parametrization that was computed by a numerical solver satisfies the conditions at its seams up
to a small violation only. This function removes it: for each interior edge with ends \f$ a, b \f$,
\f[ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f]
then holds in exact arithmetic, where \f$ \mathbf{u} \f$ and \f$ \mathbf{u}' \f$ are the coordinates
in the charts of the two faces, and \f$ R \f$ is the rotation by a multiple of 90 degrees that fits
the input; or of another angle, which `rotational_symmetry` tells. Along edges with the identity as
transition, both sides have the same coordinates to the bit. If asked to, the function also makes
one coordinate constant along feature or border edges. All coordinates remain ordinary floating
point numbers.

The result approximates the least-squares optimum, that is the exactly seamless parametrization that
minimizes the sum of squared changes of the sectors at cut vertices. Corners that no constraint
concerns keep their bits, unless the orientation of a face requires otherwise (and but for signs of
zeros, where those of several corners in one place differ). A parametrization that is
exactly seamless already is not touched at all. The result is verified exactly before the function
reports success; on failure nothing has changed.

Faces of positive orientation keep it where an exactly seamless parametrization near by allows this.
The orientations are decided exactly. If the closest solution turns a face over or makes it
degenerate, one of its vertices, with all its sectors, is moved into the kernel of its 1-ring; if
this is not possible, the closest exact solution that keeps the face is searched for.
`Snapping_report` counts such faces, and lists those that could not be saved.

Charts may be arranged in any way; cuts, rotations, and singular vertices are read off the
coordinates (see `seam_transitions()`) unless they are given. The mesh may have any number of
components of any genus, with or without border.

The method is that of Mandad and Campen \cgalCite{cgal:mc-ecstsp-19}.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh. Points in space mean nothing to a map: they may coincide, and are read only
       for a note on border edges that do.
\param uv_map the coordinates of each corner: that of halfedge `h` is the corner of `face(h)` at
       `target(h)`. Values of border halfedges are neither read nor written. Corners at one vertex
       may share a place in memory where no cut runs between them; all others need their own.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that are to lie on isocurves, such as features: along each, the
                          coordinate that changes less in the input is made constant}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether all border edges are to lie on isocurves}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_cut_map}
    \cgalParamDescription{the cut edges, where they are known. The corners along all other edges are
                          merged.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{read off the uv map}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_rotation_map}
    \cgalParamDescription{the number of counterclockwise turns by \f$ 360 / N \f$ degrees, quarter
                          turns by default, of the transition across each halfedge, where it is
                          known; modulo \f$ N \f$, and inverse for opposite halfedges}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and an
                   integer type as value type}
    \cgalParamDefault{read off the uv map}
  \cgalParamNEnd
  \cgalParamNBegin{rotational_symmetry}
    \cgalParamDescription{the angles by which charts are turned across cuts: multiples of
                          \f$ 360 / N \f$ degrees. For \f$ N = 3, 6 \f$ the coordinates are
                          lattice coordinates, see `Rotational_symmetry`.}
    \cgalParamType{`Rotational_symmetry<N>`}
    \cgalParamDefault{`Rotational_symmetry<4>()`}
    \cgalParamExtra{A map that fits another symmetry is refused as `NOT_SEAMLESS`, and the message
                    tells which.}
  \cgalParamNEnd
  \cgalParamNBegin{connection_constraints}
    \cgalParamDescription{pairs of corners that are to be connected by an isocurve}
    \cgalParamType{a range of `Connection_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
    \cgalParamExtra{`intercepted_connections()` tells which of these isocurves have something in
                    their way.}
  \cgalParamNEnd
  \cgalParamNBegin{cycle_constraints}
    \cgalParamDescription{isocurves that are to close}
    \cgalParamType{a range of `Cycle_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{connection_tolerance}
    \cgalParamDescription{the largest distance by which the isocurve of a connection or a cycle may
                          miss its end before snapping, relative to the extent of the coordinates. A
                          larger one is an error, since a path that is not meant would distort the
                          map; raise it where the distance is meant.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
  \cgalParamNBegin{corner_constraints}
    \cgalParamDescription{linear equations on the coordinates of corners}
    \cgalParamType{a range of `Corner_constraint<TriangleMesh>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the largest violation of a transition or alignment that is taken for
                          inaccuracy, relative to the extent of the coordinates. A larger one is an
                          error.}
    \cgalParamType{`double`}
    \cgalParamDefault{1e-4}
  \cgalParamNEnd
  \cgalParamNBegin{repair_flips}
    \cgalParamDescription{whether faces that have negative or no orientation in the input are to
                          become positive too, where this is possible near by and costs no other
                          face its orientation. Then a parametrization that is seamless already may
                          be changed as well.}
    \cgalParamType{Boolean, or `Flip_repair`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{With `Flip_repair::UNTANGLE`, what remains is untangled under all constraints:
                    there is no bound on how far vertices move, `Snapping_report::largest_change`
                    tells how far they did. It needs rotations by multiples of 90 degrees, takes
                    seconds rather than milliseconds, and is not guaranteed to succeed. The
                    status is `FLIPS_REMAIN` where faces are left that are not positive.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_untangling_iterations}
    \cgalParamDescription{the largest number of iterations over all faces that the search for
                          repairs takes: of Newton's method, where it untangles; quadratic programs
                          take 250 multiplications each for an iteration and a face, as for 1000
                          faces at least. With 0, only single vertices move. Without
                          `repair_flips` and `integer_grid`, it is an error of compilation.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{400; of what has been repaired, the most that was needed is told at
                      `Flip_repair`}
  \cgalParamNEnd
  \cgalParamNBegin{integer_grid}
    \cgalParamDescription{whether to make an integer-grid map: translations of cuts, cones, and the
                          levels of aligned edges become integers, the nearest ones up to what they
                          have to agree on. Where they are farther away than noise would be, the
                          change is spread over the surface, and there are up to three further
                          choices: charts are moved to where integers may be nearer, as where they
                          lie means nothing, but not with corner constraints or a rounding tolerance
                          of 0; and, in either place, integers are chosen one after another, a
                          quarter of those that are left at a time, the nearest first, with all
                          vertices following. What turns over the fewest faces is taken, and of that
                          what changes edges least: not always the nearest integers. See
                          `extract_quad_mesh()`. With \f$ N = 3, 6 \f$, these are points and lines
                          of the triangular lattice.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive number that the coordinates are multiplied by first}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_tolerance}
    \cgalParamDescription{the largest distance of a translation, a cone, or a level from the integer
                          that it becomes. A larger one is an error, since the map is not meant to
                          be an integer-grid map then; raise it, to 10 for instance, where it is.
                          Without `integer_grid`, it is an error of compilation.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
    \cgalParamExtra{Large roundings may turn faces: `Snapping_report::lost_faces` tells. The end of
                    a slit moves along its line as far as it has to.}
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
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the lines for a `visitor` are written to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; not read with a `visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is called with a line of text after each step, and about each second of
                          long ones, in the calling thread. What it throws ends the work, and passes
                          on to the caller; the map is untouched then.}
    \cgalParamType{a callable, or `std::ref()` of one, that takes a `const std::string&`}
    \cgalParamDefault{one that writes to `std::cerr` with `verbose`, else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and figures; converts to `true` if and only if the parametrization is exactly
        seamless and aligned, also where faces are left flipped, which the status `FLIPS_REMAIN`
        tells if `repair_flips` asked for them. On failure, `Snapping_report::status` is
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
        - `INCONSISTENT`: the constraints contradict each other; the message names which;
        - `NOT_REPRESENTABLE`: the number type holds no solution near by: of corner constraints
          whose right-hand sides are not zero; or because coordinates would exceed the largest
          number, as can happen with `float`s close to it; or, with `integer_grid`, because a
          coordinate is beyond \f$ 2^{46} \f$;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`;
        - `INTERNAL_ERROR`: the result failed its verification; or a `uv_map` does not keep what is
          written to it, as one that stores `float`s in place of `double`s. The old coordinates have
          been written back then; whether such a map returns them is not looked at.
        .
        The message names the place and the remedy.

\par Complexity
Linear in the number of faces, with a constant of a few passes over the edges; in addition sparse
elimination of a system whose size is the number of nodes and branches of the cuts. Orientations
take a pass over the faces at cut vertices; only faces that are thinner than their vertices move are
looked at exactly.

\sa `is_seamless()`
\sa `seam_transitions()`
\sa `snap_to_linear_constraints()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report snap_to_seamless(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  if(const auto refusal = internal::inexact_arithmetic())
    return internal::refused<Snapping_report>(*refusal);
  using Parameters = std::decay_t<decltype(internal::strip(np))>;
  using Group = internal::Symmetry_group<Parameters>;
  internal::check_parameters<Parameters>();
  const internal::Progress progress(internal::strip(np));
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::snap_surface<Group>(tmesh, uv_map, internal::strip(np));
}

namespace internal {

constexpr double lattice_height = 0.86602540378443864676; // of its triangle: sqrt(3) / 2

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

converts a parametrization from Cartesian coordinates \f$ (x, y) \f$ to lattice coordinates, those
of \f$ N = 3, 6 \f$: \f$ (x - y / \sqrt 3, 2 y / \sqrt 3) \f$, rounded. Orientations stay, but for
those of faces that are nearly degenerate. Corners with the same coordinates keep the same.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`,
        whose corners share no place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner

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

converts a parametrization from lattice coordinates \f$ (a, b) \f$ to Cartesian ones:
\f$ (a + b / 2, b \sqrt 3 / 2) \f$, rounded. What is exactly seamless in lattice coordinates is not,
in general, in these: convert for pictures and measurements, not to go on from there.

Parameters and complexity are those of `convert_to_lattice_coordinates()`.

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
