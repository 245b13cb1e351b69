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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HALF_PLANES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HALF_PLANES_H

#include <CGAL/license/Seamless_snapping.h>

// Small convex regions of displacements, as intersections of half planes: where to go to reach one.

#include <CGAL/Seamless_snapping/internal/surface/Exact_difference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The displacements d with normal . d >= bound. The normal has length 1.
struct Half_plane
{
  Uv normal;
  double bound;
};

inline double dot(const Uv& a, const Uv& b) { return a[0] * b[0] + a[1] * b[1]; }

// Intersections of half planes, up to rounding: what comes out of it is checked exactly afterwards.
class Half_planes
{
public:
  // \param is_fixed components of displacements that are 0
  explicit Half_planes(const std::array<bool, 2>& is_fixed) : m_is_fixed(is_fixed) { }

  // The displacements with gradient . d >= bound, for a gradient of any length.
  void add(Uv gradient, const double bound)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(m_is_fixed[c])
        gradient[c] = 0;
    const double length = std::sqrt(dot(gradient, gradient));
    if(length > 0)
      m_planes.push_back({{gradient[0] / length, gradient[1] / length}, bound / length});
    else
      m_is_empty = m_is_empty || bound > 0;
  }

  // The shortest displacement in the intersection: 0, on one line, or where two meet. Returns false if there
  // is none.
  bool find_shortest(Uv& shortest) const
  {
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Uv& d) {
      const double length = std::sqrt(dot(d, d));
      if(length < best && contains(d, length)) {
        best = length;
        shortest = d;
      }
    };
    consider({0, 0});
    for(std::size_t i = 0; i < m_planes.size() && best > 0; ++i) {
      const Half_plane& p = m_planes[i];
      consider({p.bound * p.normal[0], p.bound * p.normal[1]});
      for(std::size_t j = 0; j < i; ++j) {
        const Half_plane& q = m_planes[j];
        const double det = p.normal[0] * q.normal[1] - p.normal[1] * q.normal[0];
        if(std::abs(det) > 1e-14)
          consider({(p.bound * q.normal[1] - q.bound * p.normal[1]) / det,
                    (q.bound * p.normal[0] - p.bound * q.normal[0]) / det});
      }
    }
    return std::isfinite(best);
  }

private:
  bool contains(const Uv& d, const double length) const
  {
    return !m_is_empty && std::all_of(m_planes.begin(), m_planes.end(), [&](const Half_plane& p) {
      return dot(p.normal, d) >= p.bound - 1e-9 * (std::abs(p.bound) + length);
    });
  }

  std::array<bool, 2> m_is_fixed;
  std::vector<Half_plane> m_planes;
  bool m_is_empty = false;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_HALF_PLANES_H
