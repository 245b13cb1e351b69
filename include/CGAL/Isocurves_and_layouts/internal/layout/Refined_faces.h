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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The mesh refined along the arcs of a layout: each face is cut by the pieces of arcs in it, which
// leaves convex polygons. All of it is decided exactly.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_set.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_place.h>

#include <CGAL/Exact_rational.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Polygons glued along edges, as plain arrays. Darts 2 e and 2 e + 1 are the two sides of edge e.
// The members are the members that `Cell_writer` asks for.
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

// A piece of an arc between two points next to each other, in the direction of half-arc `half`.
struct Arc_step
{
  Curve_index curve;
  Segment_index segment;
  bool is_reversed;          // the arc runs against the curve
  std::int32_t source, target; // points
  Half_arc_index half;
};

class Refined_faces
{
public:
  Refined_faces(const Chart_mesh& mesh, const Curve_set& curves, const Layout& layout);

  // Whether all cells belong to a patch, as they must.
  bool is_covered() const { return m_is_covered; }
  // Two and two patches that no arc separates: cycles around the same one.
  const std::vector<std::pair<Patch_index, Patch_index> >& joined_patches() const
  { return m_joined; }

  const Polygon_complex& cells() const { return m_cells; }
  const Face_point& point(const std::size_t v) const { return m_points[v]; }
  std::size_t patch_of_cell(const std::size_t c) const { return std::size_t(m_patches[c]); }
  // The steps, arc after arc.
  const std::vector<Arc_step>& steps() const { return m_steps; }

  bool is_on_arc(const std::size_t edge) const { return m_half_arcs[edge] != no_index; }

  // The places of the cells in the charts: on halfedges, and along steps through faces; the edge of
  // a step along an edge is no_index.
  const Points_on_edges& points_on_edges() const { return m_on_edges; }

  // The dart from point i on a halfedge to the next one.
  std::int32_t dart_on_halfedge(const Corner_index h, const std::int32_t i) const
  {
    const Corner_index key = m_mesh.edge_key(h);
    const std::int32_t first = m_first_part[std::size_t(key)];
    return h == key ? 2 * (first + i) : 2 * (first + m_on_edges.number_on(h) - i) + 1;
  }

  std::int32_t edge_of_step(const std::size_t i) const { return m_edge_of_step[i]; }

  Exact_rational running_coordinate_of_step(const Arc_step& step, const bool at_target) const
  {
    const Chord& chord = m_curves.chord(step.curve, step.segment);
    const std::int32_t point = at_target ? step.target : step.source;
    const std::int32_t node = m_inner_nodes[std::size_t(point)];
    const std::size_t r = running_component(chord.direction);
    if(node != no_index)
      return m_layout.points[std::size_t(node)].place.uv[r].exact();
    const Curve_segment& segment = segment_of(step);
    const Segment_end& end = at_target != step.is_reversed ? segment.exit : segment.entry;
    return end.place == Isocurve_place::VERTEX
             ? Exact_rational(m_mesh.uv(end.halfedge)[r])
             : running_on_edge(m_mesh, end.halfedge, chord.direction, chord.level);
  }

private:
  // Adds the points of vertices, nodes, and paths; returns the points inside of edges.
  Points_on_edges add_points()
  {
    std::vector<Edge_point> on_edges;
    add_vertices_and_nodes(on_edges);
    for(std::size_t a = 0; a < m_layout.arcs.size(); ++a)
      add_path(a, on_edges);
    return Points_on_edges(m_mesh, on_edges, m_points.size());
  }

  void add_vertices_and_nodes(std::vector<Edge_point>& on_edges)
  {
    for(const Corner_index h : m_mesh.corner_at_vertex)
      m_points.push_back(point_at_vertex(h));
    for(const Layout_point& p : m_layout.points) {
      if(p.place.place == Isocurve_place::VERTEX) {
        m_points_of_nodes.push_back(std::int32_t(m_mesh.vertex(p.place.halfedge)));
        continue;
      }
      m_points_of_nodes.push_back(std::int32_t(m_points.size()));
      m_points.push_back(face_point(m_mesh, p.place));
      if(p.place.place == Isocurve_place::EDGE) {
        const Corner_index h = p.place.halfedge;
        const Uv &a = m_mesh.uv(Chart_mesh::prev(h)), &b = m_mesh.uv(h);
        const std::size_t c = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
        on_edges.push_back(edge_point(m_mesh, m_points_of_nodes.back(), h, c, p.place.uv[c]));
      }
    }
  }

  void mark_inner_points()
  {
    m_inner_nodes.assign(m_points.size(), no_index);
    for(std::size_t n = 0; n < m_layout.points.size(); ++n)
      if(m_layout.points[n].place.place == Isocurve_place::FACE)
        m_inner_nodes[std::size_t(m_points_of_nodes[n])] = std::int32_t(n);
  }

  std::int32_t add_exit(const Curve_index c, const Segment_index s,
                        std::vector<Edge_point>& on_edges)
  {
    const Segment_end& exit = m_curves[c].segments[std::size_t(s)].exit;
    if(exit.place == Isocurve_place::VERTEX)
      return std::int32_t(m_mesh.vertex(exit.halfedge));
    const Chord& chord = m_curves.chord(c, s);
    const std::int32_t point = std::int32_t(m_points.size());
    m_points.push_back(exit_point(m_mesh, m_curves, c, s));
    on_edges.push_back(edge_point(m_mesh, point, exit.halfedge,
                                  constant_component(chord.direction), chord.level));
    return point;
  }

  void add_path(const std::size_t a, std::vector<Edge_point>& on_edges)
  {
    const Layout_arc& arc = m_layout.arcs[a];
    const Curve_piece &first = arc.pieces[0], &second = arc.pieces[1];
    const Segment_index n = Segment_index(m_curves[first.curve].segments.size());
    Arc_step step{first.curve, 0, false, m_points_of_nodes[std::size_t(arc.points[0])], no_index,
                  Half_arc_index(2 * a)};
    const auto go_to = [&](const Segment_index segment, const std::int32_t point) {
      step.segment = segment;
      step.target = point;
      m_steps.push_back(step);
      step.source = point;
    };
    const auto go_along = [&](const Curve_piece& piece) {
      for(Segment_index s = piece.begin; s < piece.end; ++s)
        go_to(s, add_exit(piece.curve, s, on_edges));
    };
    const std::int32_t end = m_points_of_nodes[std::size_t(arc.points[1])];
    go_along(first);
    if(!second.is_reversed) {
      go_along(second); // the rest of a closed wall
      go_to(first.end < n ? first.end : second.end, end);
      return;
    }
    Segment_index segment = first.end; // of the other curve, that comes the other way
    for(Segment_index s = second.end; s-- > second.begin; segment = s) {
      go_to(segment, add_exit(second.curve, s, on_edges));
      step.curve = second.curve;
      step.is_reversed = true;
    }
    go_to(segment, end);
  }

  // The points on a halfedge from its source on, counted from 0; the last one is the target.
  std::int32_t point_on_halfedge(const Corner_index h, const std::int32_t i) const
  {
    const std::int32_t n = m_on_edges.number_on(h);
    if(i == 0 || i == n + 1)
      return std::int32_t(i == 0 ? m_mesh.source(h) : m_mesh.vertex(h));
    return m_on_edges.at(h, i).point;
  }

  // Adds the parts of edges of the mesh, and the edges through faces.
  void add_edges()
  {
    m_first_part.assign(m_mesh.corners.size(), no_index);
    std::int32_t n = 0;
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_mesh.represents_edge(h)) {
        m_first_part[std::size_t(h)] = n;
        n += m_on_edges.number_on(h) + 1;
      }
    m_half_arcs.assign(std::size_t(n), no_index);
    m_first_step.assign(std::size_t(m_mesh.number_of_faces()), no_index);
    m_next_step.assign(m_steps.size(), no_index);
    for(std::size_t i = 0; i < m_steps.size(); ++i) {
      const Curve_segment& segment = segment_of(m_steps[i]);
      if(segment.along != no_index) {
        mark_along(m_steps[i], segment);
        m_edge_of_step.push_back(no_index);
        continue;
      }
      std::int32_t& first = m_first_step[std::size_t(m_mesh.face(segment.exit.halfedge))];
      m_next_step[i] = first;
      first = std::int32_t(i);
      m_edge_of_step.push_back(std::int32_t(m_half_arcs.size()));
      m_half_arcs.push_back(m_steps[i].half);
    }
    m_cells.n_vertices = m_points.size();
    m_cells.targets.assign(2 * m_half_arcs.size(), no_index);
    m_cells.nexts = m_cells.cells = m_cells.targets;
  }

  const Curve_segment& segment_of(const Arc_step& step) const
  { return m_curves[step.curve].segments[std::size_t(step.segment)]; }

  void mark_along(const Arc_step& step, const Curve_segment& segment)
  {
    const Corner_index h = segment.along;
    const std::int32_t n = m_on_edges.number_on(h);
    const bool runs_with_h = (segment.exit.halfedge == h) != step.is_reversed;
    const auto rank = [&](const std::int32_t point, const bool is_source) {
      return std::size_t(point) < m_mesh.number_of_vertices() ? (is_source ? 0 : n + 1)
                                                              : m_on_edges.number_of(point, h);
    };
    const std::int32_t from = rank(runs_with_h ? step.source : step.target, true);
    const std::int32_t to = rank(runs_with_h ? step.target : step.source, false);
    for(std::int32_t i = from; i < to; ++i) {
      const std::int32_t dart = dart_on_halfedge(h, i);
      m_half_arcs[std::size_t(dart / 2)] =
        (dart % 2 == 0) == runs_with_h ? step.half : twin(step.half);
    }
  }

  // A dart that leaves a point of a face, with what it is sorted by.
  struct Outgoing
  {
    int order;
    std::int32_t dart;
    friend bool operator<(const Outgoing& a, const Outgoing& b) { return a.order < b.order; }
  };
  using Star = boost::container::small_vector<Outgoing, 4>;

  // Cuts a face along the steps in it.
  void cut_face(const Flat_face_index f)
  {
    std::array<std::int32_t, 3> first; // of the points on the halfedges
    std::int32_t n = 0;
    for(std::size_t k = 0; k < 3; ++k) {
      first[k] = n;
      n += m_on_edges.number_on(3 * f + Corner_index(k)) + 1;
    }
    m_stars.assign(std::size_t(n), Star());
    m_darts.clear();
    m_halfedges.clear();
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h)
      for(std::int32_t i = 0; i <= m_on_edges.number_on(h); ++i) {
        const std::int32_t dart = dart_on_halfedge(h, i);
        m_stars[m_halfedges.size()].push_back({-1, dart});
        m_halfedges.push_back(h);
        m_cells.targets[std::size_t(dart)] = point_on_halfedge(h, i + 1);
        m_darts.push_back({dart, std::int32_t(m_halfedges.size()) % n});
      }
    m_inner_points.clear();
    m_number_on_border = std::size_t(n);
    for(std::int32_t i = m_first_step[std::size_t(f)]; i != no_index;
        i = m_next_step[std::size_t(i)])
      add_step(std::size_t(i), first);
    link_darts();
    add_cells();
  }

  // The index of the beginning or end of a step among the points of its face: first the points on
  // its edges, then the points inside.
  std::int32_t local_point(const std::int32_t point, const Segment_end& end,
                           const std::array<std::int32_t, 3>& first)
  {
    if(is_inner(point)) {
      const auto i = std::find(m_inner_points.begin(), m_inner_points.end(), point);
      const std::size_t index = std::size_t(i - m_inner_points.begin());
      if(i == m_inner_points.end()) {
        m_inner_points.push_back(point);
        m_stars.emplace_back();
      }
      return std::int32_t(m_number_on_border + index);
    }
    if(end.place == Isocurve_place::VERTEX)
      return first[std::size_t(Chart_mesh::next(end.halfedge) % 3)];
    return first[std::size_t(end.halfedge % 3)] + m_on_edges.number_of(point, end.halfedge);
  }

  bool is_inner(const std::int32_t point) const
  { return m_inner_nodes[std::size_t(point)] != no_index; }

  void add_step(const std::size_t i, const std::array<std::int32_t, 3>& first)
  {
    const Arc_step& step = m_steps[i];
    const Curve_segment& segment = segment_of(step);
    const std::int32_t source = local_point(step.source,
                                            step.is_reversed ? segment.exit : segment.entry, first);
    const std::int32_t target = local_point(step.target,
                                            step.is_reversed ? segment.entry : segment.exit, first);
    const Direction along = m_curves.chord(step.curve, step.segment).direction;
    const Direction direction = step.is_reversed ? reversed(along) : along;
    const std::int32_t dart = 2 * m_edge_of_step[i];
    m_cells.targets[std::size_t(dart)] = step.target;
    m_cells.targets[std::size_t(dart) + 1] = step.source;
    leave(source, step.source, direction, dart);
    leave(target, step.target, reversed(direction), dart + 1);
    m_darts.push_back({dart, target});
    m_darts.push_back({dart + 1, source});
  }

  // Counterclockwise from the edge that leaves a point of the border of the face; inside, from +u.
  void leave(const std::int32_t local, const std::int32_t point, const Direction direction,
             const std::int32_t dart)
  {
    Star& star = m_stars[std::size_t(local)];
    if(is_inner(point)) {
      star.push_back({Quarter_turns::turns(direction), dart});
      return;
    }
    const Corner_index h = m_halfedges[std::size_t(local)];
    const Direction edge = quadrant(m_mesh.uv(Chart_mesh::prev(h)), m_mesh.uv(h));
    star.push_back({Quarter_turns::turns(turned(direction, Quarter_turns::inverse(
                                           turned(edge, Quarter_turns::element(1))))), dart});
  }

  // A dart is followed by the next one clockwise around its end. On the border of the face, the
  // way back along the border is not in the star: it would be the last one.
  void link_darts()
  {
    for(Star& star : m_stars)
      std::sort(star.begin(), star.end());
    for(const Local_dart& d : m_darts) {
      const Star& star = m_stars[std::size_t(d.target)];
      const auto back = std::find_if(star.begin(), star.end(), [&](const Outgoing& o)
                                     { return o.dart == (d.dart ^ 1); });
      const auto next = back == star.begin() ? star.end() : back;
      m_cells.nexts[std::size_t(d.dart)] = std::prev(next)->dart;
      m_cells.cells[std::size_t(d.dart)] = no_index;
    }
  }

  void add_cells()
  {
    for(const Local_dart& d : m_darts) {
      if(m_cells.cells[std::size_t(d.dart)] != no_index)
        continue;
      for(std::int32_t i = d.dart; m_cells.cells[std::size_t(i)] == no_index;
          i = m_cells.nexts[std::size_t(i)])
        m_cells.cells[std::size_t(i)] = std::int32_t(m_cells.n_cells);
      ++m_cells.n_cells;
    }
  }

  // Outside, against the direction of the halfedges.
  void link_border()
  {
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if(!m_mesh.is_border_edge(h))
        continue;
      Corner_index last = Chart_mesh::prev(h); // the border edge that comes next
      while(!m_mesh.is_border_edge(last))
        last = m_mesh.counterclockwise(last);
      for(std::int32_t i = 0; i <= m_on_edges.number_on(h); ++i) {
        const std::size_t dart = std::size_t(dart_on_halfedge(h, i) ^ 1);
        m_cells.targets[dart] = point_on_halfedge(h, i);
        m_cells.nexts[dart] = (i > 0 ? dart_on_halfedge(h, i - 1)
                                     : dart_on_halfedge(last, m_on_edges.number_on(last))) ^ 1;
      }
    }
  }

  // From both sides of all arcs to what no arc separates from them. Returns whether all was found.
  bool spread_patches()
  {
    m_patches.assign(m_cells.n_cells, no_index);
    std::vector<std::int32_t> found; // a dart of each cell
    const auto set = [&](const std::int32_t dart, const Patch_index patch) {
      Patch_index& of_cell = m_patches[std::size_t(m_cells.cells[std::size_t(dart)])];
      if(of_cell == no_index) {
        found.push_back(dart);
        of_cell = patch;
      } else if(of_cell != patch) {
        m_joined.emplace_back(of_cell, patch);
      }
    };
    for(std::size_t d = 0; d < m_cells.number_of_darts(); ++d) {
      const Half_arc_index half = m_half_arcs[d / 2];
      if(half != no_index && m_cells.cells[d] != no_index)
        set(std::int32_t(d), m_layout.half(d % 2 == 0 ? half : twin(half)).patch);
    }
    for(std::size_t i = 0; i < found.size(); ++i) {
      const std::int32_t first = found[i];
      const Patch_index patch = m_patches[std::size_t(m_cells.cells[std::size_t(first)])];
      std::int32_t d = first;
      do {
        if(m_half_arcs[std::size_t(d / 2)] == no_index)
          set(d ^ 1, patch);
        d = m_cells.nexts[std::size_t(d)];
      } while(d != first);
    }
    return found.size() == m_cells.number_of_cells();
  }

  struct Local_dart
  {
    std::int32_t dart, target; // among the points of the face
  };

  const Chart_mesh& m_mesh;
  const Curve_set& m_curves;
  const Layout& m_layout;
  std::vector<Face_point> m_points;           // per vertex of the cells
  std::vector<std::int32_t> m_points_of_nodes;
  std::vector<Arc_step> m_steps;
  Points_on_edges m_on_edges;                 // made with the three before it
  std::vector<std::int32_t> m_inner_nodes;    // per point: the node inside of a face, if it is one
  Polygon_complex m_cells;
  std::vector<std::int32_t> m_first_part;     // the first edge of the cells, per first halfedge
  std::vector<Half_arc_index> m_half_arcs;    // per edge of the cells: that along dart 2 e
  std::vector<std::int32_t> m_edge_of_step, m_next_step, m_first_step; // lists of steps, per face
  std::vector<Patch_index> m_patches;         // per cell
  std::vector<std::pair<Patch_index, Patch_index> > m_joined;
  bool m_is_covered = false;

  // The state of the face that is being cut.
  std::vector<Star> m_stars;
  std::vector<Local_dart> m_darts;
  std::vector<Corner_index> m_halfedges;      // per point of its border
  std::vector<std::int32_t> m_inner_points;
  std::size_t m_number_on_border = 0;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_H
