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
// origins.

#include <CGAL/Quad_remeshing/internal/quantization/Grid_vector.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

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
