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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_DIFFERENCE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_DIFFERENCE_H

#include <CGAL/license/Linear_snapping.h>

// The difference of two doubles without its rounding error, comparisons of such differences at
// about the price of a floating point operation, and an exact test whether a sum of doubles is
// zero. All need rounding to nearest.

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// a - b = rounded + error, exactly, unless the rounded difference overflows (see `is_valid`). Equal
// differences have equal members: the rounded one is the double nearest to the difference.
struct Exact_difference
{
  double rounded;
  double error;

  Exact_difference(const double a, const double b)
  {
    rounded = a - b;
    const double b_part = a - rounded;
    const double a_part = rounded + b_part;
    error = (a - a_part) + (b_part - b);
  }

  bool is_valid() const { return std::isfinite(rounded); }

  friend bool operator==(const Exact_difference& x, const Exact_difference& y)
  { return x.rounded == y.rounded && x.error == y.error; }
};

inline double distance_to_integer(const double x) { return std::abs(x - std::round(x)); }

// 0 if and only if it is one: up to 2^52, all integers are doubles.
inline double distance_to_integer(const Exact_difference& d)
{
  return std::abs((d.rounded - std::round(d.rounded)) + d.error);
}

// A rounded sum that is large beside its possible error decides; else rationals do.
// \pre all terms are finite
inline bool exact_sum_is_zero(const double* const terms, const std::size_t size)
{
  double sum = 0, size_of_terms = 0;
  for(std::size_t i = 0; i < size; ++i) {
    sum += terms[i];
    size_of_terms += std::abs(terms[i]);
  }
  if(std::isfinite(size_of_terms) && std::abs(sum) > 1e-12 * size_of_terms)
    return false; // the error is below `size` units in the last place of `size_of_terms`
  Exact_rational exact(0);
  for(std::size_t i = 0; i < size; ++i)
    exact += Exact_rational(terms[i]);
  return exact == 0;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_DIFFERENCE_H
