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

// What `measure_volume_seamlessness()` returns.

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingVerifying

What `measure_volume_seamlessness()` returns. The counts are exact; the violations are computed in
floating point with an error in the order of their last digit.
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
  /// those of them on which no coordinate is constant, or along which less than two are
  std::size_t number_of_misalignments = 0;
  std::size_t number_of_flipped_cells = 0;    ///< cells of negative orientation
  std::size_t number_of_degenerate_cells = 0; ///< cells of no volume
  double extent = 0;    ///< the larger side of the bounding box of the coordinates
  double violation = 0; ///< the largest violation of a transition
  /// the largest change of a coordinate that would have to be constant on an aligned facet or edge
  double misalignment = 0;

  /// returns `true` if and only if all transitions and alignments hold exactly.
  bool is_exact() const { return number_of_inexact_facets == 0 && number_of_misalignments == 0; }
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_VOLUME_SEAMLESSNESS_H
