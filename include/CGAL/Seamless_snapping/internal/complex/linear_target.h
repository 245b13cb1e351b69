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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_LINEAR_TARGET_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_LINEAR_TARGET_H

#include <CGAL/license/Seamless_snapping.h>

// What the linear solver is to approximate: the coordinates of the nodes' sectors; for a branch the
// mean translation of the pairs between its nodes, and for a chain their mean level.

#include <CGAL/Seamless_snapping/internal/complex/Grid_coordinates.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The means are relative to the first of the pairs or links, so that they lose no digits.
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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_LINEAR_TARGET_H
