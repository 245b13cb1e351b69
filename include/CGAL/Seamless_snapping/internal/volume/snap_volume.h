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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_VOLUME_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_VOLUME_H

#include <CGAL/license/Seamless_snapping.h>

// The part of the functions on volumes that knows the caller's types: reads them, and writes.

#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/write_all_or_nothing.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_survey.h>
#include <CGAL/Seamless_snapping/internal/volume/volume_snappers.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

constexpr double default_volume_tolerance = 1e-4;

// \param range ranges of vertices, such as triples; none, where the parameter is not given
template <typename Range, std::size_t number>
std::optional<Refusal> read_elements(const Range& range, const char* const name,
                                     std::set<std::array<std::int64_t, number> >& elements)
{
  if constexpr(is_given<Range>)
    for(const auto& vertices : range) {
      std::array<std::int64_t, number> element;
      std::size_t size = 0;
      for(const auto v : vertices) {
        if(size < element.size())
          element[size] = static_cast<std::int64_t>(v);
        ++size;
      }
      if(size != element.size())
        return invalid_cells(std::string(name) + ": an element has " + std::to_string(size) +
                             " vertices in place of " + std::to_string(element.size()));
      std::sort(element.begin(), element.end());
      elements.insert(element);
    }
  return std::nullopt;
}

enum class Cells_to_read { AT_CONSTRAINTS, ALL };

// All that constraints concern, and some further vertices, but for coordinates. Returns what is
// wrong with the input, if so.
template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
std::optional<Refusal> read_volume(const TetrahedronRange& range, const CornerUVWMap& uvw_map,
                                   const NamedParameters& np, Tetrahedra& tetrahedra,
                                   Flat_volume& volume,
                                   std::vector<std::int64_t> further_vertices = {},
                                   const Cells_to_read cells = Cells_to_read::AT_CONSTRAINTS)
{
  using CGAL::parameters::get_parameter_reference;
  if(auto refusal = read_vertices(range, tetrahedra))
    return refusal;
  const auto& neighbors = get_parameter_reference(np, CGAL::internal_np::cell_neighbors);
  std::optional<Refusal> refusal;
  if constexpr(is_given<decltype(neighbors)>)
    refusal = read_neighbors(neighbors, tetrahedra);
  else
    refusal = find_neighbors(tetrahedra);
  Volume_features features;
  if(!refusal)
    refusal = read_elements(get_parameter_reference(np, CGAL::internal_np::feature_facets),
                            "feature_facets", features.facets);
  if(!refusal)
    refusal = read_elements(get_parameter_reference(np, CGAL::internal_np::feature_edges),
                            "feature_edges", features.edges);
  if(refusal)
    return refusal;
  turn_negative_components(uvw_map, tetrahedra);
  if(cells == Cells_to_read::ALL) {
    further_vertices.clear();
    for(std::size_t v = 0; v < tetrahedra.number_of_vertices; ++v)
      further_vertices.push_back(tetrahedra.name(std::int32_t(v)));
  }
  const bool align_boundary = chosen(np, CGAL::internal_np::align_boundary, true);
  return Volume_survey<CornerUVWMap>(tetrahedra, uvw_map)
    .run(align_boundary, features, further_vertices, volume);
}

template <typename CornerUVWMap>
std::optional<Refusal> write_corners(const Flat_volume& volume, const std::vector<Uvw>& u,
                                     CornerUVWMap& uvw_map)
{
  using Point = typename boost::property_traits<CornerUVWMap>::value_type;
  using Number = typename Map_number<CornerUVWMap>::type;
  using Change = Corner_change<std::size_t, Uvw>;
  return write_all_or_nothing(
    u.size(),
    [&](const std::size_t i) {
      return Change{volume.key(i), volume.coordinates[i], u[i]};
    },
    [&](const std::size_t corner) { return get_uvw(uvw_map, corner); },
    [&](const Change& change, const Uvw& to) {
      if(change.before != change.after) // a zero that stays one keeps its sign
        put(uvw_map, change.corner, Point(static_cast<Number>(to[0]), static_cast<Number>(to[1]),
                                          static_cast<Number>(to[2])));
    });
}

// The vertices of cells that have lost their orientation, though a move of one that no constraint
// concerns may give it back.
inline std::vector<std::int64_t> free_vertices_of_lost_cells(const Flat_volume& volume,
                                                             const std::vector<std::size_t>& lost)
{
  std::vector<std::int64_t> result;
  for(std::size_t c = 0, k = 0; c < volume.number_of_cells() && k < lost.size(); ++c)
    if(std::size_t(volume.cell_names[c]) == lost[k]) {
      ++k;
      for(std::size_t i = 4 * c; i < 4 * c + 4; ++i)
        if(volume.is_fixed[std::size_t(volume.vertices[i])] != 0)
          result.push_back(volume.vertex_names[std::size_t(volume.vertices[i])]);
    }
  return result;
}

// Reads, and finds the result. The rest of the mesh is forgotten before.
template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
std::optional<Refusal> find_map(const TetrahedronRange& range, const CornerUVWMap& uvw_map,
                                const NamedParameters& np, const Volume_options& options,
                                Step_timer& timer, Snapping_report& report, Flat_volume& volume,
                                std::vector<Uvw>& snapped)
{
  const Cells_to_read cells =
    options.is_about_all_cells() ? Cells_to_read::ALL : Cells_to_read::AT_CONSTRAINTS;
  std::vector<std::int64_t> further_vertices;
  for(bool is_again = false; ; is_again = true) {
    volume = Flat_volume();
    {
      Tetrahedra tetrahedra;
      const auto refusal =
        read_volume(range, uvw_map, np, tetrahedra, volume, further_vertices, cells);
      report.run.number_of_faces = tetrahedra.number_of_cells();
      report.extent = volume.extent;
      timer.finish("reading");
      if(refusal)
        return refusal;
    }
    read_coordinates(uvw_map, volume);
    const auto format = Number_format::of<typename Map_number<CornerUVWMap>::type>();
    if(auto refusal = snap_flat_volume(volume, options, format, report, timer, snapped))
      return refusal;
    further_vertices = free_vertices_of_lost_cells(volume, report.lost_faces);
    if(is_again || further_vertices.empty())
      return std::nullopt;
    report.lost_faces.clear();
  }
}

template <typename NamedParameters>
Volume_options volume_options(const NamedParameters& np)
{
  return {chosen(np, CGAL::internal_np::tolerance, default_volume_tolerance),
          chosen(np, CGAL::internal_np::integer_grid, false),
          chosen(np, CGAL::internal_np::grid_scale, 1.),
          chosen(np, CGAL::internal_np::rounding_tolerance, default_rounding_tolerance),
          chosen_flip_repair(np),
          chosen_number_of_untangling_iterations(np)};
}

template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
Snapping_report snap_volume(const TetrahedronRange& range, CornerUVWMap uvw_map,
                            const NamedParameters& np)
{
  check_parameters<NamedParameters>();
  Snapping_report report;
  const Volume_options options = volume_options(np);
  const Progress progress(np);
  Step_timer timer(report);
  Flat_volume volume;
  std::vector<Uvw> snapped;
  std::optional<Refusal> refusal;
  if(!(options.tolerance >= 0 && options.rounding_tolerance >= 0))
    refusal = invalid_cells("a tolerance is negative or NaN");
  else
    refusal = find_map(range, uvw_map, np, options, timer, report, volume, snapped);
  if(!refusal && report.status != Outcome::ALREADY_EXACT)
    refusal = write_corners(volume, snapped, uvw_map); // last, as nothing may throw after it
  if(refusal)
    refuse(report, *refusal);
  return report;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SNAP_VOLUME_H
