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

// What the snapping functions return: whether the result is exact and, if not, why; the sizes of
// the problem; how far the values moved; where the time went.

#include <CGAL/Seamless_snapping/types/Report.h>

#include <CGAL/Exact_integer.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingRef

Figures of the linear system that a snapping function solved, and of its elimination. They are
summed over its independent components, or are the largest of any.
*/
struct Linear_solver_figures
{
  std::size_t number_of_unknowns = 0;              ///< columns
  std::size_t number_of_constraints = 0;           ///< rows
  std::size_t number_of_redundant_constraints = 0; ///< rows implied by others
  /// independent rows for which no pivot \f$ \pm 1 \f$ was found
  std::size_t number_of_non_unit_pivots = 0;
  std::size_t number_of_coefficients = 0;            ///< nonzero coefficients of the rows
  std::size_t number_of_eliminated_coefficients = 0; ///< the same after the elimination
  /// eliminations of the matrix; one, however often it is solved for other values
  std::size_t number_of_eliminations = 0;
  std::size_t coefficient_bits = 0; ///< bits of the largest coefficient met during the elimination
  double largest_coefficient = 0;   ///< its absolute value, rounded
  double largest_pivot = 0;         ///< the largest absolute value of a pivot, rounded
  bool multiprecision = false;      ///< whether the elimination needed more than 64 bits
};

/*!
\ingroup PkgSeamlessSnappingRef

Figures of a run: what was found on the surface, what was done about its faces, and how long each
step took. Those of a step that was not reached are zero, as are those of the surface for the
generic function.
*/
struct Snapping_figures
{
  /// \name Size of the Parametrization
  /// @{
  std::size_t number_of_faces = 0;        ///< faces of the mesh
  std::size_t number_of_cut_edges = 0;    ///< interior edges whose transition is not the identity
  /// edges that are no cut, but whose sides differed in the input
  std::size_t number_of_merged_edges = 0;
  /// edges too short to tell their rotation, which took it from their surroundings
  std::size_t number_of_edges_decided_by_surroundings = 0;
  /// interior vertices whose holonomy is not the identity
  std::size_t number_of_singular_vertices = 0;
  std::size_t number_of_sectors = 0; ///< sectors at the vertices of cut, merged, and aligned edges
  std::size_t number_of_nodes = 0;   ///< vertices whose sectors enter the constraint system
  std::size_t number_of_cut_branches = 0;   ///< sequences of cut edges between nodes
  std::size_t number_of_align_branches = 0; ///< sequences of aligned edges between nodes
  /// @}

  /// the spacing of the grid the constrained values were moved to; the coarsest, if there are
  /// several
  double grid_step = 0;

  /// \name Orientation
  /// @{

  /// the largest change before orientations were repaired
  double largest_change_before_repair = 0;
  /// faces of positive orientation that the closest solution turned or made degenerate, before
  /// repair
  std::size_t number_of_lost_faces = 0;
  /// those that moves of single vertices made positive again
  std::size_t number_of_faces_repaired_by_moves = 0;
  std::size_t number_of_faces_repaired_by_program = 0; ///< those that a quadratic program did
  /// with `Flip_repair::UNTANGLE`: those that untangling did
  std::size_t number_of_faces_repaired_by_untangling = 0;
  /// with `repair_flips`: faces that were not positive in the input, and that repairs made positive
  std::size_t number_of_repaired_flips = 0;
  /// with `Flip_repair::UNTANGLE`: faces that have no area, whatever the coordinates are, as long
  /// as seams and alignments are what they are
  std::size_t number_of_faces_without_area = 0;
  /// with `Flip_repair::UNTANGLE`: iterations over all faces that it took, at most what the named
  /// parameter `number_of_untangling_iterations` allows
  std::size_t number_of_untangling_iterations = 0;
  /// @}

  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
};

/*!
\ingroup PkgSeamlessSnappingRef

What `snap_to_seamless()` and `snap_to_linear_constraints()` return: the outcome, the place and
remedy of a failure, and how far the values moved. Converts to `bool`: `true` if and only if all
constraints hold exactly in the caller's values.

Lengths are in the units of the values; divide by `extent` for relative ones. Figures of a step that
was not reached, or that has no meaning for the function that was called, are zero.
*/
struct Snapping_report
  : public Report
{
  /// \cond SKIP_IN_MANUAL
  Snapping_report() : Report(Outcome::ALREADY_EXACT) { }
  /// \endcond

  /// \name Outcome
  /// @{
  /*!
  After `INCONSISTENT`: the constraints that contradict each other, as pairs of a row and a nonzero
  multiplier. The sum of these multiples of the rows reads \f$ 0 = c \f$ with \f$ c \ne 0
  \f$. For the surface function, rows are those of its internal system; `message` names what they
  stand for.
  */
  std::vector<std::pair<std::size_t, CGAL::Exact_integer> > certificate;
  /// @}

  /// \name Distances
  /// Means are over the values of those parts of the system that had to be changed: parts that
  /// share no unknown with others and hold exactly in the input are left out.
  /// @{

  /// the larger side of the bounding box of the coordinates; for the generic function the largest
  /// absolute value
  double extent = 0;
  /// the largest violation of a constraint by the input; for the surface function, of a transition
  /// or an alignment
  double violation_before = 0;
  /// the largest distance by which the isocurve of a connection or cycle constraint misses its end
  /// in the input
  double connection_violation_before = 0;
  /// with `integer_grid`: the largest distance of a translation, a cone, or the level of an aligned
  /// edge from the integer it was rounded to
  double largest_rounding = 0;
  double largest_change = 0;    ///< the largest absolute change of a value
  /// the mean absolute change (of each sector, for the surface function)
  double mean_change = 0;
  double rms_change = 0;        ///< the root-mean-square change, over the same values
  /// the same for the real-valued least-squares optimum that was approximated
  double optimal_rms_change = 0;
  /*!
  of the generic function: the distance of the result from the input, in terms of that of the
  optimum or of the spacing of numbers of the values' size, whichever is larger; the largest of any
  part of the system. Some units are usual. If it exceeds 10, then so few numbers solve the part, or
  they are so hard to find, that the result is far; `message` says so.
  */
  double distance_ratio = 0;
  /// @}

  /// \name Orientation (Surface Function Only)
  /// Faces are counted in the order of iteration over all faces of the mesh, from 0.
  /// @{

  /// faces that were positive in the input, and are not in the result
  std::vector<std::size_t> lost_faces;
  /// with `repair_flips`: faces that were not positive in the input, and still are not
  std::vector<std::size_t> remaining_flips;
  /// @}

  Snapping_figures run;                ///< figures of the run
  Linear_solver_figures linear_solver; ///< figures of the linear system
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_SNAPPING_REPORT_H
