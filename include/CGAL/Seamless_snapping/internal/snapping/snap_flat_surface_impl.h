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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// Snaps a flat surface, and compares it with the input.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/snapping/Integer_grid_snapper.h>
#include <CGAL/Seamless_snapping/internal/snapping/snap_flat_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Changes and orientations against the input times a number, where there were steps between.
// Returns the area of the result in the domain.
template <typename Group>
double compare_with_input(const std::vector<Uv>& input, const double scale,
                          const Flat_surface& result, Snapping_report& report)
{
  Magnitudes changes;
  report.lost_faces.clear();
  report.remaining_flips.clear();
  double area = 0;
  for(std::size_t first = 0; first < input.size(); first += 3) {
    Uv_triangle before, after;
    for(std::size_t k = 0; k < 3; ++k) {
      const Uv& u = before[k] = input[first + k];
      const Uv& v = after[k] = result.uv(Corner_index(first + k));
      for(const double change : Group::to_cartesian({v[0] - scale * u[0], v[1] - scale * u[1]}))
        changes.add(change);
    }
    area += ((after[1][0] - after[0][0]) * (after[2][1] - after[0][1]) -
             (after[1][1] - after[0][1]) * (after[2][0] - after[0][0])) / 2;
    if(orientation(after) != CGAL::POSITIVE)
      (orientation(before) == CGAL::POSITIVE ? report.lost_faces : report.remaining_flips)
        .push_back(first / 3);
  }
  report.largest_change = changes.largest();
  report.mean_change = changes.mean();
  report.rms_change = changes.root_mean_square();
  report.optimal_rms_change = 0; // known for one step only
  return area;
}

template <typename Group>
Snapping_report snap_flat_surface(Flat_surface& surface, const double scale,
                                  const Given_transitions<Group, Corner_index>& given,
                                  const Snapping_options<Corner_index>& options,
                                  const Solve_complex<Group> solve)
{
  if(!(scale > 0 && std::isfinite(scale)))
    return refused<Snapping_report>(
      Report(Outcome::INVALID_ARGUMENT, term("grid_scale") + " must be positive and finite"));
  const std::vector<Uv> before = surface.all_uv();
  for(Corner_index h = 0; h < surface.number_of_corners(); ++h)
    surface.set_uv(h, {scale * surface.uv(h)[0], scale * surface.uv(h)[1]});
  Integer_grid_snapper<Group> snapper(surface, given, options, solve);
  Snapping_report report = snapper.run();
  if(const auto refusal = snapper.write())
    refuse(report, *refusal);
  if(!report)
    return report;
  const double area = compare_with_input<Group>(before, scale, surface, report);
  // nothing but flips makes it less than half a cell, and faces between no integers
  if(area < 0.25 && !report.lost_faces.empty())
    refuse(report, Outcome::NOT_INTEGER,
           "at the nearest integers, the map covers no cell" + remedy(scale_up));
  else
    report.status = Outcome::SNAPPED;
  return report;
}

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_SEAMLESS_SNAPPING_SNAP_FLAT_SURFACE(, Rotation_group<4>)
CGAL_SEAMLESS_SNAPPING_SNAP_FLAT_SURFACE(, Rotation_group<6>)
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_FLAT_SURFACE_IMPL_H
