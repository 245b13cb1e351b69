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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MERGE_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MERGE_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// Tells cuts from noise where charts are not turned: edges whose sides would coincide but for noise
// are no cuts, and their corners are merged.

#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// How far noise may exceed the largest residual. Residuals add up along a branch, so a gap that
// should be closed can be a few times as wide as a single residual.
constexpr double noise_factor = 8;

// The first condition, for a single edge; the second is for its chain.
template <typename Group, typename Halfedge>
bool may_be_noise(const Mismatched_edge<Halfedge>& edge, const double residual)
{
  return edge.rotation == Group::identity() && edge.gap <= 8 * noise_factor * residual;
}

// The largest residual of the connected part of the mismatched edges that each of them belongs to:
// what is exact in one part tells nothing of others, nor others of it.
template <typename Halfedge>
std::vector<double> residuals_of_parts(const Vertex_incidences& incidences,
                                       const std::vector<Mismatched_edge<Halfedge> >& edges)
{
  boost::disjoint_sets_with_storage<> parts(edges.size());
  for(std::size_t v = 0; v < incidences.size(); ++v)
    for(const Incidence& i : incidences[v])
      parts.union_set(incidences[v].front().edge, i.edge);
  std::vector<double> largest(edges.size(), 0), result(edges.size());
  for(std::size_t i = 0; i < edges.size(); ++i) {
    double& residual = largest[parts.find_set(i)];
    residual = (std::max)(residual, edges[i].residual);
  }
  for(std::size_t i = 0; i < edges.size(); ++i)
    result[i] = largest[parts.find_set(i)];
  return result;
}

// Whether a vertex is inside and has just two mismatched edges: the one's chain goes on in the
// other.
template <typename Surface, typename Halfedge>
bool joins_two_edges(const Surface& surface, const std::vector<Mismatched_edge<Halfedge> >& edges,
                     const Vertex_incidences& incidences, const Vertex_index v)
{
  if(incidences[v].size() != 2)
    return false;
  return !has_border_at_target(surface, halfedge_towards(surface, edges, incidences[v].front()));
}

// A chain of edges without rotation is judged as a whole, by the mean of its gaps against the
// largest residual of its part, so that a small translation on an accurate map stays what it is.
template <typename Group, typename Surface, typename Halfedge>
void mark_merged_edges(const Surface& surface, const Vertex_incidences& incidences,
                       std::vector<Mismatched_edge<Halfedge> >& edges)
{
  const std::vector<double> residual = residuals_of_parts(incidences, edges);
  const auto is_candidate = [&](const std::size_t i) {
    return may_be_noise<Group>(edges[i], residual[i]);
  };
  boost::disjoint_sets_with_storage<> chains(edges.size());
  for(std::size_t v = 0; v < incidences.size(); ++v) {
    const auto pair = incidences[v];
    if(pair.size() == 2 && is_candidate(std::size_t(pair[0].edge)) &&
       is_candidate(std::size_t(pair[1].edge)) &&
       joins_two_edges(surface, edges, incidences, Vertex_index(v)))
      chains.union_set(pair[0].edge, pair[1].edge);
  }
  std::vector<double> sum(edges.size(), 0), count(edges.size(), 0);
  for(std::size_t i = 0; i < edges.size(); ++i)
    if(is_candidate(i)) {
      sum[chains.find_set(i)] += edges[i].gap;
      count[chains.find_set(i)] += 1;
    }
  for(std::size_t i = 0; i < edges.size(); ++i)
    if(is_candidate(i))
      edges[i].is_cut =
          sum[chains.find_set(i)] > noise_factor * residual[i] * count[chains.find_set(i)];
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MERGE_EDGES_H
