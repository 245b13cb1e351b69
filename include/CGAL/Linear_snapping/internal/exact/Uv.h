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

// Coordinates in the domain, and the orientation of triangles there: its exact sign, and bounds for
// displacements that cannot change it.

#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/determinant.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

using Uv = std::array<double, 2>;
using Uvw = std::array<double, 3>; // a point in the domain of a volume

// The vector times a power of two, with a largest coordinate of 1 to 2, unless it is 0: products of
// such neither underflow nor overflow.
template <std::size_t size>
std::array<double, size> scaled_to_unit_size(std::array<double, size> v)
{
  double largest = 0;
  for(const double x : v)
    largest = (std::max)(largest, std::abs(x));
  if(largest > 0)
    for(double& x : v)
      x = std::ldexp(x, -std::ilogb(largest));
  return v;
}

// The vector between two points with three coordinates, as in space.
template <typename Number>
std::array<Number, 3> vector_to(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{ return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

template <typename Number>
Number inner_product(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{ return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

template <typename Number>
std::array<Number, 3> vector_product(const std::array<Number, 3>& a,
                                     const std::array<Number, 3>& b)
{ return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

// The bound for integer-grid maps. Below it, the error of a coordinate computed on an edge stays
// under 1/4, and sums of coordinates and translations stay exact integers.
constexpr double largest_grid_coordinate = 70368744177664.; // 2^46

using Uv_triangle = std::array<Uv, 3>;

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

// The sign of the area, without a look at the floating point number.
CGAL::Orientation exact_orientation(const Uv_triangle& t);

// The sign of the area, exactly.
inline CGAL::Orientation orientation(const Uv_triangle& t)
{
  if(is_surely_positive(t, 0))
    return CGAL::POSITIVE;
  if(is_surely_positive({{t[0], t[2], t[1]}}, 0))
    return CGAL::NEGATIVE;
  return exact_orientation(t);
}

using Uvw_tetrahedron = std::array<Uvw, 4>;

// Six times the volume, with its sign.
// \tparam Number an exact ring
template <typename Number>
Number exact_determinant(const Uvw_tetrahedron& t)
{
  std::array<std::array<Number, 3>, 3> e;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t c = 0; c < 3; ++c)
      e[i][c] = Number(t[i + 1][c]) - Number(t[0][c]);
  return CGAL::determinant<Number>(e[0][0], e[0][1], e[0][2], e[1][0], e[1][1], e[1][2], e[2][0],
                                   e[2][1], e[2][2]);
}

// The sign of the volume, exactly: positive where the first corner sees the others
// counterclockwise from inside, as in CGAL. The number type is the one that CGAL's predicates
// use if their intervals do not decide.
inline CGAL::Orientation orientation(const Uvw_tetrahedron& t)
{
  const std::array<Uvw, 3> a{
    {vector_to(t[0], t[1]), vector_to(t[0], t[2]), vector_to(t[0], t[3])}};
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
  return CGAL::sign(exact_determinant<CGAL::internal::Exact_ring_selector<double>::Type>(t));
}

// Whether faces are flipped because the whole map is mirrored: more than nine of ten faces. A map
// with half of its faces flipped can be repaired. Untangling would turn a mirrored map inside out.
inline bool mean_mirroring(const std::size_t number_of_flipped_faces, const std::size_t faces)
{ return 10 * number_of_flipped_faces > 9 * faces; }

constexpr const char* remedy_for_mirrored_maps =
  "the map is mirrored, because the faces turn clockwise: exchange the two coordinates of each "
  "corner";

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Linear_snapping/internal/exact/Uv_impl.h>
#endif

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_UV_H
