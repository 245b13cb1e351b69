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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_UV_MAP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_UV_MAP_H

#include <CGAL/license/Seamless_snapping.h>

// The uv map as it will be once the snapped coordinates are written: what further constraints are checked
// on before.

#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>

#include <cstddef>
#include <unordered_map>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap, typename Snapped>
class Snapped_uv_map
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  // \param is_needed if false, the map stays empty
  Snapped_uv_map(const HalfedgeUVMap& uv_map, const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                 const Snapped& snapped, const bool is_needed)
    : m_uv_map(uv_map), m_snapped(snapped)
  {
    for(std::size_t s = 0; is_needed && s < sectors.number_of_sectors(); ++s)
      for(auto h = sectors.corners_begin(Sector_index(s)); h != sectors.corners_end(Sector_index(s)); ++h)
        m_sector_of_corner[*h] = Sector_index(s);
  }

  friend Uv get_uv(const Snapped_uv_map& map, const Halfedge h)
  {
    const auto found = map.m_sector_of_corner.find(h);
    return found == map.m_sector_of_corner.end() ? get_uv(map.m_uv_map, h)
                                                 : map.m_snapped.uv(found->second);
  }

private:
  const HalfedgeUVMap& m_uv_map;
  const Snapped& m_snapped;
  std::unordered_map<Halfedge, Sector_index> m_sector_of_corner;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_UV_MAP_H
