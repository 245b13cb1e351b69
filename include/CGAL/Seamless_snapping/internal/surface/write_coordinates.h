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

// Writes the sectors' coordinates to the uv map, checks there that all constraints hold exactly, and takes
// everything back if not. The check uses the transitions and the mesh alone, nothing of how the values
// were found.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/surface/Align_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Eq. (4) across cut edges; the same coordinates on both sides of edges that were merged, and all over
// each sector; Eq. (5) along aligned edges. No other edge was open, nor has changed.
template <typename TriangleMesh, typename HalfedgeUVMap>
bool all_constraints_hold(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                          const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                          const Transition_data<TriangleMesh>& transitions,
                          const Align_edges<TriangleMesh>& align_edges)
{
  for(const auto& edge : transitions.edges) {
    const Edge_sides sides = edge_sides(tmesh, uv_map, edge.halfedge);
    if(edge.is_cut ? !satisfies_transition(sides, edge.rotation) : !sides.are_identical())
      return false;
  }
  for(std::size_t s = 0; s < sectors.number_of_sectors(); ++s) {
    const auto first = sectors.corners_begin(Sector_index(s));
    for(auto h = first; h != sectors.corners_end(Sector_index(s)); ++h)
      if(get_uv(uv_map, *h) != get_uv(uv_map, *first))
        return false;
  }
  for(std::size_t a = 0; a < align_edges.size(); ++a) {
    const std::size_t c = std::size_t(align_edges.component(Edge_index(a)));
    const auto h = align_edges.halfedge(Edge_index(a));
    if(get_uv(uv_map, h)[c] != get_uv(uv_map, prev(h, tmesh))[c])
      return false;
  }
  return true;
}

// Figures of the changes of all corners of sectors.
class Change_statistics
{
public:
  explicit Change_statistics(const double unit) : m_unit(unit) { } // keeps squares in range

  void add(const Uv& before, const Uv& after, const std::size_t number_of_corners)
  {
    const double count = static_cast<double>(number_of_corners);
    for(std::size_t c = 0; c < 2; ++c) {
      const double change = std::abs(after[c] - before[c]) / m_unit;
      m_largest = (std::max)(m_largest, change);
      m_sum += count * change;
      m_squares += count * change * change;
      m_count += number_of_corners;
    }
  }

  void fill_in(Snapping_report& report) const
  {
    if(m_count == 0)
      return;
    const double count = static_cast<double>(m_count);
    report.largest_change = m_largest * m_unit;
    report.mean_change = m_sum / count * m_unit;
    report.rms_change = std::sqrt(m_squares / count) * m_unit;
  }

private:
  double m_unit;
  double m_largest = 0, m_sum = 0, m_squares = 0;
  std::size_t m_count = 0;
};

// Returns false, and leaves the map as it was, if the new values violate a constraint.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Snapped>
bool write_and_verify(const TriangleMesh& tmesh, HalfedgeUVMap& uv_map,
                      const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                      const Transition_data<TriangleMesh>& transitions,
                      const Align_edges<TriangleMesh>& align_edges, const Snapped& snapped,
                      Change_statistics& statistics)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = typename Uv_number<HalfedgeUVMap>::type;
  std::vector<Point> before; // of sectors whose corners differed
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector_index s = Sector_index(i);
    const Uv& uv = snapped.uv(s);
    const Point point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]));
    const auto first = sectors.corners_begin(s), last = sectors.corners_end(s);
    if(sectors.sector(s).is_uniform)
      statistics.add(sectors.sector(s).uv, uv, std::size_t(last - first));
    for(auto h = first; h != last; ++h) {
      if(!sectors.sector(s).is_uniform) {
        statistics.add(get_uv(uv_map, *h), uv, 1);
        before.push_back(get(uv_map, *h));
      }
      put(uv_map, *h, point);
    }
  }
  if(all_constraints_hold(tmesh, uv_map, sectors, transitions, align_edges))
    return true;

  auto old = before.begin();
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector& sector = sectors.sector(Sector_index(i));
    const Point uniform(static_cast<Number>(sector.uv[0]), static_cast<Number>(sector.uv[1]));
    for(auto h = sectors.corners_begin(Sector_index(i)); h != sectors.corners_end(Sector_index(i)); ++h)
      put(uv_map, *h, sector.is_uniform ? uniform : *old++);
  }
  return false;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H
