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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MOVE_FROM_ORIGIN_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MOVE_FROM_ORIGIN_H

#include <CGAL/license/Quad_remeshing.h>

// Moves maps to where all coordinates have bits of the same size, but for one: near the origin,
// they can have more bits than integers of 64 bits. That rounds them, so that the map is to be
// snapped.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/snapping/snap_flat_surface.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// \param largest the largest absolute value of a coordinate
inline double distance_from_origin(const double largest)
{ return std::ldexp(1., std::ilogb(largest) + 2); }

inline double largest_coordinate(const Uv& uv)
{ return (std::max)(std::abs(uv[0]), std::abs(uv[1])); }

template <typename TriangleMesh, typename HalfedgeUVMap>
void move_from_origin(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  double largest = 0;
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh))
      largest = (std::max)(largest, largest_coordinate(get_uv(uv_map, h)));
  const double distance = distance_from_origin(largest);
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh)) {
      const Uv uv = get_uv(uv_map, h);
      put(uv_map, h, Point(uv[0] + distance, uv[1] + distance));
    }
}

// An exactly seamless map, moved and snapped; nothing if it can't be snapped there. Features and
// the border stay on isocurves where they are on some.
// \param is_feature per corner, or empty
inline std::optional<Chart_mesh> moved_from_origin(const Chart_mesh& mesh,
                                                   const std::vector<char>& is_feature)
{
  double largest = 0;
  for(const Chart_corner& corner : mesh.corners)
    largest = (std::max)(largest, largest_coordinate(corner.uv));
  const double distance = distance_from_origin(largest);
  Flat_surface surface(mesh, [&](const Corner_index h)
                       { return Uv{mesh.uv(h)[0] + distance, mesh.uv(h)[1] + distance}; });
  const Given_transitions<Quarter_turns, Corner_index> given(
    Quarter_turns::order, nullptr, [&](const Corner_index h)
    { return surface.is_border(h) ? 0 : Quarter_turns::turns(mesh.rotation(h)); });
  Snapping_options<Corner_index> options{{}, {}, default_tolerance, 0, 0, false,
                                         Flip_repair::NONE, 0};
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.represents_edge(h) && is_on_isocurve(mesh, h) &&
       (mesh.is_border_edge(h) || (!is_feature.empty() && is_feature[std::size_t(h)])))
      options.edges_to_align.push_back(h);
  if(!snap_flat_surface(surface, 1, given, options, &solve_complex<Quarter_turns, false>))
    return std::nullopt;

  Chart_mesh result = mesh;
  result.transitions.clear();
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h) {
    result.corners[std::size_t(h)].uv = surface.uv(h);
    result.corners[std::size_t(h)].transition = no_index;
  }
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!mesh.is_border_edge(h))
      add_transition(result, h, mesh.rotation(h));
  mark_singular_vertices<CGAL::Sequential_tag>(result);
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MOVE_FROM_ORIGIN_H
