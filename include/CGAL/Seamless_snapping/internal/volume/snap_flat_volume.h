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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_FLAT_VOLUME_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_FLAT_VOLUME_H

#include <CGAL/license/Seamless_snapping.h>

// The function `snap_volume_to_seamless()` for a volume in plain arrays, a step a line.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/volume/Chart_joiner.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_untangler.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A larger change than so many times the violation, or this part of the tolerance, is none of
// noise: some rotation, cut, or alignment was misread.
constexpr double largest_change_in_violations = 10;
constexpr double least_noise_in_tolerances = 0.01;

// Changes of coordinates, where each sector counts once.
inline void fill_in_changes(const Volume_sectors& sectors, const std::vector<Uvw>& before,
                            const std::vector<Uvw>& after, Snapping_report& report)
{
  Magnitudes changes;
  for(std::size_t s = 0; s < sectors.corners.size(); ++s)
    for(const Corner_index i : sectors.corners[s])
      for(std::size_t c = 0; c < 3; ++c)
        changes.add(after[std::size_t(i)][c] - before[std::size_t(i)][c],
                    1. / static_cast<double>(sectors.corners[s].size()));
  report.largest_change = changes.largest();
  report.mean_change = changes.mean();
  report.rms_change = changes.root_mean_square();
}

class Flat_volume_snapper
{
public:
  // \param tolerance relative to the extent
  Flat_volume_snapper(const Flat_volume& volume, const double tolerance,
                      const Number_format& format, Snapping_report& report, Step_timer& timer)
    : m_volume(volume), m_tolerance(tolerance * volume.extent), m_format(format),
      m_report(report), m_timer(timer)
  { }

  // Fills in the coordinates of all corners, and the report but for its status, which is
  // `ALREADY_EXACT` before. Returns why there are none, if so.
  std::optional<Refusal> run(std::vector<Uvw>& snapped)
  {
    Volume_constraints constraints{Facet_transition_reader(m_volume).read(), {}};
    const Volume_transitions& transitions = constraints.transitions;
    fill_in(transitions);
    m_timer.finish("transitions");
    if(transitions.violation > m_tolerance)
      return not_seamless(transitions);
    const Volume_alignment& alignment = constraints.alignment =
      Facet_alignment_reader(m_volume, transitions).read();
    m_report.violation_before = (std::max)(transitions.violation, alignment.violation);
    m_timer.finish("alignment");
    if(alignment.violation > m_tolerance)
      return not_aligned(alignment);
    std::vector<char> is_inexact = inexact_coordinates(constraints);
    if(is_inexact.empty())
      return std::nullopt;
    m_timer.finish("verification of the input");

    Joined_charts joined{Volume_charts(m_volume.number_of_cells()), {}};
    const bool is_joined = Chart_joiner(m_volume, constraints).run(joined);
    m_timer.finish("charts");
    Volume_sectors sectors =
      Sector_builder(m_volume, is_joined ? joined.constraints : constraints).build();
    m_timer.finish("sectors");
    if(is_joined)
      Chart_fitter(m_volume, sectors, joined.charts).run(m_report.violation_before, m_format);
    m_timer.finish("fitting of charts");
    const Volume_structure structure(std::move(sectors), std::move(joined.charts));
    fill_in(structure);
    m_timer.finish("places");
    is_inexact = inexact_columns(is_inexact, structure);
    if(is_joined)
      spread_over_joined_charts(structure, is_inexact);
    Place_solver solver(m_volume, structure, is_inexact, m_format);
    m_report.linear_solver = solver.linear_solver().figures();
    m_report.grid_step = solver.coarsest_step();
    m_timer.finish("elimination");
    if(!solver.solve(snapped))
      return Refusal(Outcome::NOT_REPRESENTABLE,
                     "the coordinates are so large that the number type holds no solution near by" +
                     remedy("scale the map down"));
    m_timer.finish("solution");

    const Largest_change change = repair(constraints, snapped);
    m_timer.finish("orientation");
    if(change.size > largest_plausible_change())
      return collapsed(change);
    if(!is_exact(m_volume, constraints, snapped))
      return Refusal(Outcome::INTERNAL_ERROR,
                     "the result failed its exact verification and was discarded; please report "
                     "this");
    fill_in_changes(structure.sectors, m_volume.coordinates, snapped, m_report);
    m_timer.finish("verification");
    m_report.status = Outcome::SNAPPED;
    return std::nullopt;
  }

private:
  struct Largest_change // largest change of a coordinate
  {
    double size = 0;
    std::size_t corner = 0;
  };

  void fill_in(const Volume_transitions& transitions)
  {
    m_report.violation_before = transitions.violation;
    m_report.run.number_of_cut_edges = transitions.number_of_cuts;
    m_report.run.number_of_merged_edges = m_volume.open_facets.size() - transitions.number_of_cuts;
    m_report.run.number_of_edges_decided_by_surroundings =
      transitions.number_decided_by_surroundings;
  }

  void fill_in(const Volume_structure& structure)
  {
    m_report.run.number_of_sectors = structure.sectors.number_of_sectors();
    m_report.run.number_of_nodes = structure.places.places.size();
    m_report.run.number_of_cut_branches = structure.sectors.sheet_element.size();
    m_report.run.number_of_align_branches = structure.sectors.number_of_levels;
  }

  Refusal not_seamless(const Volume_transitions& transitions) const
  {
    return {Outcome::NOT_SEAMLESS,
            "at " + m_volume.name_of_facet(transitions.worst) + " the two sides differ by " +
              short_number(transitions.violation) + ", more than the tolerance allows (" +
              short_number(m_tolerance) + "), from any of the 24 rotations" +
              remedy("correct the map there, or ") + term(raise_tolerance), {}};
  }

  Refusal not_aligned(const Volume_alignment& alignment) const
  {
    return {Outcome::NOT_ALIGNED,
            alignment.worst + " is " + short_number(alignment.violation) +
              " off a plane or line of constant coordinates, more than the tolerance allows (" +
              short_number(m_tolerance) + ")" +
              remedy("correct the map there, or ") + term(raise_tolerance) +
              term(", or, for facets of the boundary, pass align_boundary(false)"), {}};
  }

  // Cells that the closest exact solution turns over, or makes degenerate, get their orientation
  // back if moves of their vertices help, as near by as possible.
  Largest_change repair(const Volume_constraints& constraints, std::vector<Uvw>& snapped)
  {
    constexpr std::size_t largest_number_of_passes = 100, reach = 1;
    std::vector<std::size_t> lost = lost_cells(m_volume.coordinates, snapped);
    m_report.run.number_of_lost_faces = lost.size();
    Largest_change change = largest_change(snapped);
    m_report.run.largest_change_before_repair = change.size;
    if(lost.empty())
      return change;
    // in the charts of the input, where all members have coordinates of their own
    const Volume_structure structure(Sector_builder(m_volume, constraints).build(),
                                     Volume_charts(m_volume.number_of_cells()));
    Volume_untangler untangler(structure.members, m_volume, m_volume.coordinates, m_format,
                               snapped);
    for(const double largest : {change.size, usual_change(), largest_plausible_change()}) {
      if(lost.empty())
        break;
      untangler.run({Cells_to_untangle::LOST, largest_number_of_passes, reach, largest});
      lost = lost_cells(m_volume.coordinates, snapped);
    }
    m_report.run.number_of_faces_repaired_by_moves =
      m_report.run.number_of_lost_faces - lost.size();
    for(const std::size_t c : lost)
      m_report.lost_faces.push_back(std::size_t(m_volume.cell_names[c]));
    return largest_change(snapped);
  }

  Largest_change largest_change(const std::vector<Uvw>& snapped) const
  {
    Largest_change result;
    for(std::size_t i = 0; i < snapped.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c) {
        const double change = std::abs(snapped[i][c] - m_volume.coordinates[i][c]);
        if(change > result.size)
          result = {change, i};
      }
    return result;
  }

  // A change that snapping without moves has never exceeded.
  double usual_change() const
  {
    return (std::min)(2 * m_report.violation_before + 8 * m_report.grid_step,
                      largest_plausible_change());
  }

  double largest_plausible_change() const
  {
    return largest_change_in_violations *
           (std::max)(m_report.violation_before, least_noise_in_tolerances * m_tolerance);
  }

  // A wrong rotation can make an exact map in which a part of the volume has collapsed.
  Refusal collapsed(const Largest_change& change) const
  {
    const std::size_t v = std::size_t(m_volume.vertices[change.corner]);
    return {Outcome::NOT_SEAMLESS,
            "an exact map would have to move " +
              name_of_vertex(std::size_t(m_volume.vertex_names[v])) +
              " by " + short_number(change.size) + ", which is more than the inaccuracy of " +
              short_number(m_report.violation_before) + " explains: the transitions around it do "
              "not fit together, or the cells there are thinner than the inaccuracy" +
              remedy("correct the map there, or ") + term(raise_tolerance)};
  }

  // Per coordinate of a corner, whether a constraint on it does not hold; empty if all hold.
  std::vector<char> inexact_coordinates(const Volume_constraints& constraints) const
  {
    std::vector<char> result;
    for_each_inexact_coordinate(m_volume, constraints, m_volume.coordinates,
                                [&](const Corner_index corner, const std::size_t c) {
      result.resize(3 * m_volume.vertices.size());
      result[3 * std::size_t(corner) + c] = 1;
    });
    return result;
  }

  // Whether a column is inexact, per coordinate of a slot.
  static std::vector<char> inexact_columns(const std::vector<char>& is_inexact,
                                           const Volume_structure& structure)
  {
    std::vector<char> result(3 * structure.places.number_of_slots, 0);
    for(std::size_t j = 0; j < is_inexact.size(); ++j)
      if(is_inexact[j] != 0)
        result[structure.members.column(Corner_index(j / 3),
                                        structure.charts.column(j / 3, j % 3))] = 1;
    return result;
  }

  // If charts have moved relative to each other, all of their coordinates are on a grid.
  static void spread_over_joined_charts(const Volume_structure& structure,
                                        std::vector<char>& is_inexact)
  {
    std::vector<char> is_root_inexact(structure.charts.roots.size(), 0);
    for(int pass = 0; pass < 2; ++pass) // the last sector may be the first that is inexact
      for(std::size_t s = 0; s < structure.sectors.corners.size(); ++s) {
        const Corner_index corner = structure.sectors.corners[s].front();
        char& of_root = is_root_inexact[structure.charts.root(corner)];
        for(std::size_t c = 0; c < 3; ++c) {
          char& of_column = is_inexact[structure.members.column(corner, c)];
          if(of_column != 0)
            of_root = 1;
          of_column = of_root;
        }
      }
  }

  const Flat_volume& m_volume;
  double m_tolerance; // absolute
  Number_format m_format;
  Snapping_report& m_report;
  Step_timer& m_timer;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_FLAT_VOLUME_H
