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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_REDUCED_SYSTEM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_REDUCED_SYSTEM_H

#include <CGAL/license/Seamless_snapping.h>

// The reduced constraint system of [MC19] Sec. 5.3, with a twist: the translation of each cut
// branch and the level of each aligned chain are unknowns too, and stand for the vertices between
// the nodes in the least-squares target. So the small system has the optimum of the full one.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/row_origins.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the columns are the coordinates of the nodes' sectors, in order; then the translations
// of branches, and the levels of chains, that have vertices between nodes.
// In lattice coordinates, the sum of the squares of all three functionals is what is to be small:
// u + v is a further column for each of these vectors then, and a row defines it.
template <typename Group>
class Reduced_system
{
  using Complex = Cut_complex<Group>;
  using Pair = typename Complex::Pair;
  using Element = typename Group::Element;
  using Row = std::vector<Entry<std::int64_t> >;
  static constexpr std::size_t dimension = Group::dimension;

public:
  explicit Reduced_system(const Complex& complex)
    : m_complex(complex), m_unknown(complex.number_of_sectors(), -1)
  {
    add_columns();
    System_builder builder(m_weights.size());
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
      add_branch_rows(b, builder);
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      add_chain_rows(c, builder);
    for(std::size_t i = 0; i < complex.paths.size(); ++i) {
      append_path(complex.paths[i]);
      add_row({Row_origin::PATH, i, false}, builder);
    }
    for(std::size_t i = 0; i < complex.equations.size(); ++i)
      add_equation(i, builder);
    add_sum_rows(builder); // the last is eliminated first: its sum is a pivot at no cost
    m_rows = builder.take();
  }

  const Scaled_system& rows() const { return m_rows; }
  const std::vector<double>& weights() const { return m_weights; } // per column
  const Row_origin& origin(const std::size_t row) const { return m_origins[row]; }

  // Only the columns of nodes must be representable: translations and levels are quantities of the
  // system alone.
  std::size_t number_of_representable_columns() const { return m_number_of_node_columns; }

  // The column of coordinate 0 of a node's sector, or -1; the other coordinates follow.
  Column_index unknown(const Sector_index s) const { return m_unknown[std::size_t(s)]; }
  // The column of coordinate 0 of a branch's translation, or -1 for branches without inner pairs.
  Column_index translation(const std::size_t b) const { return m_translation[b]; }
  // The column of a chain's level, or -1 for chains without inner links.
  Column_index level(const std::size_t c) const { return m_level[c]; }

  // Whether vectors have a column for the sum of their coordinates.
  static constexpr bool has_sums = Group::number_of_functionals > int(dimension);
  // The column of u + v for the vector whose coordinate 0 has the given column: a node or a
  // translation.
  Column_index sum(const Column_index vector) const
  {
    return m_first_sum + vector / Column_index(dimension);
  }
  std::size_t number_of_sums() const { return m_weights.size() - std::size_t(m_first_sum); }

private:
  // \return the first of `number` new columns
  Column_index add_column(const double weight, const std::size_t number)
  {
    m_weights.insert(m_weights.end(), number, weight);
    return Column_index(m_weights.size() - number);
  }

  // A pair between nodes contributes 1/2 |g u+ + t - u-|^2 to the objective, a link |f(u) - a|^2.
  void add_columns()
  {
    for(std::size_t v = 0; v < m_complex.number_of_vertices(); ++v)
      for(Sector_index s = m_complex.first_sector[v];
          m_complex.is_node[v] && s != m_complex.first_sector[v + 1]; ++s)
        m_unknown[std::size_t(s)] = add_column(1., dimension);
    m_number_of_node_columns = m_weights.size();
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b) {
      const std::size_t inner = m_complex.inner_pairs(b).size();
      m_translation.push_back(inner > 0 ? add_column(0.5 * static_cast<double>(inner), dimension)
                                        : -1);
    }
    m_end_of_vectors = Column_index(m_weights.size());
    for(std::size_t c = 0; c < m_complex.number_of_chains(); ++c) {
      const std::size_t inner = m_complex.inner_links(c).size();
      m_level.push_back(
        inner > 0 ? add_column(Group::squares_at_level_1 * static_cast<double>(inner), 1) : -1);
    }
    m_first_sum = Column_index(m_weights.size());
    if constexpr(has_sums)
      for(Column_index j = 0; j < m_end_of_vectors; j += Column_index(dimension))
        add_column(m_weights[std::size_t(j)], 1);
  }

  void add_sum_rows(System_builder& builder)
  {
    if constexpr(has_sums)
      for(Column_index j = 0; j < m_end_of_vectors; j += Column_index(dimension)) {
        m_row = {{j, 1}, {j + 1, 1}, {sum(j), -1}};
        add_row({Row_origin::SUM, std::size_t(j), false}, builder);
      }
  }

  // u- = g u+ + t at both ends. Without t: the difference of both.
  void add_branch_rows(const std::size_t b, System_builder& builder)
  {
    const Pair ends[2] = {m_complex.pairs[b].front(), m_complex.pairs[b].back()};
    for(std::size_t c = 0; c < dimension; ++c)
      for(int end = 0; end < 2; ++end) {
        const std::int64_t sign = translation(b) < 0 && end == 1 ? -1 : 1;
        m_row.push_back({unknown(ends[end].minus) + Column_index(c), sign});
        append_functional(ends[end].plus, Group::matrix(m_complex.element[b])[c], -sign);
        if(translation(b) >= 0)
          m_row.push_back({translation(b) + Column_index(c), -1});
        else if(end == 0)
          continue;
        add_row({Row_origin::BRANCH, b, translation(b) >= 0 && end == 1}, builder);
      }
  }

  // f(u) = a at both ends, [MC19] Eq. (5). Without a: the difference of both.
  void add_chain_rows(const std::size_t c, System_builder& builder)
  {
    const auto f = Group::functional(m_complex.functional[c]);
    append_functional(m_complex.links[c].front(), f, 1);
    if(level(c) >= 0) {
      m_row.push_back({level(c), -1});
      add_row({Row_origin::CHAIN, c, false}, builder);
      m_row.push_back({level(c), -1});
    }
    append_functional(m_complex.links[c].back(), f, level(c) < 0 ? -1 : 1);
    add_row({Row_origin::CHAIN, c, level(c) >= 0}, builder);
  }

  // [MC19] Eq. (6), the transitions composed: f'(g u(a) + t - u(b)), with t the sum of the
  // branches' translations as the transitions behind them turn these. Eqs. (7) and (9) are
  // not needed.
  void append_path(const typename Complex::Path& path)
  {
    int f = path.functional;
    for(const auto& crossing : path.crossings)
      f = Group::act(element_across(crossing), f).index;
    const auto wanted = Group::functional(f);
    Element behind = Group::identity(); // across the crossings behind
    for(auto crossing = path.crossings.rbegin(); crossing != path.crossings.rend(); ++crossing) {
      const Element before = Group::compose(behind, element_across(*crossing));
      if(crossing->is_along) // u' = g u + t
        append_translation(crossing->branch, Group::times_matrix(wanted, behind), 1);
      else                   // u' = g^-1 (u - t)
        append_translation(crossing->branch, Group::times_matrix(wanted, before), -1);
      behind = before;
    }
    append_functional(path.a, Group::times_matrix(wanted, behind), 1);
    append_functional(path.b, wanted, -1);
  }

  Element element_across(const typename Complex::Crossing& crossing) const
  {
    const Element g = m_complex.element[std::size_t(crossing.branch)];
    return crossing.is_along ? g : Group::inverse(g);
  }

  void add_equation(const std::size_t i, System_builder& builder)
  {
    std::vector<Entry<Exact_rational> > row;
    for(const auto& term : m_complex.equations[i].terms)
      row.push_back({unknown(term.sector) + Column_index(term.coordinate), term.coefficient});
    builder.add_row(row, m_complex.equations[i].right_hand_side);
    m_origins.push_back({Row_origin::EQUATION, i, false});
  }

  // factor f(u) for a sector
  void append_functional(const Sector_index s, const Functional<dimension>& f,
                         const std::int64_t factor)
  { append(unknown(s), f, factor); }

  // Appends the vector whose coordinate 0 has the given column.
  void append(const Column_index vector, const Functional<dimension>& f, const std::int64_t factor)
  {
    for(std::size_t d = 0; d < dimension; ++d)
      if(f[d] != 0)
        m_row.push_back({vector + Column_index(d), factor * f[d]});
  }

  // factor f(t) for the translation of a branch: unknowns or, without these, u- - g u+ at its
  // beginning.
  void append_translation(const Branch_index branch, const Functional<dimension>& f,
                          const std::int64_t factor)
  {
    const std::size_t b = std::size_t(branch);
    if(translation(b) >= 0) {
      append(translation(b), f, factor);
    } else {
      const Pair& first = m_complex.pairs[b].front();
      append_functional(first.minus, f, factor);
      append_functional(first.plus, Group::times_matrix(f, m_complex.element[b]), -factor);
    }
  }

  void add_row(const Row_origin& origin, System_builder& builder)
  {
    builder.add_row(m_row);
    m_row.clear();
    m_origins.push_back(origin);
  }

  const Complex& m_complex;
  std::vector<Column_index> m_unknown, m_translation, m_level;
  std::vector<double> m_weights;
  std::size_t m_number_of_node_columns = 0;
  Column_index m_end_of_vectors = 0, m_first_sum = 0;
  Row m_row; // under way
  std::vector<Row_origin> m_origins;
  Scaled_system m_rows;
};

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
extern template class Reduced_system<Rotation_group<4> >;
extern template class Reduced_system<Rotation_group<6> >;
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_REDUCED_SYSTEM_H
