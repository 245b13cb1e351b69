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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_WRITE_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_WRITE_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// Writes exact coordinates to the uv map, and measures by how much they change.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/write_all_or_nothing.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// `Stars` know the points that repairs of orientations have met: the sectors, and then vertices
// without a sector.
template <typename Group, typename Surface, typename Stars>
class Coordinate_writer
{
  using Halfedge = typename Surface::Halfedge;
  using Cuts = Surface_cuts<Group, Halfedge>;
  using Change = Corner_change<Halfedge, Uv>;

public:
  Coordinate_writer(const Cuts& cuts, const Stars& stars, Surface& surface)
    : m_cuts(cuts), m_stars(stars), m_surface(surface)
  { }

  // To be called once.
  // \param uv per point
  std::optional<Refusal> write(const std::vector<Uv>& uv)
  {
    for(std::size_t i = number_of_sectors(); i < uv.size(); ++i)
      collect_free_point(Sector_index(i), uv[i]);
    collect_sectors(uv);
    return write_all_or_nothing(
      m_changes.size(), [&](const std::size_t i) -> const Change& { return m_changes[i]; },
      [&](const Halfedge h) { return m_surface.uv(h); },
      [&](const Change& change, const Uv& to) { m_surface.set_uv(change.corner, to); });
  }

  // Of all Cartesian coordinates. Each sector, and each vertex without one, counts once; corners
  // that differ share its weight.
  const Magnitudes& changes() const { return m_magnitudes; }

private:
  // A zero that stays one keeps its sign.
  static Uv with_signs_of_zeros(Uv uv, const Uv& before)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(uv[c] == 0 && before[c] == 0)
        uv[c] = before[c];
    return uv;
  }

  void measure(const Uv& before, const Uv& after, const double weight)
  {
    for(const double x : Group::to_cartesian({after[0] - before[0], after[1] - before[1]}))
      m_magnitudes.add(x, weight);
  }

  void collect_free_point(const Sector_index p, const Uv& after)
  {
    double count = 0;
    m_stars.for_each_corner(p, [&](const auto) { count += 1; });
    m_stars.for_each_corner(p, [&](const auto corner) {
      const Uv before = m_surface.uv(corner);
      if(before == after)
        return;
      m_changes.push_back({corner, before, after});
      measure(before, after, 1 / count);
    });
  }

  void collect_sectors(const std::vector<Uv>& uv)
  {
    constexpr std::ptrdiff_t lookahead = 32; // corners
    const std::vector<Halfedge>& corners = m_cuts.corners.elements();
    const Halfedge* const end = corners.data() + corners.size();
    m_changes.reserve(m_changes.size() + corners.size());
    for(std::size_t i = 0; i < number_of_sectors(); ++i) {
      const Sector_index s = Sector_index(i);
      const Uv& before = m_cuts.complex.coordinates[i];
      const Uv after = with_signs_of_zeros(uv[i], before);
      const bool is_mixed = m_cuts.complex.find_mixed_sector(s) != nullptr;
      if(!is_mixed)
        measure(before, after, 1);
      const double weight = 1. / static_cast<double>(m_cuts.corners[s].size());
      for(const Halfedge& h : m_cuts.corners[s]) {
        if(end - &h > lookahead)
          m_surface.prefetch((&h)[lookahead]);
        m_changes.push_back({h, m_surface.uv(h), after});
        if(is_mixed)
          measure(m_changes.back().before, after, weight);
      }
    }
  }

  std::size_t number_of_sectors() const { return m_cuts.complex.number_of_sectors(); }

  const Cuts& m_cuts;
  const Stars& m_stars;
  Surface& m_surface;
  std::vector<Change> m_changes;
  Magnitudes m_magnitudes;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_WRITE_COORDINATES_H
