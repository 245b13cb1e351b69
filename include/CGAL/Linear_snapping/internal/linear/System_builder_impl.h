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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_IMPL_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_IMPL_H

#include <CGAL/license/Linear_snapping.h>

// Adds rows of any numbers, and makes integers of these.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

inline Exact_integer least_common_multiple(const Exact_integer& a, const Exact_integer& b)
{
  return product(exact_quotient(a, greatest_common_divisor(a, b)), b);
}

inline BOOST_NOINLINE Exact_integer numerator(const Exact_rational& q,
                                              const Exact_integer& common_denominator)
{
  const Fraction f = to_fraction(q);
  return product(f.numerator, exact_quotient(common_denominator, f.denominator));
}

inline BOOST_NOINLINE Entries<Exact_rational> to_rationals(const Entries<std::int64_t>& entries)
{
  Entries<Exact_rational> row;
  for(const Entry<std::int64_t>& e : entries)
    row.push_back({e.column, Exact_rational(e.coefficient)});
  return row;
}

// Divides the row by the greatest common divisor of its coefficients, as far as the right-hand
// side goes. Returns the divisor.
inline Exact_integer divide_by_common_factor(Waiting_row& waiting)
{
  Integer_row<Exact_integer>& row = waiting.row;
  Exact_integer factor(0), divisor(1);
  for(const Entry<Exact_integer>& e : row.entries)
    factor = greatest_common_divisor(factor, e.coefficient);
  if(factor != 0) {
    const int twos = number_of_halvings(factor);
    const Exact_integer common = greatest_common_divisor(halved(factor, twos), row.right_hand_side);
    divisor = product(common, power_of_two(std::size_t(twos)));
    for(Entry<Exact_integer>& e : row.entries)
      e.coefficient = exact_quotient(e.coefficient, divisor);
    row.right_hand_side = exact_quotient(row.right_hand_side, common);
    waiting.right_hand_scale = twos;
  }
  if(row.right_hand_side != 0) {
    const int halvings = number_of_halvings(row.right_hand_side);
    row.right_hand_side = halved(row.right_hand_side, halvings);
    waiting.right_hand_scale -= halvings;
  }
  return divisor;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Certificate
to_integer_multipliers(const std::vector<std::pair<std::size_t, Exact_rational> >& multipliers)
{
  Exact_integer denominator(1), factor(0);
  for(const auto& multiple : multipliers)
    denominator = least_common_multiple(denominator, to_fraction(multiple.second).denominator);
  Certificate result;
  for(const auto& multiple : multipliers) {
    result.emplace_back(multiple.first, numerator(multiple.second, denominator));
    factor = greatest_common_divisor(factor, result.back().second);
  }
  for(auto& multiple : result)
    multiple.second = exact_quotient(multiple.second, factor);
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void System_builder::add_row(const Entries<std::int64_t>& entries)
{
  m_row.assign(entries.begin(), entries.end());
  try {
    sort_and_sum(m_row);
    if(Integer_system::fits(m_row, std::int64_t(0)))
      return m_rows.add_row(m_row, 0);
  } catch(const Integer_overflow&) { }
  add_row(to_rationals(entries), Exact_rational(0));
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void System_builder::add_row(const Entries<std::int64_t>& entries,
                             const Exact_rational& right_hand_side)
{
  if(right_hand_side == 0)
    add_row(entries);
  else
    add_row(to_rationals(entries), right_hand_side);
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void System_builder::add_row(const Entries<Exact_rational>& entries,
                             const Exact_rational& right_hand_side)
{
  Exact_integer multiple = to_fraction(right_hand_side).denominator;
  for(const Entry<Exact_rational>& e : entries)
    multiple = least_common_multiple(multiple, to_fraction(e.coefficient).denominator);
  Waiting_row row{m_rows.number_of_rows(), {}, 0};
  for(const Entry<Exact_rational>& e : entries)
    row.row.entries.push_back({e.column, numerator(e.coefficient, multiple)});
  row.row.right_hand_side = numerator(right_hand_side, multiple);
  sort_and_sum(row.row.entries);
  const Exact_integer divisor = divide_by_common_factor(row);
  m_scales[row.index] = Exact_rational(multiple) / Exact_rational(divisor);
  m_waiting_rows.push_back(std::move(row));
  m_rows.add_row(Entries<std::int64_t>(), 0); // holds the place
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Scaled_system System_builder::take()
{
  if(m_waiting_rows.empty())
    return {std::move(m_rows), std::move(m_scales)};
  std::optional<int> finest;
  for(const Waiting_row& row : m_waiting_rows)
    if(row.row.right_hand_side != 0)
      finest = (std::max)(finest.value_or(row.right_hand_scale), row.right_hand_scale);
  Integer_system result(m_rows.number_of_columns());
  result.set_right_hand_scale(finest.value_or(0));
  auto waiting = m_waiting_rows.begin();
  for(std::size_t i = 0; i < m_rows.number_of_rows(); ++i) {
    if(waiting == m_waiting_rows.end() || waiting->index != i) {
      result.add_row(m_rows.row(i), 0);
      continue;
    }
    Exact_integer& b = waiting->row.right_hand_side;
    if(b != 0)
      b = product(b, power_of_two(std::size_t(*finest - waiting->right_hand_scale)));
    result.add_row(std::move(waiting->row));
    ++waiting;
  }
  return {std::move(result), std::move(m_scales)};
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_IMPL_H
