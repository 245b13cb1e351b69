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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_HEXAHEDRON_SHAPE_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_HEXAHEDRON_SHAPE_H

#include <CGAL/license/Hexahedral_meshing.h>

// The shape of a hexahedron: its corners as tetrahedra.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedron.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

using Hexahedron_points = std::array<Uvw, 8>;

// The points of a hexahedron, among points whose coordinates convert to `double`.
template <typename PointRange, typename Hexahedron_indices>
Hexahedron_points points_of(const PointRange& points, const Hexahedron_indices& indices)
{
  Hexahedron_points result;
  std::size_t k = 0;
  for(const auto i : indices) {
    const auto& p = *(std::begin(points) + static_cast<std::ptrdiff_t>(i));
    result[k++] = {static_cast<double>(p[0]), static_cast<double>(p[1]),
                   static_cast<double>(p[2])};
  }
  return result;
}

// Corner k with the ends of its edges, in a right-handed order: a positive tetrahedron in a cube.
template <typename T>
std::array<T, 4> tetrahedron_of_corner(const std::array<T, 8>& h, const std::size_t k)
{
  const std::size_t first = is_left_handed(k) ? 1 : 0;
  return {h[k], h[k ^ step_along[first]], h[k ^ step_along[1 - first]], h[k ^ step_along[2]]};
}

// A bit for each corner that is positive, exactly.
inline unsigned int positive_corners(const Hexahedron_points& p)
{
  unsigned int result = 0;
  for(std::size_t k = 0; k < 8; ++k)
    if(orientation(tetrahedron_of_corner(p, k)) == CGAL::POSITIVE)
      result |= 1u << k;
  return result;
}

inline bool is_positive(const Hexahedron_points& p) { return positive_corners(p) == 0xff; }

// The determinant of three vectors, made unit ones; 0 if one has no length.
inline double scaled_determinant(const Uvw& a, const Uvw& b, const Uvw& c)
{
  const double lengths = std::sqrt(inner_product(a, a)) * std::sqrt(inner_product(b, b)) *
                         std::sqrt(inner_product(c, c));
  return lengths > 0 ? inner_product(a, vector_product(b, c)) / lengths : 0;
}

inline double scaled_jacobian(const Hexahedron_points& p)
{
  std::array<Uvw, 3> axes{};
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(std::size_t k = 0; k < 8; ++k)
      for(std::size_t c = 0; c < 3; ++c)
        axes[axis][c] += coordinate_of_corner(k, axis) != 0 ? p[k][c] : -p[k][c];
  double result = scaled_determinant(axes[0], axes[1], axes[2]);
  for(std::size_t k = 0; k < 8; ++k) {
    const std::array<Uvw, 4> t = tetrahedron_of_corner(p, k);
    result = (std::min)(result, scaled_determinant(vector_to(t[0], t[1]), vector_to(t[0], t[2]),
                                                   vector_to(t[0], t[3])));
  }
  return result;
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_HEXAHEDRON_SHAPE_H
