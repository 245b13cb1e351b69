// The guard of floating point arithmetic: rounding modes, flushing to zero, traps and flags are set
// aside and come back, and a program that was compiled with options that break exact differences is
// told from one that was not. And pairs of doubles are rounded to float as single ones are, which
// compilers may not do. package_tests.cmake compiles this file with each of them, at each level of
// optimization and with many options; it returns 3 where the arithmetic is refused.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>

#include "checking.h"
#include "floating_point_traps.h"

#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

using namespace CGAL::Linear_snapping::internal;

void test_rounding_modes()
{
  for(const int mode : { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO }) {
    std::fesetround(mode);
    const bool is_exact_alone = is_arithmetic_exact();
    bool is_exact = false;
    {
      const Protect_exact_arithmetic protect;
      is_exact = is_arithmetic_exact();
    }
    const bool is_restored = std::fegetround() == mode;
    std::fesetround(FE_TONEAREST);
    CHECK(!is_exact_alone && is_exact && is_restored);
  }
}

// Numbers below the smallest normal one are zero as results (0x8000) or as operands (0x0040).
void test_flushing()
{
#if defined(__GNUC__) && defined(__x86_64__) // as in the guard
  for(const unsigned int flushing : { 0x8000u, 0x0040u, 0x8040u }) {
    const unsigned int normal = _mm_getcsr();
    _mm_setcsr(normal | flushing);
    const bool is_exact_alone = is_arithmetic_exact();
    bool is_exact = false;
    {
      const Protect_exact_arithmetic protect;
      const Protect_exact_arithmetic once_more;
      is_exact = is_arithmetic_exact();
    }
    const bool is_restored = (_mm_getcsr() & 0xffc0u) == ((normal | flushing) & 0xffc0u);
    _mm_setcsr(normal);
    CHECK(!is_exact_alone && is_exact && is_restored);
  }
#else
  checking::skip("flushing to zero, as it is not known how to set it on this processor");
#endif
}

volatile double huge = (std::numeric_limits<double>::max)(), zero = 0;

// Neither flags that are raised inside nor their absence are seen outside.
void test_flags()
{
  for(const int before : { 0, FE_DIVBYZERO }) {
    std::feclearexcept(FE_ALL_EXCEPT);
    std::feraiseexcept(before);
    double product = 0;
    bool is_clear = false;
    {
      const Protect_exact_arithmetic protect;
      product = huge * huge;
      is_clear = is_arithmetic_exact();
    }
    const int after = std::fetestexcept(FE_ALL_EXCEPT);
    CHECK(is_clear && product > huge);
    CHECK_EQUAL(after, before);
  }
  std::feclearexcept(FE_ALL_EXCEPT);
}

// Outside, what trapped before traps again, and not for what has happened inside.
void test_traps()
{
#ifdef __GLIBC__
  const Floating_point_traps traps;
  const int enabled = fegetexcept();
  double sum = 0;
  bool is_exact = false;
  {
    const Protect_exact_arithmetic protect;
    is_exact = is_arithmetic_exact();
    sum = huge * huge + 1 / zero;
    sum += zero / zero;
    CHECK_EQUAL(fegetexcept(), 0);
  }
  const double harmless = huge / 2 + 1;
  CHECK_EQUAL(fegetexcept(), enabled);
  CHECK(is_exact && sum != sum && harmless < huge);
#else
  checking::skip("traps, as it is not known how to enable them here");
#endif
}

bool is_refused()
{
  const Protect_exact_arithmetic protect;
  try {
    const Require_exact_arithmetic required;
  } catch(const std::runtime_error&) {
    return !is_arithmetic_exact();
  }
  CHECK(is_arithmetic_exact());
  return false;
}

using Pair = std::array<double, 2>;

// How the coordinates of a point are rounded all over the package.
Pair rounded(const Pair& u)
{
  return {{rounded_to<float>(u[0]), rounded_to<float>(u[1])}};
}

// Called through this pointer the function is compiled by itself: the fault shows only there.
Pair (*volatile call_rounded)(const Pair&) = rounded;

// Without a conversion: the result is a float, and the floats beside it are farther away.
bool is_nearest_float(const double x, const double y)
{
  const float f = static_cast<float>(y);
  if(static_cast<double>(f) != y)
    return false;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const double below = std::nextafter(f, -infinity), above = std::nextafter(f, infinity);
  return std::abs(x - y) <= std::abs(x - below) && std::abs(x - y) <= std::abs(x - above);
}

void test_rounding_to_float()
{
  const unsigned int seed = 20260101;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t number_of_failures = 0;
  for(int i = 0; i < 100000; ++i) {
    const double scale = std::ldexp(1., i % 60 - 30);
    const Pair u{{scale * uniform(random), scale * uniform(random)}};
    const Pair r = call_rounded(u);
    for(std::size_t c = 0; c < 2; ++c)
      if(!is_nearest_float(u[c], r[c]) || rounded_to<double>(u[c]) != u[c])
        ++number_of_failures;
  }
  CHECK_IN("seed " + std::to_string(seed), number_of_failures == 0);
}

int main()
{
  if(is_refused()) {
    std::cout << inexact_arithmetic_message() << std::endl;
    return 3;
  }
  test_rounding_modes();
  test_flushing();
  test_flags();
  test_traps();
  test_rounding_to_float();
  return report_checks();
}
