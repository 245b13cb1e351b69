// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H

#include <CGAL/license/Quad_remeshing.h>

// A plane by which a surface is its own mirror image, and which plane that is for points.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the normal has the length 1. Where it is an axis, all is computed in its coordinate
// alone: images by the coordinate planes are exact.
class Mirror
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;

public:
  // The points where a x + b y + c z + d = 0. Those where it is positive are on the upper side.
  Mirror(const double a, const double b, const double c, const double d) : m_normal{a, b, c}
  {
    const double length = std::hypot(a, b, c);
    for(double& x : m_normal)
      x /= length;
    m_offset = -d / length;
  }

  bool is_valid() const { return std::isfinite(m_normal[0]) && std::isfinite(m_offset); }

  // In the same space, scaled by a power of two.
  Mirror scaled(const int exponent) const
  {
    Mirror result(*this);
    result.m_offset = std::ldexp(m_offset, exponent);
    return result;
  }

  // Positive on the upper side.
  double distance(const Point& p) const
  {
    const int axis = this->axis();
    if(axis >= 0)
      return m_normal[std::size_t(axis)] * p[axis] - m_offset;
    return m_normal[0] * p.x() + m_normal[1] * p.y() + m_normal[2] * p.z() - m_offset;
  }

  Point image(const Point& p) const { return moved(p, 2); }
  Point on_plane(const Point& p) const { return moved(p, 1); }

private:
  // Or a negative number.
  int axis() const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_normal[(i + 1) % 3] == 0 && m_normal[(i + 2) % 3] == 0)
        return int(i);
    return -1;
  }

  Point moved(const Point& p, const double times) const
  {
    std::array<double, 3> q{p.x(), p.y(), p.z()};
    const int axis = this->axis();
    if(axis >= 0) {
      const double at = m_normal[std::size_t(axis)] * m_offset;
      q[std::size_t(axis)] = times == 1 ? at : 2 * at - q[std::size_t(axis)];
    } else {
      const double distance = this->distance(p);
      for(std::size_t i = 0; i < 3; ++i)
        q[i] -= times * distance * m_normal[i];
    }
    return Point(q[0], q[1], q[2]);
  }

  std::array<double, 3> m_normal;
  double m_offset;
};

// Twice the coordinate of the plane across an axis by which the points are symmetric, if each has
// an image among them, exactly. It lies in the middle between the outermost points. Points that all
// lie on a plane are not taken for images of themselves.
inline std::optional<double>
find_doubled_offset(const std::vector<std::array<double, 3> >& sorted, const std::size_t axis)
{
  const auto [lowest, highest] =
    std::minmax_element(sorted.begin(), sorted.end(),
                        [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
  const Exact_difference sum((*highest)[axis], -(*lowest)[axis]);
  if(!sum.is_valid() || sum.error != 0 || (*lowest)[axis] == (*highest)[axis])
    return std::nullopt;
  std::vector<std::array<double, 3> > images(sorted);
  for(std::array<double, 3>& p : images) {
    const Exact_difference image(sum.rounded, p[axis]);
    if(image.error != 0)
      return std::nullopt;
    p[axis] = image.rounded;
  }
  std::sort(images.begin(), images.end());
  return images == sorted ? std::optional<double>(sum.rounded) : std::nullopt;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H
