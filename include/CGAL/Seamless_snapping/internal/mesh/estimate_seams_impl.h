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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// Estimates the rotations of mismatched edges, and tells cuts from noise.

#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/estimate_seams.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// One run. The noise at an edge is what residuals in its surroundings tell, and gaps where corners
// differ along most edges. An edge whose length lets only one rotation explain it up to the noise
// is decided by itself. Others take the rotation of the branch they lie on, or what fits best. Only
// where corners have noise of their own, they take the rotation that leaves no cone at one of their
// ends, or are no cut if their gap is noise too.
template <typename Group>
class Seam_estimator
{
  using Element = typename Group::Element;

public:
  Seam_estimator(const Seam_options& options, const std::vector<Edge_ends>& ends,
                 const Vertex_incidences& incidences, const Vertex_star_of& star,
                 const Measured_edges& edges)
    : m_options(options), m_ends(ends), m_incidences(incidences), m_star(star), m_edges(edges),
      m_is_decided(edges.size(), true), m_is_soft(edges.size(), false),
      m_number_of_undecided(incidences.size(), 0), m_is_border(incidences.size(), UNKNOWN)
  {
    for(std::size_t i = 0; i < edges.size(); ++i)
      m_best.push_back(edges[i].rotation);
  }

  // Returns the number of edges whose surroundings ask for another rotation than the one that fits
  // them best by themselves.
  std::size_t run()
  {
    estimate_noise();
    find_undecided();
    if(std::find(m_is_soft.begin(), m_is_soft.end(), true) == m_is_soft.end())
      return 0;
    continue_branches();
    if(m_has_corner_noise) // else others fit best as they are
      leave_few_cones();
    std::size_t number = 0;
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      number += m_edges[i].rotation == m_best[i] ? 0 : 1;
    return number;
  }

private:
  enum : char { UNKNOWN, NO, YES };

  void leave_few_cones()
  {
    for(std::size_t v = 0; v < m_incidences.size(); ++v)
      m_queue.push_back(Vertex_index(v));
    complete_vertices();
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      if(!m_is_decided[i] && is_noise(m_edges[i].gap, i) && is_admissible(i, Group::identity()))
        decide(i, Group::identity());
    complete_vertices();
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      if(!m_is_decided[i]) {
        set_decided(i); // with the least residual
        complete_vertices();
      }
  }

  // --- noise ---

  // The largest residual within a few edges: a single one can be small by chance.
  void estimate_noise()
  {
    constexpr int number_of_rings = 3;
    m_noise.assign(m_edges.size(), 0);
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      m_noise[i] = m_edges[i].residual;
    for(std::size_t v = 0; v < m_incidences.size(); ++v)
      add_gaps(Vertex_index(v));
    std::vector<double> at_vertex(m_incidences.size());
    for(int ring = 0; ring < number_of_rings; ++ring) {
      std::fill(at_vertex.begin(), at_vertex.end(), 0);
      for(std::size_t i = 0; i < m_edges.size(); ++i)
        for(const Vertex_index v : {m_ends[i].source, m_ends[i].target})
          at_vertex[std::size_t(v)] = (std::max)(at_vertex[std::size_t(v)], m_noise[i]);
      for(std::size_t i = 0; i < m_edges.size(); ++i)
        m_noise[i] = (std::max)(at_vertex[std::size_t(m_ends[i].source)],
                                at_vertex[std::size_t(m_ends[i].target)]);
    }
  }

  // If corners differ along most edges of a vertex, each has noise of its own, which their gaps
  // show even if the edges are too short for residuals to: the median of the gaps, since a cut may
  // be among them.
  void add_gaps(const Vertex_index v)
  {
    if(m_incidences[v].size() < 3)
      return;
    m_gaps.clear();
    for(const Incidence& i : m_incidences[v]) {
      const Measured_edge& edge = m_edges[std::size_t(i.edge)];
      if(!edge.is_exact && edge.gap <= 4 * edge.length && !has_clear_gap(edge))
        m_gaps.push_back(edge.gap);
    }
    const std::size_t size = m_star(m_incidences[v].front()).number_of_edges;
    if(2 * m_gaps.size() <= size)
      return;
    m_has_corner_noise = true;
    const auto median = m_gaps.end() - std::ptrdiff_t((size + 1) / 2); // other edges have no gap
    std::nth_element(m_gaps.begin(), median, m_gaps.end());
    for(const Incidence& i : m_incidences[v])
      m_noise[std::size_t(i.edge)] = (std::max)(m_noise[std::size_t(i.edge)], *median);
  }

  // Whether a transition fits so well that it can't be by chance: its gap is no noise.
  static bool has_clear_gap(const Measured_edge& edge)
  {
    return (std::min)(edge.gap, edge.length) > 8 * edge.residual;
  }

  bool is_noise(const double x, const std::size_t i) const { return x <= 2 * m_noise[i]; }

  // --- edges ---

  void find_undecided()
  {
    for(std::size_t i = 0; i < m_edges.size(); ++i) {
      const Measured_edge& edge = m_edges[i];
      // what agrees exactly, and is longer than what does so by chance, is no noise
      if(!edge.is_cut || (edge.is_exact && edge.length > 64 * m_options.epsilon))
        continue;
      int number = 0;
      for(int turns = 0; turns < m_options.order; ++turns)
        number += is_admissible(i, Group::element(turns, m_options.order)) ? 1 : 0;
      if(number < 2)
        continue;
      m_is_decided[i] = false;
      m_is_soft[i] = true;
      ++m_number_of_undecided[std::size_t(m_ends[i].source)];
      ++m_number_of_undecided[std::size_t(m_ends[i].target)];
    }
  }

  bool is_admissible(const std::size_t i, const Element g) const
  {
    const Measured_edge& edge = m_edges[i];
    if(g == edge.rotation)
      return true;
    if(edge.length > 4 * m_noise[i]) // all others miss by more than this
      return false;
    const double residual = Side_vectors<Group>(edge.sides).residual(g, m_options.scale);
    return is_noise(residual, i) && residual <= m_options.tolerance;
  }

  void decide(const std::size_t i, const Element g)
  {
    set_rotation(m_edges[i], Side_vectors<Group>(m_edges[i].sides), g, m_options.scale);
    set_decided(i);
  }

  void set_decided(const std::size_t i)
  {
    m_is_decided[i] = true;
    for(const Vertex_index v : {m_ends[i].source, m_ends[i].target}) {
      --m_number_of_undecided[std::size_t(v)];
      m_queue.push_back(v);
    }
  }

  // From edges that are decided along their branches, at vertices where just two edges meet.
  void continue_branches()
  {
    std::vector<Edge_index> known;
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      if(m_is_decided[i] && m_edges[i].is_cut)
        known.push_back(Edge_index(i));
    while(!known.empty()) {
      const std::size_t i = std::size_t(known.back());
      known.pop_back();
      for(const Vertex_index v : {m_ends[i].source, m_ends[i].target}) {
        const auto pair = m_incidences[v];
        if(pair.size() != 2 || is_border(v))
          continue;
        const Incidence& other = pair[pair[0].edge == Edge_index(i) ? 1 : 0];
        const std::size_t e = std::size_t(other.edge);
        const Element g = rotation_without_cone(v, other);
        if(m_is_decided[e] || !is_admissible(e, g))
          continue;
        decide(e, g);
        known.push_back(other.edge);
      }
    }
    m_queue.clear();
  }

  // --- vertices ---

  // At inner vertices all of whose edges but one are decided, that one leaves no cone, if it can.
  void complete_vertices()
  {
    for(; !m_queue.empty(); m_queue.pop_front()) {
      const Vertex_index v = m_queue.front();
      if(m_number_of_undecided[std::size_t(v)] != 1 || is_border(v))
        continue;
      for(const Incidence& i : m_incidences[v]) {
        const std::size_t e = std::size_t(i.edge);
        if(m_is_decided[e])
          continue;
        const Element g = rotation_without_cone(v, i);
        if(is_admissible(e, g))
          decide(e, g);
        break;
      }
    }
  }

  Element rotation_without_cone(const Vertex_index v, const Incidence& i) const
  {
    const Element others = holonomy<Group>(m_incidences, m_edges, v, i.edge);
    return i.points_to_vertex ? Group::inverse(others) : others;
  }

  bool is_border(const Vertex_index v)
  {
    char& known = m_is_border[std::size_t(v)];
    if(known == UNKNOWN)
      known = m_incidences[v].size() > 0 && m_star(m_incidences[v].front()).has_border ? YES : NO;
    return known == YES;
  }

  const Seam_options& m_options;
  const std::vector<Edge_ends>& m_ends;
  const Vertex_incidences& m_incidences;
  const Vertex_star_of& m_star;
  const Measured_edges& m_edges;
  std::vector<double> m_noise; // per edge
  std::vector<char> m_is_decided, m_is_soft; // per edge: now, and not by itself
  std::vector<Element> m_best; // per edge: what fits it by itself
  std::vector<int> m_number_of_undecided; // per vertex: edges
  std::vector<char> m_is_border; // per vertex
  std::deque<Vertex_index> m_queue;
  std::vector<double> m_gaps; // scratch
  bool m_has_corner_noise = false;
};

template <typename Group>
std::size_t estimate_rotations(const Seam_options& options, const std::vector<Edge_ends>& ends,
                               const Vertex_incidences& incidences, const Vertex_star_of& star,
                               const Measured_edges& edges)
{
  return Seam_estimator<Group>(options, ends, incidences, star, edges).run();
}

// --- cuts or noise: edges that are not turned, and whose sides would coincide but for noise, are
// no cuts, and their corners are merged

// The largest residual of the connected part of the mismatched edges that each of them belongs to:
// what is exact in one part tells nothing of others, nor others of it.
inline std::vector<double> residuals_of_parts(const Vertex_incidences& incidences,
                                              const Measured_edges& edges)
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

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void mark_merged_edges(const Vertex_incidences& incidences, const Vertex_star_of& star,
                       const Measured_edges& edges)
{
  const std::vector<double> residual = residuals_of_parts(incidences, edges);
  const auto is_candidate = [&](const std::size_t i) {
    return may_be_noise(edges[i], residual[i]);
  };
  boost::disjoint_sets_with_storage<> chains(edges.size());
  for(std::size_t v = 0; v < incidences.size(); ++v) {
    const auto pair = incidences[v];
    if(pair.size() == 2 && is_candidate(std::size_t(pair[0].edge)) &&
       is_candidate(std::size_t(pair[1].edge)) && !star(pair[0]).has_border) // it goes on
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

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_SEAMLESS_SNAPPING_ESTIMATE_ROTATIONS(, Rotation_group<4>)
CGAL_SEAMLESS_SNAPPING_ESTIMATE_ROTATIONS(, Rotation_group<6>)
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_IMPL_H
