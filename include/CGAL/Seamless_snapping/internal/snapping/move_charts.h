// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_MOVE_CHARTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_MOVE_CHARTS_H

#include <CGAL/license/Seamless_snapping.h>

// The place of a chart has no meaning, because moving it changes no edge vector. So this moves
// charts to places at which rounding to integers changes less. The translations across a tree of
// cuts become integers. For each connected part, there remains one vector for all its charts,
// turned with them. It brings one of the cones and levels to an integer, the one that is best for
// the others. So a map that is an integer-grid map up to such moves needs no rounding at all.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
class Chart_mover
{
  using Element = typename Group::Element;
  using Vector = typename Cut_complex<Group>::Vector;
  using Cuts = Surface_cuts<Group, Corner_index>;
  static constexpr std::size_t dimension = Group::dimension;

public:
  Chart_mover(Flat_surface& surface, const Transition_data<Corner_index>& transitions,
              const Cuts& cuts)
    : m_surface(surface), m_cuts(cuts)
  {
    number_charts(transitions);
    link_charts(transitions);
  }

  // Returns whether charts were moved: not if none has to be by more than a negligible distance.
  bool run(const double negligible)
  {
    for(std::size_t c = 0; c < m_charts.size(); ++c)
      if(!m_charts[c].is_placed)
        place_part(c);
    collect_values();
    for(Part& part : m_parts)
      choose_shift(part);
    double largest = 0;
    for(Chart& chart : m_charts) {
      add_shift(chart);
      largest = (std::max)(largest, Group::norm(chart.move));
    }
    if(largest <= negligible)
      return false;
    move();
    return true;
  }

private:
  struct Chart
  {
    std::size_t part = 0;
    Element element = Group::identity(); // how the part's first chart is turned to this one
    Vector move{};
    bool is_placed = false;
  };

  // u(chart) = element u(here) + translation
  struct Link
  {
    std::size_t chart;
    Element element;
    Vector translation;
  };

  struct Part
  {
    std::array<std::vector<double>, dimension> values; // that are to be integers
    Vector shift{};
  };

  void number_charts(const Transition_data<Corner_index>& transitions)
  {
    std::vector<char> is_cut(std::size_t(m_surface.number_of_corners()), false);
    for(std::size_t i = 0; i < transitions.number_of_cuts; ++i)
      for(const Corner_index h : {transitions.edges[i].halfedge,
                                  m_surface.opposite(transitions.edges[i].halfedge)})
        is_cut[std::size_t(h)] = true;
    m_chart_of_face = connected_parts(m_surface.number_of_faces(), [&](const Corner_index h) {
      const Corner_index g = m_surface.opposite(h);
      return m_surface.is_border(g) || is_cut[std::size_t(h)] ? no_index : g;
    });
    for(const std::int32_t chart : m_chart_of_face)
      m_charts.resize((std::max)(m_charts.size(), std::size_t(chart) + 1));
  }

  void link_charts(const Transition_data<Corner_index>& transitions)
  {
    m_links.resize(m_charts.size());
    for(std::size_t i = 0; i < transitions.number_of_cuts; ++i) {
      const Corner_index h = transitions.edges[i].halfedge, o = m_surface.opposite(h);
      const Element g = transitions.edges[i].rotation, back = Group::inverse(g);
      const std::size_t here = chart(h), there = chart(o);
      if(here == there || (!m_links[here].empty() && m_links[here].back().chart == there))
        continue;
      const Vector turned = Group::apply(g, Vector(m_surface.uv(h)));
      const Uv u = m_surface.uv(m_surface.prev(o));
      const Vector t{u[0] - turned[0], u[1] - turned[1]}, s = Group::apply(back, t);
      m_links[here].push_back({there, g, t});
      m_links[there].push_back({here, back, {-s[0], -s[1]}});
    }
  }

  std::size_t chart(const Corner_index h) const
  { return std::size_t(m_chart_of_face[std::size_t(h / 3)]); }

  // All charts around, so that the translations on the way to them become integers.
  void place_part(const std::size_t root)
  {
    m_charts[root].is_placed = true;
    m_charts[root].part = m_parts.size();
    std::vector<std::size_t> placed(1, root);
    for(std::size_t i = 0; i < placed.size(); ++i)
      for(const Link& link : m_links[placed[i]]) {
        const Chart& here = m_charts[placed[i]];
        Chart& there = m_charts[link.chart];
        if(there.is_placed)
          continue;
        const Vector moved = Group::apply(link.element, here.move);
        there = {m_parts.size(), Group::compose(link.element, here.element), {}, true};
        for(std::size_t c = 0; c < dimension; ++c)
          there.move[c] = to_nearest_integer(link.translation[c] - moved[c]);
        placed.push_back(link.chart);
      }
    m_parts.emplace_back();
  }

  static double to_nearest_integer(const double x) { return std::round(x) - x; }

  // Cones and levels as the first chart of their part sees them, up to integers.
  void collect_values()
  {
    const Cut_complex<Group>& complex = m_cuts.complex;
    for(const Sector_index s : m_cuts.grid_points)
      for(int c = 0; c < int(dimension); ++c)
        add_value(s, c);
    for(std::size_t i = 0; i < complex.number_of_chains(); ++i)
      add_value(complex.links[i].front(), complex.functional[i]);
  }

  void add_value(const Sector_index s, const int functional)
  {
    const Chart& chart = m_charts[this->chart(m_cuts.corners[s].front())];
    const Vector& u = m_cuts.complex.coordinates[std::size_t(s)];
    const Signed_functional f = Group::act(Group::inverse(chart.element), functional);
    if(f.index < int(dimension)) // the sum of both follows
      m_parts[chart.part].values[std::size_t(f.index)].push_back(
        f.sign * Group::value(functional, Vector{u[0] + chart.move[0], u[1] + chart.move[1]}));
  }

  // None, or that of one of the first values to its integer; whatever leaves least to be rounded.
  static void choose_shift(Part& part)
  {
    constexpr std::size_t most_candidates = 64;
    for(std::size_t c = 0; c < dimension; ++c) {
      const std::vector<double>& values = part.values[c];
      const auto rest = [&](const double shift) {
        double squares = 0;
        for(const double x : values)
          squares += std::pow(to_nearest_integer(x + shift), 2);
        return squares;
      };
      double least = rest(0);
      for(std::size_t i = 0; i < (std::min)(values.size(), most_candidates); ++i) {
        const double shift = to_nearest_integer(values[i]), squares = rest(shift);
        if(squares < 0.99 * least) {
          least = squares;
          part.shift[c] = shift;
        }
      }
    }
  }

  void add_shift(Chart& chart) const
  {
    const Vector shift = Group::apply(chart.element, m_parts[chart.part].shift);
    for(std::size_t c = 0; c < dimension; ++c)
      chart.move[c] = -to_nearest_integer(chart.move[c] + shift[c]);
  }

  void move()
  {
    for(Corner_index h = 0; h < m_surface.number_of_corners(); ++h) {
      const Vector& move = m_charts[chart(h)].move;
      const Uv u = m_surface.uv(h);
      m_surface.set_uv(h, {u[0] + move[0], u[1] + move[1]});
    }
  }

  Flat_surface& m_surface;
  const Cuts& m_cuts;
  std::vector<std::int32_t> m_chart_of_face;
  std::vector<Chart> m_charts;
  std::vector<std::vector<Link> > m_links; // per chart
  std::vector<Part> m_parts;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_MOVE_CHARTS_H
