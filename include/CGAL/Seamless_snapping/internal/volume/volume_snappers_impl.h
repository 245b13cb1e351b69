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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

#include <CGAL/Seamless_snapping/internal/volume/snap_flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_whole_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/volume_snappers.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<Refusal> snap_flat_volume(const Flat_volume& volume, const Volume_options& options,
                                        const Number_format& format, Snapping_report& report,
                                        Step_timer& timer, std::vector<Uvw>& snapped)
{
  return options.is_about_all_cells()
           ? Whole_volume_snapper(volume, options, format, report, timer).run(snapped)
           : Flat_volume_snapper(volume, options.tolerance, format, report, timer).run(snapped);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H
