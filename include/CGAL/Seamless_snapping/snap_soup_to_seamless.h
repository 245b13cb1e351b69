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

#ifndef CGAL_SEAMLESS_SNAPPING_SNAP_SOUP_TO_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_SNAP_SOUP_TO_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// The surface function, and its check, for triangle soups: arrays of vertex indices, without a mesh
// data structure.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/soup_surface.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

constexpr auto soup_parameters =
  named<CGAL::internal_np::align_border, CGAL::internal_np::feature_edges,
        CGAL::internal_np::grid_scale, CGAL::internal_np::integer_grid,
        CGAL::internal_np::repair_flips, CGAL::internal_np::rotational_symmetry,
        CGAL::internal_np::rounding_tolerance, CGAL::internal_np::tolerance,
        CGAL::internal_np::untangling_iterations, CGAL::internal_np::verbose,
        CGAL::internal_np::visitor>;

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingRef

moves an approximately seamless parametrization of a triangle soup to a nearby one that is exactly
seamless, as `snap_to_seamless()` does.

Two faces are neighbors if they share two vertex indices. If the faces around a vertex form several
fans, each fan counts as a separate vertex. Messages name vertices by their indices.

\tparam TriangleRange a range whose elements are ranges of 3 vertex indices:
        `std::vector<std::array<int, 3> >`, for instance
\tparam CornerUVMap a model of `ReadWritePropertyMap` with `std::size_t` as key type and as value
        type a two-dimensional point with coordinates `x()` and `y()` of type `double` or `float`,
        which can be constructed from two of them
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param triangles the faces: integers from 0 to \f$ 2^{31} - 2 \f$ for the vertices. They need not
       be consecutive: memory is proportional to the number of faces.
\param uv_map the coordinates of each corner: key `3 * i + k` is vertex `k` of face `i`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `align_border`,
       `rotational_symmetry`, `tolerance`, `repair_flips`, `number_of_untangling_iterations`,
       `integer_grid`, `grid_scale`, `rounding_tolerance`, `verbose`, and `visitor` of
       `snap_to_seamless()`, and the one listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{feature_edges}
    \cgalParamDescription{edges that are to lie on isocurves. Along each, the function makes the
                          coordinate constant that changes less in the input.}
    \cgalParamType{a range of ranges of 2 vertex indices}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report, as for `snap_to_seamless()`. In addition, `Snapping_report::status` is
        - `NOT_MANIFOLD`: an edge belongs to more than two faces, or two of its faces are not
          oriented consistently;
        - `INVALID_ARGUMENT`: a face has a vertex twice or an index out of range, or a feature is no
          edge of a face.

\par Complexity
As for `snap_to_seamless()`. The function first makes a face graph, which takes about as long as
reading a file into a mesh.

\sa `is_soup_seamless()`
\sa `snap_to_seamless()`
\sa `snap_volume_to_seamless()`
*/
template <typename TriangleRange, typename CornerUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report snap_soup_to_seamless(const TriangleRange& triangles, CornerUVMap uv_map,
                                      const NamedParameters& np =
                                        CGAL::parameters::default_values())
{
  if constexpr(internal::check_map_of_corners<CornerUVMap, std::size_t>()) {
    const auto& plain_np = internal::strip(np, internal::soup_parameters);
    const auto& feature_edges = CGAL::parameters::get_parameter_reference(
      plain_np, CGAL::internal_np::feature_edges);
    internal::Soup_surface surface;
    if(const auto refusal = surface.read(triangles, feature_edges))
      return internal::refused<Snapping_report>(*refusal);
    return internal::snap_with_plain_parameters(
      surface.mesh(), internal::Soup_uv_map<CornerUVMap>{surface.corner(), uv_map},
      plain_np.edge_is_constrained_map(surface.is_feature())
              .vertex_index_map(surface.vertex_index()));
  }
}

/*!
\ingroup PkgSeamlessSnappingVerifying

returns whether a parametrization of a triangle soup is exactly seamless and aligned, as
`is_seamless()` does.

Parameters are as for `snap_soup_to_seamless()`. The function reads the named parameters
`align_border`, `rotational_symmetry`, and `feature_edges`. The map need only be a model of
`ReadablePropertyMap`.

\throws Invalid_input if the faces or features do not satisfy the preconditions of
        `snap_soup_to_seamless()`; the message names the place
\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\pre all coordinates are finite

\par Complexity
As for `is_seamless()`. The function first makes a face graph, as `snap_soup_to_seamless()` does.
*/
template <typename TriangleRange, typename CornerUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_soup_seamless(const TriangleRange& triangles, CornerUVMap uv_map,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  if constexpr(internal::check_map_of_corners<CornerUVMap, std::size_t>()) {
    const auto& plain_np = internal::strip(np, internal::soup_parameters);
    const auto& feature_edges = CGAL::parameters::get_parameter_reference(
      plain_np, CGAL::internal_np::feature_edges);
    internal::Soup_surface surface;
    if(const auto refusal = surface.read(triangles, feature_edges))
      throw Invalid_input(refusal->message);
    const internal::Soup_uv_map<CornerUVMap> uv{surface.corner(), uv_map};
    return internal::is_seamless(surface.mesh(), uv,
                                 plain_np.edge_is_constrained_map(surface.is_feature())
                                         .vertex_index_map(surface.vertex_index()));
  }
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_SNAP_SOUP_TO_SEAMLESS_H
