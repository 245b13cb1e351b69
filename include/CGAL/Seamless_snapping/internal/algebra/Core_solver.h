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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CORE_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CORE_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// STUB, being replaced: only empty cores.

#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/algebra/Unit_pivot_elimination.h>

#include <stdexcept>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Integer>
class Core_solver
{
public:
  explicit Core_solver(const Unit_pivot_elimination<Integer>& elimination)
  {
    if(!elimination.core_rows().empty())
      throw std::runtime_error("core not yet supported");
  }

  bool is_consistent() const { return true; }
  std::size_t number_of_redundant_rows() const { return 0; }
  const std::vector<Row_index>& independent_rows() const { return m_independent_rows; }
  Exact_integer largest_coefficient() const { return Exact_integer(0); }
  Exact_integer largest_pivot() const { return Exact_integer(0); }
  const std::vector<Column_index>& columns() const { return m_columns; }
  std::optional<std::size_t> right_hand_shift() const { return 0; }
  bool nearest(std::size_t, const std::vector<Grid_value>&, const std::vector<double>&,
               std::vector<std::int64_t>&) const
  { return true; }

private:
  std::vector<Row_index> m_independent_rows;
  std::vector<Column_index> m_columns;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_CORE_SOLVER_H
