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

#ifndef CGAL_SEAMLESS_SNAPPING_ISOCURVE_DIRECTION_H
#define CGAL_SEAMLESS_SNAPPING_ISOCURVE_DIRECTION_H

#include <CGAL/license/Seamless_snapping.h>

// The directions of isocurves, and what their points lie on.

#include <CGAL/Seamless_snapping/internal/tracing/axis_directions.h>

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingTracing

The directions of isocurves in a chart: along \f$ +u, +v, -u, -v \f$, and in the lattice
coordinates of `Rotational_symmetry` also along \f$ v - u \f$ and \f$ u - v \f$. There, `PLUS_U`,
`PLUS_V`, `MINUS_U_PLUS_V`, `MINUS_U`, `MINUS_V`, and `PLUS_U_MINUS_V` are 60 degrees apart, in this
order. In a face that is flipped in the domain a direction tells the sides: at the left of `PLUS_U`,
seen on the surface, \f$ v \f$ is larger.
*/
enum class Isocurve_direction
{
  PLUS_U,         ///< \f$ v \f$ is constant, \f$ u \f$ grows
  PLUS_V,         ///< \f$ u \f$ is constant, \f$ v \f$ grows
  MINUS_U,        ///< \f$ v \f$ is constant, \f$ u \f$ falls
  MINUS_V,        ///< \f$ u \f$ is constant, \f$ v \f$ falls
  MINUS_U_PLUS_V, ///< \f$ u + v \f$ is constant, \f$ u \f$ falls and \f$ v \f$ grows
  PLUS_U_MINUS_V  ///< \f$ u + v \f$ is constant, \f$ u \f$ grows and \f$ v \f$ falls
};

namespace internal {

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

/*!
\ingroup PkgSeamlessSnappingTracing
returns the opposite direction.
*/
inline Isocurve_direction reversed(const Isocurve_direction direction)
{
  const int i = int(direction);
  return Isocurve_direction(i < 4 ? (i + 2) % 4 : 9 - i);
}

/*!
\ingroup PkgSeamlessSnappingTracing
What a point of an isocurve lies on.
*/
enum class Isocurve_place
{
  VERTEX, ///< a vertex
  EDGE,   ///< the inside of an edge
  FACE    ///< the inside of a face
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_ISOCURVE_DIRECTION_H
