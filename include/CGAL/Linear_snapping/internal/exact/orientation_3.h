// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ORIENTATION_3_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ORIENTATION_3_H

#include <CGAL/license/Linear_snapping.h>

// The orientation of tetrahedra in the domain: its exact sign.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

using Uvw_tetrahedron = std::array<Uvw, 4>;

// The sign of the volume, exactly: positive where the first corner sees the others
// counterclockwise from inside, as in CGAL. The number type is that of CGAL's own predicates where
// their intervals can't tell.
inline CGAL::Orientation orientation(const Uvw_tetrahedron& t)
{
  std::array<Uvw, 3> a; // edges from the first corner
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t c = 0; c < 3; ++c)
      a[i][c] = t[i + 1][c] - t[0][c];
  const auto det_2 = [&](const std::size_t c, const std::size_t d, const double sign) {
    return a[1][c] * a[2][d] + sign * (a[1][d] * a[2][c]);
  };
  const auto bound_2 = [&](const std::size_t c, const std::size_t d) {
    return std::abs(a[1][c] * a[2][d]) + std::abs(a[1][d] * a[2][c]);
  };
  const double det = a[0][0] * det_2(1, 2, -1) - a[0][1] * det_2(0, 2, -1) +
                     a[0][2] * det_2(0, 1, -1);
  // each term has three differences and at most five more operations, each with an error of 2^-53
  const double permanent = std::abs(a[0][0]) * bound_2(1, 2) + std::abs(a[0][1]) * bound_2(0, 2) +
                           std::abs(a[0][2]) * bound_2(0, 1);
  const double length = std::abs(a[0][0]) + std::abs(a[0][1]) + std::abs(a[0][2]);
  const double bound = 2e-15 * permanent + 1e-300 * (1 + length); // underflow, too
  if(std::isfinite(permanent) && std::abs(det) > bound)
    return det > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
  using Number = CGAL::internal::Exact_ring_selector<double>::Type;
  std::array<std::array<Number, 3>, 3> e;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t c = 0; c < 3; ++c)
      e[i][c] = Number(t[i + 1][c]) - Number(t[0][c]);
  return CGAL::sign_of_determinant<Number>(e[0][0], e[0][1], e[0][2], e[1][0], e[1][1], e[1][2],
                                           e[2][0], e[2][1], e[2][2]);
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_ORIENTATION_3_H
