// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRON_SHAPES_H
#define CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRON_SHAPES_H

#include <CGAL/license/Hexahedral_meshing.h>

// The result of `measure_hexahedra()`.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {

/*!
\ingroup PkgHexahedralMeshingRef

The result of `measure_hexahedra()`. The scaled Jacobian of a hexahedron is the least of nine
determinants of three unit vectors: along the edges at each of the eight corners, and along the
three axes. It is 1 for cubes and boxes.
*/
struct Hexahedron_shapes
{
  std::size_t number_of_hexahedra = 0; ///< the number of all hexahedra
  double least_scaled_jacobian = 1;    ///< the least of all hexahedra
  double mean_scaled_jacobian = 1;     ///< the arithmetic mean
  /// the number of hexahedra whose scaled Jacobian is between `i / 10` and `(i + 1) / 10`. The
  /// first number includes negative scaled Jacobians.
  std::array<std::size_t, 10> number_by_tenths{};
  /// hexahedra with a corner that is not positive: the determinant of its edges is zero or
  /// negative, exactly
  std::vector<std::size_t> nonpositive_hexahedra;
};

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRON_SHAPES_H
