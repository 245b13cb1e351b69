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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_SUM_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_SUM_H

#include <CGAL/license/Linear_snapping.h>

// The sign of a sum of doubles: whether it is zero, exactly.

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

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

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_EXACT_SUM_H
