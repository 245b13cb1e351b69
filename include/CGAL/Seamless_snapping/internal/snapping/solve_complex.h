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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// From the complex of a surface to its exact coordinates: what is the same for all types of meshes.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/row_origins.h>
#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The repairs of flipped faces that a solution may have.
struct Solution_repairs
{
  Flip_repair flip_repair;
  bool keeps_angles;       // first, as cones become vertices of quads
  std::size_t& iterations; // that the search may still take; receives the rest
};

// Has no coordinates if nothing moves.
struct Complex_solution
{
  std::vector<Uv> coordinates;           // per point: sectors, and then vertices without a sector
  Magnitudes optimal_changes;            // of the least-squares optimum, without rounding
  std::vector<Row_origin> contradiction; // the rows of the certificate of a refusal
};

// Fills in the solution, and what the report tells of it, or returns why there is none.
// \param is_exact whether the input is a solution
// \tparam may_untangle whether there may be repairs by `Flip_repair::UNTANGLE`
template <typename Group, bool may_untangle>
std::optional<Refusal> solve_complex(const Cut_complex<Group>& complex, bool is_exact,
                                     const Number_format& format, Point_stars& stars,
                                     const Solution_repairs& repairs, Snapping_report& report,
                                     Step_timer& timer, Complex_solution& solution);

// `solve_complex()` with or without untangling, which not all programs compile.
template <typename Group>
using Solve_complex = decltype(&solve_complex<Group, false>);

#define CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEX(PREFIX, GROUP, MAY_UNTANGLE)                          \
  PREFIX template std::optional<Refusal> solve_complex<GROUP, MAY_UNTANGLE>(                       \
    const Cut_complex<GROUP>&, bool, const Number_format&, Point_stars&, const Solution_repairs&,  \
    Snapping_report&, Step_timer&, Complex_solution&);

#define CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEXES(PREFIX)                                             \
  CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEX(PREFIX, Rotation_group<4>, false)                           \
  CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEX(PREFIX, Rotation_group<4>, true)                            \
  CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEX(PREFIX, Rotation_group<6>, false)

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_SEAMLESS_SNAPPING_SOLVE_COMPLEXES(extern)
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/snapping/solve_complex_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SOLVE_COMPLEX_H
