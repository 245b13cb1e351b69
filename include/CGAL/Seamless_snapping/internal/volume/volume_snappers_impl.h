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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_rounder.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_untangler.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/volume_snappers.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Snapping of volumes where it may change cells away from cuts and boundary, too: to integer-grid
// maps, and with repairs of cells that are not positive. An exactly seamless map comes first.

class Whole_volume_snapper
{
public:
  // \param volume holds all cells, none of whose vertices is fixed
  Whole_volume_snapper(const Flat_volume& volume, const Volume_options& options,
                       const Number_format& format, Snapping_report& report, Step_timer& timer)
    : m_volume(volume), m_number_of_feature_edges(volume.aligned_edges.size()),
      m_options(options), m_format(format), m_report(report), m_timer(timer)
  { }

  // As `Flat_volume_snapper::run()`.
  std::optional<Refusal> run(std::vector<Uvw>& snapped)
  {
    if(!(m_options.grid_scale > 0 && std::isfinite(m_options.grid_scale)))
      return Refusal(Outcome::INVALID_ARGUMENT, term("grid_scale") +
                     " must be positive and finite");
    if(const auto refusal = scale())
      return refusal;
    const std::vector<Uvw> input = m_volume.coordinates;
    if(const auto refusal = Flat_volume_snapper(m_volume, m_options.tolerance, m_format, m_report,
                                                m_timer).run(snapped))
      return refusal;
    if(m_report.status == Outcome::SNAPPED)
      m_volume.coordinates.swap(snapped);
    m_report.lost_faces.clear();
    if(m_options.rounds || m_options.flip_repair != Flip_repair::NONE)
      if(const auto refusal = round_and_repair(input))
        return refusal;
    compare_with(input);
    snapped = m_volume.coordinates;
    if(m_options.rounds)
      return refusal_of_collapse();
    return std::nullopt;
  }

private:
  // Numbers of the format, and none that can't be used afterwards.
  std::optional<Refusal> scale()
  {
    if(m_options.grid_scale == 1)
      return std::nullopt;
    const double largest = (std::min)(1e300, std::ldexp(1., m_format.maximum_exponent - 2));
    const double least = std::ldexp(1., 2 * m_format.digits - m_format.maximum_exponent);
    if(m_volume.extent > 0 && !(m_volume.extent * m_options.grid_scale > least))
      return Refusal(Outcome::NOT_REPRESENTABLE,
                     term("grid_scale") + " makes the coordinates too small for the number type" +
                       remedy("choose a larger one"));
    for(std::size_t i = 0; i < m_volume.coordinates.size(); ++i)
      for(double& x : m_volume.coordinates[i]) {
        x = rounded_to(m_format, x * m_options.grid_scale);
        if(!(std::abs(x) <= largest))
          return Refusal(Outcome::NOT_REPRESENTABLE,
                         term("grid_scale") + " makes a coordinate of " +
                           name_of_element("cell", i / 4) + " too large for the number type" +
                           remedy("choose a smaller one"));
      }
    m_volume.extent *= m_options.grid_scale;
    return std::nullopt;
  }

  std::optional<Refusal> round_and_repair(const std::vector<Uvw>& input)
  {
    if(m_options.rounds)
      if(const auto refusal = add_grid_edges(m_volume))
        return refusal;
    const Volume_constraints constraints = read_constraints(m_volume);
    const Volume_structure structure(Sector_builder(m_volume, constraints).build(),
                                     Volume_charts(m_volume.number_of_cells()));
    std::vector<Uvw> u = m_volume.coordinates;
    if(m_options.rounds)
      if(const auto refusal =
           Volume_rounder(m_volume, constraints, structure,
                          m_options.tolerance * m_volume.extent, m_options.rounding_tolerance,
                          m_format, m_report, m_timer).run(u))
        return refusal;
    if(const auto refusal = repair(constraints, structure, input, u))
      return refusal;
    look_for_levels(structure, u);
    m_volume.coordinates.swap(u);
    return std::nullopt;
  }

  // After roundings, near by at least: their displacement may have made flips.
  std::optional<Refusal> repair(const Volume_constraints& constraints,
                                const Volume_structure& structure, const std::vector<Uvw>& input,
                                std::vector<Uvw>& u)
  {
    constexpr std::size_t reach_near_by = 2;
    Volume_untangler untangler(structure.members, m_volume, input, m_format, u);
    std::size_t& passes = m_report.run.number_of_untangling_iterations;
    const std::size_t most_passes = m_options.number_of_untangling_iterations;
    passes = untangler.run({Cells_to_untangle::ALL, most_passes, reach_near_by});
    if(m_options.flip_repair == Flip_repair::UNTANGLE)
      passes += untangler.run({Cells_to_untangle::ALL_BY_ALL_MEANS, most_passes - passes,
                               (std::numeric_limits<std::size_t>::max)()});
    m_timer.finish("orientation");
    if(m_options.rounds ? !is_on_integers(m_volume, constraints, u)
                        : !is_exact(m_volume, constraints, u))
      return Refusal(Outcome::INTERNAL_ERROR,
                     "the repaired map failed its exact verification and was discarded; please "
                     "report this");
    fill_in_changes(structure.sectors, input, u, m_report);
    m_timer.finish("verification");
    return std::nullopt;
  }

  // Roundings may take levels to one integer, so that what is between is flat, and of which
  // transition its facets are can't be told.
  std::optional<Refusal> refusal_of_collapse()
  {
    m_volume.aligned_edges.resize(m_number_of_feature_edges);
    const std::vector<std::size_t> &lost = m_report.lost_faces, &flips = m_report.remaining_flips;
    const bool are_most = 2 * lost.size() >= m_volume.number_of_cells();
    if(!are_most && measure_integer_grid(m_volume))
      return std::nullopt;
    const auto example = [](const std::vector<std::size_t>& cells)
      { return ", such as " + name_of_element("cell", cells.front()); };
    Message message = are_most ? "at the nearest integers, most cells lose their orientation"
                                   : "at the nearest integers, the coordinates no longer "
                                     "determine the grid";
    if(!lost.empty())
      message += ": " + counted(lost.size(), "cell") +
                 (lost.size() == 1 ? " loses its orientation" : " lose their orientation") +
                 example(lost);
    if(!flips.empty())
      message += (lost.empty() ? ": " : ", and ") + counted(flips.size(), "cell") +
                 (flips.size() == 1 ? " was" : " were") + " flipped or degenerate before" +
                 example(flips);
    return Refusal(Outcome::NOT_INTEGER,
                   message + (lost.empty() && !flips.empty()
                                ? remedy("repair these first, by Flip_repair::UNTANGLE without "
                                         "integer_grid") + ", or " + term(scale_up)
                                : remedy(scale_up) + ", because no repair brings these back"));
  }

  // Cells all of whose vertices lie in one plane that a level fixes each, whatever the coordinates
  // are; and those with levels that differ, and become one.
  // \param after coordinates that are rounded and repaired
  void look_for_levels(const Volume_structure& structure, const std::vector<Uvw>& after)
  {
    const std::vector<Uvw>& before = m_volume.coordinates;
    std::vector<char> is_level(3 * structure.sectors.number_of_sectors(), 0);
    for(const Sector_level& l : structure.sectors.levels)
      is_level[3 * std::size_t(l.sector) + std::size_t(l.coordinate)] = 1;
    m_has_joined_levels.assign(m_volume.number_of_cells(), 0);
    for(std::size_t c = 0; c < m_volume.number_of_cells(); ++c) {
      bool is_flat = false;
      for(std::size_t k = 0; k < 3; ++k) {
        std::vector<std::size_t> corners; // on levels
        for(std::size_t i = 4 * c; i < 4 * c + 4; ++i)
          if(is_level[3 * std::size_t(structure.sectors.sector[i]) + k] != 0)
            corners.push_back(i);
        std::size_t number = 0; // with the level of the first
        for(const std::size_t i : corners) {
          number += std::size_t(before[i][k] == before[corners[0]][k]);
          for(const std::size_t j : corners)
            if(before[i][k] != before[j][k] && after[i][k] == after[j][k])
              m_has_joined_levels[c] = 1;
        }
        is_flat = is_flat || number == 4;
      }
      m_report.run.number_of_faces_without_area += std::size_t(is_flat);
    }
  }

  // All that came between does not count.
  void compare_with(const std::vector<Uvw>& input)
  {
    m_report.run.number_of_repaired_flips = 0;
    const std::vector<Uvw>& u = m_volume.coordinates;
    for(std::size_t c = 0; c < m_volume.number_of_cells(); ++c) {
      const bool was_good = orientation(uvw_of_cell(input, c)) == CGAL::POSITIVE,
                 is_good = orientation(uvw_of_cell(u, c)) == CGAL::POSITIVE;
      if(!is_good)
        (was_good ? m_report.lost_faces : m_report.remaining_flips).push_back(c);
      m_report.run.number_of_repaired_flips += std::size_t(is_good && !was_good);
    }
    m_report.status = m_options.grid_scale == 1 && u == input ? Outcome::ALREADY_EXACT
                                                              : Outcome::SNAPPED;
    if(!has_to_be_positive())
      m_report.remaining_flips.clear();
    if(m_report.lost_faces.size() + m_report.remaining_flips.size() > 0)
      tell_of_cells();
  }

  // Repairs ask for positive cells, and so do hexahedra.
  bool has_to_be_positive() const
  { return m_options.rounds || m_options.flip_repair != Flip_repair::NONE; }

  // In the status, too, where cells are to be positive.
  void tell_of_cells()
  {
    const std::size_t lost = m_report.lost_faces.size(), flips = m_report.remaining_flips.size();
    if(has_to_be_positive())
      m_report.status = Outcome::FLIPS_REMAIN;
    const auto names = [](const std::vector<std::size_t>& cells) {
      return std::to_string(cells.size()) + " (the first is " +
             name_of_element("cell", cells.front()) + ")";
    };
    if(flips > 0)
      m_report.message = "cells that are still flipped or degenerate: " +
                         names(m_report.remaining_flips);
    if(lost > 0)
      m_report.message += (flips > 0 ? "; " : "") + std::string("cells that had the orientation of "
                          "most cells and lost it: ") + names(m_report.lost_faces);
    std::vector<std::size_t> joined;
    for(const auto& cells : {m_report.lost_faces, m_report.remaining_flips})
      std::copy_if(cells.begin(), cells.end(), std::back_inserter(joined), [&](const std::size_t c)
                   { return !m_has_joined_levels.empty() && m_has_joined_levels[c] != 0; });
    const std::size_t n = m_report.run.number_of_faces_without_area;
    if(!joined.empty())
      m_report.message += "; of these, cells between alignments that were rounded to the same "
                          "integer: " + names(joined) + remedy(scale_up);
    if(n > 0)
      m_report.message += "; alignments leave " + counted(n, "cell") + " no volume, whatever "
                          "the coordinates are: align less, or divide them";
    if(n > 0 || !joined.empty())
      return;
    if(m_report.run.number_of_untangling_iterations ==
            m_options.number_of_untangling_iterations)
      m_report.message +=
        remedy("the search for repairs ended at number_of_untangling_iterations: raise it");
    else if(m_options.flip_repair != Flip_repair::UNTANGLE)
      m_report.message += remedy("Flip_repair::UNTANGLE changes more of the map");
  }

  Flat_volume m_volume; // becomes the result
  std::vector<char> m_has_joined_levels; // per cell, once there are roundings or repairs
  std::size_t m_number_of_feature_edges;
  const Volume_options& m_options;
  Number_format m_format;
  Snapping_report& m_report;
  Step_timer& m_timer;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<Refusal> snap_flat_volume(const Flat_volume& volume, const Volume_options& options,
                                        const Number_format& format, Snapping_report& report,
                                        Step_timer& timer, std::vector<Uvw>& snapped)
{
  return options.is_about_all_cells()
           ? Whole_volume_snapper(volume, options, format, report, timer).run(snapped)
           : Flat_volume_snapper(volume, options.tolerance, format, report, timer).run(snapped);
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Volume_integer_grid_measure measure_integer_grid(const Flat_volume& volume)
{
  Volume_integer_grid_measure result;
  const Volume_constraints constraints = read_constraints(volume);
  result.is_exactly_seamless = is_exact(volume, constraints, volume.coordinates);
  measure_distances(volume, constraints, volume.coordinates, result);
  measure_singular_edges(volume, constraints.transitions, result);
  measure_orientations(volume, result);
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SNAPPERS_IMPL_H
