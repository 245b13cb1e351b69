// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SPARSE_SYSTEM_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SPARSE_SYSTEM_H

#include <CGAL/license/Quad_remeshing.h>

// A sparse symmetric positive definite linear system, behind the solver interface of CGAL.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Default_solver.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Solvers of the caller get the whole matrix.
template <typename Solver>
constexpr bool reads_lower_triangle_only = std::is_same_v<Solver, Default_solver>;

// The time that factorizations and solves take is added to a counter of the caller.
template <typename Solver>
struct Timed_solver
{
  explicit Timed_solver(double& s) : seconds(s) { }

  Solver solver;
  double& seconds;
};

// `Solver` is a model of `SparseLinearAlgebraWithFactorTraits_d`. Systems that follow each other
// share one, as long as it has one matrix at a time.
template <typename Solver>
class Sparse_system
{
  using Matrix = typename Solver::Matrix;
  using Vector = typename Solver::Vector;

public:
  Sparse_system(const std::size_t dimension, Timed_solver<Solver>& solver)
    : m_dimension(dimension)
    , m_matrix(make_matrix())
    , m_scale(1)
    , m_solver(solver)
  { }

  std::size_t dimension() const { return m_dimension; }

  // After `factor()`, for a matrix of other values.
  void set_zero()
  {
    if constexpr(std::is_same_v<Solver, Default_solver>) {
      if(m_matrix)
        m_matrix->set_zero(); // keeps its pattern
    } else {
      m_matrix.reset(make_matrix());
    }
  }

  void add(const std::size_t row, const std::size_t column, const double value)
  {
    if(reads_lower_triangle_only<Solver> && column > row)
      return;
    m_matrix->add_coef(row, column, value);
  }

  // To be called after the last coefficient.
  void factor()
  {
    CGAL::Real_timer timer;
    timer.start();
    const bool success = m_dimension == 0 || m_solver.solver.factor(*m_matrix, m_scale);
    m_solver.seconds += timer.time();
    if(!success)
      throw Refusal(Outcome::SOLVER_FAILED, "a factorization failed");
  }

  std::vector<double> solve(const std::vector<double>& right_hand_side)
  {
    if(m_dimension == 0)
      return {};
    CGAL::Real_timer timer;
    timer.start();
    Vector b(m_dimension), x(m_dimension);
    for(std::size_t i = 0; i < m_dimension; ++i)
      b.set(i, right_hand_side[i]);
    const bool success = m_solver.solver.linear_solver(b, x);
    std::vector<double> result(m_dimension);
    bool finite = true;
    for(std::size_t i = 0; i < m_dimension; ++i) {
      result[i] = x[static_cast<int>(i)] / m_scale;
      finite = finite && std::isfinite(result[i]);
    }
    m_solver.seconds += timer.time();
    if(!success || !finite)
      throw Refusal(Outcome::SOLVER_FAILED, "a linear system could not be solved");
    return result;
  }

private:
  Matrix* make_matrix() const
  {
    const int dimension = static_cast<int>(m_dimension);
    return m_dimension == 0 ? nullptr : new Matrix(dimension, dimension);
  }

  std::size_t m_dimension;
  std::unique_ptr<Matrix> m_matrix; // its address must not change: solvers keep a pointer to it
  typename Solver::NT m_scale;
  Timed_solver<Solver>& m_solver;
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SPARSE_SYSTEM_H
