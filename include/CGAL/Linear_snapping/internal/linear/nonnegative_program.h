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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_NONNEGATIVE_PROGRAM_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_NONNEGATIVE_PROGRAM_H

#include <CGAL/license/Linear_snapping.h>

// A small quadratic program over nonnegative unknowns, in floating point and approximately, by
// projected overrelaxation. The result is only a direction to try, which is checked exactly. So
// there is no need for CGAL's exact solver, whose time grows with the fourth power of the size.

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The x >= 0 that minimizes 1/2 x^T S x - r^T x, for a symmetric S with a positive diagonal.
// \param work the allowed number of multiplications; receives the number that is left
inline Eigen::VectorXd minimize_nonnegative(const Eigen::MatrixXd& s, const Eigen::VectorXd& r,
                                            double& work)
{
  constexpr double overrelaxation = 1.5, precision = 1e-6;
  const double sweep_work = static_cast<double>(r.size()) * static_cast<double>(r.size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(r.size());
  for(int sweep = 0; sweep < 10000 && work > 0; ++sweep, work -= sweep_work) {
    double largest_change = 0;
    for(Eigen::Index i = 0; i < r.size(); ++i) {
      const double step = (r[i] - s.col(i).dot(x)) / s(i, i);
      const double next = (std::max)(0., x[i] + overrelaxation * step);
      largest_change = (std::max)(largest_change, std::abs(next - x[i]));
      x[i] = next;
    }
    if(!(largest_change > precision * x.lpNorm<Eigen::Infinity>()))
      break;
  }
  return x;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_NONNEGATIVE_PROGRAM_H
