// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_CELLS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_CELLS_H

#include <CGAL/license/Quad_remeshing.h>

// The cells that darts enclose. A dart has its cell at the left; it is also the side of one corner
// of that cell, at its origin, where the next dart counterclockwise is the other side.

#include <CGAL/Quad_remeshing/internal/cells/Grid_darts.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The cells between the lines of the grid: squares, or the triangles of the lattice.
// \tparam Group the group of the directions of lines
template <typename Group>
struct Cell_shape
{
  static constexpr bool is_square = Group::is_signed_permutation;
  static constexpr int number_of_corners = is_square ? 4 : 3;
  static constexpr int cells_of_unit = is_square ? 1 : 2; // of area in the domain
  static constexpr int corners_of_unit = number_of_corners * cells_of_unit;

  // From the direction of a side to the direction of the next side.
  static constexpr int turns_at_corner = Group::order / number_of_corners;

  static const char* plural() { return is_square ? "quads" : "triangles"; }
};

using Cell_index = std::int32_t;
constexpr Cell_index no_cell = -1;

class Grid_cells
{
public:
  // Empty until find() is called, once the twins are known.
  explicit Grid_cells(const Grid_darts& darts) : m_darts(darts) { }

  void find()
  {
    constexpr Cell_index cut = -2; // no cell, and looked at
    m_cells.assign(m_darts.size(), no_cell);
    for(std::size_t d = 0; d < m_darts.size(); ++d) {
      if(m_cells[d] != no_cell || !m_darts.has_corner(d))
        continue;
      const std::size_t degree = label_orbit(d, Cell_index(m_first_darts.size()));
      m_number_of_corners += degree;
      if(degree > 0)
        m_first_darts.push_back(Dart_index(d));
      else
        label_orbit(d, cut);
    }
    if(has_gaps())
      for(Cell_index& cell : m_cells)
        if(cell == cut)
          cell = no_cell;
  }

  // Whether there is a dart without a cell.
  bool has_gaps() const { return m_number_of_corners < m_cells.size(); }

  // The next dart around the cell of a dart that has one.
  std::size_t next(const std::size_t d) const
  { return m_darts.clockwise(std::size_t(m_darts.twins[d])); }

  std::size_t size() const { return m_first_darts.size(); }
  Cell_index cell(const std::size_t d) const { return m_cells[d]; }
  std::size_t first_dart(const std::size_t cell) const { return std::size_t(m_first_darts[cell]); }

  std::size_t degree(const std::size_t cell) const
  {
    std::size_t n = 0;
    for_darts(cell, [&](std::size_t) { ++n; });
    return n;
  }

  // Calls f(dart) for the sides of a cell, counterclockwise.
  template <typename Function>
  void for_darts(const std::size_t cell, const Function& f) const
  {
    std::size_t d = first_dart(cell);
    do {
      f(d);
      d = next(d);
    } while(d != first_dart(cell));
  }

  // Corners of cells that the border cuts off, in connected pieces.
  std::size_t number_of_cut_cells() const
  {
    std::size_t n = 0;
    for(std::size_t d = 0; has_gaps() && d < m_darts.size(); ++d)
      if(m_darts.has_corner(d) && m_cells[d] == no_cell) {
        const Dart_index before = m_darts.twins[m_darts.counterclockwise(d)];
        n += before < 0 || !m_darts.has_corner(std::size_t(before)) ? 1 : 0;
      }
    return n;
  }

  // Leaves out the cells that are marked.
  void remove(const std::vector<char>& is_removed)
  {
    std::vector<Cell_index> number(size(), no_cell);
    std::size_t n = 0;
    for(std::size_t c = 0; c < size(); ++c)
      if(!is_removed[c]) {
        number[c] = Cell_index(n);
        m_first_darts[n++] = m_first_darts[c];
      }
    m_first_darts.resize(n);
    m_number_of_corners = 0;
    for(Cell_index& cell : m_cells)
      if(cell != no_cell) {
        cell = number[std::size_t(cell)];
        m_number_of_corners += cell != no_cell ? 1 : 0;
      }
  }

private:
  // Labels the darts from d on until one comes again, and returns their number; or until the border
  // comes in between, and returns 0. Since no two darts have the same next one, the first that
  // comes again is d.
  std::size_t label_orbit(const std::size_t d, const Cell_index label)
  {
    std::size_t degree = 0, e = d;
    do {
      m_cells[e] = label;
      ++degree;
      if(m_darts.twins[e] < 0)
        return 0;
      e = next(e);
      if(!m_darts.has_corner(e))
        return 0;
    } while(e != d);
    return degree;
  }

  const Grid_darts& m_darts;
  std::vector<Cell_index> m_cells;        // per dart
  std::vector<Dart_index> m_first_darts;  // per cell
  std::size_t m_number_of_corners = 0;    // of all cells
};

// The vertices of the cells: one for each point, but where cells around a point leave gaps that
// stay, one for each of their fans, since no halfedge data structure can hold several at a vertex.
class Cell_vertices
{
public:
  // is_gap(dart) tells of the cell at the left.
  template <typename ConcurrencyTag, typename Is_gap>
  static Cell_vertices make(const std::size_t number_of_points, const Grid_darts& darts,
                            const Is_gap& is_gap)
  {
    Cell_vertices result;
    result.m_vertices.resize(darts.size(), boost::container::default_init);
    const std::vector<Chunk> points = chunks_of(number_of_points);
    const auto fans = results_of_chunks<std::vector<Point_index>, ConcurrencyTag>(
      number_of_points, [&](const Chunk& chunk) {
        std::vector<Point_index> points_of_fans;
        for(std::size_t p = chunk.begin; p < chunk.end; ++p)
          result.add_fans(p, darts, is_gap, points_of_fans);
        return points_of_fans;
      });
    const std::vector<Chunk> vertices = append<ConcurrencyTag>(fans, result.m_points);
    for_each_chunk<ConcurrencyTag>(points, [&](const Chunk& chunk) {
      for(std::size_t d = darts.first(chunk.begin); d < darts.first(chunk.end); ++d)
        result.m_vertices[d] += std::int32_t(vertices[chunk.index].begin);
    });
    return result;
  }

  std::size_t size() const { return m_points.size(); }
  std::size_t point(const std::size_t vertex) const { return std::size_t(m_points[vertex]); }

  // The vertex at the corner of the cell at the left of the dart.
  std::size_t vertex(const std::size_t d) const { return std::size_t(m_vertices[d]); }

private:
  // Numbers the darts of a point from the number of the darts before.
  template <typename Is_gap>
  void add_fans(const std::size_t p, const Grid_darts& darts, const Is_gap& is_gap,
                std::vector<Point_index>& fans)
  {
    const std::size_t first = darts.first(p), end = darts.first(p + 1);
    std::size_t start = first; // of a fan, if there is a gap
    for(std::size_t d = first; d < end; ++d)
      if(is_gap(d))
        start = d;
    bool is_in_fan = false;
    std::size_t d = start;
    for(std::size_t i = first; i < end; ++i, d = darts.counterclockwise(d)) {
      const bool is_fan = !is_gap(d);
      if(is_fan && !is_in_fan)
        fans.push_back(Point_index(p));
      m_vertices[d] = std::int32_t(fans.size()) - 1; // of no meaning in a gap
      is_in_fan = is_fan;
    }
  }

  boost::container::vector<std::int32_t> m_vertices; // per dart
  boost::container::vector<Point_index> m_points;    // per vertex
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_CELLS_H
