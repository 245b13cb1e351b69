// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_TYPES_LINEAR_REPORT_H
#define CGAL_LINEAR_SNAPPING_TYPES_LINEAR_REPORT_H

#include <CGAL/license/Linear_snapping.h>

// The result of snapping to linear constraints: whether it is exact and, if not, the reason; the
// size of the system; the changes of the values; the times of the steps.

#include <CGAL/Linear_snapping/types/Report.h>

#include <CGAL/Exact_integer.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {

/*!
\ingroup PkgLinearSnappingRef

The size of the linear system that a snapping function solved, and measurements of its elimination:
sums over the independent components of the system, or maxima.
*/
struct Linear_solver_figures
{
  std::size_t number_of_unknowns = 0;              ///< columns
  std::size_t number_of_constraints = 0;           ///< rows
  std::size_t number_of_redundant_constraints = 0; ///< rows implied by others
  /// independent rows whose pivot is not \f$ \pm 1 \f$
  std::size_t number_of_non_unit_pivots = 0;
  std::size_t number_of_coefficients = 0;            ///< nonzero coefficients of the rows
  std::size_t number_of_eliminated_coefficients = 0; ///< nonzero coefficients after the elimination
  /// eliminations of matrices; a matrix that is solved for several values is eliminated once
  std::size_t number_of_eliminations = 0;
  std::size_t coefficient_bits = 0; ///< bits of the largest coefficient during the elimination
  double largest_coefficient = 0;   ///< the absolute value of this coefficient, rounded
  double largest_pivot = 0;         ///< the largest absolute value of a pivot, rounded
  bool multiprecision = false;      ///< whether the elimination needed more than 64 bits
};

/*!
\ingroup PkgLinearSnappingRef

The report of `snap_to_linear_constraints()`: the outcome, the place and remedy of a failure, and
how far the values moved. It converts to `true` if and only if all constraints hold exactly in the
values of the caller.

Lengths are in the units of the values; divide by `extent` for relative lengths. Measurements of a
step that was not reached are zero. For surfaces and volumes, `Snapping_report` tells what the
members mean.
*/
struct Linear_report
  : public Report
{
  /// \cond SKIP_IN_MANUAL
  Linear_report() : Report(Outcome::ALREADY_EXACT) { }
  /// \endcond

  /*!
  After `INCONSISTENT`: the constraints that contradict each other, as pairs of a row and a nonzero
  multiplier. The sum of these multiples of the rows reads \f$ 0 = c \f$ with \f$ c \ne 0 \f$.
  */
  std::vector<std::pair<std::size_t, CGAL::Exact_integer> > certificate;

  /// \name Distances
  /// Means are over the values of the parts of the system that had to be changed. A part shares no
  /// unknown with other parts.
  /// @{

  double extent = 0;           ///< the largest absolute value in a constraint
  double violation_before = 0; ///< the largest violation of a constraint by the input
  double largest_change = 0;   ///< the largest absolute change of a value
  double mean_change = 0;      ///< the mean absolute change of a value
  double rms_change = 0;       ///< the root-mean-square change of a value
  /// the root-mean-square change of the real-valued least-squares optimum
  double optimal_rms_change = 0;
  /*!
  the distance of the result from the input, divided by the distance of the optimum or the spacing
  of numbers of the values' size, whichever is larger; the maximum over the parts of the system.
  Values up to 10 are usual. If it exceeds 10, `message` says that the result is far, because few
  numbers solve the part or because they are hard to find.
  */
  double distance_ratio = 0;
  /// the spacing of the grid of the constrained values; the coarsest spacing, if there are several
  /// grids; 0 if no value is constrained
  double grid_step = 0;
  /// @}

  Linear_solver_figures linear_solver; ///< measurements of the linear system
  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
};

} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_TYPES_LINEAR_REPORT_H
