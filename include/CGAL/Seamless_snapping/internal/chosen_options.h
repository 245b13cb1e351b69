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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_CHOSEN_OPTIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_CHOSEN_OPTIONS_H

#include <CGAL/license/Seamless_snapping.h>

// What the named parameters ask for that snapping of surfaces and of volumes have in common.

#include <CGAL/Seamless_snapping/Flip_repair.h>
#include <CGAL/Seamless_snapping/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// In units of the grid: beyond, something else than the nearest integers is meant.
constexpr double default_rounding_tolerance = 0.01;

// The parameter is a Boolean, or a Flip_repair.
template <typename NamedParameters>
Flip_repair chosen_flip_repair(const NamedParameters& np)
{
  return static_cast<Flip_repair>(int(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::repair_flips), false)));
}

template <typename NamedParameters>
std::size_t chosen_number_of_untangling_iterations(const NamedParameters& np)
{
  return static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::untangling_iterations), 400));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_CHOSEN_OPTIONS_H
