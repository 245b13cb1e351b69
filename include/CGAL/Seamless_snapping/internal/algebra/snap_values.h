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

// From values to values: looks whether they solve the system already, divides it into independent parts,
// puts the values of each on a grid, solves there, and checks what comes back.

#include <CGAL/Seamless_snapping/internal/algebra/System_builder.h>
#include <CGAL/Seamless_snapping/internal/algebra/exact_evaluation.h>
#include <CGAL/Seamless_snapping/internal/algebra/solve_on_grid.h>
#include <CGAL/Seamless_snapping/internal/algebra/system_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Integer>
std::vector<double> component_values(const System_component<Integer>& component,
                                     const std::vector<double>& x)
{
  std::vector<double> values;
  for(const std::size_t j : component.columns)
    values.push_back(x[j]);
  return values;
}

// Any solution has a value of this size or larger.
template <typename Integer>
double size_of_solutions(const Integer_system<Integer>& system)
{
  double largest = 0;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    if(system.right_hand_side(i) == 0 || system.begin(i) == system.end(i))
      continue;
    Exact_integer sum(0);
    for(const Entry<Integer>* e = system.begin(i); e != system.end(i); ++e)
      sum += CGAL::abs(Exact_integer(e->coefficient));
    const Scaled_double b = to_scaled_double(Exact_integer(system.right_hand_side(i)));
    const Scaled_double factor = to_scaled_double(sum);
    largest = (std::max)(largest, scaled_by_power(std::abs(b.mantissa) / factor.mantissa,
                                                  b.exponent - factor.exponent - system.right_hand_scale()));
  }
  return largest;
}

// The values of a part of the system on the finest grid that holds the largest of them.
template <typename Integer>
Grid_point point_on_grid(const System_component<Integer>& component, const std::vector<double>& x,
                         const std::vector<double>& weights, const Number_format& format)
{
  double largest = (std::min)(size_of_solutions(component.system), std::ldexp(1., format.maximum_exponent - 1));
  for(const std::size_t j : component.columns)
    largest = (std::max)(largest, std::abs(x[j]));
  Grid_point point{Grid::finest(format, largest), {}, {}, component.columns.size(), true};
  for(const std::size_t j : component.columns) {
    point.values.push_back(point.grid.split(x[j]));
    point.weights.push_back(weights[j]);
  }
  return point;
}

// The largest violation of the caller's rows, of which the system's are multiples; inexact.
template <typename Integer>
double largest_violation(const System_component<Integer>& component, const Grid_point& point,
                         const std::map<std::size_t, Exact_rational>& scales)
{
  const Integer_system<Integer>& system = component.system;
  const int shift = -system.right_hand_scale() - point.grid.exponent();
  double largest = 0;
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    double violation = std::abs(row_violation(system, i, shift, point.values));
    long exponent = row_exponent(system, i) + point.grid.exponent();
    const auto scale = scales.find(component.rows[i]);
    if(scale != scales.end()) {
      const auto parts = numerator_and_denominator(scale->second);
      const Scaled_double factor = to_scaled_double(parts.first);
      const Scaled_double divisor = to_scaled_double(parts.second);
      violation *= divisor.mantissa / factor.mantissa;
      exponent += divisor.exponent - factor.exponent;
    }
    largest = (std::max)(largest, scaled_by_power(violation, exponent));
  }
  return largest;
}

// Figures of the change, in units of the largest value, so that squares neither overflow nor vanish.
class Change_figures
{
public:
  explicit Change_figures(const double unit) : m_unit(unit > 0 ? unit : 1) { }

  void add(const double before, const Grid& grid, const std::int64_t after, const Grid_value& target)
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
    if(!(std::abs(before) < std::ldexp(grid.step(), 62))) // the grid is finer than that of the input
      return to_double(target) * grid.step() - before;
    const Grid_value start = grid.split(before);
    return (static_cast<double>(target.base - start.base) + (target.offset - start.offset)) * grid.step();
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

inline std::string contradiction_message(const Snapping_report& report)
{
  std::vector<std::size_t> rows;
  for(const auto& multiple : report.certificate)
    rows.push_back(multiple.first);
  return "the constraints contradict each other: a combination of the rows " + list_of_rows(rows) +
         " (multipliers in the certificate) reads 0 = c with c != 0; remove or correct one of them";
}

// Without right-hand sides, 0 would be a solution: those are what to look at.
template <typename Integer>
std::string not_representable_message(const System_component<Integer>& component)
{
  std::vector<std::size_t> rows;
  for(std::size_t k = 0; k < component.rows.size(); ++k)
    if(component.system.right_hand_side(k) != 0)
      rows.push_back(component.rows[k]);
  return "the constraints have rational solutions, but near the values none was found whose values "
         "are all multiples of one power of two that the number type can hold at this size; round the "
         "right-hand sides of the constraints " + list_of_rows(rows) + " to fewer bits, or remove "
         "factors that they are not divisible by";
}

// One part. Writes its new values to `snapped`, or returns false and says why in the report.
template <typename Integer>
bool snap_component(const System_component<Integer>& component, const std::vector<double>& x,
                    const std::vector<double>& weights, const Number_format& format,
                    const std::map<std::size_t, Exact_rational>& scales,
                    std::vector<double>& snapped, Change_figures& figures, Snapping_report& report,
                    Step_timer& timer)
{
  const Grid_point point = point_on_grid(component, x, weights, format);
  report.violation_before = (std::max)(report.violation_before,
                                       largest_violation(component, point, scales));
  timer.finish("input");
  Grid_solution solution{point.grid, {}, {}};
  if(!solve_on_grid(component.system, point, solution, report, timer)) {
    for(auto& multiple : report.certificate)
      multiple.first = component.rows[multiple.first];
    report.message = report.status == Snapping_status::INCONSISTENT
      ? contradiction_message(report) : not_representable_message(component);
    return false;
  }
  report.run.grid_step = (std::max)(report.run.grid_step, solution.grid.step());
  for(std::size_t k = 0; k < component.columns.size(); ++k) {
    const std::size_t j = component.columns[k];
    snapped[j] = solution.grid.value(solution.x[k]);
    figures.add(x[j], solution.grid, solution.x[k], solution.target[k]);
  }
  return true;
}

// Replaces `x` by values that solve the system exactly, or leaves it alone.
template <typename Integer>
void snap_values(const Integer_system<Integer>& system,
                 const std::map<std::size_t, Exact_rational>& scales,
                 const std::vector<double>& weights, const Number_format& format,
                 std::vector<double>& x, Snapping_report& report, Step_timer& timer)
{
  if(next_violated_row(system, x) == system.number_of_rows())
    return;
  const std::vector<System_component<Integer> > components = system_components(system);
  for(const System_component<Integer>& component : components)
    for(const std::size_t j : component.columns)
      report.extent = (std::max)(report.extent, std::abs(x[j]));

  // A contradiction anywhere is the first thing to tell.
  std::vector<double> snapped(x);
  Change_figures figures(report.extent);
  Snapping_status status = Snapping_status::SNAPPED;
  for(const System_component<Integer>& component : components) {
    if(next_violated_row(component.system, component_values(component, x)) ==
       component.system.number_of_rows())
      continue; // exact, and so left alone
    if(snap_component(component, x, weights, format, scales, snapped, figures, report, timer))
      continue;
    status = report.status;
    if(status == Snapping_status::INCONSISTENT)
      break;
  }
  report.status = status;
  if(status != Snapping_status::SNAPPED) {
    return;
  }
  if(next_violated_row(system, snapped) != system.number_of_rows()) {
    report.status = Snapping_status::INTERNAL_ERROR;
    report.message = "the result failed its exact verification and was discarded; please report this";
    return;
  }
  timer.finish("verification");
  figures.fill_in(report);
  x.swap(snapped);
}

inline void snap_values(const Scaled_system& scaled, const std::vector<double>& weights,
                        const Number_format& format, std::vector<double>& x,
                        Snapping_report& report, Step_timer& timer)
{
  std::visit([&](const auto& system)
             { snap_values(system, scaled.scales, weights, format, x, report, timer); },
             scaled.system);
  scaled.rescale(report.certificate);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SNAP_VALUES_H
