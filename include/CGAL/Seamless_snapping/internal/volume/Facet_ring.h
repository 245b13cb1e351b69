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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FACET_RING_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FACET_RING_H

#include <CGAL/license/Seamless_snapping.h>

// The facets around an edge of a flat volume.

#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Walks around an edge, from facet to facet. Invariant: `facet()` contains the edge, as the cell
// sees it that was entered.
class Facet_ring
{
public:
  // Begins inside the cell of `facet`, at the edge that the facet has opposite to its corner
  // `third`; the walk goes through that cell first.
  Facet_ring(const Flat_volume& volume, const Corner_index facet, const Corner_index third)
    : m_volume(volume), m_start(facet), m_start_other(volume.opposite[std::size_t(facet)]),
      m_facet(facet), m_third(third)
  { }

  // Goes to the other facet of the cell; that is seen from the same cell.
  void turn()
  {
    // the facet opposite to `third` contains the edge and the corner opposite to the former facet
    const Corner_index former = m_facet;
    m_facet = m_third;
    m_third = former;
  }

  // Whether there is a cell on the other side, and it is known.
  bool can_cross() const { return m_volume.opposite[std::size_t(m_facet)] >= 0; }

  // Enters the cell on the other side.
  void cross()
  {
    const Corner_index third = m_volume.across(m_facet, m_third);
    m_facet = m_volume.opposite[std::size_t(m_facet)];
    m_third = third;
  }

  Corner_index facet() const { return m_facet; }
  Corner_index third() const { return m_third; } // of the facet: the corner opposite to the edge
  bool is_closed() const { return m_facet == m_start || m_facet == m_start_other; }

private:
  const Flat_volume& m_volume;
  Corner_index m_start, m_start_other, m_facet, m_third;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FACET_RING_H
