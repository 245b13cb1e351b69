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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_H

#include <CGAL/license/Seamless_snapping.h>

// The solver of cut complexes, and what changes its solutions: neither knows the mesh. What
// can be compiled once is declared here, for all groups of transitions.

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/orientation/Flip_untangler.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>
#include <CGAL/Seamless_snapping/internal/snapping/Integer_grid_snapper.h>
#include <CGAL/Seamless_snapping/internal/untangling/untangle.h>

#include <vector>

#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, GROUP)                                  \
  PREFIX template class Reduced_system<GROUP>;                                                     \
  PREFIX template class Complex_solver<GROUP>;                                                     \
  PREFIX template bool is_exact(const Cut_complex<GROUP>&, const std::vector<Uv>&);

#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, GROUP)                                  \
  PREFIX template class Orientation_repair<GROUP>;                                                 \
  PREFIX template class Integer_rounding<GROUP>;

#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, HOW)                                 \
  PREFIX template bool untangle_flips<Rotation_group<4>, HOW>(                                     \
    const Movable_points<Rotation_group<4> >&, const Complex_solver<Rotation_group<4> >&,          \
    Uv_state&, std::size_t&, std::size_t&);

#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_GRID_SNAPPER(PREFIX, GROUP, MAY_UNTANGLE)              \
  PREFIX template Snapping_report Integer_grid_snapper<GROUP, MAY_UNTANGLE>::run();

#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SURFACE_SOLVERS(PREFIX)                                 \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<4>)                            \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<6>)                            \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<4>)                            \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<6>)                            \
  PREFIX template class Untangler<double>;                                                         \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, Untangling::NEAR_BY_FIRST)                 \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, Untangling::ANGLES_FIRST)                  \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_GRID_SNAPPER(PREFIX, Rotation_group<4>, false)                \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_GRID_SNAPPER(PREFIX, Rotation_group<4>, true)                 \
  CGAL_SEAMLESS_SNAPPING_INSTANTIATE_GRID_SNAPPER(PREFIX, Rotation_group<6>, false)

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SURFACE_SOLVERS(extern)

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_H
