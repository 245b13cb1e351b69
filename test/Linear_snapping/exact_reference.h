// Exact optima for the tests to compare with: min sum w (x - xbar)^2 subject to C x = b, solved in
// exact rational arithmetic by two solvers of CGAL that share nothing with each other or with the
// package: the quadratic programming solver and the closed form through fraction-free elimination.
//
// Both grow steeply: the quadratic program with about the fourth power of the number of unknowns
// (use it up to 100), the closed form with about the third (up to 400).

#ifndef SEAMLESS_SNAPPING_TEST_EXACT_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_EXACT_REFERENCE_H

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Linear_algebraHd.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace exact_reference {

using Integer = CGAL::Exact_integer;
using Rational = CGAL::Exact_rational;
using Rationals = std::vector<Rational>;

struct Entry
{
  std::size_t column;
  Rational coefficient;
};

using Row = std::vector<Entry>; // columns may repeat: their coefficients add up

// The constraints C x = b.
struct System
{
  std::size_t columns = 0;
  std::vector<Row> rows;
  Rationals b;

  void add_row(const Row& row, const Rational& right_hand_side = Rational(0))
  {
    rows.push_back(row);
    b.push_back(right_hand_side);
  }
};

struct Optimum
{
  bool feasible = false;
  Rational value = Rational(0); // of sum w (x - xbar)^2
  Rationals x;                  // empty if infeasible
};

template <typename Number>
Rationals to_rationals(const std::vector<Number>& values)
{
  Rationals result;
  result.reserve(values.size());
  for(const Number& value : values)
    result.push_back(Rational(value));
  return result;
}

inline Integer numerator(const Rational& q)
{
  Integer n, d;
  CGAL::Fraction_traits<Rational>::Decompose()(q, n, d);
  return n;
}

inline Integer denominator(const Rational& q)
{
  Integer n, d;
  CGAL::Fraction_traits<Rational>::Decompose()(q, n, d);
  return d;
}

inline Rational quotient(const Integer& n, const Integer& d)
{
  return CGAL::Fraction_traits<Rational>::Compose()(n, d);
}

inline Integer least_common_multiple(const Integer& a, const Integer& b)
{
  const Integer g = CGAL::gcd(a, b);
  const Integer quotient = CGAL::integral_division(a, g);
  const Integer product = quotient * b;
  return CGAL::abs(product);
}

inline Integer common_denominator(const Rationals& values)
{
  Integer result(1);
  for(const Rational& value : values)
    result = least_common_multiple(result, denominator(value));
  return result;
}

inline Integer scaled_to_integer(const Rational& value, const Integer& scale)
{
  const Rational scaled = value * Rational(scale);
  return numerator(scaled);
}

// Left side minus right side of one row.
inline Rational residual(const System& system, std::size_t row, const Rationals& x)
{
  Rational sum = -system.b[row];
  for(const Entry& entry : system.rows[row])
    sum += entry.coefficient * x[entry.column];
  return sum;
}

inline bool exactly_satisfies(const System& system, const Rationals& x)
{
  for(std::size_t r = 0; r < system.rows.size(); ++r)
    if(residual(system, r, x) != 0)
      return false;
  return true;
}

template <typename Number>
bool exactly_satisfies(const System& system, const std::vector<Number>& x)
{
  return exactly_satisfies(system, to_rationals(x));
}

// Empty weights mean 1.
inline Rational squared_distance(const Rationals& x, const Rationals& xbar,
                                 const Rationals& weights = Rationals())
{
  Rational sum(0);
  for(std::size_t i = 0; i < x.size(); ++i) {
    const Rational difference = x[i] - xbar[i];
    const Rational square = difference * difference;
    sum += weights.empty() ? square : Rational(weights[i] * square);
  }
  return sum;
}

// The same problem in integers: with z = scale (x - xbar) it reads min sum weights z^2 subject to
// coefficients z = right_hand_side, so that no entry of xbar enters a matrix.
struct Integer_problem
{
  struct Integer_entry
  {
    std::size_t column;
    Integer coefficient;
  };

  Integer scale;
  std::vector<std::vector<Integer_entry> > coefficients; // columns increase along each row
  std::vector<Integer> right_hand_side;
  std::vector<Integer> weights;
};

inline Row merged(Row row)
{
  std::sort(row.begin(), row.end(),
            [](const Entry& a, const Entry& b) { return a.column < b.column; });
  Row result;
  for(const Entry& entry : row) {
    if(!result.empty() && result.back().column == entry.column)
      result.back().coefficient += entry.coefficient;
    else
      result.push_back(entry);
  }
  result.erase(std::remove_if(result.begin(), result.end(),
                              [](const Entry& e) { return e.coefficient == 0; }),
               result.end());
  return result;
}

// The multiples of the rows add up to 0 = c with c other than 0.
inline bool is_contradiction(const System& system,
                             const std::vector<std::pair<std::size_t, Integer> >& certificate)
{
  Row sum;
  Rational b(0);
  for(const auto& term : certificate) {
    for(const auto& entry : system.rows.at(term.first))
      sum.push_back({ entry.column, Rational(entry.coefficient * Rational(term.second)) });
    b += Rational(term.second) * system.b[term.first];
  }
  return merged(sum).empty() && b != 0;
}

inline Integer_problem integer_problem(const System& system, const Rationals& xbar,
                                       const Rationals& weights)
{
  Integer_problem result;
  Rationals violations;
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    const Row row = merged(system.rows[r]);
    Rationals coefficients;
    for(const Entry& entry : row)
      coefficients.push_back(entry.coefficient);
    const Integer clearing = common_denominator(coefficients);

    result.coefficients.emplace_back();
    for(const Entry& entry : row)
      result.coefficients.back().push_back(
        { entry.column, scaled_to_integer(entry.coefficient, clearing) });
    violations.push_back(-residual(system, r, xbar) * Rational(clearing));
  }

  result.scale = common_denominator(violations);
  for(const Rational& violation : violations)
    result.right_hand_side.push_back(scaled_to_integer(violation, result.scale));

  const Integer weight_scale = common_denominator(weights);
  result.weights.assign(system.columns, Integer(1));
  for(std::size_t i = 0; i < weights.size(); ++i)
    result.weights[i] = scaled_to_integer(weights[i], weight_scale);
  return result;
}

inline Optimum finished(const Rationals& z, const Integer& scale, const Rationals& xbar,
                        const Rationals& weights)
{
  Optimum result;
  result.feasible = true;
  for(std::size_t i = 0; i < xbar.size(); ++i)
    result.x.push_back(xbar[i] + z[i] / Rational(scale));
  result.value = squared_distance(result.x, xbar, weights);
  return result;
}

// The verdict and the optimum of CGAL's quadratic programming solver.
inline Optimum optimum_by_quadratic_program(const System& system, const Rationals& xbar,
                                            const Rationals& weights = Rationals())
{
  const Integer_problem problem = integer_problem(system, xbar, weights);
  CGAL::Quadratic_program<Integer> program(CGAL::EQUAL, false, Integer(0), false, Integer(0));
  for(std::size_t i = 0; i < system.columns; ++i) {
    const Integer twice = problem.weights[i] * 2; // the solver asks for 2D
    program.set_d(static_cast<int>(i), static_cast<int>(i), twice);
    program.set_c(static_cast<int>(i), Integer(0));
  }
  for(std::size_t r = 0; r < problem.coefficients.size(); ++r) {
    for(const Integer_problem::Integer_entry& entry : problem.coefficients[r])
      program.set_a(static_cast<int>(entry.column), static_cast<int>(r), entry.coefficient);
    program.set_b(static_cast<int>(r), problem.right_hand_side[r]);
  }

  const CGAL::Quadratic_program_solution<Integer> solution =
    CGAL::solve_quadratic_program(program, Integer());
  if(!solution.is_optimal())
    return Optimum();

  Rationals z;
  for(auto it = solution.variable_values_begin(); it != solution.variable_values_end(); ++it)
    z.push_back(quotient((*it).numerator(), (*it).denominator()));
  return finished(z, problem.scale, xbar, weights);
}

// A maximal set of linearly independent rows, found by exact elimination.
inline std::vector<int> independent_rows(const Integer_problem& problem, std::size_t columns)
{
  using Algebra = CGAL::Linear_algebraHd<Integer>;
  std::vector<int> result;
  if(problem.coefficients.empty() || columns == 0)
    return result;
  Algebra::Matrix transposed(static_cast<int>(columns),
                             static_cast<int>(problem.coefficients.size()));
  for(std::size_t r = 0; r < problem.coefficients.size(); ++r)
    for(const Integer_problem::Integer_entry& entry : problem.coefficients[r])
      transposed(static_cast<int>(entry.column), static_cast<int>(r)) = entry.coefficient;
  Algebra::independent_columns(transposed, result);
  return result;
}

// x = xbar + W^-1 C^T (C W^-1 C^T)^-1 (b - C xbar) on independent rows of C; the rows left out then
// tell whether the system has a solution at all. The inverse weights are brought to one common
// denominator: take weights that are small integers or powers of two, or the numbers get long.
inline Optimum optimum_in_closed_form(const System& system, const Rationals& xbar,
                                      const Rationals& weights = Rationals())
{
  using Algebra = CGAL::Linear_algebraHd<Integer>;
  const Integer_problem problem = integer_problem(system, xbar, weights);
  const std::vector<int> rows = independent_rows(problem, system.columns);
  const int rank = static_cast<int>(rows.size());

  Integer all_weights(1);
  for(const Integer& weight : problem.weights)
    all_weights = least_common_multiple(all_weights, weight);
  std::vector<Integer> inverse_weights;
  for(const Integer& weight : problem.weights)
    inverse_weights.push_back(CGAL::integral_division(all_weights, weight));

  std::vector<std::vector<Integer> > dense(rows.size(),
                                           std::vector<Integer>(system.columns, Integer(0)));
  for(std::size_t i = 0; i < rows.size(); ++i)
    for(const auto& entry : problem.coefficients[static_cast<std::size_t>(rows[i])])
      dense[i][entry.column] = entry.coefficient;

  Rationals z(system.columns, Rational(0));
  if(rank > 0) {
    Algebra::Matrix normal(rank, rank);
    Algebra::Vector rhs(rank), multipliers(rank);
    for(int i = 0; i < rank; ++i) {
      const std::size_t row = static_cast<std::size_t>(i);
      rhs[i] = problem.right_hand_side[static_cast<std::size_t>(rows[row])];
      for(int j = 0; j < rank; ++j) {
        Integer sum(0);
        for(const auto& entry : problem.coefficients[static_cast<std::size_t>(rows[row])]) {
          const Integer& other = dense[static_cast<std::size_t>(j)][entry.column];
          sum += entry.coefficient * inverse_weights[entry.column] * other;
        }
        normal(i, j) = sum;
      }
    }
    Integer common(1);
    Algebra::linear_solver(normal, rhs, multipliers, common);
    for(std::size_t c = 0; c < system.columns; ++c) {
      Integer sum(0);
      for(int i = 0; i < rank; ++i)
        sum += dense[static_cast<std::size_t>(i)][c] * multipliers[i];
      sum *= inverse_weights[c];
      z[c] = quotient(sum, common);
    }
  }

  const Optimum result = finished(z, problem.scale, xbar, weights);
  return exactly_satisfies(system, result.x) ? result : Optimum();
}

} // namespace exact_reference

#endif // SEAMLESS_SNAPPING_TEST_EXACT_REFERENCE_H
