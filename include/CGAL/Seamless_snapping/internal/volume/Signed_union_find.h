// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SIGNED_UNION_FIND_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SIGNED_UNION_FIND_H

#include <CGAL/license/Seamless_snapping.h>

// Classes of elements that are equal up to a sign.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Each element is its class' root, times a sign. Where an element is found to be both the root and
// its negative, its class is marked: numbers are zero then.
class Signed_union_find
{
public:
  struct Signed_element
  {
    std::size_t index;
    int sign;
  };

  explicit Signed_union_find(const std::size_t size)
    : m_parent(size), m_sign(size, 1), m_is_zero(size, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::int32_t(0));
  }

  Signed_element find(const std::size_t i)
  {
    Signed_element root{i, 1};
    for(; std::size_t(m_parent[root.index]) != root.index;
        root.index = std::size_t(m_parent[root.index]))
      root.sign *= m_sign[root.index];
    int sign = root.sign; // i against the root
    for(std::size_t j = i; j != root.index;) { // shortens the paths
      const std::size_t next = std::size_t(m_parent[j]);
      const int next_sign = sign * m_sign[j];
      m_parent[j] = std::int32_t(root.index);
      m_sign[j] = static_cast<signed char>(sign);
      j = next;
      sign = next_sign;
    }
    return root;
  }

  std::size_t root(const std::size_t i) { return find(i).index; }

  // a = sign b
  void unite(const std::size_t a, const std::size_t b, const int sign = 1)
  {
    Signed_element x = find(a), y = find(b);
    const int between = x.sign * sign * y.sign;
    if(x.index == y.index) {
      if(between < 0)
        m_is_zero[x.index] = 1;
      return;
    }
    if(y.index < x.index) // the least is the root, so that classes have an order
      std::swap(x, y);
    m_parent[y.index] = std::int32_t(x.index);
    m_sign[y.index] = static_cast<signed char>(between);
    if(m_is_zero[y.index] != 0)
      m_is_zero[x.index] = 1;
  }

  void set_zero(const std::size_t i) { m_is_zero[root(i)] = 1; }
  bool is_zero(const std::size_t i) { return m_is_zero[root(i)] != 0; }
  std::size_t size() const { return m_parent.size(); }

  // Numbers the classes, in the order of their first elements. Returns how many there are.
  std::size_t number(std::vector<std::int32_t>& class_of_element)
  {
    std::int32_t result = 0;
    class_of_element.resize(size());
    for(std::size_t i = 0; i < size(); ++i)
      class_of_element[i] = root(i) == i ? result++ : class_of_element[root(i)];
    return std::size_t(result);
  }

private:
  std::vector<std::int32_t> m_parent;
  std::vector<signed char> m_sign; // against the parent
  std::vector<char> m_is_zero;     // per root
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SIGNED_UNION_FIND_H
