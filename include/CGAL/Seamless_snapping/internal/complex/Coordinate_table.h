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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COORDINATE_TABLE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COORDINATE_TABLE_H

#include <CGAL/license/Seamless_snapping.h>

// The coordinates of the sectors of a complex as sums of its free unknowns, in one list.

#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/complex/Sparse_row.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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

  // row(target) - row(source), as it enters the energy of an edge.
  void difference(const std::size_t target_sector, const std::size_t source_sector,
                  const std::size_t c, Sparse_row& row) const
  {
    row.clear();
    const auto add = [&](const std::size_t i, const double sign)
    {
      for(std::size_t j = m_begin[i]; j < m_begin[i + 1]; ++j)
        row.emplace_back(m_terms[j].first, sign * m_terms[j].second);
    };
    add(2 * target_sector + c, 1);
    add(2 * source_sector + c, -1);
    normalize(row);
  }

private:
  std::vector<std::size_t> m_begin;
  Sparse_row m_terms;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COORDINATE_TABLE_H
