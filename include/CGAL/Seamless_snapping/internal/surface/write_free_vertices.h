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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_FREE_VERTICES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_FREE_VERTICES_H

#include <CGAL/license/Seamless_snapping.h>

// Writes the coordinates of vertices that no constraint concerns, where repairs of orientations moved them.

#include <CGAL/Seamless_snapping/internal/surface/Uv_points.h>
#include <CGAL/Seamless_snapping/internal/surface/write_coordinates.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// What `Sector_writer` is for sectors.
template <typename Points, typename HalfedgeUVMap>
class Free_vertex_writer
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = typename Uv_number<HalfedgeUVMap>::type;

public:
  Free_vertex_writer(const Points& points, HalfedgeUVMap& uv_map) : m_points(points), m_uv_map(uv_map) { }

  void write(const Uv_state& state, Change_statistics& statistics)
  {
    for(std::size_t i = m_points.sectors().number_of_sectors(); i < state.size(); ++i) {
      const Uv& uv = state[i];
      const Point point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]));
      double count = 0;
      m_points.for_each_corner(Point_index(i), [&](const auto) { count += 1; });
      m_points.for_each_corner(Point_index(i), [&](const auto corner) {
        const Uv before = get_uv(m_uv_map, corner);
        if(before == uv)
          return;
        m_written.push_back({corner, get(m_uv_map, corner)});
        statistics.add(before, uv, 1 / count); // each vertex counts once
        put(m_uv_map, corner, point);
      });
    }
  }

  bool is_kept(const Uv_state& state) const
  {
    bool result = true;
    for(std::size_t i = m_points.sectors().number_of_sectors(); i < state.size(); ++i)
      m_points.for_each_corner(Point_index(i), [&](const auto corner) {
        result = result && get_uv(m_uv_map, corner) == state[i];
      });
    return result;
  }

  void take_back()
  {
    for(; !m_written.empty(); m_written.pop_back())
      put(m_uv_map, m_written.back().corner, m_written.back().before);
  }

private:
  struct Written { typename Points::Halfedge corner; Point before; };

  const Points& m_points;
  HalfedgeUVMap& m_uv_map;
  std::vector<Written> m_written;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WRITE_FREE_VERTICES_H
