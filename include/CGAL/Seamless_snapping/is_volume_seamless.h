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

#ifndef CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// Checking and measuring the parametrizations of volumes: whether they are exactly seamless, and
// whether they are integer-grid maps.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/internal/volume/measure_volume.h>
#include <CGAL/Seamless_snapping/types/Volume_seamlessness.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingVerifying

decides whether a parametrization of a tetrahedral mesh is exactly seamless: whether for each
interior facet there is one of the 24 rotations of the cube \f$ R \f$ such that
\f$ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f$ for any two of its
vertices \f$ a, b \f$, where \f$ \mathbf{u} \f$ and \f$ \mathbf{u}' \f$ are the coordinates in the
charts of its two cells; and whether a coordinate is constant on each boundary facet and feature
facet, and two are along each feature edge. The answer is that of exact arithmetic.

Template and function parameters, and all named parameters but `tolerance` and `verbose`, are those
of `snap_volume_to_seamless()`; the map need be a model of `ReadablePropertyMap` only.

\return `false` also if a coordinate is NaN, infinite, or beyond 1e300

\throws std::invalid_argument if the cells, their neighbors, or the features are not what
        `snap_volume_to_seamless()` asks for; the message names the place
\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of cells; about as fast as comparing the coordinates on both sides of each
facet.

\sa `measure_volume_seamlessness()`
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_volume_seamless(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  internal::require_exact_arithmetic();
  return internal::is_volume_seamless(tetrahedra, uvw_map, internal::strip(np));
}

/*!
\ingroup PkgSeamlessSnappingVerifying

measures how far a parametrization of a tetrahedral mesh is from being exactly seamless and aligned,
and counts the cells that are flipped or degenerate in the domain. Parameters are those of
`is_volume_seamless()`.

\throws std::invalid_argument also if a coordinate is NaN, infinite, or beyond 1e300
\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of cells.
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Volume_seamlessness
measure_volume_seamlessness(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  internal::require_exact_arithmetic();
  return internal::measure_volume_seamlessness(tetrahedra, uvw_map, internal::strip(np));
}

/*!
\ingroup PkgSeamlessSnappingVerifying

What `measure_volume_integer_grid()` returns. The counts are exact; distances and the volume are
computed in floating point.
*/
struct Volume_integer_grid_measure
{
  bool is_exactly_seamless = false; ///< whether all transitions and alignments hold exactly
  std::size_t number_of_noninteger_cuts = 0;   ///< cut facets whose translation is no integer
  std::size_t number_of_noninteger_facets = 0; ///< aligned facets that lie on no integer plane
  std::size_t number_of_noninteger_edges = 0;  ///< aligned edges that lie on no integer line
  /// interior edges with another angle than 360 degrees, and, on a boundary that is aligned, edges
  /// of 360 degrees or more
  std::size_t number_of_singular_edges = 0;
  /// those of them that lie on no integer line
  std::size_t number_of_noninteger_singular_edges = 0;
  /// vertices at which other than two interior singular edges meet
  std::size_t number_of_nodes = 0;
  /// those of them that are no integer points; where cells have positive volume, all are, if
  /// singular edges are on integer lines
  std::size_t number_of_noninteger_nodes = 0;
  /// cells that are flipped or degenerate in the domain, if most are positive; else those that are
  /// not negative
  std::size_t number_of_nonpositive_cells = 0;
  double translation_distance = 0; ///< the largest distance of a translation from an integer
  /// the largest distance of an aligned facet from an integer plane, or of an edge from a line
  double alignment_distance = 0;
  /// of all cells, with their signs: in an integer-grid map with aligned boundary, it is the number
  /// of hexahedra
  double volume = 0;

  /// returns `true` if and only if the map is an integer-grid map, exactly. Orientations are not
  /// looked at.
  explicit operator bool() const
  {
    return is_exactly_seamless && number_of_noninteger_cuts == 0 &&
           number_of_noninteger_facets == 0 && number_of_noninteger_edges == 0 &&
           number_of_noninteger_singular_edges == 0 && number_of_noninteger_nodes == 0;
  }
};

namespace internal {

// The singular edges, of a volume that does not list them as aligned.
inline void measure_singular_edges(const Flat_volume& volume, const Volume_transitions& transitions,
                                   Volume_integer_grid_measure& measure)
{
  const std::vector<Grid_edge> edges = Grid_edge_finder(volume, transitions).find();
  Flat_volume edges_only = volume;
  edges_only.aligned_facets.clear();
  edges_only.aligned_edges.clear();
  measure.number_of_singular_edges = edges.size();
  for(const Grid_edge& edge : edges)
    if(!edge.is_skew)
      edges_only.aligned_edges.push_back(edge.edge);
  measure.number_of_noninteger_singular_edges = edges.size() - edges_only.aligned_edges.size();
  const Volume_alignment alignment = Facet_alignment_reader(edges_only, transitions).read();
  for(std::size_t i = 0; i < edges_only.aligned_edges.size(); ++i) {
    const double distance = line_distance(edges_only, i, alignment, volume.coordinates);
    measure.number_of_noninteger_singular_edges +=
      std::size_t(distance != 0 || !is_on_line(edges_only, i, alignment));
    measure.alignment_distance = (std::max)(measure.alignment_distance, distance);
  }
  std::vector<std::pair<std::int32_t, bool> > nodes; // and whether they are off the grid
  for(const Corner_index corner : corners_of_nodes(volume, edges))
    nodes.emplace_back(volume.vertex(corner), point_distance(volume, corner) != 0);
  std::sort(nodes.begin(), nodes.end(), std::greater<>());
  for(std::size_t i = 0; i < nodes.size(); ++i)
    if(i == 0 || nodes[i].first != nodes[i - 1].first) {
      ++measure.number_of_nodes;
      measure.number_of_noninteger_nodes += std::size_t(nodes[i].second);
    }
}

inline void measure_orientations(const Flat_volume& volume, Volume_integer_grid_measure& measure)
{
  std::size_t positive = 0, negative = 0;
  for(std::size_t c = 0; c < volume.number_of_cells(); ++c) {
    const Uvw_tetrahedron u = uvw_of_cell(volume.coordinates, c);
    const CGAL::Orientation sign = orientation(u);
    positive += std::size_t(sign == CGAL::POSITIVE);
    negative += std::size_t(sign == CGAL::NEGATIVE);
    measure.volume += six_times_volume(u) / 6;
  }
  measure.number_of_nonpositive_cells =
    volume.number_of_cells() - (std::max)(positive, negative);
  if(negative > positive)
    measure.volume = -measure.volume;
}

template <typename TetrahedronRange, typename CornerUVWMap, typename NamedParameters>
Volume_integer_grid_measure measure_volume_integer_grid(const TetrahedronRange& range,
                                                        const CornerUVWMap& uvw_map,
                                                        const NamedParameters& np)
{
  Tetrahedra tetrahedra;
  Flat_volume volume;
  if(const auto refusal = read_volume(range, uvw_map, np, tetrahedra, volume, {},
                                      Cells_to_read::ALL))
    throw std::invalid_argument(refusal->message);
  read_coordinates(uvw_map, volume);
  Volume_integer_grid_measure result;
  const Volume_transitions transitions = Facet_transition_reader(volume).read();
  const Volume_alignment alignment = Facet_alignment_reader(volume, transitions).read();
  result.is_exactly_seamless = is_exact(volume, transitions, alignment, volume.coordinates);
  const auto note = [](const double distance, std::size_t& number, double& largest) {
    number += std::size_t(distance != 0);
    largest = (std::max)(largest, distance);
  };
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i)
    if(transitions.is_cut[i] != 0)
      note(translation_distance(volume, volume.open_facets[i], transitions.element[i],
                                volume.coordinates),
           result.number_of_noninteger_cuts, result.translation_distance);
  for(std::size_t i = 0; i < volume.aligned_facets.size(); ++i)
    note(level_distance(volume, i, alignment, volume.coordinates),
         result.number_of_noninteger_facets, result.alignment_distance);
  for(std::size_t i = 0; i < volume.aligned_edges.size(); ++i)
    note(line_distance(volume, i, alignment, volume.coordinates),
         result.number_of_noninteger_edges, result.alignment_distance);
  measure_singular_edges(volume, transitions, result);
  measure_orientations(volume, result);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingVerifying

measures how far a parametrization of a tetrahedral mesh is from an integer-grid map: an exactly
seamless one whose translations across cuts are integers, whose singular edges lie on integer lines
along a coordinate axis and meet at integer points, and in which boundary facets, feature facets,
and feature edges lie on integer planes and lines. Such a map describes a mesh of hexahedra, the
cells of the integer grid, which programs like HexEx extract. Edges are singular if the angles of
cells around them do not sum up to 360 degrees: where the rotations across facets around them do not
multiply to the identity, or where they have 720 degrees or more. Where a cell around an edge is
flipped or degenerate, rotations alone tell.

Nothing of what is used here finds such maps; transitions are read off the coordinates.

Parameters and exceptions are those of `measure_volume_seamlessness()`.

\par Complexity
Linear in the number of cells, all of which are copied; but for a logarithmic factor where corners
at nodes are sorted.

\sa `snap_volume_to_seamless()`
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Volume_integer_grid_measure
measure_volume_integer_grid(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  internal::require_exact_arithmetic();
  return internal::measure_volume_integer_grid(tetrahedra, uvw_map, internal::strip(np));
}

/*!
\ingroup PkgSeamlessSnappingVerifying

returns `true` if and only if a parametrization of a tetrahedral mesh is an integer-grid map,
exactly; see `measure_volume_integer_grid()`, whose parameters it has. Orientations are not looked
at.

\throws std::invalid_argument and `std::runtime_error` as `measure_volume_integer_grid()` does

\par Complexity
That of `measure_volume_integer_grid()`.
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_volume_integer_grid_map(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  return bool(measure_volume_integer_grid(tetrahedra, uvw_map, np));
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IS_VOLUME_SEAMLESS_H
