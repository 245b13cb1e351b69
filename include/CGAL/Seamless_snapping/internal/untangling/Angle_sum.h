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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_ANGLE_SUM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_ANGLE_SUM_H

#include <CGAL/license/Seamless_snapping.h>

// The angles around a vertex. Transitions tell their sum up to full turns only, so that repairs of
// flips can turn a cone of 450 degrees into one of 90, and another vertex into one of 720.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

constexpr double full_turn = 6.283185307179586; // in radians

// Invariant: the absolute sum is at least the signed one, and as large where nothing is folded.
class Angle_sum
{
public:
  // Adds the angle at the corner `k` of a triangle in Cartesian coordinates, or takes it away.
  void add(const Uv_triangle& t, const std::size_t k, const int sign = 1)
  {
    const Uv &p = t[k], &q = t[(k + 1) % 3], &r = t[(k + 2) % 3];
    const Uv a{{q[0] - p[0], q[1] - p[1]}}, b{{r[0] - p[0], r[1] - p[1]}};
    const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    m_signed += sign * angle;
    m_absolute += sign * std::abs(angle);
  }

  // What the sum is likely to be without folds: as the transitions say, and nearest to the sum of
  // what is there, as folds leave most of it in place.
  double without_folds() const
  {
    const double result = m_signed + full_turn * std::round((m_absolute - m_signed) / full_turn);
    return result > full_turn / 16 ? result : result + full_turn;
  }

  // Whether nothing is folded any more, and yet the sum is another one.
  bool is_wrong(const double wanted) const
  {
    return m_absolute - m_signed < full_turn / 1024 &&
           std::abs(m_signed - wanted) > full_turn / 2;
  }

private:
  double m_signed = 0, m_absolute = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_ANGLE_SUM_H
