// What all exact decisions are made of, against rational numbers: differences with their errors,
// transitions, sums, integers with overflow, grids, rows, levels, points of the integer grid, and
// orientations. Numbers are chosen so that rounding matters: neighbors, powers of two, and bounds
// of number types.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>
#include <CGAL/Linear_snapping/internal/exact/exact_sum.h>
#include <CGAL/Linear_snapping/internal/exact/orientation.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/linear/exact_evaluation.h>
#include <CGAL/Quad_remeshing/internal/cells/measure_grid.h>
#include <CGAL/Quad_remeshing/internal/cells/points_in_triangle.h>
#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>

#include "checking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace CGAL::Seamless_snapping::internal;
using Integer = CGAL::Exact_integer;
using Rational = CGAL::Exact_rational;
using Random = std::mt19937_64;

constexpr unsigned int seed = 1;

int below(Random& random, const int n) { return int(random() % std::uint64_t(n)); }

// A few bits, or all; of any sign.
double random_double(Random& random, const int lowest, const int highest)
{
  const double mantissa = static_cast<double>(std::int64_t(random()) >> below(random, 64));
  int exponent = 0;
  const double unit = std::frexp(mantissa, &exponent);
  return std::ldexp(unit, lowest + below(random, highest - lowest + 1));
}

// A neighbor, or the number itself.
double random_neighbor(Random& random, const double x)
{
  const double to[3] = {x, std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  return std::nextafter(x, to[below(random, 3)]);
}

// --- differences and sums ------------------------------------------------------------------------

void test_differences()
{
  Random random(seed);
  std::size_t equal = 0, only_rounded_equal = 0;
  for(int i = 0; i < 20000; ++i) {
    const double a = random_double(random, -30, 30), b = random_double(random, -30, 30);
    const Exact_difference d(a, b);
    const Rational exact(Rational(a) - Rational(b));
    CHECK(Rational(Rational(d.rounded) + Rational(d.error)) == exact);
    // another pair of about the same difference
    const double shift = random_double(random, -30, 30);
    const double c = random_neighbor(random, a + shift), e = random_neighbor(random, b + shift);
    const bool is_equal = Rational(Rational(c) - Rational(e)) == exact;
    CHECK_EQUAL(d == Exact_difference(c, e), is_equal);
    equal += is_equal ? 1 : 0;
    only_rounded_equal += !is_equal && c - e == d.rounded ? 1 : 0;
  }
  CHECK(equal > 100 && only_rounded_equal > 100);
}

// Translations of integer-grid maps: a rounding error makes the difference.
void test_integer_differences()
{
  for(const double x : { -3., 0., 1., 0x1p40 }) {
    CHECK(is_integer(Exact_difference(x, 7)));
    for(const double off : { 0x1p-60, 0.5, 0x1p-1060 })
      CHECK(!is_integer(Exact_difference(x, off)));
  }
}

// Terms that cancel, but for the last bits of some.
void test_sums()
{
  Random random(seed);
  std::size_t zeros = 0, almost_zeros = 0;
  for(int i = 0; i < 20000; ++i) {
    std::array<double, 6> terms{};
    const int pairs = 1 + below(random, 3);
    for(int k = 0; k < pairs; ++k) {
      terms[std::size_t(2 * k)] = random_double(random, -40, 40);
      terms[std::size_t(2 * k + 1)] = -terms[std::size_t(2 * k)];
    }
    if(below(random, 2) == 0) {
      double& x = terms[std::size_t(below(random, 2 * pairs))];
      x = below(random, 4) == 0 ? x + 0x1p-45 : random_neighbor(random, x);
    }
    std::shuffle(terms.begin(), terms.end(), random);
    Rational sum(0);
    for(const double x : terms)
      sum += Rational(x);
    CHECK_EQUAL(exact_sum_is_zero(terms.data(), terms.size()), sum == 0);
    zeros += sum == 0 ? 1 : 0;
    almost_zeros += sum != 0 ? 1 : 0;
  }
  CHECK(zeros > 1000 && almost_zeros > 1000);
}

// --- transitions ---------------------------------------------------------------------------------

using Exact_point = std::array<Rational, 2>;

// By the matrix of one turn, so many times.
Exact_point turned(const Integer_matrix<2>& turn, const int times, Exact_point u)
{
  for(int i = 0; i < times; ++i) {
    const Rational first(turn[0][0] * u[0] + turn[0][1] * u[1]);
    const Rational second(turn[1][0] * u[0] + turn[1][1] * u[1]);
    u = {first, second};
  }
  return u;
}

Exact_point difference(const Uv& b, const Uv& a)
{
  return {Rational(Rational(b[0]) - Rational(a[0])), Rational(Rational(b[1]) - Rational(a[1]))};
}

// Sides of few bits that satisfy a transition, moved by translations and then to neighbors; with
// coordinates of any size up to the largest.
template <typename Group>
void test_transitions(const Integer_matrix<2>& turn, const std::string& name)
{
  Random random(seed);
  std::size_t satisfied = 0, violated = 0, overflows = 0;
  for(int i = 0; i < 20000; ++i) {
    const int turns = below(random, Group::order);
    const auto g = Group::element(turns);
    const int scale = i % 4 == 0 ? 1023 - 7 : below(random, 60) - 30; // differences overflow
    const auto coordinate = [&] { return std::ldexp(double(below(random, 512) - 256), scale); };
    const auto part = [&](const double x) { return std::ldexp(x, -2); };
    const Uv a{coordinate(), coordinate()};
    Uv b{coordinate(), coordinate()}, t{part(coordinate()), part(coordinate())};
    if(!Group::is_signed_permutation)
      b = {a[0] + part(part(b[0])), a[1] + part(part(b[1]))};
    if(i % 4 == 0)
      t = {0, 0};
    const Uv ta = Group::apply(g, a), tb = Group::apply(g, b);
    Edge_sides sides{a, b, {ta[0] + t[0], ta[1] + t[1]}, {tb[0] + t[0], tb[1] + t[1]}};
    if(below(random, 4) != 0) {
      Uv* const points[4] = {&sides.a, &sides.b, &sides.a_opposite, &sides.b_opposite};
      double& x = (*points[below(random, 4)])[std::size_t(below(random, 2))];
      x = random_neighbor(random, x);
    }
    bool is_finite = true;
    for(const Uv& u : {sides.a, sides.b, sides.a_opposite, sides.b_opposite})
      is_finite = is_finite && std::isfinite(u[0]) && std::isfinite(u[1]);
    if(!is_finite)
      continue;
    overflows += Edge_vectors(sides).are_valid() ? 0 : 1;
    bool any = false;
    const Exact_point opposite_side = difference(sides.b_opposite, sides.a_opposite);
    for(int k = 0; k < Group::order; ++k) {
      const bool expected = turned(turn, k, difference(sides.b, sides.a)) == opposite_side;
      if(!CHECK_EQUAL(satisfies_transition<Group>(sides, Group::element(k)), expected))
        std::cerr << "    " << name << ", case " << i << std::endl;
      any = any || expected;
      ++(expected ? satisfied : violated);
    }
    CHECK_EQUAL(satisfies_some_transition<Group>(sides), any);
  }
  CHECK(satisfied > 1000 && violated > 1000);
  CHECK(overflows > 100 || !Group::is_signed_permutation);
}

// --- integers ------------------------------------------------------------------------------------

Integer to_integer(const std::int64_t a) { return from_64_bits<Integer>(a); }

// Beside powers of two and the bounds, and small.
std::int64_t random_integer(Random& random)
{
  const std::int64_t largest = (std::numeric_limits<std::int64_t>::max)();
  std::int64_t a = 0;
  switch(below(random, 4)) {
  case 0: a = largest - below(random, 3); break;
  case 1: a = (std::int64_t(1) << below(random, 63)) + below(random, 3) - 1; break;
  case 2: a = below(random, 10); break;
  default: a = std::int64_t(random() >> (1 + below(random, 63)));
  }
  return below(random, 2) == 0 ? a : -a;
}

// What a function of machine integers returns, or whether it says that it overflows.
template <typename Function>
void check_overflow(const Integer& exact, const Function& f)
{
  static const Integer largest = to_integer((std::numeric_limits<std::int64_t>::max)());
  const bool fits = CGAL::abs(exact) <= largest;
  try {
    const std::int64_t result = f();
    CHECK(fits && to_integer(result) == exact);
  } catch(const Integer_overflow&) {
    CHECK(!fits);
  }
}

void test_integers()
{
  Random random(seed);
  const Integer bound = power_of_two(62);
  for(int i = 0; i < 20000; ++i) {
    const std::int64_t a = random_integer(random), b = random_integer(random);
    const Integer x = to_integer(a), y = to_integer(b);
    check_overflow(Integer(x * y), [&] { return checked_product(a, b); });
    check_overflow(Integer(x - y), [&] { return checked_difference(a, b); });
    const std::int64_t c = random_integer(random);
    std::int64_t sum = c; // may fail where the product alone does not fit
    const bool is_sum = add_product(a, b, sum);
    if(is_sum || fits_64_bits(Integer(x * y)))
      check_overflow(Integer(to_integer(c) + Integer(x * y)), [&] {
        if(!is_sum)
          throw Integer_overflow();
        return sum;
      });
    CHECK_EQUAL(fits_64_bits(a), CGAL::abs(x) <= bound);
    CHECK_EQUAL(fits_64_bits(x), CGAL::abs(x) <= bound);
    if(fits_64_bits(a)) {
      CHECK_EQUAL(to_64_bits(x), a);
      const int shift = below(random, 70) - 3;
      std::int64_t result = 0;
      const bool is_shifted = shifted(a, shift, result);
      const bool fits = a == 0 || (shift >= 0 && Integer(CGAL::abs(x) * power_of_two(
                                                   std::size_t((std::max)(shift, 0)))) <= bound);
      CHECK_EQUAL(is_shifted, fits);
      if(is_shifted && a != 0)
        CHECK(to_integer(result) == Integer(x * power_of_two(std::size_t(shift))));
    }
    // 2^(bits - 1) <= |a| < 2^bits
    CHECK_EQUAL(bit_length(x), bit_length(a));
    const std::size_t bits = bit_length(Integer(x * y));
    CHECK(CGAL::abs(Integer(x * y)) < power_of_two(bits));
    CHECK(bits == 0 || power_of_two(bits - 1) <= CGAL::abs(Integer(x * y)));
    if(a != 0) {
      const std::size_t power = std::size_t(below(random, 100));
      const int halvings = number_of_halvings(a);
      CHECK_EQUAL(number_of_halvings(Integer(x * power_of_two(power))), halvings + int(power));
      CHECK(halved(a, halvings) % 2 != 0 &&
            halved(a, halvings) * (std::int64_t(1) << halvings) == a);
    }
  }
}

// --- grids ---------------------------------------------------------------------------------------

Rational power(const int exponent)
{
  const Rational result(power_of_two(std::size_t(std::abs(exponent))));
  return exponent < 0 ? Rational(Rational(1) / result) : result;
}

template <typename Number>
void test_grids()
{
  Random random(seed);
  const Number_format format = Number_format::of<Number>();
  constexpr std::int64_t bound = std::int64_t(1) << 62;
  for(int i = 0; i < 20000; ++i) {
    const double largest = std::abs(random_double(random, -60, 60));
    const Grid grid = Grid::finest(format, largest);
    if(largest > 0) { // p bits hold it, and half of that size fits a finer grid
      CHECK(std::abs(largest) <= std::ldexp(grid.step(), format.digits));
      CHECK(std::abs(largest) >= std::ldexp(grid.step(), format.digits - 1));
    }
    // on the grid, a number of the type or not
    std::int64_t x = random_integer(random);
    x = (std::min)((std::max)(x, -bound), bound);
    const double value = static_cast<double>(static_cast<Number>(grid.value(x)));
    const Rational exact(Rational(to_integer(x)) * power(grid.exponent()));
    CHECK_EQUAL(grid.is_representable(x), std::isfinite(value) && Rational(value) == exact);

    // to the grid: the whole part, and a rest of at most half a step
    const double u = random_double(random, grid.exponent() - 4, grid.exponent() + 61);
    const Grid_value split = grid.split(u);
    CHECK(Rational((Rational(to_integer(split.base)) + Rational(split.offset)) *
                   power(grid.exponent())) == Rational(u));
    CHECK(std::abs(split.offset) <= 0.5);

    // the nearest number of the type: none is nearer, unless it is as near but for the rounding to
    // the grid before
    Grid_value v{x / 2, std::ldexp(double(below(random, 4096) - 2048), -8)};
    std::int64_t nearest = 0;
    CHECK(grid.nearest(v, nearest) && grid.is_representable(nearest));
    const Rational wanted(Rational(to_integer(v.base)) + Rational(v.offset));
    const Rational distance = CGAL::abs(Rational(wanted - Rational(to_integer(nearest))));
    const std::int64_t gap = std::int64_t(1)
      << (std::max)(0, int(bit_length(nearest)) - format.digits);
    for(const std::int64_t other : {nearest - gap / 2, nearest + gap / 2, nearest - gap,
                                    nearest + gap})
      if(grid.is_representable(other))
        CHECK(distance <= CGAL::abs(Rational(wanted - Rational(to_integer(other)))) +
                            Rational(gap > 1 ? 1 : 0));

    // in other units
    Grid_value w{v.base >> 8, v.offset};
    const Rational before(Rational(to_integer(w.base)) + Rational(w.offset));
    const int shift = below(random, 14) - 6;
    rescale(w, shift);
    CHECK(Rational((Rational(to_integer(w.base)) + Rational(w.offset)) * power(shift)) == before);
  }
}

// --- rows ----------------------------------------------------------------------------------------

// Rows with rational numbers, values that satisfy them, and neighbors of these that do not.
void test_rows()
{
  Random random(seed);
  std::size_t satisfied = 0, violated = 0;
  for(int i = 0; i < 20000; ++i) {
    const int spread = i % 3 == 0 ? 200 : 8;
    std::vector<double> x;
    Entries<Rational> row;
    Rational sum(0);
    for(int j = 0; j < 3; ++j) {
      x.push_back(random_double(random, -spread, spread));
      const Rational a(Rational(below(random, 2001) - 1000) / Rational(1 + below(random, 3)));
      if(a != 0)
        row.push_back({Column_index(j), a});
      sum += a * Rational(x.back());
    }
    System_builder builder(x.size());
    builder.add_row(row, below(random, 8) == 0 ? Rational(sum + power(-300)) : sum);
    const Rational b = below(random, 8) == 0 ? Rational(0) : sum;
    builder.add_row(row, b);
    const Scaled_system scaled = builder.take();
    double& changed = x[std::size_t(below(random, 3))];
    changed = random_neighbor(random, changed);
    Rational now(0);
    for(const auto& e : row)
      now += e.coefficient * Rational(x[std::size_t(e.column)]);
    CHECK_EQUAL(holds(scaled.system, 1, x), now == b);
    CHECK(!holds(scaled.system, 0, x) || now == sum);
    ++(now == b ? satisfied : violated);
  }
  CHECK(satisfied > 1000 && violated > 1000);
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

// --- orientations --------------------------------------------------------------------------------

int exact_orientation(const Uv_triangle& t)
{
  const Exact_point a = difference(t[1], t[0]), b = difference(t[2], t[0]);
  return int(CGAL::sign(Rational(a[0] * b[1] - a[1] * b[0])));
}

// The largest reach for which a triangle surely stays positive, to a thousandth of it.
double largest_sure_reach(const Uv_triangle& t)
{
  double low = 0, high = 1;
  while(high > 1e-12 && low < 0.999 * high) {
    const double middle = (low + high) / 2;
    (is_surely_positive(t, middle) ? low : high) = middle;
  }
  return low;
}

// Triangles that are nearly, or quite, degenerate, or right-angled; and what is sure of those that
// can move.
void test_orientations()
{
  Random random(seed);
  std::size_t degenerate = 0, sure = 0;
  for(int i = 0; i < 20000; ++i) {
    const bool is_short = i % 2 == 0; // numbers of few bits
    const auto number = [&] { return is_short ? double(below(random, 64) - 32) / 64
                                              : double(std::int64_t(random())) * 0x1p-63; };
    const Uv a{number(), number()}, b{number(), number()};
    const double s = double(below(random, 13) - 4) / 4; // on the line through a and b
    Uv c{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
    const double height = below(random, 3) == 0 ? 0 : random_double(random, -40, 0);
    c[std::size_t(below(random, 2))] += height;
    const bool is_right = i % 5 == 0;
    const Uv_triangle t = is_right ? Uv_triangle{{{b[0], a[1]}, a, b}} : Uv_triangle{{a, b, c}};
    CHECK_EQUAL(int(orientation(t)), exact_orientation(t));
    degenerate += exact_orientation(t) == 0 ? 1 : 0;
    if(!is_surely_positive(t, 0))
      continue;
    ++sure;
    CHECK_EQUAL(exact_orientation(t), 1);
    const double reach = largest_sure_reach(t);
    for(int corners = 0; corners < 64; ++corners) { // the worst moves are along both axes
      Uv_triangle moved = t;
      for(std::size_t k = 0; k < 6; ++k)
        moved[k / 2][k % 2] += (corners >> k) % 2 == 0 ? reach : -reach;
      CHECK(exact_orientation(moved) == 1);
    }
  }
  CHECK(degenerate > 1000 && sure > 1000);
}

int main()
{
  std::cout << "random seed " << seed << std::endl;
  test_differences();
  test_integer_differences();
  test_sums();
  test_transitions<Trivial>({{{{1, 0}}, {{0, 1}}}}, "N = 1");
  test_transitions<Half_turns>({{{{-1, 0}}, {{0, -1}}}}, "N = 2");
  test_transitions<Third_turns>({{{{-1, -1}}, {{1, 0}}}}, "N = 3");
  test_transitions<Quarter_turns>({{{{0, -1}}, {{1, 0}}}}, "N = 4");
  test_transitions<Sixth_turns>({{{{0, -1}}, {{1, 1}}}}, "N = 6");
  test_integers();
  test_grids<double>();
  test_grids<float>();
  test_rows();
  test_levels();
  test_lattice_points();
  test_orientations();
  return report_checks();
}
