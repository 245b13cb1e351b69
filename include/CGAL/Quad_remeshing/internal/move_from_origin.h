// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_MOVE_FROM_ORIGIN_H
#define CGAL_QUAD_REMESHING_INTERNAL_MOVE_FROM_ORIGIN_H

#include <CGAL/license/Quad_remeshing.h>

// From a map to one of coarser bits: near the origin, coordinates and translations may have finer
// ones than integers of 64 bits can hold beside the largest coordinate.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// To where all coordinates have bits of the same size, but for one; rounded, so that the map is to
// be snapped.
template <typename TriangleMesh, typename HalfedgeUVMap>
void move_from_origin(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  double largest = 0;
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh))
      for(const double x : get_uv(uv_map, h))
        largest = (std::max)(largest, std::abs(x));
  const double distance = std::ldexp(1., std::ilogb(largest) + 2);
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh)) {
      const Uv uv = get_uv(uv_map, h);
      put(uv_map, h, Point(uv[0] + distance, uv[1] + distance));
    }
}

// Moves an exactly seamless map, and snaps it. Features and the border stay on isocurves where they
// are on some.
//
// \param mesh the same map, which stays where it is
// \param is_feature per corner of it, or empty
// \param uv_map receives the result
template <typename TriangleMesh, typename HalfedgeUVMap>
bool snap_far_from_origin(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                          const Chart_mesh& mesh, const std::vector<char>& is_feature,
                          const HalfedgeUVMap& uv_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  for(const auto h : numbering.halfedges_of_corners()) {
    const Uv& uv = mesh.uv(numbering.corner(h));
    put(uv_map, h, Point(uv[0], uv[1]));
  }
  move_from_origin(tmesh, uv_map);
  const auto is_aligned = [&](const typename Graph_traits::edge_descriptor e) {
    const auto h = halfedge(e, tmesh);
    const Corner_index side = numbering.corner(is_border(h, tmesh) ? opposite(h, tmesh) : h);
    return (mesh.is_border_edge(side) || (!is_feature.empty() && is_feature[std::size_t(side)])) &&
           is_on_isocurve(mesh, side);
  };
  const auto rotation = [&](const typename Graph_traits::halfedge_descriptor h) {
    return is_border(h, tmesh) ? 0 : Quarter_turns::turns(mesh.rotation(numbering.corner(h)));
  };
  return bool(snap_to_seamless(
    tmesh, uv_map,
    parameters::edge_is_constrained_map(
                  boost::make_function_property_map<typename Graph_traits::edge_descriptor>(
                    is_aligned))
                .halfedge_rotation_map(
                  boost::make_function_property_map<typename Graph_traits::halfedge_descriptor>(
                    rotation))));
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_MOVE_FROM_ORIGIN_H
