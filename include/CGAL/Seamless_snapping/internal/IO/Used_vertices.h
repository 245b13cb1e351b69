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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_USED_VERTICES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_USED_VERTICES_H

#include <CGAL/license/Seamless_snapping.h>

// Consecutive numbers for the vertices that faces use. One index of the caller may be so large that
// no array can be as long.

#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: vertices are numbered in the order of their names, which are the caller's indices.
class Used_vertices
{
public:
  static constexpr Soup_index none = static_cast<Soup_index>(-1);

  // \param corners the names of the vertices of all corners
  explicit Used_vertices(std::vector<std::size_t> corners)
  {
    const std::size_t end =
      corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()) + 1;
    if(end > 4 * corners.size()) { // an array of numbers would be longer than this one
      std::sort(corners.begin(), corners.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      m_names.swap(corners);
      return;
    }
    m_numbers.assign(end, none);
    for(const std::size_t name : corners)
      m_numbers[name] = 0;
    for(std::size_t name = 0; name < end; ++name)
      if(m_numbers[name] != none) {
        m_numbers[name] = Soup_index(m_names.size());
        m_names.push_back(name);
      }
  }

  const std::vector<std::size_t>& names() const { return m_names; } // per number

  // The number of a vertex; `none` if no corner has that name.
  Soup_index number(const std::size_t name) const
  {
    if(!m_numbers.empty())
      return name < m_numbers.size() ? m_numbers[name] : none;
    const auto found = std::lower_bound(m_names.begin(), m_names.end(), name);
    return found != m_names.end() && *found == name ? Soup_index(found - m_names.begin()) : none;
  }

private:
  std::vector<std::size_t> m_names;
  std::vector<Soup_index> m_numbers; // per name; empty if names are much larger than numbers
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_USED_VERTICES_H
