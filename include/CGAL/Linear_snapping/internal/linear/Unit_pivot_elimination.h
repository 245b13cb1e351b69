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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_UNIT_PIVOT_ELIMINATION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_UNIT_PIVOT_ELIMINATION_H

#include <CGAL/license/Linear_snapping.h>

// Sparse exact elimination that pivots on coefficients +-1 only, and leaves the rows in echelon
// order ([MC19] Sec. 4.1, without Algorithm 2: values of implied variables follow by
// back-substitution). What has no unit pivot left is handed on as the core. Pivots are chosen
// freely, always in a shortest row and there in the column that the fewest other rows share, or,
// where coefficients would grow, that these hold with the smallest coefficients: this keeps both
// the fill and the coefficients small.
//
// Columns that a single row holds, with coefficients unlike +-1, would pile up in ever longer rows:
// each cone of an odd number of quarter turns leaves one, with coefficient 2. A row needs but one
// of them. Several are replaced by an auxiliary unknown, which is a sum of them: a unimodular
// change of variables.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/elimination_queues.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Row `target` lost `factor` times row `pivot`; or, where `pivot` is -1, was divided by `factor`.
template <typename Integer>
struct Elimination_step
{
  Row_index target, pivot;
  Integer factor;
};

// Invariant after construction: each row is redundant (0 = 0), or contradictory (0 = c), or has a
// unit pivot in a column that no core row and no later pivot row holds, or belongs to the core.
// With 64-bit integers the constructor throws `Integer_overflow` where the exact result does not
// fit.
template <typename Integer>
class Unit_pivot_elimination
{
public:
  using Row = Entries<Integer>;
  using Log = std::vector<Elimination_step<Integer> >;

  // \param most_work multiplications of words; more throw `Work_exceeded`
  // \param log of all that happens to the system's rows, if it is wanted
  // \pre 64-bit integers are for systems that have no others
  Unit_pivot_elimination(const Integer_system& system, const double most_work,
                         Log* const log = nullptr)
    : m_number_of_original_columns(system.number_of_columns()), m_rows(system.number_of_rows()),
      m_right_hand_side(system.number_of_rows()), m_states(system.number_of_rows(), WAITING),
      m_columns(system.number_of_columns()), m_work_left(most_work), m_log(log)
  {
    load(system);
    Row_index row;
    while(m_queue.pop(row)) {
      process(row);
      Progress::tell_each_second([&] { return counted(m_pivots.size(), "row") + " eliminated"; });
    }
  }

  // Call once.
  Echelon_form take_echelon_form()
  {
    Echelon_form form;
    const std::size_t size = number_of_columns();
    form.pivot_rows = Integer_system(size);
    form.core_rows = Integer_system(size);
    std::size_t number_of_entries = 0;
    for(const Pivot& pivot : m_pivots)
      number_of_entries += row(pivot.row).size();
    form.pivot_rows.reserve(m_pivots.size(), number_of_entries);
    form.pivot_columns.reserve(m_pivots.size());
    form.rows_with_pivot.reserve(m_pivots.size());
    for(const Pivot& pivot : m_pivots) {
      add_row(pivot.row, form.pivot_rows);
      form.pivot_columns.push_back(pivot.column);
      if(std::size_t(pivot.row) < m_rows.size() - m_auxiliary_unknowns.size())
        form.rows_with_pivot.push_back(pivot.row);
    }
    for(std::size_t i = 0; i < m_rows.size(); ++i)
      if(m_states[i] == CORE) {
        add_row(Row_index(i), form.core_rows);
        form.rows_in_core.push_back(Row_index(i));
      }
    form.auxiliary_unknowns = std::move(m_auxiliary_unknowns);
    form.redundant_rows = std::move(m_redundant_rows);
    form.contradictory_rows = std::move(m_contradictory_rows);
    form.number_of_coefficients =
      form.pivot_rows.number_of_entries() + form.core_rows.number_of_entries();
    form.largest_coefficient = Exact_integer(m_largest_coefficient);
    form.is_multiprecision = std::is_same<Integer, Exact_integer>::value;
    return form;
  }

private:
  enum State : char { WAITING, CORE, DONE };
  struct Pivot { Row_index row; Column_index column; };

  std::size_t number_of_columns() const
  { return m_number_of_original_columns + m_auxiliary_unknowns.size(); }
  const Row& row(const Row_index i) const { return m_rows[std::size_t(i)]; }
  const Integer& right_hand_side(const Row_index i) const
  { return m_right_hand_side[std::size_t(i)]; }

  void add_row(const Row_index i, Integer_system& system) const
  {
    if constexpr(!std::is_same<Integer, Exact_integer>::value)
      if(Integer_system::fits(row(i), right_hand_side(i)))
        return system.add_row(row(i), right_hand_side(i));
    Integer_row<Exact_integer> exact{{}, Exact_integer(right_hand_side(i))};
    for(const Entry<Integer>& e : row(i))
      exact.entries.push_back({e.column, Exact_integer(e.coefficient)});
    system.add_row(std::move(exact));
  }

  void load_row(const Integer_system& system, const std::size_t i)
  {
    if constexpr(std::is_same<Integer, Exact_integer>::value) {
      Integer_row<Exact_integer> row = system.exact_row(i);
      m_rows[i] = std::move(row.entries);
      m_right_hand_side[i] = std::move(row.right_hand_side);
    } else {
      m_rows[i].reserve(2 * system.row(i).size()); // most rows grow
      m_rows[i].assign(system.row(i).begin(), system.row(i).end());
      m_right_hand_side[i] = system.right_hand_side(i);
    }
  }

  void load(const Integer_system& system)
  {
    m_columns.reserve(2 * system.number_of_entries()); // most rows grow
    m_queue.reserve(2 * m_rows.size());
    m_pivots.reserve(m_rows.size());
    for(std::size_t i = 0; i < m_rows.size(); ++i) {
      load_row(system, i);
      for(const Entry<Integer>& e : m_rows[i])
        m_columns.add(e.column, Row_index(i));
      divide_by_common_factor(Row_index(i));
      for(const Entry<Integer>& e : m_rows[i])
        note_size(e.coefficient);
      m_queue.push(Row_index(i), m_rows[i].size());
    }
  }

  void process(const Row_index i)
  {
    if(m_states[std::size_t(i)] != WAITING)
      return;
    if(row(i).empty()) {
      m_states[std::size_t(i)] = DONE;
      (right_hand_side(i) == 0 ? m_redundant_rows : m_contradictory_rows).push_back(i);
      return;
    }
    const Entry<Integer>* pivot = rarest_unit(row(i));
    if(pivot == nullptr) {
      m_states[std::size_t(i)] = CORE; // until another pivot changes it
      return;
    }
    if(leaves_large_coefficients(i, *pivot))
      pivot = gentlest_unit(i, pivot);
    const Row& pivot_row = row(i);
    m_states[std::size_t(i)] = DONE;
    m_pivots.push_back({i, pivot->column});
    for(const Entry<Integer>& e : pivot_row)
      m_columns.remove_one(e.column);
    if(m_columns.count(pivot->column) > 0)
      eliminate(i, *pivot);
  }

  const Entry<Integer>* rarest_unit(const Row& row) const
  {
    const Entry<Integer>* best = nullptr;
    int best_count = 0;
    for(const Entry<Integer>& e : row) {
      if(!is_unit(e.coefficient))
        continue;
      const int count = m_columns.count(e.column);
      if(best == nullptr || count < best_count) {
        best = &e;
        best_count = count;
        if(count == 1)
          break;
      }
    }
    return best;
  }

  // Whether rows that hold the pivot's column would get coefficients above 4, about. Since columns
  // are chosen freely, there is nearly always one that avoids it; without that, thousands of cones
  // of 120 degrees, each with a coefficient of 3, leave some of 10^10, by which implied values
  // multiply the rounding of the free ones.
  bool leaves_large_coefficients(const Row_index i, const Entry<Integer>& pivot) const
  {
    if(m_largest_coefficient <= 2)
      return false;
    Integer largest(1);
    for(const Entry<Integer>& e : row(i))
      largest = (std::max)(largest, Integer(absolute_value(e.coefficient)));
    return largest_elsewhere(i, pivot.column) > Integer(4) / largest;
  }

  // The largest coefficient of a column in the other rows that still wait.
  Integer largest_elsewhere(const Row_index i, const Column_index column) const
  {
    Integer largest(0);
    m_columns.for_rows(column, [&](const Row_index j) {
      const Entry<Integer>* const found =
        j == i || m_states[std::size_t(j)] == DONE ? nullptr : find_entry(row(j), column);
      if(found != nullptr)
        largest = (std::max)(largest, Integer(absolute_value(found->coefficient)));
    });
    return largest;
  }

  // The unit whose column has the smallest coefficients in other rows; the rarest of these.
  // \param rarest the one in the rarest column: others that are much less rare would cost more fill
  const Entry<Integer>* gentlest_unit(const Row_index i, const Entry<Integer>* const rarest) const
  {
    const int most_rows = m_columns.count(rarest->column) + 2;
    const Entry<Integer>* best = nullptr;
    Integer smallest(0);
    for(const Entry<Integer>& e : row(i)) {
      if(!is_unit(e.coefficient) || m_columns.count(e.column) > most_rows)
        continue;
      const Integer largest = largest_elsewhere(i, e.column);
      if(best == nullptr || largest < smallest ||
         (largest == smallest && m_columns.count(e.column) < m_columns.count(best->column))) {
        best = &e;
        smallest = largest;
      }
    }
    return best;
  }

  // Cancels the pivot's column in all rows that still wait.
  void eliminate(const Row_index i, const Entry<Integer>& pivot)
  {
    m_columns.take(pivot.column, m_rows_of_column);
    m_changed_rows.clear();
    for(const Row_index j : m_rows_of_column) {
      if(m_states[std::size_t(j)] == DONE)
        continue;
      const Entry<Integer>* const found = find_entry(m_rows[std::size_t(j)], pivot.column);
      if(found == nullptr)
        continue; // the list was out of date
      const Integer factor(found->coefficient * pivot.coefficient); // = / pivot, a unit
      subtract(j, factor, i);
      if(m_log != nullptr)
        m_log->push_back({j, i, factor});
      m_changed_rows.push_back(j);
    }
    for(const Row_index j : m_changed_rows) { // which columns are single is known only now
      merge_single_columns(j);
      divide_by_common_factor(j);
      m_states[std::size_t(j)] = WAITING;
      m_queue.push(j, m_rows[std::size_t(j)].size());
    }
  }

  // row j -= factor * row i
  void subtract(const Row_index j, const Integer& factor, const Row_index i)
  {
    Row& a = m_rows[std::size_t(j)];
    const Row& b = m_rows[std::size_t(i)];
    count_work(a.size() + b.size());
    m_scratch.clear();
    auto p = a.begin();
    auto q = b.begin();
    while(p != a.end() || q != b.end()) {
      if(q == b.end() || (p != a.end() && p->column < q->column)) {
        m_scratch.push_back(std::move(*p++));
      } else if(p == a.end() || q->column < p->column) {
        m_scratch.push_back({q->column, difference_with_product(Integer(0), factor,
                                                                q->coefficient)});
        note_size(m_scratch.back().coefficient);
        m_columns.add(q->column, j);
        ++q;
      } else {
        Integer c = difference_with_product(p->coefficient, factor, q->coefficient);
        if(c == 0) {
          m_columns.remove_one(p->column);
        } else {
          note_size(c);
          m_scratch.push_back({p->column, std::move(c)});
        }
        ++p;
        ++q;
      }
    }
    a.assign(std::make_move_iterator(m_scratch.begin()), std::make_move_iterator(m_scratch.end()));
    Integer& rhs = m_right_hand_side[std::size_t(j)];
    if(right_hand_side(i) != 0)
      rhs = difference_with_product(rhs, factor, right_hand_side(i));
  }

  void count_work(const std::size_t number_of_entries)
  {
    // multiplications that take as long as what is done with an entry
    constexpr double of_entry = std::is_same<Integer, Exact_integer>::value ? 60 : 6;
    m_work_left -= of_entry * double(number_of_entries);
    if(m_work_left < 0)
      throw Work_exceeded();
  }

  // The sum of at most this many of the system's unknowns is an auxiliary one, so that its value
  // still fits.
  static constexpr int largest_sum = 128;

  // c (u + q v + ...) becomes c w, where w = u + q v + ... is new, and u = w - q v - ... is
  // implied.
  void merge_single_columns(const Row_index i)
  {
    const std::size_t first = first_single(m_rows[std::size_t(i)]);
    if(first == m_rows[std::size_t(i)].size())
      return;
    Row& row = m_rows[std::size_t(i)];
    const Integer c = row[first].coefficient;
    Entries<std::int64_t> sum;
    sum.reserve(m_singles.size());
    int size = 0;
    for(std::size_t k = first; k < row.size(); ++k) {
      if(m_columns.count(row[k].column) != 1 ||
         (row[k].coefficient != c && row[k].coefficient != -c) ||
         size + sum_size(row[k].column) > largest_sum)
        continue;
      size += sum_size(row[k].column);
      sum.push_back({row[k].column, row[k].coefficient == c ? 1 : -1});
    }
    if(sum.size() < 2)
      return;
    const Column_index column = Column_index(number_of_columns());
    auto merged = sum.begin();
    row.erase(std::remove_if(row.begin(), row.end(), [&](const Entry<Integer>& e) {
      if(merged == sum.end() || e.column != merged->column)
        return false;
      ++merged;
      return true;
    }), row.end());
    row.push_back({column, c});
    m_columns.add_column();
    m_columns.add(column, i);

    Row implied; // w - u - q v - ... = 0, with pivot u
    implied.reserve(sum.size() + 1);
    for(const Entry<std::int64_t>& e : sum)
      implied.push_back({e.column, Integer(-e.coefficient)});
    implied.push_back({column, Integer(1)});
    add_auxiliary_unknown(std::move(sum), size, std::move(implied)); // invalidates `row`
  }

  // \param implied the row of one of the unknowns that it replaces, which is the first
  void add_auxiliary_unknown(Entries<std::int64_t> sum, const int size, Row implied)
  {
    m_sum_sizes.push_back(size);
    m_pivots.push_back({Row_index(m_rows.size()), implied.front().column});
    m_auxiliary_unknowns.push_back(std::move(sum));
    m_rows.push_back(std::move(implied));
    m_right_hand_side.push_back(Integer(0));
    m_states.push_back(DONE);
  }

  // The first of at least two columns that no other row holds and that have the same coefficient up
  // to the sign, or the size of the row.
  std::size_t first_single(const Row& row)
  {
    m_singles.clear();
    for(std::size_t k = 0; k < row.size(); ++k)
      if(m_columns.count(row[k].column) == 1) {
        if(is_unit(row[k].coefficient))
          return row.size(); // a pivot at no cost
        m_singles.push_back(
          {Integer(absolute_value(row[k].coefficient)), sum_size(row[k].column), k});
      }
    std::sort(m_singles.begin(), m_singles.end());
    std::size_t first = row.size();
    for(std::size_t i = 1; i < m_singles.size(); ++i) {
      const auto& [a, size_of_a, k] = m_singles[i - 1];
      const auto& [b, size_of_b, l] = m_singles[i];
      if(a == b && size_of_a + size_of_b <= largest_sum)
        first = (std::min)({first, k, l});
    }
    return first;
  }

  int sum_size(const Column_index column) const
  {
    return std::size_t(column) < m_number_of_original_columns
      ? 1 : m_sum_sizes[std::size_t(column) - m_number_of_original_columns];
  }

  void note_size(const Integer& c)
  {
    if(c > m_largest_coefficient)
      m_largest_coefficient = c;
    else if(c < -m_largest_coefficient)
      m_largest_coefficient = -c;
  }

  // "This can be beneficial as [...] the magnitude of the matrix entries has some influence on how
  // freely the values [...] can be chosen" ([MC19] Sec. 4.1); here it can also bring back unit
  // pivots.
  void divide_by_common_factor(const Row_index i)
  {
    Row& row = m_rows[std::size_t(i)];
    Integer factor = right_hand_side(i);
    for(const Entry<Integer>& e : row) {
      if(is_unit(e.coefficient))
        return;
      factor = greatest_common_divisor(factor, e.coefficient);
      if(is_unit(factor))
        return;
    }
    if(row.empty() || factor == 0)
      return;
    for(Entry<Integer>& e : row)
      e.coefficient = exact_quotient(e.coefficient, factor);
    m_right_hand_side[std::size_t(i)] = exact_quotient(right_hand_side(i), factor);
    if(m_log != nullptr)
      m_log->push_back({i, -1, factor});
  }

  std::size_t m_number_of_original_columns;
  std::vector<Entries<std::int64_t> > m_auxiliary_unknowns;
  std::vector<int> m_sum_sizes; // per auxiliary unknown
  std::vector<Row> m_rows;
  std::vector<Integer> m_right_hand_side;
  std::vector<State> m_states;
  Column_lists m_columns;
  Row_queue m_queue;
  std::vector<Pivot> m_pivots;
  std::vector<Row_index> m_redundant_rows, m_contradictory_rows;
  double m_work_left;
  Log* m_log;
  Integer m_largest_coefficient = Integer(0);
  std::vector<std::tuple<Integer, int, std::size_t> > m_singles; // scratch
  std::vector<Row_index> m_rows_of_column, m_changed_rows; // scratch
  Row m_scratch;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_UNIT_PIVOT_ELIMINATION_H
