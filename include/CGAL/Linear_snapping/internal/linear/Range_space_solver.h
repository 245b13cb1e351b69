// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_RANGE_SPACE_SOLVER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_RANGE_SPACE_SOLVER_H

#include <CGAL/license/Linear_snapping.h>

// The minimum of a quadratic function under linear equations that come one after another: by the
// range-space method, which factorizes the function's matrix once, whatever the equations are.

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Equations that hold up to a tolerance without being asked for cost nothing but their evaluation;
// each of the others takes a solution, and k of them the Cholesky factorization of a dense matrix
// of k rows.
//
// \tparam Solver has factorized the function's matrix
template <typename Solver>
class Range_space_solver
{
public:
  // Unknowns and their factors.
  using Row = std::vector<std::pair<Eigen::Index, double> >;

  Range_space_solver(const Solver& solver, const Eigen::VectorXd& rhs)
    : m_solver(solver), m_free_minimum(solver.solve(rhs)), m_solution(m_free_minimum)
  { }

  void add(Row row, const double value) { m_equations.push_back({std::move(row), value, false}); }

  // The minimum under all equations that were added, except for equations that contradict others.
  const Eigen::VectorXd& solution()
  {
    for(std::vector<std::size_t> violated = most_violated(); !violated.empty();
        violated = most_violated())
      enforce(violated);
    return m_solution;
  }

private:
  struct Equation
  {
    Row row;
    double value;
    bool is_asked_for; // by what follows from the function, it need not hold
  };

  static constexpr double tolerance = 1e-3;
  static constexpr double dependent = 1e-10; // relative to an equation alone
  static constexpr std::size_t most_at_once = 32;

  static double evaluate(const Row& row, const Eigen::VectorXd& x)
  {
    double result = 0;
    for(const auto& [unknown, factor] : row)
      result += factor * x[unknown];
    return result;
  }

  double violation(const std::size_t equation) const
  {
    const Equation& e = m_equations[equation];
    return std::abs(e.value - evaluate(e.row, m_solution));
  }

  // Once asked for, an equation holds, or follows from others.
  std::vector<std::size_t> most_violated() const
  {
    std::vector<std::pair<double, std::size_t> > violations;
    for(std::size_t i = 0; i < m_equations.size(); ++i)
      if(const double v = m_equations[i].is_asked_for ? 0 : violation(i); v > tolerance)
        violations.emplace_back(-v, i);
    std::sort(violations.begin(), violations.end());
    std::vector<std::size_t> result;
    for(const auto& [v, i] : violations)
      if(result.size() < most_at_once)
        result.push_back(i);
    return result;
  }

  void enforce(const std::vector<std::size_t>& equations)
  {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(m_solution.size(), Eigen::Index(equations.size()));
    for(std::size_t i = 0; i < equations.size(); ++i)
      for(const auto& [unknown, factor] : m_equations[equations[i]].row)
        rows(unknown, Eigen::Index(i)) += factor;
    const Eigen::MatrixXd responses = m_solver.solve(rows);
    for(std::size_t i = 0; i < equations.size(); ++i) {
      m_equations[equations[i]].is_asked_for = true;
      add_to_factor(equations[i], responses.col(Eigen::Index(i)));
    }
    const auto k = Eigen::Index(m_asked.size());
    Eigen::VectorXd multipliers(k);
    for(Eigen::Index i = 0; i < k; ++i) {
      const Equation& e = m_equations[m_asked[std::size_t(i)]];
      multipliers[i] = e.value - evaluate(e.row, m_free_minimum);
    }
    const auto factor = m_factor.topLeftCorner(k, k).template triangularView<Eigen::Lower>();
    factor.solveInPlace(multipliers);
    factor.transpose().solveInPlace(multipliers);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(m_solution.size());
    for(Eigen::Index i = 0; i < k; ++i)
      for(const auto& [unknown, f] : m_equations[m_asked[std::size_t(i)]].row)
        forces[unknown] += f * multipliers[i];
    m_solution = m_free_minimum + m_solver.solve(forces);
  }

  // Adds a row to the factor of the matrix of responses to each other.
  void add_to_factor(const std::size_t equation, const Eigen::VectorXd& response)
  {
    const auto k = Eigen::Index(m_asked.size());
    if(k == m_factor.rows())
      m_factor.conservativeResize(2 * k + 16, 2 * k + 16);
    Eigen::VectorXd row(k);
    for(Eigen::Index i = 0; i < k; ++i)
      row[i] = evaluate(m_equations[m_asked[std::size_t(i)]].row, response);
    m_factor.topLeftCorner(k, k).template triangularView<Eigen::Lower>().solveInPlace(row);
    const double alone = evaluate(m_equations[equation].row, response),
                 rest = alone - row.squaredNorm();
    if(!(rest > dependent * alone))
      return;
    m_factor.row(k).head(k) = row.transpose();
    m_factor(k, k) = std::sqrt(rest);
    m_asked.push_back(equation);
  }

  const Solver& m_solver;
  Eigen::VectorXd m_free_minimum, m_solution;
  std::vector<Equation> m_equations;
  std::vector<std::size_t> m_asked; // for, and independent
  Eigen::MatrixXd m_factor;         // its lower left half: of those
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_RANGE_SPACE_SOLVER_H
