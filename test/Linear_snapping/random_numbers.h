// Random numbers for exact tests: of few bits or all, and neighbors of numbers; and points in
// rational numbers.

#ifndef SEAMLESS_SNAPPING_TEST_RANDOM_NUMBERS_H
#define SEAMLESS_SNAPPING_TEST_RANDOM_NUMBERS_H

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace random_numbers {

using Integer = CGAL::Exact_integer;
using Rational = CGAL::Exact_rational;
using Random = std::mt19937_64;

inline int below(Random& random, const int n) { return int(random() % std::uint64_t(n)); }

// A few bits, or all; of any sign.
inline double random_double(Random& random, const int lowest, const int highest)
{
  const double mantissa = static_cast<double>(std::int64_t(random()) >> below(random, 64));
  int exponent = 0;
  const double unit = std::frexp(mantissa, &exponent);
  return std::ldexp(unit, lowest + below(random, highest - lowest + 1));
}

// A neighbor, or the number itself.
inline double random_neighbor(Random& random, const double x)
{
  const double to[3] = {x, std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  return std::nextafter(x, to[below(random, 3)]);
}

using Exact_point = std::array<Rational, 2>;

template <typename Point>
Exact_point difference(const Point& b, const Point& a)
{
  return {Rational(Rational(b[0]) - Rational(a[0])), Rational(Rational(b[1]) - Rational(a[1]))};
}

} // namespace random_numbers

#endif // SEAMLESS_SNAPPING_TEST_RANDOM_NUMBERS_H
