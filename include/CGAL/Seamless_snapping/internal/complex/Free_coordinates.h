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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// The unknowns that stay free when all constraints of a complex have been eliminated, exactly.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_unknowns.h>
#include <CGAL/Seamless_snapping/internal/complex/Reduced_system.h>
#include <CGAL/Seamless_snapping/internal/complex/Sparse_row.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: whatever values the free unknowns have, the coordinates of the sectors meet all
// constraints of the complex, with right-hand sides of zero.
template <typename Group>
class Free_coordinates
{
  static constexpr std::size_t dimension = Group::dimension;

public:
  explicit Free_coordinates(const Cut_complex<Group>& complex)
    : Free_coordinates(complex, Reduced_system<Group>(complex))
  { }

  std::size_t number_of_unknowns() const { return m_unknowns.size(); }

  // Coordinate `c` of a sector, over the free unknowns.
  Sparse_row coordinate(const std::size_t sector, const std::size_t c) const
  {
    Sparse_row row;
    for(const auto& [quantity, factor] : m_coordinates[dimension * sector + c])
      append(row, m_quantities[quantity], factor);
    normalize(row);
    return row;
  }

  // The coordinates of all sectors. Those of the two sides of a cut differ by the same translation,
  // so that transitions hold up to the rounding of a single sum.
  std::vector<std::array<double, dimension> > evaluate(const std::vector<double>& free_values) const
  {
    std::vector<double> values;
    for(const Sparse_row& quantity : m_quantities)
      values.push_back(value_of(quantity, free_values));
    std::vector<std::array<double, dimension> > uv(m_coordinates.size() / dimension);
    for(std::size_t i = 0; i < m_coordinates.size(); ++i)
      uv[i / dimension][i % dimension] = value_of(m_coordinates[i], values);
    return uv;
  }

private:
  Free_coordinates(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
    : m_unknowns(system.rows().system), m_coordinates(dimension * complex.number_of_sectors())
  {
    for(std::size_t c = 0; c < system.weights().size(); ++c)
      m_quantities.push_back(m_unknowns.sum(c));
    add_sectors_of_nodes(complex, system);
    add_chains(complex, system);
    add_branches(complex, system);
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      make_free(Sector_index(s));
  }

  Sparse_row& row(const Sector_index s, const std::size_t c)
  { return m_coordinates[dimension * std::size_t(s) + c]; }

  // What has no value yet.
  void make_free(const Sector_index s)
  {
    for(std::size_t c = 0; c < dimension; ++c)
      if(row(s, c).empty()) {
        row(s, c).emplace_back(m_quantities.size(), 1.);
        m_quantities.push_back({{m_unknowns.add_unknown(), 1.}});
      }
  }

  void add_sectors_of_nodes(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      if(const Column_index first = system.unknown(Sector_index(s)); first >= 0)
        for(std::size_t c = 0; c < dimension; ++c)
          row(Sector_index(s), c).emplace_back(std::size_t(first) + c, 1.);
  }

  // Between nodes, the constant coordinate is the level of the chain.
  void add_chains(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    static_assert(Group::is_signed_permutation, "functionals have to be coordinates");
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      if(complex.has_inner_links(c))
        for(auto s = complex.links_begin(c) + 1; s + 1 != complex.links_end(c); ++s)
          row(*s, std::size_t(complex.functional[c]))
            .emplace_back(std::size_t(system.level(c)), 1.);
  }

  // Between nodes, u- = g u+ + t.
  void add_branches(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b) {
      if(!complex.has_inner_pairs(b))
        continue;
      const auto& m = Group::matrix(complex.element[b]);
      for(auto p = complex.pairs_begin(b) + 1; p + 1 != complex.pairs_end(b); ++p) {
        make_free(p->plus);
        for(std::size_t c = 0; c < dimension; ++c) {
          Sparse_row& minus = row(p->minus, c);
          for(std::size_t d = 0; d < dimension; ++d)
            if(m[c][d] != 0)
              append(minus, row(p->plus, d), m[c][d]);
          minus.emplace_back(std::size_t(system.translation(b)) + c, 1.);
        }
      }
    }
  }

  Free_unknowns m_unknowns;
  // The columns of the reduced system, and the coordinates of sectors that stay free.
  std::vector<Sparse_row> m_quantities;
  std::vector<Sparse_row> m_coordinates; // of the sectors, as sums of quantities
};

// The coordinates of the sectors as rows over the free unknowns, one after the other.
class Coordinate_table
{
public:
  template <typename Group>
  Coordinate_table(const Free_coordinates<Group>& coordinates, const std::size_t number_of_sectors)
    : m_begin(1, 0)
  {
    for(std::size_t s = 0; s < number_of_sectors; ++s)
      for(std::size_t c = 0; c < 2; ++c) {
        append(m_terms, coordinates.coordinate(s, c));
        m_begin.push_back(m_terms.size());
      }
  }

  // visit(unknown, factor) for the terms of coordinate `c` of a sector.
  template <typename Visit>
  void for_each_term(const std::size_t sector, const std::size_t c, const Visit& visit) const
  {
    for(std::size_t j = m_begin[2 * sector + c]; j < m_begin[2 * sector + c + 1]; ++j)
      visit(m_terms[j].first, m_terms[j].second);
  }

  // row(target) - row(source), as it enters the energy of an edge.
  void difference(const std::size_t target_sector, const std::size_t source_sector,
                  const std::size_t c, Sparse_row& row) const
  {
    row.clear();
    for_each_term(target_sector, c, [&](const std::size_t i, const double factor)
                  { row.emplace_back(i, factor); });
    for_each_term(source_sector, c, [&](const std::size_t i, const double factor)
                  { row.emplace_back(i, -factor); });
    normalize(row);
  }

private:
  std::vector<std::size_t> m_begin;
  Sparse_row m_terms;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_COORDINATES_H
