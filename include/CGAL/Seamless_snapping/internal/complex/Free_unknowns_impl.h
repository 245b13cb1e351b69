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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// Eliminates the equations exactly to find the free unknowns.

#include <CGAL/Linear_snapping/internal/linear/Integer_lattice.h>
#include <CGAL/Linear_snapping/internal/linear/eliminate.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Free_unknowns::Free_unknowns(const Integer_system& system)
{
  const Echelon_form form = eliminate(system);
  m_sums.resize(form.pivot_rows.number_of_columns());
  std::vector<char> is_implied(m_sums.size(), false);
  for(const Column_index c : form.pivot_columns)
    is_implied[std::size_t(c)] = true;
  add_core(form.core_rows, is_implied);
  for(std::size_t c = 0; c < m_sums.size(); ++c)
    if(!is_implied[c])
      m_sums[c].emplace_back(m_size++, 1.);
  std::size_t number_of_terms = 0;
  for(std::size_t i = form.pivot_columns.size(); i-- > 0; ) {
    substitute_back(form.pivot_rows.exact_row(i).entries, form.pivot_columns[i]);
    number_of_terms += m_sums[std::size_t(form.pivot_columns[i])].size();
    if(number_of_terms > most_terms)
      throw Refusal(Outcome::TOO_LARGE, "features and borders link so many coordinates that they "
                                        "take more than a gigabyte; mark fewer features");
  }
}

// The rows that pivots of 1 and -1 leave: a basis of their lattice spans all solutions.
CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void Free_unknowns::add_core(const Integer_system& rows, std::vector<char>& is_implied)
{
  std::vector<Integer_row<Exact_integer> > core_rows;
  for(std::size_t i = 0; i < rows.number_of_rows(); ++i)
    core_rows.push_back(rows.exact_row(i));
  const std::vector<Column_index> columns = renumber_columns(core_rows);
  Integer_system core(columns.size());
  for(Integer_row<Exact_integer>& row : core_rows)
    core.add_row(std::move(row));
  for(const Column_index c : columns)
    is_implied[std::size_t(c)] = true;
  if(columns.empty())
    return;
  const Integer_lattice lattice(core);
  for(const auto& vector : lattice.kernel_basis()) {
    for(const auto& e : vector)
      m_sums[std::size_t(columns[std::size_t(e.column)])].emplace_back(
        m_size, CGAL::to_double(e.coefficient));
    ++m_size;
  }
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void Free_unknowns::substitute_back(const Entries<Exact_integer>& row, const Column_index pivot)
{
  Sparse_row& result = m_sums[std::size_t(pivot)];
  double sign = 0;
  for(const auto& e : row)
    if(e.column == pivot)
      sign = CGAL::to_double(e.coefficient);
    else
      append(result, m_sums[std::size_t(e.column)], CGAL::to_double(e.coefficient));
  for(auto& term : result)
    term.second *= -sign;
  normalize(result);
  result.shrink_to_fit();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_IMPL_H
