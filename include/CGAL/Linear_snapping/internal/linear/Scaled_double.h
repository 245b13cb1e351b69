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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SCALED_DOUBLE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SCALED_DOUBLE_H

#include <CGAL/license/Linear_snapping.h>

// Floating point numbers of any size: those of integers with hundreds of bits.

#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// mantissa 2^exponent
struct Scaled_double
{
  double mantissa;
  long exponent;
};

inline Scaled_double to_scaled_double(const std::int64_t a)
{
  return {static_cast<double>(a), 0};
}

// The relative error is a few ulps, whatever the size of the integer.
inline BOOST_NOINLINE Scaled_double to_scaled_double(const Exact_integer& a)
{
  static const Exact_integer too_large = power_of_two(960);
  static const Exact_integer divisor = power_of_two(512);
  Exact_integer rest = a;
  long exponent = 0;
  while(rest >= too_large || Exact_integer(-rest) >= too_large) {
    rest = Exact_integer(rest / divisor);
    exponent += 512;
  }
  int binary_exponent = 0;
  const double mantissa = std::frexp(CGAL::to_double(rest), &binary_exponent);
  return {mantissa, mantissa == 0 ? 0 : exponent + binary_exponent};
}

// ldexp for exponents of any size.
inline double scaled_by_power(const double a, const long exponent)
{
  if(exponent == 0 || a == 0)
    return a;
  return std::ldexp(a, static_cast<int>((std::max)(-5000L, (std::min)(5000L, exponent))));
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SCALED_DOUBLE_H
