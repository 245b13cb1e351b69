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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_SHAPE_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_SHAPE_H

#include <CGAL/license/Quad_remeshing.h>

// The cells between the lines of the grid: squares, or the triangles of the lattice.

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// \tparam Group that of the directions of lines
template <typename Group>
struct Cell_shape
{
  static constexpr bool is_square = Group::is_signed_permutation;
  static constexpr int number_of_corners = is_square ? 4 : 3;
  static constexpr int cells_of_unit = is_square ? 1 : 2; // of area in the domain
  static constexpr int corners_of_unit = number_of_corners * cells_of_unit;

  // From the direction of a side to that of the next one.
  static constexpr int turns_at_corner = Group::order / number_of_corners;

  static const char* plural() { return is_square ? "quads" : "triangles"; }
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_SHAPE_H
