// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_LOCAL_GRIDS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_LOCAL_GRIDS_H

#include <CGAL/license/Seamless_snapping.h>

// Parts of a parametrization that no constraint links to the rest, such as connected components of the mesh
// or borders that are aligned by themselves, may have much smaller coordinates. They get grids of their own.
// Homogeneous constraints hold for all multiples of a solution: so such a part is magnified by a power of two
// for the time of the computation, and one grid serves all.

#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// \param grid the finest for the largest coordinate of all
// \pre the cut and aligned edges are all constraints that there are
template <typename TriangleMesh, typename HalfedgeUVMap>
void magnify_small_parts(Sector_map<TriangleMesh, HalfedgeUVMap>& sectors, const Grid& grid)
{
  const std::size_t size = sectors.number_of_vertices();
  std::vector<Vertex_index> parent(size), rank(size, 0);
  boost::disjoint_sets<Vertex_index*, Vertex_index*> parts(rank.data(), parent.data());
  for(std::size_t v = 0; v < size; ++v)
    parts.make_set(Vertex_index(v));
  std::size_t number_of_parts = size;
  for(const auto* edges : {&sectors.cut_ends(), &sectors.align_ends()})
    for(const Edge_ends& edge : *edges) {
      const Vertex_index a = parts.find_set(edge.source), b = parts.find_set(edge.target);
      if(a == b)
        continue;
      parts.link(a, b);
      --number_of_parts;
    }
  if(number_of_parts <= 1)
    return;

  std::vector<double> largest(size, 0);
  for(std::size_t v = 0; v < size; ++v) {
    double& l = largest[std::size_t(parts.find_set(Vertex_index(v)))];
    const Sector_index end = sectors.first_sector(Vertex_index(v) + 1);
    for(Sector_index s = sectors.first_sector(Vertex_index(v)); s != end; ++s)
      l = (std::max)(l, sectors.largest_coordinate(s));
  }
  for(std::size_t v = 0; v < size; ++v) {
    const double l = largest[std::size_t(parts.find_set(Vertex_index(v)))];
    if(l > 0)
      sectors.magnify(Vertex_index(v), grid.exponent() - Grid::finest(grid.format(), l).exponent());
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_LOCAL_GRIDS_H
