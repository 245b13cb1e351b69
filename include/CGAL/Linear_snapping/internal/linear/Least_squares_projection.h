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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LEAST_SQUARES_PROJECTION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LEAST_SQUARES_PROJECTION_H

#include <CGAL/license/Linear_snapping.h>

// The real-valued target of the snapping: the weighted least-squares projection of the values onto
// the solutions of C x = b, in floating point. [MC19] keeps the input on the free variables and
// lets the implied ones absorb all the violation ([MC19] Sec. 4.2); this spreads it. Nothing here
// decides exactness.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/Orthogonal_frame.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The power of two by which a row is divided before it becomes one of doubles: 0 unless these
// overflow.
inline long row_exponent(const Integer_system& system, const std::size_t row)
{
  constexpr long large = 200; // sums of products with grid values stay far from the limit
  long largest = 0;
  if(!system.is_small(row))
    for(const Entry<Exact_integer>& e : system.large_row(row).entries)
      largest = (std::max)(largest, to_scaled_double(e.coefficient).exponent);
  return largest > large ? largest : 0;
}

inline double divided_by_power(const Exact_integer& a, const long exponent)
{
  const Scaled_double scaled = to_scaled_double(a);
  return scaled_by_power(scaled.mantissa, scaled.exponent - exponent);
}

// The coefficients of a row, divided by 2^row_exponent.
inline void get_real_row(const Integer_system& system, const std::size_t row,
                         Entries<double>& result)
{
  result.clear();
  if(system.is_small(row)) {
    for(const Entry<std::int64_t>& e : system.row(row))
      result.push_back({e.column, static_cast<double>(e.coefficient)});
  } else {
    const long exponent = row_exponent(system, row);
    for(const Entry<Exact_integer>& e : system.large_row(row).entries)
      result.push_back({e.column, divided_by_power(e.coefficient, exponent)});
  }
}

// C base - b 2^right_hand_shift for one row. Returns false if it does not fit into 64 bits.
inline bool small_violation(const Integer_system& system, const std::size_t row,
                            const int right_hand_shift, const std::vector<Grid_value>& values,
                            std::int64_t& sum)
{
  if(!system.is_small(row) || !shifted(-system.right_hand_side(row), right_hand_shift, sum))
    return false;
  for(const Entry<std::int64_t>& e : system.row(row))
    if(!add_product(e.coefficient, values[std::size_t(e.column)].base, sum))
      return false;
  return true;
}

// A value in units of 2^exponent, without rounding.
// \pre `exponent` is at most 0 and that of the last bit of the offset
inline Exact_integer in_units(const Grid_value& value, const int exponent)
{
  Exact_integer result = product(Exact_integer(value.base), power_of_two(std::size_t(-exponent)));
  if(value.offset != 0) {
    const int last_bit = (std::max)(std::ilogb(value.offset) - 52, exponent);
    result += product(Exact_integer(std::ldexp(value.offset, -last_bit)),
                      power_of_two(std::size_t(last_bit - exponent)));
  }
  return result;
}

// C (base + offset) - b 2^right_hand_shift for one row, divided by 2^row_exponent: exact in the
// bases, so that violations below one ulp of the values are still seen. If right-hand sides lie
// between grid points, it is exact in the offsets, too: small values beside large ones count.
inline double row_violation(const Integer_system& system, const std::size_t row,
                            const int right_hand_shift, const std::vector<Grid_value>& values)
{
  std::int64_t small_sum = 0;
  if(small_violation(system, row, right_hand_shift, values, small_sum)) {
    double offset = 0;
    for(const Entry<std::int64_t>& e : system.row(row))
      offset += static_cast<double>(e.coefficient) * values[std::size_t(e.column)].offset;
    return static_cast<double>(small_sum) + offset;
  }
  const Integer_row<Exact_integer> exact = system.exact_row(row);
  int unit = (std::min)(right_hand_shift, 0); // its exponent, in steps of the grid
  for(const Entry<Exact_integer>& e : exact.entries)
    if(const double offset = values[std::size_t(e.column)].offset; !std::isfinite(offset))
      return offset;
    else if(offset != 0)
      unit = (std::min)(unit, std::ilogb(offset) - 52);
  Exact_integer sum(0);
  for(const Entry<Exact_integer>& e : exact.entries)
    sum += product(e.coefficient, in_units(values[std::size_t(e.column)], unit));
  sum = difference(sum, product(exact.right_hand_side,
                                power_of_two(std::size_t(right_hand_shift - unit))));
  return divided_by_power(sum, row_exponent(system, row) - unit);
}

// Minimum degree on a matrix that is symmetric, which Eigen would make so once more.
struct Symmetric_ordering
{
  using PermutationType = Eigen::AMDOrdering<int>::PermutationType;

  template <typename Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    Eigen::AMDOrdering<int>()(matrix.template selfadjointView<Eigen::Lower>(), permutation);
  }
};

// Solves equations that are triangular and have few unknowns more than rows: by a basis of all
// differences between solutions, which is dense. Elimination keeps rows sparse whose normal matrix
// fills in.
class Null_space_solver
{
public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  // \param rows as columns
  // \param pivots an unknown for each row, which is in no row that follows
  // \param number_of_unknowns whose squares count; any others follow
  Null_space_solver(const Matrix& rows, const std::vector<Column_index>& pivots,
                    const std::size_t number_of_unknowns)
    : m_rows(rows), m_pivots(pivots), m_number_of_unknowns(Eigen::Index(number_of_unknowns))
  {
    std::vector<bool> is_free(std::size_t(rows.rows()), true);
    for(const Column_index p : pivots)
      is_free[std::size_t(p)] = false;
    m_basis = Basis::Zero(rows.rows(), rows.rows() - rows.cols());
    Eigen::Index k = 0;
    for(std::size_t j = 0; j < is_free.size(); ++j)
      if(is_free[j])
        m_basis(Eigen::Index(j), k++) = 1;
    substitute(Eigen::MatrixXd::Zero(rows.cols(), k), m_basis);
    m_factors.compute(counted(m_basis).transpose() * counted(m_basis));
  }

  // How many multiplications the constructor takes.
  static double work(const double number_of_unknowns, const double number_of_rows,
                     const double number_of_coefficients)
  {
    const double k = number_of_unknowns - number_of_rows;
    return k * (number_of_coefficients + k * number_of_unknowns / 2);
  }

  // Whether the basis is nearly dependent, so that most digits are lost.
  bool is_ill_conditioned() const
  {
    return m_basis.cols() > 0 &&
           (m_factors.info() != Eigen::Success || !m_basis.allFinite() ||
            !(m_factors.vectorD().minCoeff() > 1e-7 * m_factors.vectorD().maxCoeff()));
  }

  // The shortest y with M^T y = r, up to rounding.
  Vector solve(const Vector& r) const
  {
    Basis y = Basis::Zero(m_rows.rows(), 1);
    substitute(r, y);
    const Vector multipliers = m_factors.solve(counted(m_basis).transpose() * counted(y));
    return y - m_basis * multipliers;
  }

private:
  using Basis = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Basis counted(const Basis& y) const { return y.topRows(m_number_of_unknowns); }

  // Sets the unknowns that are pivots, for each column of right-hand sides.
  void substitute(const Eigen::MatrixXd& r, Basis& y) const
  {
    for(std::size_t i = m_pivots.size(); i-- > 0;) {
      const Eigen::Index p = m_pivots[i];
      Eigen::RowVectorXd sum = r.row(Eigen::Index(i));
      double pivot = 1;
      for(Matrix::InnerIterator e(m_rows, Eigen::Index(i)); e; ++e)
        if(e.row() == p)
          pivot = e.value();
        else
          sum -= e.value() * y.row(e.row());
      y.row(p) = sum / pivot;
    }
  }

  const Matrix& m_rows;
  const std::vector<Column_index>& m_pivots;
  Eigen::Index m_number_of_unknowns;
  Basis m_basis;
  Eigen::LDLT<Eigen::MatrixXd> m_factors; // of the products of the basis
};

// The linear algebra of the projection, for one set of independent rows. Invariant: the normal
// matrix M^T M of the rows is factorized, where M holds them as columns; or, where unknowns that
// many rows share would make it dense, the matrix (I M; M^T -d) with a small d; or rows that are
// triangular have a solver of their own; or, if all of these fill in, conjugate gradients solve
// with M^T M.
class Least_squares_projection
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Vector = Eigen::VectorXd;

public:
  // \param weights one per column, positive
  // \param most_work if a factorization takes more multiplications, nothing is factorized, and
  //        `iterate()` must take its place
  Least_squares_projection(const Integer_system& system, std::vector<Row_index> independent_rows,
                           const std::vector<double>& weights,
                           const double most_work = std::numeric_limits<double>::infinity())
    : Least_squares_projection(std::move(independent_rows), weights)
  {
    if(m_row_indices.empty())
      return;
    set_rows(system);
    const Rows by_unknown(m_rows);
    m_is_augmented =
      number_of_products(by_unknown) > 100 * std::size_t(m_rows.nonZeros()) + 1000000;
    const Matrix matrix =
      m_is_augmented ? augmented_matrix(by_unknown) : normal_matrix(by_unknown);
    m_work = m_factors.analyze(matrix, (std::max)(most_work, 2e11));
    if(m_work > most_work)
      return;
    m_factors.factorize(matrix);
    // a pivot is the square of the distance of a row, of length 1, from the rows before it
    m_is_ill_conditioned =
      m_factors.info() != Eigen::Success || !(m_factors.vectorD().cwiseAbs().minCoeff() > 1e-7);
  }

  // \param system its rows are triangular, with pivots and unknowns as `Null_space_solver` takes
  //        them
  Least_squares_projection(const Integer_system& system, const std::vector<Column_index>& pivots,
                           const std::size_t number_of_unknowns, std::vector<Row_index> all_rows,
                           const std::vector<double>& weights)
    : Least_squares_projection(std::move(all_rows), weights)
  {
    set_rows(system);
    m_null_space.emplace(m_rows, pivots, number_of_unknowns);
    m_is_ill_conditioned = m_null_space->is_ill_conditioned();
  }

  Least_squares_projection(const Least_squares_projection&) = delete;
  Least_squares_projection& operator=(const Least_squares_projection&) = delete;

  std::size_t number_of_rows() const { return m_row_indices.size(); }

  // The multiplications of the factorization, whether or not it was made; infinity if these are
  // more than 2e11.
  double work_of_factorization() const { return m_work; }

  // Lets conjugate gradients take the place of the factorization. Returns false if they converge
  // too slowly.
  bool iterate()
  {
    m_is_iterated = true;
    std::minstd_rand random; // most unlike the eigenvectors of a regular system
    Vector r(m_rows.cols());
    for(Eigen::Index i = 0; i < r.size(); ++i)
      r[i] = double(random()) - double(random());
    return (r - m_rows.transpose() * solve(r)).norm() < 2 * goal_of_iteration * r.norm();
  }

  // Whether rows are so nearly dependent that most digits are lost.
  bool is_ill_conditioned() const { return m_is_ill_conditioned; }

  // Moves `values` to their projection, in steps, each of which starts from the exact violations
  // that the last one left, as long as these shrink.
  // \pre the system is the system of the constructor
  void project(const Integer_system& system, const int right_hand_shift,
               std::vector<Grid_value>& values) const
  {
    // relative to the first violations; if rows are nearly dependent, small ones count as well
    const double negligible = m_is_ill_conditioned ? 0 : 0x1p-40;
    double first_size = -1, last_size = std::numeric_limits<double>::infinity();
    for(Vector step;;) {
      const Vector r = violations(system, right_hand_shift, values);
      const double size = r.size() == 0 ? 0 : r.lpNorm<Eigen::Infinity>();
      if(first_size < 0)
        first_size = size;
      if(!r.allFinite() || size <= negligible * first_size)
        return;
      if(!(size < last_size / 2)) {
        if(size > last_size)
          move(step, -1, values);
        return;
      }
      last_size = size;
      step = m_scales.cwiseProduct(shortest_solution(r / size)); // r may have any magnitude
      step *= size;
      move(step, 1, values);
    }
  }

  // The nearest difference between solutions.
  Vector nearest_difference(const Vector& difference) const
  {
    if(m_row_indices.empty())
      return difference;
    const Vector scaled = difference.cwiseQuotient(m_scales);
    const Vector r = m_rows.transpose() * scaled;
    const bool is_inexact = m_is_augmented || m_is_iterated;
    return m_scales.cwiseProduct(scaled - (is_inexact ? shortest_solution(r) : solve(r)));
  }

private:
  static constexpr double goal_of_iteration = 1e-8; // relative; refinement makes up for it

  struct Factors : public Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Symmetric_ordering>
  {
    // Finds an order. Returns how many multiplications a factorization takes; infinity if these are
    // more than `most_work`, and the analysis would take long, too, which visits all entries.
    double analyze(const Matrix& matrix, const double most_work)
    {
      constexpr Eigen::Index large = 50000;
      CholMatrixType permuted(matrix.rows(), matrix.rows());
      ConstCholMatrixPtr upper = nullptr;
      ordering(matrix, upper, permuted);
      if(matrix.rows() > large && takes_more(*upper, most_work))
        return std::numeric_limits<double>::infinity();
      analyzePattern_preordered(*upper, true);
      return m_nonZerosPerCol.template cast<double>().squaredNorm();
    }

  private:
    // Follows each row of the factor through the elimination tree.
    static bool takes_more(const CholMatrixType& upper, const double most_work)
    {
      const std::size_t size = std::size_t(upper.cols());
      std::vector<Eigen::Index> parent(size, -1), last_row(size, -1);
      std::vector<double> entries(size, 0.); // per column
      double work = 0;
      for(Eigen::Index k = 0; k < upper.cols() && work <= most_work; ++k)
        for(CholMatrixType::InnerIterator e(upper, k); e; ++e)
          for(Eigen::Index i = e.index(); i < k && last_row[std::size_t(i)] != k;
              i = parent[std::size_t(i)]) {
            if(parent[std::size_t(i)] < 0)
              parent[std::size_t(i)] = k;
            last_row[std::size_t(i)] = k;
            work += 2 * entries[std::size_t(i)]++ + 1;
          }
      return work > most_work;
    }
  };

  Least_squares_projection(std::vector<Row_index> rows, const std::vector<double>& weights)
    : m_row_indices(std::move(rows)), m_scales(Eigen::Index(weights.size())),
      m_row_scales(Eigen::Index(m_row_indices.size()))
  {
    for(std::size_t j = 0; j < weights.size(); ++j)
      m_scales[Eigen::Index(j)] = 1. / std::sqrt(weights[j]);
  }

  static void move(const Vector& step, const double factor, std::vector<Grid_value>& values)
  {
    for(std::size_t j = 0; j < values.size(); ++j)
      values[j].offset -= factor * step[Eigen::Index(j)];
  }

  Vector violations(const Integer_system& system, const int right_hand_shift,
                    const std::vector<Grid_value>& values) const
  {
    Vector r(m_rows.cols());
    for(Eigen::Index i = 0; i < r.size(); ++i)
      r[i] = m_row_scales[i] * row_violation(system, std::size_t(m_row_indices[std::size_t(i)]),
                                             right_hand_shift, values);
    return r;
  }

  // The independent rows, scaled by 1/sqrt(w) per column and then to unit length, as columns.
  void set_rows(const Integer_system& system)
  {
    m_rows.resize(m_scales.size(), Eigen::Index(m_row_indices.size()));
    m_rows.reserve(Eigen::Index(system.number_of_entries()));
    Entries<double> row;
    for(std::size_t i = 0; i < m_row_indices.size(); ++i) {
      get_real_row(system, std::size_t(m_row_indices[i]), row);
      double largest = 0;
      for(Entry<double>& e : row) {
        e.coefficient *= m_scales[e.column];
        largest = (std::max)(largest, std::abs(e.coefficient));
      }
      double squares = 0; // the sum for c / largest, because c^2 may overflow
      for(const Entry<double>& e : row)
        squares += (e.coefficient / largest) * (e.coefficient / largest);
      const double scale = 1. / (largest * std::sqrt(squares));
      m_row_scales[Eigen::Index(i)] = scale;
      m_rows.startVec(Eigen::Index(i));
      for(const Entry<double>& e : row)
        m_rows.insertBack(e.column, Eigen::Index(i)) = e.coefficient * scale;
    }
    m_rows.finalize();
  }

  static std::size_t number_of_products(const Rows& by_unknown)
  {
    std::size_t result = 0;
    for(Eigen::Index j = 0; j < by_unknown.outerSize(); ++j) {
      const int* const begin = by_unknown.outerIndexPtr() + j;
      const std::size_t count = std::size_t(begin[1] - begin[0]);
      result += count * (count + 1) / 2;
    }
    return result;
  }

  // The lower triangle of (I M; M^T -d).
  Matrix augmented_matrix(const Rows& by_unknown) const
  {
    constexpr double d = 1e-8; // refinement makes up for it
    const int n = int(m_rows.rows()), size = n + int(m_rows.cols());
    Matrix result(size, size);
    result.reserve(m_rows.nonZeros() + size);
    for(int j = 0; j < size; ++j) {
      result.startVec(j);
      result.insertBackByOuterInner(j, j) = j < n ? 1 : -d;
      if(j < n)
        for(Rows::InnerIterator e(by_unknown, j); e; ++e)
          result.insertBackByOuterInner(j, n + int(e.col())) = e.value();
    }
    result.finalize();
    return result;
  }

  // The lower triangle of M^T M.
  Matrix normal_matrix(const Rows& by_unknown) const
  {
    const int* const begin = by_unknown.outerIndexPtr();
    Matrix result(m_rows.cols(), m_rows.cols());
    result.reserve(4 * m_rows.nonZeros());
    std::vector<double> sums(std::size_t(m_rows.cols()), 0.);
    std::vector<int> last_use(std::size_t(m_rows.cols()), -1), used;
    for(int i = 0; i < int(m_rows.cols()); ++i) {
      used.clear();
      for(Matrix::InnerIterator a(m_rows, i); a; ++a)
        for(int b = begin[a.row() + 1]; b-- > begin[a.row()];) {
          const int k = by_unknown.innerIndexPtr()[b];
          if(k < i)
            break;
          if(last_use[std::size_t(k)] != i) {
            last_use[std::size_t(k)] = i;
            sums[std::size_t(k)] = 0;
            used.push_back(k);
          }
          sums[std::size_t(k)] += a.value() * by_unknown.valuePtr()[b];
        }
      std::sort(used.begin(), used.end());
      result.startVec(i);
      for(const int k : used)
        result.insertBackByOuterInner(i, k) = sums[std::size_t(k)];
    }
    result.finalize();
    return result;
  }

  // The shortest y with M^T y = r, up to rounding and what d does.
  Vector solve(const Vector& r) const
  {
    if(m_null_space)
      return m_null_space->solve(r);
    if(m_is_iterated)
      return solve_by_iteration(r);
    if(!m_is_augmented) {
      const Vector multipliers = m_factors.solve(r); // a vector: expressions compile slowly
      return m_rows * multipliers;
    }
    Vector right_hand_side = Vector::Zero(m_rows.rows() + m_rows.cols());
    right_hand_side.tail(r.size()) = -r;
    const Vector solution = m_factors.solve(right_hand_side);
    return m_rows * Vector(solution.tail(r.size()));
  }

  // Conjugate gradients for M^T M u = r with y = M u, which is the shortest whenever they stop. The
  // rows have length 1, so that the diagonal needs no preconditioner.
  Vector solve_by_iteration(const Vector& r) const
  {
    constexpr double most_work = 1e9; // multiplications: about a second
    const double most_iterations =
      (std::max)(200., most_work / double(2 * m_rows.nonZeros() + 3 * m_rows.rows()));
    Vector y = Vector::Zero(m_rows.rows()), rest = r, direction = r;
    double squares = rest.squaredNorm();
    const double goal = goal_of_iteration * goal_of_iteration * squares;
    for(int i = 0; i < most_iterations && squares > goal; ++i) {
      const Vector step = m_rows * direction;
      const double factor = squares / step.squaredNorm();
      y += factor * step;
      rest -= factor * (m_rows.transpose() * step);
      const double squares_before = squares;
      squares = rest.squaredNorm();
      direction = rest + squares / squares_before * direction;
    }
    return y;
  }

  // The shortest solution, refined.
  Vector shortest_solution(const Vector& r) const
  {
    constexpr int rounds_of_augmented = 10;
    Vector y = solve(r);
    for(int round = m_is_augmented && !m_is_iterated ? rounds_of_augmented : 1; round > 0; --round)
      y += solve(Vector(r - m_rows.transpose() * y));
    return y.allFinite() ? y : Vector::Zero(m_rows.rows());
  }

  std::vector<Row_index> m_row_indices;
  Vector m_scales; // 1/sqrt(w)
  Vector m_row_scales;
  Matrix m_rows; // as columns
  Factors m_factors;
  std::optional<Null_space_solver> m_null_space; // in place of factors
  double m_work = 0; // of a factorization
  bool m_is_augmented = false;
  bool m_is_iterated = false; // without factors
  bool m_is_ill_conditioned = false;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LEAST_SQUARES_PROJECTION_H
