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

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
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

inline Exact_integer least_common_multiple(const Exact_integer& a, const Exact_integer& b)
{
  return product(exact_quotient(a, greatest_common_divisor(a, b)), b);
}

// Replaces multipliers by integers without a common factor.
inline Certificate to_integer_multipliers(
  const std::vector<std::pair<std::size_t, Exact_rational> >& multipliers)
{
  std::vector<Fraction> fractions;
  Exact_integer denominator(1), factor(0);
  for(const auto& multiple : multipliers) {
    fractions.push_back(to_fraction(multiple.second));
    denominator = least_common_multiple(denominator, fractions.back().denominator);
  }
  Certificate result;
  for(std::size_t i = 0; i < multipliers.size(); ++i) {
    const Fraction& f = fractions[i];
    result.emplace_back(multipliers[i].first,
                        product(f.numerator, exact_quotient(denominator, f.denominator)));
    factor = greatest_common_divisor(factor, result.back().second);
  }
  for(auto& multiple : result)
    multiple.second = exact_quotient(multiple.second, factor);
  return result;
}

// A system in integers, and the factors between its rows and the rows of the caller.
struct Scaled_system
{
  Integer_system system;
  std::map<std::size_t, Exact_rational> scales; // 1 for rows that are not here
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
  // A row that was not made of 64-bit integers, or that has a right-hand side.
  struct Waiting_row
  {
    std::size_t index;
    Integer_row<Exact_integer> row; // the right-hand side times 2^-right_hand_scale; odd, or 0
    int right_hand_scale;
  };

  static BOOST_NOINLINE Exact_rational quotient(const Exact_integer& a, const Exact_integer& b)
  {
    return Exact_rational(Exact_rational(a) / Exact_rational(b));
  }

  static BOOST_NOINLINE Entries<Exact_rational> to_rationals(const Entries<std::int64_t>& entries)
  {
    Entries<Exact_rational> row;
    for(const Entry<std::int64_t>& e : entries)
      row.push_back({e.column, Exact_rational(e.coefficient)});
    return row;
  }

  bool add_small_row(const Entries<std::int64_t>& entries)
  {
    Entries<std::int64_t>& row = m_row;
    row.assign(entries.begin(), entries.end());
    try {
      sort_and_sum(row);
    } catch(const Integer_overflow&) {
      return false;
    }
    for(const Entry<std::int64_t>& e : row)
      if(!fits_64_bits(e.coefficient))
        return false;
    m_rows.add_row(row, 0);
    return true;
  }

  static Exact_integer least_common_denominator(const Entries<Exact_rational>& entries,
                                                const Exact_rational& b)
  {
    Exact_integer multiple = to_fraction(b).denominator;
    for(const Entry<Exact_rational>& e : entries)
      multiple = least_common_multiple(multiple, to_fraction(e.coefficient).denominator);
    return multiple;
  }

  // Divides the row by the greatest common divisor of its coefficients, as far as the right-hand
  // side goes. Returns the divisor.
  static Exact_integer divide_by_common_factor(Waiting_row& waiting)
  {
    Integer_row<Exact_integer>& row = waiting.row;
    Exact_integer factor(0), divisor(1);
    for(const Entry<Exact_integer>& e : row.entries)
      factor = greatest_common_divisor(factor, e.coefficient);
    if(factor != 0) {
      const int twos = number_of_halvings(factor);
      const Exact_integer common =
        greatest_common_divisor(halved(factor, twos), row.right_hand_side);
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

  void insert_waiting_rows()
  {
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
    m_rows = std::move(result);
  }

  static BOOST_NOINLINE Exact_integer numerator(const Exact_rational& q,
                                                const Exact_integer& common_denominator)
  {
    const Fraction f = to_fraction(q);
    return product(f.numerator, exact_quotient(common_denominator, f.denominator));
  }

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
