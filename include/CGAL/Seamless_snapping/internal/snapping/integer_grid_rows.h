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

#include <CGAL/Linear_snapping/internal/exact/orientation.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/mesh/Aligned_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/mesh/singular_vertices.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The angle of the corners from `first` on, clockwise, to the border or all around, in turns of the
// group; 0 at folds, where angles don't add up.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
double unfolded_angle(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const Halfedge first,
                      const double scale)
{
  double angle = 0;
  Halfedge h = first;
  do {
    const Uv_triangle t{get_uv(uv_map, h), get_uv(uv_map, next(h, tmesh)),
                        get_uv(uv_map, prev(h, tmesh))};
    if(orientation(t) != CGAL::POSITIVE)
      return 0;
    angle += corner_angle<Group>(tmesh, uv_map, h, scale);
    h = opposite(next(h, tmesh), tmesh);
  } while(h != first && !is_border(h, tmesh));
  return angle;
}

// Corners at vertices that have to be points of the grid though neither cuts nor levels tell of
// them: inner vertices of 720 degrees or more, around some of which the rotations cancel; and, on
// borders along isocurves, vertices of 360 degrees or more, where the border turns back, or goes
// straight on after more than a half turn.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
corners_at_grid_points(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                       const Aligned_edges<Group, TriangleMesh>& aligned_edges, const double scale)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  for(const auto v : vertices(tmesh)) {
    const auto first = halfedge(v, tmesh);
    if(first != boost::graph_traits<TriangleMesh>::null_halfedge() && !CGAL::is_border(v, tmesh) &&
       unfolded_angle<Group>(tmesh, uv_map, first, scale) > 2 * Group::order - 0.5)
      result.push_back(first);
  }
  for(const auto& edge : aligned_edges.edges())
    if(is_border(opposite(edge.halfedge, tmesh), tmesh) &&
       unfolded_angle<Group>(tmesh, uv_map, edge.halfedge, scale) > Group::order - 0.5)
      result.push_back(edge.halfedge);
  return result;
}

// The place of a rounding.
template <typename Group, typename TriangleMesh, typename VertexIndexMap>
std::string name_of_rounding(const Rounding<Group>& rounding,
                             const Surface_cuts<Group, TriangleMesh>& cuts,
                             const TriangleMesh& tmesh, const VertexIndexMap& vertex_indices)
{
  switch(rounding.kind) {
  case Rounding<Group>::BRANCH:
    return "the translation across " +
           edge_name(tmesh, vertex_indices, cuts.branch_ends[rounding.index][0]);
  case Rounding<Group>::CHAIN:
    return "the level of " + edge_name(tmesh, vertex_indices, cuts.chain_ends[rounding.index][0]);
  case Rounding<Group>::POINT:
    break;
  }
  const auto corner = *cuts.corners_begin(Sector_index(rounding.index));
  return std::string(CGAL::is_border(target(corner, tmesh), tmesh) ? "the border" : "the cone") +
         " at vertex " + std::to_string(get(vertex_indices, target(corner, tmesh)));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_ROWS_H
