// Levels of isocurves, and points of the integer grid in edges and triangles, against rational
// numbers and integers.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include "checking.h"
#include "random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <set>

using namespace CGAL::Quad_remeshing::internal;
using namespace random_numbers;

constexpr unsigned int seed = 1;

// Translations of integer-grid maps: a rounding error makes the difference.
void test_integer_differences()
{
  for(const double x : { -3., 0., 1., 0x1p40 }) {
    CHECK(is_integer(Exact_difference(x, 7)));
    for(const double off : { 0x1p-60, 0.5, 0x1p-1060 })
      CHECK(!is_integer(Exact_difference(x, off)));
  }
}

// --- levels --------------------------------------------------------------------------------------

// Against rational numbers. Coordinates of very different magnitude make levels outgrow two
// doubles.
void test_levels()
{
  Random random(seed);
  const auto any_number = [&](const int spread) {
    return std::ldexp(double(std::int64_t(random())) * 0x1p-63, below(random, spread));
  };
  bool all_agree = true;
  for(int spread : {1, 60, 300})
    for(int run = 0; run < 200; ++run) {
      Rational expected(any_number(spread));
      if(run % 4 == 0)
        expected /= 3;
      Exact_level level(expected);
      for(int step = 0; step < 10; ++step) {
        const double a = any_number(spread), b = any_number(spread);
        const int sign = random() % 2 == 0 ? 1 : -1;
        level.transform(sign, Exact_difference(a, b));
        expected = Rational(sign) * expected + Rational(a) - Rational(b);
        const double rounded = CGAL::to_double(expected);
        for(const double u :
            {rounded, std::nextafter(rounded, 1e300), std::nextafter(rounded, -1e300), a})
          all_agree = all_agree &&
                      level.side_of(u) == int(CGAL::compare(Rational(u), expected));
        all_agree = all_agree && level.exact() == expected && level == Exact_level(expected);
      }
    }
  CHECK(all_agree);
}

// --- points of the grid in edges and triangles ---------------------------------------------------

// Coordinates are multiples of 1/8, so that integers of 64 bits tell the truth.
void test_lattice_points()
{
  Random random(seed);
  std::size_t wrong = 0, number = 0;
  for(int run = 0; run < 4000; ++run) {
    std::array<std::array<long, 2>, 3> t;
    Uv_triangle uv;
    const long offset = run % 3 == 0 ? (1l << 40) : 0, unit = run % 2 == 0 ? 8 : 1;
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t c = 0; c < 2; ++c) {
        t[k][c] = 8 * offset + unit * (long(random() % 60) - 30);
        uv[k][c] = double(t[k][c]) / 8;
      }
    const auto side = [&](const std::size_t i, const std::size_t j, const long x, const long y) {
      return (t[j][0] - t[i][0]) * (8 * y - t[i][1]) - (t[j][1] - t[i][1]) * (8 * x - t[i][0]);
    };
    std::set<std::array<double, 2> > inside, on_edge;
    const bool is_positive = side(0, 1, 0, 0) + side(1, 2, 0, 0) + side(2, 0, 0, 0) > 0;
    for(long x = offset - 40; x <= offset + 40; ++x)
      for(long y = offset - 40; y <= offset + 40; ++y) {
        if(is_positive && side(0, 1, x, y) > 0 && side(1, 2, x, y) > 0 && side(2, 0, x, y) > 0)
          inside.insert({double(x), double(y)});
        const auto along = [&](const std::size_t k) {
          return (t[1][0] - t[0][0]) * (8 * x - t[k][0]) + (t[1][1] - t[0][1]) * (8 * y - t[k][1]);
        };
        if(side(0, 1, x, y) == 0 && along(0) > 0 && along(1) < 0)
          on_edge.insert({double(x), double(y)});
      }
    std::multiset<std::array<double, 2> > found_inside, found_on_edge;
    if(is_positive)
      for_lattice_points_inside(uv, [&](const Uv& p)
                                              { found_inside.insert(p); });
    if(t[0] != t[1])
      for_lattice_points_on_edge(uv[0], uv[1], [&](const Uv& p)
                                               { found_on_edge.insert(p); });
    wrong += std::equal(inside.begin(), inside.end(), found_inside.begin(), found_inside.end())
               ? 0 : 1;
    wrong += std::equal(on_edge.begin(), on_edge.end(), found_on_edge.begin(), found_on_edge.end())
               ? 0 : 1;
    number += inside.size() + on_edge.size();
  }
  CHECK_EQUAL(wrong, std::size_t(0));
  CHECK(number > 10000);
}

int main()
{
  std::cout << "random seed " << seed << std::endl;
  test_integer_differences();
  test_levels();
  test_lattice_points();
  return report_checks();
}
