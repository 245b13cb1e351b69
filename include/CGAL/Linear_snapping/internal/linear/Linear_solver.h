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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_H

#include <CGAL/license/Linear_snapping.h>

// A linear system, eliminated and factorized once, and solved for many targets. It is divided into
// components that share no unknown. Each component has its own grid, as fine as its values allow.

#include <CGAL/Linear_snapping/internal/linear/Linear_solution.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Linear_snapping/types/Linear_report.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

class Component_solver;
class Step_timer;

using Component_index = std::int32_t; // a component of a linear system; -1 for columns in no row

// Invariant: each component of the rows is eliminated, once. Equal components, which are frequent
// in meshes, share a solver.
class Linear_solver
{
public:
  // \param weights of the least-squares target, one per column, positive
  // \param number_of_representable_columns columns from this one on are quantities of the system
  //        alone, which need not be numbers of the format
  // \param may_be_finer whether a component may be solved on a finer grid than the target's where
  //        its numbers allow it
  Linear_solver(const Scaled_system& system, const std::vector<double>& weights,
                const Number_format& format, std::size_t number_of_representable_columns,
                bool may_be_finer);
  ~Linear_solver();

  Linear_solver(const Linear_solver&) = delete;
  Linear_solver& operator=(const Linear_solver&) = delete;

  std::size_t number_of_components() const { return m_columns.size(); }
  Component_index component(const Column_index column) const
  { return m_component_of_column[std::size_t(column)]; }
  const std::vector<Column_index>& columns(const Component_index c) const
  { return m_columns[std::size_t(c)]; }
  const std::vector<std::size_t>& rows(const Component_index c) const
  { return m_rows[std::size_t(c)]; }
  const Integer_system& system(Component_index c) const;
  const Linear_solver_figures& figures() const { return m_figures; }

  bool is_consistent() const { return !m_contradictory_row && !first_contradictory_component(); }

  // Multiples of the caller's rows that add up to 0 = c with c != 0; empty if there are none.
  Certificate certificate() const;

  // Solves all components near the target. Each grid of the solution is the grid of the target
  // or, if necessary, another one. Returns the first component that has no representable solution,
  // or -1.
  // \pre is_consistent()
  Component_index solve(const Linear_target& target, Linear_solution& solution,
                        Step_timer* timer = nullptr) const;

  // Solves one component. Returns false if it has no representable solution.
  // \pre the sizes of the vectors of `solution` are right
  bool solve_component(Component_index c, const Linear_target& target, Linear_solution& solution,
                       Step_timer* timer = nullptr) const;

  // Solves one component on a grid of its own for each column, if it has no solution on one grid.
  std::optional<std::vector<Column_solution> >
  solve_component_on_many_grids(Component_index c, const Linear_target& target) const;

  // The linear part of the least-squares projection: how the optimum answers to shifts of the
  // values, per column.
  std::vector<double> displacements(const std::vector<double>& shifts) const;

private:
  void find_components(const Integer_system& system);
  Integer_system subsystem(const Integer_system& system, std::size_t c) const;
  std::optional<std::size_t> first_contradictory_component() const;

  std::vector<Component_index> m_component_of_column;
  std::vector<Column_index> m_local_column; // within its component
  std::map<std::size_t, Exact_rational> m_scales; // the scale of each row with a scale other than 1
  std::vector<std::vector<Column_index> > m_columns; // per component
  std::vector<std::vector<std::size_t> > m_rows;     // per component
  std::map<Component_input, std::unique_ptr<Component_solver> > m_distinct_solvers;
  std::vector<const Component_solver*> m_solvers;    // per component
  std::optional<std::size_t> m_contradictory_row;    // 0 = c
  Linear_solver_figures m_figures;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Linear_snapping/internal/linear/Linear_solver_impl.h>
#endif

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_H
