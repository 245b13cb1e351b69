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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLUTION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLUTION_H

#include <CGAL/license/Linear_snapping.h>

// The input and the output of the linear solver, on grids.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// All that the solutions of one component depend on, but for its values.
struct Component_input
{
  Integer_system system;
  std::vector<double> weights; // in the least-squares target, one per column, positive
  std::size_t number_of_representable_columns; // so many of the first are numbers of the format

  friend bool operator<(const Component_input& a, const Component_input& b)
  {
    return std::tie(a.number_of_representable_columns, a.system, a.weights) <
           std::tie(b.number_of_representable_columns, b.system, b.weights);
  }
};

// The values to snap, on a grid for each component.
struct Linear_target
{
  std::vector<Grid> grids;        // one per component
  std::vector<Grid_value> values; // one per column, in steps of its component's grid
};

// Columns in no row are 0.
struct Linear_solution
{
  std::vector<Grid> grids;         // one per component
  std::vector<std::int64_t> x;     // one per column, in steps of its component's grid
  std::vector<Grid_value> optimum; // likewise: the real-valued least-squares optimum
};

// On a grid of its own.
struct Column_solution
{
  Grid grid;
  std::int64_t x;
  Grid_value optimum;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLUTION_H
