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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_CHECKED_INTEGER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_CHECKED_INTEGER_H

#include <CGAL/license/Linear_snapping.h>

// The few integer operations of the exact algorithms, written once for machine integers, which
// throw `Integer_overflow` instead of wrapping, and once for multiprecision integers, which cannot
// overflow. The smallest machine integer counts as an overflow too, so that values can be negated
// freely.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/ipower.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

static_assert(
  std::is_convertible_v<CGAL::Algebraic_structure_traits<Exact_integer>::Algebraic_category,
                        CGAL::Euclidean_ring_tag>,
  "CGAL::Exact_integer is a type without division here, as CGAL 6 takes it without GMP if Boost is "
  "older than 1.80: compile with GMP, with a newer Boost, or with the option "
  "-DCMAKE_OVERRIDDEN_DEFAULT_ENT_BACKEND=BOOST_BACKEND");

// Thrown where a result does not fit; callers repeat the computation with `Exact_integer`.
struct Integer_overflow : std::exception
{
  const char* what() const noexcept override { return "a 64-bit integer overflowed"; }
};

// Thrown if a system would take more work than is allowed.
struct Work_exceeded : std::exception
{
  const char* what() const noexcept override { return "a linear system took too long to solve"; }
};

inline std::int64_t checked_product(const std::int64_t a, const std::int64_t b)
{
  std::int64_t result = 0;
#if defined(__GNUC__)
  const bool overflow = __builtin_mul_overflow(a, b, &result);
#else
  const std::int64_t largest = (std::numeric_limits<std::int64_t>::max)();
  const bool overflow = a != 0 && b != 0 && (a < 0 ? -a : a) > largest / (b < 0 ? -b : b);
  if(!overflow)
    result = a * b;
#endif
  if(overflow || result == (std::numeric_limits<std::int64_t>::min)())
    throw Integer_overflow();
  return result;
}

inline std::int64_t checked_difference(const std::int64_t a, const std::int64_t b)
{
  std::int64_t result = 0;
#if defined(__GNUC__)
  const bool overflow = __builtin_sub_overflow(a, b, &result);
#else
  const std::int64_t largest = (std::numeric_limits<std::int64_t>::max)();
  const bool overflow = b < 0 ? a > largest + b : a < b - largest;
  if(!overflow)
    result = a - b;
#endif
  if(overflow || result == (std::numeric_limits<std::int64_t>::min)())
    throw Integer_overflow();
  return result;
}

inline std::int64_t absolute_value(const std::int64_t a) { return a < 0 ? -a : a; }

// Adds a b to `sum`. Returns false if something does not fit; then `sum` is undefined.
inline bool add_product(const std::int64_t a, const std::int64_t b, std::int64_t& sum)
{
#if defined(__GNUC__)
  std::int64_t product = 0;
  return !__builtin_mul_overflow(a, b, &product) && !__builtin_add_overflow(sum, product, &sum) &&
         sum != (std::numeric_limits<std::int64_t>::min)();
#else
  try {
    sum = checked_difference(sum, checked_product(-a, b));
    return true;
  } catch(const Integer_overflow&) {
    return false;
  }
#endif
}

// Sets `result` to a 2^shift. Returns false if that is not an integer of at most 62 bits.
// \pre |a| <= 2^62
inline bool shifted(const std::int64_t a, const int shift, std::int64_t& result)
{
  result = 0;
  if(a == 0)
    return true;
  if(shift < 0 || shift > 62 || absolute_value(a) > (std::int64_t(1) << 62 >> shift))
    return false;
  result = a * (std::int64_t(1) << shift);
  return true;
}

// a - f b
inline std::int64_t difference_with_product(const std::int64_t a, const std::int64_t f,
                                            const std::int64_t b)
{
  return checked_difference(a, checked_product(f, b));
}

// The multiprecision operations are functions of their own, not inlined: as expression templates,
// written where they are needed, they cost seconds to compile.
inline BOOST_NOINLINE Exact_integer product(const Exact_integer& a, const Exact_integer& b)
{
  return Exact_integer(a * b);
}

inline BOOST_NOINLINE Exact_integer difference(const Exact_integer& a, const Exact_integer& b)
{
  return Exact_integer(a - b);
}

inline BOOST_NOINLINE Exact_integer difference_with_product(const Exact_integer& a,
                                                            const Exact_integer& f,
                                                            const Exact_integer& b)
{
  return Exact_integer(a - Exact_integer(f * b));
}

inline BOOST_NOINLINE Exact_integer absolute_value(const Exact_integer& a)
{
  return Exact_integer(CGAL::abs(a));
}

inline std::int64_t greatest_common_divisor(const std::int64_t a, const std::int64_t b)
{
  return std::gcd(a, b);
}

inline BOOST_NOINLINE Exact_integer greatest_common_divisor(const Exact_integer& a,
                                                            const Exact_integer& b)
{
  return CGAL::gcd(a, b);
}

inline std::int64_t exact_quotient(const std::int64_t a, const std::int64_t b) { return a / b; }

inline BOOST_NOINLINE Exact_integer exact_quotient(const Exact_integer& a, const Exact_integer& b)
{
  return CGAL::integral_division(a, b);
}

template <typename Integer>
bool is_unit(const Integer& a)
{
  return a == 1 || a == -1;
}

// The number of bits of |a|; 0 for a = 0.
inline std::size_t bit_length(const std::int64_t a)
{
  std::uint64_t rest = static_cast<std::uint64_t>(a < 0 ? -a : a);
  std::size_t bits = 0;
  for(; rest != 0; rest >>= 1)
    ++bits;
  return bits;
}

inline BOOST_NOINLINE std::size_t bit_length(const Exact_integer& a)
{
  const double size = CGAL::to_double(a);
  if(std::abs(size) < 9007199254740992.) // 2^53
    return bit_length(static_cast<std::int64_t>(size));
  std::size_t bits = 0;
  // A power of two that exceeds |a| is found by doubling its exponent, then by bisection.
  const Exact_integer absolute = CGAL::abs(a);
  std::vector<Exact_integer> powers(1, Exact_integer(2)); // 2^(2^i)
  while(powers.back() <= absolute)
    powers.push_back(Exact_integer(powers.back() * powers.back()));
  Exact_integer lower(1);
  for(std::size_t i = powers.size(); i-- > 0;) {
    const Exact_integer candidate(lower * powers[i]);
    if(candidate <= absolute) {
      lower = candidate;
      bits += std::size_t(1) << i;
    }
  }
  return bits + 1;
}

// 2^62: such integers can be added, and lose nothing in a sign.
constexpr double machine_integer_bound = 4611686018427387904.;

// The integer that is `a`, in a number type that need not take 64 bits.
template <typename Exact, typename Machine_integer>
Exact from_64_bits(const Machine_integer a)
{
  const Machine_integer radix = 2147483648; // both halves are exact as doubles
  return Exact(Exact(Exact(static_cast<double>(a / radix)) * Exact(static_cast<double>(radix))) +
               Exact(static_cast<double>(a % radix)));
}

// Whether |a| <= 2^62: the range of all integers handed on as 64 bits.
inline bool fits_64_bits(const std::int64_t a)
{
  constexpr std::int64_t bound = std::int64_t(1) << 62;
  return -bound <= a && a <= bound;
}

inline BOOST_NOINLINE bool fits_64_bits(const Exact_integer& a)
{
  static const Exact_integer bound(machine_integer_bound);
  return CGAL::abs(a) <= bound;
}

// \pre fits_64_bits(a)
inline BOOST_NOINLINE std::int64_t to_64_bits(const Exact_integer& a)
{
  const Exact_integer radix(2147483648.0); // 2^31: both halves convert to double without rounding
  const Exact_integer high(a / radix);
  const Exact_integer low(a - Exact_integer(high * radix));
  return static_cast<std::int64_t>(CGAL::to_double(high)) * 2147483648LL +
         static_cast<std::int64_t>(CGAL::to_double(low));
}

inline std::int64_t to_64_bits(const std::int64_t a) { return a; }

// 2^exponent
inline BOOST_NOINLINE Exact_integer power_of_two(const std::size_t exponent)
{
  return CGAL::ipower(Exact_integer(2), static_cast<long>(exponent));
}

// How often `a` can be halved.
// \pre a != 0
inline int number_of_halvings(std::int64_t a)
{
  int count = 0;
  for(; a % 2 == 0; ++count)
    a /= 2;
  return count;
}

inline BOOST_NOINLINE int number_of_halvings(Exact_integer a)
{
  std::vector<Exact_integer> powers(1, Exact_integer(2)); // 2^(2^i), as far as they divide a
  while(Exact_integer(a % powers.back()) == 0)
    powers.push_back(Exact_integer(powers.back() * powers.back()));
  int count = 0;
  for(std::size_t i = powers.size() - 1; i-- > 0;)
    if(Exact_integer(a % powers[i]) == 0) {
      a = exact_quotient(a, powers[i]);
      count += 1 << i;
    }
  return count;
}

// \pre `a` can be halved that often
inline std::int64_t halved(const std::int64_t a, const int times)
{
  return a == 0 ? 0 : a / (std::int64_t(1) << times);
}

inline Exact_integer halved(const Exact_integer& a, const int times)
{
  return times == 0 ? a : exact_quotient(a, power_of_two(std::size_t(times)));
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_CHECKED_INTEGER_H
