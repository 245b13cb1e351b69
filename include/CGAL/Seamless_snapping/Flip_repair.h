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

#ifndef CGAL_SEAMLESS_SNAPPING_FLIP_REPAIR_H
#define CGAL_SEAMLESS_SNAPPING_FLIP_REPAIR_H

#include <CGAL/license/Seamless_snapping.h>

// What is to be done about faces that are flipped in the input.

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingRef

Values of the named parameter `repair_flips` of `snap_to_seamless()`. `true` stands for `NEAR_BY`,
`false` for `NONE`.

Repairs leave cones their angles if they can: a cone of 450 degrees, for instance, does not become
one of 90, for which another vertex would get 360 degrees more. Only where flips remain, all is
tried again without this condition; and, but for integer-grid maps, before large parts of the map
are changed. The work of untangling is bounded: 400 iterations of Newton's
method over all faces, twice if all is tried again, and for integer-grid maps nine times that, as
new cones are rounded up to eight times. Of the first 400, maps of common producers took at most 92,
and small maps that were tangled at random 208.
*/
enum class Flip_repair
{
  NONE,    ///< Flips of the input stay.
  NEAR_BY, ///< Single vertices move, and a quadratic program looks for solutions near by.
  UNTANGLE ///< The same; where flips remain, the map around them is changed as much as it takes.
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_FLIP_REPAIR_H
