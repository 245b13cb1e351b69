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

#ifndef CGAL_SEAMLESS_SNAPPING_SEAM_TRANSITIONS_H
#define CGAL_SEAMLESS_SNAPPING_SEAM_TRANSITIONS_H

#include <CGAL/license/Seamless_snapping.h>

// The seams of a uv map: its cut edges, the rotations of charts across them, and its singular
// vertices.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/singular_vertices.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingVerifying

The transitions of a parametrization, the cut edges, and the singular vertices, as returned by
`seam_transitions()`.

The transition of an interior halfedge `h` is a number of turns by \f$ 360 / N \f$ degrees, quarter
turns by default, which rotate the chart of `face(h)` into the chart of `face(opposite(h))`. Member
functions take constant time. An object is valid until the mesh is modified. It must not outlive the
mesh, because it holds a dynamic property of its edges.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, and `VertexListGraph`
\tparam N the order of the rotational symmetry: 1, 2, 3, 4, or 6
*/
template <typename TriangleMesh, int N = 4>
class Seam_transitions
{
public:
  /// `N`
  static constexpr int order = N;

  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// an interior vertex and its index in turns by 360 / N degrees: with N = 4, 1 for a cone of 270
  /// degrees, -1 for a cone of 450
  using Singular_vertex = std::pair<vertex_descriptor, int>;

  /// \cond SKIP_IN_MANUAL
  template <typename HalfedgeUVMap>
  Seam_transitions(const TriangleMesh& tmesh,
                   const HalfedgeUVMap& uv_map,
                   internal::Transition_data<halfedge_descriptor>&& data)
    : m_tmesh(&tmesh)
    , m_index(get(CGAL::dynamic_edge_property_t<int>(), tmesh))
    , m_data(std::move(data))
  {
    for(std::size_t i = 0; i < m_data.edges.size(); ++i) {
      const halfedge_descriptor h = m_data.edges[i].halfedge;
      put(m_index, edge(h, tmesh), static_cast<int>(i) + 1);
      (m_data.edges[i].is_cut ? m_cut_halfedges : m_merged_halfedges).push_back(h);
    }
    if(*this) {
      const double scale = internal::unit_scale(m_data.extent);
      const internal::Uv_surface surface(tmesh, uv_map, internal::No_indices());
      auto found = internal::singular_vertices<Group>(surface, scale, N, m_data.edges);
      internal::add_full_turns<Group>(surface, scale, N, found);
      for(const auto& [h, index] : found)
        m_singular_vertices.emplace_back(target(h, tmesh), index);
    }
  }

  const internal::Transition_data<halfedge_descriptor>& data() const { return m_data; }
  /// \endcond

  /// returns `true` if the function has found the transitions.
  explicit operator bool() const { return !m_data.refusal; }

  /// returns the reason for a failure, as listed for `seam_transitions()`, or no value on success.
  std::optional<Outcome> failure() const
  {
    return m_data.refusal ? std::optional<Outcome>(m_data.refusal->status) : std::nullopt;
  }

  /// returns the place, the reason, and the remedy of a failure.
  Message message() const { return m_data.refusal ? m_data.refusal->message : Message(); }

  /// returns the number from 0 to N - 1 of counterclockwise turns by 360 / N degrees of the
  /// transition from the chart of `face(h)` to the chart of `face(opposite(h))`; 0 at the border.
  int rotation(const halfedge_descriptor h) const
  {
    const int i = index(h);
    if(i < 0)
      return 0;
    const auto& edge = m_data.edges[std::size_t(i)];
    return Group::turns(edge.halfedge == h ? edge.rotation : Group::inverse(edge.rotation), N);
  }

  /// returns `true` if the transition across the edge of `h` is not the identity.
  bool is_cut(const halfedge_descriptor h) const
  {
    const int i = index(h);
    return i >= 0 && m_data.edges[std::size_t(i)].is_cut;
  }

  /// returns one halfedge of each cut edge, in an order that is the same for all mesh data
  /// structures.
  const std::vector<halfedge_descriptor>& cut_halfedges() const { return m_cut_halfedges; }

  /// returns one halfedge of each edge that is no cut but has different coordinates on its sides.
  const std::vector<halfedge_descriptor>& merged_halfedges() const { return m_merged_halfedges; }

  /// returns the interior vertices around which the rotations do not add up to the identity; then
  /// the vertices with an angle of 720 degrees or a larger multiple of 360, if all faces around
  /// them are positive in the domain.
  const std::vector<Singular_vertex>& singular_vertices() const { return m_singular_vertices; }

  /// returns `true` if all transitions hold exactly and nothing is to be merged.
  bool is_exact() const { return m_data.is_exact; }

  /// returns the larger side of the bounding box of all coordinates.
  double extent() const { return m_data.extent; }

  /// returns the largest violation of a transition, which is the largest component of
  /// \f$ R (\mathbf{u}(b) - \mathbf{u}(a)) - (\mathbf{u}'(b) - \mathbf{u}'(a)) \f$ over the
  /// interior edges \f$ ab \f$; with N = 3 and 6, \f$ u + v \f$ counts as a component too.
  double violation() const { return m_data.violation; }

private:
  using Group = internal::Group_of_order<N>;
  using Edge_map =
    typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<int> >::const_type;

  // The open edge of `h`, or -1.
  int index(const halfedge_descriptor h) const { return get(m_index, edge(h, *m_tmesh)) - 1; }

  const TriangleMesh* m_tmesh;
  Edge_map m_index; // the index of an open edge, plus 1
  internal::Transition_data<halfedge_descriptor> m_data;
  std::vector<halfedge_descriptor> m_cut_halfedges, m_merged_halfedges;
  std::vector<Singular_vertex> m_singular_vertices;
};

/*!
\ingroup PkgSeamlessSnappingVerifying

computes the transitions of a uv map: which edges are cuts, and the rotation and translation across
each.

If the two sides of an edge have the same coordinates, bit for bit, the edge is no cut. Otherwise,
the function estimates the seams: it chooses the topology that explains the coordinates with the
smallest residuals.
-# It measures the noise at an edge: the largest residual of the best rotations within a few edges.
   If corners differ along most edges of a vertex, the median of their gaps counts as well.
-# If only one rotation is within twice the noise, the edge takes this rotation.
-# Any other edge takes the rotation of its branch, or the rotation that fits best. If corners have
   noise of their own, it takes the rotation that leaves no cone at an end whose other edges are
   decided. If no end decides, the edge is no cut if its gap is within the noise.
-# A chain of edges without rotation is no cut if the mean of its gaps is not much larger than the
   largest residual in its connected component of the seams. The two sides of such an edge are
   <em>merged</em>: they count as equal.

If you know the cuts and rotations, pass `edge_is_cut_map` and `halfedge_rotation_map`: then the
function does not estimate.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh: any number of components, of any genus, with or without border
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Values of border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `tolerance`,
       `edge_is_cut_map`, `halfedge_rotation_map`, `rotational_symmetry`, and `vertex_index_map` of
       `snap_to_seamless()`. A smaller \f$ N \f$ makes short edges easier to decide.

\return the transitions, or the reason why the function found none; test with `operator bool()`.
        Then `Seam_transitions::failure()` is
        - `INVALID_ARGUMENT`: the tolerance is negative, or the given indices of vertices are not
          unique or out of range;
        - `NOT_TRIANGULAR`: a face has more or less than three corners;
        - `NOT_FINITE`: a coordinate is NaN, infinite, or beyond 1e300;
        - `NOT_SEAMLESS`: no rotation fits the two sides of an edge up to the tolerance;
        - `INVALID_ROTATIONS`: the given rotations of opposite halfedges are not inverse to each
          other, or an edge that is given as no cut has a rotation;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`.

\par Complexity
One pass over the edges and one over the faces, plus \f$ O(c \log c) \f$ for \f$ c \f$ edges whose
sides differ.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Seam_transitions<TriangleMesh, N>
#else
auto
#endif
seam_transitions(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  using Parameters = std::decay_t<decltype(internal::strip(np))>;
  using Group = internal::Symmetry_group<Parameters>;
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
    internal::Transition_data<Halfedge> data;
    data.refusal = internal::inexact_arithmetic();
    if(!data.refusal)
      data = internal::read_transitions<Group>(
        tmesh, uv_map, internal::strip(np, internal::surface_parameters));
    return Seam_transitions<TriangleMesh, internal::order_of_symmetry<Parameters> >(
      tmesh, uv_map, std::move(data));
  }
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_SEAM_TRANSITIONS_H
