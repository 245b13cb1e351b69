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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_H

#include <CGAL/license/Linear_snapping.h>

// Coordinates in the domain.

#include <array>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

using Uv = std::array<double, 2>;
using Uvw = std::array<double, 3>; // of volumes

// Of integer-grid maps. Below, the error of a coordinate computed on an edge stays under 1/4, and
// sums of coordinates and translations stay exact integers.
constexpr double largest_grid_coordinate = 70368744177664.; // 2^46

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_H
