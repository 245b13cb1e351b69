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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_RACE_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_RACE_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Curves that leave all starts at the same time with the same speed, and end at curves that were
// there first. Lengths, hence times, are exact at meetings.

#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_set.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_place.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// The position of a curve.
struct Curve_position
{
  Curve_index curve = no_index;
  Segment_index segment = no_index;
  Exact_level length;                              // from the start of the curve
  Direction direction = Quarter_turns::identity(); // at vertices: the slot that it goes on to
};

enum class Meeting_kind : char
{
  CROSSING, // `second` is there before `first`, or has the right of way
  HEAD_ON,  // both come along the same line; the place and their own lengths are not set
  HEAD_ON_AT_VERTEX, // likewise, at the same time, and both wait there
  TRAIL,    // `first` comes to where `second` has ended, which came along the same line; likewise
  BORDER    // `first` comes to an oblique border; there is no `second`
};

// Two curves at one point, or a curve at the border.
struct Meeting
{
  Meeting_kind kind = Meeting_kind::CROSSING;
  Exact_level twice_time; // of `first`, or of both
  Curve_position first, second;
  Layout_place place;
};

struct Race_options
{
  // Whether `first` ends there; always, if not set. Curves always end at walls.
  std::function<bool(const Meeting&)> ends;
  std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)(); // of segments, and of
                                                                          // meetings
};

// At least as small as the value, and near to it.
inline double lower_bound(const Exact_level& level)
{
  const double x = level.approximation(), infinity = std::numeric_limits<double>::infinity();
  return level.is_double() ? x : std::nextafter(std::nextafter(x, -infinity), -infinity);
}

inline double upper_bound(const Exact_level& level) { return -lower_bound(level.negated()); }

// Invariant: all meetings before the times of all segments to be added are known.
class Curve_race
{
public:
  Curve_race(const Layout_domain& domain, const Race_options& options)
    : m_domain(domain), m_mesh(domain.mesh), m_options(options), m_curves(domain)
  {
    m_limits.is_stop = [&domain](const std::size_t v)
                       { return domain.is_start(v) || domain.is_on_wall[v] ||
                                domain.mesh.is_border[v]; };
  }

  Curve_race(const Curve_race&) = delete; // its members refer to each other
  Curve_race& operator=(const Curve_race&) = delete;

  // Returns false if there are too many segments, or meetings.
  bool run()
  {
    Wall_builder(m_domain, m_curves).run();
    m_first_trace = m_curves.size();
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_domain.is_start(v))
        launch_from(v);
    while(!m_advances.empty() || !m_queue.empty())
      if(is_advance_next()) {
        const Curve_index c = m_advances.top().curve;
        m_advances.pop();
        if(!advance(c))
          return false;
      } else {
        const std::int32_t m = m_queue.top();
        m_queue.pop();
        meet(m);
      }
    return true;
  }

  const Curve_set& curves() const { return m_curves; }
  std::size_t number_of_walls() const { return m_first_trace; }

  // Segments that were walked, of all curves but walls.
  std::size_t number_of_segments() const { return m_number_of_segments; }

  // The meetings that have taken place, in the order of time. Several may be at one point.
  std::vector<const Meeting*> crossings() const
  {
    std::vector<const Meeting*> result;
    for(const std::int32_t m : m_crossings)
      result.push_back(&m_meetings[std::size_t(m)]);
    return result;
  }

private:
  // The next segment of a curve begins at this time or later.
  struct Advance
  {
    double time;
    Curve_index curve;
    friend bool operator<(const Advance& a, const Advance& b) // the first is the largest
    { return a.time != b.time ? a.time > b.time : a.curve > b.curve; }
  };

  struct Later_meeting
  {
    const std::vector<Meeting>* meetings;

    bool operator()(const std::int32_t a, const std::int32_t b) const
    {
      const Meeting &x = (*meetings)[std::size_t(a)], &y = (*meetings)[std::size_t(b)];
      const int order = compare(x.twice_time, y.twice_time);
      return order != 0 ? order > 0 : key(x) > key(y);
    }

    // Meetings that were found in several faces come one after another.
    static std::pair<Curve_index, Curve_index> key(const Meeting& m)
    { return {m.first.curve, m.second.curve}; }
  };

  void launch_from(const std::size_t v)
  {
    const Vertex_rays rays = rays_from_vertex(m_mesh, v);
    const std::int32_t first_slot = slots_of_vertex(m_domain, v).first_ray;
    for(std::size_t k = 0; k < rays.size(); ++k) {
      if(is_along_wall(m_domain, rays[k]))
        continue;
      const Curve_index c = m_curves.add_curve(v, first_slot + std::int32_t(k));
      m_walkers.resize(m_curves.size() - m_first_trace);
      m_walkers.back() = std::make_unique<Segment_walker>(m_mesh, m_limits, rays[k]);
      m_is_waiting.push_back(false);
      m_advances.push({0, c});
    }
  }

  bool is_advance_next() const
  {
    if(m_advances.empty() || m_queue.empty())
      return m_queue.empty();
    const Exact_level& time = m_meetings[std::size_t(m_queue.top())].twice_time;
    return time.side_of(2 * m_advances.top().time) <= 0;
  }

  bool advance(const Curve_index c)
  {
    std::unique_ptr<Segment_walker>& walker = m_walkers[std::size_t(c) - m_first_trace];
    if(is_waiting(c))
      return true;
    if(m_curves[c].twice_length || walker->advance() != Isocurve_status::CONTINUES) {
      walker.reset();
      return true;
    }
    ++m_number_of_segments;
    if((std::max)(m_number_of_segments, m_meetings.size()) > m_options.maximum_number)
      return false;
    const Chart_segment& segment = walker->segment();
    m_curves.add_segment(c, segment,
                         [&](const Chord& chord, const Chord& other, const Flat_face_index f)
                         { compare_chords(chord, other, f); },
                         [&](const Curve_index other, const Segment_index s)
                         { compare_visits(c, other, s); });
    if(is_at_oblique_border(segment.exit))
      add_end_at_border(c, segment);
    if(ends_at_obstacle(segment.exit))
      walker.reset();
    else if(!is_waiting(c))
      m_advances.push({time_at_exit(segment), c});
    return true;
  }

  bool is_at_oblique_border(const Segment_end& end) const
  {
    return end.place == Isocurve_place::VERTEX
             ? m_domain.is_inside_oblique_border(m_mesh.vertex(end.halfedge))
             : m_domain.is_oblique(end.halfedge);
  }

  void add_end_at_border(const Curve_index c, const Chart_segment& segment)
  {
    const Corner_index h = segment.exit.halfedge;
    const Exact_level running(running_at(m_mesh, segment, segment.exit));
    Meeting meeting;
    meeting.kind = Meeting_kind::BORDER;
    meeting.place.place = segment.exit.place;
    meeting.place.halfedge = h;
    meeting.place.uv[constant_component(segment.direction)] = segment.level;
    meeting.place.uv[running_component(segment.direction)] = running;
    const Segment_index last = Segment_index(m_curves[c].segments.size() - 1);
    meeting.first = {c, last, m_curves.chord(c, last).length_up_to(running), segment.direction};
    meeting.twice_time = meeting.first.length.doubled();
    add(meeting);
  }

  bool ends_at_obstacle(const Segment_end& exit) const
  {
    return exit.place == Isocurve_place::VERTEX
             ? m_limits.is_stop(m_mesh.vertex(exit.halfedge))
             : m_mesh.is_border_edge(exit.halfedge) ||
                 m_domain.is_wall[std::size_t(exit.halfedge)] != 0;
  }

  // A lower bound of the length up to the end of a segment.
  double time_at_exit(const Chart_segment& segment) const
  {
    using Interval = CGAL::Interval_nt<true>;
    const Corner_index h = segment.exit.halfedge;
    const std::size_t r = running_component(segment.direction);
    const auto interval = [](const Exact_level& x) { return Interval(lower_bound(x),
                                                                     upper_bound(x)); };
    Interval running(m_mesh.uv(h)[r]);
    if(segment.exit.place == Isocurve_place::EDGE) {
      const std::size_t c = constant_component(segment.direction);
      const Uv &a = m_mesh.uv(Chart_mesh::prev(h)), &b = m_mesh.uv(h);
      const Interval t = (interval(segment.level) - Interval(a[c])) /
                         (Interval(b[c]) - Interval(a[c]));
      running = Interval(a[r]) + t * (Interval(b[r]) - Interval(a[r]));
    }
    const Interval length = running - interval(segment.origin);
    return (std::max)(0., running_sign(segment.direction) > 0 ? length.inf() : -length.sup());
  }

  bool is_wall(const Curve_index c) const { return std::size_t(c) < m_first_trace; }

  char& is_waiting(const Curve_index c) { return m_is_waiting[std::size_t(c) - m_first_trace]; }

  void compare_chords(const Chord& a, const Chord& b, const Flat_face_index face)
  {
    if(constant_component(a.direction) != constant_component(b.direction))
      compare_crossing(a, b, face);
    else if(b.direction == reversed(a.direction) && a.curve != b.curve && !is_wall(b.curve) &&
            a.level == b.level)
      add_head_on(a, b);
  }

  // Both meet where their lengths are the same: in the middle between both starts.
  void add_head_on(const Chord& a, const Chord& b)
  {
    Meeting meeting;
    meeting.kind = Meeting_kind::HEAD_ON;
    meeting.first = {a.curve, a.segment, Exact_level(), a.direction};
    meeting.second = {b.curve, b.segment, Exact_level(), b.direction};
    meeting.twice_time = a.length_up_to(b.origin);
    add(meeting);
  }

  // At vertices, curves are compared that come there, through whichever faces.
  void compare_crossing(const Chord& a, const Chord& b, const Flat_face_index face)
  {
    Meeting meeting;
    meeting.place.halfedge = 3 * face;
    meeting.place.uv[constant_component(a.direction)] = a.level;
    meeting.place.uv[constant_component(b.direction)] = b.level;
    if(!locate_in_face(m_mesh, meeting.place) || meeting.place.place == Isocurve_place::VERTEX ||
       (meeting.place.place == Isocurve_place::EDGE && m_domain.is_oblique(meeting.place.halfedge)))
      return; // on an oblique border both end by themselves
    meeting.first = {a.curve, a.segment, a.length_up_to(b.level), a.direction};
    meeting.second = {b.curve, b.segment, b.length_up_to(a.level), b.direction};
    add_crossing(meeting);
  }

  void compare_visits(const Curve_index a, const Curve_index b, const Segment_index s)
  {
    const Segment_index last = Segment_index(m_curves[a].segments.size() - 1);
    if(is_at_oblique_border(m_curves[a].segments.back().exit))
      return;
    const std::size_t slot_a = slot_behind(a, last), slot_b = slot_behind(b, s);
    if((slot_a + slot_b) % 2 == 0)
      return slot_a == slot_b ? void() : wait_for_each_other(a, b, s);
    Meeting meeting;
    meeting.place.place = Isocurve_place::VERTEX;
    meeting.place.halfedge = m_curves[a].segments.back().exit.halfedge;
    meeting.first = {a, last, m_curves.length_at_vertex(a, last), Direction(slot_a)};
    meeting.second = {b, s, m_curves.length_at_vertex(b, s), Direction(slot_b)};
    add_crossing(meeting);
  }

  // Who comes to a vertex from opposite sides at the same time does not walk on beside the other
  // one. If they don't come at the same time, they meet in a face.
  void wait_for_each_other(Curve_index a, Curve_index b, const Segment_index s)
  {
    const Segment_index last_a = Segment_index(m_curves[a].segments.size() - 1);
    const Segment_index last_b = Segment_index(m_curves[b].segments.size() - 1);
    if(is_wall(b) || last_b != s)
      return;
    const Exact_level length = m_curves.length_at_vertex(a, last_a);
    if(!(length == m_curves.length_at_vertex(b, s)))
      return;
    is_waiting(a) = is_waiting(b) = true;
    Meeting meeting;
    meeting.kind = Meeting_kind::HEAD_ON_AT_VERTEX;
    meeting.twice_time = length.doubled();
    // the arc of both comes to the vertex by the segment of that with the lower number
    meeting.first = {a, last_a + (a < b ? 0 : 1), Exact_level(), Quarter_turns::identity()};
    meeting.second = {b, last_b + (b < a ? 0 : 1), Exact_level(), Quarter_turns::identity()};
    add(meeting);
  }

  // At a vertex that is no start, in quarter turns from its first ray.
  std::size_t slot_behind(const Curve_index c, const Segment_index s) const
  {
    return (slot_of_arrival(m_mesh, m_curves[c].segments[std::size_t(s)],
                            m_curves.chord(c, s).direction) + 2) % 4;
  }

  void add_crossing(Meeting& meeting)
  {
    if(comes_first(meeting.first, meeting.second))
      std::swap(meeting.first, meeting.second);
    meeting.twice_time = meeting.first.length.doubled();
    add(meeting);
  }

  // At the same time, whoever sees the other one come from the left goes first. Walls have always
  // been there.
  bool comes_first(const Curve_position& a, const Curve_position& b) const
  {
    if(is_wall(a.curve) || is_wall(b.curve))
      return is_wall(a.curve);
    const int order = compare(a.length, b.length);
    return order != 0 ? order < 0 : b.direction != turned(a.direction, Quarter_turns::element(1));
  }

  void add(const Meeting& meeting)
  {
    m_meetings.push_back(meeting);
    m_queue.push(std::int32_t(m_meetings.size() - 1));
  }

  bool reaches(const Curve_index c, const Exact_level& twice_length) const
  {
    const Layout_curve& curve = m_curves[c];
    return is_wall(c) || !curve.twice_length || compare(*curve.twice_length, twice_length) >= 0;
  }

  void meet(const std::int32_t m)
  {
    const Meeting& meeting = m_meetings[std::size_t(m)];
    switch(meeting.kind) {
    case Meeting_kind::CROSSING:
      return cross(m, meeting);
    case Meeting_kind::HEAD_ON:
      return meet_head_on(Meeting(meeting));
    case Meeting_kind::HEAD_ON_AT_VERTEX:
      return meet_at_vertex(meeting);
    case Meeting_kind::TRAIL:
      if(reaches(meeting.first.curve, meeting.twice_time))
        m_curves[meeting.first.curve].twice_length = meeting.twice_time;
      return;
    case Meeting_kind::BORDER:
      if(reaches(meeting.first.curve, meeting.twice_time)) {
        m_crossings.push_back(m);
        m_curves[meeting.first.curve].twice_length = meeting.twice_time;
      }
    }
  }

  void cross(const std::int32_t m, const Meeting& meeting)
  {
    const Curve_position &first = meeting.first, &second = meeting.second;
    if(!reaches(first.curve, meeting.twice_time) ||
       !reaches(second.curve, second.length.doubled()) ||
       (!m_crossings.empty() && is_same(m_meetings[std::size_t(m_crossings.back())], meeting)))
      return;
    m_crossings.push_back(m);
    if(is_wall(second.curve) || !m_options.ends || m_options.ends(meeting))
      m_curves[first.curve].twice_length = meeting.twice_time;
  }

  // If one of them has ended before, the other one runs on to its end, but no further.
  void meet_head_on(Meeting meeting)
  {
    const bool comes_first = reaches(meeting.first.curve, meeting.twice_time);
    const bool comes_second = reaches(meeting.second.curve, meeting.twice_time);
    if(comes_first && comes_second) {
      end_head_on(meeting.first, meeting.second.curve, meeting.twice_time);
      end_head_on(meeting.second, meeting.first.curve, meeting.twice_time);
    } else if(comes_first || comes_second) {
      if(comes_second)
        std::swap(meeting.first, meeting.second);
      meeting.kind = Meeting_kind::TRAIL;
      meeting.twice_time =
        meeting.twice_time.doubled().minus(*m_curves[meeting.second.curve].twice_length);
      add(meeting);
    }
  }

  // If one of them has ended before, the other one runs on.
  void meet_at_vertex(const Meeting& meeting)
  {
    const Curve_index a = meeting.first.curve, b = meeting.second.curve;
    const bool comes_a = reaches(a, meeting.twice_time), comes_b = reaches(b, meeting.twice_time);
    if(comes_a && comes_b) {
      end_head_on(meeting.first, b, meeting.twice_time);
      end_head_on(meeting.second, a, meeting.twice_time);
    } else if(comes_a || comes_b) {
      is_waiting(comes_a ? a : b) = false;
      m_advances.push({lower_bound(meeting.twice_time) / 2, comes_a ? a : b});
    }
  }

  void end_head_on(const Curve_position& position, const Curve_index other,
                   const Exact_level& twice_time)
  {
    Layout_curve& curve = m_curves[position.curve];
    curve.twice_length = twice_time;
    if(curve.partner != no_index)
      return;
    curve.partner = other;
    curve.last = position.segment;
  }

  // Whether both are one meeting, found in two faces.
  static bool is_same(const Meeting& a, const Meeting& b)
  {
    return a.first.curve == b.first.curve && a.second.curve == b.second.curve &&
           a.first.length == b.first.length && a.second.length == b.second.length;
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  const Race_options& m_options;
  Curve_set m_curves;
  Walk_limits m_limits;
  std::size_t m_first_trace = 0;
  std::vector<std::unique_ptr<Segment_walker> > m_walkers; // of traces that run on
  std::vector<char> m_is_waiting;                          // per trace: at a vertex
  std::priority_queue<Advance> m_advances;
  std::vector<Meeting> m_meetings;
  std::priority_queue<std::int32_t, std::vector<std::int32_t>, Later_meeting> m_queue{
    Later_meeting{&m_meetings}};
  std::vector<std::int32_t> m_crossings;
  std::size_t m_number_of_segments = 0;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_CURVE_RACE_H
