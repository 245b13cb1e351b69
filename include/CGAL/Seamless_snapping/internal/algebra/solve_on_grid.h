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

// The linear solver as the surface function still calls it.

#include <CGAL/Seamless_snapping/internal/linear/Linear_solver.h>

#include <variant>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Any_system = std::variant<Integer_system>;

struct Grid_point
{
  Grid grid;
  std::vector<Grid_value> values;
  std::vector<double> weights;
  std::size_t number_of_representable_columns;
  bool may_be_finer;
};

struct Grid_solution
{
  Grid grid;
  std::vector<std::int64_t> x;
  std::vector<Grid_value> target;
};

inline bool solve_on_grid(const Integer_system& system, const Grid_point& point,
                          Grid_solution& solution, Snapping_report& report, Step_timer& timer)
{
  std::vector<bool> is_representable(point.values.size(), false);
  std::fill_n(is_representable.begin(), point.number_of_representable_columns, true);
  const Component_solver solver(system, point.weights, point.grid.format(), is_representable,
                                point.may_be_finer);
  timer.finish("elimination");
  solver.add_to(report.linear_solver);
  if(!solver.is_consistent()) {
    report.status = Snapping_status::INCONSISTENT;
    report.certificate = to_integer_multipliers(solver.contradiction());
    return false;
  }
  Component_solution part{point.grid, {}, point.values};
  if(!solver.solve(part, &timer)) {
    report.status = Snapping_status::NOT_REPRESENTABLE;
    return false;
  }
  solution = Grid_solution{part.grid, part.x, part.optimum};
  return true;
}

class Difference_projection
{
public:
  Difference_projection(const Integer_system& system, const std::vector<double>& weights)
    : m_solver(system, weights, Number_format::of<double>(), {}, false)
  { }

  Eigen::VectorXd operator()(const Eigen::VectorXd& shifts) const
  { return m_solver.displacements(shifts); }

private:
  Component_solver m_solver;
};

inline Difference_projection difference_projection(const Integer_system& system,
                                                   const std::vector<double>& weights)
{
  return Difference_projection(system, weights);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SOLVE_ON_GRID_H
