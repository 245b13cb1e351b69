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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_TRANSITIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_TRANSITIONS_H

#include <CGAL/license/Seamless_snapping.h>

// From a uv map to its transitions: surveys the edges, measures the open ones, and tells cuts from
// noise.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/estimate_seams.h>
#include <CGAL/Seamless_snapping/internal/mesh/hint_on_symmetry.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The transitions of a uv map.
template <typename Halfedge>
struct Transition_data
{
  std::vector<Mismatched_edge<Halfedge> > edges; // the cut edges, then the merged ones
  std::size_t number_of_cuts = 0;
  std::size_t number_of_edges_decided_by_surroundings = 0;
  std::optional<Refusal> refusal;
  bool is_exact = true;
  double extent = 0;
  double violation = 0;
};

// The order of the symmetry, and what the caller knows about cuts and rotations, if anything. The
// types of the maps that tell it are unknown here, so that all calls share the code.
template <typename Group, typename Halfedge>
class Given_transitions
{
public:
  // \param is_cut,rotation of a halfedge; empty if they are not known
  Given_transitions(const int order, std::function<bool(Halfedge)> is_cut,
                    std::function<int(Halfedge)> rotation)
    : m_order(order), m_is_cut(std::move(is_cut)), m_rotation(std::move(rotation))
  { }

  int order() const { return m_order; }
  bool has_cuts() const { return bool(m_is_cut); }
  bool has_rotations() const { return bool(m_rotation); }

  bool is_cut(const Halfedge h) const { return has_cuts() && m_is_cut(h); }

  typename Group::Element rotation(const Halfedge h) const
  { return has_rotations() ? Group::element(m_rotation(h), m_order) : Group::identity(); }

  // Whether what is given of an edge with the halfedges `g` and `h` fits together.
  bool is_consistent(const Halfedge g, const Halfedge h) const
  {
    return !has_rotations() ||
           (rotation(g) == Group::inverse(rotation(h)) &&
            (rotation(g) == Group::identity() || !has_cuts() || is_cut(g)));
  }

  // Edges that count as open even if their sides are the same to the bit.
  bool is_cut_anyway(const Halfedge g, const Halfedge h) const
  {
    return is_cut(g) || rotation(g) != Group::identity() ||
           rotation(h) != Group::identity(); // perhaps not inverse
  }

  // The transitions of other halfedges, of which `h` stands for `halfedges[h]`.
  template <typename OtherHalfedge>
  Given_transitions<Group, OtherHalfedge>
  renumbered(const std::vector<Halfedge>& halfedges) const
  {
    std::function<bool(OtherHalfedge)> is_cut;
    std::function<int(OtherHalfedge)> rotation;
    if(has_cuts())
      is_cut = [this, &halfedges](const OtherHalfedge h)
        { return m_is_cut(halfedges[std::size_t(h)]); };
    if(has_rotations())
      rotation = [this, &halfedges](const OtherHalfedge h)
        { return m_rotation(halfedges[std::size_t(h)]); };
    return {m_order, is_cut, rotation};
  }

private:
  int m_order;
  std::function<bool(Halfedge)> m_is_cut;
  std::function<int(Halfedge)> m_rotation;
};

// By how much an edge violates [MC19] Eq. (4), times `scale`: for the given rotation, or the best.
template <typename Group, typename Halfedge>
double transition_violation(const Edge_sides& sides,
                            const Given_transitions<Group, Halfedge>& given, const Halfedge h,
                            const double scale)
{
  const Side_vectors<Group> vectors(sides);
  const bool is_known = given.has_rotations() || (given.has_cuts() && !given.is_cut(h));
  Measured_edge edge;
  set_rotation(edge, vectors,
               is_known ? given.rotation(h) : vectors.best_fit(scale, given.order()), scale);
  return edge.residual;
}

template <typename Surface>
std::optional<Refusal> check_indices(const Surface& surface)
{
  if(surface.has_valid_indices())
    return std::nullopt;
  return Refusal(Outcome::INVALID_ARGUMENT,
                 "the indices of vertex_index_map must be different, from 0 to " +
                   std::to_string(surface.number_of_vertices()) + " - 1, as many as there are "
                   "vertices; leave the parameter out to have them made");
}

// One run; the member functions are its steps, in order.
template <typename Group, typename Surface>
class Transition_reader
{
  using Halfedge = typename Surface::Halfedge;
  using Data = Transition_data<Halfedge>;
  using Given = Given_transitions<Group, Halfedge>;

public:
  Transition_reader(const Surface& surface, const Given& given, const double tolerance)
    : m_surface(surface), m_given(given), m_tolerance(tolerance)
  { }

  Data run();

private:
  bool read_rotations(std::vector<Mismatched_edge<Halfedge> >& surveyed,
                      const Vertex_numbers& numbers, Data& data) const
  {
    for(Mismatched_edge<Halfedge>& s : surveyed)
      if(must_turn(m_surface, s))
        s = {{m_surface.opposite(s.halfedge), s.target, s.source}, {s.sides.turned()}};
    data.edges.reserve(surveyed.size());
    for(const std::size_t i : canonical_order(m_surface, numbers, surveyed)) {
      data.edges.push_back(surveyed[i]);
      if(!read_rotation_of(data.edges.back(), data))
        return false;
    }
    return true;
  }

  bool read_rotation_of(Mismatched_edge<Halfedge>& edge, Data& data) const
  {
    const Side_vectors<Group> vectors(edge.sides);
    measure_length_and_gap(edge, vectors, m_scale);
    edge.is_cut = !m_given.has_cuts() || m_given.is_cut(edge.halfedge);
    if(m_given.has_rotations()) {
      const auto g = m_given.rotation(edge.halfedge);
      set_rotation(edge, vectors, g, m_scale);
      if(g != Group::inverse(m_given.rotation(m_surface.opposite(edge.halfedge)))) {
        fail(data, Outcome::INVALID_ROTATIONS, edge.halfedge,
             " has rotations that are not inverse to each other; rotations of opposite halfedges "
             "must add up to a multiple of " + std::to_string(m_given.order()));
        return false;
      }
      if(g != Group::identity() && !edge.is_cut) {
        fail(data, Outcome::INVALID_ROTATIONS, edge.halfedge,
             " has a rotation, but is no cut edge; make it one, or let it have rotation 0");
        return false;
      }
    } else {
      set_rotation(edge, vectors,
                   edge.is_cut ? vectors.best_fit(m_scale, m_given.order()) : Group::identity(),
                   m_scale);
    }
    return true;
  }

  // In terms of the extent; solvers and printed digits leave less.
  static constexpr double far_from_seamless = 1e-3;

  // A residual beyond the tolerance is an error that names the edge, never a guess.
  bool check_residuals(Data& data) const
  {
    const Mismatched_edge<Halfedge>* worst = nullptr;
    std::size_t count = 0;
    double worst_violation = 0;
    data.is_exact = true;
    data.violation = 0;
    for(const Mismatched_edge<Halfedge>& edge : data.edges) {
      data.is_exact = data.is_exact && edge.is_exact;
      data.violation = (std::max)(data.violation, edge.residual / m_scale);
      // the sides of an edge that is known to be no cut must coincide
      const double violation = edge.is_cut ? edge.residual : (std::max)(edge.residual, edge.gap);
      // 0 times infinity is NaN
      if(violation == 0 || violation <= m_tolerance * (data.extent * m_scale))
        continue;
      ++count;
      if(worst == nullptr || violation > worst_violation) {
        worst = &edge;
        worst_violation = violation;
      }
    }
    if(worst == nullptr)
      return true;
    Message hint = hint_on_other_symmetry(data);
    if(hint.empty() && 2 * count > data.edges.size() &&
       worst_violation > far_from_seamless * (data.extent * m_scale))
      hint = "; this is no inaccuracy: parametrizations that leave the border of a cut surface "
             "free, such as ARAP and LSCM, are not seamless" +
             remedy("compute an orbifold embedding, an integer-grid map, or a map that is aligned "
                    "to a cross field");
    fail(data, Outcome::NOT_SEAMLESS, worst->halfedge,
         " has sides that differ by " + short_number(worst_violation / (data.extent * m_scale)) +
         " of the extent, more than the tolerance of " + short_number(m_tolerance) +
         (count > 1 ? ", as with " + counted(count - 1, "other edge") : std::string()) +
         (hint.empty()
            ? remedy("if this is the accuracy of the parametrization, ") + term(raise_tolerance)
            : hint));
    return false;
  }

  // Given cuts and rotations are those of the symmetry, so that there is no other.
  Message hint_on_other_symmetry(const Data& data) const
  {
    std::vector<Edge_sides> edges;
    for(const Mismatched_edge<Halfedge>& edge : data.edges)
      edges.push_back(edge.sides);
    return m_given.has_cuts() || m_given.has_rotations()
      ? Message() : hint_on_symmetry(edges, m_tolerance * data.extent, m_given.order());
  }

  // Returns false if an edge takes a rotation from its surroundings that misses by too much.
  bool tell_cuts_from_noise(const Vertex_numbers& numbers, Data& data) const
  {
    double residual = 0;
    for(const Mismatched_edge<Halfedge>& edge : data.edges)
      residual = (std::max)(residual, edge.residual);
    if(std::none_of(data.edges.begin(), data.edges.end(),
                    [&](const Mismatched_edge<Halfedge>& edge) {
                      return edge.length <= 16 * residual || may_be_noise(edge, residual);
                    }))
      return true;
    const std::vector<Edge_ends> ends = numbers.ends(data.edges);
    const Vertex_incidences incidences = vertex_incidences(numbers.size(), ends);
    const Measured_edges edges(data.edges);
    const auto star = [&](const Incidence& i) {
      Vertex_star result;
      for_each_around_target(m_surface, halfedge_towards(m_surface, data.edges, i),
                             [&](const Halfedge h) {
        ++result.number_of_edges;
        result.has_border = result.has_border || m_surface.is_border(h);
      });
      return result;
    };
    if(!m_given.has_rotations()) {
      data.number_of_edges_decided_by_surroundings = estimate_rotations<Group>(
        {m_given.order(), m_scale, m_tolerance * (data.extent * m_scale), m_surface.epsilon()},
        ends, incidences, star, edges);
      if(data.number_of_edges_decided_by_surroundings > 0 && !check_residuals(data))
        return false;
    }
    if(!m_given.has_cuts())
      mark_merged_edges(incidences, star, edges);
    return true;
  }

  void fail(Data& data, const Outcome status, const Halfedge h,
            const Message& what) const
  {
    data.refusal = Refusal(status, edge_name(m_surface, h) + what);
    data.edges.clear(); // incomplete
  }

  const Surface& m_surface;
  const Given& m_given;
  double m_tolerance;
  double m_scale = 1; // lengths are measured after multiplication with it
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group, typename Surface>
Transition_data<typename Surface::Halfedge> Transition_reader<Group, Surface>::run()
{
  Data data;
  data.refusal = check_indices(m_surface);
  if(data.refusal)
    return data;
  if(!(m_tolerance >= 0)) {
    data.refusal = Refusal(Outcome::INVALID_ARGUMENT, "the tolerance is " +
                           short_number(m_tolerance) + remedy("it must not be negative"));
    return data;
  }
  std::function<bool(Halfedge)> is_cut_anyway;
  if(m_given.has_cuts() || m_given.has_rotations())
    is_cut_anyway = [this](const Halfedge h)
      { return m_given.is_cut_anyway(h, m_surface.opposite(h)); };
  Uv_survey<Halfedge> survey = survey_uv(m_surface, is_cut_anyway);
  data.extent = survey.extent;
  data.refusal = std::move(survey.refusal);
  if(data.refusal)
    return data;
  m_scale = unit_scale(data.extent);
  const Vertex_numbers numbers(m_surface.number_of_vertices(), survey.mismatched_edges);
  if(!read_rotations(survey.mismatched_edges, numbers, data) || !check_residuals(data) ||
     !tell_cuts_from_noise(numbers, data))
    return data;
  std::stable_partition(data.edges.begin(), data.edges.end(),
                        [](const Mismatched_edge<Halfedge>& edge) { return edge.is_cut; });
  data.number_of_cuts = std::size_t(std::count_if(data.edges.begin(), data.edges.end(),
                                                  [](const auto& edge) { return edge.is_cut; }));
  data.is_exact = data.is_exact && data.number_of_cuts == data.edges.size();
  return data;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_TRANSITIONS_H
