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

#ifndef CGAL_QUAD_REMESHING_REPAIR_INTEGER_GRID_H
#define CGAL_QUAD_REMESHING_REPAIR_INTEGER_GRID_H

#include <CGAL/license/Quad_remeshing.h>

// Repairs faces of an integer-grid map that are not positive, if that is possible.

#include <CGAL/Isocurves_and_layouts/internal/charts/axis_directions.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Quad_remeshing {
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
    if constexpr(is_given<FeatureMap>)
      return get(features, e);
    else
      return false;
  }

  bool is_on_line(const double a, const double b) const
  { return a == b && a * scale == std::round(a * scale); }

  bool is_on_line(const Exact_difference& a, const Exact_difference& b) const
  { return a == b && a.error == 0 && is_on_line(a.rounded, b.rounded); }
};

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuads

moves vertices of an integer-grid map in the domain such that flipped faces become positive.

`extract_quad_mesh()` and `extract_triangle_mesh()` refuse maps with flipped or degenerate faces.
This function repairs as many of them as it can. Translations and cones keep their integers,
features and borders on lines of the grid stay there, and the map stays exactly seamless. If no face
is flipped or degenerate, only the scale changes.

The function calls `snap_to_seamless()` and has its guarantees. It changes the map in place.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `snap_to_seamless()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below, and `tolerance`, `rotational_symmetry`, `vertex_index_map`, `verbose`, and `visitor`
        of `snap_to_seamless()`

\cgalNamedParamsBegin
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive number. The coordinates times this number must be an
                          integer-grid map.}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges. Feature edges on lines of the grid stay there.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{repair_flips}
    \cgalParamDescription{how far vertices may move}
    \cgalParamType{`Flip_repair`}
    \cgalParamDefault{`Flip_repair::NEAR_BY`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_untangling_iterations}
    \cgalParamDescription{the bound of the search, as for `snap_to_seamless()`}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{400}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return as `snap_to_seamless()`: on failure, nothing has changed. `NOT_INTEGER` tells that a
        translation, a cone, or a level is no integer. After success, which `FLIPS_REMAIN` is too,
        `Snapping_report::remaining_flips` and `Snapping_report::lost_faces` are the faces that are
        still not positive, and `Snapping_figures::number_of_repaired_flips` counts the repaired
        faces.

\par Complexity
The complexity of `snap_to_seamless()`.

\sa `is_integer_grid_map()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report repair_integer_grid(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(!internal::check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    return Snapping_report();
  } else {
    constexpr auto read =
      internal::named<CGAL::internal_np::edge_is_constrained, CGAL::internal_np::grid_scale,
                      CGAL::internal_np::repair_flips, CGAL::internal_np::rotational_symmetry,
                      CGAL::internal_np::tolerance, CGAL::internal_np::untangling_iterations,
                      CGAL::internal_np::verbose, CGAL::internal_np::vertex_index,
                      CGAL::internal_np::visitor>;
    const auto& plain_np = internal::strip(np, read);
    using Parameters = std::decay_t<decltype(plain_np)>;
    using Group = internal::Symmetry_group<Parameters>;
    const double scale = internal::chosen(plain_np, CGAL::internal_np::grid_scale, 1.);
    const auto features =
      CGAL::parameters::get_parameter(plain_np, CGAL::internal_np::edge_is_constrained);
    using Features = std::decay_t<decltype(features)>;
    const internal::Edges_on_grid<Group, TriangleMesh, HalfedgeUVMap, Features> on_grid{
      &tmesh, uv_map, features, scale};
    const auto options = internal::Named_parameters<Parameters>(plain_np)
                           .integer_grid(true).rounding_tolerance(0.).grid_scale(scale)
                           .edge_is_constrained_map(on_grid).align_border(false);
    const auto flip_repair =
      CGAL::parameters::get_parameter(plain_np, CGAL::internal_np::repair_flips);
    if constexpr(internal::is_given<decltype(flip_repair)>)
      return snap_to_seamless(tmesh, uv_map, options);
    else
      return snap_to_seamless(tmesh, uv_map, options.repair_flips(Flip_repair::NEAR_BY));
  }
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_REPAIR_INTEGER_GRID_H
