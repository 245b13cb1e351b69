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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// Solves a complex: exact coordinates of its sectors, near the input or near targets beside it. The
// elimination and the factorization are made once, and serve all targets.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/Grid_coordinates.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// From a solution of the reduced system to the coordinates of all sectors. The sectors between
// nodes take the grid points nearest to their optimum, given the translations and levels.

// Exact coordinates of all sectors, near the input.
template <typename Group>
struct Snapped_coordinates
{
  std::vector<typename Cut_complex<Group>::Vector> coordinates; // per sector
  // The changes of all Cartesian coordinates in the least-squares optimum, without rounding.
  Magnitudes optimal_changes;
  // a component that needs a coarser grid; if there is one, all is void
  Component_index misfit = -1;
};

// The components that are kept have no solution, and need none.
template <typename Group>
class Solution_expander
{
  static constexpr std::size_t dimension = Group::dimension;
  using Vector = typename Cut_complex<Group>::Vector;

public:
  Solution_expander(const Cut_complex<Group>& complex, const Reduced_system<Group>& system,
                    const Coordinate_components<Group>& components,
                    const Grid_coordinates<Group>& targets, const Linear_solution& solution,
                    const std::vector<char>& is_kept, const Number_format& format)
    : m_complex(complex), m_system(system), m_components(components), m_targets(targets),
      m_solution(solution), m_is_kept(is_kept), m_format(format)
  {
    m_result.coordinates = complex.coordinates;
    expand_mixed_sectors();
    expand_nodes();
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
      if(!complex.inner_pairs(b).empty())
        expand_branch(b);
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      if(!complex.inner_links(c).empty())
        expand_chain(c);
  }

  Snapped_coordinates<Group> take() { return std::move(m_result); }

private:
  // Corners that differ get one place, whether or not a row concerns it.
  void expand_mixed_sectors()
  {
    for(const auto& mixed : m_complex.mixed_sectors) {
      Vector& u = m_result.coordinates[std::size_t(mixed.sector)];
      for(std::size_t c = 0; c < dimension; ++c)
        u[c] = rounded_to(m_format, u[c] + mixed.deviation[c]);
      m_result.optimal_changes.add(mixed.distance);
    }
  }

  void expand_nodes()
  {
    for(std::size_t i = 0; i < m_complex.number_of_sectors(); ++i) {
      const Sector_index s = Sector_index(i);
      const Column_index unknown = m_system.unknown(s);
      if(unknown < 0)
        continue;
      const Components<dimension> k = m_components.of_node(s);
      const Grid_point<dimension> target = m_targets(s, k);
      Vector change{};
      for(std::size_t c = 0; c < dimension; ++c)
        if(k[c] >= 0 && !is_kept(k[c])) {
          const Column_index column = unknown + Column_index(c);
          set(s, c, k[c], m_solution.x[std::size_t(column)]);
          change[c] = optimal_change({target.base[c], target.offset[c]}, column);
        }
      add_optimal_change(change, k);
    }
  }

  // Given t, u+ is the grid point nearest to the mean of u+ and g^-1 (u- - t), and u- = g u+ + t.
  void expand_branch(const std::size_t b)
  {
    const auto g = m_complex.element[b], back = Group::inverse(g);
    const Components<dimension> plus_k = m_components.of_plus(b),
                                minus_k = m_components.of_minus(b);
    const std::size_t first_column = std::size_t(m_system.translation(b));
    std::array<std::int64_t, dimension> t;
    Vector rounding; // change of t
    for(std::size_t c = 0; c < dimension; ++c) {
      t[c] = m_solution.x[first_column + c];
      rounding[c] = optimal_change({t[c], 0}, Column_index(first_column + c));
    }
    rounding = Group::apply(back, rounding);
    for(const auto& pair : m_complex.inner_pairs(b)) {
      const Grid_point<dimension> plus = m_targets(pair.plus, plus_k);
      const Grid_point<dimension> minus = m_targets(pair.minus, minus_k);
      const Vector gap = Group::apply(back, translation_gap<Group>(g, plus, minus, t));
      std::array<std::int64_t, dimension> x;
      Vector change;
      for(std::size_t c = 0; c < dimension; ++c) {
        x[c] = plus.base[c] + nearest_integer(plus.offset[c] + gap[c] * 0.5);
        change[c] = (gap[c] - rounding[c]) * 0.5;
      }
      for(int side = 0; side < 2; ++side)
        add_optimal_change(change, plus_k);
      const auto turned = Group::apply(g, x);
      for(std::size_t c = 0; c < dimension; ++c) {
        set(pair.plus, c, plus_k[c], x[c]);
        set(pair.minus, c, minus_k[c], turned[c] + t[c]);
      }
    }
  }

  // Each link moves by the shortest way to the level. One coordinate of the functional takes what
  // rounding leaves, so that the level is exact.
  void expand_chain(const std::size_t chain)
  {
    const auto f = Group::functional(m_complex.functional[chain]);
    const auto direction = Group::shortest_at_level_1(m_complex.functional[chain]);
    const Components<dimension> k = m_components.of_link(chain);
    const std::size_t column = std::size_t(m_system.level(chain));
    const std::size_t last = f[1] != 0 ? 1 : 0, other = 1 - last;
    for(const Sector_index s : m_complex.inner_links(chain)) {
      const Grid_point<dimension> target = m_targets(s, k);
      std::int64_t rest = m_solution.x[column];
      double gap = static_cast<double>(rest);
      for(std::size_t c = 0; c < dimension; ++c)
        gap -= f[c] * (static_cast<double>(target.base[c]) + target.offset[c]);
      if(k[other] >= 0) {
        const std::int64_t x =
          target.base[other] + nearest_integer(target.offset[other] + direction[other] * gap);
        rest -= f[other] * x;
        set(s, other, k[other], x);
      }
      set(s, last, k[last], rest);
      const double change = optimal_change(value_of_functional(f, target), Column_index(column));
      add_optimal_change(Vector{change * direction[0], change * direction[1]}, k);
    }
  }

  // By how much the real-valued optimum of an unknown differs from a value.
  double optimal_change(const Grid_value& from, const Column_index column) const
  { return difference(m_solution.optimum[std::size_t(column)], from); }

  // \param change in steps of the components' grids; those of a vector are the same unless its
  // coordinates are Cartesian
  void add_optimal_change(const Vector& change, const Components<dimension>& k)
  {
    const Vector cartesian = Group::to_cartesian(change);
    for(std::size_t c = 0; c < dimension; ++c)
      if(k[c] >= 0 && !is_kept(k[c]))
        m_result.optimal_changes.add(cartesian[c] * grid(k[c]).step());
  }

  void set(const Sector_index s, const std::size_t c, const Component_index k, const std::int64_t x)
  {
    if(is_kept(k))
      return;
    if(!grid(k).is_representable(x))
      m_result.misfit = k;
    m_result.coordinates[std::size_t(s)][c] = grid(k).value(x);
  }

  bool is_kept(const Component_index k) const { return m_is_kept[std::size_t(k)] != 0; }
  const Grid& grid(const Component_index k) const { return m_solution.grids[std::size_t(k)]; }

  const Cut_complex<Group>& m_complex;
  const Reduced_system<Group>& m_system;
  const Coordinate_components<Group>& m_components;
  const Grid_coordinates<Group>& m_targets;
  const Linear_solution& m_solution;
  const std::vector<char>& m_is_kept; // per component: coordinates are as in the input
  Number_format m_format;
  Snapped_coordinates<Group> m_result;
};

// Which components of the reduced system hold exactly in the input: they are left alone to the bit,
// whatever is mended elsewhere. Per component.
template <typename Group>
std::vector<char> exact_components(const Cut_complex<Group>& complex,
                                   const Coordinate_components<Group>& components,
                                   const std::size_t number_of_components)
{
  std::vector<char> result(number_of_components, true);
  const auto mark = [&](const Components<Group::dimension>& inexact) {
    for(const Component_index k : inexact)
      if(k >= 0)
        result[std::size_t(k)] = false;
  };
  // Sectors can cancel in a row, so all of them are marked: the sectors that are left decide.
  const auto mark_branch = [&](const std::size_t b) {
    for(const auto& pair : {complex.pairs[b].front(), complex.pairs[b].back()})
      for(const Sector_index s : {pair.plus, pair.minus})
        mark(components.of_node(s));
    if(!complex.inner_pairs(b).empty())
      mark(components.of_minus(b));
  };
  const auto& u = complex.coordinates;
  for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
    if(!branch_is_exact(complex, b, u))
      mark_branch(b);
  for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
    if(!chain_is_exact(complex, c, u))
      for(const Sector_index s : {complex.links[c].front(), complex.links[c].back()})
        mark(components.of_node(s));
  for(const auto& path : complex.paths)
    if(path_misfit(complex, path, u) != 0) {
      for(const Sector_index s : {path.a, path.b})
        mark(components.of_node(s));
      for(const auto& crossing : path.crossings)
        mark_branch(std::size_t(crossing.branch));
    }
  for(const auto& equation : complex.equations)
    if(!equation_is_exact<Group>(equation, u))
      for(const auto& term : equation.terms)
        mark(components.of_node(term.sector));
  if(!complex.mixed_sectors.empty())
    components.for_each_sector([&](const Sector_index s, const auto& inexact) {
      if(complex.find_mixed_sector(s) != nullptr)
        mark(inexact);
    });
  return result;
}

// Invariant: the reduced system of the complex is eliminated. A solution was found for the grids of
// `grids()`, if `solve()` was called and has returned one.
template <typename Group>
class Complex_solver
{
public:
  using Coordinates = std::vector<typename Cut_complex<Group>::Vector>;

  Complex_solver(const Cut_complex<Group>& complex, const Number_format& format);
  Complex_solver(const Complex_solver&) = delete; // its members refer to each other
  Complex_solver& operator=(const Complex_solver&) = delete;

  const Reduced_system<Group>& system() const { return m_system; }
  const Linear_solver& linear_solver() const { return m_solver; }
  const Coordinate_components<Group>& components() const { return m_components; }
  const Number_format& format() const { return m_format; }
  const std::vector<Grid>& grids() const { return m_grids; } // per component

  // 1 if there is no grid.
  double coarsest_step() const
  {
    double step = 0;
    for(const Grid& grid : m_grids)
      step = (std::max)(step, grid.step());
    return step > 0 ? step : 1;
  }

  // Exact coordinates near the input; `grids()` become the grids of the solution. Returns the
  // reason if there are none.
  std::optional<Refusal> solve(Snapped_coordinates<Group>& snapped);

  // Solves for targets beside the input. Returns false if there is no solution.
  bool solve_shifted(const Target_shifts<Group>& shifts, Coordinates& coordinates) const;

  // The target of the linear solver without shifts.
  Linear_target target() const { return linear_target({}, m_grids); }

private:
  // Tries grids from the given ones on. Returns false if none has a solution.
  bool solve(const Target_shifts<Group>& shifts, std::vector<Grid>& grids,
             Snapped_coordinates<Group>& snapped) const
  {
    const std::vector<char> is_kept = kept_components(shifts);
    for(;;) {
      Linear_solution solution;
      if(!solve_components(is_kept, linear_target(shifts, grids), solution))
        return false;
      snapped = expand(shifts, is_kept, solution);
      const std::vector<Grid> tried(grids);
      grids = solution.grids;
      if(snapped.misfit < 0)
        return true;
      // Rare: coordinates that grow past a power of two need a coarser grid. Where right-hand sides
      // want a finer one, there is none.
      Grid& grid = grids[std::size_t(snapped.misfit)];
      if(grid.exponent() < tried[std::size_t(snapped.misfit)].exponent())
        return false;
      grid = Grid(m_format, grid.exponent() + 1);
    }
  }

  Linear_target linear_target(const Target_shifts<Group>& shifts,
                              const std::vector<Grid>& grids) const
  {
    const Grid_coordinates<Group> coordinates(m_complex, grids, shifts);
    return {grids,
            Linear_target_builder<Group>(m_complex, m_system, m_components, coordinates).build()};
  }

  // As fine as the grids of the solution, but where shifted coordinates are so large that they need
  // coarser ones. Returns false if they are not finite.
  bool make_grids(const Target_shifts<Group>& shifts, std::vector<Grid>& grids) const
  {
    grids = m_grids;
    bool are_finite = true;
    m_components.for_each_sector([&](const Sector_index s, const auto& components) {
      const auto found = shifts.find(s);
      for(std::size_t c = 0; c < Group::dimension && found != shifts.end(); ++c) {
        const double to = m_complex.coordinates[std::size_t(s)][c] + found->second[c];
        are_finite = are_finite && std::isfinite(to);
        if(!are_finite || components[c] < 0)
          continue;
        Grid& grid = grids[std::size_t(components[c])];
        if(const Grid needed = Grid::finest(m_format, std::abs(to));
           needed.exponent() > grid.exponent())
          grid = needed;
      }
    });
    return are_finite;
  }

  // The components that are exact in the input, and are not asked to move.
  std::vector<char> kept_components(const Target_shifts<Group>& shifts) const
  {
    std::vector<char> result(m_is_exact);
    if(!shifts.empty())
      m_components.for_each_sector([&](const Sector_index s, const auto& components) {
        if(shifts.count(s) != 0)
          for(const Component_index k : components)
            if(k >= 0)
              result[std::size_t(k)] = false;
      });
    return result;
  }

  // Returns false if a component has no representable solution.
  bool solve_components(const std::vector<char>& is_kept, const Linear_target& target,
                        Linear_solution& solution) const
  {
    solution.grids = target.grids;
    solution.x.assign(target.values.size(), 0);
    solution.optimum.assign(target.values.size(), Grid_value());
    for(std::size_t k = 0; k < is_kept.size(); ++k)
      if(!is_kept[k] && !m_solver.solve_component(Component_index(k), target, solution))
        return false;
    return true;
  }

  Snapped_coordinates<Group> expand(const Target_shifts<Group>& shifts,
                                    const std::vector<char>& is_kept,
                                    const Linear_solution& solution) const
  {
    Snapped_coordinates<Group> result;
    for(std::size_t k = 0; k < m_largest.size(); ++k) // a right-hand side may want a very fine grid
      if(solution.grids[k].in_steps(m_largest[k]) >= machine_integer_bound / 4)
        result.misfit = Component_index(k);
    if(result.misfit >= 0)
      return result;
    const Grid_coordinates<Group> targets(m_complex, solution.grids, shifts);
    return Solution_expander<Group>(m_complex, m_system, m_components, targets, solution,
                                    is_kept, m_format).take();
  }

  const Cut_complex<Group>& m_complex;
  Number_format m_format;
  Reduced_system<Group> m_system;
  Linear_solver m_solver;
  Coordinate_components<Group> m_components;
  std::vector<double> m_largest; // per component: absolute value of a coordinate
  std::vector<Grid> m_grids;     // per component
  std::vector<char> m_is_exact;  // per component: in the input
};

// Outside of the class, so that programs that share a library can share these, too.
template <typename Group>
Complex_solver<Group>::Complex_solver(const Cut_complex<Group>& complex,
                                      const Number_format& format)
  : m_complex(complex), m_format(format), m_system(complex),
    m_solver(m_system.rows(), m_system.weights(), format,
             m_system.number_of_representable_columns(), false),
    m_components(complex, m_system, m_solver),
    m_largest(largest_coordinates(complex, m_components, m_solver.number_of_components()))
{
  for(const double largest : m_largest)
    m_grids.push_back(Grid::finest(format, largest));
  m_is_exact = exact_components(complex, m_components, m_largest.size());
}

template <typename Group>
std::optional<Refusal> Complex_solver<Group>::solve(Snapped_coordinates<Group>& snapped)
{
  if(!m_solver.is_consistent())
    return Refusal(Outcome::INCONSISTENT, {}, m_solver.certificate());
  if(!solve({}, m_grids, snapped))
    return Refusal(Outcome::NOT_REPRESENTABLE, {});
  return std::nullopt;
}

template <typename Group>
bool Complex_solver<Group>::solve_shifted(const Target_shifts<Group>& shifts,
                                           Coordinates& coordinates) const
{
  std::vector<Grid> grids;
  Snapped_coordinates<Group> snapped;
  if(!make_grids(shifts, grids) || !solve(shifts, grids, snapped))
    return false;
  coordinates.swap(snapped.coordinates);
  return true;
}

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
extern template class Complex_solver<Rotation_group<4> >;
extern template class Complex_solver<Rotation_group<6> >;
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H
