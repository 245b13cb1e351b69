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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CONSTRAINT_INPUT_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CONSTRAINT_INPUT_H

#include <CGAL/license/Linear_snapping.h>

// Reads C and b in all forms that callers may pass.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/types/Linear_constraints.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

template <typename Number>
constexpr bool is_built_in_integer = std::is_integral<Number>::value && sizeof(Number) <= 8;

template <typename Number>
Exact_rational to_exact_rational(const Number& a)
{
  if constexpr(is_built_in_integer<Number> && sizeof(Number) == 8) {
    return from_64_bits<Exact_rational>(a);
  } else {
    constexpr bool is_exact = std::is_arithmetic<Number>::value ||
                              std::is_same<Number, Exact_integer>::value ||
                              std::is_same<Number, Exact_rational>::value;
    static_assert(is_exact, "convert coefficients and right-hand sides to CGAL::Exact_rational: "
                            "they must be that, CGAL::Exact_integer, integers of up to 64 bits, "
                            "float, or double");
    if constexpr(is_exact)
      return Exact_rational(a);
    else
      return Exact_rational(0);
  }
}

template <typename Constraints>
struct Is_linear_constraints : std::false_type
{ };

template <typename Coefficient>
struct Is_linear_constraints<Linear_constraints<Coefficient> > : std::true_type
{ };

// \tparam Matrix a sparse matrix, or an expression of some
template <typename Matrix>
auto constraints_of_matrix(const Matrix& c)
{
  using Scalar = typename Matrix::Scalar;
  using Rows = Eigen::SparseMatrix<Scalar, Eigen::RowMajor, typename Matrix::StorageIndex>;
  const Rows rows(c);
  Linear_constraints<Scalar> result(std::size_t(rows.cols()));
  std::vector<typename Linear_constraints<Scalar>::Term> row;
  for(Eigen::Index i = 0; i < rows.outerSize(); ++i) {
    row.clear();
    for(typename Rows::InnerIterator e(rows, i); e; ++e)
      row.emplace_back(std::size_t(e.col()), e.value());
    result.add_constraint(row);
  }
  return result;
}

template <typename Constraints>
decltype(auto) as_constraints(const Constraints& c)
{
  constexpr bool is_sparse = std::is_base_of<Eigen::SparseMatrixBase<Constraints>,
                                             Constraints>::value;
  static_assert(is_sparse || Is_linear_constraints<Constraints>::value,
                "the constraints must be Linear_constraints or a sparse matrix of Eigen: convert "
                "a dense matrix by sparseView()");
  if constexpr(Is_linear_constraints<Constraints>::value)
    return (c);
  else if constexpr(is_sparse)
    return constraints_of_matrix(c);
  else
    return Linear_constraints<>(0);
}

// Stands for a right-hand side that the constraints do not have.
struct No_right_hand_side { };

template <typename Coefficient>
const Exact_rational& right_hand_side(const Linear_constraints<Coefficient>& c,
                                      const No_right_hand_side&, const std::size_t i)
{
  return c.right_hand_side(i);
}

template <typename Coefficient, typename RightHandSide>
Exact_rational right_hand_side(const Linear_constraints<Coefficient>&, const RightHandSide& b,
                               const std::size_t i)
{
  return to_exact_rational(*std::next(std::begin(b), std::ptrdiff_t(i)));
}

template <typename T>
bool is_finite_number(const T& t)
{
  if constexpr(std::is_floating_point<T>::value)
    return std::isfinite(t);
  else
    return true;
}

// Tells the first problem if there is one.
template <typename RightHandSide>
bool has_valid_right_hand_side([[maybe_unused]] const RightHandSide& b,
                               [[maybe_unused]] const std::size_t size,
                               [[maybe_unused]] std::string& problem)
{
  if constexpr(!std::is_same<RightHandSide, No_right_hand_side>::value) {
    if(std::distance(std::begin(b), std::end(b)) != std::ptrdiff_t(size)) {
      problem = "the right-hand side must have one number per constraint, that is " +
                std::to_string(size);
      return false;
    }
    const auto first = std::find_if(std::begin(b), std::end(b),
                                    [](const auto& t) { return !is_finite_number(t); });
    if(first != std::end(b)) {
      problem = "the right-hand side of constraint " +
                std::to_string(std::distance(std::begin(b), first)) + " is NaN or infinite";
      return false;
    }
  }
  return true;
}

// Whether a built-in number is an integer that fits into 64 bits.
template <typename T>
bool is_small_integer(const T& t)
{
  if constexpr(std::is_floating_point<T>::value)
    return std::abs(t) < T(4503599627370496.) && t == std::floor(t);
  else
    return sizeof(T) < 8 || (sizeof(T) == 8 && std::is_signed<T>::value);
}

// `integers` is scratch.
template <typename Coefficient>
void add_row(const std::vector<Entry<Coefficient> >& row, const Exact_rational& b,
             Entries<std::int64_t>& integers, System_builder& builder)
{
  if constexpr(std::is_arithmetic<Coefficient>::value) {
    integers.clear();
    for(const Entry<Coefficient>& e : row) {
      if(!is_small_integer(e.coefficient))
        break;
      integers.push_back({e.column, static_cast<std::int64_t>(e.coefficient)});
    }
    if(integers.size() == row.size())
      return builder.add_row(integers, b);
  }
  Entries<Exact_rational> entries;
  for(const Entry<Coefficient>& e : row)
    entries.push_back({e.column, to_exact_rational(e.coefficient)});
  builder.add_row(entries, b);
}

// Returns false and tells the problem if something is not a number or of the wrong size.
template <typename Coefficient, typename RightHandSide>
bool read_constraints(const Linear_constraints<Coefficient>& c, const RightHandSide& b,
                      Scaled_system& system, std::string& problem)
{
  if(!has_valid_right_hand_side(b, c.number_of_constraints(), problem))
    return false;
  constexpr auto largest = std::size_t((std::numeric_limits<Column_index>::max)());
  if(c.number_of_unknowns() > largest || c.number_of_constraints() > largest) {
    problem = "more than " + std::to_string(largest) + " unknowns or constraints are not supported";
    return false;
  }
  System_builder builder(c.number_of_unknowns());
  Entries<std::int64_t> integers;
  std::vector<Entry<Coefficient> > row;
  for(std::size_t i = 0; i < c.number_of_constraints(); ++i) {
    row.clear();
    for(auto term = c.begin(i); term != c.end(i); ++term) {
      const auto& [unknown, coefficient] = *term;
      if(unknown >= c.number_of_unknowns()) {
        problem = "constraint " + std::to_string(i) + " has the unknown " +
                  std::to_string(unknown) + ", but there are only " +
                  std::to_string(c.number_of_unknowns());
        return false;
      }
      if(!is_finite_number(coefficient)) {
        problem = "the coefficient of unknown " + std::to_string(unknown) + " in constraint " +
                  std::to_string(i) + " is NaN or infinite";
        return false;
      }
      row.push_back({Column_index(unknown), coefficient});
    }
    add_row(row, right_hand_side(c, b, i), integers, builder);
  }
  system = builder.take();
  return true;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CONSTRAINT_INPUT_H
