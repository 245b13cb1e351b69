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

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/Reduced_system.h>
#include <CGAL/Seamless_snapping/internal/complex/Sparse_row.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The solutions of homogeneous integer equations. Invariant: each column is a sum of free unknowns
// with integer coefficients; whatever their values are, the equations hold, and any solution is of
// this form. Throws `Refusal` where the sums are too long.
class Free_unknowns
{
public:
  explicit Free_unknowns(const Integer_system& system);

  std::size_t size() const { return m_size; }
  std::size_t add_unknown() { return m_size++; }
  const Sparse_row& sum(const std::size_t column) const { return m_sums[column]; }

private:
  void add_core(const Integer_system& rows, std::vector<char>& is_implied);
  void substitute_back(const Entries<Exact_integer>& row, Column_index pivot);

  static constexpr std::size_t most_terms = std::size_t(1) << 26; // in all sums: a gigabyte

  std::vector<Sparse_row> m_sums; // per column
  std::size_t m_size = 0;
};

// Linear expressions, most of which are one quantity, which takes its number only. The others are
// sums, whose numbers are counted down from -1.
class Short_sums
{
public:
  explicit Short_sums(const std::size_t size) : m_places(size, nothing) { }

  std::size_t size() const { return m_places.size(); }
  bool is_set(const std::size_t i) const { return m_places[i] != nothing; }
  void set(const std::size_t i, const std::size_t quantity)
  { m_places[i] = std::ptrdiff_t(quantity); }

  void set(const std::size_t i, Sparse_row&& sum)
  {
    m_sums.push_back(std::move(sum));
    m_places[i] = -std::ptrdiff_t(m_sums.size());
  }

  // visit(quantity, factor)
  template <typename Visit>
  void for_each_term(const std::size_t i, const Visit& visit) const
  {
    if(m_places[i] >= 0)
      visit(std::size_t(m_places[i]), 1.);
    else
      for(const auto& [quantity, factor] : m_sums[std::size_t(-1 - m_places[i])])
        visit(quantity, factor);
  }

  bool are_equal(const std::size_t i, const std::size_t j) const
  {
    return m_places[i] >= 0 || m_places[j] >= 0
             ? m_places[i] == m_places[j]
             : m_sums[std::size_t(-1 - m_places[i])] == m_sums[std::size_t(-1 - m_places[j])];
  }

  // The terms of sums that are not one quantity.
  std::size_t number_of_terms_of_sums() const
  {
    std::size_t result = 0;
    for(const Sparse_row& sum : m_sums)
      result += sum.size();
    return result;
  }

private:
  static constexpr std::ptrdiff_t nothing = (std::numeric_limits<std::ptrdiff_t>::max)();

  std::vector<std::ptrdiff_t> m_places;
  std::vector<Sparse_row> m_sums;
};

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
    const auto add = [&](const std::size_t q, const double factor) {
      if(is_column(q))
        append(row, m_unknowns.sum(q), factor);
      else
        row.emplace_back(unknown(q), factor);
    };
    m_coordinates.for_each_term(dimension * sector + c, add);
    normalize(row);
    return row;
  }

  // The coordinates of all sectors. The two sides of a cut differ by the same translation,
  // so that transitions hold up to the rounding of a single sum.
  std::vector<std::array<double, dimension> > evaluate(const std::vector<double>& free_values) const
  {
    std::vector<double> values;
    for(std::size_t q = 0; is_column(q); ++q)
      values.push_back(value_of(m_unknowns.sum(q), free_values));
    std::vector<std::array<double, dimension> > uv(m_coordinates.size() / dimension);
    for(std::size_t i = 0; i < m_coordinates.size(); ++i)
      m_coordinates.for_each_term(i, [&](const std::size_t q, const double factor) {
        uv[i / dimension][i % dimension] +=
          factor * (is_column(q) ? values[q] : free_values[unknown(q)]);
      });
    return uv;
  }

private:
  Free_coordinates(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
    : m_unknowns(system.rows().system), m_number_of_columns(system.weights().size()),
      m_first_unknown(m_unknowns.size()),
      m_coordinates(dimension * complex.number_of_sectors())
  {
    add_sectors_of_nodes(complex, system);
    add_chains(complex, system);
    add_branches(complex, system);
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      make_free(Sector_index(s));
  }

  bool is_column(const std::size_t quantity) const { return quantity < m_number_of_columns; }
  std::size_t unknown(const std::size_t quantity) const
  { return quantity - m_number_of_columns + m_first_unknown; }

  static std::size_t coordinate_of(const Sector_index s, const std::size_t c)
  { return dimension * std::size_t(s) + c; }

  // Makes the coordinates of a sector free that have no value yet.
  void make_free(const Sector_index s)
  {
    for(std::size_t c = 0; c < dimension; ++c)
      if(!m_coordinates.is_set(coordinate_of(s, c)))
        m_coordinates.set(coordinate_of(s, c),
                          m_number_of_columns + m_unknowns.add_unknown() - m_first_unknown);
  }

  void add_sectors_of_nodes(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      if(const Column_index first = system.unknown(Sector_index(s)); first >= 0)
        for(std::size_t c = 0; c < dimension; ++c)
          m_coordinates.set(coordinate_of(Sector_index(s), c), std::size_t(first) + c);
  }

  // Between nodes, the constant coordinate is the level of the chain.
  void add_chains(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    static_assert(Group::is_signed_permutation, "functionals have to be coordinates");
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      for(const Sector_index s : complex.inner_links(c))
        m_coordinates.set(coordinate_of(s, std::size_t(complex.functional[c])),
                          std::size_t(system.level(c)));
  }

  // Between nodes, u- = g u+ + t.
  void add_branches(const Cut_complex<Group>& complex, const Reduced_system<Group>& system)
  {
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b) {
      const auto& m = Group::matrix(complex.element[b]);
      for(const auto& pair : complex.inner_pairs(b)) {
        make_free(pair.plus);
        for(std::size_t c = 0; c < dimension; ++c) {
          Sparse_row minus;
          for(std::size_t d = 0; d < dimension; ++d)
            if(m[c][d] != 0)
              m_coordinates.for_each_term(coordinate_of(pair.plus, d),
                                          [&](const std::size_t q, const double factor)
                                          { minus.emplace_back(q, factor * m[c][d]); });
          minus.emplace_back(std::size_t(system.translation(b)) + c, 1.);
          m_coordinates.set(coordinate_of(pair.minus, c), std::move(minus));
        }
      }
    }
  }

  Free_unknowns m_unknowns;
  std::size_t m_number_of_columns, m_first_unknown; // the latter after the columns' unknowns
  // The coordinates of the sectors, over columns of the reduced system and then free coordinates.
  Short_sums m_coordinates;
};

// The coordinates of the sectors over the free unknowns.
class Coordinate_table
{
public:
  template <typename Group>
  Coordinate_table(const Free_coordinates<Group>& coordinates, const std::size_t number_of_sectors)
    : m_coordinates(2 * number_of_sectors)
  {
    for(std::size_t s = 0; s < number_of_sectors; ++s)
      for(std::size_t c = 0; c < 2; ++c) {
        Sparse_row row = coordinates.coordinate(s, c);
        if(row.size() == 1 && row.front().second == 1)
          m_coordinates.set(2 * s + c, row.front().first);
        else
          m_coordinates.set(2 * s + c, std::move(row));
      }
  }

  // visit(unknown, factor) for the terms of coordinate `c` of a sector.
  template <typename Visit>
  void for_each_term(const std::size_t sector, const std::size_t c, const Visit& visit) const
  { m_coordinates.for_each_term(2 * sector + c, visit); }

  // Whether the constraints give both sectors the same coordinate `c`.
  bool are_equal(const std::size_t sector, const std::size_t other, const std::size_t c) const
  { return m_coordinates.are_equal(2 * sector + c, 2 * other + c); }

  std::size_t number_of_terms_of_sums() const { return m_coordinates.number_of_terms_of_sums(); }

  // Whether the mean coordinate is a long sum, as where features cross the cuts of many handles.
  bool has_long_sums() const
  {
    constexpr std::size_t many = 4; // without cuts and features, each is an unknown
    return number_of_terms_of_sums() > many * m_coordinates.size();
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
  Short_sums m_coordinates;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/complex/Free_unknowns_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_COORDINATES_H
