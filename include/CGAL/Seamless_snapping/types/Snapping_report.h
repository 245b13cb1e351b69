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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_SNAPPING_REPORT_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_SNAPPING_REPORT_H

#include <CGAL/license/Seamless_snapping.h>

// The results of functions that snap surfaces and volumes: the report of their linear system, the
// sizes of the surface, and the orientations of its faces. And the choices of repairs for faces
// that are flipped in the input.

#include <CGAL/Linear_snapping/types/Linear_report.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingRef

The values of the named parameter `repair_flips` of `snap_to_seamless()` and of
`snap_volume_to_seamless()`. `true` stands for `NEAR_BY`, `false` for `NONE`.

Repairs keep the angles of cones if possible. For example, a cone of 450 degrees does not become a
cone of 90 degrees, with 360 degrees more at another vertex. If flips remain, the function tries
again without this condition. Except for integer-grid maps, it also does so before it changes large
parts of the map. No positive face becomes flipped for the sake of another face.

The named parameter `number_of_untangling_iterations` bounds the search, by the number of Newton
iterations over all faces. A long factorization counts as several iterations. Maps of common
producers, and small maps that were tangled at random, needed at most 92 iterations in tests. If
faces stay flipped, the status is `Outcome::FLIPS_REMAIN`, and the result is exact nevertheless.
Some faces have area 0 in every map that satisfies the constraints; the function ignores them.
*/
enum class Flip_repair
{
  NONE,    ///< Flips of the input stay.
  /// Single vertices move, vertices without constraints move into the middle of their neighbors,
  /// and a quadratic program looks for nearby solutions.
  NEAR_BY,
  UNTANGLE ///< As `NEAR_BY`; the map around remaining flips changes as much as necessary.
};

/*!
\ingroup PkgSeamlessSnappingRef

Measurements of a run: sizes, and counts of repaired faces. Measurements of a step that was not
reached are zero.
*/
struct Snapping_figures
{
  /// \name Size of the Parametrization
  /// @{
  std::size_t number_of_faces = 0;        ///< faces of the mesh
  std::size_t number_of_cut_edges = 0;    ///< interior edges whose transition is not the identity
  /// edges that are no cut, but whose sides differed in the input
  std::size_t number_of_merged_edges = 0;
  /// edges that are too short to determine their rotation, and that took another rotation from
  /// their surroundings than the rotation that fits best
  std::size_t number_of_edges_decided_by_surroundings = 0;
  /// interior vertices around which the rotations do not multiply to the identity. Cones of 720
  /// degrees, or another multiple of 360, do not count; `Seam_transitions::singular_vertices()`
  /// lists them.
  std::size_t number_of_singular_vertices = 0;
  std::size_t number_of_sectors = 0; ///< sectors at the vertices of cut, merged, and aligned edges
  std::size_t number_of_nodes = 0;   ///< vertices whose sectors enter the constraint system
  std::size_t number_of_cut_branches = 0;   ///< sequences of cut edges between nodes
  std::size_t number_of_align_branches = 0; ///< sequences of aligned edges between nodes
  /// @}

  /// \name Orientation
  /// @{

  /// the largest change before orientations were repaired
  double largest_change_before_repair = 0;
  /// faces of positive orientation that the closest solution turned or made degenerate, before
  /// repair
  std::size_t number_of_lost_faces = 0;
  /// lost faces that moves of single vertices made positive again
  std::size_t number_of_faces_repaired_by_moves = 0;
  std::size_t number_of_faces_repaired_by_program = 0; ///< the same, by a quadratic program
  /// with `Flip_repair::UNTANGLE`: lost faces that untangling made positive again
  std::size_t number_of_faces_repaired_by_untangling = 0;
  /// with `repair_flips`: faces that were not positive in the input, and that repairs made positive
  std::size_t number_of_repaired_flips = 0;
  /// with `repair_flips`: interior vertices whose angle changed by full turns, because repairs
  /// turned a fold into cones; the angle in a fold is an estimate
  std::size_t number_of_changed_cones = 0;
  /// with `Flip_repair::UNTANGLE`: faces that have no area for any coordinates, because of seams
  /// and alignments
  std::size_t number_of_faces_without_area = 0;
  /// with `Flip_repair::UNTANGLE`: iterations over all faces, at most the named parameter
  /// `number_of_untangling_iterations`
  std::size_t number_of_untangling_iterations = 0;
  /// @}
};

/*!
\ingroup PkgSeamlessSnappingRef

The report of functions that snap surfaces and volumes: the report of a linear system, and the faces
that lost their orientation. It converts to `true` if and only if all constraints hold exactly in
the values of the caller.

Members of `Linear_report` have this meaning here:
- `certificate`: its rows belong to an internal system; `message` names the constraints of the
  caller
- `extent`: the largest side of the bounding box of the coordinates
- `violation_before`: the largest violation of a transition (of a volume, along two edges of a
  facet) or of an alignment
- `mean_change`, `rms_change`: the change of a sector; with `integer_grid` or `grid_scale`, of a
  corner of a surface
- `optimal_rms_change`: 0 for volumes, and with `integer_grid` or `grid_scale`
- `distance_ratio`: not computed
- `grid_step`: also 0 if corners are only merged

Measurements of a step that was not reached are zero.
*/
struct Snapping_report
  : public Linear_report
{
  /// \name Further Violations
  /// @{

  /// the largest distance by which the isocurve of a connection or cycle constraint misses its end
  /// in the input
  double connection_violation_before = 0;
  /// with `integer_grid`: the largest distance of a translation, a cone, or the level of an aligned
  /// edge from the integer it was rounded to
  double largest_rounding = 0;
  /// @}

  /// \name Orientation
  /// Faces are counted in the order of iteration over all faces of the mesh, from 0.
  /// @{

  /// faces that were positive in the input, and are not in the result
  std::vector<std::size_t> lost_faces;
  /// with `repair_flips`: faces that were not positive in the input, and still are not
  std::vector<std::size_t> remaining_flips;
  /// @}

  Snapping_figures run; ///< measurements of the run
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_SNAPPING_REPORT_H
