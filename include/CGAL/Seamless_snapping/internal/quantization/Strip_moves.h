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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUANTIZATION_STRIP_MOVES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUANTIZATION_STRIP_MOVES_H

#include <CGAL/license/Seamless_snapping.h>

// Moves of the units of a complex: along a strip of triangles that closes, or leads from border to
// border, all edges that it crosses change by one unit, in one direction. So triangles stay closed,
// sides of edges match, and walls stay on their isocurves. Strips are found as shortest paths.

#include <CGAL/Seamless_snapping/internal/quantization/round_units.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// So few that another search for more, which takes as long, is not worth it; none in small
// complexes.
inline std::size_t few_moves(const Intrinsic_complex& complex)
{
  return std::size_t(complex.number_of_faces() / 100);
}

// Invariant: no move makes a positive triangle otherwise; nor does it change the angle around a
// vertex where all triangles are positive, since they stay positive all along the move.
class Strip_moves
{
public:
  Strip_moves(Intrinsic_complex& complex, const std::vector<double>& scales)
    : m_complex(complex), m_distance(4 * complex.corners.size()), m_round(m_distance.size(), 0),
      m_parent(m_distance.size()), m_entry(m_distance.size())
  {
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
      m_wanted.push_back(wanted_units(complex, h, scales));
      m_weight.push_back(weight_of_edge(m_wanted.back()));
      if(complex.opposite(h) == no_index)
        m_border.push_back(h);
    }
  }

  // Moves that lower the sum of weighted squares of deviations, until there are few. Returns their
  // number.
  std::size_t improve(const std::size_t most_rounds)
  {
    std::size_t number = 0, before = 0;
    for(std::size_t round = 0;
        round < most_rounds && (round == 0 || number - before > few_moves(m_complex)); ++round) {
      before = number;
      for(const State s : improving_states())
        while(cost(s) < -least_gain && find_strip(s, -cost(s)) && apply(s, -least_gain))
          ++number;
    }
    return number;
  }

  // Moves that make the triangle positive. Returns false if that fails.
  bool repair(const Flat_face_index face)
  {
    for(int i = 0; i < 100; ++i) {
      if(orientation(m_complex, face, &Intrinsic_corner::units) > 0)
        return true;
      if(!raise(face))
        return false;
    }
    return false;
  }

private:
  // A halfedge, from whose face the strip comes, and the direction in that face's chart by which
  // the halfedge's vector changes.
  using State = std::int32_t;
  static constexpr State no_state = -1;
  static constexpr double least_gain = 1e-9;
  static constexpr double dearest_repair = 20; // as a sum of weighted squares

  static State state(const Corner_index h, const int direction) { return 4 * h + direction; }
  static Corner_index halfedge(const State s) { return s / 4; }
  static Grid_vector change(const State s) { return unit_vector(s % 4); }

  // Of the sum of weighted squares, if the halfedge's vector changes.
  double cost(const Corner_index h, const Grid_vector& change) const
  {
    const auto& wanted = m_wanted[std::size_t(h)];
    const Grid_vector& units = m_complex.corner(h).units;
    return m_weight[std::size_t(h)] *
           (1 + 2 * (static_cast<double>(change[0]) * (static_cast<double>(units[0]) - wanted[0]) +
                     static_cast<double>(change[1]) * (static_cast<double>(units[1]) - wanted[1])));
  }
  double cost(const State s) const { return cost(halfedge(s), change(s)); }

  // Walls change along themselves only.
  bool is_allowed(const State s) const
  {
    const Intrinsic_corner& corner = m_complex.corner(halfedge(s));
    const Grid_vector d = change(s);
    return !corner.is_wall || (corner.vector[0] == 0 ? d[0] == 0 : d[1] == 0);
  }

  std::vector<State> improving_states() const
  {
    std::vector<std::pair<double, State> > found;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h))
        for(int k = 0; k < 4; ++k)
          if(cost(state(h, k)) < -least_gain && is_allowed(state(h, k)))
            found.emplace_back(cost(state(h, k)), state(h, k));
    std::sort(found.begin(), found.end());
    std::vector<State> result;
    for(const auto& [gain, s] : found)
      result.push_back(s);
    return result;
  }

  struct Change
  {
    Corner_index halfedge;
    Grid_vector vector;
  };

  // Of two of the halfedges of a face.
  static std::int64_t determinant(const std::array<Grid_vector, 3>& units)
  { return cross_product(units[0], units[1]); }

  std::array<Grid_vector, 3> units_of_face(const Flat_face_index f) const
  {
    return {m_complex.corner(3 * f).units, m_complex.corner(3 * f + 1).units,
            m_complex.corner(3 * f + 2).units};
  }

  static void add_to(std::array<Grid_vector, 3>& units, const Corner_index h, const Grid_vector& d)
  {
    units[std::size_t(h % 3)] = sum(units[std::size_t(h % 3)], d);
  }

  // Whether a strip that has come to the state `from` may enter the next face over `entry` and
  // leave it by `exit`. It may have been there before, in another direction.
  bool may_pass(const State from, const Corner_index entry, const State exit,
                const State start) const
  {
    const Flat_face_index f = halfedge(exit) / 3;
    std::array<Grid_vector, 3> units = units_of_face(f);
    const std::int64_t before = determinant(units);
    const double nearest = least_distance(f, start);
    for(State s = from; s != start && m_distance[std::size_t(s)] >= nearest;
        s = m_parent[std::size_t(s)])
      if(halfedge(s) / 3 == f) {
        add_to(units, halfedge(s), change(s));
        add_to(units, m_entry[std::size_t(s)], negated(change(s)));
      }
    add_to(units, halfedge(exit), change(exit));
    add_to(units, entry, negated(change(exit)));
    return is_no_worse(f, before, determinant(units));
  }

  // Of the face's states that the search has reached. Distances grow along a strip: where they are
  // less than this, it has not passed the face yet.
  double least_distance(const Flat_face_index f, const State start) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(State s = state(3 * f, 0); s < state(3 * f + 3, 0); ++s)
      if(m_round[std::size_t(s)] == m_current_round && s != start)
        result = (std::min)(result, m_distance[std::size_t(s)]);
    return result;
  }

  bool is_no_worse(const Flat_face_index f, const std::int64_t before,
                   const std::int64_t after) const
  {
    return after > 0 || (before <= 0 && after - before >= (f == m_face_to_raise ? 1 : 0));
  }

  // The cheapest strip through the state whose other costs add up to less than `bound`, gains not
  // counted. Its states are then parents of each other.
  bool find_strip(const State start, const double bound)
  {
    ++m_current_round;
    m_queue = Queue();
    m_is_border_reached = false;
    expand(start, 0, bound, start);
    while(!m_queue.empty()) {
      const auto [distance, s] = m_queue.top();
      m_queue.pop();
      if(distance > m_distance[std::size_t(s)])
        continue;
      if(s == start)
        return true;
      expand(s, distance, bound, start);
    }
    return false;
  }

  void expand(const State s, const double distance, const double bound, const State start)
  {
    const Corner_index h = halfedge(s), g = m_complex.opposite(h);
    if(g != no_index) {
      const int direction = Quarter_turns::compose(m_complex.corner(h).rotation, s % 4);
      enter(s, g, direction, distance, bound, start);
      return;
    }
    if(m_is_border_reached)
      return;
    m_is_border_reached = true;
    for(const Corner_index b : m_border)
      for(int k = 0; k < 4; ++k)
        if(is_allowed(state(b, k)) && b != h)
          enter(s, b, k, distance + positive(cost(b, negated(unit_vector(k)))), bound, start);
  }

  // A small cost for each step keeps strips short.
  static double positive(const double cost) { return (std::max)(cost, 0.) + 1e-6; }

  void enter(const State from, const Corner_index entry, const int direction, const double distance,
             const double bound, const State start)
  {
    for(const Corner_index exit :
        {Intrinsic_complex::next(entry), Intrinsic_complex::prev(entry)}) {
      const State s = state(exit, direction);
      if(!is_allowed(s) || !may_pass(from, entry, s, start))
        continue;
      const double d = s == start ? distance : distance + positive(cost(s));
      if(d >= bound ||
         (m_round[std::size_t(s)] == m_current_round && m_distance[std::size_t(s)] <= d))
        continue;
      m_round[std::size_t(s)] = m_current_round;
      m_distance[std::size_t(s)] = d;
      m_parent[std::size_t(s)] = from;
      m_entry[std::size_t(s)] = entry;
      m_queue.emplace(d, s);
    }
  }

  // Makes the move along the strip that was found, if it changes the sum of squares by less than
  // `bound`, and keeps triangles positive that are.
  bool apply(const State start, const double bound)
  {
    m_changes.clear();
    State s = start;
    do {
      m_changes.push_back({halfedge(s), change(s)});
      m_changes.push_back({m_entry[std::size_t(s)], negated(change(s))});
      s = m_parent[std::size_t(s)];
    } while(s != start);
    double difference = 0;
    for(const Change& c : m_changes) {
      const Corner_index g = m_complex.opposite(c.halfedge);
      if(g == no_index || c.halfedge < g)
        difference += cost(c.halfedge, c.vector);
      add(c.halfedge, c.vector);
    }
    if(difference < bound && are_faces_positive())
      return true;
    for(const Change& c : m_changes)
      add(c.halfedge, negated(c.vector));
    return false;
  }

  // Those that have been changed; also all the way from what they were.
  bool are_faces_positive() const
  {
    for(std::size_t i = 0; i < m_changes.size(); i += 2) {
      const Flat_face_index f = m_changes[i].halfedge / 3;
      const std::array<Grid_vector, 3> after = units_of_face(f);
      std::array<Grid_vector, 3> before = after, shift{};
      for(const Change& c : m_changes)
        if(c.halfedge / 3 == f) {
          add_to(before, c.halfedge, negated(c.vector));
          add_to(shift, c.halfedge, c.vector);
        }
      const std::int64_t a = determinant(before), d = determinant(after);
      const std::int64_t square = determinant(shift);
      const std::int64_t slope = d - a - square; // of a + slope t + square t^2 at t = 0
      if(!is_no_worse(f, a, d) ||
         (a > 0 && square > 0 && slope < 0 && -slope < 2 * square &&
          checked_product(slope, slope) >= checked_product(4 * square, a)))
        return false;
    }
    return true;
  }

  void add(const Corner_index h, const Grid_vector& change)
  {
    Grid_vector& units = m_complex.corners[std::size_t(h)].units;
    units = sum(units, change);
  }

  // The cheapest move that raises the determinant of a triangle. Most are cheap, and found soon.
  bool raise(const Flat_face_index face)
  {
    m_face_to_raise = face;
    State best = no_state;
    double least = 0;
    for(const double bound : {2., dearest_repair})
      if(best == no_state) {
        least = bound;
        best = cheapest_raise(face, least);
      }
    const bool is_found = best != no_state && find_strip(best, dearest_repair) &&
                          apply(best, std::numeric_limits<double>::infinity());
    m_face_to_raise = no_index;
    return is_found;
  }

  // Lowers `least` to its cost.
  State cheapest_raise(const Flat_face_index face, double& least)
  {
    State best = no_state;
    for(Corner_index h = 3 * face; h < 3 * face + 3; ++h)
      for(int k = 0; k < 4; ++k) {
        const State s = state(h, k);
        if(!is_allowed(s) || !find_strip(s, least - positive(cost(s))))
          continue;
        best = s;
        least = m_distance[std::size_t(s)] + positive(cost(s));
      }
    return best;
  }

  using Queued = std::pair<double, State>;
  using Queue = std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued> >;

  Intrinsic_complex& m_complex;
  std::vector<std::array<double, 2> > m_wanted; // per halfedge
  std::vector<double> m_weight;                 // per halfedge
  std::vector<Corner_index> m_border;
  // Per state, valid if its round is the current one.
  std::vector<double> m_distance;
  std::vector<std::int32_t> m_round;
  std::vector<State> m_parent;
  std::vector<Corner_index> m_entry; // the halfedge over which the strip enters its face
  std::vector<Change> m_changes; // of the strip
  std::int32_t m_current_round = 0;
  bool m_is_border_reached = false;
  Flat_face_index m_face_to_raise = no_index;
  Queue m_queue;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUANTIZATION_STRIP_MOVES_H
