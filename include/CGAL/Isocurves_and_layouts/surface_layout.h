// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_SURFACE_LAYOUT_H
#define CGAL_ISOCURVES_AND_LAYOUTS_SURFACE_LAYOUT_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Motorcycle graphs, base complexes, and other layouts of exactly seamless parametrizations.

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/read_exact_map.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

Where two curves of a layout meet: what a stop policy decides by. The first curve comes to a point
at which the second one has been before, or has the right of way if both come at the same time: that
is the curve which sees the other one come from its left.

\tparam TriangleMesh the type of the mesh
*/
template <typename TriangleMesh>
struct Curve_meeting
{
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  vertex_descriptor start;        ///< where the first curve has started
  vertex_descriptor other_start;  ///< where the second curve has started
  Exact_rational length;          ///< of the first curve up to the point
  Exact_rational other_length;    ///< of the second curve up to the point
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The stop policy of motorcycle graphs: each curve ends where it meets another one, or itself.
*/
struct Stop_at_curves
{
  /// returns `true`.
  template <typename Meeting>
  bool operator()(const Meeting&) const { return true; }
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The stop policy of base complexes: each curve runs on to a node, or to a border or feature. Such
curves can be very long; see `maximum_number` of `motorcycle_graph()`.
*/
struct Run_to_nodes
{
  /// returns `false`.
  template <typename Meeting>
  bool operator()(const Meeting&) const { return false; }
};

namespace internal {

// What the caller says of vertices; empty if nothing.
template <typename TriangleMesh, typename NamedParameters>
std::vector<char> constrained_vertices(const Flat_numbering<TriangleMesh>& numbering,
                                       const NamedParameters& np)
{
  std::vector<char> result;
  const auto map = CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_is_constrained);
  if constexpr(is_given<decltype(map)>)
    for(const auto v : numbering.vertices_in_order())
      result.push_back(get(map, v) ? 1 : 0);
  return result;
}

// At a vertex with several fans of faces, vertices of the layout are more than those of the mesh.
template <typename TriangleMesh>
auto start_of_curve(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                    const Layout_data& data, const Curve_index c)
{
  const std::size_t v = data.race->curves()[c].start;
  return target(
    numbering.halfedges_of_corners()[std::size_t(data.domain.mesh.corner_at_vertex[v])], tmesh);
}

template <typename TriangleMesh, typename NamedParameters>
Race_options race_options(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                          const Layout_data& data, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  Race_options options;
  options.maximum_number = static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    get_parameter(np, CGAL::internal_np::maximum_number),
    (std::max)(std::size_t(1000000), 10 * numbering.halfedges_of_corners().size())));
  const auto policy = get_parameter(np, CGAL::internal_np::stop_policy);
  using Policy = std::decay_t<decltype(policy)>;
  if constexpr(std::is_same_v<Policy, Run_to_nodes>)
    options.ends = [](const Meeting&) { return false; };
  else if constexpr(is_given<decltype(policy)> && !std::is_same_v<Policy, Stop_at_curves>)
    options.ends = [&tmesh, &numbering, &data, policy](const Meeting& m) -> bool {
      return policy(Curve_meeting<TriangleMesh>{
        start_of_curve(tmesh, numbering, data, m.first.curve),
        start_of_curve(tmesh, numbering, data, m.second.curve), m.first.length.exact(),
        m.second.length.exact()});
    };
  return options;
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
void read_and_make_layout(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                          const HalfedgeUVMap& uv_map, const NamedParameters& np, Layout_data& data)
{
  const Protect_exact_arithmetic protect;
  Layout_input input;
  if(const auto refusal = read_exact_map(tmesh, numbering, uv_map, np, input.mesh)) {
    refuse(data, *refusal);
    return;
  }
  input.is_feature = feature_corners(tmesh, numbering, np);
  input.is_given = constrained_vertices(numbering, np);
  input.align_border = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::align_border), false);
  input.options = race_options(tmesh, numbering, data, np);
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(tmesh, np);
  input.vertex_name = [&](const std::size_t v) {
    const Corner_index h = data.domain.mesh.corner_at_vertex[v];
    return std::to_string(
      get(vertex_indices, target(numbering.halfedges_of_corners()[std::size_t(h)], tmesh)));
  };
  make_layout(std::move(input), data);
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

divides a surface into rectangles along isocurves of an exactly seamless parametrization.

Curves start at the <em>nodes</em> in all directions along which a coordinate is constant, at the
same time and with the same speed. Nodes are the cones, that is the interior vertices whose angle in
the domain is not 360 degrees; the vertices at which borders and features end, meet, or turn; given
vertices; and one vertex in each part of the surface that has no other node. A curve ends at borders
and features, at nodes, and where it meets a curve that has been there before; at the same time, the
curve that sees the other one come from its right ends. Two curves that meet head on become one arc.
Another `stop_policy` makes curves run on where they meet.

If the parametrization is exactly seamless, all faces are positive in the domain, and borders and
features lie on isocurves, then all of this ends, and what comes out divides the surface into
rectangles: discs with four corners whose opposite sides are of exactly the same length. The areas
of all rectangles make up that of the domain. At a cone of index \f$ i \f$ there are
\f$ 4 - i \f$ arcs. All conditions are checked before; that all patches are discs with four corners
and equal sides is checked afterwards, exactly. All decisions in between are exact; there are no
tolerances.

Where a border does not lie on isocurves, curves end at it as well, but none start there, unless at
given vertices, and where it meets borders and features that do. The patches that it is part of
are <em>cut</em>: they can have any shape, and need not be discs. All others are rectangles as
before, and the areas of all patches make up that of the domain. With `align_border(true)` such a
border is refused, as are features that do not lie on isocurves.

The graph depends on the mesh and its parametrization only, not on the order of faces and vertices,
which only decides how nodes, arcs, and patches are numbered; and where two vertices of a part
without nodes have the same coordinates in all charts, which of them is chosen.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh; the graph refers to it
\param uv_map the coordinates of each corner: that of halfedge `h` is the corner of `face(h)` at
       `target(h)`. Values of border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below, and those of `seam_transitions()`

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges, which become arcs and have to lie on isocurves. Border
                          edges always become arcs.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether all border edges have to lie on isocurves. Otherwise, patches that
                          a border cuts which does not need not be rectangles.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{further vertices that are nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no vertex is}
  \cgalParamNEnd
  \cgalParamNBegin{stop_policy}
    \cgalParamDescription{whether a curve ends where it meets another one, or itself. For the same
                          meeting, the answer must always be the same. At nodes, borders, and
                          features, curves always end.}
    \cgalParamType{a function object that returns `bool` for a `Curve_meeting<TriangleMesh>`, such
                   as `Stop_at_curves` and `Run_to_nodes`}
    \cgalParamDefault{`Stop_at_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of segments of all curves, which is that of crossings of edges
                          and vertices, above which the computation is given up; and that of points
                          at which two curves meet, or would if they ran on. It takes some 200
                          bytes for each of the former, and some 400 for each of the latter.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{30 times the number of faces, but at least a million}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the graph, or why there is none

\par Complexity
Linear in the number of faces, of crossings of curves with edges, and of pairs of curves that cross
the same face; with a logarithmic factor for the order of events.

\sa `snap_to_seamless()`
\sa `Isocurve_tracer::separatrices()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Motorcycle_graph<TriangleMesh>
motorcycle_graph(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    const auto numbering = std::make_shared<internal::Flat_numbering<TriangleMesh> >(tmesh);
    const auto data = std::make_shared<internal::Layout_data>();
    internal::read_and_make_layout(tmesh, *numbering, uv_map, internal::strip(np), *data);
    return Motorcycle_graph<TriangleMesh>(tmesh, numbering, data);
  }
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_SURFACE_LAYOUT_H
