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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_INTERCEPTED_CONNECTIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_INTERCEPTED_CONNECTIONS_H

#include <CGAL/license/Seamless_snapping.h>

// Connections that hold, but are interrupted. The equation of a connection says where its isocurve
// would arrive if nothing was in its way; whether something is, is found by tracing it.

#include <CGAL/Seamless_snapping/Isocurve_tracer.h>
#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>
#include <CGAL/Seamless_snapping/parameters.h>
#include <CGAL/Seamless_snapping/surface_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Seamless_snapping {
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

// Whether the isocurve of a connection does not arrive, and where it ends instead.
// \param point the distance of ends that may have become one point, with nothing between
template <typename TriangleMesh, int D, typename VertexIndexMap>
bool is_intercepted(const Isocurve_tracer<TriangleMesh, D>& tracer,
                    const Connection_constraint<TriangleMesh>& connection, const double point,
                    const VertexIndexMap& vertex_indices, std::string& obstacle)
{
  const double change = displacement(tracer, connection)
    [other_coordinate(direction_of_connection(connection.component))];
  if(std::abs(change) <= point)
    return false;
  const auto curve = trace_connection(tracer, connection, change);
  if(curve.status == Isocurve_status::TARGET)
    return false;
  obstacle = curve.status != Isocurve_status::SINGULAR_VERTEX
               ? std::string(" does not arrive at its end")
               : " ends at vertex " +
                   std::to_string(get(vertex_indices, target(curve.points.back().halfedge(),
                                                             tracer.mesh()))) +
                   " before its end";
  return true;
}

// The first one in words, after what the message says already.
inline void tell_of_interception(const std::size_t place, const std::string& obstacle,
                                 Snapping_report& report)
{
  if(report.intercepted_connections.empty())
    report.message += std::string(report.message.empty() ? "" : "; ") +
                      "the isocurve of connection constraint " + std::to_string(place) + obstacle;
  report.intercepted_connections.push_back(place);
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
void find_intercepted_connections(const CGAL::internal_np::Param_not_found&, const TriangleMesh&,
                                  const HalfedgeUVMap&, const NamedParameters&, Snapping_report&)
{ }

// Fills in the report. \pre the map is exactly seamless, and the connections hold
template <typename Connections, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters>
void find_intercepted_connections(const Connections& connections, const TriangleMesh& tmesh,
                                  const HalfedgeUVMap& uv_map, const NamedParameters& np,
                                  Snapping_report& report)
{
  Step_timer timer(report.run);
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const Isocurve_tracer tracer(tmesh, uv_map, np);
  if(!tracer.is_exact())
    return;
  std::size_t place = 0;
  for(const Connection_constraint<TriangleMesh>& connection : connections) {
    std::string obstacle;
    if(is_intercepted(tracer, connection, 1e-12 * report.extent, vertex_indices, obstacle))
      tell_of_interception(place, obstacle, report);
    ++place;
  }
  timer.finish("traces of connections");
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_INTERCEPTED_CONNECTIONS_H
