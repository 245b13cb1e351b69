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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// Solves the equations of a complex, repairs what that turns over, and verifies the result.

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/orientation/Flip_untangler.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>
#include <CGAL/Seamless_snapping/internal/snapping/solve_complex.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group, bool may_untangle>
std::optional<Refusal> solve_complex(const Cut_complex<Group>& complex, const bool was_exact,
                                     const Number_format& format, Point_stars& stars,
                                     const Solution_repairs& repairs, Snapping_report& report,
                                     Step_timer& timer, Complex_solution& solution)
{
  Complex_solver<Group> solver(complex, format);
  report.linear_solver = solver.linear_solver().figures();
  timer.finish("elimination");
  Snapped_coordinates<Group> snapped{complex.coordinates, {}, -1};
  if(!was_exact)
    if(const auto refusal = solver.solve(snapped)) {
      for(const auto& multiple : refusal->certificate)
        solution.contradiction.push_back(solver.system().origin(multiple.first));
      return refusal;
    }
  timer.finish("solution");

  typename Orientation_repair<Group>::Untangle untangle = nullptr;
  if constexpr(may_untangle)
    if(repairs.flip_repair == Flip_repair::UNTANGLE)
      untangle = repairs.keeps_angles ? &untangle_flips<Group, Untangling::ANGLES_FIRST>
                                      : &untangle_flips<Group, Untangling::NEAR_BY_FIRST>;
  Orientation_repair<Group>(complex, solver, stars, repairs.flip_repair != Flip_repair::NONE,
                            repairs.iterations, untangle)
    .run(snapped.coordinates, report);
  timer.finish("orientation");
  if(was_exact && report.run.number_of_repaired_flips == 0)
    return std::nullopt;

  if(!is_exact(complex, snapped.coordinates))
    return Refusal(Outcome::INTERNAL_ERROR, "the result failed its exact verification and "
                                            "was discarded; please report this");
  timer.finish("verification");
  report.grid_step =
    report.linear_solver.number_of_constraints > 0 ? solver.coarsest_step() : 0;
  solution.coordinates = std::move(snapped.coordinates);
  solution.optimal_changes = snapped.optimal_changes;
  return std::nullopt;
}

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
template class Reduced_system<Rotation_group<4> >;
template class Reduced_system<Rotation_group<6> >;
template class Complex_solver<Rotation_group<4> >;
template class Complex_solver<Rotation_group<6> >;
template class Distortion_minimizer<double>;
template class Untangler<double>;
CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEXES()
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_IMPL_H
