// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_H

#include <CGAL/license/Linear_snapping.h>

// From values to values: checks whether they solve the system already, rounds the values of each
// component to a grid, solves there, and checks the result.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Linear_snapping/types/Linear_report.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Replaces `x` by values that solve the system exactly. Values of components that hold do not
// change. If the function refuses the system, no value changes.
std::optional<Refusal> snap_values(const Scaled_system& scaled, const std::vector<double>& weights,
                                   const Number_format& format, std::vector<double>& x,
                                   Linear_report& report, Step_timer& timer);

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Linear_snapping/internal/linear/snap_values_impl.h>
#endif

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_H
