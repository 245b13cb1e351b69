// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H

#include <CGAL/license/Seamless_snapping.h>

// The distortion of a triangle as a function of its Jacobian, in the form of [Garanzha et al. 2021]
// that is finite, but large, where the triangle is flipped.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Templates, here and in the minimizer, so that programs that don't untangle needn't compile them.

// du/dx, du/dy, dv/dx, dv/dy, for x and y of the reference shape.
template <typename FT>
using Jacobian = Eigen::Matrix<FT, 4, 1>;

template <typename FT>
FT determinant(const Jacobian<FT>& j) { return j[0] * j[3] - j[1] * j[2]; }

// (|J|^2 + 1 + det^2 J) / chi(det J), where chi tends to the positive part of its argument with the
// regularization. It is least, 4, for rotations.
template <typename FT>
class Distortion
{
  using Vector = Eigen::Matrix<FT, 4, 1>;
  using Matrix = Eigen::Matrix<FT, 4, 4>;

public:
  explicit Distortion(const FT regularization) : m_squared(regularization * regularization) { }

  FT operator()(const Jacobian<FT>& j) const
  {
    const FT d = determinant(j);
    return numerator(j, d) / chi(d);
  }

  // The gradient, and the Hessian with its negative eigenvalues taken away.
  void derivatives(const Jacobian<FT>& j, Vector& gradient, Matrix& hessian) const
  {
    const FT d = determinant(j), root = std::sqrt(m_squared + d * d);
    const FT n = numerator(j, d), c = chi(d);
    const FT c1 = c / root, c2 = m_squared / (2 * root * root * root); // derivatives of chi
    const Vector d1(j[3], -j[2], -j[1], j[0]);                    // of the determinant
    const Vector n1 = 2 * j + 2 * d * d1;                         // of the numerator
    Matrix d2 = Matrix::Zero();
    d2(0, 3) = d2(3, 0) = 1;
    d2(1, 2) = d2(2, 1) = -1;

    gradient = n1 / c - (n * c1 / (c * c)) * d1;
    const FT slope = c1 / (c * c);
    hessian = (2 / c) * (Matrix::Identity() + d1 * d1.transpose())
            + (2 * d / c - n * slope) * d2
            - slope * (n1 * d1.transpose() + d1 * n1.transpose())
            + n * (2 * c1 * slope / c - c2 / (c * c)) * (d1 * d1.transpose());
    make_positive(hessian);
  }

  FT chi(const FT d) const
  {
    const FT root = std::sqrt(m_squared + d * d);
    return d > 0 ? (d + root) / 2 : m_squared / (2 * (root - d)); // without cancellation
  }

private:
  static FT numerator(const Jacobian<FT>& j, const FT d) { return j.squaredNorm() + 1 + d * d; }

  static void make_positive(Matrix& hessian)
  {
    // most are positive already, which takes much less time to see than eigenvalues
    const Matrix shifted = hessian - 1e-7 * hessian.trace() * Matrix::Identity();
    if(hessian.trace() > 0 && Eigen::LLT<Matrix>(shifted).info() == Eigen::Success)
      return;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const Vector& values = solver.eigenvalues(); // in increasing order
    const FT least = 1e-7 * values[3];
    if(values[0] >= least)
      return;
    hessian = solver.eigenvectors() * values.cwiseMax(least).asDiagonal()
            * solver.eigenvectors().transpose();
  }

  FT m_squared;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H
