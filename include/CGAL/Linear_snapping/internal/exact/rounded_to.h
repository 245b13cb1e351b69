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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_H

#include <CGAL/license/Linear_snapping.h>

// Rounding of doubles to the number type of the coordinates, be it known at run time only.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>

#include <limits>
#include <type_traits>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The number of type `Number` nearest to `x`: float, or a type that holds all doubles. All such
// roundings go through here: from -O2 on, the vectorizer of g++ 12 takes the conversions of two
// neighboring doubles to float and back for nothing, and drops them. A volatile number keeps it
// from that.
template <typename Number>
double rounded_to(const double x)
{
  if constexpr(std::is_same<Number, float>::value) {
    const volatile float rounded = static_cast<float>(x);
    return static_cast<double>(rounded);
  } else {
    return x;
  }
}

// The number of the format, that of float or double, nearest to `x`.
inline double rounded_to(const Number_format& format, const double x)
{
  return format.digits == std::numeric_limits<float>::digits ? rounded_to<float>(x) : x;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_H
