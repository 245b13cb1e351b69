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

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

using Hexahedron_points = std::array<Uvw, 8>;

// A corner with the ends of its edges, in a right-handed order: a positive tetrahedron in a cube.
constexpr int tetrahedron_of_corner[8][4] = {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6},
                                             {3, 0, 2, 7}, {4, 7, 5, 0}, {5, 4, 6, 1},
                                             {6, 5, 7, 2}, {7, 6, 4, 3}};

// A bit for each corner that is positive, exactly.
inline unsigned int positive_corners(const Hexahedron_points& p)
{
  unsigned int result = 0;
  for(std::size_t k = 0; k < 8; ++k) {
    const auto& t = tetrahedron_of_corner[k];
    if(orientation({{p[std::size_t(t[0])], p[std::size_t(t[1])], p[std::size_t(t[2])],
                     p[std::size_t(t[3])]}}) == CGAL::POSITIVE)
      result |= 1u << k;
  }
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
  for(std::size_t c = 0; c < 3; ++c) {
    axes[0][c] = p[1][c] + p[2][c] + p[5][c] + p[6][c] - p[0][c] - p[3][c] - p[4][c] - p[7][c];
    axes[1][c] = p[2][c] + p[3][c] + p[6][c] + p[7][c] - p[0][c] - p[1][c] - p[4][c] - p[5][c];
    axes[2][c] = p[4][c] + p[5][c] + p[6][c] + p[7][c] - p[0][c] - p[1][c] - p[2][c] - p[3][c];
  }
  double result = scaled_determinant(axes[0], axes[1], axes[2]);
  for(const auto& t : tetrahedron_of_corner) {
    const Uvw& at = p[std::size_t(t[0])];
    result = (std::min)(result, scaled_determinant(vector_to(at, p[std::size_t(t[1])]),
                                                   vector_to(at, p[std::size_t(t[2])]),
                                                   vector_to(at, p[std::size_t(t[3])])));
  }
  return result;
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_HEXAHEDRON_SHAPE_H
