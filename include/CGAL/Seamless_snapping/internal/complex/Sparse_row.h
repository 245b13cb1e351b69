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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SPARSE_ROW_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SPARSE_ROW_H

#include <CGAL/license/Seamless_snapping.h>

// Sums of a few unknowns.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Pairs of an unknown and its coefficient: an integer that a double holds exactly, so that sums
// which are zero come out as zero.
using Sparse_row = std::vector<std::pair<std::size_t, double> >;

// Sorts a row and adds up what refers to the same unknown.
inline void normalize(Sparse_row& row)
{
  std::sort(row.begin(), row.end());
  std::size_t size = 0;
  for(std::size_t i = 0; i < row.size(); ) {
    auto term = row[i];
    for(++i; i < row.size() && row[i].first == term.first; ++i)
      term.second += row[i].second;
    if(term.second != 0)
      row[size++] = term;
  }
  row.resize(size);
}

// row += factor * other
inline void append(Sparse_row& row, const Sparse_row& other, const double factor = 1)
{
  for(const auto& term : other)
    row.emplace_back(term.first, factor * term.second);
}

inline double value_of(const Sparse_row& row, const std::vector<double>& values)
{
  double sum = 0;
  for(const auto& [unknown, coefficient] : row)
    sum += coefficient * values[unknown];
  return sum;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_SPARSE_ROW_H
