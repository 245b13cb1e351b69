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

// Eq. (4) for cut edges, and the same coordinates on both sides of all others.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
bool edge_holds(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                const Transition_data<TriangleMesh>& transitions, const Halfedge h)
{
  if(CGAL::is_border_edge(h, tmesh))
    return true;
  const Edge_index i = transitions.index(h);
  if(i < 0 || !transitions.edges[std::size_t(i)].is_cut)
    return edge_sides(tmesh, uv_map, h).are_identical();
  const Open_edge<Halfedge>& edge = transitions.edges[std::size_t(i)];
  return satisfies_transition(edge_sides(tmesh, uv_map, edge.halfedge), edge.rotation);
}

// All edges that the sectors' corners touch; the others were not open and have not changed.
template <typename TriangleMesh, typename HalfedgeUVMap>
bool all_constraints_hold(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                          const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                          const Transition_data<TriangleMesh>& transitions,
                          const Align_edges<TriangleMesh>& align_edges)
{
  for(std::size_t s = 0; s < sectors.number_of_sectors(); ++s)
    for(auto h = sectors.corners_begin(Sector_index(s)); h != sectors.corners_end(Sector_index(s)); ++h)
      if(!edge_holds(tmesh, uv_map, transitions, *h))
        return false;
  for(std::size_t a = 0; a < align_edges.halfedges().size(); ++a) {
    const std::size_t c = std::size_t(align_edges.component(Edge_index(a)));
    const auto h = align_edges.halfedges()[a];
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

  void add(const double before, const double after)
  {
    const double change = std::abs(after - before) / m_unit;
    m_largest = (std::max)(m_largest, change);
    m_sum += change;
    m_squares += change * change;
    ++m_count;
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
  std::vector<Point> before;
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector_index s = Sector_index(i);
    const Uv& uv = snapped.uv(s);
    const Point point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]));
    for(auto h = sectors.corners_begin(s); h != sectors.corners_end(s); ++h) {
      before.push_back(get(uv_map, *h));
      const Uv old = get_uv(uv_map, *h);
      for(std::size_t c = 0; c < 2; ++c)
        statistics.add(old[c], uv[c]);
      put(uv_map, *h, point);
    }
  }
  if(all_constraints_hold(tmesh, uv_map, sectors, transitions, align_edges))
    return true;
  auto old = before.begin();
  for(std::size_t s = 0; s < sectors.number_of_sectors(); ++s)
    for(auto h = sectors.corners_begin(Sector_index(s)); h != sectors.corners_end(Sector_index(s)); ++h)
      put(uv_map, *h, *old++);
  return false;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_COORDINATES_H
