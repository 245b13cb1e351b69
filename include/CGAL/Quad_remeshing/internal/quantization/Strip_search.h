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

#include <CGAL/Quad_remeshing/internal/quantization/Strip_rules.h>

#include <boost/heap/d_ary_heap.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// From the start on, or, as one of two, from its other side back: these close a strip where they
// meet, or where both get to the border. A single one finds strips that close inside only.
// Invariant: what has been reached was reached from the start, by allowed changes.
class Strip_search
{
public:
  explicit Strip_search(const Strip_rules& rules)
    : m_rules(rules), m_reached(4 * rules.complex().corners.size()),
      m_passed(rules.complex().corners.size() / 3)
  { }

  // Starts a search for a strip through the state whose costs add up to less than `bound`. The
  // costs of the faces on both sides of the start count from their least values on; gains of other
  // faces do not count.
  void clear(const Strip_state s, const double bound)
  {
    ++m_round;
    m_queue.clear();
    m_exits = {no_strip_state, no_strip_state};
    m_start = s;
    m_bound = m_length = bound;
  }

  // \param entry where the strip enters its first face; none if it starts on the border
  // \param other the search from the other side, if there is one
  // \pre both are clear
  void start(const Strip_state entry, const Strip_search* other)
  {
    m_other = other;
    if(entry != no_strip_state) {
      m_least_costs = {m_rules.least_cost(entry),
                       m_rules.least_cost(with_opposite_change(m_start))};
      enter(m_start, entry, 0);
      return;
    }
    m_reached[std::size_t(m_start)] = {0, 0, m_start, no_index, m_round};
    m_exits[0] = m_start;
  }

  // The number of ways that are open. Without any, nothing else will be reached.
  std::size_t width() const { return m_queue.size(); }

  // The least cost of a strip that goes on from here, and of a strip that ends at the border.
  double distance() const { return width() == 0 ? infinity : m_queue.top().distance(); }
  double distance_of_border() const { return distance(m_exits[0]); }

  // One step.
  // \pre width() > 0
  void advance()
  {
    const double distance = m_queue.top().distance();
    const Strip_state s = m_queue.top().state;
    m_queue.pop();
    if(distance > reached(s).distance)
      return;
    Passed& passed = m_passed[std::size_t(halfedge_of(s) / 3)];
    if(passed.round != m_round)
      passed = {distance, m_round};
    enter(s, m_rules.across(s), distance);
  }

  // The sum of the other costs of the cheapest strip that has closed; or the bound.
  double length() const { return m_length; }

  bool has_closed() const { return m_length < m_bound; }

  // The state in which the two have met, or the start, and the end of the other one.
  Strip_state end() const { return m_end; }
  Strip_state end_of_other() const { return m_end_of_other; }

  // Back from the end to the start: calls `visit(exit, entry)` for the faces of the strip, with the
  // state by which it leaves a face, and the halfedge over which it enters it.
  template <typename Visit>
  void for_each_face(const Strip_state end, const Visit& visit) const
  {
    Strip_state s = end;
    if(reached(s).entry == no_index)
      return;
    do {
      visit(s, reached(s).entry);
      s = reached(s).parent;
    } while(s != m_start);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // One bit for each face of a strip; others may share it.
  using Face_bits = std::uint64_t;

  static Face_bits bit_of(const Flat_face_index f) { return Face_bits(1) << (f % 64); }

  struct Reached
  {
    double distance;
    Face_bits faces; // of the strip so far, except the face of the start
    Strip_state parent;
    Corner_index entry;     // the halfedge over which the strip enters its face
    std::int32_t round = 0; // valid if it is the current one
  };

  // The first strip through a face.
  struct Passed
  {
    double distance;
    std::int32_t round = 0;
  };

  // In one integer, because non-negative numbers are in the order of their bits: it takes less time
  // to compare than a pair.
  struct Queued
  {
    std::int64_t bits_of_distance;
    Strip_state state;

    Queued(const double distance, const Strip_state s) : state(s)
    { std::memcpy(&bits_of_distance, &distance, sizeof(distance)); }

    double distance() const
    {
      double result;
      std::memcpy(&result, &bits_of_distance, sizeof(result));
      return result;
    }

    bool operator>(const Queued& other) const
    {
      const std::int64_t d = bits_of_distance - other.bits_of_distance;
      return (d != 0 ? d : state - other.state) > 0;
    }
  };

  using Queue = boost::heap::d_ary_heap<Queued, boost::heap::arity<4>,
                                        boost::heap::compare<std::greater<Queued> > >;

  const Reached& reached(const Strip_state s) const { return m_reached[std::size_t(s)]; }
  bool is_reached(const Strip_state s) const { return reached(s).round == m_round; }

  // Faces that a strip to the state, which the search has reached, may have left.
  Face_bits faces_before(const Strip_state s) const { return s == m_start ? 0 : reached(s).faces; }

  // Distances grow along a strip: as long as they are less than the distance of the first strip
  // through the face, the strip has not passed the face yet.
  bool may_have_passed(const Flat_face_index f, const Strip_state s) const
  {
    const Passed& passed = m_passed[std::size_t(f)];
    return (faces_before(s) & bit_of(f)) != 0 && passed.round == m_round &&
           reached(s).distance >= passed.distance;
  }

  // Whether the face gets no worse by a strip to `from` that goes on into it, and leaves it by `s`.
  bool is_open(const Strip_state from, const Corner_index entry, const Strip_state s) const
  {
    const Corner_index exit = halfedge_of(s);
    const Flat_face_index f = exit / 3;
    const std::int64_t before = m_rules.determinant_of_face(f);
    if(may_have_passed(f, from))
      return m_rules.is_no_worse(f, before, determinant_on_the_way(from, entry, s));
    // of the exit and the edge that stays
    const bool is_first = exit == Intrinsic_complex::next(entry);
    const Corner_index other = is_first ? Intrinsic_complex::next(exit)
                                        : Intrinsic_complex::prev(exit);
    const std::int64_t cross = m_rules.cross(strip_state(other, s % 4));
    return m_rules.is_no_worse(f, before, checked_difference(before, is_first ? -cross : cross));
  }

  // The strip may have passed the face before, in another direction.
  std::int64_t determinant_on_the_way(const Strip_state from, const Corner_index entry,
                                      const Strip_state s) const
  {
    const Flat_face_index f = entry / 3;
    Face_units units = m_rules.units_of_face(f);
    for(Strip_state t = from; may_have_passed(f, t); t = reached(t).parent)
      if(halfedge_of(t) / 3 == f) {
        add_to(units, halfedge_of(t), change_of(t));
        add_to(units, reached(t).entry, negated(change_of(t)));
      }
    add_to(units, entry, negated(change_of(s)));
    add_to(units, halfedge_of(s), change_of(s));
    return determinant(units);
  }

  // \param side the halfedge over which the strip enters, and the direction in the chart there
  void enter(const Strip_state from, const Strip_state side, const double distance)
  {
    if(distance >= m_bound)
      return;
    const Corner_index entry = halfedge_of(side);
    for(const Corner_index exit :
        {Intrinsic_complex::next(entry), Intrinsic_complex::prev(entry)}) {
      const Strip_state s = strip_state(exit, side % 4);
      const double d = distance + cost_of_face(from, entry, s) +
                       (s == m_start ? 0. : m_rules.price(s));
      if(d >= m_bound || (is_reached(s) && reached(s).distance <= d) || !is_open(from, entry, s))
        continue;
      m_reached[std::size_t(s)] = {d, faces_before(from) | bit_of(exit / 3), from, entry, m_round};
      close_at(s);
      if(m_rules.is_border(s))
        add_exit(s);
      else if(s != m_start)
        m_queue.emplace(d, s);
    }
  }

  double cost_of_face(const Strip_state from, const Corner_index entry,
                      const Strip_state exit) const
  {
    const double cost = m_rules.cost(Strip_rules::edge_that_stays(entry, exit));
    const auto& [ahead, behind] = m_least_costs;
    return (std::max)(0., from == m_start ? cost - ahead : exit == m_start ? cost - behind : cost);
  }

  // Ends the search if a strip closes here.
  void close_at(const Strip_state s)
  {
    if(m_other == nullptr) {
      if(s == m_start)
        close(s, no_strip_state, reached(s).distance);
    } else if(m_rules.is_border(s)) {
      for(const Strip_state e : m_other->m_exits)
        if(e != no_strip_state && halfedge_of(e) != halfedge_of(s))
          close(s, e, reached(s).distance + m_other->reached(e).distance);
    } else if(const Strip_state r = m_rules.reversed(s); s != m_start && m_other->is_reached(r)) {
      close(s, r, reached(s).distance - m_rules.price(s) + m_other->reached(r).distance);
    }
  }

  void close(const Strip_state end, const Strip_state end_of_other, const double length)
  {
    if(length >= m_length)
      return;
    m_length = length;
    m_end = end;
    m_end_of_other = end_of_other;
  }

  double distance(const Strip_state s) const
  { return s == no_strip_state ? infinity : reached(s).distance; }

  void add_exit(const Strip_state s)
  {
    auto& [first, second] = m_exits;
    const bool is_another = first == no_strip_state || halfedge_of(first) != halfedge_of(s);
    if(distance(s) < distance(first)) {
      if(is_another)
        second = first;
      first = s;
    } else if(is_another && distance(s) < distance(second)) {
      second = s;
    }
  }

  const Strip_rules& m_rules;
  std::vector<Reached> m_reached; // per state
  std::vector<Passed> m_passed;   // per face
  std::int32_t m_round = 0;
  Strip_state m_start = no_strip_state, m_end = no_strip_state, m_end_of_other = no_strip_state;
  std::array<Strip_state, 2> m_exits; // the cheapest ones over different edges of the border
  std::array<double, 2> m_least_costs; // of the faces ahead of the start, and behind it
  double m_bound = 0, m_length = 0;
  const Strip_search* m_other = nullptr;
  Queue m_queue;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_SEARCH_H
