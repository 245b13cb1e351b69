// What all exact decisions are made of, against rational numbers: differences with their errors,
// sums, integers with overflow, grids, rows, and orientations. Numbers are chosen so that rounding
// matters: neighbors, powers of two, and bounds of number types. And the messages of refusals.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>

#include "checking.h"
#include "random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

using namespace CGAL::Linear_snapping::internal;
using namespace random_numbers;

constexpr unsigned int seed = 1;

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

// --- orientations --------------------------------------------------------------------------------

int rational_orientation(const Uv_triangle& t)
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
    CHECK_EQUAL(int(orientation(t)), rational_orientation(t));
    degenerate += rational_orientation(t) == 0 ? 1 : 0;
    if(!is_surely_positive(t, 0))
      continue;
    ++sure;
    CHECK_EQUAL(rational_orientation(t), 1);
    const double reach = largest_sure_reach(t);
    for(int corners = 0; corners < 64; ++corners) { // the worst moves are along both axes
      Uv_triangle moved = t;
      for(std::size_t k = 0; k < 6; ++k)
        moved[k / 2][k % 2] += (corners >> k) % 2 == 0 ? reach : -reach;
      CHECK(rational_orientation(moved) == 1);
    }
  }
  CHECK(degenerate > 1000 && sure > 1000);
}

// --- messages ------------------------------------------------------------------------------------

// A message in words of C++, and in others, with other numbers.
void test_messages()
{
  using CGAL::Linear_snapping::Message;
  const Message message = "the edge between " + name_of_vertex(3, "vertices") + " and " +
                          name_of_vertex(4, "") + " of " + name_of_face(5) + ", for " +
                          term("a_name") + " 6" + remedy("call it()") + remedy("or not");
  const std::string place = "the edge between vertices 3 and 4 of face 5, for ";
  CHECK_EQUAL(message.str(), place + "a_name 6; call it(); or not");
  const auto words = [](const Message::Part& part)
    { return part.words == "a_name" ? "--name" : part.words == "call it()" ? "" : part.words; };
  const auto number = [](const Message::Part& part)
    { return part.index + (part.kind == Message::VERTEX ? 10 : 20); };
  CHECK_EQUAL(message.str(words, number),
              "the edge between vertices 13 and 14 of face 25, for --name 6; or not");
  Message other = message.without_remedies();
  other.renumber(Message::FACE, [](const std::size_t f) { return f + 1; });
  CHECK_EQUAL(other.str(), "the edge between vertices 3 and 4 of face 6, for a_name 6");
  CHECK(Message("").empty() && remedy("first").str() == "first" && !message.empty());
  CHECK(message.find("face 5") != Message::npos && other.find("call") == Message::npos);
}

int main()
{
  std::cout << "random seed " << seed << std::endl;
  test_differences();
  test_sums();
  test_integers();
  test_grids<double>();
  test_grids<float>();
  test_rows();
  test_orientations();
  test_messages();
  return report_checks();
}
