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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_LISTS_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_LISTS_H

#include <CGAL/license/Linear_snapping.h>

// Many short lists in one array, such as the rows of a matrix or the buckets of a counting sort.

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Lists of elements, one behind the other in one array.
template <typename T>
class Lists
{
public:
  using List = boost::iterator_range<const T*>;

  Lists() : m_begin(1, 0) { }

  // Sorts by counting.
  // \param for_each(add) calls add(i, x) for each element x of each list i, elements of a list in
  //        their order; it is called twice
  template <typename ForEach>
  Lists(const std::size_t number_of_lists, const ForEach& for_each)
    : m_begin(number_of_lists + 1, 0)
  {
    for_each([&](const auto i, const T&) { ++m_begin[std::size_t(i) + 1]; });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_elements.resize(m_begin.back());
    std::vector<std::size_t> end(m_begin); // behind the elements that a list has so far
    for_each([&](const auto i, const T& x) { m_elements[end[std::size_t(i)]++] = x; });
  }

  void reserve(const std::size_t number_of_lists, const std::size_t number_of_elements)
  {
    m_begin.reserve(number_of_lists + 1);
    m_elements.reserve(number_of_elements);
  }

  // Adds to the list that `end_list()` ends.
  void push_back(const T& x) { m_elements.push_back(x); }

  template <typename Range>
  void append(const Range& range)
  { m_elements.insert(m_elements.end(), range.begin(), range.end()); }

  void end_list() { m_begin.push_back(m_elements.size()); }

  template <typename IsBefore>
  void sort_each(const IsBefore& is_before)
  {
    for(std::size_t i = 0; i < size(); ++i)
      std::sort(m_elements.begin() + std::ptrdiff_t(m_begin[i]),
                m_elements.begin() + std::ptrdiff_t(m_begin[i + 1]), is_before);
  }

  std::size_t size() const { return m_begin.size() - 1; }
  const std::vector<T>& elements() const { return m_elements; }

  template <typename Index>
  List operator[](const Index i) const
  {
    return {m_elements.data() + m_begin[std::size_t(i)],
            m_elements.data() + m_begin[std::size_t(i) + 1]};
  }

  friend bool operator<(const Lists& a, const Lists& b)
  { return std::tie(a.m_begin, a.m_elements) < std::tie(b.m_begin, b.m_elements); }

private:
  std::vector<std::size_t> m_begin; // per list, and the number of elements
  std::vector<T> m_elements;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_LISTS_H
