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

// A partition of a surface into rectangles along isocurves: nodes, arcs, and patches.

#include <CGAL/Isocurves_and_layouts/internal/layout/arc_path.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/Exact_rational.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

What a node of a motorcycle graph is.
*/
enum class Layout_node
{
  CONE,    ///< an interior vertex whose angle in the domain is not 360 degrees
  CORNER,  ///< a vertex at which borders and features end, meet, or turn
  GIVEN,   ///< a vertex that the caller has given
  SEED,    ///< a vertex chosen in a part of the surface without any other node, or on a closed
           ///< border or feature without any
  JUNCTION ///< where a curve ends at another one, or, if these run on, crosses it; or where it
           ///< ends at a border that does not lie on isocurves
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

A partition of a surface into rectangles along isocurves of an exactly seamless parametrization, as
`motorcycle_graph()` makes them. Nodes, arcs, half-arcs, and patches are numbered from 0.

Each arc is a piece of an isocurve between two nodes, of a length in the domain that is known
exactly. Arc `a` consists of the half-arcs `2 a` and `2 a + 1`, which run forward and back. Each has
a patch at its left, unless it runs along the border with the surface at its right. A patch is a
disc with four sides, each of one or more arcs, and opposite sides are of the same length. A node at
which another curve ends may thus lie inside of a side.

Where a border of the surface does not lie on isocurves, its pieces between nodes are arcs, too.
The patches there are cut: they have no sides, and can have any number of cycles of half-arcs around
them. Corners of such a border are no nodes.

The graph refers to the mesh, and stays valid as long as that is neither modified nor destroyed.
Copies share what they hold.

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

  /// returns the place, the reason, and the remedy, unless the surface is divided; then, what there
  /// is to say of a border that does not lie on isocurves.
  const std::string& message() const { return m_data->message; }

  /// returns the faces that are flipped or degenerate in the domain, in the order of iteration over
  /// all faces, from 0. If there are any, the outcome is `NOT_POSITIVE`.
  const std::vector<std::size_t>& nonpositive_faces() const { return m_data->nonpositive_faces; }

  /// returns how many segments of curves were visited: pieces in one face, or along one edge.
  std::size_t number_of_visited_segments() const
  { return m_data->race ? m_data->race->number_of_segments() : 0; }

  /// @}

  /// \name Nodes
  /// @{

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return layout().points.size(); }

  /// returns what a node is.
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

  /// returns what a node lies on; for all nodes that are no junctions, `Isocurve_place::VERTEX`.
  Isocurve_place node_place(const std::size_t n) const { return point(n).place.place; }

  /// returns a halfedge: one that points to the vertex that the node is, or lies on the edge inside
  /// of which it lies; or else one of the face inside of which it lies.
  halfedge_descriptor node_halfedge(const std::size_t n) const
  { return m_numbering->halfedges_of_corners()[std::size_t(point(n).place.halfedge)]; }

  /// returns the coordinates of a node in the chart of `face(node_halfedge(n))`.
  std::array<Exact_rational, 2> node_coordinates(const std::size_t n) const
  {
    const internal::Exact_uv& uv = point(n).place.uv;
    return {uv[0].exact(), uv[1].exact()};
  }

  /// returns where a node lies on the mesh; rounded.
  Location node_location(const std::size_t n) const
  {
    const internal::Protect_exact_arithmetic protect;
    return location(internal::face_point(chart_mesh(), point(n).place));
  }

  /// returns the half-arcs that leave a node, counterclockwise. At the border, the first one is
  /// that which has the surface only at its left.
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

  /// returns whether an arc lies on an isocurve: all do, but for those on borders that don't.
  bool arc_is_isocurve(const std::size_t a) const { return !layout().arcs[a].is_oblique; }

  /// returns the course of an arc, from its source to its target: both nodes, and between them the
  /// points where it crosses edges or meets vertices; rounded.
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

  /// returns the Euler characteristic of a patch: 1 if it is a disc, as all rectangles are.
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

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_MOTORCYCLE_GRAPH_H
