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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_HALF_PLANES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_HALF_PLANES_H

#include <CGAL/license/Seamless_snapping.h>

// Small convex regions of displacements, as intersections of half planes: where to go to reach one.

#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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
  // All displacements, or the multiples of one.
  Half_planes() = default;
  explicit Half_planes(const Uv& direction) : m_direction(direction) { }

  // The displacements with gradient . d >= bound, for a gradient of any length.
  void add(Uv gradient, const double bound)
  {
    if(m_direction) {
      const double along = dot(gradient, *m_direction) / dot(*m_direction, *m_direction);
      gradient = {{along * (*m_direction)[0], along * (*m_direction)[1]}};
    }
    const double length = std::sqrt(dot(gradient, gradient));
    if(length > 0)
      m_planes.push_back({{gradient[0] / length, gradient[1] / length}, bound / length});
    else
      m_is_empty = m_is_empty || bound > 0;
  }

  // The shortest displacement in the intersection. Returns false if there is none. Half planes come
  // in one after another: one that excludes the shortest so far has the next on its line.
  bool find_shortest(Uv& shortest) const
  {
    shortest = {{0, 0}};
    if(m_is_empty)
      return false;
    for(std::size_t i = 0; i < m_planes.size(); ++i)
      if(!contains(m_planes[i], shortest))
        shortest = shortest_on_line(i);
    return std::all_of(m_planes.begin(), m_planes.end(),
                       [&](const Half_plane& p) { return contains(p, shortest); });
  }

private:
  // The shortest displacement on the line of a half plane, within those before it: an interval.
  Uv shortest_on_line(const std::size_t i) const
  {
    const Half_plane& p = m_planes[i];
    const Uv direction{{-p.normal[1], p.normal[0]}};
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for(std::size_t j = 0; j < i; ++j) {
      const Half_plane& q = m_planes[j];
      const double slope = dot(q.normal, direction);
      const double bound = q.bound - p.bound * dot(q.normal, p.normal);
      if(slope > 1e-14)
        low = (std::max)(low, bound / slope);
      else if(slope < -1e-14)
        high = (std::min)(high, bound / slope);
    }
    const double along = (std::min)((std::max)(0., low), high);
    return {{p.bound * p.normal[0] + along * direction[0],
             p.bound * p.normal[1] + along * direction[1]}};
  }

  // Up to rounding.
  static bool contains(const Half_plane& p, const Uv& d)
  {
    return dot(p.normal, d) >= p.bound - 1e-9 * (std::abs(p.bound) + std::sqrt(dot(d, d)));
  }

  std::optional<Uv> m_direction;
  std::vector<Half_plane> m_planes;
  bool m_is_empty = false;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_HALF_PLANES_H
