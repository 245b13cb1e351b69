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

// Writes exact coordinates to the uv map, all or nothing: what a map had is written back if it
// throws, or does not keep what is written, which would void the verification.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline Refusal map_does_not_keep_coordinates()
{
  return {Outcome::INTERNAL_ERROR, "the uv map does not keep what is written to it, so that what "
          "it had was written back; each corner needs a place of its own, and the full precision "
          "of the points' number type"};
}

// Figures of the changes of all Cartesian coordinates.
class Corner_changes
{
public:
  // Each sector counts once; its corners, where they differed, share its weight.
  void add(const Uv& difference, const double weight = 1)
  {
    for(std::size_t c = 0; c < 2; ++c)
      m_changes.add(difference[c], weight);
  }

  // \param optimal_changes of which no exact solution can undercut the sum of squares
  void fill_in(Snapping_report& report, const Magnitudes& optimal_changes) const
  {
    report.largest_change = m_changes.largest();
    report.mean_change = m_changes.mean();
    report.rms_change = m_changes.root_mean_square();
    report.optimal_rms_change = optimal_changes.root(m_changes.sum_of_weights());
  }

private:
  Magnitudes m_changes;
};

// Writes, reads back, and takes back. `Stars` know the points that repairs of orientations have
// met: the sectors, and then vertices without a sector.
template <typename Group, typename Surface, typename Stars>
class Coordinate_writer
{
  using Halfedge = typename Surface::Halfedge;
  using Cuts = Surface_cuts<Group, Halfedge>;

public:
  Coordinate_writer(const Cuts& cuts, const Stars& stars, Surface& surface)
    : m_cuts(cuts), m_stars(stars), m_surface(surface)
  { }

  // Returns false if the map does not keep what is written to it. Then, and if the map throws, what
  // was read from it is written back.
  // \param uv per point
  bool write(const std::vector<Uv>& uv, Corner_changes& figures)
  {
    try {
      write_free_points(uv, figures);
      write_sectors(uv, figures);
      if(is_kept(uv))
        return true;
    } catch(...) { // by the map
      take_back();
      throw;
    }
    take_back();
    return false;
  }

private:
  static Uv change(const Uv& before, const Uv& after)
  {
    return Group::to_cartesian({after[0] - before[0], after[1] - before[1]});
  }

  // A zero that stays one keeps its sign.
  static Uv with_signs_of_zeros(Uv uv, const Uv& before)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(uv[c] == 0 && before[c] == 0)
        uv[c] = before[c];
    return uv;
  }

  void write_free_points(const std::vector<Uv>& uv, Corner_changes& figures)
  {
    for(std::size_t i = number_of_sectors(); i < uv.size(); ++i) {
      double count = 0;
      m_stars.for_each_corner(Sector_index(i), [&](const auto) { count += 1; });
      m_stars.for_each_corner(Sector_index(i), [&](const auto corner) {
        const Uv before = m_surface.uv(corner);
        if(before == uv[i])
          return;
        m_written_freely.push_back({corner, before});
        figures.add(change(before, uv[i]), 1 / count); // each vertex counts once
        m_surface.set_uv(corner, uv[i]);
      });
    }
  }

  void write_sectors(const std::vector<Uv>& new_uv, Corner_changes& figures)
  {
    for_each_sector([&](const Sector_index s, const Halfedge* first, const Halfedge* last) {
      const Uv& before = m_cuts.complex.coordinates[std::size_t(s)];
      const Uv uv = with_signs_of_zeros(new_uv[std::size_t(s)], before);
      if(is_mixed(s))
        for(auto h = first; h != last; ++h)
          figures.add(change(m_surface.uv(*h), uv), 1. / static_cast<double>(last - first));
      else
        figures.add(change(before, uv));
      if(must_remember(s))
        remember(first, last);
      m_end = s + 1;
      for(auto h = first; h != last; ++h)
        m_surface.set_uv(*h, uv);
    });
  }

  // To be looked at after all is written, since maps may share places.
  bool is_kept(const std::vector<Uv>& uv) const
  {
    bool result = true;
    for(std::size_t i = number_of_sectors(); i < uv.size(); ++i)
      m_stars.for_each_corner(Sector_index(i), [&](const auto corner) {
        result = result && m_surface.uv(corner) == uv[i];
      });
    for_each_sector([&](const Sector_index s, const Halfedge* first, const Halfedge* last) {
      for(auto h = first; h != last; ++h)
        result = result && m_surface.uv(*h) == uv[std::size_t(s)];
    });
    return result;
  }

  // The last first, so that places that several corners share get back what they had.
  void take_back()
  {
    while(m_end > 0) {
      const Sector_index s = --m_end;
      for(auto h = m_cuts.corners_end(s); h != m_cuts.corners_begin(s);) {
        m_surface.set_uv(*--h, must_remember(s) ? m_before.back()
                                                : m_cuts.complex.coordinates[std::size_t(s)]);
        if(must_remember(s))
          m_before.pop_back();
      }
    }
    for(; !m_written_freely.empty(); m_written_freely.pop_back())
      m_surface.set_uv(m_written_freely.back().corner, m_written_freely.back().before);
  }

  // All corners of a sector, or none if the map throws.
  void remember(const Halfedge* first, const Halfedge* last)
  {
    const std::ptrdiff_t size = std::ptrdiff_t(m_before.size());
    try {
      for(auto h = first; h != last; ++h)
        m_before.push_back(m_surface.uv(*h));
    } catch(...) {
      m_before.erase(m_before.begin() + size, m_before.end());
      throw;
    }
  }

  // Where a sector's coordinates are not those of each of its corners to the bit: zeros have signs.
  bool must_remember(const Sector_index s) const
  {
    const Uv& u = m_cuts.complex.coordinates[std::size_t(s)];
    return u[0] == 0 || u[1] == 0 || is_mixed(s);
  }

  bool is_mixed(const Sector_index s) const
  {
    return m_cuts.complex.find_mixed_sector(s) != nullptr;
  }

  std::size_t number_of_sectors() const { return m_cuts.complex.number_of_sectors(); }

  template <typename F>
  void for_each_sector(const F& f) const
  {
    constexpr std::ptrdiff_t lookahead = 32; // corners
    const Halfedge* const end = m_cuts.corners.data() + m_cuts.corners.size();
    for(std::size_t i = 0; i < number_of_sectors(); ++i) {
      const auto first = m_cuts.corners_begin(Sector_index(i));
      const auto last = m_cuts.corners_end(Sector_index(i));
      for(auto h = first; h != last; ++h)
        if(end - h > lookahead)
          m_surface.prefetch(h[lookahead]);
      f(Sector_index(i), first, last);
    }
  }

  struct Written { Halfedge corner; Uv before; };

  const Cuts& m_cuts;
  const Stars& m_stars;
  Surface& m_surface;
  std::vector<Uv> m_before; // of corners of the sectors to remember
  Sector_index m_end = 0;      // of the sectors that were written, perhaps in part
  std::vector<Written> m_written_freely; // of other corners
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_WRITE_COORDINATES_H
