// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ALIGN_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ALIGN_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The edges of alignment constraints, Eq. (5), and which component of the coordinates is constant along
// each.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/surface/Open_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/read_transitions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename EdgeIsConstrainedMap, typename F>
void for_each_edge_to_align(const TriangleMesh& tmesh, const EdgeIsConstrainedMap& edge_is_constrained,
                            const bool align_border, const F& f)
{
  for(const auto e : edges(tmesh)) {
    const auto h = halfedge(e, tmesh);
    if((get(edge_is_constrained, e) || (align_border && CGAL::is_border_edge(h, tmesh))) &&
       has_face(h, tmesh))
      f(h);
  }
}

// Invariant: each edge is represented by a halfedge that has a face, in whose chart the component is
// constant up to the tolerance; if not, `status()` and `message()` tell.
template <typename TriangleMesh>
class Align_edges
{
public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Edge = Indexed_edge<Halfedge>;

  explicit Align_edges(const TriangleMesh& tmesh) : m_tmesh(&tmesh) { }

  template <typename HalfedgeUVMap, typename VertexIndexMap, typename EdgeIsConstrainedMap>
  Align_edges(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
              const VertexIndexMap& vertex_indices, const EdgeIsConstrainedMap& edge_is_constrained,
              const bool align_border, const double tolerance)
    : m_tmesh(&tmesh)
  {
    const auto index = [&](const auto v) { return std::size_t(get(vertex_indices, v)); };
    std::vector<Edge> found;
    for_each_edge_to_align(tmesh, edge_is_constrained, align_border, [&](const Halfedge h) {
      found.push_back({h, index(source(h, tmesh)), index(target(h, tmesh))});
    });
    const auto turn = [&](Edge& edge) { edge = {opposite(edge.halfedge, tmesh), edge.target, edge.source}; };
    for(Edge& edge : found)
      if(must_turn(tmesh, vertex_indices, edge))
        turn(edge);
    Vertex_numbers numbers(num_vertices(tmesh));
    numbers.mark_ends(found);
    numbers.assign_numbers();
    for(const std::size_t i : canonical_order(tmesh, vertex_indices, numbers, found)) {
      m_edges.push_back(found[i]);
      if(is_border(found[i].halfedge, tmesh))
        turn(m_edges.back());
    }
    choose_components(uv_map, vertex_indices, tolerance);
  }

  Snapping_status status() const { return m_status; }
  const std::string& message() const { return m_message; }

  const std::vector<Edge>& edges() const { return m_edges; }
  std::size_t size() const { return m_edges.size(); }
  Halfedge halfedge(const Edge_index a) const { return m_edges[std::size_t(a)].halfedge; }

  // Of the chart of the halfedge's face.
  int component(const Edge_index a) const { return m_components[std::size_t(a)]; }

  // Whether Eq. (5) holds exactly along all edges, and the largest violation.
  bool is_exact() const { return m_violation == 0; }
  double violation() const { return m_violation; }

private:
  // The component that changes least along the edge.
  template <typename HalfedgeUVMap, typename VertexIndexMap>
  void choose_components(const HalfedgeUVMap& uv_map, const VertexIndexMap& vertex_indices,
                         const double tolerance)
  {
    std::size_t count = 0;
    Halfedge worst{};
    for(const Edge& edge : m_edges) {
      const Halfedge h = edge.halfedge;
      const Uv a = get_uv(uv_map, prev(h, *m_tmesh));
      const Uv b = get_uv(uv_map, h);
      const double change[2] = {std::abs(b[0] - a[0]), std::abs(b[1] - a[1])};
      const int c = change[1] < change[0] ? 1 : 0;
      m_components.push_back(c);
      if(change[c] > tolerance)
        ++count;
      if(change[c] > m_violation) {
        m_violation = change[c];
        worst = h;
      }
    }
    if(count == 0)
      return;
    m_status = Snapping_status::NOT_ALIGNED;
    m_message = edge_name(*m_tmesh, vertex_indices, worst) +
                " is to be aligned, but neither coordinate is constant along it: the lesser change is " +
                short_number(m_violation) + ", more than the tolerance of " + short_number(tolerance) +
                (count > 1 ? ", as with " + std::to_string(count - 1) + " other edges" : std::string()) +
                "; constrain only edges that lie on isocurves, or raise the tolerance";
  }

  const TriangleMesh* m_tmesh;
  std::vector<Edge> m_edges;
  std::vector<int> m_components;
  Snapping_status m_status = Snapping_status::ALREADY_EXACT;
  std::string m_message;
  double m_violation = 0;
};

// The edges that the named parameters ask to align.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Align_edges<TriangleMesh> read_align_edges(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                           const double extent, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using No_edges = CGAL::Static_boolean_property_map<Edge, false>;
  const auto edge_is_constrained =
    choose_parameter(get_parameter(np, CGAL::internal_np::edge_is_constrained), No_edges());
  const bool align_border = choose_parameter(get_parameter(np, CGAL::internal_np::align_border), false);
  if(std::is_same<std::decay_t<decltype(edge_is_constrained)>, No_edges>::value && !align_border)
    return Align_edges<TriangleMesh>(tmesh);
  const double tolerance = choose_parameter(get_parameter(np, CGAL::internal_np::tolerance),
                                            default_tolerance);
  return Align_edges<TriangleMesh>(tmesh, uv_map, CGAL::get_initialized_vertex_index_map(tmesh, np),
                                   edge_is_constrained, align_border, tolerance * extent);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ALIGN_EDGES_H
