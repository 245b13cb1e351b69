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
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: each edge is represented by a halfedge that has a face, in whose chart the functional
// is constant up to the tolerance; if not, `refusal()` tells.
template <typename Group, typename Halfedge>
class Aligned_edges
{
public:
  using Edge = Indexed_edge<Halfedge>;

  Aligned_edges() = default; // none

  // \param edges_to_align one halfedge of each
  template <typename Surface>
  Aligned_edges(const Surface& surface, const std::vector<Halfedge>& edges_to_align,
                const double tolerance)
  {
    if(edges_to_align.empty())
      return;
    std::vector<Edge> found;
    for(const Halfedge h : edges_to_align)
      found.push_back({h, surface.source(h), surface.vertex(h)});
    const auto turn = [&](Edge& edge) {
      edge = {surface.opposite(edge.halfedge), edge.target, edge.source};
    };
    for(Edge& edge : found)
      if(must_turn(surface, edge))
        turn(edge);
    const Vertex_numbers numbers(surface.number_of_vertices(), found);
    for(const std::size_t i : canonical_order(surface, numbers, found)) {
      m_edges.push_back(found[i]);
      if(surface.is_border(found[i].halfedge))
        turn(m_edges.back());
    }
    choose_functionals(surface, tolerance);
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
  template <typename Surface>
  void choose_functionals(const Surface& surface, const double tolerance)
  {
    std::size_t count = 0;
    Halfedge worst{};
    for(const Edge& edge : m_edges) {
      const Halfedge h = edge.halfedge;
      const Uv a = surface.uv(surface.prev(h));
      const Uv b = surface.uv(h);
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
    const Message message =
        edge_name(surface, worst) +
        " is to be aligned, but " +
        (Group::is_signed_permutation ? "neither coordinate" : "none of u, v, and u + v") +
        " is constant along it: the least change is " +
        short_number(m_violation) + ", more than the tolerance of " + short_number(tolerance) +
        (count > 1 ? ", as with " + counted(count - 1, "other edge") : std::string()) +
        remedy("constrain only edges that lie on isocurves, or ") + term(raise_tolerance);
    m_refusal = Refusal(Outcome::NOT_ALIGNED, message);
  }

  std::vector<Edge> m_edges;
  std::vector<int> m_functionals;
  std::optional<Refusal> m_refusal;
  double m_violation = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ALIGNED_EDGES_H
