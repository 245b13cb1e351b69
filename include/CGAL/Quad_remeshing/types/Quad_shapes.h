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

#ifndef CGAL_QUAD_REMESHING_TYPES_QUAD_SHAPES_H
#define CGAL_QUAD_REMESHING_TYPES_QUAD_SHAPES_H

#include <CGAL/license/Quad_remeshing.h>

// How well quads are shaped.

#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingRemeshing

The shapes of quads, in floating point. `measure_quad_shapes()` returns this.
*/
struct Quad_shapes
{
  /// The least scaled Jacobian of a quad: the least sine of its angles, times the cosine between
  /// the normals of the corner and of the quad, which is perpendicular to both diagonals. 1 is
  /// best.
  double least_scaled_jacobian = 1;
  double mean_scaled_jacobian = 1; ///< the mean over the quads
  /// the largest ratio of the longest and the shortest side of a quad; infinite if a side has no
  /// length
  double largest_aspect_ratio = 1;
  /// quads whose longest side is more than ten times their shortest side
  std::size_t number_of_long_quads = 0;
  /// quads with a scaled Jacobian of less than 0.1, including inverted quads and quads with three
  /// corners on a line
  std::size_t number_of_thin_quads = 0;
  /// the first of these quads, at most ten, counted from 0 in the order of iteration over all faces
  std::vector<std::size_t> first_thin_quads;
  /// quads that are degenerate for most uses: the longest side is more than 100 times the shortest
  /// side, or a side is shorter than a millionth of the mean side of all quads
  std::size_t number_of_degenerate_quads = 0;
  /// the first degenerate quads, counted like `first_thin_quads`
  std::vector<std::size_t> first_degenerate_quads;
};

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_TYPES_QUAD_SHAPES_H
