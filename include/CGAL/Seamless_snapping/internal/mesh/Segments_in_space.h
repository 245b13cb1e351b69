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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SEGMENTS_IN_SPACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SEGMENTS_IN_SPACE_H

#include <CGAL/license/Seamless_snapping.h>

// Which of a set of segments have the same ends: the two sides of a seam that was cut open.

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename FT>
class Segments_in_space
{
public:
  using Point = std::array<FT, 3>;

  struct Segment
  {
    Point low, high;   // the ends in lexicographic order
    bool runs_upwards; // from `low` to `high`
    std::size_t index; // what the caller knows it by
  };

  // Segments of no length are left out: they coincide with all others at their point.
  void add(const Point& source, const Point& target, const std::size_t index)
  {
    if(source < target)
      m_segments.push_back(Segment{source, target, true, index});
    else if(target < source)
      m_segments.push_back(Segment{target, source, false, index});
  }

  // Calls `f(first, last)` for each set of two or more that coincide, upward segments last.
  template <typename F>
  void for_each_coincidence(const F& f)
  {
    std::sort(m_segments.begin(), m_segments.end(), [](const Segment& a, const Segment& b) {
      return std::tie(a.low, a.high, a.runs_upwards, a.index)
             < std::tie(b.low, b.high, b.runs_upwards, b.index);
    });
    for(auto first = m_segments.cbegin(); first != m_segments.cend(); ) {
      const auto last = std::find_if(first, m_segments.cend(), [first](const Segment& s) {
        return s.low != first->low || s.high != first->high;
      });
      if(last - first > 1)
        f(first, last);
      first = last;
    }
  }

private:
  std::vector<Segment> m_segments;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SEGMENTS_IN_SPACE_H
