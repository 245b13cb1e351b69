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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_MOVES_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_MOVES_H

#include <CGAL/license/Quad_remeshing.h>

// Moves of the units of a complex: along a strip of triangles that closes, or leads from border to
// border, all edges that it crosses change by one unit, in one direction. So triangles stay closed,
// sides of edges match, and walls stay on their isocurves.

#include <CGAL/Quad_remeshing/internal/cells/Line_between_quads.h>
#include <CGAL/Quad_remeshing/internal/quantization/Strip_search.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The cheapest strip through an edge, by two searches, one from each of its sides, that meet.
class Strip_finder
{
public:
  // \param rules have to outlive it
  explicit Strip_finder(const Strip_rules& rules)
    : m_rules(rules), m_searches{Strip_search(rules), Strip_search(rules)}
  { }

  // The cheapest strip through the state whose costs add up to less than `bound`, where gains count
  // for the faces on both sides of the start only. The search goes on where fewer ways are open:
  // where triangles can't get smaller, one side ends soon, and there is none. A search from one
  // side finds strips that close inside only.
  bool find(const Strip_state start, const double bound, const bool from_both_sides = true)
  {
    auto& [there, back] = m_searches;
    m_least_cost = m_rules.least_cost_around(start);
    if(!(m_least_cost < bound))
      return false;
    there.clear(start, bound - m_least_cost);
    back.clear(m_rules.reversed(start), bound - m_least_cost);
    there.start(m_rules.across(start), from_both_sides ? &back : nullptr);
    if(from_both_sides)
      back.start(with_opposite_change(start), &there);
    for(;;) {
      m_found = back.length() < there.length() ? 1 : 0;
      const double least = from_both_sides ? least_length() : there.distance();
      if(least >= m_searches[m_found].length())
        return is_found();
      const bool is_back_narrower = there.width() == 0 || back.width() < there.width();
      (is_back_narrower && back.width() > 0 ? back : there).advance();
      ++m_number_of_steps;
    }
  }

  // The steps of all searches.
  std::size_t number_of_steps() const { return m_number_of_steps; }

  bool is_found() const { return m_searches[m_found].has_closed(); }

  // The length of the strip that was found: the sum of its costs.
  double length() const { return m_least_cost + m_searches[m_found].length(); }

  // As in Strip_search, for the strip that was found.
  template <typename Visit>
  void for_each_face(const Visit& visit) const
  {
    const Strip_search& found = m_searches[m_found];
    found.for_each_face(found.end(), visit);
    if(found.end_of_other() != no_strip_state)
      m_searches[1 - m_found].for_each_face(found.end_of_other(), visit);
  }

private:
  // A lower bound for strips that are not found yet: two ways that go on, or one and the border.
  double least_length() const
  {
    const auto& [there, back] = m_searches;
    return (std::min)((std::min)(there.distance(), there.distance_of_border()) + back.distance(),
                      there.distance() + back.distance_of_border());
  }

  const Strip_rules& m_rules;
  std::array<Strip_search, 2> m_searches;
  std::size_t m_found = 0; // the search that closed the strip
  double m_least_cost = 0; // of the faces on both sides of the start
  std::size_t m_number_of_steps = 0;
};

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
  // \param work receives what the moves take, but never ends them
  Strip_moves(Intrinsic_complex& complex, const std::vector<double>& scales, Work& work,
              const Cost_of_units cost = Cost_of_units::LENGTHS)
    : m_complex(complex), m_rules(complex, scales, cost), m_finder(m_rules), m_work(work)
  { }

  ~Strip_moves()
  {
    constexpr double part = 1. / 20; // of the unit, that a step of a search takes, or a change
    m_work.spend(part * double(m_complex.corners.size() + m_finder.number_of_steps() +
                               m_number_of_changes));
  }

  Strip_moves(const Strip_moves&) = delete;
  Strip_moves& operator=(const Strip_moves&) = delete;

  // Moves that lower the sum of weighted squares of deviations, until there are few. Returns their
  // number. Starts with large gains come first: where there is no strip from one, none from a later
  // one leads there either, because it would have been found.
  std::size_t improve(const std::size_t most_rounds)
  {
    std::size_t number = 0, before = 0;
    for(std::size_t round = 0;
        round < most_rounds && (round == 0 || number - before > few_moves(m_complex)); ++round) {
      before = number;
      m_rules.allow_all();
      for(const Strip_state s : improving_states())
        number += improve_from(s);
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

  // Makes the move along a line, by which edges that it crosses get one unit longer, if triangles
  // stay positive that are. Returns whether they do.
  bool move_along(const std::vector<Face_on_line>& faces)
  {
    m_changes.clear();
    for(const Face_on_line& f : faces)
      add_change(strip_state(f.exit, f.left), f.entry);
    return apply_changes(std::numeric_limits<double>::infinity());
  }

  // Makes the cheapest move that changes a halfedge by one unit in this direction. Returns whether
  // there is one.
  bool change(const Corner_index h, const Direction direction)
  {
    constexpr double no_bound = std::numeric_limits<double>::infinity();
    const Strip_state s = strip_state(h, direction);
    return m_rules.is_allowed(s) && move(s, no_bound, no_bound);
  }

private:
  static constexpr double least_gain = 1e-9; // above rounding errors
  static constexpr double dearest_repair = 20; // as a sum of weighted squares

  std::vector<Strip_state> improving_states() const
  {
    std::vector<std::pair<double, Strip_state> > found;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h))
        for(int k = 0; k < 4; ++k) {
          const Strip_state s = strip_state(h, k);
          if(!m_rules.is_allowed(s))
            continue;
          if(const double cost = m_rules.least_cost_around(s); cost < -least_gain)
            found.emplace_back(cost, s);
        }
    std::sort(found.begin(), found.end());
    std::vector<Strip_state> result;
    for(const auto& [gain, s] : found)
      result.push_back(s);
    return result;
  }

  // Returns the number of moves. Moves along one strip are made at once, as many as gain and keep
  // triangles positive: there are thousands if the scale is far from the wanted one.
  std::size_t improve_from(const Strip_state s)
  {
    std::size_t number = 0;
    while(move(s, -least_gain, -least_gain)) {
      ++number;
      for(std::int64_t k = number_of_gains(); k > 0; k /= 2)
        number += apply_changes(-least_gain, k) ? std::size_t(k) : 0;
    }
    if(number == 0 && !m_is_strip_found)
      m_rules.forbid(s);
    return number;
  }

  // Makes a move along a strip as the finder and apply() say. Two searches don't know of each
  // other which faces they pass: where both pass one, and it doesn't stay positive, a single one
  // may still find a way.
  bool move(const Strip_state start, const double bound, const double bound_of_change)
  {
    m_is_strip_found = m_finder.find(start, bound);
    return m_is_strip_found && (apply(bound_of_change) || (m_finder.find(start, bound, false) &&
                                                           apply(bound_of_change)));
  }

  // Makes the move along the strip that was found, as below.
  bool apply(const double bound)
  {
    m_changes.clear();
    m_finder.for_each_face([&](const Strip_state exit, const Corner_index entry)
                           { add_change(exit, entry); });
    return apply_changes(bound);
  }

  void add_change(const Strip_state exit, const Corner_index entry)
  { m_changes.push_back({exit, entry, m_rules.units_of_face(entry / 3)}); }

  // So many times, if that changes the sum of squares by less than `bound`, and keeps triangles
  // positive that are.
  bool apply_changes(const double bound, const std::int64_t times = 1)
  {
    const bool is_better = make_changes(times) < bound && are_faces_positive();
    if(!is_better)
      make_changes(-times);
    else
      for(Change& c : m_changes) {
        m_rules.update(c.entry / 3);
        c.before = m_rules.units_of_face(c.entry / 3);
      }
    return is_better;
  }

  // Returns by how much the sum of squares changes.
  double make_changes(const std::int64_t times)
  {
    double difference = 0;
    m_number_of_changes += m_changes.size();
    for(const Change& c : m_changes) {
      difference += m_rules.cost_of_moves(Strip_rules::edge_that_stays(c.entry, c.exit),
                                          double(times));
      const Grid_vector change = multiplied(times, change_of(c.exit));
      add(halfedge_of(c.exit), change);
      add(c.entry, negated(change));
    }
    return difference;
  }

  void add(const Corner_index h, const Grid_vector& change)
  {
    Grid_vector& units = m_complex.corners[std::size_t(h)].units;
    units = sum(units, change);
  }

  // How often the changes can be made until once more gains nothing: what they gain is linear.
  std::int64_t number_of_gains()
  {
    constexpr double most = 1e9; // moves along one strip at once
    const double first = make_changes(1), second = make_changes(1);
    make_changes(-2);
    if(first >= -least_gain || first >= second) // the latter by rounding only
      return 0;
    return std::int64_t((std::min)(most, std::ceil((first + least_gain) / (first - second))));
  }

  // Whether all changed faces are positive, now and during the change.
  bool are_faces_positive() const
  {
    for(const Change& c : m_changes) {
      const Flat_face_index f = c.entry / 3;
      const Face_units after = m_rules.units_of_face(f);
      Face_units shift;
      for(std::size_t i = 0; i < 3; ++i)
        shift[i] = difference(after[i], c.before[i]);
      const std::int64_t a = determinant(c.before), d = determinant(after);
      const std::int64_t square = determinant(shift);
      const std::int64_t slope = d - a - square; // of a + slope t + square t^2 at t = 0
      if(!m_rules.is_no_worse(f, a, d) ||
         (a > 0 && square > 0 && slope < 0 && -slope < 2 * square &&
          checked_product(slope, slope) >= checked_product(4 * square, a)))
        return false;
    }
    return true;
  }

  // The cheapest move that raises the determinant of a triangle. Most are cheap, and found soon.
  bool raise(const Flat_face_index face)
  {
    m_rules.face_to_raise = face;
    Strip_state best = no_strip_state;
    double least = 0;
    for(const double bound : {2., dearest_repair})
      if(best == no_strip_state) {
        least = bound;
        best = cheapest_raise(face, least);
      }
    const bool is_found = best != no_strip_state &&
                          move(best, dearest_repair, std::numeric_limits<double>::infinity());
    m_rules.face_to_raise = no_index;
    return is_found;
  }

  // Lowers `least` to its cost.
  Strip_state cheapest_raise(const Flat_face_index face, double& least)
  {
    Strip_state best = no_strip_state;
    for(Corner_index h = 3 * face; h < 3 * face + 3; ++h)
      for(int k = 0; k < 4; ++k) {
        const Strip_state s = strip_state(h, k);
        if(!m_rules.is_allowed(s) || !m_finder.find(s, least))
          continue;
        best = s;
        least = m_finder.length();
      }
    return best;
  }

  // The change of a face that the strip enters and leaves.
  struct Change
  {
    Strip_state exit;
    Corner_index entry;
    Face_units before; // at the last update
  };

  Intrinsic_complex& m_complex;
  Strip_rules m_rules;
  Strip_finder m_finder;
  Work& m_work;
  std::size_t m_number_of_changes = 0; // that were tried
  bool m_is_strip_found = false; // for the last move, made or not
  std::vector<Change> m_changes; // of the strip
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_MOVES_H
