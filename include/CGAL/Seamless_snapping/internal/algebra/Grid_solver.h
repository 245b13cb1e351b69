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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_GRID_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_GRID_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// The snapper: joins elimination, target, and evaluation. Takes plain rows, weights, and values; gives
// back integers on a grid that solve the rows exactly, near the values.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/algebra/Core_solver.h>
#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>
#include <CGAL/Seamless_snapping/internal/algebra/Least_squares_projection.h>
#include <CGAL/Seamless_snapping/internal/algebra/Unit_pivot_elimination.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// What is to be snapped, apart from the rows.
struct Grid_point
{
  Grid grid;                      // that `values` refer to
  std::vector<Grid_value> values; // one per column
  std::vector<double> weights;    // one per column, positive
  // Only the columns before this one must be representable; the others are quantities of the system
  // alone, such as translations of branches.
  std::size_t number_of_representable_columns;
  // Whether the solution may lie on a finer grid than the values, where it is much smaller than
  // these: not if other values, which stay on their grid, depend on it.
  bool may_be_finer;
};

// Where the unknowns end up, and the real-valued optimum that was approximated, on one grid.
struct Grid_solution
{
  Grid grid;
  std::vector<std::int64_t> x;
  std::vector<Grid_value> target;
};

// Invariant: the elimination of the system is complete. With 64-bit integers the constructor may throw
// `Integer_overflow`; then the caller starts again with `Exact_integer`.
template <typename Integer>
class Grid_solver
{
public:
  explicit Grid_solver(const Integer_system<Integer>& system)
    : m_system(system), m_elimination(system), m_core(system, m_elimination),
      m_is_free(m_elimination.number_of_columns(), false)
  {
    for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
      m_is_homogeneous = m_is_homogeneous && system.right_hand_side(i) == 0;
      for(const Entry<Integer>* e = system.begin(i); e != system.end(i); ++e)
        m_is_free[std::size_t(e->column)] = true;
    }
    for(const auto& definition : m_elimination.definitions())
      m_is_free[std::size_t(definition.column)] = true;
    for(const auto& pivot : m_elimination.pivots())
      m_is_free[std::size_t(pivot.column)] = false;
    for(const Column_index column : m_core.columns())
      m_is_free[std::size_t(column)] = false;
  }

  // Whether there are solutions over the rationals; false for a contradiction.
  bool is_consistent() const
  {
    return m_elimination.contradictory_rows().empty() && m_core.is_consistent();
  }

  // Rows of which all others are combinations.
  std::vector<Row_index> independent_rows() const
  {
    if(m_core.is_whole())
      return m_core.independent_rows();
    std::vector<bool> is_independent(m_system.number_of_rows(), false);
    for(const Row_index row : m_core.independent_rows())
      is_independent[std::size_t(row)] = true;
    for(const auto& pivot : m_elimination.pivots())
      if(m_elimination.is_original_row(pivot.row))
        is_independent[std::size_t(pivot.row)] = true;
    std::vector<Row_index> rows;
    for(std::size_t i = 0; i < is_independent.size(); ++i)
      if(is_independent[i])
        rows.push_back(Row_index(i));
    return rows;
  }

  // Adds to the figures of other systems.
  void fill_in(Snapping_report& report) const
  {
    const std::size_t core_rank = m_core.independent_rows().size();
    report.linear_solver.number_of_redundant_constraints +=
      m_elimination.redundant_rows().size() + m_core.number_of_redundant_rows();
    report.linear_solver.number_of_non_unit_pivots +=
      m_core.is_whole() ? core_rank - number_of_unit_pivots() : core_rank;
    report.linear_solver.number_of_coefficients += m_system.number_of_entries();
    report.linear_solver.number_of_eliminated_coefficients += m_elimination.number_of_coefficients();
    const Exact_integer largest = (std::max)(Exact_integer(m_elimination.largest_coefficient()),
                                             m_core.largest_coefficient());
    report.linear_solver.coefficient_bits = (std::max)(report.linear_solver.coefficient_bits, bit_length(largest));
    report.linear_solver.largest_coefficient = (std::max)(report.linear_solver.largest_coefficient, CGAL::to_double(largest));
    report.linear_solver.largest_pivot = (std::max)({report.linear_solver.largest_pivot, m_elimination.pivots().empty() ? 0. : 1.,
                                       CGAL::to_double(m_core.largest_pivot())});
    report.linear_solver.multiprecision = report.linear_solver.multiprecision || std::is_same<Integer, Exact_integer>::value;
  }

  // Sec. 4.2 and 4.3, but near the least-squares optimum instead of near the input. Tries grids from the
  // finest that fits the values on. Returns false if there is no solution on any grid that the number
  // type has for values of this size: impossible for homogeneous systems, which 0 solves.
  bool solve(const Grid_point& point, Grid_solution& solution, Step_timer& timer) const
  {
    const Number_format& format = point.grid.format();
    int coarsest = format.maximum_exponent - 1;
    if(!m_is_homogeneous) {
      if(!m_core.right_hand_shift())
        return false;
      coarsest = (std::min)(coarsest, -m_system.right_hand_scale() -
                                        static_cast<int>(*m_core.right_hand_shift()));
    }
    if(coarsest < format.minimum_exponent || !find_target(point, coarsest, solution))
      return false;
    if(m_is_homogeneous)
      pull_into_range(solution);
    add_definitions(solution.target);
    std::vector<double> weights(point.weights);
    weights.resize(solution.target.size(), 1.);
    const Lattice_metric metric = m_core.metric(weights);
    timer.finish("least-squares target");

    for(int excess = 0; (excess = evaluate(point, metric, solution)) > 0;) {
      if(solution.grid.exponent() == coarsest) {
        if(!m_is_homogeneous)
          return false;
        solution.x.assign(solution.x.size(), 0);
        break;
      }
      change_grid((std::min)(solution.grid.exponent() + excess, coarsest), solution);
    }
    solution.x.resize(point.values.size());
    solution.target.resize(point.values.size());
    timer.finish("evaluation");
    return true;
  }

private:
  // Projects the values, and chooses a grid for that: right-hand sides may want a finer one, and so
  // does a projection much smaller than the values. Returns false if no grid holds it.
  bool find_target(const Grid_point& point, const int coarsest, Grid_solution& solution) const
  {
    solution.grid = point.grid;
    solution.target = point.values;
    const std::vector<Row_index> rows = independent_rows();
    // A single solution lies on the coarsest grid.
    const bool may_be_finer = point.may_be_finer && rows.size() < m_system.number_of_columns();
    // Where values shrink by much, each round makes up for the rounding errors of the last one.
    double size = std::numeric_limits<double>::infinity(); // of the target, in steps of the grid
    for(bool again = true; again;) {
      project_to_solutions(m_system, rows, right_hand_shift(solution.grid), point.weights,
                           solution.target);
      const double previous = size;
      size = largest_target(solution);
      again = size >= machine_integer_bound && size < previous / 2;
      int wanted = (std::min)(solution.grid.exponent(), coarsest);
      if(may_be_finer)
        wanted = finer_exponent(solution.grid, size, wanted);
      if(wanted != solution.grid.exponent()) {
        change_grid(wanted, solution);
        size = std::numeric_limits<double>::infinity();
        again = true;
      }
    }
    if(std::isfinite(size) && (size < machine_integer_bound || solution.grid.exponent() < coarsest))
      return true;
    std::fill(solution.target.begin(), solution.target.end(), Grid_value());
    return m_is_homogeneous;
  }

  // That of the finest grid that holds numbers of a size, if it is worth another projection.
  static int finer_exponent(const Grid& grid, const double size, const int exponent)
  {
    constexpr int worthwhile = 4; // bits
    if(size == 0 || !std::isfinite(size))
      return exponent;
    int bits = 0;
    std::frexp(size, &bits);
    const int finest = (std::max)(grid.exponent() + bits - grid.format().digits,
                                  grid.format().minimum_exponent);
    return finest <= exponent - worthwhile ? finest : exponent;
  }

  // How often right-hand sides are doubled on a grid.
  int right_hand_shift(const Grid& grid) const
  {
    return -m_system.right_hand_scale() - grid.exponent();
  }

  std::size_t number_of_unit_pivots() const
  {
    return std::size_t(std::count_if(m_elimination.pivots().begin(), m_elimination.pivots().end(),
                                     [&](const auto& p) { return m_elimination.is_original_row(p.row); }));
  }

  // An optimum beyond the largest number is replaced by the solution on its way to 0 that is not.
  static void pull_into_range(Grid_solution& solution)
  {
    const Number_format& format = solution.grid.format();
    const double limit = std::ldexp(1., format.maximum_exponent - solution.grid.exponent());
    const double largest = largest_target(solution);
    if(!(largest >= limit))
      return;
    const double factor = limit / largest * (1 - std::ldexp(1., 4 - format.digits));
    for(Grid_value& v : solution.target)
      v = {0, to_double(v) * factor};
  }

  // The targets of the elimination's new unknowns.
  void add_definitions(std::vector<Grid_value>& target) const
  {
    for(const Definition<Integer>& definition : m_elimination.definitions()) {
      Grid_value sum;
      for(const Entry<Integer>& e : definition.sum) {
        const double sign = e.coefficient > 0 ? 1 : -1;
        const Grid_value& v = target[std::size_t(e.column)];
        const std::int64_t base = e.coefficient > 0 ? v.base : -v.base;
        if(std::abs(static_cast<double>(sum.base) + static_cast<double>(base)) < machine_integer_bound)
          sum.base += base;
        else
          sum.offset += static_cast<double>(base);
        sum.offset += sign * v.offset;
      }
      target.push_back(sum);
    }
  }

  static void change_grid(const int exponent, Grid_solution& solution)
  {
    for(Grid_value& v : solution.target)
      rescale(v, exponent - solution.grid.exponent());
    solution.grid = Grid(solution.grid.format(), exponent);
  }

  // Infinity if a target is not a number.
  static double largest_target(const Grid_solution& solution)
  {
    double largest = 0;
    for(const Grid_value& v : solution.target) {
      const double size = std::abs(to_double(v));
      if(!(size <= largest))
        largest = std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
    }
    return largest;
  }

  // Chooses the core and the free columns near the target, and computes the implied ones. Returns 0 if
  // all fit, else by how many bits the grid must be coarser.
  int evaluate(const Grid_point& point, const Lattice_metric& metric, Grid_solution& solution) const
  {
    constexpr int many = 10; // for numbers of unknown size beyond 2^62
    // negative only if all right-hand sides are zero
    const std::size_t shift = std::size_t((std::max)(right_hand_shift(solution.grid), 0));
    std::vector<std::int64_t>& x = solution.x;
    x.assign(solution.target.size(), 0);
    if(!m_core.nearest(shift, solution.target, metric, x))
      return many;
    if(m_core.is_whole())
      return excess_of(point, solution);
    for(std::size_t j = 0; j < x.size(); ++j)
      if(m_is_free[j] && !solution.grid.nearest(solution.target[j], x[j]))
        return many;
    for(auto pivot = m_elimination.pivots().rbegin(); pivot != m_elimination.pivots().rend(); ++pivot)
      if(!back_substitute(*pivot, shift, x))
        return many;
    return excess_of(point, solution);
  }

  // By how many bits values exceed the number type.
  static int excess_of(const Grid_point& point, const Grid_solution& solution)
  {
    int excess = 0;
    for(std::size_t j = 0; j < point.number_of_representable_columns; ++j)
      if(!solution.grid.is_representable(solution.x[j]))
        excess = (std::max)({excess, 1, static_cast<int>(bit_length(solution.x[j])) -
                                          solution.grid.format().digits});
    return excess;
  }

  // Eq. (2') for one row, whose pivot is 1 or -1. The sum is exact whatever its order, so Algorithm 5
  // has nothing left to do. Returns false if the value exceeds 2^62.
  bool back_substitute(const typename Unit_pivot_elimination<Integer>::Pivot& pivot,
                       const std::size_t right_hand_shift, std::vector<std::int64_t>& x) const
  {
    const auto& row = m_elimination.row(pivot.row);
    const Integer& b = m_elimination.right_hand_side(pivot.row);
    std::int64_t& value = x[std::size_t(pivot.column)];
    value = 0; // drops out of the sums
    bool negative = false; // the sign of the pivot
    try {
      if(b != 0)
        throw Integer_overflow();
      std::int64_t sum = 0;
      for(const Entry<Integer>& e : row) {
        if(e.column == pivot.column)
          negative = e.coefficient < 0;
        else if(fits_64_bits(e.coefficient))
          sum = difference_with_product(sum, to_64_bits(e.coefficient), x[std::size_t(e.column)]);
        else
          throw Integer_overflow();
      }
      value = negative ? -sum : sum;
      return fits_64_bits(value);
    } catch(const Integer_overflow&) { }

    Exact_integer sum(Exact_integer(b) * power_of_two(right_hand_shift));
    for(const Entry<Integer>& e : row) {
      if(e.column == pivot.column)
        negative = e.coefficient < 0;
      else
        sum -= Exact_integer(Exact_integer(e.coefficient) * Exact_integer(x[std::size_t(e.column)]));
    }
    if(!fits_64_bits(sum))
      return false;
    value = negative ? -to_64_bits(sum) : to_64_bits(sum);
    return true;
  }

  const Integer_system<Integer>& m_system;
  Unit_pivot_elimination<Integer> m_elimination;
  Core_solver<Integer> m_core;
  std::vector<bool> m_is_free; // in a row, but neither implied nor in the core
  bool m_is_homogeneous = true;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_GRID_SOLVER_H
