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

#ifndef CGAL_SEAMLESS_SNAPPING_ISOCURVE_SEGMENT_H
#define CGAL_SEAMLESS_SNAPPING_ISOCURVE_SEGMENT_H

#include <CGAL/license/Seamless_snapping.h>

// The part of an isocurve in one face, or along one edge.

#include <CGAL/Seamless_snapping/Isocurve_direction.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/tracing/Segment_walker.h>

#include <CGAL/Exact_rational.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

// Where a member function hides the one of the mesh.
template <typename TriangleMesh, typename Halfedge>
auto face_of_halfedge(const Halfedge h, const TriangleMesh& tmesh)
{
  return face(h, tmesh);
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingTracing

The part of an isocurve in one face, or along one edge, with exact coordinates. All of them are
those of the chart of `face()`. Segments are made by `Isocurve_walker` and `isocurve_segments()`,
and are valid as long as the tracer is.

\tparam TriangleMesh a model of `FaceGraph`
\tparam D the number of directions, as for `Isocurve_tracer`
*/
template <typename TriangleMesh, int D = 4>
class Isocurve_segment
{
  using Group = internal::Rotation_group<D>;
  using Mesh = internal::Basic_chart_mesh<Group>;
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  /// a halfedge of the mesh
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  /// a face of the mesh
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// \cond SKIP_IN_MANUAL
  Isocurve_segment(const TriangleMesh& tmesh, const Mesh& mesh,
                   const internal::Flat_numbering<TriangleMesh>& numbering,
                   const internal::Chart_segment& segment)
    : m_tmesh(&tmesh), m_mesh(&mesh), m_numbering(&numbering), m_segment(segment)
  { }
  const internal::Chart_segment& chart_segment() const { return m_segment; }
  /// \endcond

  /// returns the face that the segment lies in. Where it lies along an edge, this is one of the two
  /// faces of the edge.
  face_descriptor face() const
  { return internal::face_of_halfedge(entry(), *m_tmesh); }

  /// returns what the segment begins on: `Isocurve_place::FACE` only at the start of a curve.
  Isocurve_place entry_place() const { return m_segment.entry.place; }

  /// returns a halfedge of `face()`: that which points to the vertex, or which lies on the edge, at
  /// which the segment begins.
  halfedge_descriptor entry() const { return halfedge(m_segment.entry.halfedge); }

  /// returns what the segment ends on: `Isocurve_place::FACE` only where a curve closes that has
  /// started there.
  Isocurve_place exit_place() const { return m_segment.exit.place; }

  /// returns a halfedge of `face()`: that which points to the vertex, or which lies on the edge, at
  /// which the segment ends.
  halfedge_descriptor exit() const { return halfedge(m_segment.exit.halfedge); }

  /// returns `true` if the segment lies along an edge: then it belongs to both faces of the edge.
  bool is_along_edge() const { return m_segment.along != internal::no_index; }

  /// returns the halfedge of `face()` on which the segment lies, in either direction.
  /// \pre `is_along_edge()`
  halfedge_descriptor edge_halfedge() const { return halfedge(m_segment.along); }

  /// returns the direction of the curve.
  Isocurve_direction direction() const
  { return internal::isocurve_direction<Group>(m_segment.direction); }

  /// returns what is constant along the curve: \f$ u \f$, \f$ v \f$, or in lattice coordinates
  /// \f$ u + v \f$.
  Exact_rational constant_coordinate() const { return m_segment.level.exact(); }

  /// returns the other coordinate where the segment begins; \f$ v \f$ where \f$ u + v \f$ is
  /// constant.
  Exact_rational from() const
  { return internal::other_coordinate<Group>(m_segment, running_from(*m_mesh, m_segment)); }

  /// returns the same where the segment ends.
  Exact_rational to() const
  { return internal::other_coordinate<Group>(m_segment, running_to(*m_mesh, m_segment)); }

  /// returns the length of the curve in the domain, from its start to where the segment begins.
  /// What it goes back in flipped faces is subtracted. In lattice coordinates, the unit is the same
  /// in all directions: the side of the triangles of the lattice.
  Exact_rational length_before() const
  { return internal::length_up_to<Group>(m_segment, running_from(*m_mesh, m_segment)); }

  /// returns the same from its start to where the segment ends.
  Exact_rational length_after() const
  { return internal::length_up_to<Group>(m_segment, running_to(*m_mesh, m_segment)); }

private:
  halfedge_descriptor halfedge(const internal::Corner_index h) const
  { return m_numbering->halfedges_of_corners()[std::size_t(h)]; }

  const TriangleMesh* m_tmesh;
  const Mesh* m_mesh;
  const internal::Flat_numbering<TriangleMesh>* m_numbering;
  internal::Chart_segment m_segment;
};

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_ISOCURVE_SEGMENT_H
