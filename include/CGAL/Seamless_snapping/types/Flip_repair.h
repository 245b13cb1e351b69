// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_FLIP_REPAIR_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_FLIP_REPAIR_H

#include <CGAL/license/Seamless_snapping.h>

// What is to be done about faces that are flipped in the input.

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingRef

Values of the named parameter `repair_flips` of `snap_to_seamless()` and of
`snap_volume_to_seamless()`, which tells what they mean for cells. `true` stands for `NEAR_BY`,
`false` for `NONE`.

Repairs leave cones their angles if they can: a cone of 450 degrees, for instance, does not become
one of 90, for which another vertex would get 360 degrees more. Only where flips remain, all is
tried again without this condition; and, but for integer-grid maps, before large parts of the map
are changed. No face that is positive loses its orientation for another one.

The search is bounded by the named parameter `number_of_untangling_iterations`, 400 by default: that
many iterations of Newton's method over all faces. Where the factorization of one takes longer than
the faces, it counts for as many as take as long. Maps of common producers, and small maps that
were tangled at random, took at most 92 in the tests. What remains flipped is told by the status
`Outcome::FLIPS_REMAIN`; the result is exact nevertheless. A face that seams and alignments
leave no area, whatever the coordinates are, is not searched for.
*/
enum class Flip_repair
{
  NONE,    ///< Flips of the input stay.
  NEAR_BY, ///< Single vertices move, and a quadratic program looks for solutions near by.
  UNTANGLE ///< The same; where flips remain, the map around them is changed as much as it takes.
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_FLIP_REPAIR_H
