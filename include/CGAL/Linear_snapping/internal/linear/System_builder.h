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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_H

#include <CGAL/license/Linear_snapping.h>

// Turns rows with integer or rational coefficients and right-hand sides into a system of integers:
// "simply by multiplying each system row with the least common multiple of its entries'
// denominators" ([MC19] Sec. 4). Factors of two of the right-hand sides' denominators go into their
// common scale instead, since a finer grid can provide them.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

using Certificate = std::vector<std::pair<std::size_t, Exact_integer> >; // multiples of rows

struct Fraction
{
  Exact_integer numerator, denominator;
};

inline BOOST_NOINLINE Fraction to_fraction(const Exact_rational& q)
{
  using Traits = CGAL::Fraction_traits<Exact_rational>;
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(q, numerator, denominator);
  return {Exact_integer(numerator), Exact_integer(denominator)};
}

// Replaces multipliers by integers without a common factor.
Certificate
to_integer_multipliers(const std::vector<std::pair<std::size_t, Exact_rational> >& multipliers);

// A system in integers, and the factors between its rows and the rows of the caller.
struct Scaled_system
{
  Integer_system system;
  std::map<std::size_t, Exact_rational> scales; // 1 for rows that are not here
};

// A row that was not made of 64-bit integers, or that has a right-hand side.
struct Waiting_row
{
  std::size_t index;
  Integer_row<Exact_integer> row; // the right-hand side times 2^-right_hand_scale; odd, or 0
  int right_hand_scale;
};

class System_builder
{
public:
  explicit System_builder(const std::size_t number_of_columns) : m_rows(number_of_columns) { }

  // With right-hand side 0. Entries of all rows may be in any order; equal columns add up.
  void add_row(const Entries<std::int64_t>& entries);

  void add_row(const Entries<std::int64_t>& entries, const Exact_rational& right_hand_side);

  void add_row(const Entries<Exact_rational>& entries, const Exact_rational& right_hand_side);

  // Call once, when all rows are there.
  Scaled_system take();

private:
  Integer_system m_rows;
  Entries<std::int64_t> m_row; // scratch
  std::vector<Waiting_row> m_waiting_rows; // by index
  std::map<std::size_t, Exact_rational> m_scales; // the scale of each row with a scale other than 1
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Linear_snapping/internal/linear/System_builder_impl.h>
#endif

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SYSTEM_BUILDER_H
