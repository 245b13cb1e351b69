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
  // side ends soon, and there is none. Through the border, there is one side only.
  bool find(const Strip_state start, const double bound, const bool from_both_sides = true)
  {
    m_is_double = from_both_sides && m_rules.across(start) != no_strip_state;
    auto& [there, back] = m_searches;
    there.clear(start, bound);
    back.clear(m_is_double ? m_rules.reversed(start) : start, bound);
    there.start(m_is_double ? &back : nullptr);
    if(m_is_double)
      back.start(&there);
    for(;;) {
      Strip_search& narrower = m_is_double && back.width() < there.width() ? back : there;
      m_found = back.length() < there.length() ? 1 : 0;
      if(narrower.width() == 0 ||
         there.distance() + (m_is_double ? back.distance() : 0.) >= length())
        return is_found();
      narrower.advance();
    }
  }

  bool is_found() const { return m_searches[m_found].has_closed(); }
  bool is_from_both_sides() const { return m_is_double; }

  // Of the strip that was found: the sum of the other costs.
  double length() const { return m_searches[m_found].length(); }

  // As in Strip_search, for the strip that was found.
  template <typename Visit>
  void for_each_face(const Visit& visit) const
  {
    const Strip_state end = m_searches[m_found].end();
    m_searches[m_found].for_each_face(end, visit);
    if(m_is_double)
      m_searches[1 - m_found].for_each_face(m_rules.reversed(end), visit);
  }

private:
  const Strip_rules& m_rules;
  std::array<Strip_search, 2> m_searches;
  std::size_t m_found = 0; // the search that closed the strip
  bool m_is_double = false;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_FINDER_H
