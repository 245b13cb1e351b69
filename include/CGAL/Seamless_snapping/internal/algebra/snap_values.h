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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SNAP_VALUES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SNAP_VALUES_H

#include <CGAL/license/Seamless_snapping.h>

// From values to values: looks whether they solve the system already, puts them on a grid, solves there,
// and checks what comes back.

#include <CGAL/Seamless_snapping/internal/algebra/System_builder.h>
#include <CGAL/Seamless_snapping/internal/algebra/exact_evaluation.h>
#include <CGAL/Seamless_snapping/internal/algebra/solve_on_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Which columns occur in a row.
template <typename Integer>
std::vector<bool> used_columns(const Integer_system<Integer>& system)
{
  std::vector<bool> used(system.number_of_columns(), false);
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    for(const Entry<Integer>* e = system.begin(i); e != system.end(i); ++e)
      used[std::size_t(e->column)] = true;
  return used;
}

// The used values on the finest grid that holds the largest of them.
inline Grid_point point_on_grid(const std::vector<double>& x, const std::vector<double>& weights,
                                const std::vector<bool>& used, const Number_format& format,
                                Snapping_report& report)
{
  for(std::size_t j = 0; j < x.size(); ++j)
    if(used[j])
      report.extent = (std::max)(report.extent, std::abs(x[j]));
  Grid_point point{Grid::finest(format, report.extent), std::vector<Grid_value>(x.size()), weights,
                   x.size()};
  for(std::size_t j = 0; j < x.size(); ++j)
    if(used[j])
      point.values[j] = point.grid.split(x[j]);
  return point;
}

// The largest violation, in floating point.
template <typename Integer>
double largest_violation(const Integer_system<Integer>& system, const Grid_point& point)
{
  const int shift = -static_cast<int>(system.right_hand_scale()) - point.grid.exponent();
  double largest = 0;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    largest = (std::max)(largest, std::abs(row_violation(system, i, shift, point.values)));
  return largest * point.grid.step();
}

// Changes are measured in grid steps, so that squares neither overflow nor vanish.
inline void report_changes(const std::vector<double>& before, const std::vector<double>& after,
                           const std::vector<bool>& used, const Grid_solution& solution,
                           Snapping_report& report)
{
  const Grid& grid = solution.grid;
  report.grid_step = grid.step();
  double largest = 0, sum = 0, squares = 0, optimal_squares = 0, count = 0;
  for(std::size_t j = 0; j < before.size(); ++j) {
    if(!used[j])
      continue;
    const Grid_value a = grid.split(before[j]);
    const Grid_value b = grid.split(after[j]);
    const Grid_value& t = solution.target[j];
    const double change = std::abs(static_cast<double>(b.base - a.base) + (b.offset - a.offset));
    const double optimum = static_cast<double>(t.base - a.base) + (t.offset - a.offset);
    largest = (std::max)(largest, change);
    sum += change;
    squares += change * change;
    optimal_squares += optimum * optimum;
    count += 1;
  }
  if(count == 0)
    return;
  report.largest_change = largest * grid.step();
  report.mean_change = sum / count * grid.step();
  report.rms_change = std::sqrt(squares / count) * grid.step();
  report.optimal_rms_change = std::sqrt(optimal_squares / count) * grid.step();
}

inline std::string failure_message(const Snapping_report& report)
{
  if(report.status == Snapping_status::INCONSISTENT) {
    std::string rows;
    for(std::size_t k = 0; k < report.certificate.size() && k < 8; ++k)
      rows += (k == 0 ? " " : ", ") + std::to_string(report.certificate[k].first);
    if(report.certificate.size() > 8)
      rows += ", ...";
    return "the constraints contradict each other: a combination of the rows" + rows +
           " (multipliers in the certificate) reads 0 = c with c != 0; remove or correct one of them";
  }
  return "the constraints have rational solutions, but none whose values are multiples of one power of "
         "two that the number type can hold at this size; round the right-hand sides to fewer bits, "
         "or remove factors that they are not divisible by";
}

// Replaces `x` by values that solve the system exactly, or leaves it alone.
inline void snap_values(const Scaled_system& scaled, const std::vector<double>& weights,
                        const Number_format& format, std::vector<double>& x,
                        Snapping_report& report, Step_timer& timer)
{
  const Any_system& system = scaled.system;
  const auto solves = [&](const std::vector<double>& values) {
    return std::visit([&](const auto& s) { return next_violated_row(s, values) == s.number_of_rows(); },
                      system);
  };
  if(solves(x))
    return;
  const std::vector<bool> used = std::visit([](const auto& s) { return used_columns(s); }, system);
  const Grid_point point = point_on_grid(x, weights, used, format, report);
  report.violation_before = std::visit([&](const auto& s) { return largest_violation(s, point); },
                                       system);
  timer.finish("input");

  Grid_solution solution{point.grid, {}, {}};
  if(!std::visit([&](const auto& s) { return solve_on_grid(s, point, solution, report, timer); },
                 system)) {
    scaled.rescale(report.certificate);
    report.message = failure_message(report);
    return;
  }
  std::vector<double> snapped(x);
  for(std::size_t j = 0; j < x.size(); ++j)
    if(used[j])
      snapped[j] = solution.grid.value(solution.x[j]);
  if(!solves(snapped)) {
    report.status = Snapping_status::INTERNAL_ERROR;
    report.message = "the result failed its exact verification and was discarded; please report this";
    return;
  }
  timer.finish("verification");
  report_changes(x, snapped, used, solution, report);
  x.swap(snapped);
  report.status = Snapping_status::SNAPPED;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SNAP_VALUES_H
