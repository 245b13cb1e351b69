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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_GRID_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_GRID_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// The coordinates of sectors on the grids of the components they belong to. A component is a part
// of the reduced system that shares no unknown with others: each has a grid of its own, as fine as
// its coordinates allow. Also the target of the linear solver.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/Reduced_system.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A point on a grid per coordinate: base + offset, in steps.
template <std::size_t D>
struct Grid_point
{
  std::array<std::int64_t, D> base;
  std::array<double, D> offset;
};

// The components of the coordinates of a sector, or of a translation; -1 for what no row concerns.
template <std::size_t D>
using Components = std::array<Component_index, D>;

// By how far the targets of some sectors are moved from the input.
template <typename Group>
using Target_shifts = std::unordered_map<Sector_index, typename Cut_complex<Group>::Vector>;

// Which component each coordinate belongs to: a function of the complex, its system, and the
// solver.
template <typename Group>
class Coordinate_components
{
  static constexpr std::size_t dimension = Group::dimension;

public:
  Coordinate_components(const Cut_complex<Group>& complex, const Reduced_system<Group>& system,
                        const Linear_solver& solver)
    : m_complex(complex), m_system(system), m_solver(solver)
  { }

  Components<dimension> of_node(const Sector_index s) const
  {
    return of_columns(m_system.unknown(s));
  }

  // The components of the minus sectors of a branch with inner pairs, which share the components of
  // the translation.
  Components<dimension> of_minus(const std::size_t b) const
  {
    return of_columns(m_system.translation(b));
  }

  // The components of the plus sectors: a row of the rotation links a coordinate to a minus sector.
  Components<dimension> of_plus(const std::size_t b) const
  {
    const Components<dimension> minus = of_minus(b);
    const auto& m = Group::matrix(m_complex.element[b]);
    Components<dimension> result{};
    for(std::size_t d = 0; d < dimension; ++d)
      for(std::size_t c = 0; c < dimension; ++c)
        if(m[c][d] != 0)
          result[d] = minus[c];
    return result;
  }

  // The coordinates of the inner sectors of a chain that its level moves.
  Components<dimension> of_link(const std::size_t chain) const
  {
    const auto direction = Group::shortest_at_level_1(m_complex.functional[chain]);
    Components<dimension> result{};
    for(std::size_t c = 0; c < dimension; ++c)
      result[c] = direction[c] != 0 ? m_solver.component(m_system.level(chain)) : -1;
    return result;
  }

  // Calls f(sector, components) for all sectors that some row concerns.
  template <typename F>
  void for_each_sector(const F& f) const
  {
    for(std::size_t s = 0; s < m_complex.number_of_sectors(); ++s)
      if(m_system.unknown(Sector_index(s)) >= 0)
        f(Sector_index(s), of_node(Sector_index(s)));
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b)
      if(!m_complex.inner_pairs(b).empty()) {
        const Components<dimension> plus = of_plus(b), minus = of_minus(b);
        for(const auto& pair : m_complex.inner_pairs(b)) {
          f(pair.plus, plus);
          f(pair.minus, minus);
        }
      }
    for(std::size_t c = 0; c < m_complex.number_of_chains(); ++c)
      if(!m_complex.inner_links(c).empty()) {
        const Components<dimension> link = of_link(c);
        for(const Sector_index s : m_complex.inner_links(c))
          f(s, link);
      }
  }

private:
  Components<dimension> of_columns(const Column_index first) const
  {
    Components<dimension> result;
    for(std::size_t c = 0; c < dimension; ++c)
      result[c] = m_solver.component(first + Column_index(c));
    return result;
  }

  const Cut_complex<Group>& m_complex;
  const Reduced_system<Group>& m_system;
  const Linear_solver& m_solver;
};

// The largest absolute value of a coordinate of each component.
template <typename Group>
std::vector<double> largest_coordinates(const Cut_complex<Group>& complex,
                                        const Coordinate_components<Group>& components,
                                        const std::size_t number_of_components)
{
  std::vector<double> result(number_of_components, 0);
  const auto add = [&](const Component_index k, const double x) {
    if(k >= 0)
      result[std::size_t(k)] = (std::max)(result[std::size_t(k)], std::abs(x));
  };
  components.for_each_sector([&](const Sector_index s, const Components<Group::dimension>& k) {
    const auto* const mixed = complex.find_mixed_sector(s);
    const double largest = mixed != nullptr ? mixed->largest : 0;
    for(std::size_t c = 0; c < Group::dimension; ++c)
      add(k[c], (std::max)(std::abs(complex.coordinates[std::size_t(s)][c]), largest));
  });
  return result;
}

// The values to approximate: the input, with the mean of the corners if these differ, and shifted
// if the caller asks for it.
template <typename Group>
class Grid_coordinates
{
  static constexpr std::size_t dimension = Group::dimension;
  using Vector = typename Cut_complex<Group>::Vector;

public:
  // \param grids per component
  Grid_coordinates(const Cut_complex<Group>& complex, const std::vector<Grid>& grids,
                   const Target_shifts<Group>& shifts)
    : m_complex(complex), m_grids(grids), m_shifts(shifts)
  { }

  Grid_point<dimension> operator()(const Sector_index s, const Components<dimension>& k) const
  {
    const Vector& u = m_complex.coordinates[std::size_t(s)];
    Grid_point<dimension> result{};
    for(std::size_t c = 0; c < dimension; ++c)
      if(k[c] >= 0) {
        const Grid_value value = m_grids[std::size_t(k[c])].split(u[c]);
        result.base[c] = value.base;
        result.offset[c] = value.offset;
      }
    if(const auto* const mixed = m_complex.find_mixed_sector(s))
      add(mixed->deviation, k, result);
    if(const auto found = m_shifts.find(s); found != m_shifts.end())
      add(found->second, k, result);
    return result;
  }

private:
  void add(const Vector& by, const Components<dimension>& k, Grid_point<dimension>& point) const
  {
    for(std::size_t c = 0; c < dimension; ++c)
      if(k[c] >= 0)
        point.offset[c] += m_grids[std::size_t(k[c])].in_steps(by[c]);
  }

  const Cut_complex<Group>& m_complex;
  const std::vector<Grid>& m_grids;
  const Target_shifts<Group>& m_shifts;
};

template <std::size_t D>
Grid_value value_of_functional(const Functional<D>& f, const Grid_point<D>& u)
{
  Grid_value result;
  for(std::size_t c = 0; c < D; ++c) {
    result.base += f[c] * u.base[c];
    result.offset += f[c] * u.offset[c];
  }
  return result;
}

// g u+ + t - u-, with the minus sign: what the minus sector has too much, in steps.
template <typename Group>
std::array<double, Group::dimension>
translation_gap(const typename Group::Element g, const Grid_point<Group::dimension>& plus,
                const Grid_point<Group::dimension>& minus,
                const std::array<std::int64_t, Group::dimension>& t)
{
  const auto base = Group::apply(g, plus.base);
  const auto offset = Group::apply(g, plus.offset);
  std::array<double, Group::dimension> gap;
  for(std::size_t c = 0; c < Group::dimension; ++c)
    gap[c] = static_cast<double>(minus.base[c] - base[c] - t[c]) + (minus.offset[c] - offset[c]);
  return gap;
}

// The target of the linear solver: the coordinates of the nodes' sectors; for a branch the
// mean translation of the pairs between its nodes, and for a chain their mean level. The means are
// relative to the first of the pairs or links, so that they lose no digits.
template <typename Group>
class Linear_target_builder
{
  static constexpr std::size_t dimension = Group::dimension;

public:
  Linear_target_builder(const Cut_complex<Group>& complex, const Reduced_system<Group>& system,
                        const Coordinate_components<Group>& components,
                        const Grid_coordinates<Group>& coordinates)
    : m_complex(complex), m_system(system), m_components(components), m_coordinates(coordinates)
  { }

  std::vector<Grid_value> build()
  {
    m_values.reserve(m_system.weights().size());
    for(std::size_t s = 0; s < m_complex.number_of_sectors(); ++s)
      if(m_system.unknown(Sector_index(s)) >= 0) {
        const auto u = m_coordinates(Sector_index(s), m_components.of_node(Sector_index(s)));
        for(std::size_t c = 0; c < dimension; ++c)
          m_values.push_back({u.base[c], u.offset[c]});
      }
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b)
      if(!m_complex.inner_pairs(b).empty())
        add_translation(b);
    for(std::size_t c = 0; c < m_complex.number_of_chains(); ++c)
      if(!m_complex.inner_links(c).empty())
        add_level(c);
    if constexpr(Reduced_system<Group>::has_sums)
      add_sums();
    return std::move(m_values);
  }

private:
  void add_translation(const std::size_t b)
  {
    const auto plus_components = m_components.of_plus(b),
               minus_components = m_components.of_minus(b);
    const auto g = m_complex.element[b];
    const auto pairs = m_complex.inner_pairs(b);
    std::array<std::int64_t, dimension> base{};
    std::array<double, dimension> sum{};
    for(const auto& pair : pairs) {
      const auto plus = m_coordinates(pair.plus, plus_components);
      const auto minus = m_coordinates(pair.minus, minus_components);
      if(&pair == pairs.begin()) {
        const auto turned = Group::apply(g, plus.base);
        for(std::size_t c = 0; c < dimension; ++c)
          base[c] = minus.base[c] - turned[c];
      }
      const auto gap = translation_gap<Group>(g, plus, minus, base);
      for(std::size_t c = 0; c < dimension; ++c)
        sum[c] += gap[c];
    }
    for(std::size_t c = 0; c < dimension; ++c)
      m_values.push_back({base[c], sum[c] / static_cast<double>(pairs.size())});
  }

  void add_level(const std::size_t chain)
  {
    const auto f = Group::functional(m_complex.functional[chain]);
    const auto components = m_components.of_link(chain);
    const auto links = m_complex.inner_links(chain);
    std::int64_t base = 0;
    double sum = 0;
    for(const Sector_index& s : links) {
      const Grid_value level = value_of_functional(f, m_coordinates(s, components));
      if(&s == links.begin())
        base = level.base;
      sum += static_cast<double>(level.base - base) + level.offset;
    }
    m_values.push_back({base, sum / static_cast<double>(links.size())});
  }

  void add_sums()
  {
    for(std::size_t k = 0; k < m_system.number_of_sums(); ++k) {
      const Grid_value u = m_values[dimension * k], v = m_values[dimension * k + 1];
      m_values.push_back({u.base + v.base, u.offset + v.offset});
    }
  }

  const Cut_complex<Group>& m_complex;
  const Reduced_system<Group>& m_system;
  const Coordinate_components<Group>& m_components;
  const Grid_coordinates<Group>& m_coordinates;
  std::vector<Grid_value> m_values; // per column
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_GRID_COORDINATES_H
