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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_SET_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_SET_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Curves on a surface, each a list of segments, and their meetings: the chords in each face, and
// the curves through each vertex.

#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

using Curve_index = std::int32_t;
using Segment_index = std::int32_t;

// A segment as one of the faces sees it that it lies in: two of them, if it lies along an edge.
struct Chord
{
  Curve_index curve = no_index;
  Segment_index segment = no_index;
  Direction direction = Quarter_turns::identity();
  Exact_level level;  // the constant coordinate
  Exact_level origin; // the running coordinate of the start of the curve

  // The length of the curve from its start to a point of the chord.
  Exact_level length_up_to(const Exact_level& running) const
  {
    return running_sign(direction) > 0 ? running.minus(origin) : origin.minus(running);
  }
};

struct Curve_segment
{
  Segment_end entry, exit;
  Corner_index along;
  std::int32_t chord; // in the chart of the face of entry and exit; none on an oblique border
};

struct Layout_curve
{
  std::vector<Curve_segment> segments;
  std::size_t start = 0;                 // the vertex that it starts at
  std::int32_t start_slot = 0;           // there
  bool is_wall = false;
  bool is_oblique = false;               // a piece of the border on no isocurve: no chords, and its
                                         // length is counted in edges
  bool is_closed = false;                // it is a wall that ends where it starts, at no corner
  bool is_left_outside = false, is_right_outside = false;
  std::optional<Exact_level> twice_length; // unless it runs on
  Curve_index partner = no_index;        // that it meets head on, at the end of both
  Segment_index last = no_index;         // in which it does
};

// Invariant: each chord is in a list of its face, and each segment that ends at a vertex in the
// list of the vertex, unless curves start there.
class Curve_set
{
public:
  explicit Curve_set(const Layout_domain& domain)
    : m_domain(&domain), m_chords_of_face(std::size_t(domain.mesh.number_of_faces()), no_index),
      m_first_visit(domain.mesh.number_of_vertices(), no_index)
  { }

  const Chart_mesh& mesh() const { return m_domain->mesh; }
  std::size_t size() const { return m_curves.size(); }
  const Layout_curve& operator[](const Curve_index c) const { return m_curves[std::size_t(c)]; }
  Layout_curve& operator[](const Curve_index c) { return m_curves[std::size_t(c)]; }
  const Chord& chord(const std::int32_t i) const { return m_chords[std::size_t(i)]; }

  const Chord& chord(const Curve_index c, const Segment_index s) const
  { return chord((*this)[c].segments[std::size_t(s)].chord); }

  Curve_index add_curve(const std::size_t start, const std::int32_t slot)
  {
    m_curves.emplace_back();
    m_curves.back().start = start;
    m_curves.back().start_slot = slot;
    return Curve_index(m_curves.size() - 1);
  }

  // Appends a halfedge of an oblique border.
  void add_border_edge(const Curve_index c, const Corner_index h)
  {
    const Segment_end entry{Isocurve_place::VERTEX, Chart_mesh::prev(h)};
    (*this)[c].segments.push_back({entry, {Isocurve_place::VERTEX, h}, h, no_index});
  }

  // The length of a curve up to the end of a segment at a vertex.
  Exact_level length_at_vertex(const Curve_index c, const Segment_index s) const
  {
    if((*this)[c].is_oblique)
      return Exact_level(double(s) + 1);
    const Chord& chord = this->chord(c, s);
    const Segment_end& exit = (*this)[c].segments[std::size_t(s)].exit;
    return chord.length_up_to(
      Exact_level(mesh().uv(exit.halfedge)[running_component(chord.direction)]));
  }

  // Appends a segment to a curve. Calls on_chord(chord, other, face) for its chords and chords that
  // cross them in a face, or may run against them, and on_visit(curve, segment) for the segments
  // that have come to the same vertex.
  template <typename OnChord, typename OnVisit>
  void add_segment(const Curve_index c, const Chart_segment& segment, const OnChord& on_chord,
                   const OnVisit& on_visit)
  {
    Layout_curve& curve = (*this)[c];
    const Segment_index s = Segment_index(curve.segments.size());
    Chord chord;
    chord.curve = c;
    chord.segment = s;
    chord.direction = segment.direction;
    chord.level = segment.level;
    chord.origin = segment.origin;
    curve.segments.push_back(
      {segment.entry, segment.exit, segment.along, std::int32_t(m_chords.size())});
    add_chord(chord, segment.face(), on_chord);
    if(segment.along != no_index && mesh().opposite(segment.along) != no_index) {
      const Corner_index h = segment.along;
      add_chord(carried_over_edge(chord, h), mesh().face(mesh().opposite(h)), on_chord);
    }
    if(segment.exit.place == Isocurve_place::VERTEX &&
       !m_domain->is_start(mesh().vertex(segment.exit.halfedge)))
      add_visit(c, s, mesh().vertex(segment.exit.halfedge), on_visit);
  }

private:
  struct Visit
  {
    Curve_index curve;
    Segment_index segment;
    std::int32_t next;
  };

  // By their directions, and of each about its level: a curve that spirals has thousands in a face.
  using Chords_of_face = std::array<std::vector<std::pair<double, std::int32_t> >, 4>;

  template <typename OnChord>
  void add_chord(const Chord& chord, const Flat_face_index face, const OnChord& on_chord)
  {
    std::int32_t& list = m_chords_of_face[std::size_t(face)];
    if(list == no_index) {
      list = std::int32_t(m_chords_by_direction.size());
      m_chords_by_direction.emplace_back();
    }
    Chords_of_face& chords = m_chords_by_direction[std::size_t(list)];
    const auto in_direction = [&](const int turns) -> auto& {
      return chords[std::size_t(turned(chord.direction, Quarter_turns::element(turns)))];
    };
    for(const int turns : {1, 3})
      for(const auto& [level, i] : in_direction(turns))
        on_chord(chord, m_chords[std::size_t(i)], face);
    const double level = chord.level.approximation();
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(level);
    for(const auto& [other_level, i] : in_direction(2))
      if(std::abs(other_level - level) <= rounding)
        on_chord(chord, m_chords[std::size_t(i)], face);
    in_direction(0).emplace_back(level, std::int32_t(m_chords.size()));
    m_chords.push_back(chord);
  }

  template <typename OnVisit>
  void add_visit(const Curve_index c, const Segment_index s, const std::size_t vertex,
                 const OnVisit& on_visit)
  {
    std::int32_t& first = m_first_visit[vertex];
    for(std::int32_t i = first; i != no_index; i = m_visits[std::size_t(i)].next)
      on_visit(m_visits[std::size_t(i)].curve, m_visits[std::size_t(i)].segment);
    m_visits.push_back({c, s, first});
    first = std::int32_t(m_visits.size() - 1);
  }

  // A chord along an edge, in the chart of the other face.
  Chord carried_over_edge(Chord chord, const Corner_index h) const
  {
    const Direction before = chord.direction;
    chord.direction = turned(before, mesh().rotation(h));
    chord.level =
      Exact_level(mesh().uv(mesh().opposite(h))[constant_component(chord.direction)]);
    carry_over_edge(mesh(), h, running_component(before), chord.origin);
    return chord;
  }

  const Layout_domain* m_domain;
  std::vector<Layout_curve> m_curves;
  std::vector<Chord> m_chords;
  std::vector<Visit> m_visits;
  std::vector<std::int32_t> m_chords_of_face; // in those by direction; none where no chord is
  std::vector<Chords_of_face> m_chords_by_direction;
  std::vector<std::int32_t> m_first_visit; // per vertex
};

// Walls as curves, from corner to corner, or closed; and oblique borders likewise.
class Wall_builder
{
public:
  Wall_builder(const Layout_domain& domain, Curve_set& curves)
    : m_domain(domain), m_mesh(domain.mesh), m_curves(curves),
      m_is_done(domain.mesh.corners.size(), false)
  {
    m_limits.is_stop = [&domain](const std::size_t v) { return domain.is_start(v); };
  }

  void run()
  {
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_domain.is_start(v) && m_domain.is_on_wall[v])
        add_walls_from(v);
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i)
      if(m_domain.is_wall[i] && !m_is_done[i])
        add_walls_from(m_mesh.vertex(Corner_index(i)));
    if(m_domain.has_oblique_border)
      add_oblique_borders();
  }

private:
  void add_walls_from(const std::size_t v)
  {
    const Vertex_rays rays = rays_from_vertex(m_mesh, v);
    for(std::size_t k = 0; k < rays.size(); ++k) {
      const Corner_index h = edge_of_ray(rays[k]);
      if(h != no_index && m_domain.is_wall[std::size_t(h)] && !m_is_done[std::size_t(h)])
        add_wall(v, slots_of_vertex(m_domain, v).first_ray + std::int32_t(k), rays[k]);
    }
  }

  void add_wall(const std::size_t v, const std::int32_t slot, const Vertex_ray& ray)
  {
    const Curve_index c = m_curves.add_curve(v, slot);
    Segment_walker walker(m_mesh, m_limits, ray);
    while(walker.advance() == Isocurve_status::CONTINUES) {
      const Chart_segment& segment = walker.segment();
      const Corner_index h = segment.along, g = m_mesh.opposite(h);
      m_is_done[std::size_t(h)] = true;
      if(g != no_index)
        m_is_done[std::size_t(g)] = true;
      m_curves.add_segment(c, segment, [](const Chord&, const Chord&, Flat_face_index) { },
                           [](Curve_index, Segment_index) { });
    }
    Layout_curve& wall = m_curves[c];
    const Curve_segment& last = wall.segments.back();
    const bool is_border = m_mesh.is_border_edge(last.along);
    wall.is_wall = true;
    wall.is_closed = walker.status() == Isocurve_status::CLOSED;
    wall.is_right_outside = is_border && last.exit.halfedge == last.along;
    wall.is_left_outside = is_border && last.exit.halfedge != last.along;
    wall.twice_length =
      m_curves.length_at_vertex(c, Segment_index(wall.segments.size() - 1)).doubled();
  }

  // Adds the borders that begin at starts first; the other borders are closed.
  void add_oblique_borders()
  {
    for(const bool is_closed : {false, true})
      for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h)
        if(m_domain.is_oblique(h) && !m_is_done[std::size_t(h)] &&
           (is_closed || m_domain.is_start(m_mesh.source(h))))
          add_oblique_border(h, is_closed);
  }

  // With the surface at the left.
  void add_oblique_border(const Corner_index first, const bool is_closed)
  {
    const Curve_index c = m_curves.add_curve(m_mesh.source(first), 0);
    Corner_index h = first;
    std::size_t end = 0;
    do {
      m_is_done[std::size_t(h)] = true;
      m_curves.add_border_edge(c, h);
      end = m_mesh.vertex(h);
      h = border_edge_from(m_mesh, end);
    } while(!m_domain.is_start(end) && h != first);
    Layout_curve& border = m_curves[c];
    border.is_wall = border.is_oblique = border.is_right_outside = true;
    border.is_closed = is_closed;
    border.twice_length = Exact_level(2 * double(border.segments.size()));
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  Curve_set& m_curves;
  Walk_limits m_limits;
  std::vector<char> m_is_done; // per corner
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_SET_H
