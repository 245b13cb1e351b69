// Pairs of doubles are rounded to float as single ones are. Compilers may not: package_tests.cmake
// compiles this file with each of them, at each level of optimization.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>

using CGAL::Linear_snapping::internal::rounded_to;
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

int main()
{
  const unsigned int seed = 20260101;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int number_of_checks = 0, number_of_failures = 0;
  for(int i = 0; i < 100000; ++i) {
    const double scale = std::ldexp(1., i % 60 - 30);
    const Pair u{{scale * uniform(random), scale * uniform(random)}};
    const Pair r = call_rounded(u);
    for(std::size_t c = 0; c < 2; ++c, ++number_of_checks)
      if(!is_nearest_float(u[c], r[c]) || rounded_to<double>(u[c]) != u[c])
        if(++number_of_failures <= 5)
          std::cerr << "seed " << seed << ": " << u[c] << " became " << r[c] << "\n";
  }
  std::cout << number_of_checks << " checks, " << number_of_failures << " failures\n";
  return number_of_failures == 0 ? 0 : 1;
}
