// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_VERTICES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_VERTICES_H

#include <CGAL/license/Hexahedral_meshing.h>

// The points of the integer grid in the cells of a map: the vertices of hexahedra, and, shifted by
// halves, their centers and the middles of their edges.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_map.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// So many cells are a piece of work for a thread.
constexpr std::size_t cells_of_chunk = 128;

// Calls f(point) for the points of the grid, shifted by 0 or 1/2 in each coordinate, that a cell
// contains, in lexicographic order.
template <typename F>
void for_each_grid_point(const Cell_sides& sides, const std::int32_t cell, const Uvw& shift,
                         const F& f)
{
  Uvw least, largest;
  for(std::size_t c = 0; c < 3; ++c) {
    const auto& u = sides.corners();
    least[c] = (std::min)((std::min)(u[0][c], u[1][c]), (std::min)(u[2][c], u[3][c]));
    largest[c] = (std::max)((std::max)(u[0][c], u[1][c]), (std::max)(u[2][c], u[3][c]));
  }
  const auto first = [&](const std::size_t c, const double bound)
  { return std::ceil(bound - shift[c]) + shift[c]; };
  Cell_point point{cell, {}, 0};
  Uvw& p = point.p;
  for(p[0] = first(0, least[0]); p[0] <= largest[0]; ++p[0])
    for(p[1] = first(1, least[1]); p[1] <= largest[1]; ++p[1]) {
      double low = least[2], high = largest[2];
      sides.clip_row(p, low, high);
      for(p[2] = first(2, low); p[2] <= high; ++p[2]) {
        point.facets = sides.facets_at(p);
        if(point.facets != outside)
          f(point);
      }
    }
}

// The vertices, numbered by their places.
class Grid_vertices
{
public:
  template <typename ConcurrencyTag>
  Grid_vertices(const Grid_map& map, ConcurrencyTag)
    : m_first(map.number_of_cells() + 1, 0)
  {
    const auto points = results_of_chunks<std::vector<Uvw>, ConcurrencyTag>(
      map.number_of_cells(), [&](const Chunk& chunk) { return points_of(map, chunk); },
      cells_of_chunk);
    for(std::size_t c = 0; c < map.number_of_cells(); ++c)
      m_first[c + 1] += m_first[c];
    m_points.reserve(m_first.back());
    for(const std::vector<Uvw>& some : points)
      m_points.insert(m_points.end(), some.begin(), some.end());
  }

  std::size_t size() const { return m_points.size(); }
  const Uvw& point(const std::size_t v) const { return m_points[v]; }
  std::size_t begin_of_cell(const std::size_t cell) const { return m_first[cell]; }
  std::size_t end_of_cell(const std::size_t cell) const { return m_first[cell + 1]; }

  // The vertex in a place; -1 if there is none.
  std::int32_t find(const Cell_point& place) const
  {
    const auto begin = m_points.begin() + std::ptrdiff_t(m_first[std::size_t(place.cell)]),
               end = m_points.begin() + std::ptrdiff_t(m_first[std::size_t(place.cell) + 1]);
    const auto found = std::lower_bound(begin, end, place.p);
    return found != end && *found == place.p ? std::int32_t(found - m_points.begin()) : -1;
  }

private:
  // The numbers of points of cells stand in `m_first` behind the cells meanwhile.
  std::vector<Uvw> points_of(const Grid_map& map, const Chunk& chunk)
  {
    std::vector<Uvw> result;
    for(std::size_t c = chunk.begin; c < chunk.end; ++c) {
      const std::size_t before = result.size();
      const auto cell = std::int32_t(c);
      for_each_grid_point(map.sides(cell), cell, {0, 0, 0}, [&](const Cell_point& point) {
        if(map.is_in_place(point))
          result.push_back(point.p);
      });
      m_first[c + 1] = result.size() - before;
    }
    return result;
  }

  std::vector<std::size_t> m_first; // per cell
  std::vector<Uvw> m_points;        // in the charts of their cells
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_VERTICES_H
