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
// multipliers. Neither does this one: it notes its steps, and follows them back from the
// contradiction.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>
#include <CGAL/Seamless_snapping/internal/algebra/System_builder.h>
#include <CGAL/Seamless_snapping/internal/algebra/Unit_pivot_elimination.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Certificate = std::vector<std::pair<std::size_t, Exact_integer> >;

// Those that may take part in a combination without unknowns: not one that holds a column alone, nor
// one that does so once such rows are gone.
inline std::vector<Row_index>
rows_without_single_columns(const Integer_system<Exact_integer>& system)
{
  struct Holders { Row_index exclusive_or, count; }; // of the rows left: one row is known by it
  std::vector<Holders> holders(system.number_of_columns(), Holders{0, 0});
  std::vector<Column_index> single;
  const auto change = [&](const std::size_t i, const Row_index by) {
    for(const Entry<Exact_integer>* e = system.begin(i); e != system.end(i); ++e) {
      Holders& h = holders[std::size_t(e->column)];
      h.exclusive_or ^= Row_index(i);
      h.count += by;
      if(by < 0 && h.count == 1)
        single.push_back(e->column);
    }
  };
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    change(i, 1);
  for(std::size_t j = 0; j < holders.size(); ++j)
    if(holders[j].count == 1)
      single.push_back(Column_index(j));
  std::vector<bool> is_left(system.number_of_rows(), true);
  while(!single.empty()) {
    const Holders& h = holders[std::size_t(single.back())];
    single.pop_back();
    if(h.count != 1)
      continue;
    const std::size_t i = std::size_t(h.exclusive_or);
    is_left[i] = false;
    change(i, -1);
  }
  std::vector<Row_index> rows;
  for(std::size_t i = 0; i < is_left.size(); ++i)
    if(is_left[i])
      rows.push_back(Row_index(i));
  return rows;
}

// Sparse elimination over the rationals with any pivots, chosen like those of `Unit_pivot_elimination`
// for little fill. Invariant: each row is the combination of original rows that `m_steps` say.
class Traced_elimination
{
public:
  explicit Traced_elimination(const Integer_system<Exact_integer>& system)
    : m_rows(system.number_of_rows()), m_right_hand_side(system.number_of_rows()),
      m_is_waiting(system.number_of_rows(), false), m_columns(system.number_of_columns())
  {
    for(const Row_index i : rows_without_single_columns(system)) {
      Row& row = m_rows[std::size_t(i)];
      row.assign(system.begin(std::size_t(i)), system.end(std::size_t(i)));
      m_right_hand_side[std::size_t(i)] = system.right_hand_side(std::size_t(i));
      m_is_waiting[std::size_t(i)] = true;
      for(const Entry<Exact_integer>& e : row)
        m_columns.add(e.column, i);
      m_queue.push(i, row.size());
    }
  }

  // Eliminates until a row reads 0 = c, c != 0. The certificate is empty if none does.
  Certificate contradiction()
  {
    Row_index i;
    while(m_queue.pop(i)) {
      if(!m_is_waiting[std::size_t(i)])
        continue;
      m_is_waiting[std::size_t(i)] = false;
      if(!m_rows[std::size_t(i)].empty())
        eliminate(i);
      else if(m_right_hand_side[std::size_t(i)] != 0)
        return certificate(i);
    }
    return Certificate();
  }

private:
  using Row = std::vector<Entry<Exact_integer> >;
  // row `target` became (p row `target` - q row `pivot`) / divisor; row `pivot` is final
  struct Step { Row_index target, pivot; Exact_integer p, q, divisor; };

  // Cancels a column of row `i` in all rows that wait.
  void eliminate(const Row_index i)
  {
    const Row& row = m_rows[std::size_t(i)];
    for(const Entry<Exact_integer>& e : row)
      m_columns.remove_one(e.column);
    const Entry<Exact_integer>& pivot =
      *std::min_element(row.begin(), row.end(), [&](const auto& a, const auto& b)
                        { return m_columns.count(a.column) < m_columns.count(b.column); });
    if(m_columns.count(pivot.column) == 0)
      return;
    m_columns.take(pivot.column, m_rows_of_column);
    for(const Row_index j : m_rows_of_column) {
      if(!m_is_waiting[std::size_t(j)])
        continue;
      const Entry<Exact_integer>* const found = find_entry(m_rows[std::size_t(j)], pivot.column);
      if(found == nullptr)
        continue; // the list was out of date
      const Exact_integer divisor = greatest_common_divisor(found->coefficient, pivot.coefficient);
      Step step{j, i, exact_quotient(pivot.coefficient, divisor),
                exact_quotient(found->coefficient, divisor), Exact_integer(1)};
      reduce(step);
      m_steps.push_back(std::move(step));
      m_queue.push(j, m_rows[std::size_t(j)].size());
    }
  }

  // Does the step, and finds its divisor.
  void reduce(Step& step)
  {
    Row& target = m_rows[std::size_t(step.target)];
    const Row& pivot = m_rows[std::size_t(step.pivot)];
    Exact_integer& b = m_right_hand_side[std::size_t(step.target)];
    Row sum;
    auto s = target.begin();
    auto t = pivot.begin();
    while(s != target.end() || t != pivot.end()) {
      if(t == pivot.end() || (s != target.end() && s->column < t->column)) {
        sum.push_back({s->column, Exact_integer(step.p * s->coefficient)});
        ++s;
      } else if(s == target.end() || t->column < s->column) {
        sum.push_back({t->column, Exact_integer(-Exact_integer(step.q * t->coefficient))});
        m_columns.add(t->column, step.target);
        ++t;
      } else {
        const Exact_integer c = Exact_integer(Exact_integer(step.p * s->coefficient) -
                                              Exact_integer(step.q * t->coefficient));
        if(c != 0)
          sum.push_back({s->column, c});
        else
          m_columns.remove_one(s->column);
        ++s;
        ++t;
      }
    }
    b = Exact_integer(Exact_integer(step.p * b) -
                      Exact_integer(step.q * m_right_hand_side[std::size_t(step.pivot)]));
    Exact_integer factor(b);
    for(const Entry<Exact_integer>& e : sum)
      factor = greatest_common_divisor(factor, e.coefficient);
    if(factor != 0 && factor != 1) {
      for(Entry<Exact_integer>& e : sum)
        e.coefficient = exact_quotient(e.coefficient, factor);
      b = exact_quotient(b, factor);
      step.divisor = factor;
    }
    target = std::move(sum);
  }

  // The combination of original rows that row `i` is, up to a factor.
  Certificate certificate(const Row_index i) const
  {
    std::vector<Exact_rational> multipliers(m_rows.size(), Exact_rational(0));
    multipliers[std::size_t(i)] = Exact_rational(1);
    for(auto step = m_steps.rbegin(); step != m_steps.rend(); ++step) {
      Exact_rational& target = multipliers[std::size_t(step->target)];
      if(target == 0)
        continue;
      const Exact_rational share = target / Exact_rational(step->divisor);
      target = share * Exact_rational(step->p);
      multipliers[std::size_t(step->pivot)] -= share * Exact_rational(step->q);
    }
    Certificate result;
    Exact_integer denominator(1);
    for(const Exact_rational& y : multipliers) {
      const Exact_integer d = numerator_and_denominator(y).second;
      const Exact_integer common = greatest_common_divisor(denominator, d);
      denominator = Exact_integer(exact_quotient(denominator, common) * d);
    }
    for(std::size_t k = 0; k < multipliers.size(); ++k)
      if(multipliers[k] != 0) {
        const auto parts = numerator_and_denominator(multipliers[k]);
        const Exact_integer factor = exact_quotient(denominator, parts.second);
        result.emplace_back(k, Exact_integer(parts.first * factor));
      }
    return result;
  }

  std::vector<Row> m_rows;
  std::vector<Exact_integer> m_right_hand_side;
  std::vector<bool> m_is_waiting; // for being a pivot row
  Column_lists m_columns; // of the rows that wait
  Row_queue m_queue;
  std::vector<Step> m_steps;
  std::vector<Row_index> m_rows_of_column; // scratch
};

// \pre the system has no solution over the rationals
inline Certificate contradiction_certificate(const Integer_system<Exact_integer>& system)
{
  return Traced_elimination(system).contradiction();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CONTRADICTION_CERTIFICATE_H
