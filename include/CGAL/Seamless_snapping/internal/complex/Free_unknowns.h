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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_H

#include <CGAL/license/Seamless_snapping.h>

// The solutions of integer equations, over unknowns that are free.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/complex/Sparse_row.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The solutions of homogeneous integer equations. Invariant: each column is a sum of free unknowns
// with integer coefficients; whatever their values are, the equations hold, and any solution is of
// this form.
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

  std::vector<Sparse_row> m_sums; // per column
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/complex/Free_unknowns_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_FREE_UNKNOWNS_H
