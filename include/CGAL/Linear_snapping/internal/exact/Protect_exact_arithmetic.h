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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H

#include <CGAL/license/Linear_snapping.h>

// Exact computations need sums, differences, and roundings of doubles as IEEE 754 defines them.
// This sets the processor accordingly for the duration of each public function. Compiler options
// that break it are refused: while compiling if the compiler reveals them, else by a test at run
// time.

#include <boost/config.hpp>

#if defined(__GNUC__) && defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include <cfenv>
#include <limits>
#include <stdexcept>
#include <type_traits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#  error "Seamless_snapping computes exactly, which options like -ffast-math, -Ofast and /fp:fast \
make impossible: compile without them."
#endif

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// As long as an object lives, its thread has the environment that programs start with: it rounds to
// nearest, keeps numbers of any size, and traps nothing. Then it does as before, with the flags
// that were raised before. Callers may sit inside of interval arithmetic, of a process that flushes
// to zero, or of one that wants a signal for each infinity; here infinities are a way to see that a
// number is too large. Each public function that computes with coordinates begins with one.
class Protect_exact_arithmetic
{
public:
  Protect_exact_arithmetic()
  {
    if(m_fast.applies())
      return;
    std::fegetenv(&m_environment);
    std::fesetenv(FE_DFL_ENV);
  }

  Protect_exact_arithmetic(const Protect_exact_arithmetic&) = delete;
  Protect_exact_arithmetic& operator=(const Protect_exact_arithmetic&) = delete;

  ~Protect_exact_arithmetic()
  {
    if(m_fast.applies())
      m_fast.restore_flags();
    else
      std::fesetenv(&m_environment);
  }

private:
  // The library's functions take as long as several steps of an isocurve. Where the environment is
  // the right one already, there is nothing to do but for the flags.
#if defined(__GNUC__) && defined(__x86_64__)
  class Default_environment
  {
  public:
    Default_environment() : m_sse(_mm_getcsr())
    { __asm__ __volatile__("fnstcw %0" : "=m"(m_x87)); }

    bool applies() const { return (m_sse & ~flags) == 0x1f80 && m_x87 == 0x37f; }
    void restore_flags() const { _mm_setcsr(m_sse); }

  private:
    static constexpr unsigned int flags = 0x3f;
    unsigned int m_sse;
    unsigned short m_x87; // says how numbers are printed
  };
#else
  struct Default_environment
  {
    bool applies() const { return false; }
    void restore_flags() const { }
  };
#endif

  const Default_environment m_fast;
  std::fenv_t m_environment;
};

// The rounding error of a - b, by the same operations as `Exact_difference`.
inline double error_of_difference(const double a, const double b)
{
  const double rounded = a - b;
  const double b_part = a - rounded;
  const double a_part = rounded + b_part;
  return (a - a_part) + (b_part - b);
}

// Whether a few operations give what they should. They fail where the compiler reorders sums, keeps
// intermediate results in registers of more bits (-mfpmath=387), or assumes that no number is NaN;
// and where small numbers are flushed to zero on a processor whose bits for that are not known. The
// numbers are volatile, so that the operations take place at run time; and the function is not
// inlined, so that they take place where it is called. To be called while arithmetic is protected.
inline BOOST_NOINLINE bool is_arithmetic_exact()
{
  volatile double large = 1, tie = 0x1p-53, above_tie = 0x1.001p-53, smallest = 0x1p-1074;
  volatile double infinity = std::numeric_limits<double>::infinity();
  const double one = large, half_step = tie, more = above_tie, tiny = smallest;
  const double nan = infinity - infinity, normal = 0x1p-1022;

  const bool errors_are_kept = error_of_difference(one, -half_step) == half_step &&
                               error_of_difference(-half_step, one) == -half_step;
  const double sum = one + more;
  const bool is_rounded_once = sum == 0x1.0000000000001p0;
  const double less = normal - tiny;
  const bool is_nothing_flushed = tiny > 0 && 0 < less && less < normal;
  return errors_are_kept && is_rounded_once && is_nothing_flushed && nan != nan;
}

// For messages.
inline const char* inexact_arithmetic_message()
{
  return "this program does not compute with floating point numbers as IEEE 754 defines it; "
         "compile it without options like -ffast-math, -funsafe-math-optimizations and "
         "-mfpmath=387";
}

// For functions that return no status: throws where arithmetic is not exact.
struct Require_exact_arithmetic
  : public Protect_exact_arithmetic
{
  Require_exact_arithmetic()
  {
    if(!is_arithmetic_exact())
      throw std::runtime_error(inexact_arithmetic_message());
  }
};

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

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H
