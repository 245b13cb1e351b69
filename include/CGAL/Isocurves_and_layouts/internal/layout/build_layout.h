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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_BUILD_LAYOUT_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_BUILD_LAYOUT_H

#include <CGAL/license/Isocurves_and_layouts.h>

// From curves that have run their course to points, arcs, and the order of arcs around patches.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_race.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// A point on a curve. Ends of segments before `end` come before it, ends from `begin` on after it.
struct Curve_point
{
  Curve_index curve;
  Exact_level length; // of the curve up to there
  Point_index point;
  std::int32_t slot;  // in which the curve goes on
  std::int32_t back;  // and the index of the way back
  Segment_index begin, end;
};

// Each step returns false if the curves make no partition, which can't be.
class Layout_builder
{
public:
  Layout_builder(const Layout_domain& domain, const Curve_race& race)
    : m_domain(domain), m_mesh(domain.mesh), m_race(race), m_curves(race.curves())
  { }

  bool run()
  {
    add_starts();
    add_crossings();
    add_points_of_loops();
    return add_arcs() && link();
  }

  Layout& layout() { return m_layout; }

private:
  void add_point(const Layout_place& place, const Start_kind start, const std::int32_t slots)
  {
    Layout_point point;
    point.place = place;
    point.start = start;
    point.first_slot = std::int32_t(m_layout.slots.size());
    point.number_of_slots = slots;
    m_layout.points.push_back(point);
    m_layout.slots.resize(m_layout.slots.size() + std::size_t(slots), no_index);
  }

  void add_starts()
  {
    m_points_of_vertices.assign(m_mesh.number_of_vertices(), no_index);
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v) {
      if(!m_domain.is_start(v))
        continue;
      m_points_of_vertices[v] = Point_index(m_layout.points.size());
      add_point(place_of_vertex(v), m_domain.starts[v], slots_of_vertex(m_domain, v).number);
    }
    for(Curve_index c = 0; c < Curve_index(m_curves.size()); ++c) {
      const Layout_curve& curve = m_curves[c];
      if(!curve.is_closed)
        m_on_curves.push_back({c, Exact_level(0.), m_points_of_vertices[curve.start],
                               curve.start_slot, no_index, 0, 0});
      if(curve.is_wall && !curve.is_closed)
        add_end_of_wall(c);
    }
  }

  Layout_place place_of_vertex(const std::size_t v) const
  {
    Layout_place place;
    place.place = Isocurve_place::VERTEX;
    place.halfedge = m_mesh.corner_at_vertex[v];
    make_unique(m_mesh, place);
    return place;
  }

  // Walls end where others start, in a slot which no curve goes on in.
  void add_end_of_wall(const Curve_index c)
  {
    const Segment_index n = Segment_index(m_curves[c].segments.size());
    const std::size_t v = m_mesh.vertex(m_curves[c].segments.back().exit.halfedge);
    m_on_curves.push_back({c, m_curves.length_at_vertex(c, n - 1), m_points_of_vertices[v],
                           no_index, slot_of_way_back(c, n - 1), n, n - 1});
  }

  // At the vertex that a segment ends at.
  std::int32_t slot_of_way_back(const Curve_index c, const Segment_index s) const
  {
    const Curve_segment& segment = m_curves[c].segments[std::size_t(s)];
    const Vertex_slots slots = slots_of_vertex(m_domain, m_mesh.vertex(segment.exit.halfedge));
    return m_curves[c].is_oblique
             ? slots.number - 1
             : slots.first_ray + std::int32_t(slot_of_arrival(m_mesh, segment,
                                                              m_curves.chord(c, s).direction));
  }

  void add_crossings()
  {
    const std::vector<const Meeting*> meetings = m_race.crossings();
    std::vector<Layout_place> places;
    std::vector<Quarter_turns::Element> turns;
    for(const Meeting* const m : meetings) {
      places.push_back(m->place);
      turns.push_back(make_unique(m_mesh, places.back()));
    }
    std::vector<std::size_t> order(meetings.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b)
              { return compare(places[a], places[b]) < 0; });
    for(std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t m = order[i];
      const bool is_new = i == 0 || compare(places[order[i - 1]], places[m]) != 0;
      if(meetings[m]->kind == Meeting_kind::BORDER) {
        if(is_new)
          add_point_on_border(places[m]);
        add_end_at_border(*meetings[m]);
        continue;
      }
      if(is_new)
        add_point(places[m], Start_kind::NONE, 4);
      add_on_curve(meetings[m]->first, meetings[m]->place, turns[m]);
      add_on_curve(meetings[m]->second, meetings[m]->place, turns[m]);
    }
  }

  // A new point on an oblique border. Inside of an edge, two rays lead into the face.
  void add_point_on_border(const Layout_place& place)
  {
    const bool is_vertex = place.place == Isocurve_place::VERTEX;
    const std::size_t v = m_mesh.vertex(place.halfedge);
    const std::int32_t n = is_vertex ? slots_of_vertex(m_domain, v).number : 4;
    const Corner_index h = is_vertex ? border_edge_to(m_mesh, v) : place.halfedge;
    const auto [curve, segment] = segment_on_border(h);
    add_point(place, Start_kind::NONE, n);
    const Exact_rational length(Exact_rational(segment) +
                                (is_vertex ? Exact_rational(1) : parameter_on_edge(h, place.uv)));
    m_on_curves.push_back({curve, Exact_level(length), Point_index(m_layout.points.size() - 1), 0,
                           n - 1, segment + (is_vertex ? 1 : 0), segment});
  }

  Exact_rational parameter_on_edge(const Corner_index h, const Exact_uv& uv) const
  {
    const Exact_rational a(m_mesh.uv(Chart_mesh::prev(h))[0]), b(m_mesh.uv(h)[0]);
    return Exact_rational((uv[0].exact() - a) / (b - a));
  }

  std::pair<Curve_index, Segment_index> segment_on_border(const Corner_index h)
  {
    if(m_on_border.empty())
      for(Curve_index c = 0; c < Curve_index(m_curves.size()); ++c)
        for(std::size_t s = 0; m_curves[c].is_oblique && s < m_curves[c].segments.size(); ++s)
          m_on_border[m_curves[c].segments[s].along] = {c, Segment_index(s)};
    return m_on_border.at(h);
  }

  // At the last point that was added.
  void add_end_at_border(const Meeting& meeting)
  {
    const auto [curve, segment] = std::make_pair(meeting.first.curve, meeting.first.segment);
    std::int32_t back = 0;
    if(meeting.place.place == Isocurve_place::VERTEX) {
      back = slot_of_way_back(curve, segment);
    } else {
      const Corner_index h = meeting.place.halfedge;
      const Direction first = turned(quadrant(m_mesh.uv(Chart_mesh::prev(h)), m_mesh.uv(h)),
                                     Quarter_turns::element(1)); // of the rays into the face
      back = 1 + Quarter_turns::turns(turned(reversed(meeting.first.direction),
                                             Quarter_turns::inverse(first)));
    }
    m_on_curves.push_back({curve, meeting.first.length, Point_index(m_layout.points.size() - 1),
                           no_index, back, segment + 1, segment});
  }

  // Closed walls and borders that nothing has come to: each gets a point that no curve starts at.
  void add_points_of_loops()
  {
    std::vector<char> has_point(m_curves.size(), false);
    for(const Curve_point& p : m_on_curves)
      has_point[std::size_t(p.curve)] = true;
    for(Curve_index c = 0; c < Curve_index(m_curves.size()); ++c)
      if(m_curves[c].is_closed && !has_point[std::size_t(c)])
        add_point_of_loop(c);
  }

  void add_point_of_loop(const Curve_index c)
  {
    std::map<std::size_t, Segment_index> segments; // that end at each vertex
    std::vector<std::size_t> vertices;
    for(const Curve_segment& segment : m_curves[c].segments) {
      const std::size_t v = m_mesh.vertex(segment.exit.halfedge);
      segments[v] = Segment_index(vertices.size());
      vertices.push_back(v);
    }
    const std::size_t v = vertex_with_least_coordinates(m_mesh, vertices);
    const Segment_index s = segments[v];
    const std::int32_t back = slot_of_way_back(c, s);
    add_point(place_of_vertex(v), Start_kind::SEED,
              m_curves[c].is_oblique ? slots_of_vertex(m_domain, v).number : 4);
    m_on_curves.push_back({c, m_curves.length_at_vertex(c, s),
                           Point_index(m_layout.points.size() - 1),
                           m_curves[c].is_oblique ? 0 : (back + 2) % 4, back, s + 1, s});
  }

  // The last point that was added.
  void add_on_curve(const Curve_position& position, const Layout_place& place,
                    const Quarter_turns::Element turn)
  {
    const Segment_index s = position.segment;
    const Curve_segment& segment = m_curves[position.curve].segments[std::size_t(s)];
    const bool is_at_exit = is_at(position, place, segment.exit);
    const bool is_at_entry = !is_at_exit && is_at(position, place, segment.entry);
    const Direction slot = turned(position.direction, turn);
    m_on_curves.push_back({position.curve, position.length,
                           Point_index(m_layout.points.size() - 1), slot, reversed(slot),
                           s + (is_at_exit ? 1 : 0), s - (is_at_entry ? 1 : 0)});
  }

  // Whether a point of a segment is this end of it. On a mesh where both ends of a segment may lie
  // on the same edge, only coordinates tell.
  bool is_at(const Curve_position& position, const Layout_place& place,
             const Segment_end& end) const
  {
    if(place.place == Isocurve_place::FACE || place.place != end.place)
      return false;
    if(place.place == Isocurve_place::VERTEX)
      return m_mesh.vertex(place.halfedge) == m_mesh.vertex(end.halfedge);
    if(m_mesh.edge_key(place.halfedge) != m_mesh.edge_key(end.halfedge))
      return false;
    const Chord& chord = m_curves.chord(position.curve, position.segment);
    const Exact_level running(running_on_edge(m_mesh, end.halfedge, chord.direction, chord.level));
    return chord.length_up_to(running) == position.length;
  }

  bool add_arcs()
  {
    std::sort(m_on_curves.begin(), m_on_curves.end(), [](const Curve_point& a, const Curve_point& b)
    {
      return a.curve != b.curve ? a.curve < b.curve : compare(a.length, b.length) < 0;
    });
    m_on_curves.erase(std::unique(m_on_curves.begin(), m_on_curves.end(),
                                  [](const Curve_point& a, const Curve_point& b)
                                  { return a.curve == b.curve && a.length == b.length; }),
                      m_on_curves.end());
    std::vector<std::size_t> last(m_curves.size(), m_on_curves.size()); // point of each curve
    for(std::size_t i = 0; i < m_on_curves.size(); ++i)
      last[std::size_t(m_on_curves[i].curve)] = i;
    for(std::size_t i = 0, first = 0; i < m_on_curves.size(); ++i) {
      const Curve_index c = m_on_curves[i].curve;
      if(i != last[std::size_t(c)]) {
        if(!add_arc(m_on_curves[i], m_on_curves[i + 1]))
          return false;
        continue;
      }
      if(m_curves[c].is_closed ? !add_closing_arc(m_on_curves[i], m_on_curves[first])
                               : !add_last_arc(m_on_curves[i], last))
        return false;
      first = i + 1;
    }
    return true;
  }

  bool add_arc(const Curve_point& a, const Curve_point& b)
  {
    return add_arc(a, b, b.back, b.length.minus(a.length), {a.curve, a.begin, b.end, false},
                   {a.curve, 0, 0, false});
  }

  // From the last point of a closed wall to the first.
  bool add_closing_arc(const Curve_point& a, const Curve_point& b)
  {
    const Layout_curve& curve = m_curves[a.curve];
    const Segment_index n = Segment_index(curve.segments.size());
    const Exact_level length = m_curves.length_at_vertex(a.curve, n - 1);
    return add_arc(a, b, b.back, length.minus(a.length).minus(b.length.negated()),
                   {a.curve, a.begin, n, false}, {a.curve, 0, b.end, false});
  }

  // Nothing, where the curve ends; or the arc of two curves that meet head on, once.
  bool add_last_arc(const Curve_point& a, const std::vector<std::size_t>& last)
  {
    const Layout_curve& curve = m_curves[a.curve];
    if(!curve.twice_length)
      return false;
    if(*curve.twice_length == a.length.doubled())
      return true;
    if(curve.partner == no_index)
      return false;
    const Curve_point& b = m_on_curves[last[std::size_t(curve.partner)]];
    const Layout_curve& partner = m_curves[curve.partner];
    if(partner.partner != a.curve || *partner.twice_length == b.length.doubled())
      return false;
    if(a.curve > b.curve)
      return true;
    return add_arc(a, b, b.slot, curve.twice_length->minus(a.length).minus(b.length),
                   {a.curve, a.begin, curve.last, false}, {b.curve, b.begin, partner.last, true});
  }

  bool add_arc(const Curve_point& a, const Curve_point& b, const std::int32_t slot_of_b,
               const Exact_level& length, const Curve_piece& first, const Curve_piece& second)
  {
    const Half_arc_index h = Half_arc_index(2 * m_layout.arcs.size());
    const Layout_curve& curve = m_curves[a.curve];
    m_layout.arcs.push_back({{a.point, b.point}, curve.is_oblique ? Exact_level(0.) : length,
                             {first, second}, curve.is_wall, curve.is_oblique});
    m_layout.half_arcs.resize(std::size_t(h) + 2);
    m_layout.half_arcs[std::size_t(h)].is_outside = curve.is_left_outside;
    m_layout.half_arcs[std::size_t(h) + 1].is_outside = curve.is_right_outside;
    return occupy(a.point, a.slot, h) && occupy(b.point, slot_of_b, twin(h));
  }

  bool occupy(const Point_index p, const std::int32_t slot, const Half_arc_index h)
  {
    Layout_point& point = m_layout.points[std::size_t(p)];
    if(slot < 0 || slot >= point.number_of_slots || slot_of(point, slot) != no_index)
      return false;
    slot_of(point, slot) = h;
    ++point.degree;
    return true;
  }

  Half_arc_index& slot_of(const Layout_point& point, const std::int32_t slot)
  { return m_layout.slots[std::size_t(point.first_slot + slot)]; }

  // The next half around a patch is the next one clockwise around its first point.
  bool link()
  {
    for(const Layout_point& point : m_layout.points) {
      if(point.degree == 0)
        return false;
      const std::int32_t n = point.number_of_slots;
      for(std::int32_t s = 0, previous = last_occupied(point); s < n; ++s) {
        const Half_arc_index h = slot_of(point, s);
        if(h == no_index)
          continue;
        Half_arc& arriving = m_layout.half_arcs[std::size_t(twin(h))];
        arriving.next = slot_of(point, previous);
        if(!m_layout.arc(h).is_oblique && !m_layout.arc(arriving.next).is_oblique)
          arriving.turns = (s - previous + n - 1) % n + 1;
        previous = s;
      }
    }
    return true;
  }

  std::int32_t last_occupied(const Layout_point& point)
  {
    std::int32_t s = point.number_of_slots - 1;
    while(slot_of(point, s) == no_index)
      --s;
    return s;
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  const Curve_race& m_race;
  const Curve_set& m_curves;
  Layout m_layout;
  std::vector<Point_index> m_points_of_vertices;
  std::vector<Curve_point> m_on_curves;
  std::map<Corner_index, std::pair<Curve_index, Segment_index> > m_on_border; // by halfedges
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_BUILD_LAYOUT_H
