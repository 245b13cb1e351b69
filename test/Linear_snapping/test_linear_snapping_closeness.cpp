// How close snap_to_linear_constraints() comes, and whether it finds a solution wherever there is
// one near by: systems that make rounding errors grow, unknowns that many rows share, coefficients
// of many bits, values of mixed scale. Each is compared with a reference that shares nothing with
// the package.
//
//   test_linear_snapping_closeness [NUMBER [SEED]]
//
// runs NUMBER random small systems instead of a few thousand.

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include "checking.h"
#include "exact_reference.h"
#include "floating_point_traps.h"
#include "grid_reference.h"
#include "random_systems.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace LS = CGAL::Linear_snapping;

using exact_reference::Integer;
using exact_reference::Rational;
using grid_reference::Small_system;
using random_systems::Random;
using random_systems::random_integer;
using random_systems::random_real;
using Constraints = LS::Linear_constraints<>;
using Values = std::vector<double>;

template <typename Coefficient>
bool is_solution(const LS::Linear_constraints<Coefficient>& c, const Values& x)
{
  for(std::size_t i = 0; i < c.number_of_constraints(); ++i) {
    Rational sum = -c.right_hand_side(i);
    for(auto term = c.begin(i); term != c.end(i); ++term)
      sum += Rational(term->second) * Rational(x[term->first]);
    if(sum != 0)
      return false;
  }
  return true;
}

double largest_difference(const Values& a, const Values& b)
{
  double result = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    result = (std::max)(result, std::abs(a[i] - b[i]));
  return result;
}

// Snaps, and tells how far the values moved; and how long that took, which is not checked.
template <typename Coefficient>
LS::Linear_report snap(const std::string& name, const LS::Linear_constraints<Coefficient>& c,
                       Values& x)
{
  const Values before(x);
  const auto start = std::chrono::steady_clock::now();
  const LS::Linear_report report = LS::snap_to_linear_constraints(c, x);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::cout << name << ": " << report << ", largest change " << largest_difference(before, x)
            << ", optimal rms " << report.optimal_rms_change << ", " << time.count() << " s"
            << std::endl;
  if(CHECK(bool(report)))
    CHECK(is_solution(c, x));
  return report;
}

// --- rounding errors that grow from row to row ---------------------------------------------------

// The harmonic functions of a k x k grid, by their five-point stencils, at noise of 1e-9.
void test_laplace_grid(const int k, const unsigned int seed)
{
  Random random(seed);
  Constraints c(std::size_t(k * k));
  Values x;
  for(int i = 0; i < k; ++i)
    for(int j = 0; j < k; ++j) {
      const std::size_t center = std::size_t(i * k + j), width = std::size_t(k);
      x.push_back(double(i * i - j * j) / double(k * k) + 1e-9 * random_real(random));
      if(i > 0 && i + 1 < k && j > 0 && j + 1 < k)
        c.add_constraint({{center, 4}, {center - 1, -1}, {center + 1, -1}, {center - width, -1},
                          {center + width, -1}});
    }
  const Values before(x);
  snap("Laplace grid, k = " + std::to_string(k), c, x);
  CHECK(largest_difference(before, x) < 1e-8);
}

// --- few unknowns more than rows -----------------------------------------------------------------

// Each row has an unknown that no later row has, and up to three later unknowns at random.
// Elimination keeps these rows, but the matrix of their products fills in. The reference is dense.
// Without free unknowns, 0 is the only solution.
void test_few_free_unknowns(const std::size_t number_of_rows, const std::size_t number_free,
                            const unsigned int seed)
{
  Random random(seed);
  const std::size_t n = number_of_rows + number_free;
  Constraints c(n);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(number_of_rows), Eigen::Index(n));
  for(std::size_t i = 0; i < number_of_rows; ++i) {
    std::map<std::size_t, std::int64_t> row{{i, 1}};
    while(row.size() < (std::min)(std::size_t(4), n - i))
      row[i + 1 + random() % (n - i - 1)] = random() % 2 == 0 ? 1 : -1;
    c.add_constraint({row.begin(), row.end()});
    for(const auto& [column, coefficient] : row)
      rows(Eigen::Index(i), Eigen::Index(column)) = double(coefficient);
  }
  Values x(n);
  for(double& value : x)
    value = random_real(random);
  const Eigen::VectorXd before = Eigen::Map<const Eigen::VectorXd>(x.data(), Eigen::Index(n));
  snap("few free unknowns, seed " + std::to_string(seed), c, x);
  Eigen::VectorXd optimum = Eigen::VectorXd::Zero(before.size());
  if(number_free > 0)
    optimum = before - rows.transpose() * (rows * rows.transpose()).ldlt().solve(rows * before);
  CHECK(largest_difference(x, Values(optimum.data(), optimum.data() + n)) < 1e-9);
}

// --- equations that fill in ----------------------------------------------------------------------

// Four unknowns at random in each row: in any order, the products of rows fill in.
Constraints random_sparse_constraints(const std::size_t n, Random& random)
{
  constexpr std::array<std::int64_t, 3> coefficients{-1, 1, 2};
  Constraints c(n);
  for(std::size_t i = 0; i < n / 2; ++i) {
    std::map<std::size_t, std::int64_t> row;
    while(row.size() < 4)
      row[random() % n] = coefficients[random() % 3];
    c.add_constraint({row.begin(), row.end()});
  }
  return c;
}

// The nearest solution is the one whose distance from the values is a combination of rows.
void test_fill_in(const std::size_t n, const unsigned int seed)
{
  Random random(seed);
  const Constraints c = random_sparse_constraints(n, random);
  Values x(n);
  for(double& value : x)
    value = random_real(random);
  Eigen::VectorXd change = Eigen::Map<const Eigen::VectorXd>(x.data(), Eigen::Index(n));
  const LS::Linear_report report =
    snap("fill-in, " + std::to_string(n) + ", seed " + std::to_string(seed), c, x);
  CHECK(report.rms_change <= 1.01 * report.optimal_rms_change);
  change -= Eigen::Map<const Eigen::VectorXd>(x.data(), Eigen::Index(n));
  Eigen::SparseMatrix<double> rows(Eigen::Index(n), Eigen::Index(c.number_of_constraints()));
  for(std::size_t i = 0; i < c.number_of_constraints(); ++i)
    for(auto term = c.begin(i); term != c.end(i); ++term)
      rows.insert(Eigen::Index(term->first), Eigen::Index(i)) = double(term->second);
  const Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double> > combination(rows);
  const Eigen::VectorXd multipliers = combination.solve(change);
  CHECK((change - rows * multipliers).norm() <= 1e-9 * change.norm());
}

// Weights of all sizes make the rows nearly dependent, so that iterations converge slowly.
void test_fill_in_with_weights(const std::size_t n, const unsigned int seed)
{
  Random random(seed);
  const Constraints c = random_sparse_constraints(n, random);
  Values x(n), weights(n);
  for(std::size_t j = 0; j < n; ++j) {
    x[j] = random_real(random);
    weights[j] = std::ldexp(1., int(random() % 100));
  }
  const Values before(x);
  const LS::Linear_report report =
    LS::snap_to_linear_constraints(c, x, LS::parameters::value_weights(weights));
  std::cout << "fill-in with weights, seed " << seed << ": " << report << std::endl;
  CHECK_EQUAL(report.status, LS::Outcome::TOO_LARGE);
  CHECK(report.message.find("link so many unknowns") != std::string::npos);
  CHECK(x == before);
}

// --- refinements ---------------------------------------------------------------------------------

// Each row has an unknown that only later levels use, as 8 f = a + 6 b + c: an elimination by the
// coefficients 1 would make coefficients of hundreds of bits. Rows and unknowns come in any order.
void test_refinement(const unsigned int seed, const std::size_t coarse, const std::size_t of_level,
                     const bool has_right_hand_sides)
{
  constexpr std::size_t levels = 3;
  Random random(seed);
  std::vector<std::size_t> column(coarse + levels * of_level);
  std::iota(column.begin(), column.end(), std::size_t(0));
  std::shuffle(column.begin(), column.end(), random);
  Values solution(column.size());
  for(std::size_t j = 0; j < coarse; ++j)
    solution[column[j]] = random_real(random);
  std::vector<std::pair<std::vector<std::pair<std::size_t, std::int64_t> >, double> > rows;
  for(std::size_t j = coarse; j < column.size(); ++j) {
    const std::size_t earlier = coarse + (j - coarse) / of_level * of_level;
    const std::int64_t factor =
      std::array<std::int64_t, 4>{{2, 4, 8, has_right_hand_sides ? 2 : 3}}[random() % 4];
    std::map<std::size_t, std::int64_t> terms;
    for(std::int64_t i = 0; i < factor; ++i)
      --terms[column[random() % earlier]];
    const double b = has_right_hand_sides ? std::ldexp(double(random() % 9), -8) : 0;
    double sum = b;
    for(const auto& [k, a] : terms)
      sum -= double(a) * solution[k];
    solution[column[j]] = sum / double(factor);
    rows.push_back({{terms.begin(), terms.end()}, b});
    rows.back().first.emplace_back(column[j], factor);
  }
  std::shuffle(rows.begin(), rows.end(), random);
  LS::Linear_constraints<Rational> c(column.size());
  for(const auto& [terms, b] : rows)
    c.add_constraint(std::vector<std::pair<std::size_t, Rational> >(terms.begin(), terms.end()),
                     Rational(b));
  Values x(solution);
  for(double& v : x)
    v += 1e-9 * random_real(random);
  const LS::Linear_report report =
    snap("refinement of " + std::to_string(column.size()) + ", seed " + std::to_string(seed), c, x);
  CHECK(report && report.distance_ratio < 10);
  CHECK(largest_difference(solution, x) < 1e-8);
  CHECK(report.linear_solver.coefficient_bits < 40);
}

// --- unknowns that many rows share ---------------------------------------------------------------

// All equal the first one: the optimum is the mean.
void test_hub(const std::size_t n)
{
  Constraints c(n);
  for(std::size_t j = 1; j < n; ++j)
    c.add_constraint({{0, 1}, {j, -1}});
  Values x(n, 0.);
  x[0] = 1;
  const LS::Linear_report report = snap("hub of " + std::to_string(n), c, x);
  const double mean = 1. / static_cast<double>(n);
  CHECK(std::abs(x[0] - mean) <= 1e-9 * mean);
  const double rms = std::sqrt((1 - mean) * mean);
  CHECK(std::abs(report.optimal_rms_change - rms) <= 0.01 * rms);
}

// Two of them, which the rows also link to each other.
void test_two_hubs(const std::size_t n)
{
  Constraints c(2 * n);
  for(std::size_t j = 1; j < n; ++j) {
    c.add_constraint({{0, 1}, {2 * j, -1}});
    c.add_constraint({{1, 2}, {0, -1}, {2 * j + 1, -1}});
  }
  Values x(2 * n, 0.);
  x[0] = 1;
  x[1] = 1;
  snap("two hubs of " + std::to_string(n), c, x);
  // min (a-1)^2 + (n-1) a^2 + (b-1)^2 + (n-1) (2b-a)^2
  const double r = static_cast<double>(n - 1);
  const double aa = 1 + 2 * r, ab = -2 * r, bb = 1 + 4 * r, determinant = aa * bb - ab * ab;
  CHECK(std::abs(x[0] - (bb - ab) / determinant) < 1e-9);
  CHECK(std::abs(x[1] - (aa - ab) / determinant) < 1e-9);
}

// --- coefficients of many bits -------------------------------------------------------------------

std::int64_t random_coefficient(Random& random, const int bits)
{
  const std::int64_t largest = std::int64_t(1) << bits;
  return std::int64_t(random() % std::uint64_t(2 * largest + 1)) - largest;
}

// A row that few integers of a knapsack satisfy.
void test_knapsack_row(const std::size_t n, const int bits, const unsigned int seed)
{
  Random random(seed);
  Constraints c(n);
  std::vector<Constraints::Term> row;
  Values x;
  for(std::size_t j = 0; j < n; ++j) {
    row.emplace_back(j, random_coefficient(random, bits));
    x.push_back(random_real(random));
  }
  c.add_constraint(row);
  const LS::Linear_report report = snap("row of " + std::to_string(n), c, x);
  CHECK(report.rms_change <= 1.01 * report.optimal_rms_change);
}

// Rows that are nearly parallel: the second is the first but for small changes.
void test_nearly_parallel_rows(const std::size_t n, const int bits, const unsigned int seed)
{
  Random random(seed);
  Constraints c(n);
  exact_reference::System system;
  system.columns = n;
  std::vector<Constraints::Term> first, second;
  exact_reference::Row first_row, second_row;
  Values x;
  for(std::size_t j = 0; j < n; ++j) {
    const std::int64_t a = random_coefficient(random, bits);
    const std::int64_t b = a + random_integer(random, -1, 1);
    first.emplace_back(j, a);
    second.emplace_back(j, b);
    first_row.push_back({j, Rational(a)});
    second_row.push_back({j, Rational(b)});
    x.push_back(random_real(random));
  }
  c.add_constraint(first);
  c.add_constraint(second);
  system.add_row(first_row);
  system.add_row(second_row);
  const exact_reference::Optimum optimum =
    exact_reference::optimum_in_closed_form(system, exact_reference::to_rationals(x));
  const LS::Linear_report report =
    snap("parallel rows of " + std::to_string(n) + ", " + std::to_string(bits) + " bits", c, x);
  const double rms = std::sqrt(CGAL::to_double(optimum.value) / static_cast<double>(n));
  if(!CHECK(std::abs(report.optimal_rms_change - rms) <= 0.01 * rms))
    std::cout << "  the optimum is " << rms << std::endl;
  CHECK(report.rms_change <= 10 * rms);
}

// --- solutions that are not on the grid of the largest value -------------------------------------

void test_found(const std::string& name, const std::size_t n,
                const std::vector<std::pair<std::vector<Constraints::Term>, double> >& rows,
                const Values& values, const double largest_change)
{
  std::vector<std::size_t> order(n);
  for(std::size_t j = 0; j < n; ++j)
    order[j] = j;
  do { // whatever the order of the unknowns
    Constraints c(n);
    for(const auto& row : rows) {
      std::vector<Constraints::Term> terms(row.first);
      for(Constraints::Term& term : terms)
        term.first = order[term.first];
      c.add_constraint(terms, Rational(row.second));
    }
    Values x(n);
    for(std::size_t j = 0; j < n; ++j)
      x[order[j]] = values[j];
    const Values before(x);
    snap(name, c, x);
    CHECK(largest_difference(before, x) <= largest_change);
  } while(std::next_permutation(order.begin(), order.end()));
}

void test_mixed_scales()
{
  test_found("at a power of two", 2, {{{{0, 1}, {1, -1}}, -0x1p-49}}, {-16, -16}, 0x1p-47);
  test_found("at two powers of two", 3,
             {{{{0, 1}, {1, -1}}, -0x1p-49}, {{{1, 1}, {2, 1}}, 0x1p-49}}, {-16, -16, 16}, 0x1p-46);
  test_found("small pin", 1, {{{{0, 1}}, 1e-96}}, {1e235}, 1e235);
  test_found("beside a power of two", 2, {{{{0, 1}, {1, 1}}, -0x1p-51}},
             {4, -4.0000000000000018}, 0x1p-48);
  test_found("small sum", 3, {{{{0, 1}, {1, 1}, {2, 1}}, 0x1p-60}}, {1, -1, 0}, 0x1p-50);
  test_found("large and small", 3, {{{{0, 1}, {1, -1}}, 0}, {{{1, 1}, {2, -1}}, 1e20}},
             {1e-20, 1e-20, -1e20}, 1e5);
}

// --- random small systems ------------------------------------------------------------------------

struct Tally
{
  std::map<std::string, std::size_t> outcomes;
  std::size_t compared = 0, too_far = 0, refused = 0;
  double worst_ratio = 0;
};

struct Random_problem
{
  Small_system system;
  Values x;
};

Random_problem random_problem(Random& random)
{
  Random_problem p;
  const std::size_t n = std::size_t(random_integer(random, 1, 6));
  const int m = random_integer(random, 1, (std::max)(1, int(n) - 1));
  const int bits = random_integer(random, 1, 24), zeros = random_integer(random, 0, 60);
  const bool is_mixed = random() % 2 == 0;
  const int spread = is_mixed ? random_integer(random, 1, 40) : 0;
  p.system.columns = n;
  for(std::size_t j = 0; j < n; ++j)
    p.x.push_back(std::ldexp(random_real(random), random_integer(random, -spread, spread)));
  const int kind = random_integer(random, 0, 3);
  for(int i = 0; i < m; ++i) {
    grid_reference::Integers row;
    Rational b(0);
    for(std::size_t j = 0; j < n; ++j) {
      const bool is_zero = random_integer(random, 0, 99) < zeros;
      row.push_back(Integer(is_zero ? 0 : random_coefficient(random, bits)));
      if(kind >= 2) // near the values, on a grid
        b += Rational(row.back()) * Rational(std::ldexp(std::floor(std::ldexp(p.x[j], 20)), -20));
    }
    if(kind == 1)
      b = Rational(
          std::ldexp(double(random_integer(random, -9, 9)), random_integer(random, -60, 0)));
    p.system.rows.push_back(row);
    p.system.b.push_back(b);
  }
  return p;
}

void test_random_problem(const std::uint64_t seed, Tally& tally)
{
  Random random(seed);
  const Random_problem p = random_problem(random);
  LS::Linear_constraints<Integer> c(p.system.columns);
  for(std::size_t i = 0; i < p.system.rows.size(); ++i) {
    std::vector<std::pair<std::size_t, Integer> > row;
    for(std::size_t j = 0; j < p.system.columns; ++j)
      row.emplace_back(j, p.system.rows[i][j]);
    c.add_constraint(row, p.system.b[i]);
  }
  Values x(p.x);
  const LS::Linear_report report = LS::snap_to_linear_constraints(c, x);
  ++tally.outcomes[LS::to_string(report.status)];
  if(report && !CHECK(is_solution(c, x)))
    std::cout << "  seed " << seed << std::endl;
  const auto reference = grid_reference::nearest_on_one_grid(p.system, p.x);
  if(!reference)
    return;
  ++tally.compared;
  if(!report) {
    const double extent = std::abs(*std::max_element(p.x.begin(), p.x.end(),
      [](const double a, const double b) { return std::abs(a) < std::abs(b); }));
    if(reference->largest_change <= 1000 * extent) {
      ++tally.refused;
      if(tally.refused < 5)
        std::cout << "  refused: seed " << seed << ", " << reference->largest_change << std::endl;
    }
    return;
  }
  if(reference->largest_change == 0)
    return;
  const double ratio = largest_difference(p.x, x) / reference->largest_change;
  tally.worst_ratio = (std::max)(tally.worst_ratio, ratio);
  if(ratio > 10) {
    ++tally.too_far;
    if(tally.too_far < 5)
      std::cout << "  seed " << seed << ": moved by " << largest_difference(p.x, x)
                << " instead of " << reference->largest_change << std::endl;
  }
}

void test_random_problems(const std::uint64_t count, const std::uint64_t seed)
{
  Tally tally;
  for(std::uint64_t i = 0; i < count; ++i)
    test_random_problem(seed + i, tally);
  std::cout << count << " random systems from seed " << seed << ":";
  for(const auto& outcome : tally.outcomes)
    std::cout << " " << outcome.first << " " << outcome.second;
  std::cout << "; compared " << tally.compared << ", refused " << tally.refused
            << ", more than 10 times as far " << tally.too_far << ", at most "
            << tally.worst_ratio << " times" << std::endl;
  CHECK(2 * tally.compared > count);
  CHECK_EQUAL(tally.refused, 0u);
  CHECK_EQUAL(tally.too_far, 0u);
}

// --- solutions that are known --------------------------------------------------------------------

struct Planted_problem
{
  LS::Linear_constraints<Rational> constraints;
  Values solution, x;

  void add_row(const std::vector<std::pair<std::size_t, Rational> >& row)
  {
    Rational b(0);
    for(const auto& term : row)
      b += term.second * Rational(solution[term.first]);
    constraints.add_constraint(row, b);
  }

  void add_noise(Random& random)
  {
    const double size = std::ldexp(1., -random_integer(random, 10, 56));
    for(const double value : solution)
      x.push_back(value * (1 + size * random_real(random)));
  }
};

Planted_problem planted_problem(const Values& solution)
{
  return {LS::Linear_constraints<Rational>(solution.size()), solution, {}};
}

// Values of very different size, and rows of very different scale; with coefficients of up to some
// bits more or less than others.
Planted_problem mixed_scales(Random& random, const int bits)
{
  const int n = random_integer(random, 2, 5), m = random_integer(random, 1, n - 1);
  const int spread = random_integer(random, 1, 60), row_spread = random_integer(random, 0, 60);
  Values solution;
  for(int j = 0; j < n; ++j)
    solution.push_back(std::ldexp(random_real(random), random_integer(random, -spread, spread)));
  Planted_problem p = planted_problem(solution);
  for(int i = 0; i < m; ++i) {
    const int scale = random_integer(random, -row_spread, row_spread);
    const int largest = random_integer(random, 1, 9);
    std::vector<std::pair<std::size_t, Rational> > row;
    for(int j = 0; j < n; ++j)
      if(random() % 4 != 0) {
        const double c = random_integer(random, -largest, largest);
        row.emplace_back(j, std::ldexp(c, scale + random_integer(random, 0, bits)));
      }
    p.add_row(row);
  }
  p.add_noise(random);
  return p;
}

// x_j = c 2^k x_i, with some i < j for each j.
Planted_problem multiples(Random& random)
{
  const int n = random_integer(random, 2, 5), spread = random_integer(random, 1, 60);
  Values solution(1, std::ldexp(double(1 + random() % 0xffffff),
                                random_integer(random, -spread, spread)));
  std::vector<std::vector<std::pair<std::size_t, Rational> > > rows;
  for(int j = 1; j < n; ++j) {
    const std::size_t i = std::size_t(random_integer(random, 0, j - 1));
    const double c = std::ldexp(2 * random_integer(random, -7, 7) + 1.,
                                random_integer(random, -60, 60));
    rows.push_back({{std::size_t(j), Rational(1)}, {i, Rational(-c)}});
    solution.push_back(c * solution[i]);
  }
  Planted_problem p = planted_problem(solution);
  for(const auto& row : rows)
    p.add_row(row);
  p.add_noise(random);
  return p;
}

// Sums of values on both sides of powers of two, where the spacing of numbers changes.
Planted_problem beside_powers_of_two(Random& random)
{
  const int n = random_integer(random, 2, 5);
  Values solution, x;
  std::vector<std::pair<std::size_t, Rational> > row;
  for(int j = 0; j < n; ++j) {
    const double power = std::ldexp(random() % 2 == 0 ? 1 : -1, random_integer(random, -2, 2));
    for(Values* const values : {&solution, &x}) {
      values->push_back(power);
      const int steps = random_integer(random, -3, 3);
      for(int k = std::abs(steps); k > 0; --k)
        values->back() = std::nextafter(values->back(), steps < 0 ? 0 : 2 * power);
    }
    row.emplace_back(j, random() % 2 == 0 ? 1 : -1);
  }
  Planted_problem p = planted_problem(solution);
  p.add_row(row);
  p.x = x;
  return p;
}

// Sums and differences of values that share no digit.
Planted_problem all_scales(Random& random, const int most_unknowns)
{
  const int n = random_integer(random, 3, most_unknowns), m = random_integer(random, 1, 2 * n / 3);
  Values solution;
  for(int j = 0; j < n; ++j)
    solution.push_back(std::ldexp(random_real(random), random_integer(random, -300, 300)));
  Planted_problem p = planted_problem(solution);
  for(int i = 0; i < m; ++i) {
    std::map<std::size_t, Rational> row;
    for(int k = random_integer(random, 1, 4); k > 0; --k)
      row[std::size_t(random_integer(random, 0, n - 1))] = random() % 2 == 0 ? 1 : -1;
    p.add_row({row.begin(), row.end()});
  }
  p.add_noise(random);
  return p;
}

double distance(const Values& a, const Values& b)
{
  double result = 0;
  for(std::size_t j = 0; j < a.size(); ++j)
    result = std::hypot(result, a[j] - b[j]);
  return result;
}

template <typename Make>
void test_planted_problems(const std::string& name, const Make& make, const std::uint64_t count,
                           const std::uint64_t seed)
{
  std::size_t changed = 0, refused = 0, distant = 0;
  for(std::uint64_t i = 0; i < count; ++i) {
    Random random(seed + i);
    const Planted_problem p = make(random);
    Values x(p.x);
    const LS::Linear_report report = LS::snap_to_linear_constraints(p.constraints, x);
    if(report.status == LS::Outcome::ALREADY_EXACT)
      continue;
    ++changed;
    if(!report) {
      CHECK_EQUAL(report.status, LS::Outcome::NOT_REPRESENTABLE);
      ++refused;
      continue;
    }
    if(!CHECK(is_solution(p.constraints, x)))
      std::cout << "  seed " << seed + i << std::endl;
    distant += distance(x, p.x) > 10 * distance(p.solution, p.x);
  }
  std::cout << name << ", " << count << " systems from seed " << seed << ": of " << changed
            << " that did not hold, refused though solvable " << refused
            << ", more than 10 times as far as a known solution " << distant << std::endl;
  CHECK(2 * changed > count);
  CHECK(100 * (refused + distant) < changed);
}

void test_planted_problems(const std::uint64_t count, const std::uint64_t seed)
{
  test_planted_problems("rows of very different scale",
                        [](Random& random) { return mixed_scales(random, 0); }, count, seed);
  test_planted_problems("coefficients of very different size",
                        [](Random& random) { return mixed_scales(random, 40); }, count, seed);
  test_planted_problems("multiples", multiples, count, seed);
  test_planted_problems("beside powers of two", beside_powers_of_two, count, seed);
  test_planted_problems("few values of all scales",
                        [](Random& random) { return all_scales(random, 8); }, count, seed);
  test_planted_problems("many values of all scales",
                        [](Random& random) { return all_scales(random, 40); }, count / 10, seed);
}

// Where one change takes all digits of a small value: the solution that is known is 2e-27 away.
void test_small_value_beside_large_ones()
{
  const Values solution{1.0414309314381706e-20, -9.846746568305923e+25, -6.7192498847280044e-15,
                        -5.8365732994387437e+20};
  Planted_problem p = planted_problem(solution);
  p.add_row({{2, -1}, {1, 1}, {0, -1}, {3, 1}});
  p.add_row({{1, -1}});
  Values x{1.0414309314373119e-20, -9.846746568305923e+25, -6.7192498847332574e-15,
           -5.8365732994387437e+20};
  const Values before(x);
  snap("small values beside large ones", p.constraints, x);
  CHECK(distance(x, before) <= 2 * distance(solution, before));
}

// Values of which only the right-hand sides are large: squares of the rest underflow, and a
// reduction of the rows found no end.
void test_rows_with_large_right_hand_sides()
{
  Constraints c(6);
  c.add_constraint({{0, 1}, {4, 1}, {5, 1}, {2, 1}}, 8358256617533179. / 128);
  c.add_constraint({{3, 1}, {0, -1}, {2, 1}, {1, -1}}, std::ldexp(957869471782607., -172));
  c.add_constraint({{3, 1}, {1, -1}, {4, 1}}, std::ldexp(4235251833531049., -691));
  c.add_constraint({{5, -1}}, std::ldexp(5347132160005573., -456));
  const Values before{-0x1.abdbc352059d5p+76, -0x1.935e6842d6594p-340, -0x1.2beb8602d0382p-384,
                      -0x1.19659ce310dabp+162, -0x1.2c40508ce7829p+512, 0x1.d06a6ab7bba5ep-69};
  Values x(before);
  const LS::Linear_report report = LS::snap_to_linear_constraints(c, x);
  CHECK_EQUAL(report.status, LS::Outcome::NOT_REPRESENTABLE);
  CHECK(x == before);
}

// --- figures -------------------------------------------------------------------------------------

LS::Linear_report snap_row(const std::vector<std::pair<std::size_t, Rational> >& row,
                           const Rational& b, Values x)
{
  LS::Linear_constraints<Rational> c(x.size());
  c.add_constraint(row, b);
  const LS::Linear_report report = snap("row", c, x);
  for(const double figure : {report.rms_change, report.optimal_rms_change, report.largest_change,
                             report.mean_change, report.distance_ratio})
    CHECK(std::isfinite(figure));
  return report;
}

// Whose squares exceed all numbers.
void test_large_figures()
{
  LS::Linear_report report = snap_row({{0, 1}, {1, -1}}, Rational(0x1p115), {1e-126, 0});
  CHECK_EQUAL(report.rms_change, 0x1p114);
  CHECK_EQUAL(report.optimal_rms_change, 0x1p114);
  report = snap_row({{0, 1}, {1, -1}}, Rational(0), {1e300, 0});
  CHECK(std::abs(report.rms_change - 5e299) < 1e285);
  report = snap_row({{0, 1}, {1, 1}}, Rational(0), {1.7e308, 1.7e308});
  CHECK(std::abs(report.mean_change - 1.7e308) < 1e293);
  report = snap_row({{0, 1}, {1, 1}}, Rational(0), {5e-324, 0});
  CHECK_EQUAL(report.largest_change, 5e-324);
}

// What is far is told, and what need not be far is not.
void test_told_distances()
{
  for(const int k : {20, 50, 60}) {
    const double factor = std::ldexp(1., k), x = 1.1 * (1 + 0x1p-45);
    const LS::Linear_report report =
      snap_row({{0, 1}, {1, Rational(-factor)}}, Rational(0), {1.1 * factor, x});
    CHECK(report.message.empty() && report.distance_ratio < 10);
    CHECK(report.largest_change <= 0x1p-44 * factor);
  }
  // more bits than 62
  const Rational b = Rational(-6047602843450.) * Rational(1000000) - Rational(96881);
  CHECK_EQUAL(snap_row({{0, 2}, {1, 2}}, b, {-3.0235976744977705e18, -203747227277944.47})
                .largest_change, 0.03125);
}

// Where so few numbers solve a system that a result would have nothing of the values, there is
// none; but values may start anywhere.
void test_meaningless_results()
{
  // below 2^53, only 0 is a multiple
  Constraints c(2);
  c.add_constraint({{0, (std::int64_t(1) << 60) + 1}, {1, -1}}); // 2^60 + 1
  Values x{1, 0x1p60};
  const LS::Linear_report report = LS::snap_to_linear_constraints(c, x);
  CHECK_EQUAL(report.status, LS::Outcome::NOT_REPRESENTABLE);
  CHECK(report.message.find("constraints 0 would move more than 10^1") != std::string::npos);
  CHECK(x == Values({1, 0x1p60}));
  x = {1, 0};
  CHECK_EQUAL(LS::snap_to_linear_constraints(c, x).status, LS::Outcome::SNAPPED);
  Constraints d(3);
  d.add_constraint({{0, 3}, {1, -5}, {2, 7}}, 1000);
  d.add_constraint({{0, 2}, {1, 3}, {2, 10}}, -500);
  x = {0, 0, 0};
  CHECK_EQUAL(LS::snap_to_linear_constraints(d, x).status, LS::Outcome::SNAPPED);
}

int main(int argc, char** argv)
{
  const Floating_point_traps traps; // for all functions that are called
  const std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : 1;
  const std::uint64_t count = argc > 1 ? std::stoull(argv[1]) : 2000;
  test_random_problems(count, seed);
  test_planted_problems(count, seed);
  if(argc > 1)
    return report_checks();
  test_small_value_beside_large_ones();
  test_rows_with_large_right_hand_sides();
  test_large_figures();
  test_told_distances();
  test_meaningless_results();
  test_mixed_scales();
  for(const int bits : {10, 20, 25, 30, 35, 40})
    for(unsigned int i = 1; i <= 5; ++i)
      test_nearly_parallel_rows(8, bits, i);
  for(const std::size_t n : {100, 1800, 100000})
    test_hub(n);
  test_two_hubs(3000);
  for(const std::size_t n : {60, 80, 150})
    test_knapsack_row(n, 40, 1);
  for(const int k : {10, 20, 30})
    test_laplace_grid(k, 1);
  for(unsigned int i = 0; i <= 3; ++i)
    test_few_free_unknowns(600, 3 * i, i);
  test_fill_in(4000, 1); // below the bound, and above it
  test_fill_in(30000, 1);
  test_fill_in_with_weights(30000, 1);
  for(unsigned int i = 1; i <= 20; ++i)
    test_refinement(i, 200, 20 * i, i % 2 == 0);
  return report_checks();
}
