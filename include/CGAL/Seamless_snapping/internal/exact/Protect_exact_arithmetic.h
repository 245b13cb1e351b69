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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H

#include <CGAL/license/Seamless_snapping.h>

// What the exact computations of this package need of the processor and of the compiler: sums and
// differences of doubles as IEEE 754 defines them. The processor is set to that for the duration of
// each public function; compiler options that break it are refused, while compiling where the
// compiler tells, and by a test at run time elsewhere.

#include <CGAL/FPU.h>

#include <boost/config.hpp>

#include <limits>
#include <stdexcept>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#  error "Seamless_snapping computes exactly, which options like -ffast-math, -Ofast and /fp:fast \
make impossible: compile without them."
#endif

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The bits of the processor by which numbers below the smallest normal one are taken for zero, as
// operands or as results. They are set for the whole process by any library that was linked with
// -ffast-math. None where they are not known; then `is_arithmetic_exact()` tells.
#if defined(CGAL_HAS_SSE2)
constexpr unsigned int flushing_bits = 0x8040;
inline unsigned int control_word() { return _mm_getcsr(); }
inline void set_control_word(const unsigned int word) { _mm_setcsr(word); }
#elif defined(__aarch64__) && defined(__GNUC__)
constexpr unsigned long long flushing_bits = 1ull << 24;
inline unsigned long long control_word()
{
  unsigned long long word;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(word));
  return word;
}
inline void set_control_word(const unsigned long long word)
{
  __asm__ __volatile__("msr fpcr, %0" : : "r"(word));
}
#else
constexpr unsigned int flushing_bits = 0;
inline unsigned int control_word() { return 0; }
inline void set_control_word(unsigned int) { }
#endif

// As long as an object lives, its thread rounds to nearest and keeps numbers of any size; then it
// does as before. Callers may sit inside of interval arithmetic, or of a process that flushes to
// zero. Each public function that computes with coordinates begins with one.
class Protect_exact_arithmetic
{
public:
  Protect_exact_arithmetic()
    : m_to_nearest(CGAL_FE_TONEAREST), m_flushed(control_word() & flushing_bits)
  {
    if(m_flushed != 0)
      set_control_word(control_word() & ~flushing_bits);
  }

  Protect_exact_arithmetic(const Protect_exact_arithmetic&) = delete;
  Protect_exact_arithmetic& operator=(const Protect_exact_arithmetic&) = delete;

  ~Protect_exact_arithmetic()
  {
    if(m_flushed != 0)
      set_control_word(control_word() | m_flushed);
  }

private:
  const CGAL::Protect_FPU_rounding<true> m_to_nearest;
  const decltype(control_word()) m_flushed;
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

// For functions that return no status.
inline void require_exact_arithmetic()
{
  if(!is_arithmetic_exact())
    throw std::runtime_error(inexact_arithmetic_message());
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_PROTECT_EXACT_ARITHMETIC_H
