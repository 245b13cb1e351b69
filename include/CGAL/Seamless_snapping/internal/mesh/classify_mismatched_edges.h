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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CLASSIFY_MISMATCHED_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CLASSIFY_MISMATCHED_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// Reads off each open edge the rotation of its transition, and tells cuts from noise. Floating point is
// used throughout: this chooses which parametrization is approximated, not whether it is met exactly.

#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>

#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>

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

// Lengths are measured after multiplication with this power of two, which keeps the smallest and the
// largest maps in range.
inline double unit_scale(const double extent)
{
  int exponent = 0;
  std::frexp(extent, &exponent);
  return std::ldexp(1., (std::min)(-exponent, 1000));
}

// Measures Eq. (4) for one rotation. \pre the coordinates are in range
template <typename Group, typename Halfedge>
void set_rotation(Mismatched_edge<Halfedge>& edge, const Edge_vectors& vectors,
                  const typename Group::Element g, const double scale)
{
  edge.rotation = g;
  edge.is_exact = vectors.match<Group>(g);
  edge.residual = edge.is_exact ? 0 : vectors.residual<Group>(g, scale);
}

template <typename Halfedge>
void measure_length_and_gap(Mismatched_edge<Halfedge>& edge, const Edge_vectors& vectors, const double scale)
{
  const Edge_sides& sides = edge.sides;
  edge.length = vectors.length(scale);
  edge.gap = 0;
  for(std::size_t c = 0; c < 2; ++c)
    edge.gap = (std::max)({edge.gap, scale * std::abs(sides.a[c] - sides.a_opposite[c]),
                                     scale * std::abs(sides.b[c] - sides.b_opposite[c])});
}

template <typename Halfedge>
double largest_residual(const std::vector<Mismatched_edge<Halfedge> >& edges)
{
  double largest = 0;
  for(const Mismatched_edge<Halfedge>& edge : edges)
    largest = (std::max)(largest, edge.residual);
  return largest;
}

// At an inner vertex where just two open edges meet, the one's branch goes on in the other, unless it
// is a cone: that can't be seen where edges hide their rotations.
template <typename TriangleMesh, typename Halfedge>
bool joins_two_edges(const TriangleMesh& tmesh, const std::vector<Mismatched_edge<Halfedge> >& edges,
                     const Vertex_incidences& incidences, const Vertex_index v)
{
  if(incidences.degree(v) != 2)
    return false;
  const Incidence& incidence = *incidences.begin(v);
  const Halfedge h = edges[std::size_t(incidence.edge)].halfedge;
  return !CGAL::is_border(incidence.points_to_vertex ? target(h, tmesh) : source(h, tmesh), tmesh);
}

// An edge not longer than a few residuals looks alike under all rotations: it takes its rotation from
// the branch it lies on. Not so if it is exact, and longer than what agrees by chance.
// \param epsilon that of the coordinates' number type
template <typename Halfedge>
bool hides_its_rotation(const Mismatched_edge<Halfedge>& edge, const double residual,
                        const double epsilon)
{
  return edge.is_cut && edge.length <= 4 * residual &&
         !(edge.is_exact && edge.length > 64 * epsilon);
}

// Returns whether a rotation has changed.
// \param is_hidden whether an edge hides its rotation
template <typename Group, typename TriangleMesh, typename Halfedge, typename Predicate>
bool complete_rotations(const TriangleMesh& tmesh, const double scale, const Predicate& is_hidden,
                        const std::vector<Edge_ends>& ends, const Vertex_incidences& incidences,
                        std::vector<Mismatched_edge<Halfedge> >& edges)
{
  std::vector<char> is_known(edges.size());
  std::vector<Edge_index> known;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    is_known[i] = !is_hidden(edges[i]);
    if(is_known[i] && edges[i].is_cut)
      known.push_back(Edge_index(i));
  }
  if(std::find(is_known.begin(), is_known.end(), 0) == is_known.end())
    return false;
  bool has_changed = false;
  while(!known.empty()) {
    const Edge_index i = known.back();
    known.pop_back();
    for(const Vertex_index v : {ends[std::size_t(i)].source, ends[std::size_t(i)].target}) {
      if(!joins_two_edges(tmesh, edges, incidences, v))
        continue;
      const Incidence* pair = incidences.begin(v);
      const Incidence& here = pair[pair[0].edge == i ? 0 : 1];
      const Incidence& other = pair[pair[0].edge == i ? 1 : 0];
      if(is_known[std::size_t(other.edge)])
        continue;
      // towards the vertex the rotations of both are inverse to each other
      const auto g = edges[std::size_t(i)].rotation;
      Mismatched_edge<Halfedge>& edge = edges[std::size_t(other.edge)];
      const auto old_rotation = edge.rotation;
      set_rotation<Group>(edge, Edge_vectors(edge.sides),
                          here.points_to_vertex == other.points_to_vertex ? Group::inverse(g) : g,
                          scale);
      has_changed = has_changed || edge.rotation != old_rotation;
      is_known[std::size_t(other.edge)] = true;
      known.push_back(other.edge);
    }
  }
  return has_changed;
}

// Chains of edges without rotation whose sides would coincide but for noise are no cuts: their corners
// are merged. A chain is judged as a whole, by the mean of its gaps against the largest residual of the
// map, so that a small translation on an accurate map stays what it is.
template <typename Group, typename Halfedge>
bool may_be_noise(const Mismatched_edge<Halfedge>& edge, const double residual)
{
  return edge.rotation == Group::identity() && edge.gap <= 8 * noise_factor * residual;
}

template <typename Group, typename TriangleMesh, typename Halfedge>
void mark_merged_edges(const TriangleMesh& tmesh, const std::vector<Edge_ends>& ends,
                       const Vertex_incidences& incidences,
                       const double residual, std::vector<Mismatched_edge<Halfedge> >& edges)
{
  const auto is_candidate = [&](const Edge_index i) {
    return may_be_noise<Group>(edges[std::size_t(i)], residual);
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
    for(const Vertex_index v : {ends[std::size_t(i)].source, ends[std::size_t(i)].target}) {
      const Incidence* pair = incidences.begin(v);
      if(incidences.degree(v) == 2 && is_candidate(pair[0].edge) && is_candidate(pair[1].edge) &&
         joins_two_edges(tmesh, edges, incidences, v))
        chains.union_set(pair[0].edge, pair[1].edge);
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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CLASSIFY_MISMATCHED_EDGES_H
