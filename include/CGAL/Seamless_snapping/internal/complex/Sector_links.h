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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SECTOR_LINKS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SECTOR_LINKS_H

#include <CGAL/license/Seamless_snapping.h>

// Which sectors the pairs of a complex link, and which functionals its chains fix, seen from each
// sector.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
class Sector_links
{
public:
  // u(sector) = element u(here) + t, for some translation.
  struct Link
  {
    Sector_index sector;
    typename Group::Element element;
  };

  explicit Sector_links(const Cut_complex<Group>& complex)
    : m_first_link(complex.number_of_sectors() + 1, 0), m_links(2 * complex.pairs.size()),
      m_first_functional(complex.number_of_sectors() + 1, 0), m_functionals(complex.links.size())
  {
    for(const auto& pair : complex.pairs) {
      ++m_first_link[std::size_t(pair.plus) + 1];
      ++m_first_link[std::size_t(pair.minus) + 1];
    }
    for(const Sector_index s : complex.links)
      ++m_first_functional[std::size_t(s) + 1];
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s) {
      m_first_link[s + 1] += m_first_link[s];
      m_first_functional[s + 1] += m_first_functional[s];
    }
    Offsets next_link(m_first_link), next_functional(m_first_functional);
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
      for(auto p = complex.pairs_begin(b); p != complex.pairs_end(b); ++p) {
        const auto g = complex.element[b];
        m_links[next_link[std::size_t(p->plus)]++] = {p->minus, g};
        m_links[next_link[std::size_t(p->minus)]++] = {p->plus, Group::inverse(g)};
      }
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      for(auto s = complex.links_begin(c); s != complex.links_end(c); ++s)
        m_functionals[next_functional[std::size_t(*s)]++] = complex.functional[c];
    for(const auto& path : complex.paths) {
      m_pinned.push_back(path.a);
      m_pinned.push_back(path.b);
    }
    for(const auto& equation : complex.equations)
      for(const auto& term : equation.terms)
        m_pinned.push_back(term.sector);
    std::sort(m_pinned.begin(), m_pinned.end());
  }

  const Link* begin(const Sector_index s) const
  { return m_links.data() + m_first_link[std::size_t(s)]; }
  const Link* end(const Sector_index s) const
  { return m_links.data() + m_first_link[std::size_t(s) + 1]; }

  const int* functionals_begin(const Sector_index s) const
  { return m_functionals.data() + m_first_functional[std::size_t(s)]; }
  const int* functionals_end(const Sector_index s) const
  { return m_functionals.data() + m_first_functional[std::size_t(s) + 1]; }

  // Whether the sector is in a further constraint.
  bool is_pinned(const Sector_index s) const
  { return std::binary_search(m_pinned.begin(), m_pinned.end(), s); }

private:
  Offsets m_first_link;
  std::vector<Link> m_links;
  Offsets m_first_functional;
  std::vector<int> m_functionals;
  std::vector<Sector_index> m_pinned;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SECTOR_LINKS_H
