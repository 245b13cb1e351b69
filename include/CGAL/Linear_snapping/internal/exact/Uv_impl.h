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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_IMPL_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_IMPL_H

#include <CGAL/license/Linear_snapping.h>

// The orientation of triangles in the domain if floating point numbers do not tell it.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>

#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/sign_of_determinant.h>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The number type is the one that CGAL's predicates use if their intervals do not decide; CGAL's
// kernel would take longer to compile than all else here.
CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
CGAL::Orientation exact_orientation(const Uv_triangle& t)
{
  using Number = CGAL::internal::Exact_ring_selector<double>::Type;
  const Number x(t[0][0]), y(t[0][1]);
  return CGAL::sign_of_determinant<Number>(Number(t[1][0]) - x, Number(t[1][1]) - y,
                                           Number(t[2][0]) - x, Number(t[2][1]) - y);
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_IMPL_H
