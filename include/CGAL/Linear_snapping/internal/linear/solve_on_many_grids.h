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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H

#include <CGAL/license/Linear_snapping.h>

// A grid for each unknown, if one grid for all unknowns has no solution near by. Its spacing comes
// from the size of the unknown ([MC19] Sec. 4.3). If a right-hand side needs a finer grid, the
// value has to shrink. Columns are scaled by powers of two; the remaining problem is a lattice with
// bounds.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/linear/Component_solver.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_lattice.h>
#include <CGAL/Linear_snapping/internal/linear/Linear_solution.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Weights times 2^exponents, all times the same power of two. They are in the range of the squares
// of values within 2^(+-400).
inline std::vector<double> times_powers_of_two(const std::vector<double>& weights,
                                               const std::vector<long>& exponents)
{
  constexpr long largest_exponent = 800; // squares of 64-bit integers times roots do not overflow
  long largest = (std::numeric_limits<long>::min)();
  for(std::size_t j = 0; j < weights.size(); ++j)
    largest = (std::max)(largest, std::ilogb(weights[j]) + exponents[j]);
  std::vector<double> result;
  for(std::size_t j = 0; j < weights.size(); ++j) {
    const int bits = std::ilogb(weights[j]);
    const long exponent =
      (std::max)(largest_exponent + bits + exponents[j] - largest, -largest_exponent);
    result.push_back(std::ldexp(weights[j], static_cast<int>(exponent) - bits));
  }
  return result;
}

// Invariant: each unknown is to be an integer of at most p bits, times the step of its grid, near
// its target there.
class Many_grids_solver
{
public:
  static constexpr std::size_t most_columns = 200;
  static constexpr double most_work = 1e10; // multiplications of words: some seconds

  // \param target real values that solve the system
  Many_grids_solver(const Integer_system& system, const std::vector<double>& weights,
                    const Component_solution& target)
    : m_system(system), m_weights(weights), m_format(target.grid.format()),
      m_largest(std::ldexp(1., m_format.digits))
  {
    for(const Grid_value& v : target.optimum) {
      m_columns.push_back({exponent_of_value(target.grid, v), v, false});
      rescale(m_columns.back().target, m_columns.back().exponent - target.grid.exponent());
    }
  }

  // If no integers solve the system, or too large ones only, a grid becomes finer or coarser, or a
  // target smaller, and the search begins again. Returns false if this finds no solution soon.
  bool solve()
  try {
    constexpr int most_rounds = 12;
    double work_left = most_work;
    for(int round = 0; round < most_rounds; ++round) {
      const Scaled_rows rows = scaled_rows();
      const Integer_lattice lattice(rows.system, work_left);
      const Lattice_metric metric = lattice.metric(scaled_weights(), lattice.work_left());
      work_left = metric.work_left();
      std::vector<Grid_value> targets;
      for(const Column& column : m_columns)
        targets.push_back(column.target);
      Lattice_solution found =
        lattice.nearest_solution(rows.right_hand_side, targets, metric);
      if(found.solvability != Solvability::SOLVABLE) {
        if(!found.is_dyadic || !refine_one(found.certificate.multipliers, rows))
          return false;
      } else if(is_representable(found.values)) {
        m_values = std::move(found.values);
        return true;
      } else if(!make_room(found.values)) {
        return false;
      }
    }
    return false;
  } catch(const Work_exceeded&) {
    return false;
  }

  // \pre `solve()` has returned `true`
  Grid grid(const std::size_t j) const { return Grid(m_format, m_columns[j].exponent); }
  std::int64_t value(const std::size_t j) const { return to_64_bits(m_values[j]); }

private:
  struct Column
  {
    int exponent;      // grid
    Grid_value target; // on the grid
    bool is_held;      // at the target: all others are less important
  };

  // C x = b in terms of the multiples of 2^exponents that x are made of.
  struct Scaled_rows
  {
    Integer_system system;
    std::vector<Exact_integer> right_hand_side;
  };

  // The exponent of the finest grid that holds a number near v, given in steps of another grid.
  static int exponent_of_value(const Grid& grid, const Grid_value& v)
  {
    const Number_format& format = grid.format();
    int exponent = 0;
    const double mantissa = std::frexp(to_double(v), &exponent);
    if(std::abs(mantissa) == 0.5 && v.offset * mantissa < 0)
      --exponent; // just below a power of two
    return (std::max)(grid.exponent() + exponent - format.digits, format.minimum_exponent);
  }

  Scaled_rows scaled_rows() const
  {
    Scaled_rows result{Integer_system(m_columns.size()), {}};
    for(std::size_t i = 0; i < m_system.number_of_rows(); ++i) {
      Integer_row<Exact_integer> row = m_system.exact_row(i);
      Exact_integer& b = row.right_hand_side;
      int finest = b == 0 ? (std::numeric_limits<int>::max)() : -m_system.right_hand_scale();
      for(const Entry<Exact_integer>& e : row.entries)
        finest = (std::min)(finest, exponent(e));
      for(Entry<Exact_integer>& e : row.entries)
        e.coefficient = product(e.coefficient, power_of_two(std::size_t(exponent(e) - finest)));
      if(b != 0)
        b = product(b, power_of_two(std::size_t(-m_system.right_hand_scale() - finest)));
      result.right_hand_side.push_back(std::move(b));
      b = Exact_integer(0);
      result.system.add_row(std::move(row));
    }
    return result;
  }

  int exponent(const Entry<Exact_integer>& e) const
  { return m_columns[std::size_t(e.column)].exponent; }

  // In units of the columns' grids.
  std::vector<double> scaled_weights() const
  {
    constexpr double heavy = 0x1p40;
    std::vector<long> exponents;
    for(const Column& column : m_columns)
      exponents.push_back(2L * column.exponent);
    std::vector<double> result = times_powers_of_two(m_weights, exponents);
    const double largest = *std::max_element(result.begin(), result.end());
    for(std::size_t j = 0; j < m_columns.size(); ++j)
      if(m_columns[j].is_held)
        result[j] = heavy * largest;
    return result;
  }

  // The sum of multiples of the rows is a row of which all integers X make a number with more twos
  // than its right-hand side has: one of the unknowns must have a finer grid. It is the one that
  // has to move least to be small enough for that.
  bool refine_one(const std::vector<Exact_integer>& multipliers, const Scaled_rows& rows)
  {
    std::vector<Exact_integer> sums(m_columns.size(), Exact_integer(0));
    Exact_integer right_hand_side(0);
    for(std::size_t i = 0; i < multipliers.size(); ++i) {
      for(const Entry<Exact_integer>& e : rows.system.exact_row(i).entries)
        sums[std::size_t(e.column)] += product(multipliers[i], e.coefficient);
      right_hand_side += product(multipliers[i], rows.right_hand_side[i]);
    }
    const int twos = number_of_halvings(right_hand_side);
    double least = std::numeric_limits<double>::infinity();
    Column* best = nullptr;
    int best_bits = 0;
    for(std::size_t j = 0; j < sums.size(); ++j) {
      const int bits = sums[j] == 0 ? 0 : number_of_halvings(sums[j]) - twos;
      if(bits <= 0 || m_columns[j].exponent - bits < m_format.minimum_exponent)
        continue;
      const double size = std::abs(to_double(m_columns[j].target));
      const double way = (std::max)(0., size - std::ldexp(m_largest, -bits)); // in steps
      const double cost = std::sqrt(m_weights[j]) * std::ldexp(way, m_columns[j].exponent);
      if(cost < least) {
        least = cost;
        best = &m_columns[j];
        best_bits = bits;
      }
    }
    if(best == nullptr)
      return false;
    change_grid(*best, -best_bits);
    if(std::abs(to_double(best->target)) > m_largest)
      hold(*best, m_largest);
    return true;
  }

  static void change_grid(Column& column, const int bits)
  {
    column.exponent += bits;
    rescale(column.target, bits);
  }

  static void hold(Column& column, const double size)
  {
    const double target = to_double(column.target) < 0 ? -size : size;
    column.target = {static_cast<std::int64_t>(target), 0};
    column.is_held = true;
  }

  bool is_representable(const std::size_t j, const Exact_integer& x) const
  { return fits_64_bits(x) && grid(j).is_representable(to_64_bits(x)); }

  bool is_representable(const std::vector<Exact_integer>& x) const
  {
    for(std::size_t j = 0; j < x.size(); ++j)
      if(!is_representable(j, x[j]))
        return false;
    return true;
  }

  // Targets of values that are too large move away from the bound, by more from time to time, as
  // long as that is a small part of their size; else grids become coarser.
  bool make_room(const std::vector<Exact_integer>& x)
  {
    for(std::size_t j = 0; j < x.size(); ++j) {
      if(is_representable(j, x[j]))
        continue;
      Column& column = m_columns[j];
      const Exact_integer base = from_64_bits<Exact_integer>(column.target.base);
      const double distance = std::abs(CGAL::to_double(difference(x[j], base)));
      const double size = (std::min)(std::abs(to_double(column.target)), m_largest);
      if(2 * distance < size)
        hold(column, size - 2 * distance);
      else if(column.is_held)
        return false;
      else
        change_grid(column, (std::max)(1, static_cast<int>(bit_length(x[j])) - m_format.digits));
    }
    return true;
  }

  const Integer_system& m_system;
  const std::vector<double>& m_weights;
  const Number_format m_format;
  const double m_largest; // all integers up to it are numbers of the format
  std::vector<Column> m_columns;
  std::vector<Exact_integer> m_values;
};

// By which all values change by about the same factor.
inline std::vector<double> relative_weights(const std::vector<double>& weights,
                                            const std::vector<Grid_value>& values)
{
  int smallest = (std::numeric_limits<int>::max)();
  for(const Grid_value& v : values)
    if(to_double(v) != 0)
      smallest = (std::min)(smallest, std::ilogb(to_double(v)));
  std::vector<long> exponents;
  for(const Grid_value& v : values)
    exponents.push_back(-2L * (to_double(v) == 0 ? smallest : std::ilogb(to_double(v))));
  return times_powers_of_two(weights, exponents);
}

// Solves a component on a grid for each of its columns: near its optimum, and near the optimum of
// relative changes, which keeps small values small, so that they have fine grids. Returns the
// solution that is nearer to the optimum, if there is one.
inline std::optional<std::vector<Column_solution> >
solve_on_many_grids(const Component_solver& solver, const Component_solution& values)
{
  const std::size_t n = values.optimum.size();
  Component_solution optimum(values);
  if(n > Many_grids_solver::most_columns || !solver.is_dyadic() || !solver.find_optimum(optimum))
    return std::nullopt;
  const Component_input relative{solver.system(),
                                 relative_weights(solver.weights(), values.optimum), n};
  const Component_solver relative_solver(relative, values.grid.format(), true);
  std::optional<std::vector<Column_solution> > best;
  double least_distance = 0;
  for(const Component_solver* const other : {&solver, &relative_solver}) {
    Component_solution target(values);
    if(!other->find_optimum(target))
      continue;
    Many_grids_solver many_grids(other->system(), other->weights(), target);
    if(!many_grids.solve())
      continue;
    std::vector<Column_solution> columns;
    Magnitudes distances;
    for(std::size_t j = 0; j < n; ++j) {
      const Grid grid = many_grids.grid(j);
      Grid_value v = optimum.optimum[j];
      rescale(v, grid.exponent() - optimum.grid.exponent());
      columns.push_back({grid, many_grids.value(j), v});
      distances.add(difference(v, {columns.back().x, 0}) * grid.step(), solver.weights()[j]);
    }
    if(best && distances.root_mean_square() >= least_distance)
      continue;
    least_distance = distances.root_mean_square();
    best = std::move(columns);
  }
  return best;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SOLVE_ON_MANY_GRIDS_H
