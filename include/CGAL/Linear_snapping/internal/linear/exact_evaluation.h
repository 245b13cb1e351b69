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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_EXACT_EVALUATION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_EXACT_EVALUATION_H

#include <CGAL/license/Linear_snapping.h>

// Decides exactly whether floating point values solve a system: the check that every result has to
// pass, and the look before a snap whether there is anything to do. Knows no grid.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <CGAL/Exact_rational.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Whether C x = b for one row, in rationals.
inline BOOST_NOINLINE bool holds_in_rationals(const Integer_system& system, const std::size_t row,
                                              const std::vector<double>& x)
{
  const Integer_row<Exact_integer> exact = system.exact_row(row);
  const int scale = system.right_hand_scale();
  Exact_rational sum(0);
  for(const Entry<Exact_integer>& e : exact.entries)
    sum += Exact_rational(e.coefficient) * Exact_rational(x[std::size_t(e.column)]);
  if(scale >= 0)
    sum *= Exact_rational(power_of_two(std::size_t(scale)));
  else
    sum /= Exact_rational(power_of_two(std::size_t(-scale)));
  return sum == Exact_rational(exact.right_hand_side);
}

// The same in 64-bit integers, on the coarsest grid that holds all values of the row. Returns false
// if it can't tell.
inline bool holds_in_small_integers(const Integer_system& system, const std::size_t row,
                                    const std::vector<double>& x, bool& holds)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  if(!system.is_small(row))
    return false;
  double largest = 0;
  for(const Entry<std::int64_t>& e : system.row(row))
    largest = (std::max)(largest, std::abs(x[std::size_t(e.column)]));
  // 7 bits finer than the largest value needs; that is enough for nearly all others
  const int exponent = (largest == 0 ? 0 : std::ilogb(largest)) - (digits - 1 + 7);
  const double factor = std::ldexp(1., -exponent);
  std::int64_t sum = 0;
  if(!std::isfinite(factor) ||
     !shifted(-system.right_hand_side(row), -system.right_hand_scale() - exponent, sum))
    return false;
  for(const Entry<std::int64_t>& e : system.row(row)) {
    const double value = x[std::size_t(e.column)];
    const double scaled = value * factor;
    const std::int64_t integer = static_cast<std::int64_t>(scaled);
    if((scaled == 0 && value != 0) || static_cast<double>(integer) != scaled ||
       !add_product(e.coefficient, integer, sum))
      return false;
  }
  holds = (sum == 0);
  return true;
}

// Whether the values satisfy a row exactly.
inline bool holds(const Integer_system& system, const std::size_t row, const std::vector<double>& x)
{
  bool result = false;
  return holds_in_small_integers(system, row, x, result) ? result
                                                         : holds_in_rationals(system, row, x);
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_EXACT_EVALUATION_H
