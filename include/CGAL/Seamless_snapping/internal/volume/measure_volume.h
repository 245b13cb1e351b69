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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MEASURE_VOLUME_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MEASURE_VOLUME_H

#include <CGAL/license/Seamless_snapping.h>

// How far a parametrization of a volume is from being exactly seamless: what the functions of
// `is_volume_seamless.h` do.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_volume.h>
#include <CGAL/Seamless_snapping/types/Volume_seamlessness.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The differences of the coordinates of some corners, in ascending order.
inline Uvw sorted_spreads(const Flat_volume& volume, const std::vector<Corner_index>& corners)
{
  Uvw result{};
  for(std::size_t c = 0; c < 3; ++c) {
    double least = volume.uvw(corners[0])[c], largest = least;
    for(const Corner_index corner : corners) {
      least = (std::min)(least, volume.uvw(corner)[c]);
      largest = (std::max)(largest, volume.uvw(corner)[c]);
    }
    result[c] = largest - least;
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Counts and measures what the flat volume lists.
inline void measure_constraints(const Flat_volume& volume, Volume_seamlessness& result)
{
  result.extent = volume.extent;
  result.number_of_mismatched_facets = volume.open_facets.size();
  for(const Corner_index facet : volume.open_facets) {
    const Facet_vectors vectors(volume.sides(facet));
    if(vectors.match_some())
      continue;
    ++result.number_of_inexact_facets;
    double least = vectors.residual(0);
    for(int g = 1; g < Cube_rotations::order; ++g)
      least = (std::min)(least, vectors.residual(g));
    result.violation = (std::max)(result.violation, least);
  }
  const auto add_misalignment = [&](const double miss) {
    result.number_of_misalignments += std::size_t(miss != 0);
    result.misalignment = (std::max)(result.misalignment, miss);
  };
  result.number_of_aligned_facets = volume.aligned_facets.size();
  for(const Corner_index facet : volume.aligned_facets) {
    const auto corners = corners_of_facet(facet);
    add_misalignment(sorted_spreads(volume, {corners.begin(), corners.end()})[0]);
  }
  result.number_of_aligned_edges = volume.aligned_edges.size();
  for(const Flat_volume::Aligned_edge& edge : volume.aligned_edges)
    add_misalignment(sorted_spreads(volume, {edge.a, edge.b})[1]);
}

// Throws what is wrong with the cells or the coordinates.
template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
void read_or_throw(const TetrahedronRange& range, const CornerUVWMap& uvw_map,
                   const NamedParameters& np, const Cells_to_read cells, Tetrahedra& tetrahedra,
                   Flat_volume& volume)
{
  if(const auto refusal = read_volume(range, uvw_map, np, tetrahedra, volume, {}, cells))
    throw std::invalid_argument(refusal->message);
  read_coordinates(uvw_map, volume);
}

template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
Volume_seamlessness measure_volume_seamlessness(const TetrahedronRange& range,
                                                const CornerUVWMap& uvw_map,
                                                const NamedParameters& np)
{
  Tetrahedra tetrahedra;
  Flat_volume volume;
  read_or_throw(range, uvw_map, np, Cells_to_read::AT_CONSTRAINTS, tetrahedra, volume);
  Volume_seamlessness result;
  measure_constraints(volume, result);
  result.number_of_cells = tetrahedra.number_of_cells();
  for(std::size_t f = 0; f < tetrahedra.neighbors.size(); ++f)
    result.number_of_interior_facets += std::size_t(tetrahedra.neighbors[f] > Corner_index(f / 4));
  for(std::size_t c = 0; c < tetrahedra.number_of_cells(); ++c) {
    Uvw_tetrahedron u;
    for(std::size_t i = 0; i < 4; ++i)
      u[i] = get_uvw(uvw_map, 4 * c + i);
    const CGAL::Orientation sign = orientation(u);
    result.number_of_flipped_cells += std::size_t(sign == CGAL::NEGATIVE);
    result.number_of_degenerate_cells += std::size_t(sign == CGAL::ZERO);
  }
  return result;
}

template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
bool is_volume_seamless(const TetrahedronRange& range, const CornerUVWMap& uvw_map,
                        const NamedParameters& np)
{
  Tetrahedra tetrahedra;
  Flat_volume volume;
  if(const auto refusal = read_volume(range, uvw_map, np, tetrahedra, volume)) {
    if(refusal->status == Outcome::NOT_FINITE)
      return false;
    throw std::invalid_argument(refusal->message);
  }
  read_coordinates(uvw_map, volume);
  Volume_seamlessness result;
  measure_constraints(volume, result);
  return result.is_exact();
}

template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
Volume_integer_grid_measure measure_volume_integer_grid(const TetrahedronRange& range,
                                                        const CornerUVWMap& uvw_map,
                                                        const NamedParameters& np)
{
  Tetrahedra tetrahedra;
  Flat_volume volume;
  read_or_throw(range, uvw_map, np, Cells_to_read::ALL, tetrahedra, volume);
  return measure_integer_grid(volume);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MEASURE_VOLUME_H
