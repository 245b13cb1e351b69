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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ROUNDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ROUNDER_H

#include <CGAL/license/Seamless_snapping.h>

// From an exactly seamless map of a volume to an integer-grid map near by: translations, levels of
// aligned facets, and singular curves become integers, and the change is spread over the volume.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/volume/Rounding_displacement.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The place of a chart has no meaning: charts move to places at which translations and levels are
// nearer to integers.

// Charts are classes of cells between which no cut runs. From one to the next, the first cut gets
// an integer translation; then all charts of a component of the mesh are moved by one vector, which
// takes the levels of aligned facets and edges as near to integers as their mean allows.
class Volume_chart_mover
{
  using Group = Cube_rotations;

public:
  Volume_chart_mover(const Flat_volume& volume, const Volume_constraints& constraints,
                     const Volume_members& members)
    : m_volume(volume), m_alignment(constraints.alignment), m_members(members),
      m_element(elements_of_facets(volume, constraints.transitions, true, -1)),
      m_chart_of_cell(volume.number_of_cells(), -1)
  { }

  // The coordinates of all corners, moved.
  std::vector<Uvw> run()
  {
    for(std::size_t c = 0; c < m_chart_of_cell.size(); ++c)
      if(m_chart_of_cell[c] < 0)
        reach_component(c);
    set_origins();
    const std::vector<Uvw> common = common_shifts();
    std::vector<Uvw> result = m_volume.coordinates;
    for(std::size_t i = 0; i < result.size(); ++i) {
      const Chart& chart = this->chart(i);
      const Uvw by = Group::apply(chart.rotation, common[chart.component]);
      for(std::size_t c = 0; c < 3; ++c)
        result[i][c] += chart.shift[c] + by[c];
    }
    return result;
  }

  // The charts that were moved, joined with their neighbors.
  const Chart_ties& ties() const { return m_ties; }

private:
  struct Chart
  {
    int rotation; // from the first chart of its component
    Uvw shift;
    Uvw origin; // the origin of the first chart, in the moved chart
    std::size_t component;
  };

  const Chart& chart(const std::size_t corner) const
  { return m_charts[std::size_t(m_chart_of_cell[corner / 4])]; }

  // Cells of a chart before cells beyond its cuts, so that they get the same shift.
  void reach_component(const std::size_t root)
  {
    std::vector<Corner_index> cuts; // reached, as the cell on this side sees them
    reach_chart(root, {Group::identity(), {}, {}, m_number_of_components}, cuts);
    for(std::size_t i = 0; i < cuts.size(); ++i) {
      const Corner_index facet = cuts[i], there = m_volume.opposite[std::size_t(facet)];
      if(m_chart_of_cell[std::size_t(there / 4)] >= 0)
        continue;
      const int g = m_element[std::size_t(facet)];
      const Corner_index corner = corners_of_facet(facet)[0];
      const Chart& here = chart(std::size_t(facet));
      Chart next{Group::compose(g, here.rotation), {}, Group::apply(g, here.origin),
                 m_number_of_components};
      Uvw u = m_volume.uvw(corner);
      for(std::size_t c = 0; c < 3; ++c)
        u[c] += here.shift[c];
      u = Group::apply(g, u);
      for(std::size_t c = 0; c < 3; ++c) {
        const double t = m_volume.uvw(m_volume.across(facet, corner))[c] - u[c];
        next.shift[c] = std::round(t) - t;
        next.origin[c] += std::round(t);
      }
      add_ties(facet, g);
      reach_chart(std::size_t(there / 4), next, cuts);
    }
    ++m_number_of_components;
  }

  void add_ties(const Corner_index facet, const int g)
  {
    for(const Corner_index here : corners_of_facet(facet))
      for(std::size_t c = 0; c < 3; ++c)
        m_ties.ties.push_back({m_members.column(m_volume.across(facet, here), c),
                               m_members.column(here, Group::source(g, c)), Group::sign(g, c)});
  }

  void set_origins()
  {
    for(std::size_t i = 0; i < m_volume.vertices.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c) {
        const std::size_t j = m_members.column(Corner_index(i), c);
        m_ties.origin.resize((std::max)(m_ties.origin.size(), j + 1), 0);
        m_ties.origin[j] = std::int64_t(chart(i).origin[c]);
      }
  }

  void reach_chart(const std::size_t first, const Chart& chart, std::vector<Corner_index>& cuts)
  {
    const auto number = std::int32_t(m_charts.size());
    m_charts.push_back(chart);
    std::vector<std::size_t> cells(1, first);
    m_chart_of_cell[first] = number;
    for(std::size_t i = 0; i < cells.size(); ++i)
      for(std::size_t facet = 4 * cells[i]; facet < 4 * cells[i] + 4; ++facet) {
        const Corner_index other = m_volume.opposite[facet];
        if(other < 0)
          continue;
        if(m_element[facet] >= 0) {
          cuts.push_back(Corner_index(facet));
        } else if(std::int32_t& n = m_chart_of_cell[std::size_t(other / 4)]; n < 0) {
          n = number;
          cells.push_back(std::size_t(other / 4));
        }
      }
  }

  // Per component, in the chart of its first cell.
  std::vector<Uvw> common_shifts() const
  {
    constexpr double turn = 2 * 3.14159265358979323846;
    using Phase = std::complex<double>;
    std::vector<std::array<Phase, 3> > sums(m_number_of_components);
    for_each_level(m_volume, m_alignment, [&](const auto& corners, const std::size_t c,
                                              const auto&) {
      const Chart& chart = this->chart(std::size_t(corners[0]));
      const double level = m_volume.uvw(corners[0])[c] + chart.shift[c];
      const int g = chart.rotation;
      sums[chart.component][Group::source(g, c)] +=
        std::polar(1., Group::sign(g, c) * turn * (level - std::round(level)));
    });
    std::vector<Uvw> result(m_number_of_components);
    for(std::size_t k = 0; k < result.size(); ++k)
      for(std::size_t c = 0; c < 3; ++c)
        result[k][c] = std::abs(sums[k][c]) > 0 ? -std::arg(sums[k][c]) / turn : 0.;
    return result;
  }

  const Flat_volume& m_volume;
  const Volume_alignment& m_alignment;
  const Volume_members& m_members;
  Chart_ties m_ties;
  std::vector<signed char> m_element; // per facet: to the other side; -1 where there is no cut
  std::vector<std::int32_t> m_chart_of_cell; // -1 while it is not reached
  std::vector<Chart> m_charts;
  std::size_t m_number_of_components = 0;
};

// Below, each vertex takes the nearest place, and charts stay where they are.
constexpr double negligible_volume_rounding = 1e-4;

// Adds the edges that an integer-grid map has on integer lines to the edges that are to be aligned.
// A refusal names what no integer grid fits.
inline std::optional<Refusal> add_grid_edges(Flat_volume& volume)
{
  const Volume_transitions transitions = Facet_transition_reader(volume).read();
  for(const Grid_edge& edge : Grid_edge_finder(volume, transitions).find()) {
    if(edge.is_skew)
      return Refusal(Outcome::NOT_INTEGER,
                     "cells are turned around the singular " + volume.name_of_edge(edge.edge) +
                       " about an axis that is none of the coordinates', so that no integer grid "
                       "fits" + remedy("correct the map there"));
    volume.aligned_edges.push_back(edge.edge);
  }
  return std::nullopt;
}

// \pre `add_grid_edges()` was called for the volume before its structure was read; it holds all
//      cells, none of whose vertices is fixed
class Volume_rounder
{
  using Group = Cube_rotations;

public:
  // \param tolerance of alignments, absolute
  Volume_rounder(const Flat_volume& volume, const Volume_constraints& constraints,
                 const Volume_structure& structure, const double tolerance,
                 const double rounding_tolerance, const Number_format& format,
                 Snapping_report& report, Step_timer& timer)
    : m_volume(volume), m_constraints(constraints), m_structure(structure),
      m_members(structure.members),
      m_tolerance(tolerance), m_rounding_tolerance(rounding_tolerance), m_format(format),
      m_report(report), m_timer(timer),
      m_integers(structure, format)
  { }

  // Moves the coordinates of all corners where they have to. Returns why that fails, if so.
  // \param rounded the rounded coordinates of the volume
  std::optional<Refusal> run(std::vector<Uvw>& rounded)
  {
    const Volume_alignment& alignment = m_constraints.alignment;
    if(alignment.violation > m_tolerance)
      return Refusal(Outcome::NOT_INTEGER,
                     alignment.worst + ", around which cells have 720 degrees or the boundary "
                     "turns back, is " + short_number(alignment.violation) + " off a line of "
                     "constant coordinates; correct the map there");
    if(const auto refusal = check_range())
      return refusal;
    if(is_on_integers(m_volume, m_constraints, m_volume.coordinates))
      return std::nullopt;
    m_report.linear_solver = m_integers.linear_solver().figures();
    std::vector<Uvw> u = m_volume.coordinates;
    const std::vector<Separation> separations =
      Separation_finder(m_volume, m_constraints.transitions, m_members).find();
    if(!m_integers.solve(u, separations, {}))
      return not_representable();
    auto worst = largest_rounding(u);
    Rounding_displacement displacement(m_structure, m_integers, u);
    const bool is_far = worst.first > negligible_volume_rounding;
    if(is_far) {
      const std::size_t joined = m_integers.number_of_joined();
      Volume_chart_mover mover(m_volume, m_constraints, m_members);
      std::vector<Uvw> moved = u;
      if(m_rounding_tolerance > 0)
        moved = mover.run();
      if(!m_integers.solve(moved, separations, mover.ties()))
        return not_representable();
      const auto worst_of_moved = largest_rounding(moved);
      Rounding_displacement of_moved(m_structure, m_integers, moved);
      const bool is_moved_near = worst_of_moved.first <= negligible_volume_rounding;
      if(!is_moved_near) {
        displacement.spread();
        of_moved.spread();
      }
      if(is_moved_near ||
         std::make_pair(m_integers.number_of_joined(), of_moved.energy()) <
           std::make_pair(joined, displacement.energy())) {
        displacement = std::move(of_moved);
        worst = worst_of_moved;
      } else {
        m_integers.solve(u, separations, {}); // as before
      }
    }
    m_timer.finish("rounding");
    m_report.largest_rounding = worst.first;
    if(worst.first > m_rounding_tolerance)
      return Refusal(Outcome::NOT_INTEGER,
                     worst.second + " must move by " + short_number(rounded_up(worst.first)) +
                       " to reach the integer that fits the others, but " +
                       internal::term("the rounding_tolerance is") + " " +
                       short_number(m_rounding_tolerance) +
                       remedy("raise rounding_tolerance to at least this distance, or scale the "
                              "map up by grid_scale"));
    if(!expand(displacement, is_far, rounded))
      return not_representable();
    if(!is_on_integers(m_volume, m_constraints, rounded))
      return Refusal(Outcome::INTERNAL_ERROR,
                     "the integer-grid map failed its exact verification and was discarded; please "
                     "report this");
    m_timer.finish("displacement");
    return std::nullopt;
  }

private:
  Refusal not_representable() const
  {
    return {Outcome::NOT_REPRESENTABLE,
            "the integers near by would be too large for the number type" +
              remedy("scale the map down"), {}};
  }

  // Seven bits for what is behind the point.
  std::optional<Refusal> check_range() const
  {
    const int bits = m_format.digits - 7;
    for(std::size_t i = 0; i < m_volume.coordinates.size(); ++i)
      for(const double x : m_volume.coordinates[i])
        if(std::abs(x) > std::ldexp(1., bits))
          return Refusal(Outcome::NOT_REPRESENTABLE,
                         "a coordinate at " +
                           name_of_vertex(std::size_t(m_volume.vertex_names[std::size_t(
                             m_volume.vertices[i])])) +
                           " is too large: beyond 2^" + std::to_string(bits) + ", where units "
                           "can't be counted safely" + remedy("move or shrink the map"));
    return std::nullopt;
  }

  // To three digits, so that the number that is told is far enough.
  static double rounded_up(const double x)
  {
    const double unit = std::pow(10., std::floor(std::log10(x)) - 2);
    return std::ceil(x / unit) * unit;
  }

  // The largest distance of a translation or a level from its integer, and the place.
  std::pair<double, Message> largest_rounding(const std::vector<Uvw>& u) const
  {
    std::pair<double, Message> result(0, {});
    const auto note = [&](const double x, const std::int64_t integer, const auto& name) {
      const double distance = std::abs(x - static_cast<double>(integer));
      if(distance > result.first)
        result = {distance, name()};
    };
    for(std::size_t i = 0; i < m_volume.open_facets.size(); ++i)
      if(m_constraints.transitions.is_cut[i] != 0)
        for(std::size_t c = 0; c < 3; ++c)
          note_translation(u, i, c, note);
    for_each_level(m_volume, m_constraints.alignment, [&](const auto& corners, const std::size_t c,
                                                          const auto& name) {
      note(u[std::size_t(corners[0])][c], m_integers(corners[0], c),
           [&] { return (corners.size() == 3 ? "the level of " : "") + name(); });
    });
    return result;
  }

  template <typename Note>
  void note_translation(const std::vector<Uvw>& u, const std::size_t i, const std::size_t c,
                        const Note& note) const
  {
    const Corner_index facet = m_volume.open_facets[i], here = corners_of_facet(facet)[0],
                       there = m_volume.across(facet, here);
    const int g = m_constraints.transitions.element[i];
    const std::size_t source = Group::source(g, c);
    const int sign = Group::sign(g, c);
    note(u[std::size_t(there)][c] - sign * u[std::size_t(here)][source],
         m_integers(there, c) - sign * m_integers(here, source), [&] {
           return "the translation across " + m_volume.name_of_facet(facet);
         });
  }

  // On one grid, which holds all coordinates. Vertices that no constraint concerns keep theirs,
  // unless these are spread.
  bool expand(const Rounding_displacement& displacement, const bool is_spread,
              std::vector<Uvw>& rounded) const
  {
    const auto move = [&](const Volume_members::Term& t)
    { return t.sign == 0 ? 0. : t.sign * displacement.moves()[t.unknown]; };
    double largest = 1;
    for(std::size_t i = 0; i < rounded.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c) {
        const double integer = static_cast<double>(m_integers(Corner_index(i), c));
        largest = (std::max)({largest, std::abs(integer),
                              std::abs(integer + move(m_members.term(Corner_index(i), c)))});
      }
    const Grid grid = Grid::finest(m_format, largest);
    if(grid.exponent() > 0)
      return false;
    m_report.grid_step = grid.step();
    const std::int64_t unit = std::int64_t(1) << -grid.exponent();
    for(std::size_t i = 0; i < rounded.size(); ++i) {
      if(!is_spread &&
         !m_members.place(m_members.member_of_corner(Corner_index(i))).is_constrained())
        continue;
      for(std::size_t c = 0; c < 3; ++c) {
        const Volume_members::Term t = m_members.term(Corner_index(i), c);
        std::int64_t x = unit * m_integers(Corner_index(i), c);
        if(t.sign != 0)
          x += t.sign * nearest_integer(grid.in_steps(displacement.moves()[t.unknown]));
        if(!grid.is_representable(x))
          return false;
        if(const double to = grid.value(x); rounded[i][c] != to) // zeros keep their signs
          rounded[i][c] = to;
      }
    }
    return true;
  }

  const Flat_volume& m_volume;
  const Volume_constraints& m_constraints;
  const Volume_structure& m_structure;
  const Volume_members& m_members;
  double m_tolerance, m_rounding_tolerance;
  Number_format m_format;
  Snapping_report& m_report;
  Step_timer& m_timer;
  Integer_places m_integers;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ROUNDER_H
