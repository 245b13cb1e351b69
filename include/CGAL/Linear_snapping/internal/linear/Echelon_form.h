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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ECHELON_FORM_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ECHELON_FORM_H

#include <CGAL/license/Linear_snapping.h>

// What an elimination leaves behind.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Invariant: the pivot rows, the core rows, and the equations of the auxiliary unknowns have
// together the solutions of the system, apart from contradictory rows. The pivot of a row is 1 or
// -1, in a column that neither later pivot rows nor core rows hold, so that back-substitution runs
// through them in reverse.
struct Echelon_form
{
  Integer_system pivot_rows; // in the order of elimination
  std::vector<Column_index> pivot_columns; // one per pivot row
  Integer_system core_rows; // without a coefficient 1 or -1
  // Unknowns that follow the system's: sums of earlier ones, with signs.
  std::vector<Entries<std::int64_t> > auxiliary_unknowns;

  // Rows of the system. Those that became pivot rows are linearly independent.
  std::vector<Row_index> rows_with_pivot, rows_in_core, redundant_rows, contradictory_rows;

  std::size_t number_of_coefficients = 0;
  Exact_integer largest_coefficient = Exact_integer(0); // met on the way
  bool is_multiprecision = false;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ECHELON_FORM_H
