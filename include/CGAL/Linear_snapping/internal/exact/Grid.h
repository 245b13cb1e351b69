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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_GRID_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_GRID_H

#include <CGAL/license/Linear_snapping.h>

// The fixed-point numbers of [MC19] Sec. 4.3: a grid 2^exponent Z, whose elements are handled as
// 64-bit integers, and real numbers split into a grid element and a small rest; and rounding to the
// number type of the coordinates, be it known at run time only.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The real number (base + offset) 2^exponent on a grid that the context knows. Keeping the integer
// apart makes differences of close values exact, also where the changes wanted are below one ulp.
struct Grid_value
{
  std::int64_t base = 0;
  double offset = 0;
};

inline double to_double(const Grid_value& v) { return static_cast<double>(v.base) + v.offset; }

inline double difference(const Grid_value& a, const Grid_value& b)
{
  return static_cast<double>(a.base - b.base) + (a.offset - b.offset);
}

// The limits of a floating point number type.
struct Number_format
{
  int digits;           // p: all integers up to 2^p are exact
  int minimum_exponent; // the smallest positive number is 2^minimum_exponent
  int maximum_exponent; // all numbers are below 2^maximum_exponent

  template <typename F>
  static Number_format of()
  {
    using Limits = std::numeric_limits<F>;
    static_assert(Limits::is_iec559 && Limits::digits <= 53,
                  "values must be of type float or double");
    return {Limits::digits, Limits::min_exponent - Limits::digits, Limits::max_exponent};
  }
};

// To nearest, up to ties; faster than the library's, which sets flags. \pre |x| < 2^63
inline std::int64_t nearest_integer(const double x)
{
  const double whole = static_cast<double>(static_cast<std::int64_t>(x)); // towards 0
  return static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(2 * (x - whole));
}

class Grid
{
public:
  Grid(const Number_format& format, const int exponent)
    : m_format(format), m_exponent(exponent), m_step(std::ldexp(1., exponent)),
      m_half_inverse(std::ldexp(1., -exponent / 2)),
      m_other_half_inverse(std::ldexp(1., -exponent - (-exponent / 2)))
  { }

  // The finest grid on which all numbers up to `largest` have at most p bits. ([MC19] Sec. 4.3 adds
  // a bit of margin; here the rare result that needs it is computed again on a coarser grid.)
  static Grid finest(const Number_format& format, const double largest)
  {
    int exponent = 0;
    if(largest > 0)
      std::frexp(largest, &exponent);
    return Grid(format, (std::max)(exponent - format.digits, format.minimum_exponent));
  }

  const Number_format& format() const { return m_format; }
  int exponent() const { return m_exponent; }
  double step() const { return m_step; }

  // x / step(), which may be infinite
  double in_steps(const double x) const
  { return (x * m_half_inverse) * m_other_half_inverse; } // 1 / step() may overflow

  // Exact, but for values that are subnormal numbers, or infinite, in units of the step. Beyond
  // 2^62 steps there is no base.
  Grid_value split(const double x) const
  {
    const double scaled = in_steps(x);
    if(!(std::abs(scaled) < machine_integer_bound))
      return {0, scaled};
    const std::int64_t base = nearest_integer(scaled);
    return {base, scaled - static_cast<double>(base)};
  }

  // \pre is_representable(x)
  double value(const std::int64_t x) const { return static_cast<double>(x) * m_step; }

  // Whether x 2^exponent is a number of the format.
  bool is_representable(const std::int64_t x) const
  {
    if(x == 0)
      return true;
    // the common case first
    const std::int64_t largest = std::int64_t(1) << m_format.digits;
    if(-largest <= x && x <= largest && m_exponent + m_format.digits < m_format.maximum_exponent)
      return true;
    std::uint64_t significand = static_cast<std::uint64_t>(x < 0 ? -x : x);
    const int bits = static_cast<int>(bit_length(x));
    while((significand & 1) == 0)
      significand >>= 1;
    return m_exponent + bits <= m_format.maximum_exponent &&
           significand <= (std::uint64_t(1) << m_format.digits);
  }

  // The representable grid element nearest to a real number, up to ties; false if that exceeds
  // 2^62.
  bool nearest(const Grid_value& v, std::int64_t& x) const
  {
    if(!(std::abs(to_double(v)) < machine_integer_bound))
      return false;
    x = std::abs(v.offset) < machine_integer_bound ? v.base + nearest_integer(v.offset) : 0;
    const int excess = static_cast<int>(bit_length(x)) - m_format.digits;
    if(excess > 0 && !is_representable(x)) {
      const std::int64_t unit = std::int64_t(1) << excess;
      x = ((x >= 0 ? x + unit / 2 : x - unit / 2) / unit) * unit;
    }
    return true;
  }

private:
  Number_format m_format;
  int m_exponent;
  double m_step, m_half_inverse, m_other_half_inverse;
};

// Changes the units to the units of a grid 2^shift times as coarse (as fine for shift < 0). Numbers
// that exceed 2^62 there lose their exact part.
inline void rescale(Grid_value& v, const int shift)
{
  if(shift == 0 && std::abs(v.offset) <= 0.5)
    return;
  const double size = std::ldexp(to_double(v), -shift);
  const double offset = std::ldexp(v.offset, -shift);
  if(shift > 0 && shift < 62 && std::abs(v.offset) < machine_integer_bound) {
    const std::int64_t unit = std::int64_t(1) << shift;
    v.offset = std::ldexp(static_cast<double>(v.base % unit) + v.offset, -shift);
    v.base /= unit;
  } else if(shift <= 0 && std::abs(offset) < machine_integer_bound &&
            std::ldexp(std::abs(static_cast<double>(v.base)), -shift) < machine_integer_bound) {
    const double whole = std::nearbyint(offset);
    v.base = (v.base == 0 ? 0 : v.base * (std::int64_t(1) << -shift)) +
             static_cast<std::int64_t>(whole);
    v.offset = offset - whole;
  } else {
    v = {0, size};
  }
}

// The number nearest to `x` in the format of float or double.
inline double rounded_to(const Number_format& format, const double x)
{
  return format.digits == std::numeric_limits<float>::digits ? rounded_to<float>(x) : x;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_GRID_H
