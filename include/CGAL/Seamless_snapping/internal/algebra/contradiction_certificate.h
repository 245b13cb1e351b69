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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CONTRADICTION_CERTIFICATE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CONTRADICTION_CERTIFICATE_H

#include <CGAL/license/Seamless_snapping.h>

// For a system that contradicts itself: multipliers of rows whose combination reads 0 = c, c != 0, so
// that the user sees which constraints fight. Runs only on failure; the elimination proper carries no
// multipliers.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Certificate = std::vector<std::pair<std::size_t, Exact_integer> >;

// A row together with the combination of original rows that it is: columns from `number_of_columns`
// on hold the multipliers.
class Traced_rows
{
public:
  using Row = std::vector<Entry<Exact_integer> >;

  explicit Traced_rows(const Integer_system<Exact_integer>& system)
    : m_system(system), m_number_of_columns(Column_index(system.number_of_columns()))
  { }

  // Reduces row `i` by the rows before it. Returns true if 0 = c, c != 0, is left.
  bool add(const std::size_t i, Certificate& certificate)
  {
    Row row(m_system.begin(i), m_system.end(i));
    row.push_back({m_number_of_columns + Column_index(i), Exact_integer(1)});
    Exact_integer b = m_system.right_hand_side(i);
    while(row.front().column < m_number_of_columns) {
      const auto pivot = m_pivot_rows.find(row.front().column);
      if(pivot == m_pivot_rows.end()) {
        const Column_index column = row.front().column;
        m_pivot_rows.emplace(column, std::make_pair(std::move(row), b));
        return false;
      }
      reduce(row, b, pivot->second.first, pivot->second.second);
    }
    if(b == 0)
      return false;
    for(const Entry<Exact_integer>& e : row)
      certificate.emplace_back(std::size_t(e.column - m_number_of_columns), e.coefficient);
    return true;
  }

private:
  // Cancels the first entry, which both rows hold in the same column.
  static void reduce(Row& row, Exact_integer& b, const Row& pivot_row, const Exact_integer& pivot_b)
  {
    const Exact_integer divisor = greatest_common_divisor(row.front().coefficient,
                                                          pivot_row.front().coefficient);
    const Exact_integer p = exact_quotient(pivot_row.front().coefficient, divisor);
    const Exact_integer q = exact_quotient(row.front().coefficient, divisor);
    Row sum;
    for(const Entry<Exact_integer>& e : row)
      sum.push_back({e.column, Exact_integer(p * e.coefficient)});
    for(const Entry<Exact_integer>& e : pivot_row)
      sum.push_back({e.column, Exact_integer(-Exact_integer(q * e.coefficient))});
    sort_and_sum(sum);
    b = Exact_integer(Exact_integer(p * b) - Exact_integer(q * pivot_b));
    Exact_integer factor(b);
    for(const Entry<Exact_integer>& e : sum)
      factor = greatest_common_divisor(factor, e.coefficient);
    for(Entry<Exact_integer>& e : sum)
      e.coefficient = exact_quotient(e.coefficient, factor);
    b = exact_quotient(b, factor);
    row = std::move(sum);
  }

  const Integer_system<Exact_integer>& m_system;
  Column_index m_number_of_columns;
  std::map<Column_index, std::pair<Row, Exact_integer> > m_pivot_rows;
};

// \pre the system has no solution over the rationals
inline Certificate contradiction_certificate(const Integer_system<Exact_integer>& system)
{
  Traced_rows rows(system);
  Certificate certificate;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    if(rows.add(i, certificate))
      break;
  return certificate;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CONTRADICTION_CERTIFICATE_H
