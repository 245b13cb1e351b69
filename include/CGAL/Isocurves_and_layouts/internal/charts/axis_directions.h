// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_AXIS_DIRECTIONS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_AXIS_DIRECTIONS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The directions of isocurves in a chart, as the rotations that turn +u into them: +u, +v, -u, -v
// in Cartesian coordinates; +u, +v, v - u, -u, -v, u - v in lattice coordinates, 60 degrees apart.
//
// The group of the directions has the order 4 for N = 1, 2, 4, and the order 6 for N = 3, 6: all
// templates on it are compiled for these two groups only.

#include <CGAL/Isocurves_and_layouts/internal/packages_below.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// An element of either group.
using Direction = int;

// In the chart behind a transition.
template <typename Group = Quarter_turns>
Direction turned(const Direction direction, const typename Group::Element g)
{
  return Group::compose(g, direction);
}

template <typename Group = Quarter_turns>
Direction reversed(const Direction direction)
{
  return turned<Group>(direction, Group::element(Group::order / 2));
}

// The parts of a direction: one component runs along it, another one is constant and grows or
// falls to its left. Components are the functionals of the group: u, v, and u + v for N = 6, where
// +v has u + v as its running one. So a transition takes each of both to that behind it.
struct Axes
{
  std::size_t running, constant; // components
  int running_sign, left_sign;
};

template <typename Group>
constexpr Axes axes_of_direction(const Direction direction)
{
  const Signed_functional along = Group::act(direction, 0), left = Group::act(direction, 1);
  return {std::size_t(along.index), std::size_t(left.index), along.sign, left.sign};
}

template <typename Group>
struct Axes_table
{
  Axes of_direction[Group::order];

  static constexpr Axes_table make()
  {
    Axes_table result{};
    for(int d = 0; d < Group::order; ++d)
      result.of_direction[d] = axes_of_direction<Group>(d);
    return result;
  }
};

template <typename Group = Quarter_turns>
const Axes& axes(const Direction direction)
{
  static constexpr Axes_table<Group> table = Axes_table<Group>::make();
  return table.of_direction[direction];
}

// The component that is constant along isocurves of this direction.
template <typename Group = Quarter_turns>
std::size_t constant_component(const Direction d) { return axes<Group>(d).constant; }

// The component that changes along them, and whether it grows or falls.
template <typename Group = Quarter_turns>
std::size_t running_component(const Direction d) { return axes<Group>(d).running; }
template <typename Group = Quarter_turns>
int running_sign(const Direction d) { return axes<Group>(d).running_sign; }

// The sign of the constant component, less its value on the curve, at the left of the curve.
template <typename Group = Quarter_turns>
int left_sign(const Direction d) { return axes<Group>(d).left_sign; }

// -1, 0, or 1; exact, as comparisons of floating point numbers are.
inline int compare(const double a, const double b) { return int(a > b) - int(a < b); }

// Rounding to the nearest number does not change the order.
inline int compare(const Exact_difference& a, const Exact_difference& b)
{
  const int rounded = compare(a.rounded, b.rounded);
  return rounded != 0 ? rounded : compare(a.error, b.error);
}

// A component of a point, exactly: u + v may need two numbers.
template <typename Group>
using Component = std::conditional_t<Group::is_signed_permutation, double, Exact_difference>;

template <typename Group>
Component<Group> component(const Uv& u, const std::size_t c)
{
  if constexpr(Group::is_signed_permutation)
    return u[c];
  else
    return c < 2 ? Exact_difference(u[c], 0) : Exact_difference(u[0], -u[1]);
}

inline double nearest_double(const double x) { return x; }
inline double nearest_double(const Exact_difference& x) { return x.rounded; }

// The order of the enumeration starts with the four of Cartesian coordinates.
template <typename Group>
Isocurve_direction isocurve_direction(const Direction d)
{
  if constexpr(Group::order == 4)
    return Isocurve_direction(d);
  else
    return Isocurve_direction(d < 2 ? d : d == 2 ? 4 : d < 5 ? d - 1 : 5);
}

template <typename Group>
Direction chart_direction(const Isocurve_direction direction)
{
  const int i = int(direction);
  CGAL_precondition_msg(i < Group::order, "this direction exists in lattice coordinates only");
  if constexpr(Group::order == 4)
    return i;
  else
    return i < 2 ? i : i == 4 ? 2 : i < 4 ? i + 1 : 5;
}

// The component that is constant: u, v, or u + v.
inline std::size_t constant_component(const Isocurve_direction direction)
{
  return int(direction) < 4 ? std::size_t(1 - int(direction) % 2) : 2;
}

// A coordinate that is not.
inline std::size_t other_coordinate(const Isocurve_direction direction)
{
  return constant_component(direction) == 1 ? 0 : 1;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_AXIS_DIRECTIONS_H
