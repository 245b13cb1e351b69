// How close a solution of a small system lies on one grid: an upper bound of the optimum, found in
// exact integers by other means than the package's, and so what a snap can be measured against.

#ifndef SEAMLESS_SNAPPING_TEST_GRID_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_GRID_REFERENCE_H

#include "exact_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace grid_reference {

using exact_reference::Integer;
using exact_reference::Rational;
using Integers = std::vector<Integer>;

// C x = b with integers as coefficients; dense.
struct Small_system
{
  std::vector<Integers> rows;
  std::vector<Rational> b;
  std::size_t columns = 0;
};

inline Rational power_of_two(int exponent)
{
  Rational result(1);
  const Rational factor = exponent < 0 ? Rational(1) / Rational(2) : Rational(2);
  for(int i = 0; i < std::abs(exponent); ++i)
    result *= factor;
  return result;
}

inline Integer product(const Integers& a, const Integers& b)
{
  Integer sum(0);
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

inline bool shorten(Integers& a, const Integers& b)
{
  const Integer square = product(b, b), dot = product(a, b);
  if(2 * CGAL::abs(dot) <= square)
    return false;
  const Integer twice = 2 * dot + square, divisor = 2 * square; // floor(dot / square + 1/2)
  Integer factor = twice / divisor;
  if(factor * divisor > twice)
    --factor;
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i] -= factor * b[i];
  return factor != 0;
}

// All integer solutions of C Y = B: one of them, and a basis of the differences.
class Solutions
{
public:
  explicit Solutions(const Small_system& system) : m_system(system)
  {
    // Unimodular column operations bring C to echelon form; below it, they are noted.
    const std::size_t m = system.rows.size(), n = system.columns;
    for(std::size_t j = 0; j < n; ++j) {
      Integers column;
      for(std::size_t i = 0; i < m; ++i)
        column.push_back(system.rows[i][j]);
      column.resize(m + n, Integer(0));
      column[m + j] = 1;
      m_columns.push_back(column);
    }
    for(std::size_t i = 0; i < m; ++i)
      clear_row(i);
    for(std::size_t j = m_rank; j < n; ++j)
      m_basis.emplace_back(m_columns[j].begin() + std::ptrdiff_t(m), m_columns[j].end());
    reduce();
  }

  const std::vector<Integers>& basis() const { return m_basis; }

  // One solution for the right-hand sides b / step, if there is any.
  std::optional<Integers> particular(const Rational& step) const
  {
    const std::size_t m = m_system.rows.size();
    Integers y(m_system.columns, Integer(0));
    std::size_t pivot = 0;
    for(std::size_t i = 0; i < m; ++i) {
      Rational rest = m_system.b[i] / step;
      for(std::size_t j = 0; j < m_system.columns; ++j)
        rest -= Rational(m_system.rows[i][j] * y[j]);
      const bool has_pivot = pivot < m_rank && m_pivot_rows[pivot] == i;
      if(rest == 0) {
        pivot += has_pivot;
        continue;
      }
      if(!has_pivot)
        return std::nullopt;
      const Rational factor = rest / Rational(m_columns[pivot][i]);
      if(exact_reference::denominator(factor) != 1)
        return std::nullopt;
      for(std::size_t j = 0; j < y.size(); ++j)
        y[j] += exact_reference::numerator(factor) * m_columns[pivot][m + j];
      ++pivot;
    }
    return y;
  }

private:
  void clear_row(const std::size_t i)
  {
    for(std::size_t j = m_rank + 1; j < m_columns.size(); ++j)
      while(m_columns[j][i] != 0) {
        const Integer factor = m_columns[m_rank][i] / m_columns[j][i];
        for(std::size_t r = 0; r < m_columns[j].size(); ++r)
          m_columns[m_rank][r] -= factor * m_columns[j][r];
        std::swap(m_columns[m_rank], m_columns[j]);
      }
    if(m_rank < m_columns.size() && m_columns[m_rank][i] != 0) {
      m_pivot_rows.push_back(i);
      ++m_rank;
    }
  }

  // Lagrange's algorithm, pair by pair, until nothing becomes shorter.
  void reduce()
  {
    for(bool again = true; again;) {
      again = false;
      for(std::size_t i = 0; i < m_basis.size(); ++i)
        for(std::size_t j = 0; j < m_basis.size(); ++j)
          again = (i != j && shorten(m_basis[i], m_basis[j])) || again;
    }
  }

  const Small_system& m_system;
  std::vector<Integers> m_columns; // of C, and what they are made of
  std::vector<Integers> m_basis;
  std::vector<std::size_t> m_pivot_rows;
  std::size_t m_rank = 0;
};

struct Near_solution
{
  double largest_change;
  double step;
};

// Subtracts the rounded combination of independent vectors that is nearest: single ones would need
// very many steps where they are nearly dependent.
inline void subtract_nearest(Integers& a, const std::vector<Integers>& vectors)
{
  const std::size_t d = vectors.size();
  std::vector<std::vector<Rational> > rows(d); // normal equations
  for(std::size_t k = 0; k < d; ++k) {
    for(const Integers& v : vectors)
      rows[k].emplace_back(product(vectors[k], v));
    rows[k].emplace_back(product(vectors[k], a));
  }
  for(std::size_t k = 0; k < d; ++k) // pivots are positive, as the matrix is positive definite
    for(std::size_t i = 0; i < d; ++i) {
      const Rational factor = rows[i][k] / rows[k][k];
      for(std::size_t j = k; i != k && j <= d; ++j)
        rows[i][j] -= factor * rows[k][j];
    }
  for(std::size_t k = 0; k < d; ++k) {
    const Rational c = rows[k][d] / rows[k][k];
    const Integer factor =
      (2 * exact_reference::numerator(c) + exact_reference::denominator(c)) /
      (2 * exact_reference::denominator(c));
    for(std::size_t j = 0; j < a.size(); ++j)
      a[j] -= factor * vectors[k][j];
  }
}

// Rounds to a near solution in the basis, then tries all neighbours.
inline double largest_change(const Solutions& solutions, Integers y, const std::vector<Rational>& x)
{
  const std::vector<Integers>& basis = solutions.basis();
  const auto difference = [&](const Integers& z, const std::size_t j) {
    return CGAL::to_double(Rational(z[j]) - x[j]);
  };
  const std::size_t d = basis.size(), n = y.size();
  const Integer unit(1 << 20); // 20 binary digits of x behind the point are enough
  Integers rest(n), rounded(n);
  for(std::size_t j = 0; j < n; ++j) {
    const Rational scaled = x[j] * Rational(unit);
    rounded[j] = exact_reference::numerator(scaled) / exact_reference::denominator(scaled);
    rest[j] = y[j] * unit - rounded[j];
  }
  std::vector<Integers> steps(basis);
  for(Integers& step : steps)
    for(Integer& z : step)
      z *= unit;
  subtract_nearest(rest, steps);
  for(bool again = true; again;) {
    again = false;
    for(const Integers& step : steps)
      again = shorten(rest, step) || again;
  }
  for(std::size_t j = 0; j < n; ++j)
    y[j] = (rest[j] + rounded[j]) / unit;
  double best = -1;
  std::vector<int> step(d, -1);
  for(;;) {
    Integers z(y);
    for(std::size_t k = 0; k < d; ++k)
      for(std::size_t j = 0; j < n; ++j)
        z[j] += step[k] * basis[k][j];
    double change = 0;
    bool fits = true; // 2^53 + 1 is 2^53 as a double
    for(std::size_t j = 0; j < n; ++j) {
      change = (std::max)(change, std::abs(difference(z, j)));
      fits = fits && CGAL::abs(z[j]) <= Integer(0x1p53);
    }
    if(fits && (best < 0 || change < best))
      best = change;
    std::size_t k = 0;
    while(k < d && step[k] == 1)
      step[k++] = -1;
    if(k == d)
      return best;
    ++step[k];
  }
}

// The largest change on the way to a solution on the finest grid on which one was found whose
// values have 53 bits at most.
inline std::optional<Near_solution> nearest_on_one_grid(const Small_system& system,
                                                        const std::vector<double>& x)
{
  double largest = 0;
  for(const double value : x)
    largest = (std::max)(largest, std::abs(value));
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Solutions solutions(system);
  for(int e = exponent - 54; e < exponent + 4; ++e) {
    const Rational step = power_of_two(e);
    const std::optional<Integers> y = solutions.particular(step);
    if(!y)
      return std::nullopt; // nor on any coarser grid
    std::vector<Rational> target;
    for(const double value : x)
      target.push_back(Rational(value) / step);
    const double change = largest_change(solutions, *y, target);
    if(change >= 0)
      return Near_solution{change * std::ldexp(1., e), std::ldexp(1., e)};
  }
  return std::nullopt;
}

} // namespace grid_reference

#endif // SEAMLESS_SNAPPING_TEST_GRID_REFERENCE_H
