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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELLS_WITH_BORDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELLS_WITH_BORDER_H

#include <CGAL/license/Quad_remeshing.h>

// Cells that have a part of the border in their interior. Where the border crosses a side of a
// cell, the dart there has no twin, and the cell is not closed; but a hole may lie inside of a cell
// altogether, or touch its sides.

#include <CGAL/Quad_remeshing/internal/cells/Cell_complex.h>
#include <CGAL/Quad_remeshing/internal/cells/Dart_tracer.h>
#include <CGAL/Quad_remeshing/internal/cells/Grid_cells.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

template <typename Group>
class Border_cells
{
  using Mesh = Basic_chart_mesh<Group>;
  using Decisions = Basic_integer_decisions<Group>;
  using Shape = Cell_shape<Group>;

public:
  Border_cells(const Mesh& mesh, const Cell_complex& complex)
    : m_mesh(mesh), m_complex(complex), m_decisions(mesh, m_no_features, m_step),
      m_tracer(mesh, complex.points, complex.darts, m_no_features),
      m_is_visited(mesh.corners.size() / 3, false)
  { }

  // Marks, per cell; or nothing if a part of the border lies along no side of the cell around it,
  // which can't be.
  std::optional<std::vector<char> > find()
  {
    std::vector<char> is_found(m_complex.cells.size(), false);
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const Corner_index h = Corner_index(i);
      Side side;
      if(m_mesh.opposite(h) != no_index || is_on_grid_line(m_mesh, h) || !is_in_cell(h, side))
        continue;
      const Cell_index cell = cell_around(face_of(h), side);
      if(cell != no_cell)
        is_found[std::size_t(cell)] = true;
    }
    if(m_is_lost)
      return std::nullopt;
    return is_found;
  }

private:
  // A side of a cell, which stands for the cell at its left.
  struct Side
  {
    Uv start{};
    Direction direction = Group::identity();

    Uv end() const { return unit_step<Group>(start, direction); }
    Side next() const { return {end(), turned<Group>(direction, Shape::turns_at_corner)}; }
  };

  // Whether no line of the grid crosses the edge. Then it gives a side of its cell.
  bool is_in_cell(const Corner_index h, Side& side) const
  {
    double low[Group::number_of_functionals];
    for(std::size_t c = 0; c < std::size_t(Group::number_of_functionals); ++c) {
      const auto a = m_mesh.component(Mesh::prev(h), c), b = m_mesh.component(h, c);
      const bool is_upwards = compare(a, b) < 0;
      low[c] = static_cast<double>(floor_integer(is_upwards ? a : b));
      if(Decisions::side_of(low[c] + 1, is_upwards ? b : a) > 0)
        return false;
    }
    side = {{low[0], low[1]}, Group::identity()};
    if constexpr(!Shape::is_square)
      if(low[2] > low[0] + low[1]) // the other triangle of the square
        side = {{low[0] + 1, low[1] + 1}, Group::element(Group::order / 2)};
    return true;
  }

  // From face to face inside of the cell until a side of it is found.
  Cell_index cell_around(const std::size_t first_face, const Side& first_side)
  {
    std::vector<std::pair<std::size_t, Side> > to_visit(1, {first_face, first_side});
    while(!to_visit.empty()) {
      const auto [face, side] = to_visit.back();
      to_visit.pop_back();
      if(m_is_visited[face])
        continue;
      Cell_index cell = no_cell;
      if(find_cell(face, side, cell))
        return cell;
      m_is_visited[face] = true; // which lies inside, and in no other cell
      for(Corner_index h = Corner_index(3 * face); h < Corner_index(3 * face + 3); ++h)
        if(m_mesh.opposite(h) != no_index)
          to_visit.emplace_back(face_of(m_mesh.opposite(h)), side_beyond(h, side));
    }
    return no_cell;
  }

  Side side_beyond(const Corner_index h, const Side& side) const
  {
    const auto rotation = m_mesh.rotation(h);
    const Corner_index g = m_mesh.opposite(h);
    return {carried<Group>(side.start, rotation, m_mesh.uv(h), m_mesh.uv(Mesh::prev(g))),
            turned<Group>(side.direction, rotation)};
  }

  // Whether a side of the cell runs through the face or, if the face lies inside of the cell, along
  // its edges; then that is followed to its end.
  bool find_cell(const std::size_t face, Side side, Cell_index& cell)
  {
    const Corner_index corner = Corner_index(3 * face);
    Dart_index twin = untraced_dart;
    for(int k = 0; k < Shape::number_of_corners && twin == untraced_dart; ++k, side = side.next())
      if(is_before_exit(corner, side.start, side.direction) &&
         is_before_exit(corner, side.end(), reversed<Group>(side.direction)))
        twin = m_tracer.trace_through_face(corner, side.end(), side.direction);
    for(Corner_index h = corner; h < corner + 3 && twin == untraced_dart; ++h)
      if(is_on_grid_line(m_mesh, h)) {
        const Direction along = sector<Group>(m_mesh.uv(Mesh::prev(h)), m_mesh.uv(h));
        for(int k = 0; k < Shape::number_of_corners && side.direction != along; ++k)
          side = side.next();
        if(side.direction == along)
          twin = m_tracer.trace_along_edge(h, side.end(), along);
        else
          m_is_lost = true;
      }
    if(twin >= 0)
      cell = m_complex.cells.cell(m_complex.darts.clockwise(std::size_t(twin)));
    return twin != untraced_dart;
  }

  // Whether the line through the point in this direction leads through the interior of the face,
  // and the point comes before the line leaves it.
  bool is_before_exit(const Corner_index corner, const Uv& point, const Direction direction)
  {
    typename Decisions::State state;
    state.halfedge = corner;
    state.direction = direction;
    state.level = Group::value(int(constant_component<Group>(direction)), point);
    int lowest = 1, highest = -1;
    for(Corner_index h = corner; h < corner + 3; ++h) {
      const int side = side_of_corner<Decisions>(m_mesh, state, h);
      lowest = (std::min)(lowest, side);
      highest = (std::max)(highest, side);
    }
    if(lowest >= 0 || highest <= 0)
      return false;
    leave_face_point<Decisions>(m_mesh, state);
    m_step.end = point;
    return m_decisions.ends_before(state) && m_step.place == Lattice_place::FACE;
  }

  const Mesh& m_mesh;
  const Cell_complex& m_complex;
  const std::vector<char> m_no_features;
  Unit_step m_step;
  Decisions m_decisions;
  Basic_dart_tracer<Group> m_tracer;
  std::vector<char> m_is_visited; // per face
  bool m_is_lost = false;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELLS_WITH_BORDER_H
