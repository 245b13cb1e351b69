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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_MOTORCYCLE_GRAPH_H
#define CGAL_ISOCURVES_AND_LAYOUTS_MOTORCYCLE_GRAPH_H

#include <CGAL/license/Isocurves_and_layouts.h>

// A partition of a surface into rectangles along isocurves: nodes, arcs, and patches; how it is
// made; and the lengths of its arcs as integers, which quantizations start from and must keep.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The kind of a node of a motorcycle graph.
*/
enum class Layout_node
{
  CONE,    ///< an interior vertex whose angle in the domain is not 360 degrees
  CORNER,  ///< a vertex at which borders and features end, meet, or turn
  GIVEN,   ///< a vertex that the caller has given
  SEED,    ///< a vertex that the function chose in a part of the surface without other nodes, or on
           ///< a closed border or feature without other nodes
  JUNCTION ///< the end of a curve at another curve, the crossing of two curves, or the end of a
           ///< curve at a border that does not lie on isocurves
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The result of `motorcycle_graph()`: a division of a surface into rectangles along isocurves of an
exactly seamless parametrization. With the policy `Run_to_nodes`, it is a base complex. Nodes, arcs,
half-arcs, and patches are numbered from 0.

Each arc is a piece of an isocurve between two nodes, of a length in the domain that is known
exactly. Arc `a` consists of the half-arcs `2 a` and `2 a + 1`, which run forward and back. Each has
a patch at its left, unless it runs along the border with the surface at its right. A patch is a
disk with four sides, each of one or more arcs, and opposite sides have the same length. A node at
which another curve ends may thus lie in the interior of a side.

If a border of the surface does not lie on isocurves, its pieces between nodes are arcs, too.
The patches there are cut: they have no sides, and can have any number of cycles of half-arcs around
them. Corners of such a border are no nodes.

The graph refers to the mesh, and stays valid until the mesh is modified or destroyed.
Copies share their data.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
*/
template <typename TriangleMesh>
class Motorcycle_graph
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Numbering = internal::Flat_numbering<TriangleMesh>;

public:
  /// a halfedge of the mesh
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  /// a vertex of the mesh
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  /// a face of the mesh
  using face_descriptor = typename Graph_traits::face_descriptor;
  /// a face and the barycentric coordinates of a point in it, in the order of
  /// `CGAL::Polygon_mesh_processing::Face_location`
  using Location = std::pair<face_descriptor, std::array<double, 3> >;
  /// the number of no patch
  static constexpr std::size_t null_patch = (std::numeric_limits<std::size_t>::max)();

  /// \cond SKIP_IN_MANUAL
  Motorcycle_graph(const TriangleMesh& tmesh, std::shared_ptr<const Numbering> numbering,
                   std::shared_ptr<const internal::Layout_data> data)
    : m_tmesh(&tmesh), m_numbering(std::move(numbering)), m_data(std::move(data))
  { }
  const internal::Layout_data& data() const { return *m_data; }
  const TriangleMesh& mesh() const { return *m_tmesh; }
  Location location(const internal::Face_point& p) const
  {
    return {face(m_numbering->halfedges_of_corners()[std::size_t(3 * p.face)], *m_tmesh),
            {p.weights[2], p.weights[0], p.weights[1]}};
  }
  /// \endcond

  /// \name Outcome
  /// @{

  /// returns `true` if and only if the surface is divided into patches.
  explicit operator bool() const { return status() == Outcome::SUCCESS; }

  /// returns the outcome.
  Outcome status() const { return m_data->status; }

  /// returns the reason, the place, and the remedy if there is no layout. Otherwise, returns a note
  /// on a border that does not lie on isocurves, if there is one.
  const Message& message() const { return m_data->message; }

  /// returns the faces that are flipped or degenerate in the domain, in the order of iteration over
  /// all faces, from 0. If there are any, the outcome is `NOT_POSITIVE`.
  const std::vector<std::size_t>& nonpositive_faces() const { return m_data->nonpositive_faces; }

  /// returns how many segments of curves were visited: pieces in one face, or along one edge.
  std::size_t number_of_visited_segments() const { return m_data->number_of_segments; }

  /// @}

  /// \name Nodes
  /// @{

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return layout().points.size(); }

  /// returns the kind of a node.
  Layout_node node_kind(const std::size_t n) const
  {
    switch(point(n).start) {
    case internal::Start_kind::CONE:   return Layout_node::CONE;
    case internal::Start_kind::CORNER: return Layout_node::CORNER;
    case internal::Start_kind::GIVEN:  return Layout_node::GIVEN;
    case internal::Start_kind::SEED:   return Layout_node::SEED;
    case internal::Start_kind::NONE:   break;
    }
    return Layout_node::JUNCTION;
  }

  /// returns the element on which a node lies; for all nodes that are no junctions,
  /// `Isocurve_place::VERTEX`.
  Isocurve_place node_place(const std::size_t n) const { return point(n).place.place; }

  /// returns a halfedge at a node: it points to the vertex, lies on the edge, or belongs to the
  /// face on which the node lies.
  halfedge_descriptor node_halfedge(const std::size_t n) const
  { return m_numbering->halfedges_of_corners()[std::size_t(point(n).place.halfedge)]; }

  /// returns the coordinates of a node in the chart of `face(node_halfedge(n))`.
  std::array<Exact_rational, 2> node_coordinates(const std::size_t n) const
  {
    const internal::Exact_uv& uv = point(n).place.uv;
    return {uv[0].exact(), uv[1].exact()};
  }

  /// returns the place of a node on the mesh; rounded.
  Location node_location(const std::size_t n) const
  {
    const internal::Protect_exact_arithmetic protect;
    return location(internal::face_point(chart_mesh(), point(n).place));
  }

  /// returns the half-arcs that leave a node, counterclockwise. At the border, the first one
  /// has the surface only at its left.
  std::vector<std::size_t> half_arcs_around_node(const std::size_t n) const
  {
    std::vector<std::size_t> result;
    const internal::Layout_point& p = point(n);
    for(std::int32_t s = p.first_slot; s < p.first_slot + p.number_of_slots; ++s)
      if(layout().slots[std::size_t(s)] != internal::no_index)
        result.push_back(std::size_t(layout().slots[std::size_t(s)]));
    const auto is_first = [&](const std::size_t h) { return patch(opposite(h)) == null_patch; };
    std::rotate(result.begin(), std::find_if(result.begin(), result.end(), is_first),
                result.end());
    return result;
  }

  /// @}

  /// \name Arcs
  /// @{

  /// returns the number of arcs.
  std::size_t number_of_arcs() const { return layout().arcs.size(); }

  /// returns the length of an arc in the domain; 0 if it does not lie on an isocurve.
  Exact_rational arc_length(const std::size_t a) const { return layout().arcs[a].length.exact(); }

  /// returns whether an arc runs along the border or along features.
  bool arc_is_constrained(const std::size_t a) const { return layout().arcs[a].is_wall; }

  /// returns whether an arc lies on an isocurve: all arcs do, except for arcs on
  /// borders that do not lie on isocurves.
  bool arc_is_isocurve(const std::size_t a) const { return !layout().arcs[a].is_oblique; }

  /// returns the course of an arc, from its source to its target: both nodes, and between them the
  /// points at which it crosses edges or meets vertices; rounded.
  std::vector<Location> arc_path(const std::size_t a) const
  {
    const internal::Protect_exact_arithmetic protect;
    std::vector<Location> result;
    for(const internal::Face_point& p :
        internal::path_of_arc(chart_mesh(), m_data->race->curves(), layout(), a))
      result.push_back(location(p));
    return result;
  }

  /// @}

  /// \name Half-arcs
  /// @{

  /// returns the arc of a half-arc.
  static std::size_t arc(const std::size_t h) { return h / 2; }

  /// returns the other half of the arc.
  static std::size_t opposite(const std::size_t h) { return h ^ 1; }

  /// returns the node at which a half-arc begins.
  std::size_t source(const std::size_t h) const { return std::size_t(layout().source(index(h))); }

  /// returns the node at which a half-arc ends.
  std::size_t target(const std::size_t h) const { return std::size_t(layout().target(index(h))); }

  /// returns the next half-arc around the same patch, or along the border.
  std::size_t next(const std::size_t h) const
  { return std::size_t(layout().half(index(h)).next); }

  /// returns the patch at the left of a half-arc, `null_patch` outside of the border.
  std::size_t patch(const std::size_t h) const
  {
    const internal::Patch_index p = layout().half(index(h)).patch;
    return p == internal::no_index ? null_patch : std::size_t(p);
  }

  /// @}

  /// \name Patches
  /// @{

  /// returns the number of patches.
  std::size_t number_of_patches() const { return layout().patches.size(); }

  /// returns whether a patch is cut by a border that does not lie on isocurves. Otherwise it is a
  /// rectangle.
  bool patch_is_cut(const std::size_t p) const { return layout().patches[p].is_cut; }

  /// returns the number of patches that are cut.
  std::size_t number_of_cut_patches() const
  {
    const auto& patches = layout().patches;
    return std::size_t(std::count_if(patches.begin(), patches.end(),
                                     [](const internal::Layout_patch& p) { return p.is_cut; }));
  }

  /// returns the half-arcs around a patch: one cycle for a rectangle, which starts at a corner; any
  /// number for a patch that is cut. Each has the patch at its left.
  std::vector<std::vector<std::size_t> > patch_cycles(const std::size_t p) const
  {
    std::vector<std::vector<std::size_t> > result;
    for(const auto& cycle : layout().patches[p].cycles)
      result.emplace_back(cycle.begin(), cycle.end());
    return result;
  }

  /// returns the Euler characteristic of a patch: 1 if it is a disk, as all rectangles are.
  std::ptrdiff_t patch_euler_characteristic(const std::size_t p) const
  { return layout().patches[p].euler_characteristic; }

  /// returns the area of a patch in the domain.
  Exact_rational patch_area(const std::size_t p) const
  {
    return patch_is_cut(p) ? layout().patches[p].area
                           : Exact_rational(patch_width(p) * patch_height(p));
  }

  /// returns the half-arcs of side 0, 1, 2, or 3 of a patch, counterclockwise; none if it is cut.
  std::vector<std::size_t> patch_side(const std::size_t p, const std::size_t side) const
  {
    const auto& halves = layout().patches[p].sides[side];
    return std::vector<std::size_t>(halves.begin(), halves.end());
  }

  /// returns the length of sides 0 and 2 of a patch; 0 if it is cut.
  Exact_rational patch_width(const std::size_t p) const
  { return layout().patches[p].width.exact(); }

  /// returns the length of sides 1 and 3 of a patch; 0 if it is cut.
  Exact_rational patch_height(const std::size_t p) const
  { return layout().patches[p].height.exact(); }

  /// @}

private:
  const internal::Layout& layout() const { return m_data->layout; }
  const internal::Chart_mesh& chart_mesh() const { return m_data->domain.mesh; }
  const internal::Layout_point& point(const std::size_t n) const { return layout().points[n]; }
  static internal::Half_arc_index index(const std::size_t h)
  { return internal::Half_arc_index(h); }

  const TriangleMesh* m_tmesh;
  std::shared_ptr<const Numbering> m_numbering;
  std::shared_ptr<const internal::Layout_data> m_data;
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The meeting of two curves of a layout, for a stop policy. The first curve comes to a point at which
the second curve has been before. If both come at the same time, the first curve is the one that has
the other curve on its right.

\tparam TriangleMesh the type of the mesh
*/
template <typename TriangleMesh>
struct Curve_meeting
{
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  vertex_descriptor start;        ///< the start of the first curve
  vertex_descriptor other_start;  ///< the start of the second curve
  Exact_rational length;          ///< the length of the first curve up to the point
  Exact_rational other_length;    ///< the length of the second curve up to the point
};

namespace internal {

// The vertices that the caller has given as nodes; empty if there are none.
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

// At a vertex with several fans of faces, the layout has more vertices than the mesh.
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
  options.maximum_number =
    chosen(np, CGAL::internal_np::maximum_number,
           (std::max)(std::size_t(1000000), 10 * numbering.halfedges_of_corners().size()));
  const auto policy = get_parameter(np, CGAL::internal_np::curve_stop_policy);
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
  input.align_border = chosen(np, CGAL::internal_np::align_border, false);
  input.options = race_options(tmesh, numbering, data, np);
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(tmesh, np);
  input.vertex_name = [&](const std::size_t v) {
    const Corner_index h = data.domain.mesh.corner_at_vertex[v];
    return name_of_vertex(std::size_t(
      get(vertex_indices, target(numbering.halfedges_of_corners()[std::size_t(h)], tmesh))));
  };
  make_layout(std::move(input), data);
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

divides a surface into rectangles along isocurves of an exactly seamless parametrization.

Curves start at the <em>nodes</em> in all directions along which a coordinate is constant, at the
same time and with the same speed. Nodes are the cones, the vertices at which borders and features
end, meet, or turn, given vertices, and one vertex in each part of the surface that has no other
node. A curve ends at nodes, borders, features, and at a point that another curve has passed before.
If two curves come to a point at the same time, the curve that has the other one on its right ends.
Two curves that meet head-on become one arc. With another `curve_stop_policy`, curves run on across
each other.

\par Guarantee
Let the parametrization be exactly seamless, let all faces be positive in the domain, and let
borders and features lie on isocurves. Then all curves end, and they divide the surface into
rectangles: disks with four corners whose opposite sides have exactly the same length. The areas of
the rectangles add up to the area of the domain. A cone of index \f$ i \f$ has \f$ 4 - i \f$ arcs.
The function checks all conditions before, and the rectangles afterwards, exactly.

\par Borders off isocurves
If a border does not lie on isocurves, curves end at it. Only given vertices, and vertices at which
it meets aligned borders and features, start curves. The patches at such a border are <em>cut</em>:
they can have any shape, and need not be disks. With `align_border(true)`, such a border is refused.

\par Order
The graph does not depend on the order of faces and vertices, except for the numbering, and for the
choice among several vertices with the same coordinates in a part without nodes.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh; the graph refers to it
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below, and `tolerance`, `edge_is_cut_map`, `halfedge_rotation_map`, `rotational_symmetry`,
       and `vertex_index_map` of `seam_transitions()`; `rotational_symmetry` must be of order 4, 2,
       or 1

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges, which become arcs and have to lie on isocurves. Border
                          edges always become arcs.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether all border edges have to lie on isocurves. Otherwise, patches that
                          such a border cuts need not be rectangles.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{further vertices that are nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no vertex is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{curve_stop_policy}
    \cgalParamDescription{whether a curve ends at a curve that it meets (which can be the curve
                          itself). For the same meeting, the answer must always be the same. At
                          nodes, borders, and features, curves always end.}
    \cgalParamType{a function object that returns `bool` for a `Curve_meeting<TriangleMesh>`, such
                   as `Stop_at_curves` and `Run_to_nodes`}
    \cgalParamDefault{`Stop_at_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{a bound for the number of segments of all curves, and for the number of
                          points at which two curves meet, or would meet if they ran on. Above it,
                          the function gives up. It bounds the memory: some hundred bytes for each
                          segment and point.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{30 times the number of faces, but at least a million}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the graph; converts to `true` if and only if the surface is divided. Otherwise
        `Motorcycle_graph::status()` is a status of `Seam_transitions::failure()`, or
        - `INVALID_ARGUMENT`: the mesh has no face;
        - `NOT_SEAMLESS`: the parametrization is not exactly seamless;
        - `NOT_POSITIVE`: faces are flipped or degenerate in the domain;
        - `NOT_ALIGNED`: a feature edge, or, with `align_border`, a border edge, lies on no
          isocurve;
        - `TOO_LARGE`: there are more segments or meetings of curves than `maximum_number`;
        - `INTERNAL_ERROR`: the patches failed the check at the end.
        .
        The message names the place and the remedy.

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
    constexpr auto read =
      internal::surface_parameters +
      internal::named<CGAL::internal_np::curve_stop_policy, CGAL::internal_np::maximum_number,
                      CGAL::internal_np::vertex_is_constrained>;
    internal::read_and_make_layout(tmesh, *numbering, uv_map, internal::strip(np, read), *data);
    return Motorcycle_graph<TriangleMesh>(tmesh, numbering, data);
  }
}

namespace internal {

template <typename TriangleMesh>
bool bounds_rectangle(const Motorcycle_graph<TriangleMesh>& graph, const std::size_t arc)
{
  for(const std::size_t h : {2 * arc, 2 * arc + 1})
    if(graph.patch(h) != graph.null_patch && !graph.patch_is_cut(graph.patch(h)))
      return true;
  return false;
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The lengths of the arcs of a layout, as integers.
*/
struct Integer_arc_lengths
{
  std::vector<Exact_integer> lengths; ///< per arc, in multiples of the unit; 0 if it bounds no
                                      ///< rectangle
  Exact_rational unit{1};             ///< a power of two
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

returns the lengths of all arcs that bound rectangles, in multiples of a unit: the largest power of
two of which all of them are integer multiples. Such a unit always exists, because the coordinates
of the ends of arcs are dyadic numbers. These lengths are a quantization of the layout at a scale
that is far too fine; see `are_lengths_consistent()`.

\tparam TriangleMesh the type of the mesh
\param graph the layout

\pre `bool(graph)`

\par Complexity
Linear in the number of arcs, times the bits of their lengths.
*/
template <typename TriangleMesh>
Integer_arc_lengths integer_arc_lengths(const Motorcycle_graph<TriangleMesh>& graph)
{
  using Fraction_traits = CGAL::Fraction_traits<Exact_rational>;
  typename Fraction_traits::Numerator_type numerator;
  typename Fraction_traits::Denominator_type denominator;
  Integer_arc_lengths result;
  bool is_first = true;
  // The unit is the least power of two that any length is an odd multiple of.
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a) {
    if(!internal::bounds_rectangle(graph, a))
      continue;
    typename Fraction_traits::Decompose()(graph.arc_length(a), numerator, denominator);
    Exact_rational unit(Exact_rational(1) / Exact_rational(denominator));
    for(; Exact_integer(numerator % 2) == 0; numerator = Exact_integer(numerator / 2))
      unit = Exact_rational(unit * 2);
    if(is_first || unit < result.unit)
      result.unit = unit;
    is_first = false;
  }
  result.lengths.assign(graph.number_of_arcs(), Exact_integer(0));
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a)
    if(internal::bounds_rectangle(graph, a)) {
      typename Fraction_traits::Decompose()(Exact_rational(graph.arc_length(a) / result.unit),
                                            numerator, denominator);
      result.lengths[a] = numerator;
    }
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

returns whether given lengths of the arcs fit: in each patch that is a rectangle, opposite sides
have the same length. With positive integers, each rectangle can then be filled by a grid of quads
that fits the grids of its neighbors. The number of all quads is the sum of width times height.

\tparam TriangleMesh the type of the mesh
\tparam Length a number type with exact sums
\param graph the layout
\param lengths one length per arc

\pre `bool(graph)`, and `lengths.size() == graph.number_of_arcs()`

\par Complexity
Linear in the number of arcs.
*/
template <typename TriangleMesh, typename Length>
bool are_lengths_consistent(const Motorcycle_graph<TriangleMesh>& graph,
                            const std::vector<Length>& lengths)
{
  const auto length_of_side = [&](const std::size_t p, const std::size_t side) {
    Length sum(0);
    for(const std::size_t h : graph.patch_side(p, side))
      sum += lengths[graph.arc(h)];
    return sum;
  };
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    if(length_of_side(p, 0) != length_of_side(p, 2) || length_of_side(p, 1) != length_of_side(p, 3))
      return false;
  return true;
}

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_MOTORCYCLE_GRAPH_H
