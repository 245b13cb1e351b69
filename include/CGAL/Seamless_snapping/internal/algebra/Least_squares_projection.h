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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_LEAST_SQUARES_PROJECTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_LEAST_SQUARES_PROJECTION_H

#include <CGAL/license/Seamless_snapping.h>

// The real-valued target of the snapping: the weighted least-squares projection of the values onto the
// solutions of C x = b, in floating point. The paper keeps the input on the free variables and lets the
// implied ones absorb all the violation (Sec. 4.2); this spreads it. Nothing here decides exactness.

#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <CGAL/number_utils.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// C (base + offset) - b 2^right_hand_shift for one row: exact in the bases, so that violations below one
// ulp of the values are still seen.
template <typename Integer>
double row_violation(const Integer_system<Integer>& system, const std::size_t row,
                     const int right_hand_shift, const std::vector<Grid_value>& values)
{
  double offset = 0;
  for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
    offset += CGAL::to_double(e->coefficient) * values[std::size_t(e->column)].offset;
  try {
    std::int64_t sum = 0;
    if(system.right_hand_side(row) != 0)
      throw Integer_overflow();
    for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e) {
      if(!fits_64_bits(e->coefficient))
        throw Integer_overflow();
      sum = difference_with_product(sum, -to_64_bits(e->coefficient),
                                    values[std::size_t(e->column)].base);
    }
    return static_cast<double>(sum) + offset;
  } catch(const Integer_overflow&) { }
  // Where right-hand sides lie between grid points, both sides are taken to a finer grid.
  const std::size_t up = std::size_t((std::max)(right_hand_shift, 0));
  const std::size_t down = std::size_t((std::max)(-right_hand_shift, 0));
  Exact_integer sum(0);
  for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
    sum += Exact_integer(Exact_integer(e->coefficient) *
                         Exact_integer(values[std::size_t(e->column)].base));
  sum = Exact_integer(Exact_integer(sum * power_of_two(down)) -
                      Exact_integer(Exact_integer(system.right_hand_side(row)) * power_of_two(up)));
  return std::ldexp(CGAL::to_double(sum), -static_cast<int>(down)) + offset;
}

// The independent rows, scaled by 1/sqrt(w) per column and then to unit length, as a matrix.
template <typename Integer>
Eigen::SparseMatrix<double> scaled_rows(const Integer_system<Integer>& system,
                                        const std::vector<Row_index>& rows,
                                        const std::vector<double>& scales, // 1/sqrt(w)
                                        Eigen::VectorXd& row_scales)
{
  std::vector<Eigen::Triplet<double> > triplets;
  triplets.reserve(system.number_of_entries());
  row_scales.resize(Eigen::Index(rows.size()));
  for(std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t row = std::size_t(rows[i]);
    const std::size_t first = triplets.size();
    double largest = 0;
    for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e) {
      const double c = CGAL::to_double(e->coefficient) * scales[std::size_t(e->column)];
      largest = (std::max)(largest, std::abs(c));
      triplets.emplace_back(int(i), e->column, c);
    }
    double squares = 0; // of c / largest: c^2 may overflow
    for(std::size_t k = first; k < triplets.size(); ++k)
      squares += (triplets[k].value() / largest) * (triplets[k].value() / largest);
    const double scale = 1. / (largest * std::sqrt(squares));
    row_scales[Eigen::Index(i)] = scale;
    for(std::size_t k = first; k < triplets.size(); ++k)
      triplets[k] = Eigen::Triplet<double>(triplets[k].row(), triplets[k].col(),
                                           triplets[k].value() * scale);
  }
  Eigen::SparseMatrix<double> matrix(Eigen::Index(rows.size()),
                                     Eigen::Index(system.number_of_columns()));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

// The lower triangle of M M^T, or an empty matrix where columns shared by many rows make it too dense.
inline Eigen::SparseMatrix<double> normal_matrix(const Eigen::SparseMatrix<double>& m)
{
  std::size_t size = 0;
  for(Eigen::Index j = 0; j < m.outerSize(); ++j) {
    const std::size_t count = std::size_t(m.outerIndexPtr()[j + 1] - m.outerIndexPtr()[j]);
    size += count * (count + 1) / 2;
  }
  if(size > 100 * std::size_t(m.nonZeros()) + 1000000)
    return Eigen::SparseMatrix<double>();

  std::vector<Eigen::Triplet<double> > triplets;
  triplets.reserve(size);
  using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
  for(Eigen::Index j = 0; j < m.outerSize(); ++j)
    for(Iterator a(m, j); a; ++a)
      for(Iterator b(m, j); b && b.row() <= a.row(); ++b)
        triplets.emplace_back(int(a.row()), int(b.row()), a.value() * b.value());
  Eigen::SparseMatrix<double> result(m.rows(), m.rows());
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

// The shortest y with M y = r, for M of full row rank.
inline Eigen::VectorXd shortest_solution(const Eigen::SparseMatrix<double>& m,
                                         const Eigen::VectorXd& r)
{
  const Eigen::SparseMatrix<double> normal = normal_matrix(m);
  if(normal.rows() == m.rows()) {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky(normal);
    if(cholesky.info() == Eigen::Success) {
      Eigen::VectorXd y = m.transpose() * cholesky.solve(r);
      y += m.transpose() * cholesky.solve(Eigen::VectorXd(r - m * y)); // one refinement
      if(y.allFinite())
        return y;
    }
  }
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double> > iterative(m);
  iterative.setTolerance(1e-12);
  const Eigen::VectorXd y = iterative.solve(r);
  return y.allFinite() ? y : Eigen::VectorXd::Zero(m.cols());
}

// Moves `values` to their projection.
template <typename Integer>
void project_to_solutions(const Integer_system<Integer>& system,
                          const std::vector<Row_index>& independent_rows,
                          const int right_hand_shift,
                          const std::vector<double>& weights,
                          std::vector<Grid_value>& values)
{
  if(independent_rows.empty())
    return;
  std::vector<double> scales(weights.size());
  for(std::size_t j = 0; j < weights.size(); ++j)
    scales[j] = 1. / std::sqrt(weights[j]);
  Eigen::VectorXd row_scales;
  const Eigen::SparseMatrix<double> m = scaled_rows(system, independent_rows, scales, row_scales);
  Eigen::VectorXd r(m.rows());
  for(Eigen::Index i = 0; i < r.size(); ++i)
    r[i] = row_scales[i] * row_violation(system, std::size_t(independent_rows[std::size_t(i)]),
                                         right_hand_shift, values);
  const double size = r.lpNorm<Eigen::Infinity>();
  if(size == 0)
    return;
  const Eigen::VectorXd y = shortest_solution(m, r / size); // r itself may have any magnitude
  for(std::size_t j = 0; j < values.size(); ++j)
    values[j].offset -= size * y[Eigen::Index(j)] * scales[j];
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_LEAST_SQUARES_PROJECTION_H
