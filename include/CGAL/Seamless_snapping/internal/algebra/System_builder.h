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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_BUILDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_BUILDER_H

#include <CGAL/license/Seamless_snapping.h>

// Turns rows with integer or rational coefficients and right-hand sides into a system of integers:
// "simply by multiplying each system row with the least common multiple of its entries' denominators"
// (Sec. 4). Factors of two of the right-hand sides' denominators go into their common scale instead,
// since a finer grid can provide them.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// 64-bit integers wherever these suffice.
using Any_system = std::variant<Integer_system<std::int64_t>, Integer_system<Exact_integer> >;

inline std::pair<Exact_integer, Exact_integer> numerator_and_denominator(const Exact_rational& q)
{
  using Traits = CGAL::Fraction_traits<Exact_rational>;
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(q, numerator, denominator);
  return {Exact_integer(numerator), Exact_integer(denominator)};
}

// A system in integers, and by which factors its rows differ from those the caller gave.
struct Scaled_system
{
  Any_system system;
  std::map<std::size_t, Exact_rational> scales; // 1 for rows that aren't here

  // Multipliers of the system's rows, as multipliers of the caller's: integers without a common factor.
  void rescale(std::vector<std::pair<std::size_t, Exact_integer> >& certificate) const
  {
    std::vector<Exact_rational> multipliers;
    Exact_integer denominator(1), factor(0);
    for(const auto& multiple : certificate) {
      const auto scale = scales.find(multiple.first);
      multipliers.push_back(Exact_rational(multiple.second) *
                            (scale == scales.end() ? Exact_rational(1) : scale->second));
      const Exact_integer d = numerator_and_denominator(multipliers.back()).second;
      denominator = Exact_integer(exact_quotient(denominator, greatest_common_divisor(denominator, d)) * d);
    }
    for(std::size_t i = 0; i < certificate.size(); ++i) {
      const auto parts = numerator_and_denominator(multipliers[i]);
      certificate[i].second = Exact_integer(parts.first * exact_quotient(denominator, parts.second));
      factor = greatest_common_divisor(factor, certificate[i].second);
    }
    for(auto& multiple : certificate)
      multiple.second = exact_quotient(multiple.second, factor);
  }
};

class System_builder
{
public:
  explicit System_builder(const std::size_t number_of_columns)
    : m_number_of_columns(number_of_columns), m_rows(number_of_columns)
  { }

  // With right-hand side 0.
  void add_row(const std::vector<Entry<std::int64_t> >& entries)
  {
    if(!add_small_row(entries))
      add_row(to_rationals(entries), Exact_rational(0));
  }

  // Entries in any order; equal columns add up.
  template <typename Coefficient>
  void add_row(const std::vector<Entry<Coefficient> >& entries,
               const Exact_rational& right_hand_side)
  {
    if constexpr(std::is_same<Coefficient, std::int64_t>::value) {
      if(right_hand_side == 0 && add_small_row(entries))
        return;
    }
    std::vector<Entry<Exact_rational> > row = to_rationals(entries);
    add_rational_row(row, right_hand_side);
  }

  // Call once, when all rows are there.
  Scaled_system take() { return {take_system(), std::move(m_scales)}; }

private:
  Any_system take_system()
  {
    std::optional<int> finest;
    for(const Large_row& row : m_large_rows)
      if(row.right_hand_side != 0)
        finest = finest ? (std::max)(*finest, row.right_hand_scale) : row.right_hand_scale;
    const int scale = finest ? *finest : 0;
    bool small = true;
    for(Large_row& row : m_large_rows) {
      if(row.right_hand_side != 0)
        row.right_hand_side = Exact_integer(row.right_hand_side *
                                            power_of_two(std::size_t(scale - row.right_hand_scale)));
      small = small && fits_64_bits(row.right_hand_side) &&
              std::all_of(row.entries.begin(), row.entries.end(),
                          [](const Entry<Exact_integer>& e) { return fits_64_bits(e.coefficient); });
    }
    if(m_large_rows.empty())
      return Any_system(std::move(m_rows));
    if(small)
      return Any_system(merged<std::int64_t>(scale));
    return Any_system(merged<Exact_integer>(scale));
  }

  // A row that is not made of 64-bit integers only, or that has a right-hand side.
  struct Large_row
  {
    std::size_t index;
    std::vector<Entry<Exact_integer> > entries;
    Exact_integer right_hand_side; // times 2^-right_hand_scale; odd, or 0
    int right_hand_scale;
  };

  template <typename Coefficient>
  static std::vector<Entry<Exact_rational> >
  to_rationals(const std::vector<Entry<Coefficient> >& entries)
  {
    std::vector<Entry<Exact_rational> > row;
    for(const Entry<Coefficient>& e : entries)
      row.push_back({e.column, Exact_rational(e.coefficient)});
    return row;
  }

  bool add_small_row(const std::vector<Entry<std::int64_t> >& entries)
  {
    std::vector<Entry<std::int64_t> >& row = m_row;
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

  void add_rational_row(std::vector<Entry<Exact_rational> >& entries, const Exact_rational& b)
  {
    std::sort(entries.begin(), entries.end(),
              [](const Entry<Exact_rational>& x, const Entry<Exact_rational>& y)
              { return x.column < y.column; });
    // The row times the least common multiple of all denominators ...
    Exact_integer multiple(numerator_and_denominator(b).second);
    for(const Entry<Exact_rational>& e : entries) {
      const Exact_integer denominator = numerator_and_denominator(e.coefficient).second;
      multiple = Exact_integer(exact_quotient(multiple,
                                              greatest_common_divisor(multiple, denominator)) *
                               denominator);
    }
    Large_row row{m_rows.number_of_rows(), {}, numerator(b, multiple), 0};
    for(const Entry<Exact_rational>& e : entries)
      row.entries.push_back({e.column, numerator(e.coefficient, multiple)});
    sort_and_sum(row.entries);
    // ... and over the greatest common divisor of its coefficients, as far as the right-hand side goes.
    Exact_integer factor(0);
    for(const Entry<Exact_integer>& e : row.entries)
      factor = greatest_common_divisor(factor, e.coefficient);
    if(factor != 0) {
      const int twos = number_of_halvings(factor);
      const Exact_integer odd = exact_quotient(factor, power_of_two(std::size_t(twos)));
      const Exact_integer common = greatest_common_divisor(odd, row.right_hand_side);
      const Exact_integer divisor(common * power_of_two(std::size_t(twos)));
      m_scales[m_rows.number_of_rows()] = Exact_rational(multiple) / Exact_rational(divisor);
      for(Entry<Exact_integer>& e : row.entries)
        e.coefficient = exact_quotient(e.coefficient, divisor);
      row.right_hand_side = exact_quotient(row.right_hand_side, common);
      row.right_hand_scale = twos;
    } else {
      m_scales[m_rows.number_of_rows()] = Exact_rational(multiple);
    }
    if(row.right_hand_side != 0) {
      const int halvings = number_of_halvings(row.right_hand_side);
      row.right_hand_side = exact_quotient(row.right_hand_side, power_of_two(std::size_t(halvings)));
      row.right_hand_scale -= halvings;
    }
    m_rows.add_row({}, 0); // holds the place
    m_large_rows.push_back(std::move(row));
  }

  static Exact_integer numerator(const Exact_rational& q, const Exact_integer& common_denominator)
  {
    const auto parts = numerator_and_denominator(q);
    return Exact_integer(parts.first * exact_quotient(common_denominator, parts.second));
  }

  template <typename Integer>
  static Integer converted(const Exact_integer& a)
  {
    if constexpr(std::is_same<Integer, std::int64_t>::value)
      return to_64_bits(a);
    else
      return a;
  }

  template <typename Integer>
  Integer_system<Integer> merged(const int scale) const
  {
    Integer_system<Integer> result(m_number_of_columns);
    result.set_right_hand_scale(scale);
    std::vector<Entry<Integer> > entries;
    auto large = m_large_rows.begin();
    for(std::size_t i = 0; i < m_rows.number_of_rows(); ++i) {
      entries.clear();
      Integer b(0);
      if(large != m_large_rows.end() && large->index == i) {
        for(const Entry<Exact_integer>& e : large->entries)
          entries.push_back({e.column, converted<Integer>(e.coefficient)});
        b = converted<Integer>(large->right_hand_side);
        ++large;
      } else {
        for(const Entry<std::int64_t>* e = m_rows.begin(i); e != m_rows.end(i); ++e)
          entries.push_back({e->column, Integer(e->coefficient)});
      }
      result.add_row(entries, b);
    }
    return result;
  }

  std::size_t m_number_of_columns;
  Integer_system<std::int64_t> m_rows;
  std::vector<Entry<std::int64_t> > m_row; // under way
  std::vector<Large_row> m_large_rows; // by index
  std::map<std::size_t, Exact_rational> m_scales; // of large rows
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_BUILDER_H
