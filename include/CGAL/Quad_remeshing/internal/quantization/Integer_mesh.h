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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H

#include <CGAL/license/Quad_remeshing.h>

// A parametrized surface in integers: a vector along each halfedge, in the chart of its face, and
// the rotation of the transition across each edge. Translations are gone, and with them the charts'
// origins. Sums of vectors throw where they don't fit, and signs of products are exact.

#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Grid_vector = std::array<std::int64_t, 2>;

inline Grid_vector negated(const Grid_vector& a) { return {-a[0], -a[1]}; }

inline Grid_vector multiplied(const std::int64_t factor, const Grid_vector& a)
{ return {checked_product(factor, a[0]), checked_product(factor, a[1])}; }

inline Grid_vector sum(const Grid_vector& a, const Grid_vector& b)
{
  return {checked_difference(a[0], -b[0]), checked_difference(a[1], -b[1])};
}

using Linear_snapping::internal::difference; // and of vectors:

inline Grid_vector difference(const Grid_vector& a, const Grid_vector& b)
{
  return {checked_difference(a[0], b[0]), checked_difference(a[1], b[1])};
}

inline Grid_vector rotated(const Quarter_turns::Element g, const Grid_vector& a)
{
  return Quarter_turns::apply(g, a);
}

// The unit vector in one of the four directions.
inline Grid_vector unit_vector(const int direction)
{
  return rotated(Quarter_turns::element(direction), Grid_vector{1, 0});
}

// a x b where the result fits; throws where it doesn't.
inline std::int64_t cross_product(const Grid_vector& a, const Grid_vector& b)
{
  return checked_difference(checked_product(a[0], b[1]), checked_product(a[1], b[0]));
}

inline BOOST_NOINLINE Exact_integer exact_cross(const Grid_vector& a, const Grid_vector& b)
{
  const auto exact = [](const std::int64_t x) { return from_64_bits<Exact_integer>(x); };
  return difference(product(exact(a[0]), exact(b[1])), product(exact(a[1]), exact(b[0])));
}

// The sign of a x b. Each product has a relative error of at most 4 roundings.
inline int cross_sign(const Grid_vector& a, const Grid_vector& b)
{
  const double p = static_cast<double>(a[0]) * static_cast<double>(b[1]);
  const double q = static_cast<double>(a[1]) * static_cast<double>(b[0]);
  if(std::abs(p - q) > 1e-15 * (std::abs(p) + std::abs(q)))
    return p > q ? 1 : -1;
  return p == 0 && q == 0 ? 0 : int(CGAL::sign(exact_cross(a, b)));
}

// Of two vectors on a line through 0: whether they point to opposite sides.
inline bool are_opposite(const Grid_vector& a, const Grid_vector& b)
{
  const std::size_t c = a[0] != 0 ? 0 : 1;
  return cross_sign(a, b) == 0 && (a[c] > 0) != (b[c] > 0) && b[c] != 0;
}

// The quadrant that contains the vector, which is not null, each with the axis at its clockwise
// end.
inline int quadrant(const Grid_vector& a)
{
  if(a[0] > 0 && a[1] >= 0)
    return 0;
  if(a[0] <= 0 && a[1] > 0)
    return 1;
  return a[0] < 0 && a[1] <= 0 ? 2 : 3;
}

// By how many axes a vector passes that turns from `first` to `last`, counterclockwise, by less
// than 180 degrees.
inline int axes_between(const Grid_vector& first, const Grid_vector& last)
{
  return Quarter_turns::turns(Quarter_turns::element(quadrant(last) - quadrant(first)));
}

inline double dot(const Grid_vector& a, const Grid_vector& b)
{
  return static_cast<double>(a[0]) * static_cast<double>(b[0]) +
         static_cast<double>(a[1]) * static_cast<double>(b[1]);
}

inline double approximate_cross(const Grid_vector& a, const Grid_vector& b)
{
  return static_cast<double>(a[0]) * static_cast<double>(b[1]) -
         static_cast<double>(a[1]) * static_cast<double>(b[0]);
}

inline double length(const Grid_vector& a)
{
  return std::hypot(static_cast<double>(a[0]), static_cast<double>(a[1]));
}

struct Integer_corner : Flat_corner
{
  Integer_corner() : Flat_corner{no_index, no_index} { }

  Grid_vector vector{};  // from the source of the halfedge to its target
  Quarter_turns::Element rotation = Quarter_turns::identity(); // to the chart of the opposite face
  bool is_wall = false; // on the border, or a feature: it lies on an isocurve, and stays there
};

// Invariant: the vectors of each face add up to 0 and turn left, those of an edge's two sides are
// opposite up to the rotation, and one coordinate of each wall is 0.
struct Integer_mesh : Flat_mesh<Integer_corner>
{
  std::vector<double> steps;      // per connected part: the length of one unit in the domain
  std::vector<std::int32_t> part; // per face
};

// The corner of a vertex that contains a direction, and the direction in the chart of its face.
struct Direction_at_corner
{
  Corner_index corner = no_index;
  Quarter_turns::Element turns = Quarter_turns::identity(); // to the chart of that corner's face
};

// Turns on, counterclockwise, until `vector` lies before the last edge of the corner. It must lie
// less than 180 degrees behind the first edge of `at.corner`. `turned` carries whatever belongs to
// the chart along.
template <typename Turn>
void turn_to(const Integer_mesh& mesh, Corner_index& corner, Grid_vector& vector,
             const Turn& turned)
{
  while(cross_sign(negated(mesh.corner(corner).vector), vector) >= 0 &&
        mesh.opposite(corner) != no_index) {
    const Quarter_turns::Element rotation = mesh.corner(corner).rotation;
    vector = rotated(rotation, vector);
    turned(rotation);
    corner = mesh.counterclockwise(corner);
  }
}

// Whether `b` lies less than 180 degrees counterclockwise of `a`, or in the same direction.
inline bool is_counterclockwise(const Grid_vector& a, const Grid_vector& b)
{
  const int sign = cross_sign(a, b);
  return sign > 0 || (sign == 0 && !are_opposite(a, b));
}

// The direction of `vector`, counterclockwise of that of `from`, which is known, by less than a
// whole turn.
inline Direction_at_corner find_direction(const Integer_mesh& mesh, Direction_at_corner known,
                                          Grid_vector from, const Grid_vector& vector)
{
  const auto turn = [&](const Grid_vector& direction) {
    Grid_vector here = rotated(known.turns, direction);
    turn_to(mesh, known.corner, here, [&](const Quarter_turns::Element rotation)
            { known.turns = Quarter_turns::compose(rotation, known.turns); });
  };
  while(!is_counterclockwise(from, vector)) {
    from = rotated(Quarter_turns::element(1), from);
    turn(from);
  }
  turn(vector);
  return known;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H
