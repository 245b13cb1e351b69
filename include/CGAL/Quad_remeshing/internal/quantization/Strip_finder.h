// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_FINDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_FINDER_H

#include <CGAL/license/Quad_remeshing.h>

// The cheapest strip through an edge, by two searches, one from each of its sides, that meet.

#include <CGAL/Quad_remeshing/internal/quantization/Strip_search.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Strip_finder
{
public:
  // \param rules have to outlive it
  explicit Strip_finder(const Strip_rules& rules)
    : m_rules(rules), m_searches{Strip_search(rules), Strip_search(rules)}
  { }

  // The cheapest strip through the state whose other costs add up to less than `bound`, gains not
  // counted. The search goes on where fewer ways are open: where triangles can't get smaller, one
  // side ends soon, and there is none. A search from one side finds strips that close inside only.
  bool find(const Strip_state start, const double bound, const bool from_both_sides = true)
  {
    auto& [there, back] = m_searches;
    there.clear(start, bound);
    back.clear(m_rules.reversed(start), bound);
    there.start(m_rules.across(start), from_both_sides ? &back : nullptr);
    if(from_both_sides)
      back.start(with_opposite_change(start), &there);
    for(;;) {
      m_found = back.length() < there.length() ? 1 : 0;
      const double least = from_both_sides ? least_length() : there.distance();
      if(least >= length())
        return is_found();
      const bool is_back_narrower = there.width() == 0 || back.width() < there.width();
      (is_back_narrower && back.width() > 0 ? back : there).advance();
      ++m_number_of_steps;
    }
  }

  // Of all searches.
  std::size_t number_of_steps() const { return m_number_of_steps; }

  bool is_found() const { return m_searches[m_found].has_closed(); }

  // Of the strip that was found: the sum of the other costs.
  double length() const { return m_searches[m_found].length(); }

  // As in Strip_search, for the strip that was found.
  template <typename Visit>
  void for_each_face(const Visit& visit) const
  {
    const Strip_search& found = m_searches[m_found];
    found.for_each_face(found.end(), visit);
    if(found.end_of_other() != no_strip_state)
      m_searches[1 - m_found].for_each_face(found.end_of_other(), visit);
  }

private:
  // Of strips that are not found yet: of two ways that go on, or one that does, and the border.
  double least_length() const
  {
    const auto& [there, back] = m_searches;
    return (std::min)((std::min)(there.distance(), there.distance_of_border()) + back.distance(),
                      there.distance() + back.distance_of_border());
  }

  const Strip_rules& m_rules;
  std::array<Strip_search, 2> m_searches;
  std::size_t m_found = 0; // the search that closed the strip
  std::size_t m_number_of_steps = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_FINDER_H
