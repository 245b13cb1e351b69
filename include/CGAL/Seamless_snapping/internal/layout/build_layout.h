// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_BUILD_LAYOUT_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_BUILD_LAYOUT_H

#include <CGAL/license/Seamless_snapping.h>

// From curves that have run their course to points, arcs, and patches.

#include <CGAL/Seamless_snapping/internal/layout/Curve_race.h>
#include <CGAL/Seamless_snapping/internal/layout/Layout.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A point on a curve. Ends of segments before `end` come before it, those from `begin` on after it.
struct Curve_point
{
  Curve_index curve;
  Exact_level length; // of the curve up to there
  Point_index point;
  std::int32_t slot;  // in which the curve goes on
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
    return add_arcs() && link() && add_patches();
  }

  Layout& layout() { return m_layout; }

private:
  void add_point(const Layout_place& place, const Start_kind start, const std::size_t slots)
  {
    Layout_point point;
    point.place = place;
    point.start = start;
    point.first_slot = std::int32_t(m_layout.slots.size());
    point.number_of_slots = std::int32_t(slots);
    m_layout.points.push_back(point);
    m_layout.slots.resize(m_layout.slots.size() + slots, no_index);
  }

  void add_starts()
  {
    m_points_of_vertices.assign(m_mesh.number_of_vertices(), no_index);
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v) {
      if(!m_domain.is_start(v))
        continue;
      Layout_place place;
      place.place = Isocurve_place::VERTEX;
      place.halfedge = m_mesh.corner_at_vertex[v];
      make_unique(m_mesh, place);
      m_points_of_vertices[v] = Point_index(m_layout.points.size());
      add_point(place, m_domain.starts[v], rays_from_vertex(m_mesh, v).size());
    }
    for(Curve_index c = 0; c < Curve_index(m_curves.size()); ++c) {
      const Layout_curve& curve = m_curves[c];
      if(!curve.is_closed)
        m_on_curves.push_back({c, Exact_level(0.), m_points_of_vertices[curve.start],
                               std::int32_t(curve.start_slot), 0, 0});
      if(curve.is_wall && !curve.is_closed)
        add_end_of_wall(c);
    }
  }

  // Walls end where others start, in a slot which no curve goes on in.
  void add_end_of_wall(const Curve_index c)
  {
    const Curve_segment& last = m_curves[c].segments.back();
    const Segment_index n = Segment_index(m_curves[c].segments.size());
    const std::size_t slot = slot_of_arrival(m_mesh, last, m_curves.chord(c, n - 1).direction);
    const std::size_t v = m_mesh.vertex(last.exit.halfedge);
    m_on_curves.push_back({c, m_curves.length_at_vertex(c, n - 1), m_points_of_vertices[v],
                           std::int32_t(slot), n, n - 1});
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
      if(i == 0 || compare(places[order[i - 1]], places[m]) != 0)
        add_point(places[m], Start_kind::NONE, 4);
      add_on_curve(meetings[m]->first, meetings[m]->place, turns[m]);
      add_on_curve(meetings[m]->second, meetings[m]->place, turns[m]);
    }
  }

  // The last point that was added.
  void add_on_curve(const Curve_position& position, const Layout_place& place,
                    const Quarter_turns::Element turn)
  {
    const Segment_index s = position.segment;
    const Curve_segment& segment = m_curves[position.curve].segments[std::size_t(s)];
    const bool is_at_exit = is_at(position, place, segment.exit);
    const bool is_at_entry = !is_at_exit && is_at(position, place, segment.entry);
    m_on_curves.push_back({position.curve, position.length,
                           Point_index(m_layout.points.size() - 1),
                           turned(position.direction, turn), s + (is_at_exit ? 1 : 0),
                           s - (is_at_entry ? 1 : 0)});
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
    const Layout_curve& curve = m_curves[a.curve];
    const bool is_end =
      curve.is_wall && !curve.is_closed && *curve.twice_length == b.length.doubled();
    return add_arc(a, b, is_end ? b.slot : behind(b), b.length.minus(a.length),
                   {a.curve, a.begin, b.end, false}, {a.curve, 0, 0, false});
  }

  // From the last point of a closed wall to the first.
  bool add_closing_arc(const Curve_point& a, const Curve_point& b)
  {
    const Layout_curve& curve = m_curves[a.curve];
    const Segment_index n = Segment_index(curve.segments.size());
    const Exact_level length = m_curves.length_at_vertex(a.curve, n - 1);
    return add_arc(a, b, behind(b), length.minus(a.length).minus(b.length.negated()),
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

  // The slot of the way back, where a curve runs straight on.
  static std::int32_t behind(const Curve_point& p) { return (p.slot + 2) % 4; }

  bool add_arc(const Curve_point& a, const Curve_point& b, const std::int32_t slot_of_b,
               const Exact_level& length, const Curve_piece& first, const Curve_piece& second)
  {
    const Half_arc_index h = Half_arc_index(2 * m_layout.arcs.size());
    m_layout.arcs.push_back(
      {{a.point, b.point}, length, {first, second}, m_curves[a.curve].is_wall});
    m_layout.half_arcs.resize(std::size_t(h) + 2);
    m_layout.half_arcs[std::size_t(h)].is_outside = m_curves[a.curve].is_left_outside;
    m_layout.half_arcs[std::size_t(h) + 1].is_outside = m_curves[a.curve].is_right_outside;
    return occupy(a.point, a.slot, h) && occupy(b.point, slot_of_b, twin(h));
  }

  bool occupy(const Point_index p, const std::int32_t slot, const Half_arc_index h)
  {
    Layout_point& point = m_layout.points[std::size_t(p)];
    if(slot >= point.number_of_slots || slot_of(point, slot) != no_index)
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

  bool add_patches()
  {
    for(Half_arc_index h = 0; h < Half_arc_index(m_layout.half_arcs.size()); ++h) {
      const Half_arc& half = m_layout.half(h);
      if(half.patch == no_index && !half.is_outside && !add_patch(h))
        return false;
    }
    return true;
  }

  bool add_patch(const Half_arc_index any)
  {
    Half_arc_index first = any, h = any;
    while(m_layout.half(first).turns != 1) { // the next half starts at a corner
      first = m_layout.half(first).next;
      if(first == any)
        return false;
    }
    Layout_patch patch;
    std::size_t side = 0;
    h = first = m_layout.half(first).next;
    do {
      Half_arc& half = m_layout.half_arcs[std::size_t(h)];
      if(half.turns > 2 || half.is_outside || side == 4)
        return false;
      half.patch = Patch_index(m_layout.patches.size());
      patch.sides[side].push_back(h);
      side += half.turns == 1 ? 1 : 0;
      h = half.next;
    } while(h != first);
    patch.width = length(patch.sides[0]);
    patch.height = length(patch.sides[1]);
    m_layout.patches.push_back(patch);
    return side == 4 && patch.width == length(patch.sides[2]) &&
           patch.height == length(patch.sides[3]);
  }

  Exact_level length(const std::vector<Half_arc_index>& side) const
  {
    Exact_level sum(0.);
    for(const Half_arc_index h : side)
      sum = sum.minus(m_layout.arc(h).length.negated());
    return sum;
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  const Curve_race& m_race;
  const Curve_set& m_curves;
  Layout m_layout;
  std::vector<Point_index> m_points_of_vertices;
  std::vector<Curve_point> m_on_curves;
};

// Of a closed cell complex, the Euler characteristic is that of the surface if and only if all
// patches are discs, as none of them has no border.
inline bool has_right_euler_characteristic(const Chart_mesh& mesh, const Layout& layout)
{
  std::ptrdiff_t expected = std::ptrdiff_t(mesh.number_of_vertices()) +
                            std::ptrdiff_t(mesh.number_of_faces());
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    expected -= mesh.represents_edge(h) ? 1 : 0;
  return expected == std::ptrdiff_t(layout.points.size()) - std::ptrdiff_t(layout.arcs.size()) +
                       std::ptrdiff_t(layout.patches.size());
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LAYOUT_BUILD_LAYOUT_H
