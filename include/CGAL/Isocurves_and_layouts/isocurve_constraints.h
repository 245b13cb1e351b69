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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_CONSTRAINTS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_CONSTRAINTS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Constraints from isocurves: connections and cycles along traced curves. And connections that
// hold, but are intercepted: their equation fixes the end of an isocurve if nothing is in its way,
// and tracing it finds whether something is.

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {

namespace internal {

// Appends the edges between two corners of a vertex: counterclockwise, or clockwise where the
// border is in the way.
template <typename TriangleMesh, typename Halfedge>
void turn_around_vertex(const TriangleMesh& tmesh, const Halfedge from, const Halfedge to,
                        std::vector<Halfedge>& path)
{
  const std::size_t n = path.size();
  Halfedge h = from;
  while(h != to && !is_border(opposite(h, tmesh), tmesh)) {
    path.push_back(h);
    h = prev(opposite(h, tmesh), tmesh);
  }
  if(h == to)
    return;
  path.resize(n);
  for(h = from; h != to; h = opposite(path.back(), tmesh))
    path.push_back(next(h, tmesh));
}

// The corner of the face of `h` at a vertex.
template <typename TriangleMesh, typename Halfedge, typename Vertex>
Halfedge corner_at(const TriangleMesh& tmesh, Halfedge h, const Vertex v)
{
  while(target(h, tmesh) != v)
    h = next(h, tmesh);
  return h;
}

// The corner that a curve ends at or, if it has missed a vertex, is about to pass by.
template <typename TriangleMesh>
auto corner_at_end(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  const Isocurve_point<TriangleMesh>& end = curve.points.back();
  if(end.place() == Isocurve_place::VERTEX)
    return end.halfedge();
  return next(opposite(end.halfedge(), tmesh), tmesh);
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsConstraints

returns the edges that a curve crosses, as the path of a `Connection_constraint` or
`Cycle_constraint`: `h` leads from `face(h)` to `face(opposite(h))`. The path begins in the face of
the first point of the curve and ends in the face of its last point. It leads around the vertices
that the curve passes.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`

\par Complexity
Linear in the number of points of the curve and of faces around the vertices that it passes.
*/
template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
isocurve_face_path(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> path;
  const auto go_on = [&](const Isocurve_point<TriangleMesh>& from, const auto to) {
    const auto h = from.halfedge();
    if(face(h, tmesh) == face(to, tmesh))
      return;
    if(from.place() == Isocurve_place::VERTEX)
      internal::turn_around_vertex(tmesh, h, internal::corner_at(tmesh, to, target(h, tmesh)),
                                   path);
    else
      path.push_back(h);
  };
  for(std::size_t i = 1; i < curve.points.size(); ++i)
    go_on(curve.points[i - 1], curve.points[i].halfedge());
  return path;
}

/*!
\ingroup PkgIsocurvesAndLayoutsConstraints

returns a connection constraint between the first and the last vertex of a curve.

If the status of the curve is `Isocurve_status::MISSED_TARGET`, the missed vertex takes the place of
the last one. To follow an isocurve on an approximately seamless parametrization, see the parameter
`decide_exactly` of `trace_isocurve()`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`

\return the constraint, for the named parameter `connection_constraints` of `snap_to_seamless()`

\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and ends at a vertex or has missed one

\par Complexity
Linear in the number of edges crossed, and of faces around the vertices met.

\sa `cycle_along_isocurve()`
*/
template <typename TriangleMesh>
Connection_constraint<TriangleMesh>
connection_along_isocurve(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  CGAL_precondition(!curve.points.empty());
  const Isocurve_point<TriangleMesh>& start = curve.points.front();
  CGAL_precondition(start.place() == Isocurve_place::VERTEX);
  CGAL_precondition(curve.status == Isocurve_status::MISSED_TARGET ||
                    curve.points.back().place() == Isocurve_place::VERTEX);
  Connection_constraint<TriangleMesh> result;
  result.a = start.halfedge();
  result.b = internal::corner_at_end(tmesh, curve);
  result.component = int(internal::constant_component(start.direction()));
  result.path = isocurve_face_path(tmesh, curve);
  if(curve.points.back().place() == Isocurve_place::EDGE)
    result.path.push_back(curve.points.back().halfedge());
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsConstraints

returns the constraint that the isocurve from the start vertex of a curve closes there. The
status of the curve is `Isocurve_status::CLOSED` or, if it passes by this vertex,
`Isocurve_status::SPIRALS`.

\param tmesh the mesh
\param curve a curve with its points, traced on `tmesh`
\pre the curve has its points (`trace_isocurve()` writes them to its output
     iterator instead), starts at a vertex, and has one of these statuses

\par Complexity
Linear in the number of edges crossed, and of faces around the vertices met.

\sa `connection_along_isocurve()`
*/
template <typename TriangleMesh>
Cycle_constraint<TriangleMesh>
cycle_along_isocurve(const TriangleMesh& tmesh, const Isocurve<TriangleMesh>& curve)
{
  CGAL_precondition(!curve.points.empty());
  const Isocurve_point<TriangleMesh>& start = curve.points.front();
  CGAL_precondition(start.place() == Isocurve_place::VERTEX);
  CGAL_precondition(curve.status == Isocurve_status::CLOSED ||
                    curve.status == Isocurve_status::SPIRALS);
  Cycle_constraint<TriangleMesh> result;
  result.corner = start.halfedge();
  result.component = int(internal::constant_component(start.direction()));
  result.path = isocurve_face_path(tmesh, curve);
  if(curve.points.back().place() == Isocurve_place::EDGE)
    result.path.push_back(curve.points.back().halfedge());
  internal::turn_around_vertex(tmesh, internal::corner_at_end(tmesh, curve), result.corner,
                               result.path);
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsConstraints

A connection constraint whose isocurve does not arrive, as `intercepted_connections()` finds it.
*/
struct Intercepted_connection
{
  std::size_t index;   ///< the place in the range of connections
  Message message;     ///< the constraint, and the end of its isocurve
};

namespace internal {

// From corner a to corner b of a connection, in the chart of a, as if the faces of the path lay in
// the plane. Rounded: it tells the direction, and about how far the isocurve has to go.
template <typename TriangleMesh, int D>
Uv displacement(const Isocurve_tracer<TriangleMesh, D>& tracer,
                const Connection_constraint<TriangleMesh>& connection)
{
  using Group = Rotation_group<D>;
  const Basic_chart_mesh<Group>& mesh = tracer.chart_mesh();
  const auto corner = [&](const auto h) { return tracer.correspondence().corner(h); };
  Uv u = mesh.uv(corner(connection.a));
  typename Group::Element g = Group::identity();
  for(const auto h : connection.path) {
    const auto t = mesh.corner(corner(h)).transition;
    if(t == no_index)
      continue;
    const auto& transition = mesh.transitions[std::size_t(t)];
    u = Group::apply(transition.rotation, u);
    for(std::size_t c = 0; c < 2; ++c)
      u[c] += nearest_double(transition.translation[c]);
    g = Group::compose(transition.rotation, g);
  }
  const Uv b = mesh.uv(corner(connection.b));
  return Group::apply(Group::inverse(g), Uv{b[0] - u[0], b[1] - u[1]});
}

// The direction along which this component is constant and the other coordinate grows.
inline Isocurve_direction direction_of_connection(const int component)
{
  return component == 0 ? Isocurve_direction::PLUS_V
                        : component == 1 ? Isocurve_direction::PLUS_U
                                         : Isocurve_direction::MINUS_U_PLUS_V;
}

// Traces the isocurve of a connection until it is as long as it should be: this change of the other
// coordinate.
template <typename TriangleMesh, int D>
Isocurve<TriangleMesh> trace_connection(const Isocurve_tracer<TriangleMesh, D>& tracer,
                                        const Connection_constraint<TriangleMesh>& connection,
                                        const double change)
{
  const Isocurve_direction growing = direction_of_connection(connection.component);
  return tracer.trace(Isocurve_start<TriangleMesh>::at_vertex(connection.a),
                      change > 0 ? growing : reversed(growing),
                      parameters::target_vertex(target(connection.b, tracer.mesh()))
                                 .maximum_length(1.001 * std::abs(change)));
}

// The end of the isocurve of a connection in words, if it does not arrive; else empty.
// \param point the distance of ends that may have become one point, with nothing between
// \pre the map is exact
template <typename TriangleMesh, int D, typename VertexIndexMap>
Message obstacle_of_connection(const Isocurve_tracer<TriangleMesh, D>& tracer,
                               const Connection_constraint<TriangleMesh>& connection,
                               const double point, const VertexIndexMap& vertex_indices)
{
  const double change = displacement(tracer, connection)
    [other_coordinate(direction_of_connection(connection.component))];
  if(std::abs(change) <= point)
    return {};
  const auto curve = trace_connection(tracer, connection, change);
  if(curve.status == Isocurve_status::TARGET)
    return {};
  if(curve.status != Isocurve_status::SINGULAR_VERTEX)
    return "does not arrive at its end";
  const auto v = target(curve.points.back().halfedge(), tracer.mesh());
  return "ends at " + name_of_vertex(std::size_t(get(vertex_indices, v))) + " before its end";
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsConstraints

finds the connection constraints that hold, but whose isocurve does not arrive at its end, because a
singular vertex or the border is in its way. `snap_to_seamless()` makes constraints hold, but does
not check the way; this function does.

If faces are flipped in the domain, an isocurve can turn back, and the result can be wrong.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam D the number of directions of the tracer: 4 or 6
\tparam ConnectionRange a range of `Connection_constraint<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tracer of the map that was snapped with the connections
\param connections the constraints
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map` of
        `snap_to_seamless()`

\pre `snap_to_seamless()` has taken the connections, and the map is as it left it

\return the connections that are intercepted, in the order of the range; all of them, if
        `tracer.is_exact()` is `false`

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of edges that the isocurves cross.

\sa `connection_along_isocurve()`
*/
template <typename TriangleMesh, int D, typename ConnectionRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Intercepted_connection>
intercepted_connections(const Isocurve_tracer<TriangleMesh, D>& tracer,
                        const ConnectionRange& connections,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  const auto vertex_indices =
    CGAL::get_initialized_vertex_index_map(
      tracer.mesh(), internal::strip(np, internal::named<CGAL::internal_np::vertex_index>));
  const double point = 1e-12 * tracer.chart_mesh().extent;
  std::vector<Intercepted_connection> result;
  std::size_t index = 0;
  for(const Connection_constraint<TriangleMesh>& connection : connections) {
    const Message obstacle =
      tracer.is_exact()
        ? internal::obstacle_of_connection(tracer, connection, point, vertex_indices)
        : "can't be traced, because the map is not exactly seamless" +
            internal::remedy("call snap_to_seamless() first");
    if(!obstacle.empty())
      result.push_back({index, "the isocurve of connection constraint " + std::to_string(index) +
                                 " " + obstacle});
    ++index;
  }
  return result;
}

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_CONSTRAINTS_H
