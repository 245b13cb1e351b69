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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_CLASSIFY_OPEN_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_CLASSIFY_OPEN_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// Reads off each open edge the rotation of its transition, and tells cuts from noise. Floating point is
// used throughout: this chooses which parametrization is approximated, not whether it is met exactly.

#include <CGAL/Seamless_snapping/internal/surface/Exact_difference.h>
#include <CGAL/Seamless_snapping/internal/surface/Open_edges.h>

#include <CGAL/Seamless_snapping/internal/surface/uv_survey.h>

#include <CGAL/boost/graph/helpers.h>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// How far noise may exceed the largest residual. Residuals add up along a branch, so a gap that should
// be closed can be a few times as wide as a single residual.
constexpr double noise_factor = 8;

// Measures Eq. (4) for one rotation.
template <typename Halfedge>
void set_rotation(Open_edge<Halfedge>& edge, const Edge_sides& sides, const int k, const int exponent)
{
  edge.rotation = k;
  edge.is_exact = satisfies_transition(sides, k);
  edge.residual = edge.is_exact ? 0 : Edge_vectors(sides).residual(k, exponent);
}

// The rotation of least residual, as in [EBCK13]. All lengths in units of 2^exponent.
template <typename Halfedge>
void read_rotation(Open_edge<Halfedge>& edge, const Edge_sides& sides, const int exponent)
{
  set_rotation(edge, sides, 0, exponent);
  for(int k = 1; k < number_of_rotations && edge.residual > 0; ++k) {
    Open_edge<Halfedge> candidate = edge;
    set_rotation(candidate, sides, k, exponent);
    if(candidate.residual < edge.residual)
      edge = candidate;
  }
}

template <typename Halfedge>
void measure_length_and_gap(Open_edge<Halfedge>& edge, const Edge_sides& sides, const int exponent)
{
  edge.length = Edge_vectors(sides).length(exponent);
  edge.gap = 0;
  for(std::size_t c = 0; c < 2; ++c)
    edge.gap = (std::max)({edge.gap, std::abs(std::ldexp(sides.a[c], -exponent) -
                                              std::ldexp(sides.a_opposite[c], -exponent)),
                                     std::abs(std::ldexp(sides.b[c], -exponent) -
                                              std::ldexp(sides.b_opposite[c], -exponent))});
}

template <typename Halfedge>
double largest_residual(const std::vector<Open_edge<Halfedge> >& edges)
{
  double largest = 0;
  for(const Open_edge<Halfedge>& edge : edges)
    largest = (std::max)(largest, edge.residual);
  return largest;
}

// At a regular inner vertex where just two open edges meet, the one's branch goes on in the other.
template <typename TriangleMesh>
bool joins_two_edges(const TriangleMesh& tmesh, const Vertex_numbers<TriangleMesh>& vertices,
                     const Vertex_incidences& incidences, const Vertex_index v)
{
  return incidences.degree(v) == 2 && !CGAL::is_border(vertices.vertex(v), tmesh);
}

// An edge not longer than a few residuals looks alike under all rotations: it takes its rotation from
// the branch it lies on.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
void complete_rotations(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const int exponent,
                        const Vertex_numbers<TriangleMesh>& vertices,
                        const Vertex_incidences& incidences,
                        std::vector<Open_edge<Halfedge> >& edges)
{
  const double shortest = 4 * largest_residual(edges);
  std::vector<char> is_known(edges.size());
  std::vector<Edge_index> known;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    is_known[i] = edges[i].length > shortest;
    if(is_known[i])
      known.push_back(Edge_index(i));
  }
  if(known.size() == edges.size())
    return;
  while(!known.empty()) {
    const Edge_index i = known.back();
    known.pop_back();
    const Halfedge h = edges[std::size_t(i)].halfedge;
    for(const Vertex_index v : {vertices.source_index(h), vertices.target_index(h)}) {
      if(!joins_two_edges(tmesh, vertices, incidences, v))
        continue;
      const Incidence* ends = incidences.begin(v);
      const Incidence& here = ends[ends[0].edge == i ? 0 : 1];
      const Incidence& other = ends[ends[0].edge == i ? 1 : 0];
      if(is_known[std::size_t(other.edge)])
        continue;
      // towards the vertex the rotations of both add up to 0
      const int k = edges[std::size_t(i)].rotation;
      Open_edge<Halfedge>& edge = edges[std::size_t(other.edge)];
      set_rotation(edge, edge_sides(tmesh, uv_map, edge.halfedge),
                   here.points_to_vertex == other.points_to_vertex ? inverse_rotation(k) : k, exponent);
      is_known[std::size_t(other.edge)] = true;
      known.push_back(other.edge);
    }
  }
}

// Chains of edges without rotation whose sides would coincide but for noise are no cuts: their corners
// are merged. A chain is judged as a whole, by the mean of its gaps against the largest residual of the
// map, so that a small translation on an accurate map stays what it is.
template <typename TriangleMesh, typename Halfedge>
void mark_merged_edges(const TriangleMesh& tmesh, const Vertex_numbers<TriangleMesh>& vertices,
                       const Vertex_incidences& incidences, const double residual,
                       std::vector<Open_edge<Halfedge> >& edges)
{
  const auto is_candidate = [&](const Edge_index i) {
    const Open_edge<Halfedge>& edge = edges[std::size_t(i)];
    return edge.rotation == 0 && edge.gap <= 8 * noise_factor * residual;
  };
  std::vector<Edge_index> parent(edges.size()), rank(edges.size(), 0);
  boost::disjoint_sets<Edge_index*, Edge_index*> chains(rank.data(), parent.data());
  std::vector<Edge_index> candidates;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    chains.make_set(Edge_index(i));
    if(is_candidate(Edge_index(i)))
      candidates.push_back(Edge_index(i));
  }
  for(const Edge_index i : candidates) {
    const Halfedge h = edges[std::size_t(i)].halfedge;
    for(const Vertex_index v : {vertices.source_index(h), vertices.target_index(h)}) {
      const Incidence* ends = incidences.begin(v);
      if(incidences.degree(v) == 2 && is_candidate(ends[0].edge) && is_candidate(ends[1].edge) &&
         joins_two_edges(tmesh, vertices, incidences, v))
        chains.union_set(ends[0].edge, ends[1].edge);
    }
  }
  std::vector<double> sum(edges.size(), 0), count(edges.size(), 0);
  for(const Edge_index i : candidates) {
    const std::size_t chain = std::size_t(chains.find_set(i));
    sum[chain] += edges[std::size_t(i)].gap;
    count[chain] += 1;
  }
  for(const Edge_index i : candidates) {
    const std::size_t chain = std::size_t(chains.find_set(i));
    edges[std::size_t(i)].is_cut = sum[chain] > noise_factor * residual * count[chain];
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_CLASSIFY_OPEN_EDGES_H
