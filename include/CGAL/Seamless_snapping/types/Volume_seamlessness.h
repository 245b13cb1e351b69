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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_VOLUME_SEAMLESSNESS_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_VOLUME_SEAMLESSNESS_H

#include <CGAL/license/Seamless_snapping.h>

// The results of `measure_volume_seamlessness()` and `measure_volume_integer_grid()`.

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingVerifying

The result of `measure_volume_seamlessness()`. The counts are exact. The violations are computed in
floating point, with an error in their last digits.
*/
struct Volume_seamlessness
{
  std::size_t number_of_cells = 0;           ///< tetrahedra
  std::size_t number_of_interior_facets = 0; ///< facets with a cell on both sides
  /// interior facets whose sides have different coordinates
  std::size_t number_of_mismatched_facets = 0;
  /// interior facets for which no transition holds exactly
  std::size_t number_of_inexact_facets = 0;
  std::size_t number_of_aligned_facets = 0;  ///< facets that were asked to be aligned
  std::size_t number_of_aligned_edges = 0;   ///< edges that were asked to be aligned
  /// aligned facets without a constant coordinate, and aligned edges without two
  std::size_t number_of_misalignments = 0;
  /// cells with another orientation than most cells of their component of the mesh
  std::size_t number_of_flipped_cells = 0;
  std::size_t number_of_degenerate_cells = 0; ///< cells of no volume
  double extent = 0;    ///< the larger side of the bounding box of the coordinates
  double violation = 0; ///< the largest violation of a transition, along two edges of a facet
  /// the largest change of a coordinate that would have to be constant on an aligned facet or edge
  double misalignment = 0;

  /// returns `true` if and only if all transitions and alignments hold exactly.
  bool is_exact() const { return number_of_inexact_facets == 0 && number_of_misalignments == 0; }
};

/*!
\ingroup PkgSeamlessSnappingVerifying

The result of `measure_volume_integer_grid()`. The counts are exact. Distances are
computed in floating point.
*/
struct Volume_integer_grid_measure
{
  bool is_exactly_seamless = false; ///< whether all transitions and alignments hold exactly
  std::size_t number_of_noninteger_cuts = 0;   ///< cut facets whose translation is no integer
  std::size_t number_of_noninteger_facets = 0; ///< aligned facets that lie on no integer plane
  std::size_t number_of_noninteger_edges = 0;  ///< aligned edges that lie on no integer line
  /// interior edges with another angle than 360 degrees, and edges of an aligned boundary with an
  /// angle of 360 degrees or more
  std::size_t number_of_singular_edges = 0;
  /// singular edges that lie on no integer line
  std::size_t number_of_noninteger_singular_edges = 0;
  /// nodes: vertices of interior singular edges that do not have exactly two of them
  std::size_t number_of_nodes = 0;
  /// nodes that are no integer points; there are none if cells have positive volume and singular
  /// edges lie on integer lines
  std::size_t number_of_noninteger_nodes = 0;
  /// cells that are flipped or degenerate in the domain, relative to the orientation of most cells
  std::size_t number_of_nonpositive_cells = 0;
  double translation_distance = 0; ///< the largest distance of a translation from an integer
  /// the largest distance of an aligned facet from an integer plane, or of an edge from a line
  double alignment_distance = 0;
  /// the signed volume of all cells, computed exactly and rounded to a `double`; in an integer-grid
  /// map with aligned boundary, it is the number of hexahedra
  double volume = 0;

  /// returns `true` if and only if the map is exactly an integer-grid map. Orientations are
  /// ignored.
  explicit operator bool() const
  {
    return is_exactly_seamless && number_of_noninteger_cuts == 0 &&
           number_of_noninteger_facets == 0 && number_of_noninteger_edges == 0 &&
           number_of_noninteger_singular_edges == 0 && number_of_noninteger_nodes == 0;
  }
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_VOLUME_SEAMLESSNESS_H
