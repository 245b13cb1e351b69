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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_ROWS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_ROWS_H

#include <CGAL/license/Seamless_snapping.h>

// What an integer-grid map asks for beyond a seamless one, added to the complex of a mesh.

#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/mesh/Aligned_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/singular_vertices.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Corners at vertices that have to be points of the grid though neither cuts nor levels tell of
// them: inner vertices of 720 degrees or more, around some of which the rotations cancel; and, on
// borders along isocurves, vertices of 360 degrees or more, where the border turns back, or goes
// straight on after more than a half turn.
template <typename Group>
std::vector<Corner_index>
corners_at_grid_points(const Flat_surface& surface,
                       const Aligned_edges<Group, Corner_index>& aligned_edges, const double scale)
{
  std::vector<Corner_index> result;
  for(const Corner_index first : surface.one_per_vertex())
    if(unfolded_angle<Group>(surface, first, scale) > 2 * Group::order - 0.5 &&
       !has_border_at_target(surface, first))
      result.push_back(first);
  for(const auto& edge : aligned_edges.edges())
    if(surface.is_border(surface.opposite(edge.halfedge)) &&
       unfolded_angle<Group>(surface, edge.halfedge, scale) > Group::order - 0.5)
      result.push_back(edge.halfedge);
  return result;
}

// The place of a rounding.
template <typename Group, typename Surface>
std::string name_of_rounding(const Rounding<Group>& rounding, const Surface& surface,
                             const Surface_cuts<Group, typename Surface::Halfedge>& cuts)
{
  switch(rounding.kind) {
  case Rounding<Group>::BRANCH:
    return "the translation across " + edge_name(surface, cuts.branch_ends[rounding.index][0]);
  case Rounding<Group>::CHAIN:
    return "the level of " + edge_name(surface, cuts.chain_ends[rounding.index][0]);
  case Rounding<Group>::POINT:
    break;
  }
  const auto corner = *cuts.corners_begin(Sector_index(rounding.index));
  return std::string(has_border_at_target(surface, corner) ? "the border" : "the cone") +
         " at vertex " + std::to_string(surface.vertex(corner));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_ROWS_H
