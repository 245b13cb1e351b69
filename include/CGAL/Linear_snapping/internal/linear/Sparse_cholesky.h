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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H

#include <CGAL/license/Linear_snapping.h>

// The solver of large sparse systems that need not be exact: CHOLMOD of SuiteSparse where the build
// system has found it and defines CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE, and Eigen's own
// elsewhere. CHOLMOD works on dense blocks, which pays where the factor is dense: on large meshes,
// and where cones couple the two coordinates.

#include <Eigen/SparseCore>

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE
#include <CGAL/Linear_snapping/internal/linear/One_blas_thread.h>

#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace CGAL {
namespace Linear_snapping {
namespace internal {

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE

// CHOLMOD would print each failure to the standard output, which belongs to the caller.
template <typename Matrix>
class Sparse_cholesky : public Eigen::CholmodDecomposition<Matrix>
{
  using Base = Eigen::CholmodDecomposition<Matrix>;

public:
  Sparse_cholesky() { this->cholmod().print = 0; }

  void compute(const Matrix& matrix)
  {
    analyzePattern(matrix);
    factorize(matrix);
  }

  // CHOLMOD would try METIS as well, which takes several times as long on large matrices as the
  // factorizations gain that follow.
  void analyzePattern(const Matrix& matrix)
  {
    constexpr int large = 110000;
    this->cholmod().nmethods = matrix.cols() > large ? 1 : 0;
    this->cholmod().method[0].ordering = CHOLMOD_AMD;
    Base::analyzePattern(matrix);
  }

  void factorize(const Matrix& matrix)
  {
    const One_blas_thread guard;
    Base::factorize(matrix);
  }

  template <typename Right_hand_side>
  typename Right_hand_side::PlainObject solve(const Right_hand_side& b) const
  {
    const One_blas_thread guard;
    return Base::solve(b);
  }
};

#else

template <typename Matrix>
using Sparse_cholesky = Eigen::SimplicialLDLT<Matrix>;

#endif

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H
