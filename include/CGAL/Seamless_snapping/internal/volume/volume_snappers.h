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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_H

#include <CGAL/license/Seamless_snapping.h>

// Exact maps of volumes in plain arrays: what is the same for all types of callers.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>
#include <CGAL/Seamless_snapping/types/Volume_seamlessness.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Volume_options
{
  double tolerance; // relative to the extent
  bool rounds;      // to an integer-grid map
  double grid_scale;
  double rounding_tolerance;
  Flip_repair flip_repair;
  std::size_t number_of_untangling_iterations;

  // Whether cells away from constraints are looked at.
  bool is_about_all_cells() const
  {
    return rounds || grid_scale != 1 || flip_repair != Flip_repair::NONE;
  }
};

// Fills in the coordinates of all corners of the flat volume, and the report but for its status,
// which is `ALREADY_EXACT` before. Returns why there are none, if so. Where constraints are not all
// that the options ask for, the volume holds all cells, none of whose vertices is fixed.
std::optional<Refusal> snap_flat_volume(const Flat_volume& volume, const Volume_options& options,
                                        const Number_format& format, Snapping_report& report,
                                        Step_timer& timer, std::vector<Uvw>& snapped);

// How far a map is from an integer-grid map, computed from its coordinates only.
// \pre the volume holds all cells, and lists no singular edges
Volume_integer_grid_measure measure_integer_grid(const Flat_volume& volume);

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/volume/volume_snappers_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_H
