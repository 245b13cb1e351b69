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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXPAND_SOLUTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXPAND_SOLUTION_H

#include <CGAL/license/Seamless_snapping.h>

// From a solution of the reduced system to the coordinates of all sectors. The sectors between
// nodes take the grid points nearest to their optimum, given the translations and levels.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Seamless_snapping/internal/complex/Grid_coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Exact coordinates of all sectors, near the input.
template <typename Group>
struct Snapped_coordinates
{
  std::vector<typename Cut_complex<Group>::Vector> coordinates; // per sector
  // Of all Cartesian coordinates, had they not been rounded to grids: those of the least-squares
  // optimum.
  Magnitudes optimal_changes;
  double unit = 1; // the step of the coarsest grid
  // a component that needs a coarser grid; if there is one, all is void
  Component_index misfit = -1;
};

// Of all grids; 1 if there is none.
inline double coarsest_step(const std::vector<Grid>& grids)
{
  double step = 0;
  for(const Grid& grid : grids)
    step = (std::max)(step, grid.step());
  return step > 0 ? step : 1;
}

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
    m_result.unit = coarsest_step(solution.grids);
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
    Vector rounding; // of t
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
  const std::vector<char>& m_is_kept; // per component: coordinates are those of the input
  Number_format m_format;
  Snapped_coordinates<Group> m_result;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXPAND_SOLUTION_H
