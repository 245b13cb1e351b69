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
// ask for, facet by facet. It knows nothing of sectors, sheets, and places.

#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>

#include <cstddef>
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H
