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
#include <CGAL/Seamless_snapping/internal/surface/Branches.h>
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
void magnify_small_parts(Sector_map<TriangleMesh, HalfedgeUVMap>& sectors, const Branches& branches,
                         const Grid& grid)
{
  const std::size_t size = sectors.number_of_vertices();
  std::vector<Vertex_index> parent(size), rank(size, 0);
  boost::disjoint_sets<Vertex_index*, Vertex_index*> parts(rank.data(), parent.data());
  for(std::size_t v = 0; v < size; ++v)
    parts.make_set(Vertex_index(v));
  const auto link = [&](const Vertex_index a, const Vertex_index b) {
    const Vertex_index x = parts.find_set(a), y = parts.find_set(b);
    if(x != y)
      parts.link(x, y);
    return x != y;
  };

  // The nodes alone tell whether there is one part only, as there mostly is.
  std::ptrdiff_t number_of_parts = std::count(branches.is_node.begin(), branches.is_node.end(), true);
  for(const Branch_list* list : {&branches.cut, &branches.aligned})
    for(std::size_t b = 0; b < list->size(); ++b)
      number_of_parts -= link(list->nodes(b).source, list->nodes(b).target) ? 1 : 0;
  if(number_of_parts <= 1)
    return;

  for(const auto* edges : {&sectors.cut_ends(), &sectors.align_ends()})
    for(const Edge_ends& edge : *edges)
      link(edge.source, edge.target);
  std::vector<double> largest(size, 0);
  for(std::size_t v = 0; v < size; ++v) {
    double& l = largest[std::size_t(parts.find_set(Vertex_index(v)))];
    const Sector_index end = sectors.first_sector(Vertex_index(v) + 1);
    for(Sector_index s = sectors.first_sector(Vertex_index(v)); s != end; ++s)
      l = (std::max)(l, largest_component(sectors.sector(s).uv));
  }
  constexpr int worthwhile = 4; // bits: magnified coordinates take longer
  for(std::size_t v = 0; v < size; ++v) {
    const double l = largest[std::size_t(parts.find_set(Vertex_index(v)))];
    const int bits = l > 0 ? grid.exponent() - Grid::finest(grid.format(), l).exponent() : 0;
    if(bits >= worthwhile)
      sectors.magnify(Vertex_index(v), bits);
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_LOCAL_GRIDS_H
