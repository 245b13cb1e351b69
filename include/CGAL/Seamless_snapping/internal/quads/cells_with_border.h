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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_CELLS_WITH_BORDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_CELLS_WITH_BORDER_H

#include <CGAL/license/Seamless_snapping.h>

// Cells that have a part of the border in their interior. Where the border crosses a side of a
// cell, the dart there has no twin, and the cell is not closed; but a hole may lie inside of a cell
// altogether, or touch its sides.

#include <CGAL/Seamless_snapping/internal/quads/Dart_tracer.h>
#include <CGAL/Seamless_snapping/internal/quads/Quad_complex.h>
#include <CGAL/Seamless_snapping/internal/quads/Surface_parts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Border_cells
{
public:
  Border_cells(const Chart_mesh& mesh, const Quad_complex& complex)
    : m_mesh(mesh), m_complex(complex), m_decisions(mesh, m_no_features, m_step),
      m_tracer(mesh, complex.points, complex.darts, m_no_features),
      m_is_visited(mesh.corners.size() / 3, false)
  { }

  // Marks, per cell.
  std::vector<char> find()
  {
    std::vector<char> is_found(m_complex.cells.size(), false);
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const Corner_index h = Corner_index(i);
      Uv center;
      if(m_mesh.opposite(h) != no_index || is_on_grid_line(m_mesh, h) || !is_in_cell(h, center))
        continue;
      const Cell_index cell = cell_around(face_of(h), center);
      if(cell != no_cell)
        is_found[std::size_t(cell)] = true;
    }
    return is_found;
  }

private:
  // Whether no line of the grid crosses the edge. Then it gives the center of its cell.
  bool is_in_cell(const Corner_index h, Uv& center) const
  {
    const Uv &a = m_mesh.uv(Chart_mesh::prev(h)), &b = m_mesh.uv(h);
    for(std::size_t c = 0; c < 2; ++c) {
      const double low = static_cast<double>(floor_integer((std::min)(a[c], b[c])));
      if((std::max)(a[c], b[c]) > low + 1)
        return false;
      center[c] = low + 0.5;
    }
    return true;
  }

  // From face to face inside of the cell until a side of it is found.
  Cell_index cell_around(const std::size_t first_face, const Uv& first_center)
  {
    std::vector<std::pair<std::size_t, Uv> > to_visit(1, {first_face, first_center});
    while(!to_visit.empty()) {
      const auto [face, center] = to_visit.back();
      to_visit.pop_back();
      if(m_is_visited[face])
        continue;
      Cell_index cell = no_cell;
      if(find_side(face, center, cell))
        return cell;
      m_is_visited[face] = true; // which lies inside, and in no other cell
      for(Corner_index h = Corner_index(3 * face); h < Corner_index(3 * face + 3); ++h)
        if(m_mesh.opposite(h) != no_index)
          to_visit.emplace_back(face_of(m_mesh.opposite(h)), center_beyond(h, center));
    }
    return no_cell;
  }

  Uv center_beyond(const Corner_index h, const Uv& center) const
  {
    const Corner_index g = m_mesh.opposite(h);
    return carried(center, m_mesh.rotation(h), m_mesh.uv(h), m_mesh.uv(Chart_mesh::prev(g)));
  }

  // Whether a side of the cell runs through the face or, if the face lies inside of the cell, along
  // its edges; then that is followed to its end.
  bool find_side(const std::size_t face, const Uv& center, Cell_index& cell)
  {
    const Corner_index corner = Corner_index(3 * face);
    Dart_index twin = untraced_dart;
    for(int direction = 0; direction < Quarter_turns::order && twin == untraced_dart; ++direction) {
      const Uv start = cell_corner(center, direction), end = cell_corner(center, direction + 1);
      if(is_before_exit(corner, start, direction) &&
         is_before_exit(corner, end, reversed(direction)))
        twin = m_tracer.trace_through_face(corner, end, direction);
    }
    for(Corner_index h = corner; h < corner + 3 && twin == untraced_dart; ++h)
      if(is_on_grid_line(m_mesh, h)) {
        const int direction = quadrant(m_mesh.uv(Chart_mesh::prev(h)), m_mesh.uv(h));
        twin = m_tracer.trace_along_edge(h, cell_corner(center, direction + 1), direction);
      }
    if(twin >= 0)
      cell = m_complex.cells.cell(m_complex.darts.clockwise(std::size_t(twin)));
    return twin != untraced_dart;
  }

  // Corner k of a cell is where its side in direction k begins.
  static Uv cell_corner(const Uv& center, const int k)
  {
    const Direction d = Quarter_turns::element(k);
    return {center[0] + (d == 0 || d == 3 ? -0.5 : 0.5), center[1] + (d < 2 ? -0.5 : 0.5)};
  }

  // Whether the line through the point in this direction leads through the interior of the face,
  // and the point comes before the line leaves it.
  bool is_before_exit(const Corner_index corner, const Uv& point, const int direction)
  {
    Integer_decisions::State state;
    state.halfedge = corner;
    state.direction = direction;
    state.level = point[constant_component(direction)];
    int lowest = 1, highest = -1;
    for(Corner_index h = corner; h < corner + 3; ++h) {
      const int side = side_of_corner<Integer_decisions>(m_mesh, state, h);
      lowest = (std::min)(lowest, side);
      highest = (std::max)(highest, side);
    }
    if(lowest >= 0 || highest <= 0)
      return false;
    leave_face_point<Integer_decisions>(m_mesh, state);
    m_step.end = point;
    return m_decisions.ends_before(state) && m_step.place == Lattice_place::FACE;
  }

  const Chart_mesh& m_mesh;
  const Quad_complex& m_complex;
  const std::vector<char> m_no_features;
  Unit_step m_step;
  Integer_decisions m_decisions;
  Dart_tracer m_tracer;
  std::vector<char> m_is_visited; // per face
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_CELLS_WITH_BORDER_H
