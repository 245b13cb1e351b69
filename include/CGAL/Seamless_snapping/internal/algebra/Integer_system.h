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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_INTEGER_SYSTEM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_INTEGER_SYSTEM_H

#include <CGAL/license/Seamless_snapping.h>

// A sparse system C x = b with integer coefficients, as flat rows, and the entries and rows that the
// elimination works on.

#include <CGAL/Seamless_snapping/internal/algebra/checked_integer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Column_index = int;
using Row_index = int;

template <typename Integer>
struct Entry
{
  Column_index column;
  Integer coefficient;
};

// A row in the making: the coefficients of equal columns add up, the columns end up sorted.
template <typename Integer>
void sort_and_sum(std::vector<Entry<Integer> >& entries)
{
  std::sort(entries.begin(), entries.end(), [](const Entry<Integer>& a, const Entry<Integer>& b)
            { return a.column < b.column; });
  std::size_t last = 0; // entries before `last` are done
  for(std::size_t i = 0; i < entries.size();) {
    Entry<Integer> sum = entries[i];
    for(++i; i < entries.size() && entries[i].column == sum.column; ++i)
      sum.coefficient = difference_with_product(sum.coefficient, Integer(-1),
                                                entries[i].coefficient);
    if(sum.coefficient != 0)
      entries[last++] = std::move(sum);
  }
  entries.resize(last);
}

// The entry of a row, whose columns are sorted, in one column; null if there is none.
template <typename Integer>
const Entry<Integer>* find_entry(const std::vector<Entry<Integer> >& row, const Column_index column)
{
  const auto found = std::lower_bound(row.begin(), row.end(), column,
    [](const Entry<Integer>& e, const Column_index c) { return e.column < c; });
  return found == row.end() || found->column != column ? nullptr : &*found;
}

// Rows with sorted columns and no zeros. The right-hand sides are integers times 2^-right_hand_scale:
// a solution on a grid of step 2^e, e <= -right_hand_scale, is an integer vector X with
// C X = right_hand_side 2^(-right_hand_scale - e).
template <typename Integer>
class Integer_system
{
public:
  explicit Integer_system(const std::size_t number_of_columns = 0)
    : m_number_of_columns(number_of_columns), m_row_begin(1, 0)
  { }

  // \pre the entries are sorted by column
  void add_row(const std::vector<Entry<Integer> >& entries, const Integer& right_hand_side)
  {
    m_entries.insert(m_entries.end(), entries.begin(), entries.end());
    m_row_begin.push_back(m_entries.size());
    m_right_hand_side.push_back(right_hand_side);
  }

  std::size_t number_of_columns() const { return m_number_of_columns; }
  std::size_t number_of_rows() const { return m_right_hand_side.size(); }
  std::size_t number_of_entries() const { return m_entries.size(); }

  const Entry<Integer>* begin(const std::size_t row) const
  { return m_entries.data() + m_row_begin[row]; }
  const Entry<Integer>* end(const std::size_t row) const
  { return m_entries.data() + m_row_begin[row + 1]; }

  const Integer& right_hand_side(const std::size_t row) const { return m_right_hand_side[row]; }

  int right_hand_scale() const { return m_right_hand_scale; }
  void set_right_hand_scale(const int scale) { m_right_hand_scale = scale; }

private:
  std::size_t m_number_of_columns;
  int m_right_hand_scale = 0;
  std::vector<Entry<Integer> > m_entries;
  std::vector<std::size_t> m_row_begin;
  std::vector<Integer> m_right_hand_side;
};

// The same system in multiprecision integers, for a second try after an overflow.
inline Integer_system<Exact_integer> to_multiprecision(const Integer_system<std::int64_t>& system)
{
  Integer_system<Exact_integer> result(system.number_of_columns());
  result.set_right_hand_scale(system.right_hand_scale());
  std::vector<Entry<Exact_integer> > row;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    row.clear();
    for(const Entry<std::int64_t>* e = system.begin(i); e != system.end(i); ++e)
      row.push_back({e->column, Exact_integer(e->coefficient)});
    result.add_row(row, Exact_integer(system.right_hand_side(i)));
  }
  return result;
}

// The same system in 64-bit integers, if they are large enough.
inline std::optional<Integer_system<std::int64_t> >
to_machine_integers(const Integer_system<Exact_integer>& system)
{
  Integer_system<std::int64_t> result(system.number_of_columns());
  result.set_right_hand_scale(system.right_hand_scale());
  std::vector<Entry<std::int64_t> > row;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    row.clear();
    for(const Entry<Exact_integer>* e = system.begin(i); e != system.end(i); ++e) {
      if(!fits_64_bits(e->coefficient))
        return std::nullopt;
      row.push_back({e->column, to_64_bits(e->coefficient)});
    }
    if(!fits_64_bits(system.right_hand_side(i)))
      return std::nullopt;
    result.add_row(row, to_64_bits(system.right_hand_side(i)));
  }
  return result;
}

inline const Integer_system<Exact_integer>&
to_multiprecision(const Integer_system<Exact_integer>& system)
{
  return system;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_INTEGER_SYSTEM_H
