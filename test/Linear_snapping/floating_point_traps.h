// As long as an object lives, invalid operations, divisions by zero, and overflows of floating
// point numbers end the program. Hosts may run so; no function of the package may fail for it.

#ifndef SEAMLESS_SNAPPING_TEST_FLOATING_POINT_TRAPS_H
#define SEAMLESS_SNAPPING_TEST_FLOATING_POINT_TRAPS_H

#include <cfenv>

class Floating_point_traps
{
public:
  Floating_point_traps()
  {
    std::fegetenv(&m_environment);
#ifdef __GLIBC__ // elsewhere nothing traps
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
  }

  ~Floating_point_traps() { std::fesetenv(&m_environment); }

  Floating_point_traps(const Floating_point_traps&) = delete;
  Floating_point_traps& operator=(const Floating_point_traps&) = delete;

private:
  std::fenv_t m_environment;
};

#endif // SEAMLESS_SNAPPING_TEST_FLOATING_POINT_TRAPS_H
