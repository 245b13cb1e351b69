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

// The solver of all sparse systems unless the caller names another one. The order of elimination
// depends on which entries a matrix has, not on their values: it is kept for the next matrix.

#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_sparse_matrix.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parametrization {

// A model of `SparseLinearAlgebraWithFactorTraits_d`.
class Default_solver
  : public CGAL::Eigen_solver_traits<
      Sparse_cholesky<CGAL::Eigen_sparse_matrix<double>::EigenType> >
{
public:
  bool factor(const Matrix& matrix, NT& scale)
  {
    scale = 1;
    m_mat = &matrix.eigen_object(); // compressed
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
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H
