// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POLYGON_COMPLEX_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POLYGON_COMPLEX_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Polygons glued along edges, as plain arrays.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Darts 2 e and 2 e + 1 are the two sides of edge e. The members are those that `Cell_writer` asks
// for.
struct Polygon_complex
{
  std::size_t n_vertices = 0, n_cells = 0;
  std::vector<std::int32_t> targets; // per dart
  std::vector<std::int32_t> nexts;   // around the same cell, or along the border
  std::vector<std::int32_t> cells;   // -1 outside

  std::size_t number_of_vertices() const { return n_vertices; }
  std::size_t number_of_cells() const { return n_cells; }
  std::size_t number_of_darts() const { return targets.size(); }
  static bool is_edge(std::size_t) { return true; }
  static std::size_t twin(const std::size_t d) { return d ^ 1; }
  std::size_t next(const std::size_t d) const { return std::size_t(nexts[d]); }
  std::size_t target(const std::size_t d) const { return std::size_t(targets[d]); }
  std::int32_t cell(const std::size_t d) const { return cells[d]; }
};

// Whether no edge is a loop or has the same cell on both sides, and no two have the same ends, as
// polygon meshes must have it.
inline bool is_simple(const Polygon_complex& complex)
{
  std::vector<std::pair<std::int32_t, std::int32_t> > ends;
  for(std::size_t d = 0; d < complex.number_of_darts(); d += 2) {
    ends.push_back(std::minmax(complex.targets[d], complex.targets[d + 1]));
    if(ends.back().first == ends.back().second || complex.cells[d] == complex.cells[d + 1])
      return false;
  }
  std::sort(ends.begin(), ends.end());
  return std::adjacent_find(ends.begin(), ends.end()) == ends.end();
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POLYGON_COMPLEX_H
