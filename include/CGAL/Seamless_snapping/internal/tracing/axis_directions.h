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

// The four directions of isocurves in a chart, as numbers 0..3 for +u, +v, -u, -v: a transition by
// k quarter turns maps direction d to d + k.

#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline int turned(const int direction, const int quarter_turns)
{
  return (direction + quarter_turns) & (number_of_rotations - 1);
}

inline int reversed(const int direction) { return turned(direction, 2); }

// The component that is constant along isocurves of this direction.
inline std::size_t constant_component(const int direction)
{
  return std::size_t(1 - (direction & 1));
}


// The component that changes along them, and whether it grows or falls.
inline std::size_t running_component(const int direction) { return std::size_t(direction & 1); }
inline int running_sign(const int direction) { return direction < 2 ? 1 : -1; }

// The sign of the constant component, less its value on the curve, at the left of the curve.
inline int left_sign(const int direction) { return (direction == 0 || direction == 3) ? 1 : -1; }

// -1, 0, or 1; exact, as comparisons of floating point numbers are.
inline int compare(const double a, const double b) { return int(a > b) - int(a < b); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_AXIS_DIRECTIONS_H
