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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H

#include <CGAL/license/Quad_remeshing.h>

// The solver of all sparse systems unless the caller names another one, and its matrices. The order
// of elimination depends on which entries a matrix has, not on their values: it is kept for the
// next matrix.

#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
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

  // \pre the matrix is compressed
  void set_zero() { m_sum.coeffs().setZero(); }

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
  std::size_t m_most_terms;
  bool m_is_compressed = false;
};

// A model of `SparseLinearAlgebraWithFactorTraits_d`.
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
      solver().analyzePattern(*m_mat);
    }
    solver().factorize(*m_mat);
    return solver().info() == Eigen::Success;
  }

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

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H
