// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_EXACT_EVALUATION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_EXACT_EVALUATION_H

#include <CGAL/license/Seamless_snapping.h>

// Decides exactly whether floating point values solve a system: the check that every result has to
// pass, and the look before a snap whether there is anything to do. Knows no grid.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// C x - b for one row, in rationals.
template <typename Integer>
Exact_rational exact_violation(const Integer_system<Integer>& system, const std::size_t row,
                               const std::vector<double>& x)
{
  const int scale = system.right_hand_scale();
  Exact_rational sum(-Exact_rational(Exact_integer(system.right_hand_side(row))));
  if(scale >= 0)
    sum /= Exact_rational(power_of_two(std::size_t(scale)));
  else
    sum *= Exact_rational(power_of_two(std::size_t(-scale)));
  for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
    sum += Exact_rational(Exact_integer(e->coefficient)) * Exact_rational(x[std::size_t(e->column)]);
  return sum;
}

// The same in 64-bit integers, on the coarsest grid that holds all values of the row. Returns false if
// it can't tell.
template <typename Integer>
bool holds_in_small_integers(const Integer_system<Integer>& system, const std::size_t row,
                             const std::vector<double>& x, bool& holds)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  if(system.right_hand_side(row) != 0)
    return false;
  int largest = std::numeric_limits<int>::min();
  for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
    if(x[std::size_t(e->column)] != 0)
      largest = (std::max)(largest, std::ilogb(x[std::size_t(e->column)]));
  try {
    std::int64_t sum = 0;
    for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e) {
      const double value = x[std::size_t(e->column)];
      if(value == 0)
        continue;
      // 7 bits finer than the largest value needs; that is enough for nearly all others
      const double scaled = std::ldexp(value, digits - 1 + 7 - largest);
      const std::int64_t integer = static_cast<std::int64_t>(scaled);
      if(scaled == 0 || static_cast<double>(integer) != scaled || !fits_64_bits(e->coefficient))
        return false;
      sum = difference_with_product(sum, to_64_bits(e->coefficient), integer);
    }
    holds = (sum == 0);
    return true;
  } catch(const Integer_overflow&) {
    return false;
  }
}

// The first row from `row` on that the values do not satisfy exactly, or the number of rows.
template <typename Integer>
std::size_t next_violated_row(const Integer_system<Integer>& system, const std::vector<double>& x,
                              std::size_t row = 0)
{
  for(; row < system.number_of_rows(); ++row) {
    bool holds = false;
    if(!holds_in_small_integers(system, row, x, holds))
      holds = (exact_violation(system, row, x) == 0);
    if(!holds)
      break;
  }
  return row;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_EXACT_EVALUATION_H
