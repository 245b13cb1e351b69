// The guard of floating point arithmetic: rounding modes and flushing to zero are set aside and
// come back, and a program that was compiled with options that break exact differences is told from
// one that was not. package_tests.cmake compiles this file with many options; it returns 3 where
// the arithmetic is refused.

#include <CGAL/Seamless_snapping/internal/exact/Protect_exact_arithmetic.h>

#include "checking.h"

#include <stdexcept>

using namespace CGAL::Seamless_snapping::internal;

void test_rounding_modes()
{
  for(const auto mode : { CGAL_FE_UPWARD, CGAL_FE_DOWNWARD, CGAL_FE_TOWARDZERO }) {
    CGAL::FPU_set_cw(CGAL::FPU_CW_t(mode));
    const bool is_exact_alone = is_arithmetic_exact();
    bool is_exact = false;
    {
      const Protect_exact_arithmetic protect;
      is_exact = is_arithmetic_exact();
    }
    const bool is_restored = CGAL::FPU_get_cw() == CGAL::FPU_CW_t(mode);
    CGAL::FPU_set_cw(CGAL_FE_TONEAREST);
    CHECK(!is_exact_alone && is_exact && is_restored);
  }
}

// Numbers below the smallest normal one are zero as results (0x8000) or as operands (0x0040).
void test_flushing()
{
#ifdef CGAL_HAS_SSE2
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

bool is_refused()
{
  const Protect_exact_arithmetic protect;
  try {
    require_exact_arithmetic();
  } catch(const std::runtime_error&) {
    return !is_arithmetic_exact();
  }
  CHECK(is_arithmetic_exact());
  return false;
}

int main()
{
  if(is_refused()) {
    std::cout << inexact_arithmetic_message() << std::endl;
    return 3;
  }
  test_rounding_modes();
  test_flushing();
  return report_checks();
}
