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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_SYSTEM_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_SYSTEM_H

#include <CGAL/license/Linear_snapping.h>

// A sparse system C x = b with integer coefficients, as flat rows, and its echelon form. Rows
// usually have 64-bit integers; a row whose numbers do not fit is stored separately, in
// multiprecision.

#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>

#include <CGAL/Exact_rational.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

using Column_index = std::int32_t;
using Row_index = std::int32_t;

template <typename Integer>
struct Entry
{
  Column_index column;
  Integer coefficient;
};

template <typename Integer>
using Entries = std::vector<Entry<Integer> >; // sorted by column, no zeros, if not said otherwise

template <typename Integer>
bool operator<(const Entry<Integer>& a, const Entry<Integer>& b)
{
  return std::tie(a.column, a.coefficient) < std::tie(b.column, b.coefficient);
}

// A row in the making: the coefficients of equal columns add up, the columns end up sorted.
template <typename Integer>
void sort_and_sum(Entries<Integer>& entries)
{
  const auto is_before = [](const Entry<Integer>& a, const Entry<Integer>& b)
    { return a.column < b.column; };
  if(!std::is_sorted(entries.begin(), entries.end(), is_before))
    std::sort(entries.begin(), entries.end(), is_before);
  std::size_t last = 0; // entries before `last` are done
  for(std::size_t i = 0; i < entries.size();) {
    const std::size_t first = i;
    for(++i; i < entries.size() && entries[i].column == entries[first].column; ++i)
      entries[first].coefficient = difference_with_product(entries[first].coefficient, Integer(-1),
                                                           entries[i].coefficient);
    if(entries[first].coefficient == 0)
      continue;
    if(last != first)
      entries[last] = std::move(entries[first]);
    ++last;
  }
  entries.erase(entries.begin() + std::ptrdiff_t(last), entries.end());
}

// The entry of a row, whose columns are sorted, in one column; null if there is none.
template <typename Integer>
const Entry<Integer>* find_entry(const Entries<Integer>& row, const Column_index column)
{
  const auto found = std::lower_bound(row.begin(), row.end(), column,
    [](const Entry<Integer>& e, const Column_index c) { return e.column < c; });
  return found == row.end() || found->column != column ? nullptr : &*found;
}

template <typename Integer>
struct Integer_row
{
  Entries<Integer> entries;
  Integer right_hand_side = Integer(0);
};

template <typename Integer>
bool operator<(const Integer_row<Integer>& a, const Integer_row<Integer>& b)
{
  return std::tie(a.entries, a.right_hand_side) < std::tie(b.entries, b.right_hand_side);
}

// Replaces columns by their places among the columns that occur in rows; returns these, sorted.
inline std::vector<Column_index>
renumber_columns(std::vector<Integer_row<Exact_integer> >& rows)
{
  std::vector<Column_index> columns;
  for(const Integer_row<Exact_integer>& row : rows)
    for(const Entry<Exact_integer>& e : row.entries)
      columns.push_back(e.column);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  for(Integer_row<Exact_integer>& row : rows)
    for(Entry<Exact_integer>& e : row.entries)
      e.column = Column_index(std::lower_bound(columns.begin(), columns.end(), e.column) -
                              columns.begin());
  return columns;
}

// Invariant: each row has sorted columns and no zeros, and is kept in multiprecision if and only if
// one of its numbers exceeds 2^62. The right-hand sides are integers times 2^-right_hand_scale: a
// solution on a grid of step 2^e, e <= -right_hand_scale, is an integer vector X with
// C X = right_hand_side 2^(-right_hand_scale - e).
class Integer_system
{
public:
  explicit Integer_system(const std::size_t number_of_columns = 0)
    : m_number_of_columns(number_of_columns)
  { }

  void reserve(const std::size_t number_of_rows, const std::size_t number_of_entries)
  {
    m_rows.reserve(number_of_rows, number_of_entries);
    m_right_hand_side.reserve(number_of_rows);
  }

  // Whether a row need not be kept in multiprecision.
  template <typename Integer>
  static bool fits(const Entries<Integer>& entries, const Integer& b)
  {
    return fits_64_bits(b) &&
           std::all_of(entries.begin(), entries.end(), [](const Entry<Integer>& e)
                       { return fits_64_bits(e.coefficient); });
  }

  // \pre the entries are sorted by column, and the row fits
  template <typename Row>
  void add_row(const Row& entries, const std::int64_t b)
  {
    m_rows.append(entries);
    end_row(b);
  }

  void add_row(Integer_row<Exact_integer> row)
  {
    if(fits(row.entries, row.right_hand_side)) {
      for(const Entry<Exact_integer>& e : row.entries)
        m_rows.push_back({e.column, to_64_bits(e.coefficient)});
      end_row(to_64_bits(row.right_hand_side));
      return;
    }
    m_large_row.resize(number_of_rows(), -1);
    m_large_row.push_back(static_cast<std::int32_t>(m_large_rows.size()));
    m_number_of_large_entries += row.entries.size();
    m_large_rows.push_back(std::move(row));
    end_row(0);
  }

  std::size_t number_of_columns() const { return m_number_of_columns; }
  std::size_t number_of_rows() const { return m_right_hand_side.size(); }
  std::size_t number_of_entries() const
  { return m_rows.elements().size() + m_number_of_large_entries; }

  // Whether all rows are of 64-bit integers.
  bool is_small() const { return m_large_rows.empty(); }
  bool is_small(const std::size_t row) const
  { return row >= m_large_row.size() || m_large_row[row] < 0; }

  // \pre is_small(row)
  Lists<Entry<std::int64_t> >::List row(const std::size_t i) const { return m_rows[i]; }
  std::int64_t right_hand_side(const std::size_t row) const { return m_right_hand_side[row]; }

  // \pre !is_small(row)
  const Integer_row<Exact_integer>& large_row(const std::size_t row) const
  { return m_large_rows[std::size_t(m_large_row[row])]; }

  // Any row, in multiprecision.
  Integer_row<Exact_integer> exact_row(const std::size_t row) const
  {
    if(!is_small(row))
      return large_row(row);
    Integer_row<Exact_integer> result;
    for(const Entry<std::int64_t>& e : m_rows[row])
      result.entries.push_back({e.column, Exact_integer(e.coefficient)});
    result.right_hand_side = Exact_integer(right_hand_side(row));
    return result;
  }

  bool has_right_hand_side(const std::size_t row) const
  { return is_small(row) ? right_hand_side(row) != 0 : large_row(row).right_hand_side != 0; }

  // Calls f(column) for all entries of a row.
  template <typename F>
  void for_each_column(const std::size_t row, const F& f) const
  {
    if(is_small(row))
      for(const Entry<std::int64_t>& e : m_rows[row])
        f(e.column);
    else
      for(const Entry<Exact_integer>& e : large_row(row).entries)
        f(e.column);
  }

  int right_hand_scale() const { return m_right_hand_scale; }
  void set_right_hand_scale(const int scale) { m_right_hand_scale = scale; }

  // Some order, by which equal systems are found.
  friend bool operator<(const Integer_system& a, const Integer_system& b)
  {
    const auto members = [](const Integer_system& s) {
      return std::tie(s.m_number_of_columns, s.m_right_hand_scale, s.m_rows, s.m_right_hand_side,
                      s.m_large_row, s.m_large_rows);
    };
    return members(a) < members(b);
  }

private:
  void end_row(const std::int64_t b)
  {
    m_rows.end_list();
    m_right_hand_side.push_back(b);
  }

  std::size_t m_number_of_columns;
  int m_right_hand_scale = 0;
  Lists<Entry<std::int64_t> > m_rows; // empty where they are large
  std::vector<std::int64_t> m_right_hand_side;
  std::vector<Integer_row<Exact_integer> > m_large_rows;
  std::vector<std::int32_t> m_large_row; // per row, as far as there are large ones: -1 for others
  std::size_t m_number_of_large_entries = 0;
};

// Invariant: the pivot rows, the core rows, and the equations of the auxiliary unknowns have
// together the solutions of the system, apart from contradictory rows. The pivot of a row is in a
// column that neither later pivot rows nor core rows hold, so that back-substitution runs through
// them in reverse. It is 1 or -1, or divides the row where all unknowns are such multiples.
struct Echelon_form
{
  Integer_system pivot_rows; // in the order of elimination
  std::vector<Column_index> pivot_columns; // one per pivot row
  Integer_system core_rows; // without a coefficient 1 or -1
  // Unknowns that follow the system's: sums of earlier ones, with signs.
  std::vector<Entries<std::int64_t> > auxiliary_unknowns;

  // Rows of the system. Rows that became pivot rows are linearly independent.
  std::vector<Row_index> rows_with_pivot, rows_in_core, redundant_rows, contradictory_rows;

  std::vector<std::int64_t> multiples; // per column, for pivots that are not 1; empty: any integers
  int right_hand_halvings = 0; // by which grids must be finer for the right-hand sides

  std::size_t number_of_coefficients = 0, number_of_non_unit_pivots = 0; // in pivot rows
  std::int64_t largest_pivot = 1;
  Exact_integer largest_coefficient = Exact_integer(0); // met on the way
  bool is_multiprecision = false;
};

// Whether C x = b for one row, in rationals.
inline BOOST_NOINLINE bool holds_in_rationals(const Integer_system& system, const std::size_t row,
                                              const std::vector<double>& x)
{
  const Integer_row<Exact_integer> exact = system.exact_row(row);
  const int scale = system.right_hand_scale();
  Exact_rational sum(0);
  for(const Entry<Exact_integer>& e : exact.entries)
    sum += Exact_rational(e.coefficient) * Exact_rational(x[std::size_t(e.column)]);
  if(scale >= 0)
    sum *= Exact_rational(power_of_two(std::size_t(scale)));
  else
    sum /= Exact_rational(power_of_two(std::size_t(-scale)));
  return sum == Exact_rational(exact.right_hand_side);
}

// Whether a row holds, in 64-bit integers on the coarsest grid that holds all values of the row.
// Returns false if it can't tell.
inline bool holds_in_small_integers(const Integer_system& system, const std::size_t row,
                                    const std::vector<double>& x, bool& holds)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  if(!system.is_small(row))
    return false;
  double largest = 0;
  for(const Entry<std::int64_t>& e : system.row(row))
    largest = (std::max)(largest, std::abs(x[std::size_t(e.column)]));
  // 7 bits finer than the largest value needs; that is enough for nearly all others
  const int exponent = (largest == 0 ? 0 : std::ilogb(largest)) - (digits - 1 + 7);
  const double factor = std::ldexp(1., -exponent);
  std::int64_t sum = 0;
  if(!std::isfinite(factor) ||
     !shifted(-system.right_hand_side(row), -system.right_hand_scale() - exponent, sum))
    return false;
  for(const Entry<std::int64_t>& e : system.row(row)) {
    const double value = x[std::size_t(e.column)];
    const double scaled = value * factor;
    const std::int64_t integer = static_cast<std::int64_t>(scaled);
    if((scaled == 0 && value != 0) || static_cast<double>(integer) != scaled ||
       !add_product(e.coefficient, integer, sum))
      return false;
  }
  holds = (sum == 0);
  return true;
}

// Whether the values satisfy a row exactly.
inline bool holds(const Integer_system& system, const std::size_t row, const std::vector<double>& x)
{
  bool result = false;
  return holds_in_small_integers(system, row, x, result) ? result
                                                         : holds_in_rationals(system, row, x);
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_SYSTEM_H
