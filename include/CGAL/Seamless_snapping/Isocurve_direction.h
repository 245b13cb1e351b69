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

#ifndef CGAL_SEAMLESS_SNAPPING_ISOCURVE_DIRECTION_H
#define CGAL_SEAMLESS_SNAPPING_ISOCURVE_DIRECTION_H

#include <CGAL/license/Seamless_snapping.h>

// The directions of isocurves, and what their points lie on.

#include <CGAL/Seamless_snapping/internal/tracing/axis_directions.h>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingTracing

The directions of isocurves in a chart: along \f$ +u, +v, -u, -v \f$. In a face that is flipped in
the domain a direction tells the sides: at the left of `PLUS_U`, seen on the surface, \f$ v \f$ is
larger.
*/
enum class Isocurve_direction
{
  PLUS_U,  ///< \f$ v \f$ is constant, \f$ u \f$ grows
  PLUS_V,  ///< \f$ u \f$ is constant, \f$ v \f$ grows
  MINUS_U, ///< \f$ v \f$ is constant, \f$ u \f$ falls
  MINUS_V  ///< \f$ u \f$ is constant, \f$ v \f$ falls
};

/*!
\ingroup PkgSeamlessSnappingTracing
returns the opposite direction.
*/
inline Isocurve_direction reversed(const Isocurve_direction direction)
{
  return Isocurve_direction(internal::reversed(int(direction)));
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
