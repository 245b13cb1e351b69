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
#include <CGAL/Seamless_snapping/internal/algebra/Orthogonal_frame.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The power of two by which a row is divided before it becomes one of doubles: 0 unless these overflow.
template <typename Integer>
long row_exponent(const Integer_system<Integer>& system, const std::size_t row)
{
  constexpr long large = 200; // sums of products with grid values stay far from the limit
  long largest = 0;
  if constexpr(!std::is_same<Integer, std::int64_t>::value)
    for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
      largest = (std::max)(largest, to_scaled_double(e->coefficient).exponent);
  return largest > large ? largest : 0;
}

inline double divided_by_power(const std::int64_t a, long) { return static_cast<double>(a); }
inline double divided_by_power(const Exact_integer& a, const long exponent)
{
  const Scaled_double scaled = to_scaled_double(a);
  return scaled_by_power(scaled.mantissa, scaled.exponent - exponent);
}

// C (base + offset) - b 2^right_hand_shift for one row, divided by 2^row_exponent: exact in the bases, so
// that violations below one ulp of the values are still seen.
template <typename Integer>
double row_violation(const Integer_system<Integer>& system, const std::size_t row,
                     const int right_hand_shift, const std::vector<Grid_value>& values)
{
  const long exponent = row_exponent(system, row);
  double offset = 0;
  for(const Entry<Integer>* e = system.begin(row); e != system.end(row); ++e)
    offset += divided_by_power(e->coefficient, exponent) * values[std::size_t(e->column)].offset;
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
  return divided_by_power(sum, exponent + static_cast<long>(down)) + offset;
}

// The independent rows, scaled by 1/sqrt(w) per column and then to unit length, as the columns of a matrix.
template <typename Integer>
Eigen::SparseMatrix<double> scaled_rows(const Integer_system<Integer>& system,
                                        const std::vector<Row_index>& rows,
                                        const std::vector<double>& scales, // 1/sqrt(w)
                                        Eigen::VectorXd& row_scales)
{
  Eigen::SparseMatrix<double> result(Eigen::Index(system.number_of_columns()), Eigen::Index(rows.size()));
  result.reserve(Eigen::Index(system.number_of_entries()));
  row_scales.resize(Eigen::Index(rows.size()));
  std::vector<double> row;
  for(std::size_t i = 0; i < rows.size(); ++i) {
    const Entry<Integer>* const first = system.begin(std::size_t(rows[i]));
    const Entry<Integer>* const last = system.end(std::size_t(rows[i]));
    const long exponent = row_exponent(system, std::size_t(rows[i]));
    row.clear();
    double largest = 0;
    for(const Entry<Integer>* e = first; e != last; ++e) {
      row.push_back(divided_by_power(e->coefficient, exponent) * scales[std::size_t(e->column)]);
      largest = (std::max)(largest, std::abs(row.back()));
    }
    double squares = 0; // of c / largest: c^2 may overflow
    for(const double c : row)
      squares += (c / largest) * (c / largest);
    const double scale = 1. / (largest * std::sqrt(squares));
    row_scales[Eigen::Index(i)] = scale;
    result.startVec(Eigen::Index(i));
    for(const Entry<Integer>* e = first; e != last; ++e)
      result.insertBack(e->column, Eigen::Index(i)) = row[std::size_t(e - first)] * scale;
  }
  result.finalize();
  return result;
}

// The lower triangle of M^T M, or an empty matrix where rows shared by many columns make it too dense.
inline Eigen::SparseMatrix<double> normal_matrix(const Eigen::SparseMatrix<double>& m)
{
  const Eigen::SparseMatrix<double, Eigen::RowMajor> by_row(m);
  std::size_t size = 0;
  for(Eigen::Index i = 0; i < by_row.outerSize(); ++i) {
    const std::size_t count = std::size_t(by_row.outerIndexPtr()[i + 1] - by_row.outerIndexPtr()[i]);
    size += count * (count + 1) / 2;
  }
  if(size > 100 * std::size_t(m.nonZeros()) + 1000000)
    return Eigen::SparseMatrix<double>();

  std::vector<Eigen::Triplet<double> > triplets;
  triplets.reserve(size);
  using Iterator = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
  for(Eigen::Index i = 0; i < by_row.outerSize(); ++i)
    for(Iterator a(by_row, i); a; ++a)
      for(Iterator b(by_row, i); b && b.col() <= a.col(); ++b)
        triplets.emplace_back(int(a.col()), int(b.col()), a.value() * b.value());
  Eigen::SparseMatrix<double> result(m.cols(), m.cols());
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

// The shortest y with M^T y = r, for M of full column rank.
inline Eigen::VectorXd shortest_solution(const Eigen::SparseMatrix<double>& m,
                                         const Eigen::VectorXd& r)
{
  const Eigen::SparseMatrix<double> normal = normal_matrix(m);
  if(normal.rows() == m.cols()) {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky(normal);
    if(cholesky.info() == Eigen::Success) {
      Eigen::VectorXd y = m * cholesky.solve(r);
      y += m * cholesky.solve(Eigen::VectorXd(r - m.transpose() * y)); // one refinement
      if(y.allFinite())
        return y;
    }
  }
  const Eigen::SparseMatrix<double> rows = m.transpose();
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double> > iterative(rows);
  iterative.setTolerance(1e-12);
  const Eigen::VectorXd y = iterative.solve(r);
  return y.allFinite() ? y : Eigen::VectorXd::Zero(m.rows());
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
  Eigen::VectorXd r(m.cols());
  for(Eigen::Index i = 0; i < r.size(); ++i)
    r[i] = row_scales[i] * row_violation(system, std::size_t(independent_rows[std::size_t(i)]),
                                         right_hand_shift, values);
  const double size = r.lpNorm<Eigen::Infinity>();
  if(size == 0 || !r.allFinite())
    return;
  const Eigen::VectorXd y = shortest_solution(m, r / size); // r itself may have any magnitude
  for(std::size_t j = 0; j < values.size(); ++j)
    values[j].offset -= size * y[Eigen::Index(j)] * scales[j];
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_LEAST_SQUARES_PROJECTION_H
