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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_H
#define CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Where isocurves start, and what they are when traced: sequences of crossed edges and met
// vertices, or of segments.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A point of the surface at which an isocurve starts, together with the chart that its direction
refers to.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
struct Isocurve_start
{
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  Isocurve_place place = Isocurve_place::VERTEX; ///< what the point lies on
  halfedge_descriptor halfedge{};   ///< of the face whose chart is meant
  Exact_rational parameter{0};      ///< on an edge: 0 at its source, 1 at its target
  std::array<double, 2> uv{{0, 0}}; ///< in a face: the coordinates of the point

  /*!
  the target of `h`. The direction refers to the chart of `face(h)`. The curve need not leave
  through this face: it takes the ray of this direction that is nearest to it, when the direction is
  carried around the vertex; around a regular vertex there is only one.
  \pre `h` has a face
  */
  static Isocurve_start at_vertex(const halfedge_descriptor h)
  { return {Isocurve_place::VERTEX, h, Exact_rational(0), {{0, 0}}}; }

  /*!
  the point \f$ (1-t) a + t b \f$ of the edge from \f$ a \f$ to \f$ b \f$.
  \pre `h` has a face, and `t` is larger than 0 and smaller than 1
  */
  static Isocurve_start on_edge(const halfedge_descriptor h, const Exact_rational& t)
  { return {Isocurve_place::EDGE, h, t, {{0, 0}}}; }

  /*!
  the point of `face(h)` with these coordinates in its chart.
  \pre the point lies in the face, not at one of its vertices
  */
  static Isocurve_start in_face(const halfedge_descriptor h, const double u, const double v)
  { return {Isocurve_place::FACE, h, Exact_rational(0), {{u, v}}}; }
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A point of a traced isocurve: an edge that is crossed, a vertex that is met, or the point of a face
at which the curve starts. Where two consecutive points are vertices, the curve runs along the edge
between them.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
class Isocurve_point
{
public:
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// \cond SKIP_IN_MANUAL
  Isocurve_point() = default;
  Isocurve_point(const Isocurve_place place, const halfedge_descriptor h,
                 const Isocurve_direction direction, const internal::Exact_level& level,
                 const double running = 0)
    : m_halfedge(h), m_place(place), m_direction(static_cast<unsigned char>(direction)),
      m_level(level), m_running(running)
  { }
  const internal::Exact_level& level() const { return m_level; }
  double running_coordinate() const { return m_running; }
  /// \endcond

  /// returns what the point lies on.
  Isocurve_place place() const { return m_place; }

  /// returns for an edge the halfedge of the face that the curve leaves; for a vertex a halfedge
  /// that points to it, of a face that the curve has come through or along or, where it starts,
  /// that it goes through or along; for a face one of its halfedges.
  halfedge_descriptor halfedge() const { return m_halfedge; }

  /// returns the direction of the curve in the chart of `face(halfedge())`.
  Isocurve_direction direction() const { return Isocurve_direction(m_direction); }

  /// returns what is constant along the curve, in this chart, exactly: \f$ u \f$, \f$ v \f$, or
  /// in lattice coordinates \f$ u + v \f$.
  Exact_rational constant_coordinate() const { return m_level.exact(); }

  /// returns the same, rounded.
  double approximate_constant_coordinate() const { return m_level.approximation(); }

private:
  halfedge_descriptor m_halfedge{};
  Isocurve_place m_place = Isocurve_place::VERTEX;
  unsigned char m_direction = 0;
  internal::Exact_level m_level;
  double m_running = 0;
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A traced isocurve.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
struct Isocurve
{
  Isocurve_status status = Isocurve_status::MAXIMUM_NUMBER; ///< how it ends
  Isocurve_start<TriangleMesh> start;                      ///< where it starts
  Isocurve_direction direction = Isocurve_direction::PLUS_U; ///< in which direction
  std::size_t number_of_crossings = 0; ///< edges crossed and vertices passed
  double length = 0;                   ///< from the start to the end; 0 unless it was bounded
  std::vector<Isocurve_point<TriangleMesh> > points; ///< from the start to the end
};

namespace internal {

// u, v, or u + v.
inline Exact_rational exact_component(const Uv& u, const std::size_t c)
{
  return c < 2 ? Exact_rational(u[c]) : Exact_rational(Exact_rational(u[0]) + Exact_rational(u[1]));
}

inline double rounded_component(const Uv& u, const std::size_t c)
{
  return c < 2 ? u[c] : u[0] + u[1];
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the position of a point on an edge: 0 at the source of `point.halfedge()`, 1 at its target.
It is exact where the curve crosses the edge. Where the curve starts on the edge and runs along it,
the position is computed from the rounded coordinates of the start.

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner

\pre `point.place()` is `Isocurve_place::EDGE`, and the ends of the edge differ in the domain
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
Exact_rational isocurve_parameter(const Isocurve_point<TriangleMesh>& point,
                                  const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  const internal::Uv a = internal::get_uv(uv_map, prev(point.halfedge(), tmesh)),
                     b = internal::get_uv(uv_map, point.halfedge());
  const auto parameter = [](const Exact_rational& x, const Exact_rational& from,
                            const Exact_rational& to)
  { return Exact_rational((x - from) / (to - from)); };
  const std::size_t c = internal::constant_component(point.direction());
  const Exact_rational from = internal::exact_component(a, c), to = internal::exact_component(b, c);
  if(from != to)
    return parameter(point.constant_coordinate(), from, to);
  const std::size_t k = internal::other_coordinate(point.direction());
  return parameter(Exact_rational(point.running_coordinate()), Exact_rational(a[k]),
                   Exact_rational(b[k]));
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the coordinates of a point in the chart of `face(point.halfedge())`, rounded.

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
std::array<double, 2> isocurve_uv(const Isocurve_point<TriangleMesh>& point,
                                  const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  const internal::Protect_exact_arithmetic protect;
  const std::size_t c = internal::constant_component(point.direction()),
                    k = internal::other_coordinate(point.direction());
  const internal::Uv b = internal::get_uv(uv_map, point.halfedge());
  if(point.place() == Isocurve_place::VERTEX)
    return b;
  const double level = point.approximate_constant_coordinate();
  double running = point.running_coordinate();
  if(point.place() == Isocurve_place::EDGE) {
    const internal::Uv a = internal::get_uv(uv_map, prev(point.halfedge(), tmesh));
    const double from = internal::rounded_component(a, c), to = internal::rounded_component(b, c);
    if(from != to) // else the curve starts here, and runs along the edge
      running = a[k] + (level - from) / (to - from) * (b[k] - a[k]);
  }
  internal::Uv result;
  result[k] = running;
  result[1 - k] = c < 2 ? level
                        : point.level().minus(internal::Exact_level(running)).approximation();
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

returns the place of a point in space, rounded.

\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional
        point as value type

\param point a point of a curve that was traced on `tmesh` with `uv_map`
\param tmesh the mesh
\param uv_map the coordinates of each corner
\param vertex_point_map the points of the vertices
*/
template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexPointMap>
typename boost::property_traits<VertexPointMap>::value_type
isocurve_point_3(const Isocurve_point<TriangleMesh>& point, const TriangleMesh& tmesh,
                 const HalfedgeUVMap& uv_map, const VertexPointMap& vertex_point_map)
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point_3>::Kernel::FT;
  const internal::Protect_exact_arithmetic protect;
  const auto h = point.halfedge();
  const Point_3 q = get(vertex_point_map, target(h, tmesh));
  if(point.place() == Isocurve_place::VERTEX)
    return q;
  const Point_3 p = get(vertex_point_map, source(h, tmesh));
  const Point_3 r = get(vertex_point_map, target(next(h, tmesh), tmesh));
  const internal::Uv a = internal::get_uv(uv_map, prev(h, tmesh)), b = internal::get_uv(uv_map, h),
                     c = internal::get_uv(uv_map, next(h, tmesh)),
                     x = isocurve_uv(point, tmesh, uv_map);
  // barycentric coordinates of b and c
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  double s = ((x[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (x[1] - a[1])) / area;
  double t = ((b[0] - a[0]) * (x[1] - a[1]) - (x[0] - a[0]) * (b[1] - a[1])) / area;
  if(point.place() == Isocurve_place::EDGE) {
    std::size_t k = 1 - internal::other_coordinate(point.direction());
    k = (a[k] == b[k]) ? 1 - k : k;
    s = (a[k] == b[k]) ? 0.5 : (x[k] - a[k]) / (b[k] - a[k]);
    t = 0;
  }
  return Point_3(p + FT(s) * (q - p) + FT(t) * (r - p));
}

namespace internal {

// Where a member function hides the one of the mesh.
template <typename TriangleMesh, typename Halfedge>
auto face_of_halfedge(const Halfedge h, const TriangleMesh& tmesh)
{
  return face(h, tmesh);
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

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

#endif // CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_H
