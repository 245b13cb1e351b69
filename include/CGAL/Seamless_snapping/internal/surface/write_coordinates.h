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

// Checks that the sectors' new coordinates satisfy all constraints exactly, and only then writes them to
// the uv map.

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
    if(!satisfies_transition(sides, transitions.edges[i].rotation))
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

// Reads back what it writes: a map that does not keep values would void the check. Returns false, with
// everything taken back, in such a case.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Snapped>
bool write_coordinates(const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors, const Snapped& snapped,
                       HalfedgeUVMap& uv_map, Change_statistics& statistics)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = typename Uv_number<HalfedgeUVMap>::type;
  const auto point = [](const Uv& uv) {
    return Point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]));
  };
  std::vector<Point> before; // of sectors whose corners differed
  bool kept = true;
  constexpr std::ptrdiff_t lookahead = 32; // corners
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector_index s = Sector_index(i);
    const Uv& uv = snapped.uv(s);
    const Point new_point = point(uv);
    const auto first = sectors.corners_begin(s), last = sectors.corners_end(s);
    if(sectors.sector(s).is_uniform())
      statistics.add(sectors.sector(s).uv, uv);
    for(auto h = first; h != last; ++h) {
      if(sectors.corners_end() - h > lookahead)
        prefetch(uv_map, h[lookahead]);
      if(!sectors.sector(s).is_uniform()) {
        statistics.add(get_uv(uv_map, *h), uv, 1. / static_cast<double>(last - first));
        before.push_back(get(uv_map, *h));
      }
      put(uv_map, *h, new_point);
      kept = kept && get_uv(uv_map, *h) == uv;
    }
  }
  auto old = before.begin();
  for(std::size_t i = 0; i < sectors.number_of_sectors() && !kept; ++i) {
    const Sector_index s = Sector_index(i);
    for(auto h = sectors.corners_begin(s); h != sectors.corners_end(s); ++h)
      put(uv_map, *h, sectors.sector(s).is_uniform() ? point(sectors.sector(s).uv) : *old++);
  }
  return kept;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H
