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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_GRID_CHECK_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_GRID_CHECK_H

#include <CGAL/license/Seamless_snapping.h>

// The verification of integer-grid maps of volumes: whether translations and levels are integers,
// exactly, facet by facet. It knows nothing of how they became so.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Seamless_snapping/internal/volume/Grid_edges.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The largest distance of a translation of a cut from an integer.
inline double translation_distance(const Flat_volume& volume, const Corner_index facet, const int g,
                                   const std::vector<Uvw>& u)
{
  using Group = Cube_rotations;
  const Corner_index corner = corners_of_facet(facet)[0];
  const Uvw &here = u[std::size_t(corner)],
            &there = u[std::size_t(volume.across(facet, corner))];
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    result = (std::max)(result, distance_to_integer(Exact_difference(
                                  there[c], Group::sign(g, c) * here[Group::source(g, c)])));
  return result;
}

// Those of a constant coordinate of an aligned facet, and of both of an aligned edge.
inline double level_distance(const Flat_volume& volume, const std::size_t i,
                             const Volume_alignment& alignment, const std::vector<Uvw>& u)
{
  const Corner_index corner = corners_of_facet(volume.aligned_facets[i])[0];
  return distance_to_integer(u[std::size_t(corner)][std::size_t(alignment.coordinate[i])]);
}

inline double line_distance(const Flat_volume& volume, const std::size_t i,
                            const Volume_alignment& alignment, const std::vector<Uvw>& u)
{
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    if(int(c) != alignment.direction[i])
      result = (std::max)(result, distance_to_integer(
                                    u[std::size_t(volume.aligned_edges[i].a)][c]));
  return result;
}

// Whether all but one of its coordinates are constant along an aligned edge.
inline bool is_on_line(const Flat_volume& volume, const std::size_t i,
                       const Volume_alignment& alignment)
{
  const Uvw &a = volume.uvw(volume.aligned_edges[i].a), &b = volume.uvw(volume.aligned_edges[i].b);
  for(std::size_t c = 0; c < 3; ++c)
    if(int(c) != alignment.direction[i] && a[c] != b[c])
      return false;
  return true;
}

// Whether translations and levels are integers. \pre the map is exactly seamless and aligned
inline bool is_on_integers(const Flat_volume& volume, const Volume_transitions& transitions,
                           const Volume_alignment& alignment, const std::vector<Uvw>& u)
{
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i)
    if(transitions.is_cut[i] != 0 &&
       translation_distance(volume, volume.open_facets[i], transitions.element[i], u) != 0)
      return false;
  for(std::size_t i = 0; i < volume.aligned_facets.size(); ++i)
    if(level_distance(volume, i, alignment, u) != 0)
      return false;
  for(std::size_t i = 0; i < volume.aligned_edges.size(); ++i)
    if(line_distance(volume, i, alignment, u) != 0)
      return false;
  return true;
}

// The corners of vertices at which other than two of the interior edges meet.
inline std::vector<Corner_index> corners_of_nodes(const Flat_volume& volume,
                                                  const std::vector<Grid_edge>& edges)
{
  std::vector<std::int32_t> number(volume.number_of_vertices(), 0);
  for(const Grid_edge& edge : edges)
    for(const Corner_index end : {edge.edge.a, edge.edge.b})
      number[std::size_t(volume.vertex(end))] += std::int32_t(edge.is_interior);
  std::vector<Corner_index> result;
  for(std::size_t i = 0; i < volume.vertices.size(); ++i)
    if(const std::int32_t n = number[std::size_t(volume.vertices[i])]; n != 0 && n != 2)
      result.push_back(Corner_index(i));
  return result;
}

inline double point_distance(const Flat_volume& volume, const Corner_index corner)
{
  double result = 0;
  for(const double x : volume.uvw(corner))
    result = (std::max)(result, distance_to_integer(x));
  return result;
}

// Whether a map is that of an integer grid, to one who sees its coordinates only.
// \pre the volume holds all cells, and lists no singular edges
inline bool is_integer_grid(Flat_volume volume)
{
  const Volume_transitions transitions = Facet_transition_reader(volume).read();
  const std::vector<Grid_edge> edges = Grid_edge_finder(volume, transitions).find();
  for(const Grid_edge& edge : edges) {
    if(edge.is_skew)
      return false;
    volume.aligned_edges.push_back(edge.edge);
  }
  for(const Corner_index corner : corners_of_nodes(volume, edges))
    if(point_distance(volume, corner) != 0)
      return false;
  const Volume_alignment alignment = Facet_alignment_reader(volume, transitions).read();
  return is_exact(volume, transitions, alignment, volume.coordinates) &&
         is_on_integers(volume, transitions, alignment, volume.coordinates);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_GRID_CHECK_H
