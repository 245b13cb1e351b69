// Thousands of random systems through snap_to_linear_constraints(), each compared with the exact
// references: the verdict, the exactness of the result, its distance to the input, and that nothing
// is touched where there is nothing to do or nothing to be done. Then those of the data folder, and
// what is told of long steps.

#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include "checking.h"
#include "exact_reference.h"
#include "interruptions.h"
#include "lattice_reference.h"
#include "random_systems.h"
#include "snap_in_any_form.h"
#include "test_data.h"

#include <Eigen/SparseCore>
#include <unsupported/Eigen/SparseExtra>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <new>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace LS = CGAL::Linear_snapping;

using exact_reference::Optimum;
using exact_reference::Rational;
using exact_reference::Rationals;
using exact_reference::System;
using random_systems::Kind;
using random_systems::Random;
using random_systems::random_integer;
using random_systems::random_real;
using random_systems::Right_hand_side;

// --- what must hold ------------------------------------------------------------------------------

template <typename Number>
bool same_bits(const std::vector<Number>& a, const std::vector<Number>& b)
{
  return a.size() == b.size()
         && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

std::vector<bool> used_columns(const System& system)
{
  std::vector<bool> result(system.columns, false);
  for(const auto& row : system.rows)
    for(const auto& entry : exact_reference::merged(row))
      result[entry.column] = true;
  return result;
}

double step_of(const double largest, const int digits)
{
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1., exponent - digits);
}

// The coarsest grid that may be needed: its step is such that the largest value has all p bits.
// Where the optimum is much smaller than the input, that is the largest value of the output, with 4
// bits to spare.
template <typename Number>
double expected_step(const std::vector<Number>& before, const std::vector<Number>& after,
                     const Optimum& optimum, const std::vector<bool>& used)
{
  double largest_before = 0, largest_after = 0;
  for(std::size_t i = 0; i < before.size(); ++i)
    if(used[i]) {
      largest_before = (std::max)(largest_before, std::abs(double(before[i])));
      largest_after = (std::max)({ largest_after, std::abs(double(after[i])),
                                   std::abs(CGAL::to_double(optimum.x[i])) });
    }
  constexpr int digits = std::numeric_limits<Number>::digits;
  return (std::min)(step_of((std::max)(largest_before, largest_after), digits),
                    8 * step_of(largest_after, digits));
}

struct Tally
{
  std::map<std::string, int> outcomes;
  double largest_excess = 0; // of the squared change over its optimum, relative to what is allowed
};

// The change may exceed the optimum by 1 % and by what the grid costs. The optimum x* is the
// projection of the input, so that the squared change of any solution x is that of x* plus
// |x - x*|^2; and on a grid of step s there is a solution with |x - x*| <= s grid_radius(...).
// Twice that distance is allowed, since the grid may be coarser by one bit, and since the choice of
// free variables, on which the bound depends, is up to the function.
template <typename Number>
void check_distance(const std::vector<Number>& before, const std::vector<Number>& after,
                    const Rationals& weights, const Optimum& optimum, const System& system,
                    const std::vector<exact_reference::Integer_vector>& kernel, Tally& tally)
{
  const Rational change = exact_reference::squared_distance(
    exact_reference::to_rationals(after), exact_reference::to_rationals(before), weights);
  const double excess = CGAL::to_double(Rational(change - optimum.value));
  const double step = expected_step(before, after, optimum, used_columns(system));
  const double grid = 2 * step * exact_reference::grid_radius(kernel, weights).first;
  const double allowed = 0.01 * CGAL::to_double(optimum.value) + grid * grid;
  CHECK(excess >= 0);
  if(!CHECK(excess <= allowed))
    std::cerr << "    excess " << excess << ", optimum " << CGAL::to_double(optimum.value)
              << ", contribution of the grid " << grid * grid << std::endl;
  if(allowed > 0)
    tally.largest_excess = (std::max)(tally.largest_excess, excess / allowed);
}

// Whether a grid that the numbers have holds a solution near the optimum. Otherwise a solution may
// be refused, or be far.
template <typename Number>
bool lies_on_one_grid(const System& system, const Optimum& optimum,
                      const std::vector<exact_reference::Integer_vector>& kernel)
{
  if(std::all_of(system.b.begin(), system.b.end(), [](const Rational& b) { return b == 0; }))
    return true;
  const exact_reference::Dyadic_solvability dyadic = exact_reference::dyadic_solvability(system);
  if(!dyadic.is_solvable)
    return false;
  double largest = 0;
  for(const Rational& value : optimum.x)
    largest = (std::max)(largest, std::abs(CGAL::to_double(value)));
  const double step = std::ldexp(1., -dyadic.bits);
  const double reach = largest + step * exact_reference::grid_radius(kernel, Rationals()).second;
  return reach <= std::ldexp(step, std::numeric_limits<Number>::digits);
}

// Figures are rounded, the violation in each of its terms.
template <typename Number>
void check_figures(const LS::Linear_report& report, const System& system,
                   const std::vector<Number>& before, const std::vector<Number>& after)
{
  constexpr double precision = 1e-12;
  const Rationals xbar = exact_reference::to_rationals(before);
  double violation = 0, terms = 0, extent = 0, change = 0;
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    const Rational residual = exact_reference::residual(system, r, xbar);
    violation = (std::max)(violation, std::abs(CGAL::to_double(residual)));
    double sum = 0;
    for(const auto& [column, coefficient] : system.rows[r])
      sum += std::abs(CGAL::to_double(coefficient) * double(before[column]));
    terms = (std::max)(terms, sum);
  }
  const std::vector<bool> used = used_columns(system);
  for(std::size_t i = 0; i < used.size(); ++i)
    if(used[i]) {
      extent = (std::max)(extent, std::abs(double(before[i])));
      change = (std::max)(change, std::abs(double(after[i]) - double(before[i])));
    }
  if(!CHECK(std::abs(report.violation_before - violation) <=
            precision * violation + precision * precision * terms))
    std::cerr << "    violation " << report.violation_before << ", not " << violation << std::endl;
  CHECK_EQUAL(report.extent, extent);
  CHECK(std::abs(report.largest_change - change) <= precision * change);
}

template <typename Number>
void check_system(Random& random, const System& system, const std::vector<Number>& before,
                  const std::vector<double>& weights, bool with_quadratic_program, Tally& tally)
{
  const Rationals xbar = exact_reference::to_rationals(before);
  const Rationals exact_weights = exact_reference::to_rationals(weights);
  const Optimum optimum = exact_reference::optimum_in_closed_form(system, xbar, exact_weights);
  if(with_quadratic_program) {
    const Optimum other =
      exact_reference::optimum_by_quadratic_program(system, xbar, exact_weights);
    CHECK_EQUAL(other.feasible, optimum.feasible);
    CHECK(other.value == optimum.value);
  }

  std::vector<Number> after = before;
  const LS::Linear_report report =
    snap_in_any_form::snap(random, system, after, weights);
  ++tally.outcomes[LS::to_string(report.status)];
  const bool was_exact = exact_reference::exactly_satisfies(system, before);
  CHECK_EQUAL(report.status == LS::Outcome::INCONSISTENT, !optimum.feasible);
  CHECK_EQUAL(report.status == LS::Outcome::ALREADY_EXACT, was_exact);
  if(!report || was_exact)
    CHECK(same_bits(before, after));
  if(report.status == LS::Outcome::INCONSISTENT)
    CHECK(exact_reference::is_contradiction(system, report.certificate));
  if(!optimum.feasible || was_exact)
    return;

  const auto kernel = exact_reference::kernel_vectors(system);
  if(!report) {
    CHECK(report.status == LS::Outcome::NOT_REPRESENTABLE);
    const bool is_far = report.message.find("would move more than 10^") != std::string::npos;
    CHECK(is_far || !lies_on_one_grid<Number>(system, optimum, kernel));
    return;
  }
  CHECK(exact_reference::exactly_satisfies(system, after));
  check_figures(report, system, before, after);
  const std::vector<bool> used = used_columns(system);
  for(std::size_t i = 0; i < used.size(); ++i)
    if(!used[i])
      CHECK(before[i] == after[i]);
  if(lies_on_one_grid<Number>(system, optimum, kernel))
    check_distance(before, after, exact_weights, optimum, system, kernel, tally);
}

// --- the runs ------------------------------------------------------------------------------------

// Values that violate the constraints by noise of some size: the projection of a random point,
// rounded, and moved at random.
template <typename Number>
std::vector<Number> values_near_a_solution(Random& random, const System& system, bool is_near)
{
  const double magnitude = std::ldexp(1., random_integer(random, -20, 20));
  const double noise =
    magnitude * std::ldexp(1., -random_integer(random, 4, std::numeric_limits<Number>::digits));
  Rationals point;
  for(std::size_t c = 0; c < system.columns; ++c)
    point.push_back(Rational(magnitude * random_real(random)));
  if(is_near) {
    const Optimum projection = exact_reference::optimum_in_closed_form(system, point);
    if(projection.feasible)
      point = projection.x;
  }
  std::vector<Number> result;
  for(const Rational& value : point)
    result.push_back(Number(CGAL::to_double(value) + noise * random_real(random)));
  return result;
}

template <typename Number>
void test_random_system(std::uint64_t seed, std::size_t largest, Tally& tally)
{
  Random random(seed);
  const Kind kind = Kind(random() % std::uint64_t(Kind::number_of_kinds));
  const Right_hand_side rhs = random_systems::random_right_hand_side(random);
  const std::size_t columns = 1 + random() % largest;
  const std::size_t most_rows = random() % 2 == 0 ? columns : columns / 2 + 1;
  const std::size_t rows = 1 + random() % most_rows;
  System system = random_systems::random_homogeneous_system(random, kind, columns, rows);
  const bool redundant_first = random() % 2 == 0; // then right-hand sides may contradict
  if(redundant_first)
    random_systems::add_redundant_rows(random, system, random_integer(random, 0, 2));
  random_systems::set_right_hand_side(random, rhs, system);
  if(!redundant_first)
    random_systems::add_redundant_rows(random, system, random_integer(random, 0, 3));

  std::vector<Number> values =
    values_near_a_solution<Number>(random, system, random() % 4 != 0);
  if(random() % 4 == 0) { // of another size than the right-hand sides
    const int exponent = random_integer(random, -60, 60);
    for(Number& value : values)
      value = std::ldexp(value, exponent);
  }
  if(random() % 8 == 0) // an outlier
    values[random() % columns] = std::ldexp(Number(1), random_integer(random, 20, 80));
  std::vector<double> weights(columns, 1.);
  if(random() % 2 == 0)
    for(double& weight : weights)
      weight = std::ldexp(double(random_integer(random, 1, 3)), random_integer(random, -3, 3));
  const std::size_t failed = checking::counts().failed;
  check_system(random, system, values, weights, columns <= 40, tally);
  if(failed != checking::counts().failed)
    std::cerr << "    seed " << seed << ", " << columns << " unknowns, kind " << int(kind)
              << ", right-hand side " << int(rhs) << ", " << 8 * sizeof(Number) << " bits"
              << std::endl;
}

void print(const std::string& name, const Tally& tally)
{
  std::cout << name << ":";
  for(const auto& outcome : tally.outcomes)
    std::cout << "  " << outcome.first << " " << outcome.second;
  std::cout << ", largest excess over the optimum " << tally.largest_excess << " of what is allowed"
            << std::endl;
}

template <typename Number>
void test_random_systems(const std::string& name, std::uint64_t first_seed, int count,
                         std::size_t largest)
{
  Tally tally;
  count = test_data::trials(count);
  for(int i = 0; i < count; ++i)
    test_random_system<Number>(first_seed + std::uint64_t(i), largest, tally);
  print(name + ", seeds " + std::to_string(first_seed) + " to "
          + std::to_string(first_seed + std::uint64_t(count) - 1),
        tally);
}

exact_reference::Integer random_long_integer(Random& random, int bits)
{
  exact_reference::Integer result(1);
  for(int i = 1; i < bits; ++i)
    result = exact_reference::Integer(result * 2) + static_cast<int>(random() % 2);
  return random() % 2 == 0 ? result : exact_reference::Integer(-result);
}

// Coefficients and right-hand sides of hundreds of digits, and more rows than unknowns: the one
// solution must come back from values close to it; with another right-hand side there is none. In
// `chain` the coefficients get long during the elimination only.
void test_long_numbers(std::uint64_t seed, int bits, bool chain)
{
  Random random(seed);
  const std::size_t columns = 2 + random() % 5;
  System system;
  system.columns = columns;
  for(std::size_t r = 0; r < columns; ++r) {
    exact_reference::Row row;
    for(std::size_t c = 0; c < columns; ++c)
      if(!chain || c == r || c == (r + 1) % columns)
        row.push_back({ c, chain && c == r ? Rational(1)
                                           : Rational(random_long_integer(random, bits)) });
    system.add_row(row);
  }
  random_systems::add_redundant_rows(random, system, 2);
  std::vector<double> solution, x;
  for(std::size_t c = 0; c < columns; ++c) {
    solution.push_back(random_integer(random, -1000000, 1000000) / 1024.);
    x.push_back(solution.back() + 1e-3 * random_real(random));
  }
  const Rationals exact_solution = exact_reference::to_rationals(solution);
  for(std::size_t r = 0; r < system.rows.size(); ++r)
    system.b[r] = exact_reference::residual(system, r, exact_solution) + system.b[r];

  const std::vector<double> before = x;
  const auto snap = [&] {
    x = before;
    return LS::snap_to_linear_constraints(snap_in_any_form::linear_constraints<Rational>(system),
                                          x);
  };
  const LS::Linear_report report = snap();
  const std::size_t failed = checking::counts().failed;
  CHECK(bool(report));
  CHECK(report.linear_solver.multiprecision);
  CHECK(report.linear_solver.coefficient_bits >=
        std::size_t(chain ? 129 : bits - 30)); // rows may have a common factor
  CHECK(x == solution);

  system.b.back() += Rational(1) / Rational(random_long_integer(random, bits));
  const LS::Linear_report contradiction = snap();
  CHECK(contradiction.status == LS::Outcome::INCONSISTENT);
  CHECK(exact_reference::is_contradiction(system, contradiction.certificate));
  CHECK(same_bits(x, before));
  if(failed != checking::counts().failed)
    std::cerr << "    long numbers, seed " << seed << ", " << bits << " bits: " << report << "; "
              << contradiction << std::endl;
}

// --- particular systems --------------------------------------------------------------------------

template <typename Constraints, typename Values>
LS::Linear_report snap_and_check(const std::string& name,
                                 const Constraints& constraints,
                                 Values& x,
                                 const System& system)
{
  const Values before = x;
  const LS::Linear_report report = LS::snap_to_linear_constraints(constraints, x);
  const bool is_exact = exact_reference::exactly_satisfies(system, x);
  if(!CHECK_EQUAL(bool(report), is_exact) || !CHECK(bool(report) || same_bits(before, x)))
    std::cerr << "    " << name << ": " << report << std::endl;
  return report;
}

// One row per element: terms, and the right-hand side.
using Rows = std::vector<std::pair<std::vector<std::pair<std::size_t, Rational> >, Rational> >;

// Must succeed, with values close to those that are expected.
template <typename Number>
LS::Linear_report test_rows(const std::string& name, const Rows& rows, std::vector<Number> x,
                            const std::vector<double>& expected, const double relative)
{
  System system;
  system.columns = x.size();
  LS::Linear_constraints<Rational> constraints(x.size());
  for(const auto& [terms, b] : rows) {
    exact_reference::Row row;
    for(const auto& [column, coefficient] : terms)
      row.push_back({column, coefficient});
    system.add_row(row);
    system.b.back() = b;
    constraints.add_constraint(terms, b);
  }
  const LS::Linear_report report = snap_and_check(name, constraints, x, system);
  bool is_close = bool(report);
  for(std::size_t i = 0; i < x.size(); ++i)
    is_close = is_close && std::abs(double(x[i]) - expected[i]) <= relative * std::abs(expected[i]);
  if(!CHECK(is_close)) {
    std::cerr << "    " << name << ": " << report << "; ";
    for(const Number value : x)
      std::cerr << " " << value;
    std::cerr << std::endl;
  }
  return report;
}

// Parts that share no unknown are snapped as if they were alone, also if they are equal, or equal
// but for coefficients, right-hand sides, or a weight.
void test_parts(const std::uint64_t seed)
{
  constexpr std::size_t n = 6, number_of_parts = 12;
  Random random(seed);
  System system = random_systems::random_homogeneous_system(random, Kind(seed % 3), n, 3);
  random_systems::set_right_hand_side(random, Right_hand_side(seed % 2), system);
  LS::Linear_constraints<Rational> whole(n * number_of_parts);
  std::vector<double> x, all_weights, expected;
  for(std::size_t k = 0; k < number_of_parts; ++k) {
    LS::Linear_constraints<Rational> part(n);
    std::vector<double> weights(n, 1.), values;
    weights.back() = 2; // the largest of each part: it is what weights are scaled by
    if(k % 4 == 3)
      weights.front() = 1.5;
    for(std::size_t i = 0; i < system.rows.size(); ++i) {
      std::vector<std::pair<std::size_t, Rational> > terms;
      for(const auto& entry : system.rows[i])
        terms.emplace_back(entry.column, entry.coefficient * Rational(k % 4 == 1 ? i + 2 : 1));
      if(k % 4 == 1 && !terms.empty())
        terms.front().second += 1;
      const Rational b = system.b[i] + Rational(k % 4 == 2 ? 3 : 0);
      part.add_constraint(terms, b);
      for(auto& term : terms)
        term.first += n * k;
      whole.add_constraint(terms, b);
    }
    for(std::size_t j = 0; j < n; ++j)
      values.push_back(8 * random_real(random));
    x.insert(x.end(), values.begin(), values.end());
    all_weights.insert(all_weights.end(), weights.begin(), weights.end());
    if(!LS::snap_to_linear_constraints(part, values, LS::parameters::value_weights(weights)))
      return; // so is the whole
    expected.insert(expected.end(), values.begin(), values.end());
  }
  LS::snap_to_linear_constraints(whole, x, LS::parameters::value_weights(all_weights));
  if(!CHECK(same_bits(x, expected)))
    std::cerr << "    parts, seed " << seed << std::endl;
}

// Right-hand sides much smaller or larger than the values, or of parts of the system only.
void test_right_hand_sides_of_other_sizes()
{
  const double close = 1e-14;
  test_rows<double>("two parts", {{{{0, 1}, {1, -1}}, 0x1p-40}, {{{2, 1}, {3, -1}}, 0}},
                    {1, 2, 3, 4}, {1.5, 1.5, 3.5, 3.5}, 1e-9);
  test_rows<double>("small pin", {{{{0, 1}}, 1e-6}}, {0.5}, {1e-6}, 0);
  test_rows<double>("small difference", {{{{0, 1}, {1, -1}}, 1e-6}}, {0.5, -0.5}, {5e-7, -5e-7},
                    1e-9);
  test_rows<double>("smaller pin", {{{{0, 1}}, 0.1}}, {1000}, {0.1}, 0);
  test_rows<double>("smallest pin", {{{{0, 1}}, 1e-30}}, {1}, {1e-30}, 0);
  test_rows<double>("large pin", {{{{0, 1}}, 1e19}}, {1.1e19}, {1e19}, 0);
  test_rows<double>("larger pin", {{{{0, 1}}, 1e300}}, {1}, {1e300}, 0);
  test_rows<double>("pin of 0", {{{{0, 1}}, 1e300}}, {0}, {1e300}, 0);
  test_rows<float>("float", {{{{0, 1}, {1, -1}}, 1e8}}, {1e8f, 3.f}, {1e8, 1.5}, 4);
  test_rows<double>("powers", {{{{0, 1}, {1, -1}}, 0x1p60}}, {0x1p60 + 256, 100}, {0x1p60, 178},
                    0.5);
  test_rows<double>("both", {{{{0, 1}}, 1e-300}, {{{1, 1}}, 1e300}}, {1, 1}, {1e-300, 1e300}, 0);
  test_rows<double>("sum of both", {{{{0, 1}}, 0x1p-30}, {{{0, 1}, {1, 1}}, 0x1p20}}, {1, 1},
                    {0x1p-30, 0x1p20}, close);
}

// One value much larger than the optimum: the others must not be rounded to multiples of its ulp.
void test_outliers()
{
  const double close = 1e-14;
  const Rows pin_of_outlier = {{{{0, 1}}, 0}, {{{0, 1}, {1, 1}, {2, -1}}, 0}};
  test_rows<double>("outlier", pin_of_outlier, {1e20, .3, .3}, {0, .3, .3}, close);
  test_rows<double>("small outlier", pin_of_outlier, {1e10, .3, .3}, {0, .3, .3}, close);
  test_rows<double>("large outlier", pin_of_outlier, {-1e300, 1e280, 1e280},
                    {0, 1e280, 1e280}, close);
  test_rows<float>("outlier, float", pin_of_outlier, {1e20f, .5f, .5f}, {0, .5, .5}, 1e-6);
  test_rows<double>("outlier and right-hand side",
                    {{{{0, 1}}, 0.25}, {{{0, 1}, {1, 1}, {2, -1}}, 0}}, {1e20, .125, .375},
                    {.25, .125, .375}, close);

  LS::Linear_constraints<> constraints(2);
  constraints.add_constraint({{0, 1}, {1, -1}});
  std::vector<double> x = {1e20, 1};
  const std::vector<double> weights = {1e-30, 1};
  CHECK(
      bool(LS::snap_to_linear_constraints(constraints, x, LS::parameters::value_weights(weights))));
  CHECK(x[0] == x[1] && std::abs(x[0] - (1 + 1e-10)) < close);
}

// Projections that no floating point number holds, and a system too large to try them for long.
void test_projection_beyond_range()
{
  const std::size_t n = 30000;
  LS::Linear_constraints<Rational> chain(n);
  for(std::size_t i = 0; i + 1 < n; ++i)
    chain.add_constraint({{i, 1}, {i + 1, -1}}, i == n / 2 ? 1e-300 : 0.);
  std::vector<double> x(n, 1);
  CHECK(LS::snap_to_linear_constraints(chain, x).status == LS::Outcome::NOT_REPRESENTABLE);
}

// Products and sums that exceed the range of the number type, though there are solutions within.
void test_large_numbers()
{
  const Rational huge(std::ldexp(1., 600)), tiny(std::ldexp(1., -600));
  test_rows<double>("1e300 to 1", {{{{0, 1e300}, {1, -1}}, 0}}, {1, 1}, {0, 0}, 0);
  test_rows<double>("2^1200", {{{{0, huge}, {1, -tiny}}, 0}}, {1, 1}, {0, 0}, 0);
  test_rows<double>("large value", {{{{0, 1}}, 0.1}}, {1e300}, {0.1}, 0);
  test_rows<double>("three", {{{{0, 1}, {1, -1}, {2, -1}, {3, -1}}, 0}},
                    {1.797e308, 9.4e307, 9.4e307, 9.4e307},
                    {1.797e308, 6e307, 6e307, 6e307}, 0.1);
  test_rows<double>("two", {{{{0, 1}, {1, -1}, {2, -1}}, 0}}, {1.7e308, 1.7e308, 1.7e308},
                    {1.797e308, 0.9e308, 0.9e308}, 0.01);
  test_rows<float>("two, float", {{{{0, 1}, {1, -1}, {2, -1}}, 0}}, {3.4e38f, 3.4e38f, 3.4e38f},
                   {3.4e38, 1.7e38, 1.7e38}, 0.01);
}

// Images of equal logarithm whose doubled rests exceed 64 bits, in the lattice.
void test_large_images()
{
  const std::int64_t large = std::int64_t(1) << 62, half = large / 2;
  LS::Linear_constraints<> constraints(5);
  constraints.add_constraint({{0, 1}, {1, -1}});
  constraints.add_constraint({{2, 1}, {3, -1}});
  constraints.add_constraint({{3, 1}, {4, -1}});
  constraints.add_constraint({{0, large}, {1, large - 5}, {2, large}, {3, half}, {4, half - 9}});
  System system;
  system.columns = 5;
  for(std::size_t i = 0; i < constraints.number_of_constraints(); ++i) {
    exact_reference::Row row;
    for(auto term = constraints.begin(i); term != constraints.end(i); ++term)
      row.push_back({term->first, Rational(static_cast<long>(term->second))});
    system.add_row(row);
  }
  std::vector<double> x = {1, 2, 3, 4, 5};
  CHECK(bool(snap_and_check("large images", constraints, x, system)));
}

// 2 x0 = x1 in the types that coefficients may have.
template <typename Coefficient>
void test_coefficient_type(const std::string& name)
{
  System system;
  system.columns = 2;
  system.add_row({{0, 2}, {1, 3}});
  LS::Linear_constraints<Coefficient> constraints(2);
  constraints.add_constraint({{0, Coefficient(2)}, {1, Coefficient(3)}});
  std::vector<double> x = {1, 2};
  CHECK(bool(snap_and_check(name, constraints, x, system)));
  Eigen::SparseMatrix<Coefficient> matrix(1, 2);
  matrix.insert(0, 0) = Coefficient(2);
  matrix.insert(0, 1) = Coefficient(3);
  std::vector<float> y = {1, 2};
  CHECK(bool(snap_and_check(name, matrix, y, system)));
  const std::vector<long long> b = {1};
  CHECK(bool(LS::snap_to_linear_constraints(matrix, b, y)));
  CHECK(2. * y[0] + 3. * y[1] == 1); // in double, which holds the products
}

// Expressions of matrices, and arrays of C.
void test_forms_of_arguments()
{
  Eigen::SparseMatrix<int> transposed(2, 1);
  transposed.insert(0, 0) = 1;
  transposed.insert(1, 0) = -3;
  double x[] = { 0.3, 0.1 };
  const double b[] = { 0.5 }, weights[] = { 1, 1 };
  const auto np = LS::parameters::value_weights(std::vector<double>(weights, weights + 2));
  CHECK(bool(LS::snap_to_linear_constraints(transposed.transpose(), b, x, np)));
  CHECK(Rational(x[0]) - 3 * Rational(x[1]) == Rational(b[0]));
  CHECK(bool(LS::snap_to_linear_constraints(transposed.transpose() * 2, x)));
  CHECK(Rational(x[0]) == 3 * Rational(x[1]));
}

void test_figures()
{
  LS::Linear_report report =
    test_rows<double>("violation", {{{{0, 0.25}, {1, -0.75}}, 0}}, {3 + 1e-7, 1}, {3, 1}, 1e-6);
  CHECK(report.violation_before > 2.4e-8 && report.violation_before < 2.6e-8);
  report =
      test_rows<double>("coefficient", {{{{0, 1}, {1, -1000}}, 0}}, {1000, 1.5}, {1000, 1}, 0.5);
  CHECK_EQUAL(report.linear_solver.largest_coefficient, 1000.);
  CHECK(report.optimal_rms_change > 0 &&
        report.optimal_rms_change <= report.rms_change * (1 + 1e-9));

  LS::Linear_constraints<> constraints(2);
  constraints.add_constraint({{0, 1}, {1, -1}});
  for(const std::vector<double>& weights :
      {std::vector<double>{1e300, 1e-320}, {1e-320, 1e-320}, {1e308, 1e308}, {1, 1}}) {
    std::vector<double> x = {1, 2};
    CHECK(bool(
        LS::snap_to_linear_constraints(constraints, x, LS::parameters::value_weights(weights))));
    CHECK(x[0] == x[1] && x[0] == (weights[0] == weights[1] ? 1.5 : 1.));
  }
}

bool contains(const LS::Linear_report& report, const std::string& words)
{
  const bool result = report.message.find(words) != std::string::npos;
  if(!result)
    std::cerr << "    \"" << words << "\" is missing in: " << report << std::endl;
  return result;
}

// The messages name the place.
void test_refusals()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> x = {1, 2, 4, 5};
  const auto snap = [&](const auto&... arguments)
  {
    const std::vector<double> before = x;
    const LS::Linear_report report = LS::snap_to_linear_constraints(arguments..., x);
    CHECK(same_bits(before, x));
    return report;
  };
  LS::Linear_constraints<double> constraints(4);
  constraints.add_constraint({{0, 1.}, {1, -1.}});
  constraints.add_constraint({{2, 1.}, {3, 1.}});
  CHECK(contains(snap(constraints, std::vector<double>{0, infinity}), "constraint 1 "));
  CHECK(contains(snap(constraints, std::vector<double>{0}), "2"));
  constraints.add_constraint({{1, 1.}, {3, nan}});
  CHECK(contains(snap(constraints), "unknown 3 in constraint 2 "));

  LS::Linear_constraints<> no_solution(4);
  no_solution.add_constraint({{0, 1}, {1, -1}}, 1);
  no_solution.add_constraint({{2, 1}, {3, -1}});
  no_solution.add_constraint({{2, 1}, {3, 2}}, 1);
  const LS::Linear_report report = snap(no_solution);
  CHECK(report.status == LS::Outcome::NOT_REPRESENTABLE);
  CHECK(contains(report, "constraints 2 to "));
}

// A number that throws when it is copied, if asked to.
struct Fragile
{
  Fragile() = default;
  Fragile(const Fragile&) { if(throws) throw std::bad_alloc(); }
  Fragile& operator=(const Fragile&) = default;
  static bool throws;
};
bool Fragile::throws = false;

template <typename Exception, typename F>
bool throws(const F& f)
{
  try {
    f();
  } catch(const Exception&) {
    return true;
  }
  return false;
}

// Constraints that can't be added leave nothing behind.
void test_adding_constraints()
{
  LS::Linear_constraints<> constraints(2);
  for(const double b : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    CHECK(throws<std::invalid_argument>([&] { constraints.add_constraint({{0, 1}}, b); }));
    const std::vector<std::pair<std::size_t, std::int64_t> > terms = {{1, 1}};
    CHECK(throws<std::invalid_argument>([&] { constraints.add_constraint(terms, float(b)); }));
  }
  CHECK_EQUAL(constraints.number_of_constraints(), 0u);
  constraints.add_constraint({{0, 1}}, 0.1f);
  constraints.add_constraint({{0, 1}}, std::int64_t(9007199254740993)); // 2^53 + 1
  CHECK(constraints.right_hand_side(0) == Rational(double(0.1f)));
  CHECK(constraints.right_hand_side(1) - Rational(9007199254740992.) == 1);

  LS::Linear_constraints<Fragile> fragile(3);
  const std::vector<std::pair<std::size_t, Fragile> > row(3);
  fragile.add_constraint(row);
  for(int i = 0; i < 3; ++i) { // whether or not there is room
    Fragile::throws = true;
    CHECK(throws<std::bad_alloc>([&] { fragile.add_constraint(row); }));
    Fragile::throws = false;
    CHECK_EQUAL(fragile.add_constraint(row), std::size_t(i) + 1);
    CHECK_EQUAL(fragile.end(std::size_t(i) + 1) - fragile.begin(std::size_t(i) + 1), 3);
  }
}

// Systems that are large in one respect only; with a test that is slow otherwise.
void test_many_rows()
{
  LS::Linear_constraints<> repeated(102);
  for(std::size_t i = 0; i < 50000; ++i)
    repeated.add_constraint({{i % 100, 1}, {(i + 1 + i / 100 % 50) % 100, -1}});
  repeated.add_constraint({{0, 2}, {100, 3}, {101, 5}}, 1);
  std::vector<double> x(102, 1.);
  const LS::Linear_report report = LS::snap_to_linear_constraints(repeated, x);
  CHECK(report.status == LS::Outcome::SNAPPED);
  CHECK_EQUAL(report.linear_solver.number_of_redundant_constraints, 50001u - 100u);
  CHECK_EQUAL(report.linear_solver.number_of_non_unit_pivots, 1u);

  const std::size_t n = 30000;
  LS::Linear_constraints<> halvings(n);
  for(std::size_t i = 0; i + 1 < n; ++i)
    halvings.add_constraint({{i, 1}, {i + 1, -1}}, i == n / 2 ? 1e-300 : 1.);
  x.assign(n, 1.);
  CHECK(LS::snap_to_linear_constraints(halvings, x).status ==
        LS::Outcome::NOT_REPRESENTABLE);
}

// x_i - x_j = b; must be refused, with a certificate of some size.
struct Difference { std::size_t i, j; long b; };

void test_contradiction(const std::size_t columns, const std::vector<Difference>& differences,
                        const std::size_t size)
{
  System system;
  system.columns = columns;
  LS::Linear_constraints<> constraints(columns);
  for(const Difference& d : differences) {
    constraints.add_constraint({{d.i, 1}, {d.j, -1}}, d.b);
    system.add_row({{d.i, 1}, {d.j, -1}});
    system.b.back() = d.b;
  }
  std::vector<double> x(columns, 1.);
  const LS::Linear_report report = LS::snap_to_linear_constraints(constraints, x);
  CHECK(report.status == LS::Outcome::INCONSISTENT);
  CHECK(exact_reference::is_contradiction(system, report.certificate));
  CHECK_EQUAL(report.certificate.size(), size);
}

// Where it takes all rows, where many share an unknown, and where most have nothing to do with it.
void test_large_contradictions()
{
  const std::size_t n = 30000;
  std::vector<Difference> loop, star, double_star;
  for(std::size_t i = 1; i < n; ++i) {
    loop.push_back({i - 1, i, long(i % 7)});
    star.push_back({0, i, 0});
    double_star.push_back({0, i, 0});
    double_star.push_back({i, 0, 0});
  }
  loop.push_back({n - 1, 0, 1});
  star.push_back({1, 2, 1});
  double_star.push_back({1, 2, 1});
  test_contradiction(n, loop, n);
  test_contradiction(n, star, 3);
  test_contradiction(n, double_star, 3);
}

// --- files ---------------------------------------------------------------------------------------

// Seam systems and random ones of thousands of unknowns: for the references they are too big.
void test_file(const std::string& path)
{
  Eigen::SparseMatrix<double> matrix;
  if(!CHECK(Eigen::loadMarket(matrix, path)))
    return;
  Random random(std::uint64_t(matrix.rows()));
  std::vector<double> x(std::size_t(matrix.cols()));
  for(double& value : x)
    value = random_real(random);
  const LS::Linear_report report = LS::snap_to_linear_constraints(matrix, x);
  CHECK(bool(report));

  Rationals sums(std::size_t(matrix.rows()), Rational(0));
  for(Eigen::Index c = 0; c < matrix.cols(); ++c)
    for(Eigen::SparseMatrix<double>::InnerIterator entry(matrix, c); entry; ++entry)
      sums[std::size_t(entry.row())] += Rational(entry.value()) * Rational(x[std::size_t(c)]);
  CHECK(std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 0; }));
  if(path.find("seams_") != std::string::npos) {
    CHECK(report.rms_change <= 1.01 * report.optimal_rms_change);
    if(path.find("connections") == std::string::npos)
      CHECK_EQUAL(report.linear_solver.number_of_non_unit_pivots, 0u);
  }
  std::cout << std::filesystem::path(path).filename().string() << ": " << report << ", "
            << report.linear_solver.coefficient_bits << " bits" << std::endl;
}

// A lattice of a hundred dimensions, made of numbers that exceed 64 bits, takes many minutes. It is
// reduced where that time is asked for.
bool takes_long(const std::string& path)
{
  return path.find("random_560x700_8") != std::string::npos && !test_data::are_tests_long();
}

void test_files()
{
  for(const auto& path : test_data::further_files("systems", ".mtx"))
    if(takes_long(path.string()))
      checking::skip(path.filename().string() + ", as SEAMLESS_SNAPPING_LONG_TESTS is not set");
    else
      test_file(path.string());
}

// Who is told what.
void test_signs_of_life()
{
  using CGAL::Linear_snapping::internal::Progress;
  using CGAL::Linear_snapping::internal::Step_timer;
  namespace parameters = CGAL::Linear_snapping::parameters;
  struct { std::vector<std::pair<std::string, double> > step_times; } report;
  std::vector<std::string> all, others;
  const auto visitor = [](auto& texts) { return [&](const std::string& text)
                                         { texts.push_back(text); }; };
  const auto tell = [](const std::string& text) { Progress::tell([&] { return text; }); };
  const auto strip = [](const auto& np) { return CGAL::Linear_snapping::internal::strip(np); };
  tell("nobody");
  {
    const Progress progress(strip(parameters::visitor(visitor(all)).verbose(true)));
    tell("one");
    Progress::tell_each_second([] { return std::string("too soon"); });
    {
      const Progress same(strip(parameters::default_values()));
      tell("two");
      const Progress other(strip(parameters::visitor(visitor(others)).tolerance(1.)));
      tell("three");
    }
    tell("four");
    Step_timer timer(report);
    timer.finish("outer");
    timer.finish("outer"); // again
    {
      Step_timer inner(report);
      inner.finish("inner, and short");
    }
  }
  tell("nobody again");
  CHECK(all.size() == 4 && all.back().find("outer: ") == 0 && all.back().back() == 's');
  all.pop_back();
  CHECK(all == std::vector<std::string>({"one", "two", "four"}));
  CHECK(others == std::vector<std::string>({"three"}));
  CHECK_EQUAL(report.step_times.size(), std::size_t(2));

  struct Counter { int calls = 0; void operator()(const std::string&) { ++calls; } } counter;
  const Progress by_reference(strip(parameters::visitor(std::ref(counter))));
  tell("by reference");
  CHECK_EQUAL(counter.calls, 1);

  std::ostringstream os;
  std::streambuf* const before = std::cerr.rdbuf(os.rdbuf());
  {
    const Progress verbose(strip(parameters::verbose(true)));
    tell("to the error stream");
  }
  std::cerr.rdbuf(before);
  CHECK_EQUAL(os.str(), "  to the error stream\n");
}

// Sparse, dense, and of several grids.
void test_interruptions()
{
  namespace LS = CGAL::Linear_snapping;
  using Kind_of_system = std::array<unsigned int, 3>;
  for(const auto& [unknowns, terms, least] : {Kind_of_system{300, 3, 1}, {30, 20, 2}, {3, 3, 2}}) {
    std::mt19937 random(unknowns);
    LS::Linear_constraints<> c(unknowns);
    std::vector<double> before(unknowns);
    for(double& x : before)
      x = double(random() % 1000) / 1000;
    for(std::size_t i = 0; i < unknowns / 3; ++i) {
      std::vector<std::pair<std::size_t, std::int64_t> > row;
      for(std::size_t k = 0; k < terms; ++k)
        row.emplace_back(random() % unknowns, std::int64_t(least + random() % 9));
      c.add_constraint(row);
    }
    std::vector<double> x;
    interruptions::test(std::to_string(unknowns) + " unknowns", [&](const auto& visitor) {
      x = before;
      return bool(LS::snap_to_linear_constraints(c, x, LS::parameters::visitor(visitor)));
    }, [&] { return x == before; });
  }
}

int main(int argc, char** argv)
{
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : 1;
  for(std::uint64_t i = 0; i < 60; ++i)
    test_parts(seed + i);
  test_right_hand_sides_of_other_sizes();
  test_outliers();
  test_projection_beyond_range();
  test_large_numbers();
  test_large_images();
  test_coefficient_type<short>("short");
  test_coefficient_type<unsigned int>("unsigned int");
  test_coefficient_type<unsigned long long>("unsigned long long");
  test_coefficient_type<long long>("long long");
  test_coefficient_type<float>("float");
  test_coefficient_type<double>("double");
  test_coefficient_type<Rational>("rational");
  test_forms_of_arguments();
  test_figures();
  test_refusals();
  test_adding_constraints();
  test_many_rows();
  test_large_contradictions();
  test_random_systems<double>("up to 4 unknowns", seed, 600, 4);
  test_random_systems<float>("up to 4 unknowns, float", seed + 10000, 400, 4);
  test_random_systems<double>("up to 12 unknowns", seed + 20000, 900, 12);
  test_random_systems<float>("up to 12 unknowns, float", seed + 30000, 400, 12);
  test_random_systems<double>("up to 40 unknowns", seed + 40000, 100, 40);
  test_random_systems<double>("up to 120 unknowns", seed + 50000, 10, 120);
  for(const int bits : { 70, 140, 400, 1200 })
    for(std::uint64_t i = 0; i < 10; ++i) {
      test_long_numbers(seed + 60000 + i, bits, false);
      test_long_numbers(seed + 70000 + i, bits, true);
    }
  test_files();
  test_signs_of_life();
  test_interruptions();
  return report_checks();
}
