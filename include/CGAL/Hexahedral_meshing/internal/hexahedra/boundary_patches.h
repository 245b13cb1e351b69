// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_BOUNDARY_PATCHES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_BOUNDARY_PATCHES_H

#include <CGAL/license/Hexahedral_meshing.h>

// The boundary of hexahedra: its quadrilaterals, in patches that meet in sharp edges.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedra_topology.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Fills in all but points and hexahedra.
inline void find_boundary_patches(Hexahedral_mesh& mesh)
{
  const Hexahedra_topology topology =
    Topology_finder(mesh.hexahedra, mesh.points.size()).run(CGAL::Sequential_tag());
  mesh.quadrilaterals.clear();
  std::vector<std::pair<Edge_of_hexahedra, std::size_t> > sides; // of smooth edges
  for(const Hexahedron_facet& f : topology.boundary) {
    std::array<std::int32_t, 4> quadrilateral;
    for(std::size_t k = 0; k < 4; ++k)
      quadrilateral[k] = mesh.hexahedra[std::size_t(f.hexahedron)][std::size_t(
        facet_of_hexahedron[f.facet][k])];
    for(std::size_t k = 0; k < 4; ++k) {
      const auto [a, b] = std::minmax(quadrilateral[k], quadrilateral[(k + 1) % 4]);
      if(const Edge_of_hexahedra edge{a, b};
         std::binary_search(topology.smooth_edges.begin(), topology.smooth_edges.end(), edge))
        sides.emplace_back(edge, mesh.quadrilaterals.size());
    }
    mesh.quadrilaterals.push_back(quadrilateral);
  }
  std::sort(sides.begin(), sides.end());
  Signed_union_find patches(mesh.quadrilaterals.size());
  for(std::size_t i = 1; i < sides.size(); ++i)
    if(sides[i].first == sides[i - 1].first)
      patches.unite(sides[i].second, sides[i - 1].second);
  mesh.patches.assign(mesh.quadrilaterals.size(), 0);
  std::int32_t number = 0;
  for(std::size_t i = 0; i < mesh.quadrilaterals.size(); ++i) { // a root is the first of its class
    const std::size_t root = patches.root(i);
    mesh.patches[i] = root == i ? ++number : mesh.patches[root];
  }
  mesh.edges.clear();
  std::set_difference(topology.boundary_edges.begin(), topology.boundary_edges.end(),
                      topology.smooth_edges.begin(), topology.smooth_edges.end(),
                      std::back_inserter(mesh.edges));
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_BOUNDARY_PATCHES_H
