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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_TRIANGULAR_FORM_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_TRIANGULAR_FORM_H

#include <CGAL/license/Linear_snapping.h>

// Systems that are triangular up to the order of their rows and columns, such as 8 f = a + 6 b + c
// for refinements. They need no elimination: a pivot is an unknown that no later row has. The other
// unknowns are multiples of numbers that make all pivots divide.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Invariant: the pivots of the rows in `m_order` are in no row that follows.
class Triangular_order
{
public:
  explicit Triangular_order(const Integer_system& system)
    : m_system(system), m_number_of_rows(system.number_of_columns(), 0),
      m_sum_of_rows(system.number_of_columns(), 0), m_is_waiting(system.number_of_rows(), false)
  {
    for(std::size_t i = 0; i < system.number_of_rows(); ++i)
      for(const Entry<std::int64_t>& e : system.row(i)) {
        ++m_number_of_rows[std::size_t(e.column)];
        m_sum_of_rows[std::size_t(e.column)] += i;
      }
    for(std::size_t i = 0; i < system.number_of_rows(); ++i)
      for(const Entry<std::int64_t>& e : system.row(i))
        add_row_of_own(e.column);
    for(std::size_t k = 0; k < m_order.size(); ++k)
      take(m_order[k]);
  }

  // Whether these are all rows.
  bool is_complete() const { return m_order.size() == m_system.number_of_rows(); }

  const std::vector<Row_index>& rows() const { return m_order; }
  const std::vector<Entry<std::int64_t> >& pivots() const { return m_pivots; }

private:
  // If only one of the rows that are left has the column.
  void add_row_of_own(const Column_index column)
  {
    const std::size_t i = m_sum_of_rows[std::size_t(column)];
    if(m_number_of_rows[std::size_t(column)] != 1 || m_is_waiting[i])
      return;
    m_is_waiting[i] = true;
    m_order.push_back(Row_index(i));
  }

  // The largest coefficient makes errors of the others smallest.
  void take(const Row_index i)
  {
    Entry<std::int64_t> pivot{0, 0};
    for(const Entry<std::int64_t>& e : m_system.row(std::size_t(i)))
      if(m_number_of_rows[std::size_t(e.column)] == 1 &&
         std::abs(e.coefficient) > std::abs(pivot.coefficient))
        pivot = e;
    m_pivots.push_back(pivot);
    for(const Entry<std::int64_t>& e : m_system.row(std::size_t(i))) {
      --m_number_of_rows[std::size_t(e.column)];
      m_sum_of_rows[std::size_t(e.column)] -= std::size_t(i);
      add_row_of_own(e.column);
    }
  }

  const Integer_system& m_system;
  std::vector<std::size_t> m_number_of_rows, m_sum_of_rows; // per column, of the rows that are left
  std::vector<char> m_is_waiting; // per row: whether it is in `m_order`
  std::vector<Row_index> m_order;
  std::vector<Entry<std::int64_t> > m_pivots; // per row in `m_order`
};

// The numbers of which the unknowns are to be multiples, so that all pivots divide; empty if a
// number is large, or no grid makes a right-hand side divisible.
// \param halvings becomes how often right-hand sides must be doubled at least
inline std::vector<std::int64_t> multiples_for_pivots(const Integer_system& system,
                                                      const Triangular_order& order,
                                                      const std::int64_t largest, int& halvings)
{
  std::vector<std::int64_t> result(system.number_of_columns(), 1);
  for(std::size_t k = 0; k < order.rows().size(); ++k) {
    const Entry<std::int64_t>& pivot = order.pivots()[k];
    if(std::abs(pivot.coefficient) > largest)
      return {};
    const std::int64_t divisor =
      std::abs(pivot.coefficient) * result[std::size_t(pivot.column)];
    for(const Entry<std::int64_t>& e : system.row(std::size_t(order.rows()[k]))) {
      std::int64_t& multiple = result[std::size_t(e.column)];
      if(e.column != pivot.column)
        multiple = std::lcm(multiple, divisor / std::gcd(divisor, e.coefficient));
      if(multiple > largest)
        return {};
    }
    const std::int64_t b = system.right_hand_side(std::size_t(order.rows()[k]));
    const int twos = number_of_halvings(divisor);
    if(b % (divisor >> twos) != 0)
      return {};
    if(b != 0)
      halvings = (std::max)(halvings, twos - number_of_halvings(b));
  }
  return result;
}

// By how many steps unknowns can be off at most, for free ones that are rounded to multiples.
inline double largest_error(const Integer_system& system, const Triangular_order& order,
                            const std::vector<std::int64_t>& multiples)
{
  std::vector<double> error(multiples.begin(), multiples.end());
  double largest = 0;
  for(std::size_t k = order.rows().size(); k-- > 0;) {
    const Entry<std::int64_t>& pivot = order.pivots()[k];
    double sum = 0;
    for(const Entry<std::int64_t>& e : system.row(std::size_t(order.rows()[k])))
      if(e.column != pivot.column)
        sum += std::abs(double(e.coefficient)) * error[std::size_t(e.column)];
    error[std::size_t(pivot.column)] = sum / std::abs(double(pivot.coefficient));
    largest = (std::max)(largest, error[std::size_t(pivot.column)]);
  }
  return largest;
}

inline bool has_only_units(const Integer_system& system)
{
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    for(const Entry<std::int64_t>& e : system.row(i))
      if(std::abs(e.coefficient) != 1)
        return false;
  return true;
}

// None for a system that is not triangular, or whose unknowns would be off by much, and for one
// with coefficients 1 and -1 alone, or of few unknowns, which an elimination brings as close or
// closer.
inline std::optional<Echelon_form> triangular_form(const Integer_system& system)
{
  constexpr std::size_t few_columns = 200;
  constexpr std::int64_t largest = 1000000;
  if(system.number_of_columns() <= few_columns || !system.is_small() || has_only_units(system))
    return std::nullopt;
  const Triangular_order order(system);
  Echelon_form form;
  if(order.is_complete())
    form.multiples = multiples_for_pivots(system, order, largest, form.right_hand_halvings);
  if(form.multiples.empty() || largest_error(system, order, form.multiples) > double(largest))
    return std::nullopt;
  form.pivot_rows = Integer_system(system.number_of_columns());
  form.pivot_rows.set_right_hand_scale(system.right_hand_scale());
  for(std::size_t k = 0; k < order.rows().size(); ++k) {
    const std::size_t row = std::size_t(order.rows()[k]);
    form.pivot_rows.add_row(system.row(row), system.right_hand_side(row));
    form.pivot_columns.push_back(order.pivots()[k].column);
    const std::int64_t pivot = std::abs(order.pivots()[k].coefficient);
    form.number_of_non_unit_pivots += pivot == 1 ? 0 : 1;
    form.largest_pivot = (std::max)(form.largest_pivot, pivot);
    for(const Entry<std::int64_t>& e : system.row(row))
      form.largest_coefficient =
        (std::max)(form.largest_coefficient, Exact_integer(std::abs(e.coefficient)));
  }
  form.rows_with_pivot = order.rows();
  form.number_of_coefficients = system.number_of_entries();
  return form;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_TRIANGULAR_FORM_H
