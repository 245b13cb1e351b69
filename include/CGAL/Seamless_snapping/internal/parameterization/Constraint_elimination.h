// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CONSTRAINT_ELIMINATION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CONSTRAINT_ELIMINATION_H

#include <CGAL/license/Seamless_snapping.h>

// Homogeneous linear constraints and their elimination: each unknown as a sparse combination of
// those that stay free.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

// Pairs of an unknown and its coefficient, in the order of the unknowns.
using Sparse_row = std::vector<std::pair<std::size_t, double> >;

// Sorts a row and adds up what refers to the same unknown. Coefficients are small dyadic numbers,
// so that sums which are zero come out as zero; the threshold is for chains of other pivots.
inline void normalize(Sparse_row& row)
{
  constexpr double zero = 1e-12;
  std::sort(row.begin(), row.end());
  std::size_t size = 0;
  for(std::size_t i = 0; i < row.size(); ) {
    auto term = row[i];
    for(++i; i < row.size() && row[i].first == term.first; ++i)
      term.second += row[i].second;
    if(std::abs(term.second) > zero)
      row[size++] = term;
  }
  row.resize(size);
}

// Invariant: the solution space of all constraints added so far is that of the substitutions.
class Constraint_elimination
{
public:
  explicit Constraint_elimination(const std::size_t number_of_unknowns)
    : m_substitution(number_of_unknowns)
    , m_is_eliminated(number_of_unknowns, false)
  { }

  // Adds the constraints row = 0. Pivots are the unknowns that occur in the fewest constraints: the
  // translations of branches that end at a cone, and so chains of junctions don't fill up.
  void add(const std::vector<Sparse_row>& rows)
  {
    std::vector<std::size_t> count(m_substitution.size(), 0);
    for(const Sparse_row& row : rows)
      for(const auto& term : row)
        ++count[term.first];
    for(const Sparse_row& row : rows)
      eliminate(row, count);
  }

  // To be called once, after the last constraint: leaves only free unknowns in the substitutions.
  void finish()
  {
    for(auto it = m_order.rbegin(); it != m_order.rend(); ++it)
      m_substitution[*it] = reduced(m_substitution[*it]);
  }

  bool is_eliminated(const std::size_t unknown) const { return m_is_eliminated[unknown]; }

  const Sparse_row& substitution(const std::size_t unknown) const
  {
    return m_substitution[unknown];
  }

private:
  Sparse_row reduced(Sparse_row row) const
  {
    normalize(row);
    for(bool changed = true; changed; ) {
      changed = false;
      Sparse_row result;
      for(const auto& [unknown, coefficient] : row) {
        if(!m_is_eliminated[unknown]) {
          result.emplace_back(unknown, coefficient);
          continue;
        }
        changed = true;
        for(const auto& [other, factor] : m_substitution[unknown])
          result.emplace_back(other, coefficient * factor);
      }
      if(changed)
        normalize(result);
      row.swap(result);
    }
    return row;
  }

  void eliminate(const Sparse_row& constraint, const std::vector<std::size_t>& count)
  {
    const Sparse_row row = reduced(constraint);
    if(row.empty())
      return;
    const auto is_better = [&count](const auto& a, const auto& b)
    {
      const bool a_is_unit = std::abs(a.second) == 1, b_is_unit = std::abs(b.second) == 1;
      return a_is_unit != b_is_unit ? a_is_unit : count[a.first] < count[b.first];
    };
    const auto pivot = *std::min_element(row.begin(), row.end(), is_better);
    Sparse_row& substitution = m_substitution[pivot.first];
    for(const auto& term : row)
      if(term.first != pivot.first)
        substitution.emplace_back(term.first, -term.second / pivot.second);
    m_is_eliminated[pivot.first] = true;
    m_order.push_back(pivot.first);
  }

  std::vector<Sparse_row> m_substitution;
  std::vector<char> m_is_eliminated;
  std::vector<std::size_t> m_order;
};

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CONSTRAINT_ELIMINATION_H
