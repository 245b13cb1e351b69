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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HEIGHT_WEIGHTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HEIGHT_WEIGHTS_H

#include <CGAL/license/Seamless_snapping.h>

// Weights for a target that spares slivers: sectors whose triangles are thin hold still, others give way.

#include <CGAL/Seamless_snapping/internal/surface/Watched_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// How far the first corner can move before the triangle turns; infinite if it isn't positive anyway.
inline double altitude(const Uv_triangle& t)
{
  const double ax = t[1][0] - t[0][0], ay = t[1][1] - t[0][1];
  const double bx = t[2][0] - t[0][0], by = t[2][1] - t[0][1];
  const double height = (ax * by - ay * bx) / std::hypot(bx - ax, by - ay);
  return height > 0 ? height : std::numeric_limits<double>::infinity();
}

// 1/h^2 for the least altitude h around a sector, in units of a safe one; at least 1, so that all sectors that
// are not in danger are alike.
// \param safe an altitude at which nothing is in danger
template <typename Sectors, typename HalfedgeUVMap>
std::vector<double> height_weights(const Sectors& sectors, const HalfedgeUVMap& uv_map, const double safe)
{
  constexpr double largest = 1e4; // ratio of altitudes; beyond, the target would lose precision
  std::vector<double> result;
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    double height = safe;
    for(auto h = sectors.corners_begin(Sector_index(i)); h != sectors.corners_end(Sector_index(i)); ++h)
      height = (std::min)(height, altitude(uv_triangle(sectors.mesh(), uv_map, *h)));
    const double ratio = (std::min)(safe / height, largest);
    result.push_back(ratio * ratio);
  }
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HEIGHT_WEIGHTS_H
