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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// The steps from values to values, their figures, and the reasons for which they end.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/Refusal.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/exact/Grid.h>
#include <CGAL/Seamless_snapping/internal/linear/Least_squares_projection.h>
#include <CGAL/Seamless_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Seamless_snapping/internal/linear/exact_evaluation.h>
#include <CGAL/Seamless_snapping/internal/linear/snap_values.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Any solution has a value of this size or larger.
inline double size_of_solutions(const Integer_system& system)
{
  double largest = 0;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    if(!system.has_right_hand_side(i))
      continue;
    const Integer_row<Exact_integer> row = system.exact_row(i);
    Exact_integer sum(0);
    for(const Entry<Exact_integer>& e : row.entries)
      sum += absolute_value(e.coefficient);
    const Scaled_double b = to_scaled_double(row.right_hand_side);
    const Scaled_double factor = to_scaled_double(sum);
    const long exponent = b.exponent - factor.exponent - system.right_hand_scale();
    largest = (std::max)(largest,
                         scaled_by_power(std::abs(b.mantissa) / factor.mantissa, exponent));
  }
  return largest;
}

// The finest grid that holds the values of a component and, as far as is known, its solutions.
inline Grid grid_of_component(const Linear_solver& solver, const Component_index c,
                              const std::vector<double>& x, const Number_format& format)
{
  double largest = (std::min)(size_of_solutions(solver.system(c)),
                              std::ldexp(1., format.maximum_exponent - 1));
  for(const Column_index j : solver.columns(c))
    largest = (std::max)(largest, std::abs(x[std::size_t(j)]));
  return Grid::finest(format, largest);
}

// The largest violation of the caller's rows of a component, of which the system's are multiples;
// inexact.
inline double largest_violation(const Linear_solver& solver, const Component_index c,
                                const Grid& grid, const std::vector<Grid_value>& values,
                                const std::map<std::size_t, Exact_rational>& scales)
{
  const Integer_system& system = solver.system(c);
  const int shift = -system.right_hand_scale() - grid.exponent();
  double largest = 0;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    double violation = std::abs(row_violation(system, i, shift, values));
    long exponent = row_exponent(system, i) + grid.exponent();
    const auto scale = scales.find(solver.rows(c)[i]);
    if(scale != scales.end()) {
      const Fraction parts = to_fraction(scale->second);
      const Scaled_double factor = to_scaled_double(parts.numerator);
      const Scaled_double divisor = to_scaled_double(parts.denominator);
      violation *= divisor.mantissa / factor.mantissa;
      exponent += divisor.exponent - factor.exponent;
    }
    largest = (std::max)(largest, scaled_by_power(violation, exponent));
  }
  return largest;
}

// Figures of the change, in units of the largest value, so that squares neither overflow nor
// vanish.
class Change_figures
{
public:
  explicit Change_figures(const double unit) : m_unit(unit > 0 ? unit : 1) { }

  void add(const double before, const Grid& grid, const std::int64_t after,
           const Grid_value& target)
  {
    const double change = std::abs(grid.value(after) - before);
    const double optimum = difference(target, before, grid) / m_unit;
    m_largest = (std::max)(m_largest, change);
    m_sum += change / m_unit;
    m_squares += (change / m_unit) * (change / m_unit);
    m_optimal_squares += optimum * optimum;
    m_count += 1;
  }

  void fill_in(Snapping_report& report) const
  {
    if(m_count == 0)
      return;
    report.largest_change = m_largest;
    report.mean_change = m_sum / m_count * m_unit;
    report.rms_change = std::sqrt(m_squares / m_count) * m_unit;
    report.optimal_rms_change = std::sqrt(m_optimal_squares / m_count) * m_unit;
  }

private:
  static double difference(const Grid_value& target, const double before, const Grid& grid)
  {
    if(!(std::abs(before) < std::ldexp(grid.step(), 62))) // the grid is finer than the input's
      return to_double(target) * grid.step() - before;
    const Grid_value start = grid.split(before);
    return internal::difference(target, start) * grid.step();
  }

  double m_unit;
  double m_largest = 0, m_sum = 0, m_squares = 0, m_optimal_squares = 0, m_count = 0;
};

// The first of them.
inline std::string list_of_rows(const std::vector<std::size_t>& rows)
{
  constexpr std::size_t at_most = 8;
  std::string list;
  for(std::size_t k = 0; k < rows.size() && k < at_most; ++k)
    list += (k == 0 ? "" : ", ") + std::to_string(rows[k]);
  return rows.size() > at_most ? list + ", ..." : list;
}

inline Refusal contradiction(const Linear_solver& solver)
{
  Refusal refusal{Snapping_status::INCONSISTENT, "", solver.certificate()};
  std::vector<std::size_t> rows;
  for(const auto& multiple : refusal.certificate)
    rows.push_back(multiple.first);
  refusal.message = "the constraints contradict each other: a combination of the rows " +
                    list_of_rows(rows) + " (multipliers in the certificate) reads 0 = c with "
                    "c != 0; remove or correct one of them";
  return refusal;
}

// Without right-hand sides, 0 would be a solution: those are what to look at.
inline Refusal not_representable(const Linear_solver& solver, const Component_index c)
{
  std::vector<std::size_t> rows;
  for(std::size_t k = 0; k < solver.rows(c).size(); ++k)
    if(solver.system(c).has_right_hand_side(k))
      rows.push_back(solver.rows(c)[k]);
  return {Snapping_status::NOT_REPRESENTABLE,
          "the constraints have rational solutions, but near the values none was found in numbers "
          "of their type; round the right-hand sides of the constraints " + list_of_rows(rows) +
          " to fewer bits, or remove factors that they are not divisible by", {}};
}

// The components that have a row which the values do not satisfy exactly.
inline std::vector<Component_index> violated_components(const Linear_solver& solver,
                                                        const std::vector<bool>& holds)
{
  std::vector<Component_index> result;
  for(Component_index c = 0; c < Component_index(solver.number_of_components()); ++c)
    if(!std::all_of(solver.rows(c).begin(), solver.rows(c).end(),
                    [&](const std::size_t i) { return holds[i]; }))
      result.push_back(c);
  return result;
}

CGAL_SEAMLESS_SNAPPING_SOLVER_FUNCTION
std::optional<Refusal> snap_values(const Scaled_system& scaled,
                                   const std::vector<double>& weights,
                                   const Number_format& format, std::vector<double>& x,
                                   Snapping_report& report, Step_timer& timer)
{
  const Integer_system& system = scaled.system;
  std::vector<bool> row_holds(system.number_of_rows());
  for(std::size_t i = 0; i < row_holds.size(); ++i)
    row_holds[i] = holds(system, i, x);
  if(std::find(row_holds.begin(), row_holds.end(), false) == row_holds.end())
    return std::nullopt;
  timer.finish("input");
  const Linear_solver solver(scaled, weights, format, x.size(), true);
  report.linear_solver = solver.figures();
  timer.finish("elimination");
  if(!solver.is_consistent())
    return contradiction(solver);

  Linear_target target;
  Linear_solution solution;
  target.values.resize(x.size());
  solution.x.resize(x.size());
  solution.optimum.resize(x.size());
  for(Component_index c = 0; c < Component_index(solver.number_of_components()); ++c) {
    target.grids.push_back(grid_of_component(solver, c, x, format));
    for(const Column_index j : solver.columns(c)) {
      target.values[std::size_t(j)] = target.grids.back().split(x[std::size_t(j)]);
      report.extent = (std::max)(report.extent, std::abs(x[std::size_t(j)]));
    }
  }
  solution.grids = target.grids;

  std::vector<double> snapped(x);
  Change_figures figures(report.extent);
  for(const Component_index c : violated_components(solver, row_holds)) {
    report.violation_before =
      (std::max)(report.violation_before, largest_violation(solver, c, target.grids[std::size_t(c)],
                                                            target.values, scaled.scales));
    timer.finish("input");
    const auto take = [&](const std::size_t j, const Column_solution& part) {
      report.run.grid_step = (std::max)(report.run.grid_step, part.grid.step());
      snapped[j] = part.grid.value(part.x);
      figures.add(x[j], part.grid, part.x, part.optimum);
    };
    const std::vector<Column_index>& columns = solver.columns(c);
    if(solver.solve_component(c, target, solution, &timer)) {
      for(const Column_index column : columns) {
        const std::size_t j = std::size_t(column);
        take(j, {solution.grids[std::size_t(c)], solution.x[j], solution.optimum[j]});
      }
    } else if(const auto parts = solver.solve_component_on_many_grids(c, target)) {
      for(std::size_t k = 0; k < columns.size(); ++k)
        take(std::size_t(columns[k]), (*parts)[k]);
    } else {
      return not_representable(solver, c);
    }
  }
  for(std::size_t i = 0; i < row_holds.size(); ++i)
    if(!holds(system, i, snapped))
      return Refusal{Snapping_status::INTERNAL_ERROR, "the result failed its exact verification "
                     "and was discarded; please report this", {}};
  timer.finish("verification");
  figures.fill_in(report);
  report.status = Snapping_status::SNAPPED;
  x.swap(snapped);
  return std::nullopt;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H
