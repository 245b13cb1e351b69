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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H

#include <CGAL/license/Linear_snapping.h>

// The steps from values to values, their figures, and the reasons for a failure.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/Least_squares_projection.h>
#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Linear_snapping/internal/linear/snap_values.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/types/Linear_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
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
                                const Grid& grid, const std::vector<Grid_value>& all_values,
                                const std::map<std::size_t, Exact_rational>& scales)
{
  const Integer_system& system = solver.system(c); // whose columns belong to the component
  std::vector<Grid_value> values;
  for(const Column_index j : solver.columns(c))
    values.push_back(all_values[std::size_t(j)]);
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

// How far values move, how far the optimum is, and the spacing of numbers of their size.
class Change_figures
{
public:
  explicit Change_figures(const Number_format& format) : m_format(format) { }

  void add(const double before, const Column_solution& after, const double weight = 1)
  {
    m_changes.add(after.grid.value(after.x) - before, weight);
    m_optimal_changes.add(difference(after.optimum, before, after.grid), weight);
    m_sizes.add(before, weight);
    int exponent = 0;
    if(std::frexp(before, &exponent) != 0)
      m_spacing.add(std::ldexp(1., (std::max)(exponent - m_format.digits,
                                              m_format.minimum_exponent)), weight);
  }

  void fill_in(Linear_report& report) const
  {
    report.largest_change = m_changes.largest();
    report.mean_change = m_changes.mean();
    report.rms_change = distance();
    report.optimal_rms_change = optimal_distance();
  }

  double distance() const { return m_changes.root_mean_square(); }
  double optimal_distance() const { return m_optimal_changes.root_mean_square(); }

  // The distance in terms of the least that can be expected.
  double ratio() const
  {
    const double spacing = m_spacing.root(m_changes.sum_of_weights());
    const double least = (std::max)(optimal_distance(), spacing);
    return least > 0 ? (std::min)(distance() / least, (std::numeric_limits<double>::max)()) : 1;
  }

  // Whether the values move as far as they are large, though a real solution is near.
  bool is_meaningless() const
  { return ratio() > 1000 && distance() > 0.1 * m_sizes.root(m_changes.sum_of_weights()); }

private:
  static double difference(const Grid_value& target, const double before, const Grid& grid)
  {
    if(!(std::abs(before) < std::ldexp(grid.step(), 62))) // the grid is finer than the input's
      return to_double(target) * grid.step() - before;
    const Grid_value start = grid.split(before);
    return internal::difference(target, start) * grid.step();
  }

  Number_format m_format;
  Magnitudes m_changes, m_optimal_changes, m_spacing, m_sizes;
};

constexpr double far_ratio = 10; // beyond this ratio of distances, another search follows

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
  Refusal refusal(Outcome::INCONSISTENT, {}, solver.certificate());
  std::vector<std::size_t> rows;
  for(const auto& multiple : refusal.certificate)
    rows.push_back(multiple.first);
  refusal.message = "the constraints contradict each other: a combination of the rows " +
                    list_of_rows(rows) + " (multipliers in the certificate) reads 0 = c with "
                    "c != 0" + remedy("remove or correct one of them");
  return refusal;
}

// The refusal if there is no solution at all: without right-hand sides, 0 would be one.
inline Refusal not_representable(const Linear_solver& solver, const Component_index c)
{
  std::vector<std::size_t> rows;
  for(std::size_t k = 0; k < solver.rows(c).size(); ++k)
    if(solver.system(c).has_right_hand_side(k))
      rows.push_back(solver.rows(c)[k]);
  return {Outcome::NOT_REPRESENTABLE,
          "the constraints have rational solutions, but near the values none was found in numbers "
          "of their type" + remedy("round the right-hand sides of the constraints " +
                                   list_of_rows(rows) + " to fewer bits, or remove factors that "
                                   "they are not divisible by")};
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

// \param moved "moved" or "would move"
inline std::string note_on_distance(const Linear_solver& solver, const Component_index c,
                                    const double ratio, const std::string& moved)
{
  const int power = static_cast<int>(std::floor(std::log10(ratio)));
  return "the values of the constraints " + list_of_rows(solver.rows(c)) + " " + moved +
         " more than 10^" + std::to_string(power) + " times as far as the nearest real solution "
         "is: among numbers of their type none was found nearer; coefficients and right-hand sides "
         "of fewer digits, or fewer unknowns that depend on each other, leave more of these";
}

// Snaps component by component. Invariant: finished components have values on their grids.
class Value_snapper
{
public:
  Value_snapper(const Linear_solver& solver, const std::vector<double>& weights,
                const Number_format& format, const std::vector<double>& x)
    : m_solver(solver), m_weights(weights), m_format(format), m_x(x), m_snapped(x),
      m_figures(format)
  {
    m_target.values.resize(x.size());
    m_solution.x.resize(x.size());
    m_solution.optimum.resize(x.size());
    for(Component_index c = 0; c < Component_index(solver.number_of_components()); ++c) {
      m_target.grids.push_back(grid_of_component(solver, c, x, format));
      for(const Column_index j : solver.columns(c))
        m_target.values[std::size_t(j)] = m_target.grids.back().split(x[std::size_t(j)]);
    }
    m_solution.grids = m_target.grids;
  }

  const Linear_target& target() const { return m_target; }
  const std::vector<double>& snapped() const { return m_snapped; }

  // Returns why not, if no solution is found, or one that means nothing.
  std::optional<Refusal> snap(const Component_index c, Step_timer& timer)
  {
    const std::vector<Column_index>& columns = m_solver.columns(c);
    const auto on_one_grid = [&](const std::size_t k) {
      const std::size_t j = std::size_t(columns[k]);
      return Column_solution{m_solution.grids[std::size_t(c)], m_solution.x[j],
                             m_solution.optimum[j]};
    };
    std::optional<Change_figures> change;
    if(m_solver.solve_component(c, m_target, m_solution, &timer))
      change = figures(columns, on_one_grid);
    if(change && !is_worth_another_try(*change, columns.size()))
      return take(c, *change, on_one_grid);
    const auto parts = m_solver.solve_component_on_many_grids(c, m_target);
    if(!change && !parts)
      return not_representable(m_solver, c);
    const auto on_many_grids = [&](const std::size_t k) { return (*parts)[k]; };
    const auto other = parts ? figures(columns, on_many_grids) : *change;
    timer.finish("evaluation");
    return change && !(other.distance() < change->distance()) ? take(c, *change, on_one_grid)
                                                              : take(c, other, on_many_grids);
  }

  void fill_in(Linear_report& report) const
  {
    m_figures.fill_in(report);
    report.grid_step = m_coarsest_step;
    report.distance_ratio = m_ratio;
    if(m_ratio > far_ratio)
      report.message = note_on_distance(m_solver, m_farthest, m_ratio, "moved");
  }

private:
  // If distances are only some steps of the grid, it has to cost little.
  static bool is_worth_another_try(const Change_figures& change, const std::size_t size)
  {
    constexpr std::size_t few = 16;
    return change.ratio() > far_ratio ||
           (size <= few && change.distance() > far_ratio * change.optimal_distance());
  }

  template <typename Parts>
  Change_figures figures(const std::vector<Column_index>& columns, const Parts& part) const
  {
    Change_figures result(m_format);
    for(std::size_t k = 0; k < columns.size(); ++k) {
      const std::size_t j = std::size_t(columns[k]);
      result.add(m_x[j], part(k), m_weights[j]);
    }
    return result;
  }

  template <typename Parts>
  std::optional<Refusal> take(const Component_index c, const Change_figures& change,
                              const Parts& parts)
  {
    if(change.is_meaningless())
      return Refusal(Outcome::NOT_REPRESENTABLE,
                     note_on_distance(m_solver, c, change.ratio(), "would move"));
    const std::vector<Column_index>& columns = m_solver.columns(c);
    for(std::size_t k = 0; k < columns.size(); ++k) {
      const std::size_t j = std::size_t(columns[k]);
      const Column_solution part = parts(k);
      m_coarsest_step = (std::max)(m_coarsest_step, part.grid.step());
      m_snapped[j] = part.grid.value(part.x);
      m_figures.add(m_x[j], part);
    }
    if(change.ratio() > m_ratio) {
      m_ratio = change.ratio();
      m_farthest = c;
    }
    return std::nullopt;
  }

  const Linear_solver& m_solver;
  const std::vector<double>& m_weights;
  const Number_format& m_format;
  const std::vector<double>& m_x;
  Linear_target m_target;
  Linear_solution m_solution;
  std::vector<double> m_snapped;
  Change_figures m_figures;
  double m_coarsest_step = 0, m_ratio = 0;
  Component_index m_farthest = -1;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<Refusal> snap_values(const Scaled_system& scaled,
                                   const std::vector<double>& weights,
                                   const Number_format& format, std::vector<double>& x,
                                   Linear_report& report, Step_timer& timer)
try {
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

  for(std::size_t j = 0; j < x.size(); ++j)
    if(solver.component(Column_index(j)) >= 0)
      report.extent = (std::max)(report.extent, std::abs(x[j]));
  Value_snapper snapper(solver, weights, format, x);
  for(const Component_index c : violated_components(solver, row_holds)) {
    const Linear_target& target = snapper.target();
    report.violation_before =
      (std::max)(report.violation_before, largest_violation(solver, c, target.grids[std::size_t(c)],
                                                            target.values, scaled.scales));
    timer.finish("input");
    if(auto refusal = snapper.snap(c, timer))
      return refusal;
  }
  for(std::size_t i = 0; i < row_holds.size(); ++i)
    if(!holds(system, i, snapper.snapped()))
      return Refusal(Outcome::INTERNAL_ERROR, "the result failed its exact verification "
                     "and was discarded; please report this");
  timer.finish("verification");
  snapper.fill_in(report);
  report.status = Outcome::SNAPPED;
  x = snapper.snapped();
  return std::nullopt;
} catch(const Work_exceeded&) {
  return Refusal(Outcome::TOO_LARGE,
                 "the constraints link so many unknowns that a solution takes too long; use fewer "
                 "of them at once, or coefficients of fewer digits");
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SNAP_VALUES_IMPL_H
