// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_REDUCED_ROWS_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_REDUCED_ROWS_H

#include <CGAL/license/Linear_snapping.h>

// Other rows with the same solutions, short and nearly orthogonal: where rows are nearly parallel,
// the least-squares problem loses all its digits.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/lattice_reduction.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// A reduced basis of the lattice that the rows span; right-hand sides follow.
// \pre the rows are linearly independent
inline Integer_system reduced_rows(const Integer_system& system, const std::vector<Row_index>& rows,
                                   const std::vector<double>& weights)
{
  const std::size_t n = system.number_of_columns();
  std::vector<std::vector<Exact_integer> > basis;
  for(const Row_index row : rows) {
    basis.emplace_back(n + 1, Exact_integer(0)); // the right-hand side is the last
    const Integer_row<Exact_integer> exact = system.exact_row(std::size_t(row));
    for(const Entry<Exact_integer>& e : exact.entries)
      basis.back()[std::size_t(e.column)] = e.coefficient;
    basis.back()[n] = exact.right_hand_side;
  }
  std::vector<double> scale;
  for(const double w : weights)
    scale.push_back(1. / std::sqrt(w));
  scale.push_back(0.);
  Lattice_reduction<Exact_integer>(basis, scale);

  Integer_system result(n);
  result.set_right_hand_scale(system.right_hand_scale());
  for(const std::vector<Exact_integer>& v : basis) {
    Integer_row<Exact_integer> row;
    for(std::size_t j = 0; j < n; ++j)
      if(v[j] != 0)
        row.entries.push_back({Column_index(j), v[j]});
    row.right_hand_side = v[n];
    result.add_row(std::move(row));
  }
  return result;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_REDUCED_ROWS_H
