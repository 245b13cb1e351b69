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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H

#include <CGAL/license/Linear_snapping.h>

// Divides a linear system into components, and joins their solutions.

#include <CGAL/Linear_snapping/internal/linear/Component_solver.h>
#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Linear_snapping/internal/linear/solve_on_many_grids.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// How often all right-hand sides can be halved.
inline int common_number_of_halvings(const Integer_system& system,
                                     const std::vector<std::size_t>& rows)
{
  std::optional<int> count;
  for(const std::size_t i : rows)
    if(system.has_right_hand_side(i)) {
      const int halvings = system.is_small(i)
        ? number_of_halvings(system.right_hand_side(i))
        : number_of_halvings(system.large_row(i).right_hand_side);
      count = (std::min)(count.value_or(halvings), halvings);
    }
  return count.value_or(0);
}

// The values of one component.
inline Component_solution part_of(const Linear_target& target, const Component_index c,
                                  const std::vector<Column_index>& columns)
{
  Component_solution part{target.grids[std::size_t(c)], {}, {}};
  part.optimum.reserve(columns.size());
  for(const Column_index j : columns)
    part.optimum.push_back(target.values[std::size_t(j)]);
  return part;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Linear_solver::Linear_solver(const Scaled_system& system, const std::vector<double>& weights,
                             const Number_format& format,
                             const std::size_t number_of_representable_columns,
                             const bool may_be_finer)
  : m_component_of_column(system.system.number_of_columns(), -1),
    m_local_column(system.system.number_of_columns(), -1), m_scales(system.scales)
{
  m_figures.number_of_unknowns = system.system.number_of_columns();
  m_figures.number_of_constraints = system.system.number_of_rows();
  m_figures.number_of_eliminations = 1;
  find_components(system.system);
  m_solvers.reserve(m_columns.size());
  for(std::size_t c = 0; c < m_columns.size(); ++c) {
    const std::vector<Column_index>& columns = m_columns[c];
    const auto end = std::lower_bound(columns.begin(), columns.end(),
                                      Column_index(number_of_representable_columns));
    Component_input input{subsystem(system.system, c), {}, std::size_t(end - columns.begin())};
    input.weights.reserve(columns.size());
    for(const Column_index j : columns)
      input.weights.push_back(weights[std::size_t(j)]);
    const auto solver = m_distinct_solvers.try_emplace(std::move(input)).first;
    if(solver->second == nullptr)
      solver->second = std::make_unique<Component_solver>(solver->first, format, may_be_finer);
    m_solvers.push_back(solver->second.get());
    m_solvers.back()->add_to(m_figures);
  }
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Linear_solver::~Linear_solver() = default;

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
const Integer_system& Linear_solver::system(const Component_index c) const
{
  return m_solvers[std::size_t(c)]->system();
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Certificate Linear_solver::certificate() const
{
  std::vector<std::pair<std::size_t, Exact_rational> > multipliers;
  if(m_contradictory_row) {
    multipliers.emplace_back(*m_contradictory_row, Exact_rational(1));
  } else if(const auto c = first_contradictory_component()) {
    multipliers = m_solvers[*c]->contradiction();
    for(auto& multiple : multipliers)
      multiple.first = m_rows[*c][multiple.first];
  }
  for(auto& multiple : multipliers) {
    const auto scale = m_scales.find(multiple.first);
    if(scale != m_scales.end())
      multiple.second *= scale->second;
  }
  return to_integer_multipliers(multipliers);
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Component_index Linear_solver::solve(const Linear_target& target, Linear_solution& solution,
                                     Step_timer* const timer) const
{
  solution.x.assign(target.values.size(), 0);
  solution.optimum.assign(target.values.size(), Grid_value());
  solution.grids = target.grids;
  for(Component_index c = 0; c < Component_index(m_solvers.size()); ++c)
    if(!solve_component(c, target, solution, timer))
      return c;
  return -1;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
bool Linear_solver::solve_component(const Component_index c, const Linear_target& target,
                                    Linear_solution& solution, Step_timer* const timer) const
{
  Component_solution part = part_of(target, c, columns(c));
  if(!m_solvers[std::size_t(c)]->solve(part, timer))
    return false;
  solution.grids[std::size_t(c)] = part.grid;
  for(std::size_t k = 0; k < columns(c).size(); ++k) {
    const std::size_t j = std::size_t(columns(c)[k]);
    solution.x[j] = part.x[k];
    solution.optimum[j] = part.optimum[k];
  }
  return true;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<std::vector<Column_solution> >
Linear_solver::solve_component_on_many_grids(const Component_index c,
                                             const Linear_target& target) const
{
  return solve_on_many_grids(*m_solvers[std::size_t(c)], part_of(target, c, columns(c)));
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::vector<double> Linear_solver::displacements(const std::vector<double>& shifts) const
{
  std::vector<double> result(shifts);
  for(std::size_t c = 0; c < m_solvers.size(); ++c) {
    Eigen::VectorXd part(Eigen::Index(m_columns[c].size()));
    for(std::size_t k = 0; k < m_columns[c].size(); ++k)
      part[Eigen::Index(k)] = shifts[std::size_t(m_columns[c][k])];
    if(part.isZero(0))
      continue;
    part = m_solvers[c]->displacements(part);
    for(std::size_t k = 0; k < m_columns[c].size(); ++k)
      result[std::size_t(m_columns[c][k])] = part[Eigen::Index(k)];
  }
  return result;
}

// In the order of their first rows; rows and columns of each in the system's order.
CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void Linear_solver::find_components(const Integer_system& system)
{
  boost::disjoint_sets_with_storage<> sets(system.number_of_columns());
  std::vector<Column_index> first_column(system.number_of_rows(), -1);
  for(std::size_t i = 0; i < system.number_of_rows(); ++i)
    system.for_each_column(i, [&](const Column_index j) {
      if(first_column[i] < 0)
        first_column[i] = j;
      else
        sets.union_set(first_column[i], j);
    });
  std::vector<Component_index> component_of_set(system.number_of_columns(), -1);
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    if(first_column[i] < 0) {
      if(!system.has_right_hand_side(i))
        ++m_figures.number_of_redundant_constraints;
      else if(!m_contradictory_row)
        m_contradictory_row = i;
      continue;
    }
    Component_index& c = component_of_set[sets.find_set(std::size_t(first_column[i]))];
    if(c < 0) {
      c = Component_index(m_rows.size());
      m_rows.emplace_back();
      m_columns.emplace_back();
    }
    m_rows[std::size_t(c)].push_back(i);
  }
  for(std::size_t j = 0; j < system.number_of_columns(); ++j) {
    const Component_index c = component_of_set[sets.find_set(j)];
    m_component_of_column[j] = c;
    if(c < 0)
      continue;
    m_local_column[j] = Column_index(m_columns[std::size_t(c)].size());
    m_columns[std::size_t(c)].push_back(Column_index(j));
  }
}

// The rows of a component, with right-hand sides on a scale of their own.
CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Integer_system Linear_solver::subsystem(const Integer_system& system, const std::size_t c) const
{
  Integer_system result(m_columns[c].size());
  const int halvings = common_number_of_halvings(system, m_rows[c]);
  result.set_right_hand_scale(system.right_hand_scale() - halvings);
  std::size_t number_of_entries = 0;
  for(const std::size_t i : m_rows[c])
    number_of_entries += system.row(i).size();
  result.reserve(m_rows[c].size(), number_of_entries);
  const auto make_local = [&](auto& row) {
    for(auto& e : row)
      e.column = m_local_column[std::size_t(e.column)]; // in the same order
  };
  Entries<std::int64_t> row;
  for(const std::size_t i : m_rows[c])
    if(system.is_small(i)) {
      row.assign(system.row(i).begin(), system.row(i).end());
      make_local(row);
      result.add_row(row, halved(system.right_hand_side(i), halvings));
    } else {
      Integer_row<Exact_integer> large = system.large_row(i);
      make_local(large.entries);
      large.right_hand_side = halved(large.right_hand_side, halvings);
      result.add_row(std::move(large));
    }
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<std::size_t> Linear_solver::first_contradictory_component() const
{
  for(std::size_t c = 0; c < m_solvers.size(); ++c)
    if(!m_solvers[c]->is_consistent())
      return c;
  return std::nullopt;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H
