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

#ifndef CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// Checking and measuring the parametrizations of volumes: whether they are exactly seamless, and
// whether they are integer-grid maps.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_volume.h>
#include <CGAL/Seamless_snapping/types/Volume_seamlessness.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Counts and measures what the flat volume lists.
inline void measure_constraints(const Flat_volume& volume, Volume_seamlessness& result)
{
  result.extent = volume.extent;
  result.number_of_mismatched_facets = volume.open_facets.size();
  for(const Corner_index facet : volume.open_facets) {
    const Facet_vectors vectors(volume.sides(facet));
    if(vectors.exact_fit())
      continue;
    ++result.number_of_inexact_facets;
    result.violation = (std::max)(result.violation, vectors.residual(vectors.best_fit()));
  }
  // as many coordinates are to be constant
  const auto add_misalignment = [&](Uvw spread, const std::size_t number) {
    std::sort(spread.begin(), spread.end());
    result.number_of_misalignments += std::size_t(spread[number - 1] != 0);
    result.misalignment = (std::max)(result.misalignment, spread[number - 1]);
  };
  result.number_of_aligned_facets = volume.aligned_facets.size();
  for(const Corner_index facet : volume.aligned_facets)
    add_misalignment(spread(volume, corners_of_facet(facet)), 1);
  result.number_of_aligned_edges = volume.aligned_edges.size();
  for(const Flat_volume::Aligned_edge& edge : volume.aligned_edges)
    add_misalignment(spread<2>(volume, {{edge.a, edge.b}}), 2);
}

// Throws what is wrong with the cells or the coordinates.
template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
void read_or_throw(const TetrahedronRange& range, const CornerUVWMap& uvw_map,
                   const NamedParameters& np, const Cells_to_read cells, Tetrahedra& tetrahedra,
                   Flat_volume& volume)
{
  if(const auto refusal = read_volume(range, uvw_map, np, tetrahedra, volume, {}, cells))
    throw Invalid_input(refusal->message);
  read_coordinates(uvw_map, volume);
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingVerifying

returns whether a parametrization of a tetrahedral mesh is exactly seamless, by exact arithmetic.

This is the case if for each interior facet there is one of the 24 rotations of the cube \f$ R \f$
such that
\f$ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f$ for any two of its
vertices \f$ a, b \f$. Here \f$ \mathbf{u} \f$ and \f$ \mathbf{u}' \f$ are the coordinates in the
charts of the two cells. In addition, one coordinate must be constant on each boundary facet and
feature facet, and two must be constant along each feature edge.

Template parameters, parameters, and named parameters are as for `snap_volume_to_seamless()`,
without `tolerance`, `verbose`, and `visitor`. The map need only be a model of
`ReadablePropertyMap`.

\return `true` if and only if the parametrization is exactly seamless and aligned. The result is
        also `false` if a coordinate is NaN, infinite, or beyond 1e300.

\throws Invalid_input if the cells, their neighbors, or the features do not satisfy the
        preconditions of `snap_volume_to_seamless()`; the message names the place
\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of cells; about as fast as comparing the coordinates on both sides of each
facet.

\sa `measure_volume_seamlessness()`
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_volume_seamless(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  internal::Tetrahedra mesh;
  internal::Flat_volume volume;
  if(const auto refusal =
       internal::read_volume(tetrahedra, uvw_map,
                             internal::strip(np, internal::volume_parameters), mesh, volume)) {
    if(refusal->status == Outcome::NOT_FINITE)
      return false;
    throw Invalid_input(refusal->message);
  }
  internal::read_coordinates(uvw_map, volume);
  Volume_seamlessness result;
  internal::measure_constraints(volume, result);
  return result.is_exact();
}

/*!
\ingroup PkgSeamlessSnappingVerifying

measures how far a parametrization of a tetrahedral mesh is from being exactly seamless and aligned,
and counts the cells that are flipped or degenerate in the domain.

Parameters are as for `is_volume_seamless()`.

\throws Invalid_input also if a coordinate is NaN, infinite, or beyond 1e300
\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of cells.
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Volume_seamlessness
measure_volume_seamlessness(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  internal::Tetrahedra mesh;
  internal::Flat_volume volume;
  internal::read_or_throw(tetrahedra, uvw_map, internal::strip(np, internal::volume_parameters),
                          internal::Cells_to_read::AT_CONSTRAINTS, mesh, volume);
  Volume_seamlessness result;
  internal::measure_constraints(volume, result);
  result.number_of_cells = mesh.number_of_cells();
  for(std::size_t f = 0; f < mesh.neighbors.size(); ++f)
    result.number_of_interior_facets +=
      std::size_t(mesh.neighbors[f] > internal::Corner_index(f / 4));
  for(std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    internal::Uvw_tetrahedron u;
    for(std::size_t i = 0; i < 4; ++i)
      u[i] = internal::get_uvw(uvw_map, mesh.turned.key(4 * c + i));
    const CGAL::Orientation sign = internal::orientation(u);
    result.number_of_flipped_cells += std::size_t(sign == CGAL::NEGATIVE);
    result.number_of_degenerate_cells += std::size_t(sign == CGAL::ZERO);
  }
  return result;
}

/*!
\ingroup PkgSeamlessSnappingVerifying

measures how far a parametrization of a tetrahedral mesh is from an integer-grid map.

An integer-grid map is an exactly seamless parametrization with these properties:
- translations across cuts are integers;
- singular edges lie on integer lines along a coordinate axis, and meet at integer points;
- boundary facets, feature facets, and feature edges lie on integer planes and lines.

Such a map describes a mesh of hexahedra, the cells of the integer grid, which programs like HexEx
extract. An edge is singular if the angles of the cells around it do not add up to 360 degrees. This
is so if the rotations around it do not multiply to the identity, or if the sum is 720 degrees or
more. If a cell around an edge is flipped or degenerate, only the rotations count.

The function computes transitions from the coordinates, and shares no code with the functions that
make such maps. Parameters and exceptions are as for `measure_volume_seamlessness()`.

\par Complexity
\f$ O(n \log n) \f$ in the number \f$ n \f$ of cells, in practice linear. All cells are copied.

\sa `snap_volume_to_seamless()`
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Volume_integer_grid_measure
measure_volume_integer_grid(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  internal::Tetrahedra mesh;
  internal::Flat_volume volume;
  internal::read_or_throw(tetrahedra, uvw_map, internal::strip(np, internal::volume_parameters),
                          internal::Cells_to_read::ALL, mesh, volume);
  return internal::measure_integer_grid(volume);
}

/*!
\ingroup PkgSeamlessSnappingVerifying

returns `true` if and only if a parametrization of a tetrahedral mesh is exactly an integer-grid
map.

Orientations are ignored. Parameters, exceptions, and complexity are as for
`measure_volume_integer_grid()`.
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_volume_integer_grid_map(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  return bool(measure_volume_integer_grid(tetrahedra, uvw_map, np));
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H
