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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_WALKER_H
#define CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_WALKER_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Isocurves a segment at a time, which the caller continues or leaves.

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Isocurves_and_layouts {

namespace internal {

// For places at which a member function hides the function of the mesh.
template <typename TriangleMesh, typename Halfedge>
auto face_of_halfedge(const Halfedge h, const TriangleMesh& tmesh)
{
  return face(h, tmesh);
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

The part of an isocurve in one face, or along one edge, with exact coordinates in the chart of
`face()`. `Isocurve_walker` and `isocurve_segments()` make segments, which are valid as long as the
tracer is.

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

  /// returns the face that the segment lies in. If it lies along an edge, this is one of the two
  /// faces of the edge.
  face_descriptor face() const
  { return internal::face_of_halfedge(entry(), *m_tmesh); }

  /// returns the element at which the segment begins: `Isocurve_place::FACE` only at the start of a
  /// curve.
  Isocurve_place entry_place() const { return m_segment.entry.place; }

  /// returns the halfedge of `face()` that points to the vertex at which the segment begins, or
  /// that lies on the edge at which it begins.
  halfedge_descriptor entry() const { return halfedge(m_segment.entry.halfedge); }

  /// returns the element at which the segment ends: `Isocurve_place::FACE` only if a curve closes
  /// that has started in the face.
  Isocurve_place exit_place() const { return m_segment.exit.place; }

  /// returns the halfedge of `face()` that points to the vertex at which the segment ends, or that
  /// lies on the edge at which it ends.
  halfedge_descriptor exit() const { return halfedge(m_segment.exit.halfedge); }

  /// returns `true` if the segment lies along an edge: then it belongs to both faces of the edge.
  bool is_along_edge() const { return m_segment.along != internal::no_index; }

  /// returns the halfedge of `face()` on which the segment lies, in either direction.
  /// \pre `is_along_edge()`
  halfedge_descriptor edge_halfedge() const { return halfedge(m_segment.along); }

  /// returns the direction of the curve.
  Isocurve_direction direction() const
  { return internal::isocurve_direction<Group>(m_segment.direction); }

  /// returns the constant coordinate of the curve: \f$ u \f$, \f$ v \f$, or in lattice coordinates
  /// \f$ u + v \f$.
  Exact_rational constant_coordinate() const { return m_segment.level.exact(); }

  /// returns the other coordinate at the beginning of the segment; \f$ v \f$ if \f$ u + v \f$ is
  /// constant.
  Exact_rational from() const
  { return internal::other_coordinate<Group>(m_segment, running_from(*m_mesh, m_segment)); }

  /// returns the other coordinate at the end of the segment.
  Exact_rational to() const
  { return internal::other_coordinate<Group>(m_segment, running_to(*m_mesh, m_segment)); }

  /// returns the length of the curve in the domain, from its start to the beginning of the segment.
  /// The way back in flipped faces is subtracted. In lattice coordinates, the unit is the same in
  /// all directions: the side of the triangles of the lattice.
  Exact_rational length_before() const
  { return internal::length_up_to<Group>(m_segment, running_from(*m_mesh, m_segment)); }

  /// returns the length of the curve in the domain, from its start to the end of the segment.
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

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

walks along an isocurve of an exactly seamless parametrization, one segment at a time. This is for
algorithms that trace many curves at once, or decide themselves when a curve ends. A copy goes on
independently.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam D the number of directions, as for `Isocurve_tracer`

\cgalModels{CopyConstructible, Assignable}
\sa `isocurve_segments()`
*/
template <typename TriangleMesh, int D = 4>
class Isocurve_walker
{
  using Group = internal::Rotation_group<D>;

public:
  using Tracer = Isocurve_tracer<TriangleMesh, D>;   ///< the tracer
  using Start = Isocurve_start<TriangleMesh>;        ///< the start of a curve
  using Segment = Isocurve_segment<TriangleMesh, D>; ///< a part of the curve

  /*!
  begins at a point, as `Isocurve_tracer::trace()` does.
  \param tracer has to outlive the walker
  \param start the start of the curve
  \param direction its direction in the chart of `face(start.halfedge)`
  \pre `start` is as `Isocurve_start` asks for
  */
  Isocurve_walker(const Tracer& tracer, const Start& start, const Isocurve_direction direction)
    : m_tracer(&tracer)
  {
    const internal::Protect_exact_arithmetic protect;
    if(tracer.is_exact())
      m_walker.emplace(tracer.chart_mesh(), internal::no_limits(), tracer.chart_start(start),
                       internal::chart_direction<Group>(direction));
  }

  /*!
  goes on to the next segment, which the first call finds at the start, and returns
  `Isocurve_status::CONTINUES`. If the curve has ended, it returns the end, and there is no further
  segment. The end is never `TARGET`, `MAXIMUM_NUMBER`, or `MAXIMUM_LENGTH`. It is `NOT_EXACT` if
  the parametrization is not exactly seamless.
  */
  Isocurve_status advance()
  {
    const internal::Protect_exact_arithmetic protect;
    return m_walker ? m_walker->advance() : Isocurve_status::NOT_EXACT;
  }

  /// returns the result of the last call of `advance()`.
  Isocurve_status status() const
  { return m_walker ? m_walker->status() : Isocurve_status::NOT_EXACT; }

  /*!
  returns the last segment.
  \pre a call of `advance()` has returned `Isocurve_status::CONTINUES`
  */
  Segment segment() const
  {
    return Segment(m_tracer->mesh(), m_tracer->chart_mesh(), m_tracer->correspondence(),
                   m_walker->segment());
  }

private:
  const Tracer* m_tracer;
  std::optional<internal::Basic_segment_walker<Group> > m_walker;
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

iterates over the segments of an isocurve, from its start to its end; see `isocurve_segments()`.

\cgalModels{InputIterator}
*/
template <typename TriangleMesh, int D = 4>
class Isocurve_segment_iterator
  : public boost::iterator_facade<Isocurve_segment_iterator<TriangleMesh, D>,
                                  const Isocurve_segment<TriangleMesh, D>,
                                  boost::single_pass_traversal_tag,
                                  Isocurve_segment<TriangleMesh, D> >
{
public:
  Isocurve_segment_iterator() = default; ///< the end of any curve

  /// \cond SKIP_IN_MANUAL
  Isocurve_segment_iterator(const Isocurve_walker<TriangleMesh, D>& walker,
                            const std::size_t number)
    : m_walker(walker), m_number_left(number)
  {
    increment();
  }
  /// \endcond

private:
  friend class boost::iterator_core_access;

  void increment()
  {
    if(m_number_left == 0 || m_walker->advance() != Isocurve_status::CONTINUES)
      m_walker.reset();
    else
      --m_number_left;
  }

  bool equal(const Isocurve_segment_iterator& other) const
  {
    return m_walker.has_value() == other.m_walker.has_value() &&
           (!m_walker || m_number_left == other.m_number_left);
  }

  Isocurve_segment<TriangleMesh, D> dereference() const { return m_walker->segment(); }

  std::optional<Isocurve_walker<TriangleMesh, D> > m_walker; // none at the end
  std::size_t m_number_left = 0;
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the segments of an isocurve as a range of `Isocurve_segment`, which walks along the curve
during the iteration. It ends like `trace_isocurve()` without bounds. On a map that is
not exactly seamless, it is empty.

\param tracer has to outlive the range
\param start the start of the curve
\param direction its direction in the chart of `face(start.halfedge)`
\pre `start` is as `Isocurve_start` asks for

\par Complexity
Constant for each segment that is iterated over, apart from the faces around vertices that are met.

\sa `Isocurve_walker`
*/
template <typename TriangleMesh, int D>
CGAL::Iterator_range<Isocurve_segment_iterator<TriangleMesh, D> >
isocurve_segments(const Isocurve_tracer<TriangleMesh, D>& tracer,
                  const Isocurve_start<TriangleMesh>& start, const Isocurve_direction direction)
{
  using Iterator = Isocurve_segment_iterator<TriangleMesh, D>;
  return {Iterator(Isocurve_walker<TriangleMesh, D>(tracer, start, direction),
                   (std::numeric_limits<std::size_t>::max)()), Iterator()};
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the segments of a curve that was traced exactly, as many as it has between its points.

\param tracer the tracer of the curve
\param curve a curve with its points

\par Complexity
As for a curve from its start.
*/
template <typename TriangleMesh, int D>
CGAL::Iterator_range<Isocurve_segment_iterator<TriangleMesh, D> >
isocurve_segments(const Isocurve_tracer<TriangleMesh, D>& tracer,
                  const Isocurve<TriangleMesh>& curve)
{
  using Iterator = Isocurve_segment_iterator<TriangleMesh, D>;
  return {Iterator(Isocurve_walker<TriangleMesh, D>(tracer, curve.start, curve.direction),
                   curve.points.empty() ? 0 : curve.points.size() - 1), Iterator()};
}

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_WALKER_H
