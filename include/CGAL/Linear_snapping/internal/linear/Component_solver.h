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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_COMPONENT_SOLVER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_COMPONENT_SOLVER_H

#include <CGAL/license/Linear_snapping.h>

// Joins elimination, target, and evaluation for one component of a system: real values on a grid
// become integers that solve the rows exactly, near the values.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Core_solver.h>
#include <CGAL/Linear_snapping/internal/linear/Least_squares_projection.h>
#include <CGAL/Linear_snapping/internal/linear/Linear_solution.h>
#include <CGAL/Linear_snapping/internal/linear/eliminate.h>
#include <CGAL/Linear_snapping/internal/linear/lattice_reduction.h>
#include <CGAL/Linear_snapping/internal/linear/triangular_form.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/types/Linear_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Values or solutions of one component, on a grid.
struct Component_solution
{
  Grid grid;
  std::vector<std::int64_t> x;
  std::vector<Grid_value> optimum; // before it is found: the values to be snapped
};

// Invariant: the elimination of the component is complete. What depends on the weights, too, is
// computed when it is needed first, and kept.
class Component_solver
{
public:
  // Throws `Work_exceeded` if the elimination or rows without a unit take too long, and it may be
  // finer.
  // \param input is kept by reference
  Component_solver(const Component_input& input, const Number_format& format,
                   const bool may_be_finer)
    : m_system(input.system), m_weights(input.weights), m_format(format),
      m_number_of_representable_columns(input.number_of_representable_columns),
      m_may_be_finer(may_be_finer)
  {
    std::optional<Echelon_form> form;
    if(may_be_finer) // multiples are too coarse for faces
      form = triangular_form(m_system);
    m_form = form ? std::move(*form) : eliminate(m_system, work_limit());
    if(!m_form.rows_in_core.empty()) {
      m_core = whole_system();
      if(m_core == nullptr)
        m_core = std::make_unique<Core_solver>(m_system, m_form, false, work_limit());
    }
    std::vector<bool> is_free(m_form.pivot_rows.number_of_columns(), true);
    for(const Column_index column : m_form.pivot_columns)
      is_free[std::size_t(column)] = false;
    if(m_core != nullptr)
      for(const Column_index column : m_core->columns())
        is_free[std::size_t(column)] = false;
    m_free_columns.reserve(is_free.size());
    for(std::size_t j = 0; j < is_free.size(); ++j)
      if(is_free[j])
        m_free_columns.push_back(Column_index(j));
    for(std::size_t i = 0; i < m_system.number_of_rows(); ++i)
      m_is_homogeneous = m_is_homogeneous && !m_system.has_right_hand_side(i);
  }

  const Integer_system& system() const { return m_system; }
  const std::vector<double>& weights() const { return m_weights; }

  // Whether there are solutions over the rationals.
  bool is_consistent() const
  {
    return m_form.contradictory_rows.empty() && (m_core == nullptr || m_core->is_consistent());
  }

  // Whether there may be solutions among numbers with a finite binary expansion.
  bool is_dyadic() const
  { return m_is_homogeneous || m_core == nullptr || m_core->right_hand_shift(); }

  // Multiples of rows that add up to 0 = c with c != 0.
  // \pre !is_consistent()
  std::vector<std::pair<std::size_t, Exact_rational> > contradiction() const
  {
    if(!m_form.contradictory_rows.empty())
      return multipliers_of_rows(m_system, m_form, {{std::size_t(m_form.contradictory_rows.front()),
                                                     Exact_integer(1)}});
    const Certificate multiples = m_core->contradiction();
    if(!is_whole())
      return multipliers_of_rows(m_system, m_form, multiples);
    std::vector<std::pair<std::size_t, Exact_rational> > result;
    for(const auto& multiple : multiples)
      result.emplace_back(multiple.first, Exact_rational(multiple.second));
    return result;
  }

  // Adds to the figures of other components.
  void add_to(Linear_solver_figures& figures) const
  {
    const std::size_t core_rank = m_core == nullptr ? 0 : m_core->independent_rows().size();
    figures.number_of_redundant_constraints +=
      m_form.redundant_rows.size() + (m_core == nullptr ? 0 : m_core->number_of_redundant_rows());
    figures.number_of_non_unit_pivots +=
      is_whole() ? core_rank - m_form.rows_with_pivot.size()
                 : core_rank + m_form.number_of_non_unit_pivots;
    figures.number_of_coefficients += m_system.number_of_entries();
    figures.number_of_eliminated_coefficients += m_form.number_of_coefficients;
    Exact_integer largest = m_form.largest_coefficient;
    double largest_pivot = m_form.pivot_columns.empty() ? 0 : double(m_form.largest_pivot);
    if(m_core != nullptr) {
      largest = (std::max)(largest, m_core->largest_coefficient());
      largest_pivot = (std::max)(largest_pivot, CGAL::to_double(m_core->largest_pivot()));
    }
    figures.coefficient_bits = (std::max)(figures.coefficient_bits, bit_length(largest));
    figures.largest_coefficient =
      (std::max)(figures.largest_coefficient, CGAL::to_double(largest));
    figures.largest_pivot = (std::max)(figures.largest_pivot, largest_pivot);
    figures.multiprecision = figures.multiprecision || m_form.is_multiprecision;
  }

  // [MC19] Sec. 4.2 and 4.3, but near the least-squares optimum instead of near the input. Tries
  // grids from the finest that fits the values on. Returns false if there is no solution on any
  // grid that the number type has for values of this size: impossible for homogeneous systems,
  // which 0 solves.
  // \pre is_consistent()
  bool solve(Component_solution& solution, Step_timer* const timer = nullptr) const
  {
    const int coarsest = coarsest_exponent();
    const Component_solution values(solution);
    if(coarsest < m_format.minimum_exponent || !find_optimum(coarsest, solution))
      return false;
    if(m_is_homogeneous)
      pull_into_range(solution);
    finish(timer, "least-squares target");
    const bool found = evaluate_near(values, coarsest, solution);
    finish(timer, "evaluation");
    return found;
  }

  // Moves the values to the least-squares optimum, on a grid that holds it, whether or not there
  // are solutions on that. Returns false if no grid of the number type does.
  bool find_optimum(Component_solution& solution) const
  {
    return find_optimum(m_format.maximum_exponent - 1, solution);
  }

  // How the optimum answers to shifts of the values.
  Eigen::VectorXd displacements(const Eigen::VectorXd& shifts) const
  {
    const Least_squares_projection& target = projection(); // which chooses the system
    if(!m_is_projected_in_form)
      return target.nearest_difference(shifts);
    Eigen::VectorXd all(Eigen::Index(m_form.pivot_rows.number_of_columns()));
    Eigen::Index size = shifts.size();
    all.head(size) = shifts;
    for(const Entries<std::int64_t>& terms : m_form.auxiliary_unknowns) {
      all[size] = 0;
      for(const Entry<std::int64_t>& e : terms)
        all[size] += double(e.coefficient) * all[e.column];
      ++size;
    }
    return target.nearest_difference(all).head(shifts.size());
  }

private:
  static constexpr std::size_t most_rows_to_reduce = 300;
  static constexpr double most_work = 3e10; // multiplications: about a minute
  static constexpr double most_work_of_whole_system = 1e10;
  static constexpr double work_of_short_factorization = 1e9; // about a second
  static constexpr int most_bits_at_once = 40; // of a finer grid, for the errors

  double work_limit() const
  { return m_may_be_finer ? most_work : std::numeric_limits<double>::infinity(); }

  static void finish(Step_timer* const timer, const char* step)
  {
    if(timer != nullptr)
      timer->finish(step);
  }

  // The exponent of the coarsest grid that has solutions; too small for any if none has.
  int coarsest_exponent() const
  {
    const int coarsest = m_format.maximum_exponent - 1;
    if(m_is_homogeneous)
      return coarsest;
    if(!is_dyadic())
      return m_format.minimum_exponent - 1;
    const int shift = m_core == nullptr ? m_form.right_hand_halvings
                                        : static_cast<int>(*m_core->right_hand_shift());
    return (std::min)(coarsest, -m_system.right_hand_scale() - shift);
  }

  // None if it has too many columns, or would take too long.
  std::unique_ptr<Core_solver> whole_system() const
  {
    m_may_be_whole = m_may_be_whole &&
                     m_system.number_of_columns() <= Core_solver::largest_whole_system;
    if(m_may_be_whole)
      try {
        return std::make_unique<Core_solver>(m_system, m_form, true, most_work_of_whole_system);
      } catch(const Work_exceeded&) {
        m_may_be_whole = false;
      }
    return nullptr;
  }

  bool is_whole() const { return m_core != nullptr && m_core->is_whole(); }

  // Rows of which all others are combinations.
  std::vector<Row_index> independent_rows() const
  {
    std::vector<Row_index> rows;
    if(m_core != nullptr)
      rows = m_core->independent_rows();
    if(is_whole())
      return rows;
    rows.insert(rows.end(), m_form.rows_with_pivot.begin(), m_form.rows_with_pivot.end());
    std::sort(rows.begin(), rows.end());
    return rows;
  }

  // The work of a factorization from which on the null space takes less; infinite if elimination
  // did not end with a triangular form of the unknowns, or if both take too much.
  double work_before_null_space() const
  {
    constexpr double least = 1e6;  // multiplications: about a millisecond
    constexpr double factor = 4;   // leaves solutions as they are if little is gained
    const Integer_system& form = m_form.pivot_rows;
    if(m_core != nullptr || !m_form.multiples.empty())
      return std::numeric_limits<double>::infinity();
    const double work = Null_space_solver::work(double(form.number_of_columns()),
                                                double(form.number_of_rows()),
                                                double(form.number_of_entries()));
    return work > most_work ? std::numeric_limits<double>::infinity()
                            : (std::max)(least, factor * work);
  }

  // Nothing if most digits would be lost.
  std::unique_ptr<Least_squares_projection> projection_by_null_space() const
  {
    std::vector<Row_index> all_rows(m_form.pivot_rows.number_of_rows());
    std::iota(all_rows.begin(), all_rows.end(), 0);
    auto result = std::make_unique<Least_squares_projection>(m_form.pivot_rows,
                                                             m_form.pivot_columns,
                                                             m_weights.size(), all_rows,
                                                             all_weights());
    if(result->is_ill_conditioned())
      return nullptr;
    m_is_projected_in_form = true;
    return result;
  }

  // A factorization, unless another way takes less work.
  std::unique_ptr<Least_squares_projection>
  cheapest_projection(const std::vector<Row_index>& rows) const
  {
    const double before_null_space = work_before_null_space();
    const double most_at_first = (std::min)(before_null_space, work_of_short_factorization);
    auto result = std::make_unique<Least_squares_projection>(m_system, rows, m_weights,
                                                             most_at_first);
    const double work = result->work_of_factorization();
    if(work <= most_at_first)
      return result;
    if(work > before_null_space)
      if(auto by_null_space = projection_by_null_space())
        return by_null_space;
    if(work > work_of_short_factorization && result->iterate())
      return result;
    if(work > work_limit())
      throw Work_exceeded();
    return std::make_unique<Least_squares_projection>(m_system, rows, m_weights);
  }

  const Integer_system& projected_system() const
  {
    return m_is_projected_in_form ? m_form.pivot_rows
           : m_reduced_rows == nullptr ? m_system : *m_reduced_rows;
  }

  const Least_squares_projection& projection() const
  {
    if(m_projection != nullptr)
      return *m_projection;
    const std::vector<Row_index> rows = independent_rows();
    m_projection = cheapest_projection(rows);
    if(m_projection->is_ill_conditioned() && rows.size() <= most_rows_to_reduce) {
      m_reduced_rows = std::make_unique<Integer_system>(reduced_rows(m_system, rows, m_weights));
      std::vector<Row_index> all_rows(rows.size());
      std::iota(all_rows.begin(), all_rows.end(), 0);
      m_projection =
        std::make_unique<Least_squares_projection>(*m_reduced_rows, all_rows, m_weights);
    }
    return *m_projection;
  }

  // The weights of all unknowns; auxiliary unknowns have 1.
  std::vector<double> all_weights() const
  {
    std::vector<double> weights(m_weights);
    weights.resize(m_form.pivot_rows.number_of_columns(), 1.);
    return weights;
  }

  // Finds integers near the optimum by back-substitution or, where this leads far away, by lattice
  // reduction.
  bool evaluate_near(const Component_solution& values, const int coarsest,
                     Component_solution& solution) const
  {
    Component_solution nearest(solution);
    bool found = evaluate_on_grids(m_core.get(), coarsest, nearest);
    if(!is_whole() && m_may_be_whole && (!found || is_far(values, solution, nearest))) {
      if(m_whole == nullptr)
        m_whole = whole_system();
      Component_solution other(solution);
      if(m_whole != nullptr && evaluate_on_grids(m_whole.get(), coarsest, other) &&
         !(found && distance(other) >= distance(nearest))) {
        nearest = std::move(other);
        found = true;
      }
    }
    solution = std::move(nearest);
    return found;
  }

  // Evaluates on the finest grid that the number type has for the result.
  bool evaluate_on_grids(const Core_solver* const core, const int coarsest,
                         Component_solution& solution) const
  {
    add_auxiliary_unknowns(solution.optimum);
    int excess = 0;
    while((excess = evaluate(core, solution)) > 0 && solution.grid.exponent() != coarsest)
      change_grid((std::min)(solution.grid.exponent() + excess, coarsest), solution);
    if(excess > 0 && m_is_homogeneous)
      solution.x.assign(solution.x.size(), 0);
    solution.x.resize(m_system.number_of_columns());
    solution.optimum.resize(m_system.number_of_columns());
    return excess == 0 || m_is_homogeneous;
  }

  // Whether a solution is several times as far from the optimum as the values are, or as the grid
  // makes necessary.
  // \param optimum on any grid
  bool is_far(const Component_solution& values, const Component_solution& optimum,
              const Component_solution& solution) const
  {
    double change = 0, distance = 0; // in steps of the optimum's grid
    const int shift = optimum.grid.exponent() - values.grid.exponent();
    const double unit =
      std::ldexp(1., solution.grid.exponent() - optimum.grid.exponent());
    for(std::size_t j = 0; j < m_number_of_representable_columns; ++j) {
      Grid_value v = values.optimum[j];
      rescale(v, shift);
      change = (std::max)(change, std::abs(difference(optimum.optimum[j], v)));
      const double rest = difference(solution.optimum[j], Grid_value{solution.x[j], 0});
      distance = (std::max)(distance, std::abs(rest) * unit);
    }
    return distance > 4 * (change + 1 + static_cast<double>(solution.x.size() / 16));
  }

  // The weighted distance of a solution from the optimum.
  double distance(const Component_solution& solution) const
  {
    double squares = 0;
    for(std::size_t j = 0; j < solution.x.size(); ++j) {
      const double d = difference(solution.optimum[j], Grid_value{solution.x[j], 0});
      squares += m_weights[j] * d * d;
    }
    return std::sqrt(squares) * solution.grid.step();
  }

  // Projects the values, and chooses a grid for that: right-hand sides may want a finer one, and so
  // does a projection much smaller than the values. Returns false if no grid holds it.
  bool find_optimum(const int coarsest, Component_solution& solution) const
  {
    // A single solution lies on the coarsest grid.
    const bool may_be_finer =
      m_may_be_finer && projection().number_of_rows() < projected_system().number_of_columns();
    // If values shrink by much, each round makes up for the rounding errors of the last one.
    double size = std::numeric_limits<double>::infinity(); // the optimum, in steps of the grid
    for(bool again = true; again;) {
      const Least_squares_projection& target = projection(); // which chooses the system
      if(m_is_projected_in_form)
        add_auxiliary_unknowns(solution.optimum);
      target.project(projected_system(), right_hand_shift(solution.grid), solution.optimum);
      solution.optimum.resize(m_weights.size());
      const double previous = size;
      size = largest_value(solution);
      again = size >= machine_integer_bound && size < previous / 2;
      int wanted = (std::min)(solution.grid.exponent(), coarsest);
      if(may_be_finer)
        wanted = finer_exponent(solution.grid, size, wanted);
      if(wanted != solution.grid.exponent()) {
        change_grid((std::max)(wanted, solution.grid.exponent() - most_bits_at_once), solution);
        size = std::numeric_limits<double>::infinity();
        again = true;
      }
    }
    if(std::isfinite(size) && (size < machine_integer_bound || solution.grid.exponent() < coarsest))
      return true;
    std::fill(solution.optimum.begin(), solution.optimum.end(), Grid_value());
    return m_is_homogeneous;
  }

  // The exponent of the finest grid for numbers of a size, if it is worth another projection.
  int finer_exponent(const Grid& grid, const double size, const int exponent) const
  {
    constexpr int worthwhile = 4; // bits
    if(size == 0 || !std::isfinite(size))
      return exponent;
    int bits = 0;
    std::frexp(size, &bits);
    const int finest = (std::max)(grid.exponent() + bits - m_format.digits,
                                  m_format.minimum_exponent);
    return finest <= exponent - worthwhile ? finest : exponent;
  }

  // How often right-hand sides are doubled on a grid.
  int right_hand_shift(const Grid& grid) const
  {
    return -m_system.right_hand_scale() - grid.exponent();
  }

  // An optimum beyond the largest number is replaced by the solution on its way to 0 that is not.
  void pull_into_range(Component_solution& solution) const
  {
    const int exponent = m_format.maximum_exponent - solution.grid.exponent();
    if(exponent >= std::numeric_limits<double>::max_exponent) // no numbers are that large
      return;
    const double limit = std::ldexp(1., exponent);
    const double largest = largest_value(solution);
    if(!(largest >= limit))
      return;
    const double factor = limit / largest * (1 - std::ldexp(1., 4 - m_format.digits));
    for(Grid_value& v : solution.optimum)
      v = {0, to_double(v) * factor};
  }

  void add_auxiliary_unknowns(std::vector<Grid_value>& optimum) const
  {
    for(const Entries<std::int64_t>& terms : m_form.auxiliary_unknowns) {
      Grid_value sum;
      for(const Entry<std::int64_t>& e : terms) {
        const Grid_value& v = optimum[std::size_t(e.column)];
        const std::int64_t base = e.coefficient * v.base;
        if(std::abs(static_cast<double>(sum.base) + static_cast<double>(base)) <
           machine_integer_bound)
          sum.base += base;
        else
          sum.offset += static_cast<double>(base);
        sum.offset += static_cast<double>(e.coefficient) * v.offset;
      }
      optimum.push_back(sum);
    }
  }

  void change_grid(const int exponent, Component_solution& solution) const
  {
    for(Grid_value& v : solution.optimum)
      rescale(v, exponent - solution.grid.exponent());
    solution.grid = Grid(m_format, exponent);
  }

  // Infinity if a value is not a number.
  static double largest_value(const Component_solution& solution)
  {
    double largest = 0;
    for(const Grid_value& v : solution.optimum) {
      const double size = std::abs(to_double(v));
      if(!(size <= largest))
        largest = std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
    }
    return largest;
  }

  // Chooses the core and the free columns near the optimum, and computes the implied ones. Returns
  // 0 if all fit, else by how many bits the grid must be coarser.
  int evaluate(const Core_solver* const core, Component_solution& solution) const
  {
    constexpr int many = 10; // for numbers of unknown size beyond 2^62
    // negative only if all right-hand sides are zero
    const int shift = (std::max)(right_hand_shift(solution.grid), 0);
    std::vector<std::int64_t>& x = solution.x;
    x.assign(solution.optimum.size(), 0);
    if(core != nullptr && !core->nearest(std::size_t(shift), solution.optimum, all_weights(), x))
      return many;
    if(core == nullptr || !core->is_whole()) {
      for(const Column_index column : m_free_columns)
        if(!nearest(column, solution))
          return many;
      for(std::size_t i = m_form.pivot_columns.size(); i-- > 0;)
        if(!back_substitute(i, shift, x))
          return many;
    }
    return excess_of(solution);
  }

  // By how many bits values exceed the number type.
  int excess_of(const Component_solution& solution) const
  {
    int excess = 0;
    for(std::size_t j = 0; j < m_number_of_representable_columns; ++j)
      if(!solution.grid.is_representable(solution.x[j]))
        excess = (std::max)({excess, 1, static_cast<int>(bit_length(solution.x[j])) -
                                          m_format.digits});
    return excess;
  }

  // Chooses a free unknown; false if it exceeds 2^62.
  bool nearest(const Column_index column, Component_solution& solution) const
  {
    const Grid_value& v = solution.optimum[std::size_t(column)];
    std::int64_t& x = solution.x[std::size_t(column)];
    if(m_form.multiples.empty())
      return solution.grid.nearest(v, x);
    const std::int64_t multiple = m_form.multiples[std::size_t(column)];
    const double rest = double(v.base % multiple) + v.offset;
    std::int64_t number = 0;
    x = 0;
    return solution.grid.nearest({v.base / multiple, rest / double(multiple)}, number) &&
           add_product(multiple, number, x);
  }

  // [MC19] Eq. (2') for one pivot row, which its pivot divides. The sum is exact in any order,
  // so Algorithm 5 has nothing left to do. Returns false if the value exceeds 2^62.
  bool back_substitute(const std::size_t row, const int right_hand_shift,
                       std::vector<std::int64_t>& x) const
  {
    const Integer_system& rows = m_form.pivot_rows;
    const Column_index column = m_form.pivot_columns[row];
    std::int64_t& value = x[std::size_t(column)];
    value = 0; // drops out of the sum
    std::int64_t sum = 0, pivot = 1; // the sum of the row, minus b
    bool fits = rows.is_small(row) && shifted(-rows.right_hand_side(row), right_hand_shift, sum);
    if(fits)
      for(const Entry<std::int64_t>& e : rows.row(row)) {
        if(e.column == column)
          pivot = e.coefficient;
        fits = fits && add_product(e.coefficient, x[std::size_t(e.column)], sum);
      }
    if(!fits && !large_sum(rows.exact_row(row), right_hand_shift, x, column, sum, pivot))
      return false;
    value = -sum / pivot;
    return fits_64_bits(value);
  }

  // Returns false if the sum exceeds 2^62.
  static bool large_sum(const Integer_row<Exact_integer>& row, const int right_hand_shift,
                        const std::vector<std::int64_t>& x, const Column_index column,
                        std::int64_t& sum, std::int64_t& pivot)
  {
    Exact_integer exact_sum = product(row.right_hand_side,
                                      power_of_two(std::size_t(right_hand_shift)));
    exact_sum = difference(Exact_integer(0), exact_sum);
    for(const Entry<Exact_integer>& e : row.entries)
      if(e.column == column)
        pivot = to_64_bits(e.coefficient);
      else
        exact_sum += product(e.coefficient, Exact_integer(x[std::size_t(e.column)]));
    if(!fits_64_bits(exact_sum))
      return false;
    sum = to_64_bits(exact_sum);
    return true;
  }

  const Integer_system& m_system;
  const std::vector<double>& m_weights;
  Number_format m_format;
  std::size_t m_number_of_representable_columns;
  bool m_may_be_finer;
  Echelon_form m_form;
  std::unique_ptr<Core_solver> m_core; // if there are core rows
  std::vector<Column_index> m_free_columns; // neither implied nor in the core
  bool m_is_homogeneous = true;
  mutable std::unique_ptr<Least_squares_projection> m_projection;
  mutable std::unique_ptr<Integer_system> m_reduced_rows; // its rows, if not the system's
  mutable bool m_is_projected_in_form = false;            // its rows are pivot rows
  mutable std::unique_ptr<Core_solver> m_whole; // if back-substitution led far away
  mutable bool m_may_be_whole = true;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_COMPONENT_SOLVER_H
