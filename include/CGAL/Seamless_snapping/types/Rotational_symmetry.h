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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_ROTATIONAL_SYMMETRY_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_ROTATIONAL_SYMMETRY_H

#include <CGAL/license/Seamless_snapping.h>

// The symmetry of a parametrization.

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingSymmetry

The rotations of the transitions of a parametrization: multiples of \f$ 360 / N \f$ degrees. Objects
are values of the named parameter `rotational_symmetry`.

For \f$ N = 1, 2, 4 \f$ coordinates are Cartesian. For \f$ N = 3, 6 \f$ they are <em>lattice
coordinates</em>: \f$ (a, b) \f$ stands for the point \f$ a + b \omega \f$, where \f$ \omega \f$ is
the unit vector at 60 degrees. The rotations are then integer matrices: the rotation by 60 degrees
takes \f$ (a, b) \f$ to \f$ (-b, a + b) \f$. In Cartesian coordinates no such map can be exact,
because the image of \f$ (x, y) \ne 0 \f$ is
\f$ (x / 2 - \sqrt 3 y / 2, \sqrt 3 x / 2 + y / 2) \f$, and \f$ \sqrt 3 \f$ is irrational.

For \f$ N = 3, 6 \f$ isocurves run in three directions, along which \f$ a \f$, \f$ b \f$, or
\f$ a + b \f$ is constant. These are the components 0, 1, and 2 of constraints. Tolerances and
violations refer to the largest component. The changes in `Snapping_report` are changes of Cartesian
coordinates.

\tparam N 1, 2, 3, 4, or 6

\sa `convert_to_lattice_coordinates()`
*/
template <int N>
struct Rotational_symmetry
{
  static_assert(N == 1 || N == 2 || N == 3 || N == 4 || N == 6,
                "the order of a rotational symmetry is 1, 2, 3, 4, or 6");
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_ROTATIONAL_SYMMETRY_H
