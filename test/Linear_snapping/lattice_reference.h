// What solutions a system of linear equations has on grids: which powers of two suffice, and how
// far apart the solutions on a grid lie. Exact, for small systems, with CGAL's numbers only.

#ifndef SEAMLESS_SNAPPING_TEST_LATTICE_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_LATTICE_REFERENCE_H

#include "exact_reference.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace exact_reference {

using Integer_vector = std::vector<Integer>;

// Linearly independent integer vectors z with C z = 0, as many as there are, each without a common
// factor. (They span a sublattice of all such vectors: the one that rounding each free variable to
// a multiple of what the implied ones are divided by, Sec. 4.3, chooses from.)
inline std::vector<Integer_vector> kernel_vectors(const System& system)
{
  using Algebra = CGAL::Linear_algebraHd<Integer>;
  const int columns = static_cast<int>(system.columns);
  const int rows = static_cast<int>(system.rows.size());
  Algebra::Matrix matrix(rows > 0 ? rows : 1, columns), spanning;
  const Rationals zeros(system.columns, Rational(0));
  const Integer_problem problem = integer_problem(system, zeros, Rationals());
  for(int r = 0; r < rows; ++r)
    for(const auto& entry : problem.coefficients[static_cast<std::size_t>(r)])
      matrix(r, static_cast<int>(entry.column)) = entry.coefficient;

  std::vector<Integer_vector> result;
  const int dimension = Algebra::homogeneous_linear_solver(matrix, spanning);
  for(int j = 0; j < dimension; ++j) {
    Integer_vector vector;
    Integer common(0);
    for(int i = 0; i < columns; ++i) {
      vector.push_back(spanning(i, j));
      common = CGAL::gcd(common, vector.back());
    }
    for(Integer& entry : vector)
      entry = CGAL::integral_division(entry, common);
    result.push_back(vector);
  }
  return result;
}

// A point of the solution space is within this distance of a solution on the grid of step 1, if
// there is any: half the sum of the lengths of kernel vectors, for one can round along each in
// turn. The first number is the distance weighted as in the squared change, the second the largest
// component.
inline std::pair<double, double> grid_radius(const std::vector<Integer_vector>& kernel,
                                             const Rationals& weights)
{
  std::pair<double, double> result(0, 0);
  for(const Integer_vector& vector : kernel) {
    double square = 0, largest = 0;
    for(std::size_t i = 0; i < vector.size(); ++i) {
      const double entry = std::abs(CGAL::to_double(vector[i]));
      square += (weights.empty() ? 1. : CGAL::to_double(weights[i])) * entry * entry;
      largest = (std::max)(largest, entry);
    }
    result.first += std::sqrt(square) / 2;
    result.second += largest / 2;
  }
  return result;
}

struct Dyadic_solvability
{
  bool is_solvable = true; // by integers times powers of two
  int bits = 0;            // then the coarsest grid with a solution has the step 2^-bits
};

// Adds multiples of the columns from `first` on to each other until at most the first of them has
// an entry in the row (Euclid's algorithm). Such steps keep the integer solutions.
inline void clear_row(std::vector<Integer_vector>& columns, std::size_t first, std::size_t row)
{
  for(std::size_t j = first + 1; j < columns.size(); ++j) {
    while(columns[j][row] != 0) {
      const Integer factor = columns[first][row] / columns[j][row];
      for(std::size_t r = 0; r < columns[j].size(); ++r)
        columns[first][r] -= factor * columns[j][r];
      std::swap(columns[first], columns[j]);
    }
  }
}

inline int exponent_of_two(Integer n)
{
  int result = 0;
  while(n != 0 && n % 2 == 0) {
    n /= 2;
    ++result;
  }
  return result;
}

inline Integer power_of_two(int exponent)
{
  Integer result(1);
  for(int i = 0; i < exponent; ++i)
    result *= 2;
  return result;
}

// Whether the system, which must be consistent, has solutions on any grid 2^-bits Z. After the
// unimodular column operations each row fixes one new unknown at most; a solution has as many bits
// as these.
inline Dyadic_solvability dyadic_solvability(const System& system)
{
  const Integer_problem problem =
    integer_problem(system, Rationals(system.columns, Rational(0)), Rationals());
  const std::size_t rows = system.rows.size();
  std::vector<Integer_vector> columns(system.columns, Integer_vector(rows, Integer(0)));
  for(std::size_t r = 0; r < rows; ++r)
    for(const auto& entry : problem.coefficients[r])
      columns[entry.column][r] = entry.coefficient;

  Dyadic_solvability result;
  std::vector<Rational> known;
  for(std::size_t r = 0; r < rows; ++r) {
    if(known.size() == columns.size())
      break;
    clear_row(columns, known.size(), r);
    if(columns[known.size()][r] == 0)
      continue;
    Rational rest = quotient(problem.right_hand_side[r], problem.scale);
    for(std::size_t j = 0; j < known.size(); ++j)
      rest -= Rational(columns[j][r]) * known[j];
    const Rational value = rest / Rational(columns[known.size()][r]);
    const Integer d = denominator(value);
    const int bits = exponent_of_two(d);
    result.is_solvable = result.is_solvable && d == power_of_two(bits);
    result.bits = (std::max)(result.bits, bits);
    known.push_back(value);
  }
  return result;
}

} // namespace exact_reference

#endif // SEAMLESS_SNAPPING_TEST_LATTICE_REFERENCE_H
