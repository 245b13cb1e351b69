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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H

#include <CGAL/license/Seamless_snapping.h>

// A small quadratic program over nonnegative unknowns, in floating point, by the active-set method of Lawson and
// Hanson. What comes of it is a direction to try, and is checked exactly; so the exact solver of CGAL, whose
// time grows with the fourth power of the size, is not called for.

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The restriction of S x = r to some unknowns; zero in all others.
inline Eigen::VectorXd solve_restricted(const Eigen::MatrixXd& s, const Eigen::VectorXd& r,
                                        const std::vector<Eigen::Index>& chosen)
{
  const Eigen::Index size = Eigen::Index(chosen.size());
  Eigen::MatrixXd part(size, size);
  Eigen::VectorXd right(size);
  for(Eigen::Index i = 0; i < size; ++i) {
    right[i] = r[chosen[std::size_t(i)]];
    for(Eigen::Index j = 0; j < size; ++j)
      part(i, j) = s(chosen[std::size_t(i)], chosen[std::size_t(j)]);
  }
  const Eigen::VectorXd solution = part.ldlt().solve(right);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(r.size());
  for(Eigen::Index i = 0; i < size; ++i)
    result[chosen[std::size_t(i)]] = solution[i];
  return result;
}

// Takes x to the optimum of the chosen unknowns, or as far as they stay positive; those that don't are dropped,
// and the optimum of the others is gone for.
inline void move_to_optimum(const Eigen::MatrixXd& s, const Eigen::VectorXd& r,
                            std::vector<Eigen::Index>& chosen, Eigen::VectorXd& x)
{
  for(;;) {
    const Eigen::VectorXd z = solve_restricted(s, r, chosen);
    double part = 1;
    auto first_at_zero = chosen.end();
    for(auto i = chosen.begin(); i != chosen.end(); ++i)
      if(!(z[*i] > 0) && (first_at_zero == chosen.end() || x[*i] < part * (x[*i] - z[*i]))) {
        part = x[*i] / (x[*i] - z[*i]);
        first_at_zero = i;
      }
    if(first_at_zero == chosen.end()) {
      x = z;
      return;
    }
    x += part * (z - x);
    x[*first_at_zero] = 0;
    chosen.erase(first_at_zero);
  }
}

// The x >= 0 that minimizes 1/2 x^T S x - r^T x, for a positive definite S.
inline Eigen::VectorXd minimize_nonnegative(const Eigen::MatrixXd& s, const Eigen::VectorXd& r)
{
  // Most unknowns are positive in the end, so that all of them are to begin with.
  std::vector<Eigen::Index> positive(std::size_t(r.size()));
  std::iota(positive.begin(), positive.end(), 0);
  Eigen::VectorXd x = solve_restricted(s, r, positive);
  const auto is_not_positive = [&](const Eigen::Index i) { return !(x[i] > 0); };
  while(std::any_of(positive.begin(), positive.end(), is_not_positive)) {
    positive.erase(std::remove_if(positive.begin(), positive.end(), is_not_positive), positive.end());
    x = solve_restricted(s, r, positive);
  }

  const double tolerance = 1e-10 * r.lpNorm<Eigen::Infinity>();
  for(Eigen::Index step = 0; step < 3 * r.size(); ++step) {
    Eigen::VectorXd gain = r - s * x; // by raising an unknown
    for(const Eigen::Index i : positive)
      gain[i] = -std::numeric_limits<double>::infinity();
    Eigen::Index best = 0;
    if(!(gain.maxCoeff(&best) > tolerance))
      break;
    positive.push_back(best);
    move_to_optimum(s, r, positive, x);
  }
  return x;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H
