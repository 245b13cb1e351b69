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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ORIENTATION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ORIENTATION_H

#include <CGAL/license/Seamless_snapping.h>

// The orientation of triangles in the domain: its exact sign, and bounds on what displacements can
// do to it.

#include <CGAL/Seamless_snapping/internal/exact/Uv.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Uv_triangle = std::array<Uv, 3>;

// The sign of the area, exactly.
inline CGAL::Orientation orientation(const Uv_triangle& t)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  return Kernel().orientation_2_object()(Point(t[0][0], t[0][1]), Point(t[1][0], t[1][1]),
                                         Point(t[2][0], t[2][1]));
}

// Whether the triangle stays positive however its corners move, each coordinate by up to `reach`.
// May say no for lack of precision, but never wrongly yes: the error of the determinant is below
// 1e-15 times the product of the edges, and overflow and underflow end in comparisons that fail.
inline bool is_surely_positive(const Uv_triangle& t, const double reach)
{
  const double ax = t[1][0] - t[0][0], ay = t[1][1] - t[0][1];
  const double bx = t[2][0] - t[0][0], by = t[2][1] - t[0][1];
  const double a = std::abs(ax) + std::abs(ay), b = std::abs(bx) + std::abs(by);
  return ax * by - ay * bx >
         2.001 * reach * (a + b) + 8.01 * reach * reach + 1e-15 * a * b + 1e-300;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ORIENTATION_H
