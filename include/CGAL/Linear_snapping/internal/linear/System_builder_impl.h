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

// Adds rows of any numbers.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void System_builder::add_row(const Entries<std::int64_t>& entries)
{
  if(!add_small_row(entries))
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
  const Exact_integer multiple = least_common_denominator(entries, right_hand_side);
  Waiting_row row{m_rows.number_of_rows(), {}, 0};
  for(const Entry<Exact_rational>& e : entries)
    row.row.entries.push_back({e.column, numerator(e.coefficient, multiple)});
  row.row.right_hand_side = numerator(right_hand_side, multiple);
  sort_and_sum(row.row.entries);
  const Exact_integer divisor = divide_by_common_factor(row);
  m_scales[row.index] = quotient(multiple, divisor);
  m_waiting_rows.push_back(std::move(row));
  m_rows.add_row(Entries<std::int64_t>(), 0); // holds the place
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Scaled_system System_builder::take()
{
  if(!m_waiting_rows.empty())
    insert_waiting_rows();
  return {std::move(m_rows), std::move(m_scales)};
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_IMPL_H
