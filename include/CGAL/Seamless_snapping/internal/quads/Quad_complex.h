// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// The cells of the grid on a surface, as they are written.

#include <CGAL/Seamless_snapping/internal/quads/Grid_cells.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Quad_complex
{
public:
  Quad_complex(Lattice_points&& points_, Grid_darts&& darts_)
    : points(std::move(points_)), darts(std::move(darts_)), cells(darts)
  { }

  Quad_complex(const Quad_complex&) = delete; // members refer to each other
  Quad_complex& operator=(const Quad_complex&) = delete;

  std::size_t next(const std::size_t d) const { return cells.next(d); }
  std::size_t twin(const std::size_t d) const { return std::size_t(darts.twins[d]); }
  bool has_cell(const std::size_t d) const { return cells.cell(d) != no_cell; }

  // Whether the dart and its twin are an edge of the result; one of both stands for it.
  bool is_edge(const std::size_t d) const
  { return darts.twins[d] >= 0 && (has_cell(d) || has_cell(twin(d))); }

  // The vertices of an edge: that at the origin of the dart, and that of its twin.
  std::size_t origin(const Cell_vertices& vertices, const std::size_t d) const
  { return vertices.vertex(has_cell(d) ? d : next(twin(d))); }

  Lattice_points points;
  Grid_darts darts;
  Grid_cells cells;
};

// A vertex that has an edge to itself, or two edges to another one, or one edge in all, so that its
// face has a vertex twice; or the number of vertices.
template <typename ConcurrencyTag>
std::size_t vertex_with_double_edges(const Quad_complex& complex, const Cell_vertices& vertices)
{
  return find_first<ConcurrencyTag>(vertices.size(), [&](const std::size_t v) {
    boost::container::small_vector<std::size_t, 16> neighbors(1, v);
    const std::size_t p = vertices.point(v);
    for(std::size_t d = complex.darts.first(p); d < complex.darts.first(p + 1); ++d)
      if(complex.is_edge(d) && complex.origin(vertices, d) == v)
        neighbors.push_back(complex.origin(vertices, complex.twin(d)));
    std::sort(neighbors.begin(), neighbors.end());
    return neighbors.size() == 2 ||
           std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end();
  });
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_COMPLEX_H
