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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_AXIS_DIRECTIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_AXIS_DIRECTIONS_H

#include <CGAL/license/Seamless_snapping.h>

// The four directions of isocurves in a chart, as the rotations that turn +u into +u, +v, -u, -v.

#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Direction = Quarter_turns::Element;

// In the chart behind a transition.
inline Direction turned(const Direction direction, const Quarter_turns::Element g)
{
  return Quarter_turns::compose(g, direction);
}

inline Direction reversed(const Direction direction)
{
  return turned(direction, Quarter_turns::element(Quarter_turns::order / 2));
}

// What a direction is made of: it runs along a coordinate axis, and another one points to its left.
struct Axes
{
  std::size_t running, constant; // coordinates
  int running_sign, left_sign;
};

constexpr Axes axes_of_direction(const Direction direction)
{
  const auto& m = Quarter_turns::matrix(direction); // its columns: along the curve, and to the left
  return {std::size_t(m[0][0] == 0), std::size_t(m[0][0] != 0), m[0][0] + m[1][0],
          m[0][1] + m[1][1]};
}

inline const Axes& axes(const Direction direction)
{
  static constexpr Axes table[Quarter_turns::order] = {
    axes_of_direction(Quarter_turns::element(0)), axes_of_direction(Quarter_turns::element(1)),
    axes_of_direction(Quarter_turns::element(2)), axes_of_direction(Quarter_turns::element(3))};
  return table[direction];
}

// The coordinate that is constant along isocurves of this direction.
inline std::size_t constant_component(const Direction d) { return axes(d).constant; }

// The coordinate that changes along them, and whether it grows or falls.
inline std::size_t running_component(const Direction d) { return axes(d).running; }
inline int running_sign(const Direction d) { return axes(d).running_sign; }

// The sign of the constant coordinate, less its value on the curve, at the left of the curve.
inline int left_sign(const Direction d) { return axes(d).left_sign; }

// -1, 0, or 1; exact, as comparisons of floating point numbers are.
inline int compare(const double a, const double b) { return int(a > b) - int(a < b); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_AXIS_DIRECTIONS_H
