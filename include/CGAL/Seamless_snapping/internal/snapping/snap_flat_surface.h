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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// Snaps a copy of a map in arrays: what is the same for all types of meshes.

#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/snapping/Surface_snapper.h>
#include <CGAL/Seamless_snapping/internal/snapping/solve_complex.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Snaps the map times a number, and to integers if the options ask for that. The map is void
// unless the report is a success.
template <typename Group>
Snapping_report snap_flat_surface(Flat_surface& surface, double scale,
                                  const Given_transitions<Group, Corner_index>& given,
                                  const Snapping_options<Corner_index>& options,
                                  Solve_complex<Group> solve);

#define CGAL_SEAMLESS_SNAPPING_SNAP_FLAT_SURFACE(PREFIX, GROUP)                                    \
  PREFIX template Snapping_report snap_flat_surface<GROUP>(                                        \
    Flat_surface&, double, const Given_transitions<GROUP, Corner_index>&,                          \
    const Snapping_options<Corner_index>&, Solve_complex<GROUP>);

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_SEAMLESS_SNAPPING_SNAP_FLAT_SURFACE(extern, Rotation_group<4>)
CGAL_SEAMLESS_SNAPPING_SNAP_FLAT_SURFACE(extern, Rotation_group<6>)
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/snapping/snap_flat_surface_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_H
