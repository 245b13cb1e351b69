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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ALIGNED_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ALIGNED_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The edges of alignment constraints, [MC19] Eq. (5), and which functional of the coordinates is
// constant along each.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/counted.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Calls `f(h)`, for one halfedge each, for the edges that the named parameters ask to align, while
// it returns true. Returns whether it always did.
template <typename TriangleMesh, typename NamedParameters, typename F>
bool for_each_edge_to_align(const TriangleMesh& tmesh, const NamedParameters& np, const F& f)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using No_edges = CGAL::Static_boolean_property_map<Edge, false>;
  const auto is_constrained =
    choose_parameter(get_parameter(np, CGAL::internal_np::edge_is_constrained), No_edges());
  const bool align_border =
    choose_parameter(get_parameter(np, CGAL::internal_np::align_border), false);
  if(std::is_same<std::decay_t<decltype(is_constrained)>, No_edges>::value && !align_border)
    return true;
  for(const Edge e : edges(tmesh)) {
    const auto h = halfedge(e, tmesh);
    if((get(is_constrained, e) || (align_border && CGAL::is_border_edge(h, tmesh))) &&
       has_face(h, tmesh) && !f(h))
      return false;
  }
  return true;
}

template <typename TriangleMesh, typename NamedParameters>
auto edges_to_align(const TriangleMesh& tmesh, const NamedParameters& np)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  for_each_edge_to_align(tmesh, np, [&](const auto h) {
    result.push_back(h);
    return true;
  });
  return result;
}

// Invariant: each edge is represented by a halfedge that has a face, in whose chart the functional
// is constant up to the tolerance; if not, `refusal()` tells.
template <typename Group, typename TriangleMesh>
class Aligned_edges
{
public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Edge = Indexed_edge<Halfedge>;

  explicit Aligned_edges(const TriangleMesh& tmesh) : m_tmesh(&tmesh) { }

  // \param found in any order
  template <typename HalfedgeUVMap, typename VertexIndexMap>
  Aligned_edges(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                const VertexIndexMap& vertex_indices, std::vector<Edge> found,
                const double tolerance)
    : m_tmesh(&tmesh)
  {
    const auto turn = [&](Edge& edge) {
      edge = {opposite(edge.halfedge, tmesh), edge.target, edge.source};
    };
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
    choose_functionals(uv_map, vertex_indices, tolerance);
  }

  const std::optional<Refusal>& refusal() const { return m_refusal; }

  const std::vector<Edge>& edges() const { return m_edges; }
  std::size_t size() const { return m_edges.size(); }
  Halfedge halfedge(const Edge_index a) const { return m_edges[std::size_t(a)].halfedge; }

  // In the chart of the halfedge's face.
  int functional(const Edge_index a) const { return m_functionals[std::size_t(a)]; }

  // The largest violation of [MC19] Eq. (5).
  double violation() const { return m_violation; }

private:
  // The functional that changes least along the edge.
  template <typename HalfedgeUVMap, typename VertexIndexMap>
  void choose_functionals(const HalfedgeUVMap& uv_map, const VertexIndexMap& vertex_indices,
                         const double tolerance)
  {
    std::size_t count = 0;
    Halfedge worst{};
    for(const Edge& edge : m_edges) {
      const Halfedge h = edge.halfedge;
      const Uv a = get_uv(uv_map, prev(h, *m_tmesh));
      const Uv b = get_uv(uv_map, h);
      const Uv vector{b[0] - a[0], b[1] - a[1]};
      int best = 0;
      double least = std::numeric_limits<double>::infinity();
      for(int f = 0; f < Group::number_of_functionals; ++f) {
        const double change = std::abs(Group::value(f, vector));
        if(change < least) {
          best = f;
          least = change;
        }
      }
      m_functionals.push_back(best);
      if(least > tolerance)
        ++count;
      if(least > m_violation) {
        m_violation = least;
        worst = h;
      }
    }
    if(count == 0)
      return;
    const std::string message =
        edge_name(*m_tmesh, vertex_indices, worst) +
        " is to be aligned, but " +
        (Group::is_signed_permutation ? "neither coordinate" : "none of u, v, and u + v") +
        " is constant along it: the least change is " +
        short_number(m_violation) + ", more than the tolerance of " + short_number(tolerance) +
        (count > 1 ? ", as with " + counted(count - 1, "other edge") : std::string()) +
        "; constrain only edges that lie on isocurves, or raise the tolerance";
    m_refusal = Refusal(Outcome::NOT_ALIGNED, message);
  }

  const TriangleMesh* m_tmesh;
  std::vector<Edge> m_edges;
  std::vector<int> m_functionals;
  std::optional<Refusal> m_refusal;
  double m_violation = 0;
};

// \param edges_to_align one halfedge of each
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap,
          typename Halfedge>
Aligned_edges<Group, TriangleMesh> read_aligned_edges(const TriangleMesh& tmesh,
                                                      const HalfedgeUVMap& uv_map,
                                                      const VertexIndexMap& vertex_indices,
                                                      const std::vector<Halfedge>& edges_to_align,
                                                      const double tolerance)
{
  using Aligned = Aligned_edges<Group, TriangleMesh>;
  const auto index = [&](const auto v) { return std::size_t(get(vertex_indices, v)); };
  std::vector<typename Aligned::Edge> found;
  for(const Halfedge h : edges_to_align)
    found.push_back({h, index(source(h, tmesh)), index(target(h, tmesh))});
  return found.empty() ? Aligned(tmesh)
                       : Aligned(tmesh, uv_map, vertex_indices, std::move(found), tolerance);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ALIGNED_EDGES_H
