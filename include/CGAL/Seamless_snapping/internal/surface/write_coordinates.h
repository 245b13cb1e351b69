// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// Checks that the sectors' new coordinates satisfy all constraints exactly; and writes them to the uv
// map, or takes them back if the map doesn't keep them, which would void the check.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/prefetch.h>
#include <CGAL/Seamless_snapping/internal/surface/Align_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Eq. (4) across cut edges, Eq. (5) along aligned ones. Across all other edges, corners belong to one
// sector. The check knows the values as they will be written, and nothing of how they were found.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Snapped>
bool all_constraints_hold(const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                          const Transition_data<TriangleMesh>& transitions,
                          const Align_edges<TriangleMesh>& align_edges, const Snapped& snapped)
{
  for(std::size_t i = 0; i < transitions.number_of_cuts; ++i) {
    const Directed_cut d = 2 * Directed_cut(i);
    const Edge_sides sides{snapped.uv(sectors.source_sector(d)), snapped.uv(sectors.target_sector(d)),
                           snapped.uv(sectors.target_sector(opposite_cut(d))),
                           snapped.uv(sectors.source_sector(opposite_cut(d)))};
    if(!satisfies_transition<Quarter_turns>(sides, transitions.edges[i].rotation))
      return false;
  }
  for(std::size_t a = 0; a < align_edges.size(); ++a) {
    const std::size_t c = std::size_t(align_edges.component(Edge_index(a)));
    if(snapped.uv(sectors.align_source_sector(Edge_index(a)))[c] !=
       snapped.uv(sectors.align_target_sector(Edge_index(a)))[c])
      return false;
  }
  return true;
}

// Figures of the changes of all corners of sectors.
class Change_statistics
{
public:
  explicit Change_statistics(const double unit) : m_unit(unit) { } // keeps squares in range

  // Each sector counts once; its corners, where they differed, share its weight.
  void add(const Uv& before, const Uv& after, const double weight = 1)
  {
    for(std::size_t c = 0; c < 2; ++c) {
      const double change = std::abs(after[c] - before[c]) / m_unit;
      m_largest = (std::max)(m_largest, change);
      m_sum += weight * change;
      m_squares += weight * change * change;
      m_count += weight;
    }
  }

  // \param optimal_squares the sum of the squared changes that no exact solution can undercut, in units
  void fill_in(Snapping_report& report, const double optimal_squares) const
  {
    if(m_count == 0)
      return;
    report.largest_change = m_largest * m_unit;
    report.mean_change = m_sum / m_count * m_unit;
    report.rms_change = std::sqrt(m_squares / m_count) * m_unit;
    report.optimal_rms_change = std::sqrt(optimal_squares / m_count) * m_unit;
  }

private:
  double m_unit;
  double m_largest = 0, m_sum = 0, m_squares = 0, m_count = 0;
};

// Writes the coordinates of sectors to their corners.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Sector_writer
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Halfedge = typename Sectors::Halfedge;
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = typename Uv_number<HalfedgeUVMap>::type;

public:
  Sector_writer(const Sectors& sectors, HalfedgeUVMap& uv_map)
    : m_sectors(sectors), m_uv_map(uv_map)
  { }

  template <typename Snapped>
  void write(const Snapped& snapped, Change_statistics& statistics)
  {
    for_each_sector([&](const Sector_index s, const Halfedge* first, const Halfedge* last) {
      const Uv uv = with_signs_of_zeros(snapped.uv(s), m_sectors.sector(s).uv);
      if(m_sectors.sector(s).is_uniform())
        statistics.add(m_sectors.sector(s).uv, uv);
      else
        for(auto h = first; h != last; ++h)
          statistics.add(get_uv(m_uv_map, *h), uv, 1. / static_cast<double>(last - first));
      if(must_remember(s))
        remember(first, last);
      m_end = s + 1;
      for(auto h = first; h != last; ++h)
        put(m_uv_map, *h, point(uv));
    });
  }

  // Whether the map has kept what was written; call it after all is, since maps may share places.
  template <typename Snapped>
  bool is_kept(const Snapped& snapped) const
  {
    bool result = true;
    for_each_sector([&](const Sector_index s, const Halfedge* first, const Halfedge* last) {
      const Uv& uv = snapped.uv(s);
      for(auto h = first; h != last; ++h)
        result = result && get_uv(m_uv_map, *h) == uv;
    });
    return result;
  }

  // The last first, so that places that several corners share get back what they had.
  void take_back()
  {
    while(m_end > 0) {
      const Sector_index s = --m_end;
      for(auto h = m_sectors.corners_end(s); h != m_sectors.corners_begin(s);) {
        put(m_uv_map, *--h, must_remember(s) ? m_before.back() : point(m_sectors.sector(s).uv));
        if(must_remember(s))
          m_before.pop_back();
      }
    }
  }

private:
  static Point point(const Uv& uv)
  {
    return Point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]));
  }

  // A zero that stays one keeps its sign.
  static Uv with_signs_of_zeros(Uv uv, const Uv& before)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(uv[c] == 0 && before[c] == 0)
        uv[c] = before[c];
    return uv;
  }

  // All corners of a sector, or none if the map throws.
  void remember(const Halfedge* first, const Halfedge* last)
  {
    const std::ptrdiff_t size = std::ptrdiff_t(m_before.size());
    try {
      for(auto h = first; h != last; ++h)
        m_before.push_back(get(m_uv_map, *h));
    } catch(...) {
      m_before.erase(m_before.begin() + size, m_before.end());
      throw;
    }
  }

  // Where a sector's coordinates are not those of each of its corners to the bit: zeros have signs.
  bool must_remember(const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    return !sector.is_uniform() || sector.uv[0] == 0 || sector.uv[1] == 0;
  }

  template <typename F>
  void for_each_sector(const F& f) const
  {
    constexpr std::ptrdiff_t lookahead = 32; // corners
    for(std::size_t i = 0; i < m_sectors.number_of_sectors(); ++i) {
      const auto first = m_sectors.corners_begin(Sector_index(i)),
                 last = m_sectors.corners_end(Sector_index(i));
      for(auto h = first; h != last; ++h)
        if(m_sectors.corners_end() - h > lookahead)
          prefetch(m_uv_map, h[lookahead]);
      f(Sector_index(i), first, last);
    }
  }

  const Sectors& m_sectors;
  HalfedgeUVMap& m_uv_map;
  std::vector<Point> m_before; // of corners of the sectors to remember
  Sector_index m_end = 0;      // of the sectors that were written, perhaps in part
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H
