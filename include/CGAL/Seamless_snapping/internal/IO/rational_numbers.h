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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_RATIONAL_NUMBERS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_RATIONAL_NUMBERS_H

#include <CGAL/license/Seamless_snapping.h>

// Fractions of integers, as some files hold them, as the nearest doubles.

#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// \pre all characters are digits
inline Exact_integer integer_of_digits(const std::string_view digits)
{
  constexpr std::size_t chunk = 9; // digits that an int holds
  Exact_integer result(0);
  for(std::size_t i = 0; i < digits.size(); i += chunk) {
    int part = 0, radix = 1;
    for(const char c : digits.substr(i, chunk)) {
      part = 10 * part + (c - '0');
      radix *= 10;
    }
    result = Exact_integer(Exact_integer(result * radix) + part);
  }
  return result;
}

// The double nearest to a positive number; of two, that whose last bit is 0. Infinite if it is
// beyond all.
inline double nearest_double(const Exact_rational& q)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double below = CGAL::to_double(q); // near by
  if(!std::isfinite(below))
    return infinity;
  while(Exact_rational(below) > q)
    below = std::nextafter(below, -infinity);
  double above = std::nextafter(below, infinity);
  while(std::isfinite(above) && Exact_rational(above) <= q) {
    below = above;
    above = std::nextafter(below, infinity);
  }
  if(!std::isfinite(above))
    return Exact_rational(below) == q ? below : infinity;
  const Exact_rational to_below(q - Exact_rational(below)), to_above(Exact_rational(above) - q);
  if(to_below != to_above)
    return to_below < to_above ? below : above;
  int exponent = 0; // even is what half the digits hold
  const double significand = std::ldexp(std::frexp(below, &exponent), 52);
  return significand == std::floor(significand) ? below : above;
}

// A decimal number or a fraction.
// \param is_rounded whether the number is a fraction that no double holds
template <typename Scanner>
double parse_number_or_fraction(const Scanner& scanner, const std::string_view token,
                                bool& is_rounded)
{
  is_rounded = false;
  const std::size_t slash = token.find('/');
  if(slash == std::string_view::npos)
    return parse_number<double>(scanner, token);
  const bool is_negative = token.front() == '-';
  const std::size_t begin = is_negative || token.front() == '+' ? 1 : 0;
  const std::string_view p = token.substr(begin, slash - begin), q = token.substr(slash + 1);
  const auto are_digits = [](const std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if(!are_digits(p) || !are_digits(q))
    scanner.refuse(quoted(token) + " is not a number");
  const Exact_integer numerator = integer_of_digits(p), denominator = integer_of_digits(q);
  if(denominator == 0)
    scanner.refuse(quoted(token) + " divides by zero");
  if(numerator == 0)
    return 0;
  const Exact_rational number(Exact_rational(numerator) / Exact_rational(denominator));
  const double nearest = nearest_double(number);
  if(!std::isfinite(nearest))
    scanner.refuse(quoted(token) + " is too large for the number type");
  is_rounded = Exact_rational(nearest) != number;
  return is_negative ? -nearest : nearest;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_RATIONAL_NUMBERS_H
