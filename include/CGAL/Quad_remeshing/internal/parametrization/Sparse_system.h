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

// A sparse symmetric positive definite linear system, and solvers for it of any type.

#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Real_timer.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// A matrix that is the sum of many terms, several times as many as its entries: a part of them is
// kept at a time. Once it is compressed, terms are added to the entries that it has.
class Matrix_of_terms
{
public:
  using Compressed = Eigen::SparseMatrix<double>;

  Matrix_of_terms(const int rows, const int columns)
    : m_sum(rows, columns),
      m_most_terms((std::max)(std::size_t(1) << 20, 4 * std::size_t(rows)))
  { }

  void add_coef(const std::size_t row, const std::size_t column, const double value)
  {
    if(m_is_compressed) {
      m_sum.coeffRef(Eigen::Index(row), Eigen::Index(column)) += value;
      return;
    }
    if(m_terms.size() == m_most_terms)
      add_terms();
    m_terms.emplace_back(int(row), int(column), value);
  }

  const Compressed& compress()
  {
    if(!m_terms.empty())
      add_terms();
    m_terms.shrink_to_fit();
    m_is_compressed = true;
    return m_sum;
  }

  // The block of each column. Columns of a block are close together in the order of elimination.
  const std::vector<int>& blocks() const { return m_blocks; }
  void set_blocks(std::vector<int> blocks) { m_blocks = std::move(blocks); }

  // \pre the matrix is compressed
  void set_zero() { m_sum.coeffs().setZero(); }
  void enlarge_diagonal(const double factor) { m_sum.diagonal() *= factor; }

private:
  void add_terms()
  {
    Compressed sum(m_sum.rows(), m_sum.cols());
    sum.setFromTriplets(m_terms.begin(), m_terms.end());
    m_terms.clear();
    if(m_sum.nonZeros() > 0)
      sum = Compressed(m_sum + sum);
    m_sum.swap(sum);
  }

  std::vector<Eigen::Triplet<double> > m_terms;
  Compressed m_sum;
  std::vector<int> m_blocks;
  std::size_t m_most_terms;
  bool m_is_compressed = false;
};

// The solver unless the caller names another one: a model of
// `SparseLinearAlgebraWithFactorTraits_d`. The order of elimination depends on which entries a
// matrix has, not on their values: it is kept for the next matrix.
class Default_solver
  : public CGAL::Eigen_solver_traits<Sparse_cholesky<Matrix_of_terms::Compressed> >
{
public:
  using Matrix = Matrix_of_terms;

  bool factor(Matrix& matrix, NT& scale)
  {
    scale = 1;
    m_mat = &matrix.compress();
    if(!has_pattern()) {
      m_columns.assign(m_mat->outerIndexPtr(), m_mat->outerIndexPtr() + m_mat->outerSize() + 1);
      m_rows.assign(m_mat->innerIndexPtr(), m_mat->innerIndexPtr() + m_mat->nonZeros());
      if(matrix.blocks().empty())
        solver().analyzePattern(*m_mat);
      else
        solver().analyzePattern(*m_mat, matrix.blocks());
    }
    solver().factorize(*m_mat);
    return solver().info() == Eigen::Success;
  }

  double number_of_multiplications() { return solver().number_of_multiplications(); }

private:
  bool has_pattern() const
  {
    return std::equal(m_columns.begin(), m_columns.end(), m_mat->outerIndexPtr(),
                      m_mat->outerIndexPtr() + m_mat->outerSize() + 1) &&
           std::equal(m_rows.begin(), m_rows.end(), m_mat->innerIndexPtr(),
                      m_mat->innerIndexPtr() + m_mat->nonZeros());
  }

  std::vector<int> m_columns, m_rows; // of the matrix whose pattern was analyzed
};

// A solver of any type, so that nothing else depends on it. Returns whether it succeeded.
class Sparse_solver
{
public:
  virtual ~Sparse_solver() = default;
  // \param lower_triangle which stays as it is until the last `solve()`
  virtual bool factor(Matrix_of_terms& lower_triangle) = 0;
  virtual bool solve(const std::vector<double>& right_hand_side, std::vector<double>& x) = 0;
  // The multiplications of the last factorization; 0 if they are not known.
  virtual double number_of_multiplications() { return 0; }
};

// `Solver` is a model of `SparseLinearAlgebraWithFactorTraits_d`, and gets the whole matrix, but
// for the default one.
template <typename Solver>
class Sparse_solver_of_type
  : public Sparse_solver
{
public:
  bool factor(Matrix_of_terms& lower_triangle) override
  {
    if constexpr(std::is_same_v<Solver, Default_solver>) {
      return m_solver.factor(lower_triangle, m_scale);
    } else {
      const Matrix_of_terms::Compressed& lower = lower_triangle.compress();
      m_matrix = std::make_unique<Matrix>(static_cast<int>(lower.rows()),
                                          static_cast<int>(lower.cols()));
      for(int column = 0; column < lower.outerSize(); ++column)
        for(Matrix_of_terms::Compressed::InnerIterator entry(lower, column); entry; ++entry) {
          const std::size_t i = std::size_t(entry.row()), j = std::size_t(column);
          m_matrix->add_coef(i, j, entry.value());
          if(i != j)
            m_matrix->add_coef(j, i, entry.value());
        }
      return m_solver.factor(*m_matrix, m_scale);
    }
  }

  bool solve(const std::vector<double>& right_hand_side, std::vector<double>& x) override
  {
    Vector b(x.size()), solution(x.size());
    for(std::size_t i = 0; i < x.size(); ++i)
      b.set(i, right_hand_side[i]);
    const bool success = m_solver.linear_solver(b, solution);
    for(std::size_t i = 0; i < x.size(); ++i)
      x[i] = solution[static_cast<int>(i)] / m_scale;
    return success;
  }

  double number_of_multiplications() override
  {
    if constexpr(std::is_same_v<Solver, Default_solver>)
      return m_solver.number_of_multiplications();
    return 0;
  }

private:
  using Matrix = typename Solver::Matrix;
  using Vector = typename Solver::Vector;

  std::unique_ptr<Matrix> m_matrix; // its address must not change: solvers keep a pointer to it
  Solver m_solver;
  typename Solver::NT m_scale = 1;
};

using Make_solver = std::unique_ptr<Sparse_solver> (*)();

template <typename Solver>
std::unique_ptr<Sparse_solver> make_solver()
{ return std::make_unique<Sparse_solver_of_type<Solver> >(); }

// The time that factorizations and solves take is added to a counter of the caller, and what they
// take of work is counted.
struct Timed_solver
{
  explicit Timed_solver(double& s, const Make_solver m = make_solver<Default_solver>)
    : make(m), solver(make()), seconds(s)
  { }

  void reset() { solver = make(); }

  Make_solver make;
  std::unique_ptr<Sparse_solver> solver;
  double& seconds;
  double multiplications = 0; // of factorizations
};

// Systems that follow each other share a solver, as long as it has one matrix at a time.
class Sparse_system
{
public:
  Sparse_system(const std::size_t dimension, Timed_solver& solver)
    : m_dimension(dimension),
      m_matrix(std::make_unique<Matrix_of_terms>(static_cast<int>(dimension),
                                                 static_cast<int>(dimension))),
      m_solver(solver)
  { }

  std::size_t dimension() const { return m_dimension; }

  void set_blocks(std::vector<int> blocks) { m_matrix->set_blocks(std::move(blocks)); }

  // After `factor()`, for a matrix of other values, at the same places.
  void set_zero() { m_matrix->set_zero(); }

  void add(const std::size_t row, const std::size_t column, const double value)
  {
    if(column <= row)
      m_matrix->add_coef(row, column, value);
  }

  // To be called after the last coefficient. The matrix is positive definite, but coefficients of
  // long sums can hide that in roundings: then its diagonal is made a little larger.
  void factor()
  {
    Progress::tell_each_second([&] { return "solving for " + counted(m_dimension, "unknown"); });
    CGAL::Real_timer timer;
    timer.start();
    bool success = m_dimension == 0 || m_solver.solver->factor(*m_matrix);
    for(const double part : {1e-12, 1e-9})
      if(!success) {
        m_matrix->enlarge_diagonal(1 + part);
        success = m_solver.solver->factor(*m_matrix);
      }
    m_solver.seconds += timer.time();
    m_solver.multiplications += m_solver.solver->number_of_multiplications();
    if(!success)
      throw Refusal(Outcome::SOLVER_FAILED, "a factorization failed");
  }

  std::vector<double> solve(const std::vector<double>& right_hand_side)
  {
    if(m_dimension == 0)
      return {};
    CGAL::Real_timer timer;
    timer.start();
    std::vector<double> result(m_dimension);
    const bool success = m_solver.solver->solve(right_hand_side, result) &&
                         std::all_of(result.begin(), result.end(),
                                     [](const double x) { return std::isfinite(x); });
    m_solver.seconds += timer.time();
    if(!success)
      throw Refusal(Outcome::SOLVER_FAILED, "a linear system could not be solved");
    return result;
  }

private:
  std::size_t m_dimension;
  std::unique_ptr<Matrix_of_terms> m_matrix; // at an address that the solver keeps
  Timed_solver& m_solver;
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SPARSE_SYSTEM_H
