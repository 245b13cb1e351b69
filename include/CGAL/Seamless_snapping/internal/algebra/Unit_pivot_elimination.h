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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_UNIT_PIVOT_ELIMINATION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_UNIT_PIVOT_ELIMINATION_H

#include <CGAL/license/Seamless_snapping.h>

// Sparse exact elimination that pivots on coefficients +-1 only, and leaves the rows in echelon order
// (Sec. 4.1, without Algorithm 2: values of implied variables follow by back-substitution). What has no
// unit pivot left is handed on as the core. Pivots are chosen freely, always in a shortest row and there
// in the column that the fewest other rows share: this keeps both the fill and the coefficients small.
//
// Columns that a single row holds, with coefficients other than +-1, would pile up in ever longer rows: each
// cone of an odd number of quarter turns leaves one, with coefficient 2. A row needs but one of them. Several
// are replaced by a new unknown, which is a sum of them: a unimodular change of variables.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Rows keyed by length, shortest first. Entries are never removed: a row that changed its length or
// state since it was pushed is recognised by the caller when popped.
class Row_queue
{
public:
  Row_queue() : m_buckets(max_length + 1) { }

  void push(const Row_index row, const std::size_t length)
  {
    const std::size_t bucket = (std::min)(length, std::size_t(max_length));
    m_buckets[bucket].push_back(row);
    m_first = (std::min)(m_first, bucket);
  }

  // Returns false if the queue is empty.
  bool pop(Row_index& row)
  {
    while(m_first <= max_length && m_buckets[m_first].empty())
      ++m_first;
    if(m_first > max_length)
      return false;
    row = m_buckets[m_first].back();
    m_buckets[m_first].pop_back();
    return true;
  }

private:
  static constexpr std::size_t max_length = 255; // longer rows share a bucket
  std::vector<std::vector<Row_index> > m_buckets;
  std::size_t m_first = 0;
};

// For each column the rows that hold it: exact as a count, and as a list that also keeps rows which no
// longer do. (Lists in one array: appending must not allocate.)
class Column_lists
{
public:
  explicit Column_lists(const std::size_t number_of_columns)
    : m_head(number_of_columns, -1), m_count(number_of_columns, 0)
  { }

  void add(const Column_index column, const Row_index row)
  {
    std::int32_t& head = m_head[std::size_t(column)];
    m_nodes.push_back({row, head});
    head = static_cast<std::int32_t>(m_nodes.size()) - 1;
    ++m_count[std::size_t(column)];
  }

  // \pre `column` is the number of columns so far
  void add_column(const Column_index column, const Row_index row)
  {
    m_head.push_back(-1);
    m_count.push_back(0);
    add(column, row);
  }

  void remove_one(const Column_index column) { --m_count[std::size_t(column)]; }

  int count(const Column_index column) const { return m_count[std::size_t(column)]; }

  // Moves the list of `column` to `rows`.
  void take(const Column_index column, std::vector<Row_index>& rows)
  {
    rows.clear();
    for(std::int32_t i = m_head[std::size_t(column)]; i >= 0; i = m_nodes[std::size_t(i)].next)
      rows.push_back(m_nodes[std::size_t(i)].row);
    m_head[std::size_t(column)] = -1;
  }

private:
  struct Node { Row_index row; std::int32_t next; };
  std::vector<Node> m_nodes;
  std::vector<std::int32_t> m_head;
  std::vector<int> m_count;
};

// A new unknown in terms of older ones.
template <typename Integer>
struct Definition
{
  Column_index column;
  std::vector<Entry<Integer> > sum;
};

// Invariant after construction: each row is redundant (0 = 0), or contradictory (0 = c), or has a unit
// pivot in a column that no core row and no later pivot row holds, or belongs to the core.
// The original rows of pivot rows are linearly independent. With 64-bit integers the constructor throws
// `Integer_overflow` where the exact result does not fit.
template <typename Integer>
class Unit_pivot_elimination
{
public:
  using Row = std::vector<Entry<Integer> >;
  struct Pivot { Row_index row; Column_index column; };

  explicit Unit_pivot_elimination(const Integer_system<Integer>& system)
    : m_number_of_original_rows(system.number_of_rows()),
      m_number_of_original_columns(system.number_of_columns()),
      m_rows(system.number_of_rows()), m_right_hand_side(system.number_of_rows()),
      m_states(system.number_of_rows(), WAITING), m_columns(system.number_of_columns())
  {
    load(system);
    Row_index row;
    while(m_queue.pop(row))
      process(row);
    for(std::size_t i = 0; i < m_rows.size(); ++i)
      if(m_states[i] == CORE)
        m_core_rows.push_back(Row_index(i));
  }

  // New unknowns follow the system's; a pivot row beyond the system's says how one of them came about.
  std::size_t number_of_columns() const { return m_number_of_original_columns + m_definitions.size(); }
  bool is_original_row(const Row_index i) const { return std::size_t(i) < m_number_of_original_rows; }
  const std::vector<Definition<Integer> >& definitions() const { return m_definitions; }

  // In the order of elimination: back-substitution runs through it in reverse.
  const std::vector<Pivot>& pivots() const { return m_pivots; }
  const std::vector<Row_index>& core_rows() const { return m_core_rows; }
  const std::vector<Row_index>& redundant_rows() const { return m_redundant_rows; }
  const std::vector<Row_index>& contradictory_rows() const { return m_contradictory_rows; }
  const Row& row(const Row_index i) const { return m_rows[std::size_t(i)]; }
  const Integer& right_hand_side(const Row_index i) const
  { return m_right_hand_side[std::size_t(i)]; }
  const Integer& largest_coefficient() const { return m_largest_coefficient; }

  // Of all rows together.
  std::size_t number_of_coefficients() const
  {
    std::size_t result = 0;
    for(const Row& row : m_rows)
      result += row.size();
    return result;
  }

private:
  enum State : char { WAITING, CORE, DONE };

  void load(const Integer_system<Integer>& system)
  {
    for(std::size_t i = 0; i < m_rows.size(); ++i) {
      m_rows[i].reserve(2 * std::size_t(system.end(i) - system.begin(i))); // most rows grow
      m_rows[i].assign(system.begin(i), system.end(i));
      m_right_hand_side[i] = system.right_hand_side(i);
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
    const Row& pivot_row = m_rows[std::size_t(i)];
    if(pivot_row.empty()) {
      m_states[std::size_t(i)] = DONE;
      (right_hand_side(i) == 0 ? m_redundant_rows : m_contradictory_rows).push_back(i);
      return;
    }
    const Entry<Integer>* pivot = rarest_unit(pivot_row);
    if(pivot == nullptr) {
      m_states[std::size_t(i)] = CORE; // until another pivot changes it
      return;
    }
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
    const Row& a = m_rows[std::size_t(j)];
    const Row& b = m_rows[std::size_t(i)];
    m_scratch.clear();
    auto p = a.begin();
    auto q = b.begin();
    while(p != a.end() || q != b.end()) {
      if(q == b.end() || (p != a.end() && p->column < q->column)) {
        m_scratch.push_back(*p++);
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
    m_rows[std::size_t(j)].assign(m_scratch.begin(), m_scratch.end());
    Integer& rhs = m_right_hand_side[std::size_t(j)];
    if(right_hand_side(i) != 0)
      rhs = difference_with_product(rhs, factor, right_hand_side(i));
  }

  // The sum of at most this many of the system's unknowns is a new one, so that its value still fits.
  static constexpr int largest_sum = 128;

  // c (u + q v + ...) becomes c w, where w = u + q v + ... is new, and u = w - q v - ... is implied.
  void merge_single_columns(const Row_index i)
  {
    const std::size_t first = first_single(m_rows[std::size_t(i)]);
    if(first == m_rows[std::size_t(i)].size())
      return;
    Row& row = m_rows[std::size_t(i)];
    const Integer c = row[first].coefficient;
    Definition<Integer> definition;
    int size = 0;
    for(std::size_t k = first; k < row.size(); ++k) {
      if(m_columns.count(row[k].column) != 1 || (row[k].coefficient != c && row[k].coefficient != -c) ||
         size + sum_size(row[k].column) > largest_sum)
        continue;
      size += sum_size(row[k].column);
      definition.sum.push_back({row[k].column, row[k].coefficient == c ? Integer(1) : Integer(-1)});
    }
    if(definition.sum.size() < 2)
      return;
    definition.column = Column_index(number_of_columns());
    auto merged = definition.sum.begin();
    row.erase(std::remove_if(row.begin(), row.end(), [&](const Entry<Integer>& e) {
      if(merged == definition.sum.end() || e.column != merged->column)
        return false;
      ++merged;
      return true;
    }), row.end());
    row.push_back({definition.column, c});
    m_columns.add_column(definition.column, i);

    Row implied(definition.sum); // w - u - q v - ... = 0, with pivot u
    for(Entry<Integer>& e : implied)
      e.coefficient = -e.coefficient;
    implied.push_back({definition.column, Integer(1)});
    m_pivots.push_back({Row_index(m_rows.size()), implied.front().column});
    m_sum_sizes.push_back(size);
    m_definitions.push_back(std::move(definition));
    m_rows.push_back(std::move(implied)); // invalidates `row`
    m_right_hand_side.push_back(Integer(0));
    m_states.push_back(DONE);
  }

  // The first of at least two columns that no other row holds and that have the same coefficient up to the
  // sign, or the size of the row.
  std::size_t first_single(const Row& row)
  {
    m_singles.clear();
    for(std::size_t k = 0; k < row.size(); ++k)
      if(m_columns.count(row[k].column) == 1) {
        if(is_unit(row[k].coefficient))
          return row.size(); // a pivot at no cost
        m_singles.push_back({Integer(CGAL::abs(row[k].coefficient)), sum_size(row[k].column), k});
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
  // freely the values [...] can be chosen" (Sec. 4.1); here it can also bring back unit pivots.
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
  }

  std::size_t m_number_of_original_rows, m_number_of_original_columns;
  std::vector<Definition<Integer> > m_definitions;
  std::vector<int> m_sum_sizes; // per definition
  std::vector<Row> m_rows;
  std::vector<Integer> m_right_hand_side;
  std::vector<State> m_states;
  Column_lists m_columns;
  Row_queue m_queue;
  std::vector<Pivot> m_pivots;
  std::vector<Row_index> m_core_rows, m_redundant_rows, m_contradictory_rows;
  Integer m_largest_coefficient = Integer(0);
  std::vector<std::tuple<Integer, int, std::size_t> > m_singles; // scratch
  std::vector<Row_index> m_rows_of_column, m_changed_rows; // scratch
  Row m_scratch;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_UNIT_PIVOT_ELIMINATION_H
