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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H

#include <CGAL/license/Seamless_snapping.h>

// A grid for each unknown: where values of mixed scale have no solution on the grid that the
// largest of them needs. Columns are scaled by powers of two; what is left is a system on the
// integers.

#include <CGAL/Seamless_snapping/internal/linear/Component_solver.h>
#include <CGAL/Seamless_snapping/internal/linear/Linear_solution.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The exponent of the finest grid that holds a number near v, given in steps of another grid.
inline int exponent_of_value(const Grid& grid, const Grid_value& v)
{
  const Number_format& format = grid.format();
  int exponent = 0;
  const double mantissa = std::frexp(to_double(v), &exponent);
  if(mantissa == 0)
    return grid.exponent() - format.digits;
  if(std::abs(mantissa) == 0.5 && v.offset * mantissa < 0)
    --exponent; // just below a power of two
  return (std::max)(grid.exponent() + exponent - format.digits, format.minimum_exponent);
}

// C x = b in terms of the multiples of 2^exponents that x are made of.
inline Integer_system scaled_columns(const Integer_system& system,
                                     const std::vector<int>& exponents)
{
  std::vector<Integer_row<Exact_integer> > rows;
  std::vector<int> scales; // of right-hand sides
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    rows.push_back(system.exact_row(i));
    int finest = (std::numeric_limits<int>::max)();
    for(const Entry<Exact_integer>& e : rows.back().entries)
      finest = (std::min)(finest, exponents[std::size_t(e.column)]);
    for(Entry<Exact_integer>& e : rows.back().entries)
      e.coefficient = product(e.coefficient,
                              power_of_two(std::size_t(exponents[std::size_t(e.column)] - finest)));
    scales.push_back(system.right_hand_scale() + finest);
  }
  Integer_system result(system.number_of_columns());
  const int scale = *std::max_element(scales.begin(), scales.end());
  result.set_right_hand_scale(scale);
  for(std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].right_hand_side =
      product(rows[i].right_hand_side, power_of_two(std::size_t(scale - scales[i])));
    result.add_row(std::move(rows[i]));
  }
  return result;
}

// In units of the columns' grids.
inline std::vector<double> scaled_weights(const std::vector<double>& weights,
                                          const std::vector<int>& exponents)
{
  const int coarsest = *std::max_element(exponents.begin(), exponents.end());
  std::vector<double> result;
  for(std::size_t j = 0; j < weights.size(); ++j)
    result.push_back(std::ldexp(weights[j], (std::max)(2 * (exponents[j] - coarsest), -400)));
  return result;
}

// Solves a component whose optimum is given. Where a value exceeds what its grid holds, its grid
// becomes coarser, and all are solved again.
inline std::optional<std::vector<Column_solution> >
solve_on_many_grids(const Integer_system& system, const std::vector<double>& weights,
                    const Component_solution& optimum)
{
  constexpr std::size_t most_columns = 200;
  constexpr int most_rounds = 10;
  const std::size_t n = system.number_of_columns();
  const Number_format& format = optimum.grid.format();
  if(n > most_columns)
    return std::nullopt;
  std::vector<int> exponents;
  for(const Grid_value& v : optimum.optimum)
    exponents.push_back(exponent_of_value(optimum.grid, v));
  for(int round = 0; round < most_rounds; ++round) {
    const Component_solver solver(scaled_columns(system, exponents),
                                  scaled_weights(weights, exponents), format,
                                  std::vector<bool>(n, true), false);
    Component_solution solution{Grid(format, 0), {}, optimum.optimum};
    for(std::size_t j = 0; j < n; ++j)
      rescale(solution.optimum[j], exponents[j] - optimum.grid.exponent());
    if(solver.solve(solution)) {
      std::vector<Column_solution> result;
      for(std::size_t j = 0; j < n; ++j) {
        const Grid grid(format, exponents[j] + solution.grid.exponent());
        if(!grid.is_representable(solution.x[j]))
          return std::nullopt;
        Grid_value v = optimum.optimum[j];
        rescale(v, grid.exponent() - optimum.grid.exponent());
        result.push_back({grid, solution.x[j], v});
      }
      return result;
    }
    bool has_changed = false;
    for(std::size_t j = 0; j < solution.x.size(); ++j) {
      const int excess = static_cast<int>(bit_length(solution.x[j])) - format.digits;
      if(excess > 0 && !solution.grid.is_representable(solution.x[j])) {
        exponents[j] += excess;
        has_changed = true;
      }
    }
    if(!has_changed)
      break;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H
