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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATION_QUEUES_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATION_QUEUES_H

#include <CGAL/license/Linear_snapping.h>

// Tables from which an elimination chooses its pivots: rows by length, and the rows of each column.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Lists of rows, the last one first, in one array: systems of thousands of small components must
// not allocate for each list.
class Row_lists
{
public:
  explicit Row_lists(const std::size_t number_of_lists) : m_head(number_of_lists, -1) { }

  void reserve(const std::size_t number_of_rows) { m_nodes.reserve(number_of_rows); }
  void add_list() { m_head.push_back(-1); }
  bool is_empty(const std::size_t list) const { return m_head[list] < 0; }

  void push(const std::size_t list, const Row_index row)
  {
    std::int32_t node = m_first_free;
    if(node < 0) {
      node = static_cast<std::int32_t>(m_nodes.size());
      m_nodes.push_back({row, m_head[list]});
    } else {
      m_first_free = m_nodes[std::size_t(node)].next;
      m_nodes[std::size_t(node)] = {row, m_head[list]};
    }
    m_head[list] = node;
  }

  // \pre !is_empty(list)
  Row_index pop(const std::size_t list)
  {
    const std::int32_t node = m_head[list];
    Node& popped = m_nodes[std::size_t(node)];
    m_head[list] = popped.next;
    popped.next = m_first_free;
    m_first_free = node;
    return popped.row;
  }

  // Calls f(row) for all rows of a list.
  template <typename Function>
  void for_rows(const std::size_t list, const Function& f) const
  {
    for(std::int32_t i = m_head[list]; i >= 0; i = m_nodes[std::size_t(i)].next)
      f(m_nodes[std::size_t(i)].row);
  }

private:
  struct Node { Row_index row; std::int32_t next; };
  std::vector<Node> m_nodes;
  std::vector<std::int32_t> m_head;
  std::int32_t m_first_free = -1;
};

// Rows keyed by length, shortest first. Entries are never removed: a row that changed its length or
// state since it was pushed is recognised by the caller when popped.
class Row_queue
{
public:
  Row_queue() : m_buckets(max_length + 1) { }

  void reserve(const std::size_t number_of_rows) { m_buckets.reserve(number_of_rows); }

  void push(const Row_index row, const std::size_t length)
  {
    const std::size_t bucket = (std::min)(length, std::size_t(max_length));
    m_buckets.push(bucket, row);
    m_first = (std::min)(m_first, bucket);
  }

  // Returns false if the queue is empty.
  bool pop(Row_index& row)
  {
    while(m_first <= max_length && m_buckets.is_empty(m_first))
      ++m_first;
    if(m_first > max_length)
      return false;
    row = m_buckets.pop(m_first);
    return true;
  }

private:
  static constexpr std::size_t max_length = 255; // longer rows share a bucket
  Row_lists m_buckets;
  std::size_t m_first = 0;
};

// For each column the rows that hold it: exact as a count, and as a list that also keeps rows which
// no longer do.
class Column_lists
{
public:
  explicit Column_lists(const std::size_t number_of_columns)
    : m_rows(number_of_columns), m_count(number_of_columns, 0)
  { }

  void reserve(const std::size_t number_of_entries) { m_rows.reserve(number_of_entries); }

  void add(const Column_index column, const Row_index row)
  {
    m_rows.push(std::size_t(column), row);
    ++m_count[std::size_t(column)];
  }

  // In no row.
  void add_column()
  {
    m_rows.add_list();
    m_count.push_back(0);
  }

  void remove_one(const Column_index column) { --m_count[std::size_t(column)]; }

  int count(const Column_index column) const { return m_count[std::size_t(column)]; }

  // Calls f(row) for the list of `column`.
  template <typename Function>
  void for_rows(const Column_index column, const Function& f) const
  { m_rows.for_rows(std::size_t(column), f); }

  // Moves the list of `column` to `rows`.
  void take(const Column_index column, std::vector<Row_index>& rows)
  {
    rows.clear();
    while(!m_rows.is_empty(std::size_t(column)))
      rows.push_back(m_rows.pop(std::size_t(column)));
  }

private:
  Row_lists m_rows;
  std::vector<int> m_count;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATION_QUEUES_H
