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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_COMPLEX_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_COMPLEX_H

#include <CGAL/license/Quad_remeshing.h>

// The cells of the grid on a surface, as they are written.

#include <CGAL/Quad_remeshing/internal/cells/Dart_tracer.h>
#include <CGAL/Quad_remeshing/internal/cells/Grid_cells.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Cell_complex
{
public:
  Cell_complex(Lattice_points&& points_, Grid_darts&& darts_)
    : points(std::move(points_)), darts(std::move(darts_)), cells(darts)
  { }

  Cell_complex(const Cell_complex&) = delete; // members refer to each other
  Cell_complex& operator=(const Cell_complex&) = delete;

  std::size_t next(const std::size_t d) const { return cells.next(d); }
  std::size_t twin(const std::size_t d) const { return std::size_t(darts.twins[d]); }
  bool has_cell(const std::size_t d) const { return cells.cell(d) != no_cell; }

  // Whether the dart and its twin are an edge of the result; one of both stands for it.
  bool is_edge(const std::size_t d) const
  { return darts.twins[d] >= 0 && (has_cell(d) || has_cell(twin(d))); }

  // The vertices of an edge: at the origins of the dart and of its twin.
  std::size_t origin(const Cell_vertices& vertices, const std::size_t d) const
  { return vertices.vertex(has_cell(d) ? d : next(twin(d))); }

  // A cell around a point of one dart, with this dart and its twin as two of its sides.
  struct Folded_cell
  {
    std::size_t point, dart;         // the dart is the only one of the point
    std::array<std::size_t, 2> rest; // the other two sides, to and from the opposite point
    bool is_opposite_free;           // no feature and no border holds the opposite point
  };

  // Leaves out the folded cells, which no face graph can hold, but no two next to each other.
  // The other two sides of each are to become one edge; it is a feature if one of the edges was.
  void leave_out_folded_cells()
  {
    std::vector<char> is_left_out(cells.size(), false);
    for(std::size_t p = 0; p < points.size(); ++p) {
      const std::size_t d = darts.first(p);
      if(darts.degree(p) != 1 || !has_cell(d) || cells.degree(std::size_t(cells.cell(d))) != 4)
        continue;
      const std::size_t to = next(d), from = next(to);
      const Folded_cell folded{p, d, {{to, from}}, is_free(from)};
      if(has_neighbor(folded, is_left_out))
        continue;
      is_left_out[std::size_t(cells.cell(d))] = true;
      m_folded_cells.push_back(folded);
      mark_features(folded);
    }
    for(const Folded_cell& folded : m_folded_cells)
      for(const std::size_t d : {folded.rest[0], folded.rest[1], twin(folded.dart)})
        m_folded_darts.push_back(d);
    std::sort(m_folded_darts.begin(), m_folded_darts.end());
    cells.remove(is_left_out);
  }

  // The folded cells that were left out.
  const std::vector<Folded_cell>& folded_cells() const { return m_folded_cells; }

  // Whether there is no cell at the left of the dart, nor an edge in the place of a folded one.
  bool is_gap(const std::size_t d) const { return !has_cell(d) && !is_folded(d); }

  // Whether the dart has its cell at one side only, and no other edge is to become one with it.
  bool is_border(const std::size_t d) const
  { return is_gap(d) || is_gap(twin(d)); }

  // Whether the dart is a side of a folded cell that was left out, but not from its point.
  bool is_folded(const std::size_t d) const
  { return std::binary_search(m_folded_darts.begin(), m_folded_darts.end(), d); }

  Lattice_points points;
  Grid_darts darts;
  Grid_cells cells;

private:
  // Whether the cell borders on itself, on the border, or on one that is marked.
  bool has_neighbor(const Folded_cell& folded, const std::vector<char>& is_marked) const
  {
    return std::any_of(folded.rest.begin(), folded.rest.end(), [&](const std::size_t d) {
      const Cell_index cell = cells.cell(twin(d));
      return cell == no_cell || cell == cells.cell(d) || is_marked[std::size_t(cell)];
    });
  }

  // Whether neither features nor the border meet the origin of the dart.
  bool is_free(const std::size_t dart) const
  {
    std::size_t d = dart;
    do {
      if(!has_cell(d) || darts.is_feature(d))
        return false;
      d = darts.counterclockwise(d);
    } while(d != dart);
    return true;
  }

  void mark_features(const Folded_cell& folded)
  {
    const std::array<std::size_t, 2>& rest = folded.rest;
    if(darts.is_feature(folded.dart) || darts.is_feature(rest[0]) || darts.is_feature(rest[1]))
      for(const std::size_t d : rest) {
        darts.mark_feature(d);
        darts.mark_feature(twin(d));
      }
  }

  std::vector<Folded_cell> m_folded_cells;
  std::vector<std::size_t> m_folded_darts; // their sides except the sides from their points, sorted
};

// The darts from a vertex along edges to itself, along two or more to one other vertex, or along
// the only one, so that a face has the vertex twice.
inline boost::container::small_vector<std::size_t, 16>
double_edges(const Cell_complex& complex, const Cell_vertices& vertices, const std::size_t v)
{
  boost::container::small_vector<std::pair<std::size_t, std::size_t>, 16> neighbors;
  const std::size_t p = vertices.point(v);
  for(std::size_t d = complex.darts.first(p); d < complex.darts.first(p + 1); ++d)
    if(complex.is_edge(d) && !complex.is_folded(d) && complex.origin(vertices, d) == v)
      neighbors.emplace_back(complex.origin(vertices, complex.twin(d)), d);
  std::sort(neighbors.begin(), neighbors.end());
  boost::container::small_vector<std::size_t, 16> result;
  for(std::size_t i = 0; i < neighbors.size(); ++i) {
    const std::size_t w = neighbors[i].first;
    if(w == v || neighbors.size() == 1 || (i > 0 && neighbors[i - 1].first == w) ||
       (i + 1 < neighbors.size() && neighbors[i + 1].first == w))
      result.push_back(neighbors[i].second);
  }
  return result;
}

// A vertex with such edges, or the number of vertices.
template <typename ConcurrencyTag>
std::size_t vertex_with_double_edges(const Cell_complex& complex, const Cell_vertices& vertices)
{
  return find_first<ConcurrencyTag>(vertices.size(), [&](const std::size_t v)
                                    { return !double_edges(complex, vertices, v).empty(); });
}

// Cells that have a part of the border in their interior. Where the border crosses a side of a
// cell, the dart there has no twin, and the cell is not closed; but a hole may lie inside of a cell
// altogether, or touch its sides.

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

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_COMPLEX_H
