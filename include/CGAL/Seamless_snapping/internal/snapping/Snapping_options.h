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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAPPING_OPTIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAPPING_OPTIONS_H

#include <CGAL/license/Seamless_snapping.h>

// What the named parameters of `snap_to_seamless()` ask for, without their types. Calls with
// different parameters share all code that knows these values only: it is compiled once for a mesh
// and a uv map.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Relative to the extent of the coordinates.
constexpr double default_connection_tolerance = 0.01;

template <typename Halfedge>
struct Snapping_options
{
  std::vector<Halfedge> edges_to_align; // one halfedge of each
  Constraint_list<Halfedge> constraints;
  double tolerance;
  double connection_tolerance;
  double rounding_tolerance;
  bool rounds; // to an integer-grid map
  Flip_repair flip_repair;
  std::size_t number_of_untangling_iterations;
  bool is_verbose;

  // The same with `number(h)` for each halfedge h.
  template <typename Number>
  auto renumbered(const Number& number) const
  {
    std::vector<decltype(number(Halfedge()))> edges;
    for(const Halfedge h : edges_to_align)
      edges.push_back(number(h));
    return Snapping_options<decltype(number(Halfedge()))>{
      std::move(edges), constraints.renumbered(number), tolerance, connection_tolerance,
      rounding_tolerance, rounds, flip_repair, number_of_untangling_iterations, is_verbose};
  }
};

template <typename Group, typename TriangleMesh, typename NamedParameters>
Snapping_options<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
snapping_options(const TriangleMesh& tmesh, const NamedParameters& np)
{
  const auto chosen = [&](const auto tag, const auto by_default) {
    return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, tag), by_default);
  };
  return {edges_to_align(tmesh, np),
          read_constraints<Group>(tmesh, np),
          chosen_tolerance(np),
          double(chosen(CGAL::internal_np::connection_tolerance, default_connection_tolerance)),
          double(chosen(CGAL::internal_np::rounding_tolerance, default_rounding_tolerance)),
          bool(chosen(CGAL::internal_np::integer_grid, false)),
          chosen_flip_repair(np),
          chosen_number_of_untangling_iterations(np),
          bool(chosen(CGAL::internal_np::verbose, false))};
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAPPING_OPTIONS_H
