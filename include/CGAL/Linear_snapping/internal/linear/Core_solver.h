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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CORE_SOLVER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CORE_SOLVER_H

#include <CGAL/license/Linear_snapping.h>

// Solves the core of a system, the rows without unit pivots, by the complete integer solver. Most
// systems have no core. In a large system, the core is the rows that the elimination left. In a
// small one, it is all given rows that are not redundant: implied unknowns amplify changes of the
// core, and the solution is to be near in all unknowns.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_lattice.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Invariant: without core rows, all is empty, consistent, and solved.
class Core_solver
{
public:
  static constexpr std::size_t largest_whole_system = 2000; // columns

  // \param most_work as for `Kernel_lattice`
  Core_solver(const Integer_system& system, const Echelon_form& form, const bool is_whole,
              const double most_work)
    : m_is_whole(is_whole),
      m_lattice(m_is_whole ? whole_system(system, form) : core_of(form), most_work)
  {
    for(const Row_index i : m_lattice.independent_rows())
      m_independent_rows.push_back(m_rows[std::size_t(i)]);
    const Lattice_solution solution = m_lattice.some_solution(m_right_hand_side);
    m_is_consistent = solution.solvability != Solvability::INCONSISTENT;
    if(solution.solvability == Solvability::SOLVABLE)
      m_right_hand_shift = 0;
    else if(m_is_consistent && solution.is_dyadic)
      m_right_hand_shift = solution.power_of_two;
  }

  // Whether all rows of the system are here, but for redundant ones, so that back-substitution has
  // nothing left to do.
  bool is_whole() const { return m_is_whole; }

  // Whether there are solutions over the rationals.
  bool is_consistent() const { return m_is_consistent; }

  // How often the right-hand sides must be doubled at least for an integer solution; none if no
  // number of times is enough.
  std::optional<std::size_t> right_hand_shift() const { return m_right_hand_shift; }

  const std::vector<Column_index>& columns() const { return m_columns; }
  const std::vector<Row_index>& independent_rows() const { return m_independent_rows; }
  std::size_t number_of_redundant_rows() const { return m_rows.size() - m_independent_rows.size(); }
  const Exact_integer& largest_coefficient() const { return m_largest_coefficient; }
  Exact_integer largest_pivot() const { return m_lattice.largest_pivot(); }

  // A combination of rows, by their index in the system, that reads 0 = c with c != 0.
  // \pre !is_consistent()
  Certificate contradiction() const
  {
    const Lattice_solution solution = m_lattice.some_solution(m_right_hand_side);
    Certificate result;
    for(std::size_t i = 0; i < m_rows.size(); ++i)
      if(solution.certificate.multipliers[i] != 0)
        result.emplace_back(std::size_t(m_rows[i]), solution.certificate.multipliers[i]);
    return result;
  }

  // Sets the core's columns of `x` to a solution near the target, for right-hand sides that are
  // doubled `shift` times. Returns false if a value exceeds 2^62.
  // \param weights the same in all calls: the reduced basis is expensive, and computed once
  // \pre shift >= *right_hand_shift()
  bool nearest(const std::size_t shift, const std::vector<Grid_value>& target,
               const std::vector<double>& weights, std::vector<std::int64_t>& x) const
  {
    if(m_columns.empty())
      return true;
    std::vector<Grid_value> core_target;
    for(const Column_index column : m_columns)
      core_target.push_back(target[std::size_t(column)]);
    std::vector<Exact_integer> b(m_right_hand_side);
    const Exact_integer factor = power_of_two(shift);
    for(Exact_integer& value : b)
      value = product(value, factor);
    if(m_metric == nullptr) {
      std::vector<double> core_weights;
      for(const Column_index column : m_columns)
        core_weights.push_back(weights[std::size_t(column)]);
      m_metric = std::make_unique<Lattice_metric>(m_lattice.metric(core_weights));
    }
    const Lattice_solution solution = m_lattice.nearest_solution(b, core_target, *m_metric);
    CGAL_assertion(solution.solvability == Solvability::SOLVABLE);
    for(std::size_t j = 0; j < m_columns.size(); ++j) {
      if(!fits_64_bits(solution.values[j]))
        return false;
      x[std::size_t(m_columns[j])] = to_64_bits(solution.values[j]);
    }
    return true;
  }

private:
  // The rows that the elimination left something of: about the others it said all.
  Integer_system whole_system(const Integer_system& system, const Echelon_form& form)
  {
    std::vector<bool> is_zero(system.number_of_rows(), false);
    for(const Row_index row : form.redundant_rows)
      is_zero[std::size_t(row)] = true;
    for(const Row_index row : form.contradictory_rows)
      is_zero[std::size_t(row)] = true;
    std::vector<Integer_row<Exact_integer> > rows;
    for(std::size_t i = 0; i < is_zero.size(); ++i)
      if(!is_zero[i]) {
        rows.push_back(system.exact_row(i));
        m_rows.push_back(Row_index(i));
      }
    return renumbered(std::move(rows));
  }

  Integer_system core_of(const Echelon_form& form)
  {
    std::vector<Integer_row<Exact_integer> > rows;
    for(std::size_t i = 0; i < form.rows_in_core.size(); ++i)
      rows.push_back(form.core_rows.exact_row(i));
    m_rows = form.rows_in_core;
    return renumbered(std::move(rows));
  }

  // The rows with columns as indices into `m_columns`, and without right-hand sides.
  Integer_system renumbered(std::vector<Integer_row<Exact_integer> > rows)
  {
    m_columns = renumber_columns(rows);
    Integer_system system(m_columns.size());
    for(Integer_row<Exact_integer>& row : rows) {
      for(const Entry<Exact_integer>& e : row.entries)
        m_largest_coefficient = (std::max)(m_largest_coefficient, absolute_value(e.coefficient));
      m_right_hand_side.push_back(std::move(row.right_hand_side));
      row.right_hand_side = 0;
      system.add_row(std::move(row));
    }
    return system;
  }

  bool m_is_whole;
  // filled while the lattice is made from them
  std::vector<Row_index> m_rows; // rows of the system in the core
  std::vector<Column_index> m_columns;
  std::vector<Exact_integer> m_right_hand_side;
  Exact_integer m_largest_coefficient = Exact_integer(0);
  Integer_lattice m_lattice;
  mutable std::unique_ptr<Lattice_metric> m_metric;

  std::vector<Row_index> m_independent_rows;
  bool m_is_consistent = true;
  std::optional<std::size_t> m_right_hand_shift;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_CORE_SOLVER_H
