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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CHOSEN_OPTIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CHOSEN_OPTIONS_H

#include <CGAL/license/Seamless_snapping.h>

// Which rotational symmetry the named parameters ask for. The parameter's type tells, so that a
// call compiles the code of one group only.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The plain chain of any named parameters.
template <typename NamedParameters>
using Plain_parameters = std::decay_t<decltype(strip(std::declval<const NamedParameters&>()))>;

// The parameters of `snap_to_seamless()`. Functions that verify and analyze accept the same chain,
// so that it need not be written twice.
constexpr auto surface_parameters =
  named<CGAL::internal_np::align_border, CGAL::internal_np::connection_constraints,
        CGAL::internal_np::connection_tolerance, CGAL::internal_np::corner_constraints,
        CGAL::internal_np::cycle_constraints, CGAL::internal_np::edge_is_constrained,
        CGAL::internal_np::edge_is_cut, CGAL::internal_np::grid_scale,
        CGAL::internal_np::halfedge_rotation, CGAL::internal_np::integer_grid,
        CGAL::internal_np::repair_flips, CGAL::internal_np::rotational_symmetry,
        CGAL::internal_np::rounding_tolerance, CGAL::internal_np::tolerance,
        CGAL::internal_np::untangling_iterations, CGAL::internal_np::verbose,
        CGAL::internal_np::vertex_index, CGAL::internal_np::vertex_point,
        CGAL::internal_np::visitor>;

// The parameters of `snap_volume_to_seamless()`, and of the functions that verify volumes.
constexpr auto volume_parameters =
  named<CGAL::internal_np::align_boundary, CGAL::internal_np::cell_neighbors,
        CGAL::internal_np::feature_edges, CGAL::internal_np::feature_facets,
        CGAL::internal_np::grid_scale, CGAL::internal_np::integer_grid,
        CGAL::internal_np::repair_flips, CGAL::internal_np::rounding_tolerance,
        CGAL::internal_np::tolerance, CGAL::internal_np::untangling_iterations,
        CGAL::internal_np::verbose, CGAL::internal_np::visitor>;

template <typename Parameter>
struct Order_of_symmetry
{
  static_assert(sizeof(Parameter) == 0,
                "rotational_symmetry takes Rotational_symmetry<N>(), not a number: the code for N "
                "is chosen when a program is compiled");
};

template <int N>
struct Order_of_symmetry<Rotational_symmetry<N> > : std::integral_constant<int, N>
{ };

// \tparam NamedParameters a plain chain
template <typename NamedParameters>
constexpr int order_of_symmetry =
  Order_of_symmetry<std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::rotational_symmetry_t, NamedParameters,
    Rotational_symmetry<4> >::type> >::value;

template <typename NamedParameters>
using Symmetry_group = Group_of_order<order_of_symmetry<NamedParameters> >;

constexpr double default_rounding_tolerance = 0.01;

// Parameters that do nothing by themselves are mistakes where they are alone.
template <typename NamedParameters>
constexpr void check_parameters()
{
  constexpr bool may_round = is_given<NamedParameters, CGAL::internal_np::integer_grid_t>;
  static_assert(may_round || !is_given<NamedParameters, CGAL::internal_np::rounding_tolerance_t>,
                "rounding_tolerance is for integer_grid: give that, too");
  static_assert(may_round || is_given<NamedParameters, CGAL::internal_np::repair_flips_t> ||
                  !is_given<NamedParameters, CGAL::internal_np::untangling_iterations_t>,
                "number_of_untangling_iterations is for repair_flips: give that, too");
  using Repair = std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::repair_flips_t, NamedParameters, bool>::type>;
  static_assert(std::is_same<Repair, bool>::value || std::is_same<Repair, Flip_repair>::value,
                "repair_flips takes a Flip_repair or a bool, not a number");
}

// The parameter is a Boolean, or a Flip_repair.
template <typename NamedParameters>
Flip_repair chosen_flip_repair(const NamedParameters& np)
{
  return static_cast<Flip_repair>(chosen(np, CGAL::internal_np::repair_flips, 0));
}

template <typename NamedParameters>
std::size_t chosen_number_of_untangling_iterations(const NamedParameters& np)
{
  return chosen(np, CGAL::internal_np::untangling_iterations, std::size_t(400));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CHOSEN_OPTIONS_H
