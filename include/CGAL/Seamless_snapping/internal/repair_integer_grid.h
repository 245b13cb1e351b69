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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_REPAIR_INTEGER_GRID_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_REPAIR_INTEGER_GRID_H

#include <CGAL/license/Seamless_snapping.h>

// A copy of an integer-grid map, in which faces that are not positive are repaired where that is
// possible.

#include <CGAL/Seamless_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/tracing/axis_directions.h>
#include <CGAL/Seamless_snapping/parameters.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A property map that tells which edges lie on lines of the grid: features that do, and border
// edges. They are to stay there.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename FeatureMap>
struct Edges_on_grid
{
  using key_type = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const TriangleMesh* tmesh;
  HalfedgeUVMap uv_map;
  FeatureMap features;
  double scale;

  friend bool get(const Edges_on_grid& map, const key_type& e) { return map.contains(e); }

  bool contains(const key_type& e) const
  {
    auto h = halfedge(e, *tmesh);
    if(is_border(h, *tmesh))
      h = opposite(h, *tmesh);
    else if(!is_border(opposite(h, *tmesh), *tmesh) && !is_feature(e))
      return false;
    const Uv a = get_uv(uv_map, prev(h, *tmesh)), b = get_uv(uv_map, h);
    for(std::size_t c = 0; c < std::size_t(Group::number_of_functionals); ++c)
      if(is_on_line(component<Group>(a, c), component<Group>(b, c)))
        return true;
    return false;
  }

  bool is_feature(const key_type& e) const
  {
    if constexpr(std::is_same_v<FeatureMap, CGAL::internal_np::Param_not_found>)
      return false;
    else
      return get(features, e);
  }

  bool is_on_line(const double a, const double b) const
  { return a == b && a * scale == std::round(a * scale); }

  bool is_on_line(const Exact_difference& a, const Exact_difference& b) const
  { return a == b && a.error == 0 && is_on_line(a.rounded, b.rounded); }
};

// Copies the map, and moves what may move until as many faces are positive as can be. Cuts, cones,
// and what lies on lines of the grid keep their integers: the report says if they are none.
// \param np those of the extraction, with `repair_flips`
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename RepairedMap,
          typename NamedParameters>
Snapping_report repair_integer_grid(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                    const RepairedMap& repaired, const NamedParameters& np)
{
  using Point = typename boost::property_traits<RepairedMap>::value_type;
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh)) {
      const Uv u = get_uv(uv_map, h);
      put(repaired, h, Point(u[0], u[1]));
    }
  const double scale = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::grid_scale), 1.);
  const auto features = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
  using Features = std::decay_t<decltype(features)>;
  const Edges_on_grid<Group, TriangleMesh, HalfedgeUVMap, Features> on_grid{&tmesh, uv_map,
                                                                            features, scale};
  return snap_to_seamless(tmesh, repaired,
                          Named_parameters<NamedParameters>(np)
                            .integer_grid(true).rounding_tolerance(0.).grid_scale(scale)
                            .edge_is_constrained_map(on_grid).align_border(false));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_REPAIR_INTEGER_GRID_H
