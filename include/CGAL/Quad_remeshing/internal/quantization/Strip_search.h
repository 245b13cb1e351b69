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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_SEARCH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_SEARCH_H

#include <CGAL/license/Quad_remeshing.h>

// The cheapest strip of triangles through a halfedge, along which all edges that it crosses may
// change by one unit, in one direction: a shortest path.

#include <CGAL/Quad_remeshing/internal/quantization/round_units.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// A halfedge, over which a strip leaves its face, and the direction in that face's chart by which
// the halfedge's vector changes.
using Strip_state = std::int32_t;

inline constexpr Strip_state no_strip_state = -1;

inline Strip_state strip_state(const Corner_index h, const int direction)
{ return 4 * h + direction; }
inline Corner_index halfedge_of(const Strip_state s) { return s / 4; }
inline Grid_vector change_of(const Strip_state s) { return unit_vector(s % 4); }

// The units of a face's halfedges.
using Face_units = std::array<Grid_vector, 3>;

inline void add_to(Face_units& units, const Corner_index h, const Grid_vector& change)
{
  units[std::size_t(h % 3)] = sum(units[std::size_t(h % 3)], change);
}

inline std::int64_t determinant(const Face_units& units)
{ return cross_product(units[0], units[1]); }

// What a change by one unit costs, and which are allowed. The complex has to outlive it.
class Strip_rules
{
public:
  Strip_rules(const Intrinsic_complex& complex, const std::vector<double>& scales)
    : m_complex(complex)
  {
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
      m_wanted.push_back(wanted_units(complex, h, scales));
      m_weight.push_back(weight_of_edge(m_wanted.back()));
      if(complex.opposite(h) == no_index)
        m_border.push_back(h);
    }
  }

  const Intrinsic_complex& complex() const { return m_complex; }
  const std::vector<Corner_index>& border() const { return m_border; }

  // Of the sum of weighted squares of deviations, if the halfedge's vector changes.
  double cost(const Corner_index h, const Grid_vector& change) const
  {
    const auto& wanted = m_wanted[std::size_t(h)];
    const Grid_vector& units = m_complex.corner(h).units;
    return m_weight[std::size_t(h)] *
           (1 + 2 * (static_cast<double>(change[0]) * (static_cast<double>(units[0]) - wanted[0]) +
                     static_cast<double>(change[1]) * (static_cast<double>(units[1]) - wanted[1])));
  }
  double cost(const Strip_state s) const { return cost(halfedge_of(s), change_of(s)); }

  // Walls change along themselves only.
  bool is_allowed(const Strip_state s) const
  {
    const Intrinsic_corner& corner = m_complex.corner(halfedge_of(s));
    const Grid_vector d = change_of(s);
    return !corner.is_wall || (corner.vector[0] == 0 ? d[0] == 0 : d[1] == 0);
  }

  bool is_no_worse(const Flat_face_index f, const std::int64_t before,
                   const std::int64_t after) const
  {
    return after > 0 || (before <= 0 && after - before >= (f == face_to_raise ? 1 : 0));
  }

  Face_units units_of_face(const Flat_face_index f) const
  {
    return {m_complex.corner(3 * f).units, m_complex.corner(3 * f + 1).units,
            m_complex.corner(3 * f + 2).units};
  }

  // The direction of the change in the chart of the face on the other side.
  // \pre no border
  int direction_across(const Strip_state s) const
  { return Quarter_turns::compose(m_complex.corner(halfedge_of(s)).rotation, s % 4); }

  // The same edge from the other side; strips through it are the same, in the other direction.
  // \pre no border
  Strip_state reversed(const Strip_state s) const
  { return strip_state(m_complex.opposite(halfedge_of(s)), (direction_across(s) + 2) % 4); }

  Flat_face_index face_to_raise = no_index; // a strip has to raise its determinant

private:
  const Intrinsic_complex& m_complex;
  std::vector<Corner_index> m_border;
  std::vector<std::array<double, 2> > m_wanted; // per halfedge
  std::vector<double> m_weight;                 // per halfedge
};

// Invariant: what has been reached was reached from the start, by allowed changes.
class Strip_search
{
public:
  explicit Strip_search(const Strip_rules& rules)
    : m_rules(rules), m_reached(4 * rules.complex().corners.size()),
      m_reached_faces(rules.complex().corners.size() / 3)
  { }

  // Of a strip through the state whose other costs add up to less than `bound`, gains not counted.
  void start(const Strip_state s, const double bound)
  {
    ++m_round;
    m_queue = Queue();
    m_is_border_reached = false;
    m_start = s;
    m_bound = bound;
    expand(s, 0);
  }

  // The number of ways that are open. Without any, there is no strip.
  std::size_t width() const { return m_queue.size(); }

  // One step. Returns whether the strip has closed.
  // \pre width() > 0
  bool advance()
  {
    const auto [distance, s] = m_queue.top();
    m_queue.pop();
    if(distance > reached(s).distance)
      return false;
    if(s == m_start)
      return true;
    expand(s, distance);
    return false;
  }

  // Of the strip that has closed: the sum of the other costs.
  double distance() const { return reached(m_start).distance; }

  // Of the strip that has closed: calls `visit(exit, entry, change)` for its faces, with the
  // halfedges over which it leaves and enters a face, and the change in the face's chart.
  template <typename Visit>
  void for_each_face(const Visit& visit) const
  {
    Strip_state s = m_start;
    do {
      visit(halfedge_of(s), reached(s).entry, change_of(s));
      s = reached(s).parent;
    } while(s != m_start);
  }

  // A small cost for each step keeps strips short.
  static double positive(const double cost) { return (std::max)(cost, 0.) + 1e-6; }

private:
  struct Reached
  {
    double distance;
    Strip_state parent;
    Corner_index entry;     // the halfedge over which the strip enters its face
    std::int32_t round = 0; // valid if it is the current one
  };

  struct Reached_face
  {
    double least_distance; // of its states, but for the start
    std::int32_t round = 0;
  };

  const Reached& reached(const Strip_state s) const { return m_reached[std::size_t(s)]; }
  bool is_reached(const Strip_state s) const { return reached(s).round == m_round; }

  // The units of a face after a strip that has come to the state `from`: it may have passed the
  // face before, in another direction.
  Face_units units_on_the_way(const Flat_face_index f, const Strip_state from) const
  {
    Face_units units = m_rules.units_of_face(f);
    const double nearest = least_distance(f);
    for(Strip_state s = from; s != m_start && reached(s).distance >= nearest; s = reached(s).parent)
      if(halfedge_of(s) / 3 == f) {
        add_to(units, halfedge_of(s), change_of(s));
        add_to(units, reached(s).entry, negated(change_of(s)));
      }
    return units;
  }

  // Of the face's states that the search has reached. Distances grow along a strip: where they are
  // less than this, it has not passed the face yet.
  double least_distance(const Flat_face_index f) const
  {
    const Reached_face& face = m_reached_faces[std::size_t(f)];
    return face.round == m_round ? face.least_distance : std::numeric_limits<double>::infinity();
  }

  void set_reached(const Strip_state s, const double distance, const Strip_state parent,
                   const Corner_index entry)
  {
    m_reached[std::size_t(s)] = {distance, parent, entry, m_round};
    if(s == m_start)
      return;
    const Flat_face_index f = halfedge_of(s) / 3;
    m_reached_faces[std::size_t(f)] = {(std::min)(distance, least_distance(f)), m_round};
  }

  void expand(const Strip_state s, const double distance)
  {
    const Corner_index h = halfedge_of(s), g = m_rules.complex().opposite(h);
    if(g != no_index) {
      enter(s, g, m_rules.direction_across(s), distance);
      return;
    }
    if(m_is_border_reached)
      return;
    m_is_border_reached = true;
    for(const Corner_index b : m_rules.border())
      for(int k = 0; k < 4; ++k)
        if(m_rules.is_allowed(strip_state(b, k)) && b != h)
          enter(s, b, k, distance + positive(m_rules.cost(b, negated(unit_vector(k)))));
  }

  void enter(const Strip_state from, const Corner_index entry, const int direction,
             const double distance)
  {
    const Flat_face_index f = entry / 3;
    std::optional<Face_units> entered; // most ways are not shorter, and end before
    for(const Corner_index exit :
        {Intrinsic_complex::next(entry), Intrinsic_complex::prev(entry)}) {
      const Strip_state s = strip_state(exit, direction);
      if(!m_rules.is_allowed(s))
        continue;
      const double d = s == m_start ? distance : distance + positive(m_rules.cost(s));
      if(d >= m_bound || (is_reached(s) && reached(s).distance <= d))
        continue;
      if(!entered)
        entered = units_on_the_way(f, from);
      Face_units after = *entered;
      add_to(after, entry, negated(change_of(s)));
      add_to(after, exit, change_of(s));
      if(!m_rules.is_no_worse(f, determinant(m_rules.units_of_face(f)), determinant(after)))
        continue;
      set_reached(s, d, from, entry);
      m_queue.emplace(d, s);
    }
  }

  using Queued = std::pair<double, Strip_state>;
  using Queue = std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued> >;

  const Strip_rules& m_rules;
  std::vector<Reached> m_reached;            // per state
  std::vector<Reached_face> m_reached_faces; // per face
  std::int32_t m_round = 0;
  Strip_state m_start = no_strip_state;
  double m_bound = 0;
  bool m_is_border_reached = false;
  Queue m_queue;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_SEARCH_H
