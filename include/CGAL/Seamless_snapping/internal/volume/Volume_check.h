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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H

#include <CGAL/license/Seamless_snapping.h>

// The verification: where coordinates do not satisfy, exactly, what the transitions and alignments
// ask for, and whether translations and levels are integers, facet by facet. It knows nothing of
// sectors, sheets, and places.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Seamless_snapping/internal/volume/Grid_edges.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Calls f(corner, c) for coordinates at which an open or aligned facet or an aligned edge is
// inexact; for transitions, in the chart of the cell on the other side. In the input, that is all.
template <typename F>
void for_each_inexact_coordinate(const Flat_volume& volume, const Volume_transitions& transitions,
                                 const Volume_alignment& alignment, const std::vector<Uvw>& u,
                                 const F& f)
{
  const auto compare = [&](const Corner_index a, const Corner_index b, const std::size_t c) {
    if(u[std::size_t(a)][c] != u[std::size_t(b)][c]) {
      f(a, c);
      f(b, c);
    }
  };
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i) {
    const Corner_index facet = volume.open_facets[i];
    if(transitions.is_cut[i] == 0) {
      for(const Corner_index corner : corners_of_facet(facet))
        for(std::size_t c = 0; c < 3; ++c)
          compare(corner, volume.across(facet, corner), c);
      continue;
    }
    const Facet_vectors vectors(volume.sides(facet, u));
    for(std::size_t c = 0; c < 3; ++c)
      if(!vectors.match(transitions.element[i], c))
        for(const Corner_index corner : corners_of_facet(facet))
          f(volume.across(facet, corner), c);
  }
  for(std::size_t i = 0; i < volume.aligned_facets.size(); ++i) {
    const auto corners = corners_of_facet(volume.aligned_facets[i]);
    for(std::size_t j = 1; j < 3; ++j)
      compare(corners[0], corners[j], std::size_t(alignment.coordinate[i]));
  }
  for(std::size_t i = 0; i < volume.aligned_edges.size(); ++i)
    for(std::size_t c = 0; c < 3; ++c)
      if(int(c) != alignment.direction[i])
        compare(volume.aligned_edges[i].a, volume.aligned_edges[i].b, c);
}

inline bool is_exact(const Flat_volume& volume, const Volume_transitions& transitions,
                     const Volume_alignment& alignment, const std::vector<Uvw>& u)
{
  bool result = true;
  for_each_inexact_coordinate(volume, transitions, alignment, u,
                              [&](Corner_index, std::size_t) { result = false; });
  std::vector<char> is_open(volume.opposite.size(), 0);
  for(const Corner_index facet : volume.open_facets)
    is_open[std::size_t(facet)] = is_open[std::size_t(volume.opposite[std::size_t(facet)])] = 1;
  for(std::size_t i = 0; i < volume.opposite.size() && result; ++i)
    if(volume.opposite[i] > Corner_index(i) && is_open[i] == 0)
      for(const Corner_index corner : corners_of_facet(Corner_index(i)))
        result = result && u[std::size_t(corner)] ==
                             u[std::size_t(volume.across(Corner_index(i), corner))];
  return result;
}

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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H
