// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SOLVE_ON_GRID_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SOLVE_ON_GRID_H

#include <CGAL/license/Seamless_snapping.h>

// The one door into the algebra: runs the snapper in 64-bit integers if the system has no larger ones,
// and, where one of them overflows, from the start in multiprecision; says in the report what came of
// it. And how the solution's target follows that of the unknowns.

#include <CGAL/Seamless_snapping/internal/algebra/Difference_projection.h>
#include <CGAL/Seamless_snapping/internal/algebra/Grid_solver.h>
#include <CGAL/Seamless_snapping/internal/algebra/contradiction_certificate.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// May throw `Integer_overflow` for 64-bit integers. Returns whether there is a solution.
template <typename Integer>
bool solve_with(const Integer_system<Integer>& system, const Grid_point& point,
                Grid_solution& solution, Snapping_report& report, Step_timer& timer)
{
  const Grid_solver<Integer> solver(system);
  timer.finish("elimination");
  solver.fill_in(report);
  if(!solver.is_consistent()) {
    report.status = Snapping_status::INCONSISTENT;
    report.certificate = contradiction_certificate(to_multiprecision(system));
    return false;
  }
  if(!solver.solve(point, solution, timer)) {
    report.status = Snapping_status::NOT_REPRESENTABLE;
    return false;
  }
  return true;
}

inline bool solve_on_grid(const Integer_system<std::int64_t>& system, const Grid_point& point,
                          Grid_solution& solution, Snapping_report& report, Step_timer& timer)
{
  try {
    return solve_with(system, point, solution, report, timer);
  } catch(const Integer_overflow&) {
    return solve_with(to_multiprecision(system), point, solution, report, timer);
  }
}

inline bool solve_on_grid(const Integer_system<Exact_integer>& system, const Grid_point& point,
                          Grid_solution& solution, Snapping_report& report, Step_timer& timer)
{
  if(const auto small = to_machine_integers(system)) // a part of a system with larger integers
    return solve_on_grid(*small, point, solution, report, timer);
  return solve_with(system, point, solution, report, timer);
}

// How the least-squares target answers to changes of the values.
template <typename Integer>
Difference_projection difference_projection(const Integer_system<Integer>& system,
                                            const std::vector<double>& weights)
{
  try {
    return Difference_projection(system, Grid_solver<Integer>(system).independent_rows(), weights);
  } catch(const Integer_overflow&) { // only from 64-bit integers
    const Integer_system<Exact_integer> big = to_multiprecision(system);
    return Difference_projection(big, Grid_solver<Exact_integer>(big).independent_rows(), weights);
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SOLVE_ON_GRID_H
