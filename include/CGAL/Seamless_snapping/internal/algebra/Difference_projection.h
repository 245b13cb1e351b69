// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_DIFFERENCE_PROJECTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_DIFFERENCE_PROJECTION_H

#include <CGAL/license/Seamless_snapping.h>

// The linear part of the weighted least-squares projection, for many differences in turn: factorizes once.

#include <CGAL/Seamless_snapping/internal/algebra/Least_squares_projection.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Difference_projection
{
public:
  template <typename Integer>
  Difference_projection(const Integer_system<Integer>& system,
                        const std::vector<Row_index>& independent_rows,
                        const std::vector<double>& weights)
    : m_scales(Eigen::Index(weights.size()))
  {
    std::vector<double> scales;
    for(const double w : weights)
      scales.push_back(1. / std::sqrt(w));
    m_scales = Eigen::Map<const Eigen::VectorXd>(scales.data(), m_scales.size());
    Eigen::VectorXd row_scales;
    m_rows = scaled_rows(system, independent_rows, scales, row_scales);
    const Eigen::SparseMatrix<double> normal = normal_matrix(m_rows);
    if(normal.rows() == m_rows.cols() && m_rows.cols() > 0)
      m_cholesky = std::make_unique<Cholesky>(normal);
  }

  // The nearest difference between solutions.
  Eigen::VectorXd operator()(const Eigen::VectorXd& difference) const
  {
    if(m_rows.cols() == 0)
      return difference;
    const Eigen::VectorXd scaled = difference.cwiseQuotient(m_scales);
    const Eigen::VectorXd r = m_rows.transpose() * scaled;
    if(m_cholesky == nullptr || m_cholesky->info() != Eigen::Success)
      return m_scales.cwiseProduct(scaled - shortest_solution(m_rows, r));
    return m_scales.cwiseProduct(scaled - m_rows * m_cholesky->solve(r));
  }

private:
  using Cholesky = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

  Eigen::VectorXd m_scales; // 1/sqrt(w)
  Eigen::SparseMatrix<double> m_rows; // as columns
  std::unique_ptr<Cholesky> m_cholesky; // none for systems whose normal matrix is too dense
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_DIFFERENCE_PROJECTION_H
