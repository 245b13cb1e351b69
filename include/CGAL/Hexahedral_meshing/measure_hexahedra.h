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

#ifndef CGAL_HEXAHEDRAL_MESHING_MEASURE_HEXAHEDRA_H
#define CGAL_HEXAHEDRAL_MESHING_MEASURE_HEXAHEDRA_H

#include <CGAL/license/Hexahedral_meshing.h>

// The shapes of hexahedra in space.

#include <CGAL/Hexahedral_meshing/internal/shape/hexahedron_shape.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedron_shapes.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Hexahedral_meshing {

/*!
\ingroup PkgHexahedralMeshingRef

measures the shapes of the hexahedra of any mesh. The function decides exactly whether corners are
positive.

\tparam PointRange a random access range of three-dimensional points, whose coordinates `p[0]`,
        `p[1]`, and `p[2]` convert to `double`
\tparam HexahedronRange a range of ranges of eight indices

\param points the points
\param hexahedra the hexahedra: indices of eight points each, in the order of `extract_hexahedra()`

\return the least and the mean scaled Jacobian, counts, and the hexahedra that are not positive

\pre all points exist, and are finite

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of hexahedra.
*/
template <typename PointRange, typename HexahedronRange>
Hexahedron_shapes measure_hexahedra(const PointRange& points, const HexahedronRange& hexahedra)
{
  const internal::Require_exact_arithmetic protect;
  Hexahedron_shapes result;
  double sum = 0;
  for(const auto& hexahedron : hexahedra) {
    const internal::Hexahedron_points p = internal::points_of(points, hexahedron);
    const double shape = internal::scaled_jacobian(p);
    sum += shape;
    result.least_scaled_jacobian = (std::min)(result.least_scaled_jacobian, shape);
    ++result.number_by_tenths[std::size_t((std::min)((std::max)(10 * shape, 0.), 9.))];
    if(!internal::is_positive(p))
      result.nonpositive_hexahedra.push_back(result.number_of_hexahedra);
    ++result.number_of_hexahedra;
  }
  if(result.number_of_hexahedra > 0)
    result.mean_scaled_jacobian = sum / double(result.number_of_hexahedra);
  return result;
}

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_MEASURE_HEXAHEDRA_H
