// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_POINTS_IN_TRIANGLE_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_POINTS_IN_TRIANGLE_H

#include <CGAL/license/Quad_remeshing.h>

// The points with integer coordinates inside of an edge and of a triangle. Where they are is
// computed in floating point, with a bound of the error; where that leaves a doubt, the exact
// orientation decides.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/orientation.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline bool is_integer(const double x) { return static_cast<double>(std::int64_t(x)) == x; }
inline bool is_integer(const Exact_difference& x)
{
  return x.error == 0 && x.rounded == std::round(x.rounded);
}
inline bool is_lattice_point(const Uv& u) { return is_integer(u[0]) && is_integer(u[1]); }

inline std::int64_t floor_integer(const double x)
{
  const std::int64_t i = std::int64_t(x);
  return i - std::int64_t(static_cast<double>(i) > x);
}
inline std::int64_t floor_integer(const Exact_difference& x)
{
  const std::int64_t i = floor_integer(x.rounded);
  return i - std::int64_t(x.error < 0 && static_cast<double>(i) == x.rounded);
}
inline std::int64_t ceil_integer(const double x) { return -floor_integer(-x); }

// Where the line through a and b, which differ in the component 1 - c, takes the value `level` in
// that component, between both: its component c up to `error`, which is at most 1/4.
struct Crossing
{
  double value, error;

  Crossing(const Uv& a, const Uv& b, const std::size_t c, const double level)
  {
    const double t = (level - a[1 - c]) / (b[1 - c] - a[1 - c]);
    value = a[c] + t * (b[c] - a[c]);
    error = std::ldexp(std::abs(a[c]) + std::abs(b[c]), -49);
  }

  bool may_be(const double integer) const { return std::abs(value - integer) <= error; }
};

// Calls f(p) for the lattice points inside of the edge ab.
template <typename Function>
void for_lattice_points_on_edge(const Uv& a, const Uv& b, const Function& f)
{
  // The lines of the grid that cross the edge, of the kind of which there are fewer.
  std::array<std::int64_t, 2> first, last;
  for(std::size_t c = 0; c < 2; ++c) {
    first[c] = floor_integer((std::min)(a[c], b[c])) + 1;
    last[c] = ceil_integer((std::max)(a[c], b[c])) - 1;
  }
  const bool is_on_line_0 = a[0] == b[0], is_on_line_1 = a[1] == b[1];
  if((is_on_line_0 && !is_integer(a[0])) || (is_on_line_1 && !is_integer(a[1])))
    return;
  const std::size_t c = (is_on_line_1 || (!is_on_line_0 && last[0] - first[0] < last[1] - first[1]))
                        ? 0 : 1;
  for(std::int64_t i = first[c]; i <= last[c]; ++i) {
    Uv p;
    p[c] = static_cast<double>(i);
    const Crossing crossing(a, b, 1 - c, p[c]);
    p[1 - c] = static_cast<double>(floor_integer(crossing.value + 0.5));
    if(crossing.may_be(p[1 - c]) &&
       (is_on_line_0 || is_on_line_1 || orientation({a, b, p}) == CGAL::COLLINEAR))
      f(p);
  }
}

// The first integer x with (x, y) at the left of the edge ab, which runs down (or, for mirrored
// coordinates, up), strictly. The edge meets the row y.
inline std::int64_t first_inside(const Uv& a, const Uv& b, const double y, const bool is_mirrored)
{
  const Crossing crossing(a, b, 0, y);
  const double value = is_mirrored ? -crossing.value : crossing.value;
  const std::int64_t nearest = floor_integer(value + 0.5);
  if(!crossing.may_be(static_cast<double>(is_mirrored ? -nearest : nearest)))
    return floor_integer(value) + 1;
  const Uv p{static_cast<double>(is_mirrored ? -nearest : nearest), y};
  return orientation({a, b, p}) == CGAL::LEFT_TURN ? nearest : nearest + 1;
}

// Calls f(p) for the lattice points inside of a triangle of positive orientation, row by row.
template <typename Function>
void for_lattice_points_inside(const Uv_triangle& t, const Function& f)
{
  const auto& [a, b, c] = t;
  const std::int64_t last = ceil_integer((std::max)({a[1], b[1], c[1]})) - 1;
  for(std::int64_t i = floor_integer((std::min)({a[1], b[1], c[1]})) + 1; i <= last; ++i) {
    const double y = static_cast<double>(i);
    std::int64_t begin = std::int64_t(-largest_grid_coordinate), end = -begin; // end: the last one
    for(std::size_t k = 0; k < 3; ++k) {
      const Uv &p = t[k], &q = t[(k + 1) % 3];
      if(p[1] > q[1] && p[1] >= y && y >= q[1])
        begin = (std::max)(begin, first_inside(p, q, y, false));
      else if(p[1] < q[1] && p[1] <= y && y <= q[1])
        end = (std::min)(end, -first_inside(p, q, y, true));
    }
    for(std::int64_t x = begin; x <= end; ++x)
      f(Uv{static_cast<double>(x), y});
  }
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_POINTS_IN_TRIANGLE_H
