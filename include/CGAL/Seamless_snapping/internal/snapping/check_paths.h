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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_CHECK_PATHS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_CHECK_PATHS_H

#include <CGAL/license/Seamless_snapping.h>

// How far connections and cycles are from being met before anything moves. A wrong path would
// distort the whole map, so that it is refused.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/counted.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Relative to the extent of the coordinates.
constexpr double default_connection_tolerance = 0.01;

// Returns a refusal if a path misses by more than the tolerance, relative to the extent.
// \param report its extent is set; receives the largest distance by which a path misses
template <typename Group, typename Halfedge>
std::optional<Refusal> check_paths(const Cut_complex<Group>& complex,
                                   const Constraint_list<Halfedge>& constraints,
                                   const double tolerance, Snapping_report& report)
{
  if(!(tolerance >= 0))
    return Refusal(Outcome::INVALID_ARGUMENT, "connection_tolerance is " +
                   short_number(tolerance) + "; it must not be negative");
  std::size_t worst = 0, count = 0;
  for(std::size_t i = 0; i < complex.paths.size(); ++i) {
    const double distance =
      std::abs(CGAL::to_double(path_misfit(complex, complex.paths[i], complex.coordinates)));
    if(distance > tolerance * report.extent)
      ++count;
    if(distance > report.connection_violation_before) {
      report.connection_violation_before = distance;
      worst = i;
    }
  }
  if(count == 0)
    return std::nullopt;
  return Refusal(Outcome::NOT_CONNECTED, constraints.paths[worst].name + " misses by " +
                 short_number(report.connection_violation_before / report.extent) +
                 " of the extent, more than the connection_tolerance of " +
                 short_number(tolerance) +
                 (count > 1 ? ", as with " + counted(count - 1, "other") : std::string()) +
                 "; see whether its path is the one that is meant, and raise the tolerance if so");
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_CHECK_PATHS_H
