// Tests of the complete integer solver: random small systems against a reference that shares no
// code with it (Heger's theorem on the gcds of minors, and enumeration of boxes), the examples of
// the paper's addendum, and large coefficients.

#include "checking.h"
#include "test_data.h"

#include <CGAL/Linear_snapping/internal/linear/Integer_lattice.h>
#include <CGAL/Linear_snapping/internal/linear/eliminate.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Linear_algebraHd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

using CGAL::Exact_integer;
using namespace CGAL::Linear_snapping::internal;

using Matrix = std::vector<std::vector<Exact_integer> >;
using Vector = std::vector<Exact_integer>;

Integer_system to_system(const Matrix& a, const std::size_t number_of_columns)
{
  Integer_system result(number_of_columns);
  for(const Vector& row : a) {
    std::vector<Entry<Exact_integer> > entries;
    for(std::size_t j = 0; j < row.size(); ++j)
      if(row[j] != 0)
        entries.push_back({Column_index(j), row[j]});
    result.add_row(Integer_row<Exact_integer>{entries, Exact_integer(0)});
  }
  return result;
}

Matrix to_dense(const std::vector<Entries<Exact_integer> >& vectors, const std::size_t size)
{
  Matrix result;
  for(const Entries<Exact_integer>& v : vectors) {
    result.push_back(Vector(size, Exact_integer(0)));
    for(const Entry<Exact_integer>& e : v)
      result.back()[std::size_t(e.column)] = e.coefficient;
  }
  return result;
}

Exact_integer product(const Vector& a, const Vector& b)
{
  Exact_integer sum(0);
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += Exact_integer(a[i] * b[i]);
  return sum;
}

bool solves(const Matrix& a, const Vector& y, const Vector& b)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    if(product(a[i], y) != b[i])
      return false;
  return true;
}

// ---- the reference: minors by expansion, nothing else ----

Exact_integer minor_of(const Matrix& a, const std::vector<std::size_t>& rows,
                       const std::vector<std::size_t>& columns)
{
  if(rows.empty())
    return Exact_integer(1);
  Exact_integer sum(0);
  const std::vector<std::size_t> other_rows(rows.begin() + 1, rows.end());
  for(std::size_t j = 0; j < columns.size(); ++j) {
    const Exact_integer& coefficient = a[rows[0]][columns[j]];
    if(coefficient == 0)
      continue;
    std::vector<std::size_t> other_columns = columns;
    other_columns.erase(other_columns.begin() + std::ptrdiff_t(j));
    const Exact_integer term(coefficient * minor_of(a, other_rows, other_columns));
    if(j % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
}

std::vector<std::vector<std::size_t> > subsets(const std::size_t size, const std::size_t count)
{
  std::vector<std::vector<std::size_t> > result;
  for(std::size_t mask = 0; mask < (std::size_t(1) << size); ++mask) {
    std::vector<std::size_t> subset;
    for(std::size_t i = 0; i < size; ++i)
      if((mask >> i) & 1)
        subset.push_back(i);
    if(subset.size() == count)
      result.push_back(subset);
  }
  return result;
}

// The gcd of all minors of an order; 0 if they vanish.
Exact_integer gcd_of_minors(const Matrix& a, const std::size_t order)
{
  Exact_integer gcd(0);
  const std::size_t columns = a.empty() ? 0 : a[0].size();
  for(const std::vector<std::size_t>& r : subsets(a.size(), order))
    for(const std::vector<std::size_t>& c : subsets(columns, order)) {
      const Exact_integer m = minor_of(a, r, c);
      gcd = CGAL::gcd(gcd, Exact_integer(CGAL::abs(m)));
    }
  return gcd;
}

std::size_t rank_of(const Matrix& a)
{
  std::size_t rank = 0;
  while(rank < a.size() && gcd_of_minors(a, rank + 1) != 0)
    ++rank;
  return rank;
}

Matrix augmented(Matrix a, const Vector& b, const Exact_integer& factor)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i].push_back(Exact_integer(b[i] * factor));
  return a;
}

struct Reference
{
  Solvability solvability;
  bool is_dyadic = false;
  std::size_t power_of_two = 0;
};

// Heger: A Y = B is solvable over Z iff the gcd of the largest nonzero minors doesn't change when B
// is appended.
Reference reference_of(const Matrix& a, const Vector& b)
{
  const std::size_t rank = rank_of(a);
  const Matrix ab = augmented(a, b, Exact_integer(1));
  if(gcd_of_minors(ab, rank + 1) != 0)
    return {Solvability::INCONSISTENT};
  const Exact_integer gcd = gcd_of_minors(a, rank);
  if(gcd_of_minors(ab, rank) == gcd)
    return {Solvability::SOLVABLE};
  Exact_integer factor(1);
  for(std::size_t k = 1; k < 12; ++k) {
    factor *= 2;
    if(gcd_of_minors(augmented(a, b, factor), rank) == gcd)
      return {Solvability::NOT_INTEGER, true, k};
  }
  return {Solvability::NOT_INTEGER, false, 0};
}

// ---- checks ----

bool is_zero_modulo(const Exact_integer& a, const Exact_integer& modulus)
{
  if(modulus == 0)
    return a == 0;
  const Exact_integer rest(a % modulus);
  return rest == 0;
}

bool is_valid(const Insolvability_certificate& certificate, const Matrix& a, const Vector& b)
{
  const Vector& y = certificate.multipliers;
  if(y.size() != a.size() || is_zero_modulo(product(y, b), certificate.modulus))
    return false;
  for(std::size_t j = 0; j < a[0].size(); ++j) {
    Exact_integer sum(0);
    for(std::size_t i = 0; i < a.size(); ++i)
      sum += Exact_integer(y[i] * a[i][j]);
    if(!is_zero_modulo(sum, certificate.modulus))
      return false;
  }
  return true;
}

// Whatever the outcome, it comes with something that can be checked.
void check_solution(const Matrix& a, const Vector& b, const Lattice_solution& s)
{
  if(s.solvability == Solvability::SOLVABLE) {
    CHECK(solves(a, s.values, b));
    return;
  }
  CHECK(is_valid(s.certificate, a, b));
  if(s.solvability == Solvability::INCONSISTENT)
    CHECK(s.certificate.modulus == 0);
  else
    CHECK(s.certificate.modulus > 1);
  if(s.solvability == Solvability::NOT_INTEGER && !s.is_dyadic)
    CHECK(Exact_integer(s.certificate.modulus % 2) != 0);
}

void check_kernel(const Matrix& a, const std::size_t n, const Integer_lattice& lattice)
{
  const Matrix kernel = to_dense(lattice.kernel_basis(), n);
  const std::size_t rank = rank_of(a);
  CHECK_EQUAL(kernel.size(), n - rank);
  for(const Vector& v : kernel)
    CHECK(solves(a, v, Vector(a.size(), Exact_integer(0))));
  // saturated: no integer vector of its span is missing
  if(!kernel.empty())
    CHECK(gcd_of_minors(kernel, kernel.size()) == 1);
}

std::vector<Grid_value> to_target(const std::vector<double>& y)
{
  std::vector<Grid_value> result(y.size());
  for(std::size_t i = 0; i < y.size(); ++i) {
    result[i].base = std::llround(y[i]);
    result[i].offset = y[i] - static_cast<double>(result[i].base);
  }
  return result;
}

double squared_distance(const Vector& a, const std::vector<double>& y, const std::vector<double>& w)
{
  double sum = 0;
  for(std::size_t i = 0; i < y.size(); ++i) {
    const double d = CGAL::to_double(a[i]) - y[i];
    sum += w[i] * d * d;
  }
  return sum;
}

Matrix random_matrix(std::mt19937& random, const std::size_t m, const std::size_t n,
                     const int largest)
{
  std::uniform_int_distribution<int> coefficient(-largest, largest), percent(0, 99);
  const int zeros = percent(random) / 2;
  Matrix a(m, Vector(n, Exact_integer(0)));
  for(Vector& row : a)
    for(Exact_integer& c : row)
      if(percent(random) >= zeros)
        c = coefficient(random);
  if(m > 1 && percent(random) < 30) // a redundant row
    for(std::size_t j = 0; j < n; ++j)
      a[m - 1][j] = Exact_integer(a[0][j] * 2) + (m > 2 ? a[1][j] : Exact_integer(0));
  return a;
}

// Of all kinds: consistent over Z, over Q, or by chance.
Vector random_right_hand_side(std::mt19937& random, const Matrix& a)
{
  std::uniform_int_distribution<int> value(-9, 9), kind(0, 2), divisor(2, 4);
  Vector b(a.size(), Exact_integer(0));
  if(kind(random) == 0) {
    for(Exact_integer& x : b)
      x = value(random);
    return b;
  }
  Vector y(a[0].size(), Exact_integer(0));
  for(Exact_integer& x : y)
    x = value(random);
  const int d = divisor(random);
  bool is_divisible = true;
  for(std::size_t i = 0; i < a.size(); ++i) {
    b[i] = product(a[i], y);
    is_divisible = is_divisible && Exact_integer(b[i] % d) == 0;
  }
  if(is_divisible)
    for(Exact_integer& x : b)
      x = Exact_integer(x / d);
  return b;
}

void test_random_systems(const unsigned int seed)
{
  std::cout << "random systems, seed " << seed << std::endl;
  std::mt19937 random(seed);
  std::size_t seen[4] = { 0, 0, 0, 0 };
  for(int repetition = 0; repetition < 2000; ++repetition) {
    const std::size_t m = 1 + random() % 4, n = 1 + random() % 5;
    const Matrix a = random_matrix(random, m, n, repetition % 2 == 0 ? 4 : 12);
    const Integer_lattice lattice(to_system(a, n));
    check_kernel(a, n, lattice);
    for(int i = 0; i < 3; ++i) {
      const Vector b = random_right_hand_side(random, a);
      const Lattice_solution s = lattice.some_solution(b);
      const Reference reference = reference_of(a, b);
      check_solution(a, b, s);
      CHECK(s.solvability == reference.solvability);
      if(s.solvability == Solvability::NOT_INTEGER) {
        CHECK_EQUAL(s.is_dyadic, reference.is_dyadic);
        CHECK_EQUAL(s.power_of_two, reference.power_of_two);
      }
      ++seen[s.solvability == Solvability::NOT_INTEGER && s.is_dyadic ? 3 : int(s.solvability)];
    }
  }
  std::cout << "  solvable " << seen[0] << ", not over Z " << seen[1] << " (with halved grids "
            << seen[3] << "), not over Q " << seen[2] << std::endl;
  for(const std::size_t count : seen)
    CHECK(count > 100);
}

// Calls f(Y) for all integer Y with |Y_i - center_i| <= radius.
template <typename Function>
void for_each_in_box(const std::vector<double>& center, const int radius, const Function& f)
{
  const std::size_t n = center.size();
  std::vector<int> shift(n, -radius);
  for(;;) {
    std::vector<int> y(n);
    for(std::size_t i = 0; i < n; ++i)
      y[i] = int(std::lround(center[i])) + shift[i];
    f(y);
    std::size_t i = 0;
    while(i < n && shift[i] == radius)
      shift[i++] = -radius;
    if(i == n)
      return;
    ++shift[i];
  }
}

void test_nearness(const unsigned int seed)
{
  std::cout << "nearness, seed " << seed << std::endl;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-20, 20), logarithm(-2, 2);
  std::size_t compared = 0, optimal = 0;
  double worst = 1;
  const int number = test_data::trials(400);
  for(int repetition = 0; repetition < number; ++repetition) {
    const std::size_t n = 2 + random() % 3, m = 1 + random() % (n - 1);
    const Matrix a = random_matrix(random, m, n, 6);
    const Vector b = random_right_hand_side(random, a);
    std::vector<double> y(n), w(n, 1.);
    for(std::size_t i = 0; i < n; ++i) {
      y[i] = coordinate(random);
      if(repetition % 2 == 1)
        w[i] = std::exp(logarithm(random));
    }
    const Integer_lattice lattice(to_system(a, n));
    const Lattice_solution s = lattice.nearest_solution(b, to_target(y), lattice.metric(w));
    check_solution(a, b, s);
    double best = -1;
    for_each_in_box(y, n == 4 ? 9 : 20, [&](const std::vector<int>& candidate) {
      Vector exact(n);
      for(std::size_t i = 0; i < n; ++i)
        exact[i] = candidate[i];
      if(!solves(a, exact, b))
        return;
      CHECK(s.solvability == Solvability::SOLVABLE);
      const double d = squared_distance(exact, y, w);
      best = best < 0 ? d : (std::min)(best, d);
    });
    if(best < 0 || s.solvability != Solvability::SOLVABLE)
      continue;
    ++compared;
    const double ratio = std::sqrt(squared_distance(s.values, y, w) / best);
    worst = (std::max)(worst, ratio);
    optimal += ratio < 1 + 1e-9;
    // The bound of the nearest plane algorithm in dimension d is 2^(d/2).
    CHECK(ratio <= std::exp2(0.5 * static_cast<double>(lattice.kernel_basis().size())) + 1e-9);
  }
  std::cout << "  compared " << compared << ", optimal " << optimal << ", worst ratio " << worst
            << std::endl;
  CHECK(4 * compared > std::size_t(number));
  CHECK(10 * optimal > 9 * compared);
}

void test_addendum()
{
  const auto solve = [](const Matrix& a, const Vector& b) {
    const Lattice_solution s = Integer_lattice(to_system(a, a[0].size())).some_solution(b);
    check_solution(a, b, s);
    return s;
  };
  Lattice_solution s = solve({{3}}, {1});
  CHECK(s.solvability == Solvability::NOT_INTEGER && !s.is_dyadic);
  s = solve({{9, 14}}, {1});
  CHECK(s.solvability == Solvability::SOLVABLE);
  s = solve({{9, 15}}, {1});
  CHECK(s.solvability == Solvability::NOT_INTEGER && !s.is_dyadic);
  s = solve({{2, 4}}, {1});
  CHECK(s.solvability == Solvability::NOT_INTEGER && s.is_dyadic && s.power_of_two == 1);
  s = solve({{8, 24}}, {3});
  CHECK(s.solvability == Solvability::NOT_INTEGER && s.is_dyadic && s.power_of_two == 3);
  s = solve({{2, 4}, {3, 6}}, {2, 4});
  CHECK(s.solvability == Solvability::INCONSISTENT);
  s = solve({{0, 0}}, {0});
  CHECK(s.solvability == Solvability::SOLVABLE);
  s = solve({{0, 0}}, {1});
  CHECK(s.solvability == Solvability::INCONSISTENT);
  // Both an obstacle that halving the grid removes and one that it doesn't, in either order.
  s = solve({{2, 0}, {0, 3}}, {1, 1});
  CHECK(s.solvability == Solvability::NOT_INTEGER && !s.is_dyadic);
  s = solve({{3, 0}, {0, 2}}, {1, 1});
  CHECK(s.solvability == Solvability::NOT_INTEGER && !s.is_dyadic);
}

Exact_integer random_integer(std::mt19937& random, const int bits)
{
  Exact_integer result(0);
  for(int i = 0; i < bits; i += 16)
    result = Exact_integer(result * 65536) + Exact_integer(int(random() % 65536));
  return random() % 2 == 0 ? result : Exact_integer(-result);
}

// The largest |Y_i - y_i|.
double largest_change(const Vector& a, const std::vector<Grid_value>& y)
{
  double result = 0;
  for(std::size_t i = 0; i < y.size(); ++i) {
    const Exact_integer high(static_cast<double>(y[i].base / 1024));
    const Exact_integer low(static_cast<double>(y[i].base % 1024));
    const Exact_integer difference(a[i] - Exact_integer(high * 1024) - low);
    result = (std::max)(result, std::abs(CGAL::to_double(difference) - y[i].offset));
  }
  return result;
}

void test_large_coefficients(const unsigned int seed)
{
  std::cout << "large coefficients, seed " << seed << std::endl;
  std::mt19937 random(seed);
  for(const int bits : { 30, 48, 64, 128, 400, 1200 })
    for(int repetition = 0; repetition < 10; ++repetition) {
      const std::size_t m = 1 + random() % 3, n = m + 2 + random() % 4;
      Matrix a(m, Vector(n, Exact_integer(0)));
      for(Vector& row : a)
        for(Exact_integer& c : row)
          c = random_integer(random, bits);
      Vector y(n, Exact_integer(0)), b(m, Exact_integer(0));
      for(Exact_integer& x : y)
        x = random_integer(random, 48);
      for(std::size_t i = 0; i < m; ++i)
        b[i] = product(a[i], y);
      const Integer_lattice lattice(to_system(a, n));
      check_kernel(a, n, lattice);
      const Lattice_solution some = lattice.some_solution(b);
      check_solution(a, b, some);
      CHECK(some.solvability == Solvability::SOLVABLE);

      // Near to a target that is a solution but for small changes, this solution must come back.
      std::uniform_real_distribution<double> noise(-0.3, 0.3);
      std::vector<Grid_value> target(n);
      for(std::size_t i = 0; i < n; ++i)
        target[i] = {to_64_bits(y[i]), noise(random)};
      const Lattice_metric metric = lattice.metric(std::vector<double>(n, 1.));
      const Lattice_solution nearest = lattice.nearest_solution(b, target, metric);
      check_solution(a, b, nearest);
      // Many bits, few columns: the kernel vectors are long, so that solution is the only one near.
      CHECK(nearest.values == y);

      // One bit more on the right can't always be had.
      b[0] += 1;
      check_solution(a, b, lattice.some_solution(b));
    }
}

// A sparse system with entries +-1 only whose eliminated form has large coefficients.
void test_growth(const unsigned int seed, const std::size_t m, const std::size_t n)
{
  std::cout << "random sparse " << m << " x " << n << ", seed " << seed;
  std::mt19937 random(seed);
  Matrix a(m, Vector(n, Exact_integer(0)));
  for(Vector& row : a)
    for(int i = 0; i < 5; ++i)
      row[random() % n] = random() % 2 == 0 ? 1 : -1;
  const Integer_lattice lattice(to_system(a, n));
  CHECK(lattice.kernel_basis().size() >= n - m);
  const Vector zero(m, Exact_integer(0));
  for(const Vector& v : to_dense(lattice.kernel_basis(), n))
    CHECK(solves(a, v, zero));
  // A target far from the kernel, and the approximation of a point near to it.
  std::vector<Grid_value> target(n);
  for(Grid_value& t : target)
    t.base = to_64_bits(random_integer(random, 48));
  const std::vector<double> weights(n, 1.);
  const Lattice_metric metric = lattice.metric(weights);
  const Lattice_solution first = lattice.nearest_solution(zero, target, metric);
  CHECK(solves(a, first.values, zero));
  for(std::size_t i = 0; i < n; ++i)
    target[i] = {to_64_bits(first.values[i]), 0.4};
  const Lattice_solution second = lattice.nearest_solution(zero, target, metric);
  CHECK(solves(a, second.values, zero));
  std::cout << ", change " << largest_change(second.values, target) << std::endl;
  CHECK(largest_change(second.values, target) < 1e4);
  // The same again, bit for bit.
  const Integer_lattice same(to_system(a, n));
  const Lattice_solution again = same.nearest_solution(zero, target, same.metric(weights));
  CHECK(again.values == second.values);
}

// ---- reduction of a given basis ----

// The basis vectors (e_i, a_i) tell afterwards by which matrix they were combined: that of their
// first components. It must be of determinant +-1, and explain the last ones.
template <typename Integer>
void test_basis(const std::size_t size,
                const int bits,
                const bool is_weighted,
                const unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::vector<Integer> a(size);
  std::vector<std::vector<Integer> > basis(size, std::vector<Integer>(size + 1, Integer(0)));
  for(std::size_t i = 0; i < size; ++i) {
    a[i] = Integer(0);
    for(int b = 0; b < bits; ++b)
      a[i] = Integer(a[i] * 2 + Integer(static_cast<int>(random() % 2)));
    basis[i][i] = Integer(1);
    basis[i][size] = a[i];
  }
  std::vector<double> scale(size + 1, 1.);
  for(std::size_t j = 0; is_weighted && j < size; ++j)
    scale[j] = 0.25 + double(random() % 1000) / 500;
  Lattice_reduction<Integer>(basis, scale);

  using Algebra = CGAL::Linear_algebraHd<Exact_integer>;
  const int n = static_cast<int>(size);
  Algebra::Matrix combination(n, n);
  double longest = 0;
  for(std::size_t i = 0; i < size; ++i) {
    Exact_integer sum(0);
    double length = 0;
    for(std::size_t j = 0; j < size; ++j) {
      combination(int(i), int(j)) = Exact_integer(basis[i][j]);
      sum += Exact_integer(Exact_integer(basis[i][j]) * Exact_integer(a[j]));
      length += std::pow(CGAL::to_double(basis[i][j]), 2);
    }
    CHECK(sum == Exact_integer(basis[i][size]));
    longest = (std::max)(longest, std::sqrt(length));
  }
  const Exact_integer determinant = Algebra::determinant(combination);
  CHECK(determinant == 1 || determinant == -1);
  CHECK(longest < std::exp2(double(bits) / double(size) + 5)); // unreduced: 2^bits for such numbers
}

void test_bases(unsigned int seed)
{
  for(const bool is_weighted : {false, true}) {
    test_basis<std::int64_t>(20, 40, is_weighted, ++seed);
    test_basis<Exact_integer>(20, 40, is_weighted, ++seed);
    test_basis<std::int64_t>(80, 40, is_weighted, ++seed);
    test_basis<Exact_integer>(20, 200, is_weighted, ++seed);
    test_basis<Exact_integer>(80, 200, is_weighted, ++seed);
  }
}

template <typename Function>
bool is_given_up(const Function& f)
{
  try {
    f();
  } catch(const Work_exceeded&) {
    return true;
  }
  return false;
}

// Where each value of a square is the mean of its neighbors. What takes too long is given up.
void test_bound_of_work()
{
  constexpr std::size_t side = 12;
  Matrix a;
  for(std::size_t i = 1; i + 1 < side; ++i)
    for(std::size_t j = 1; j + 1 < side; ++j) {
      Vector row(side * side, Exact_integer(0));
      const std::size_t k = i * side + j;
      row[k] = 4;
      for(const std::size_t n : {k - 1, k + 1, k - side, k + side})
        row[n] = -1;
      a.push_back(row);
    }
  const auto system = to_system(a, side * side);
  const std::size_t nullity = system.number_of_columns() - a.size();
  CHECK_EQUAL(Integer_lattice(system).kernel_basis().size(), nullity);
  CHECK_EQUAL(Integer_lattice(system, 1e9).kernel_basis().size(), nullity);
  CHECK(is_given_up([&] { Integer_lattice(system, 1e3); }));
}

// Each pivot changes all rows that follow.
void test_bound_of_elimination()
{
  constexpr std::size_t size = 10;
  Matrix a(size, Vector(2 * size, Exact_integer(1)));
  for(std::size_t i = 0; i < size; ++i)
    a[i][i] = 2;
  const Integer_system system = to_system(a, 2 * size);
  const Echelon_form form = eliminate(system, 1e6);
  CHECK_EQUAL(form.pivot_columns.size() + form.rows_in_core.size(), size);
  CHECK(is_given_up([&] { eliminate(system, 1e3); }));
  CHECK(is_given_up([&] { Unit_pivot_elimination<Exact_integer>(system, 1e4); }));
}

int main()
{
  test_bases(100);
  test_bound_of_work();
  test_bound_of_elimination();
  test_addendum();
  test_random_systems(4711);
  test_nearness(815);
  test_large_coefficients(42);
  test_growth(1, 30, 50);
  test_growth(2, 60, 80);
  test_growth(3, 100, 110);
  test_growth(4, 60, 170);
  return report_checks();
}
