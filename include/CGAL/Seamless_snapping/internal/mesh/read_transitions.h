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
#include <CGAL/Linear_snapping/internal/support/counted.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/estimate_seams.h>
#include <CGAL/Seamless_snapping/internal/mesh/hint_on_symmetry.h>
#include <CGAL/Seamless_snapping/internal/mesh/measure_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/merge_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The transitions of a uv map.
template <typename TriangleMesh>
struct Transition_data
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  std::vector<Mismatched_edge<Halfedge> > edges; // the cut edges, then the merged ones
  std::size_t number_of_cuts = 0;
  std::size_t number_of_edges_decided_by_surroundings = 0;
  std::optional<Refusal> refusal;
  bool is_exact = true;
  double extent = 0;
  double violation = 0;
};

// What the caller knows about cuts and rotations, if anything. The types of the maps that tell it
// end here, so that all calls share the code behind.
template <typename Group, typename TriangleMesh>
class Given_transitions
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  template <typename NamedParameters>
  Given_transitions(const TriangleMesh& tmesh, const NamedParameters& np) : m_tmesh(tmesh)
  {
    using CGAL::parameters::get_parameter;
    const auto edge_is_cut = get_parameter(np, CGAL::internal_np::edge_is_cut);
    if constexpr(is_given<std::decay_t<decltype(edge_is_cut)> >)
      m_is_cut = [edge_is_cut, &tmesh](const Halfedge h) -> bool
        { return get(edge_is_cut, edge(h, tmesh)); };
    const auto rotation = get_parameter(np, CGAL::internal_np::halfedge_rotation);
    if constexpr(is_given<std::decay_t<decltype(rotation)> >)
      m_rotation = [rotation](const Halfedge h)
        { return static_cast<int>(get(rotation, h) % Group::order); };
  }

  bool has_cuts() const { return bool(m_is_cut); }
  bool has_rotations() const { return bool(m_rotation); }

  bool is_cut(const Halfedge h) const { return has_cuts() && m_is_cut(h); }

  typename Group::Element rotation(const Halfedge h) const
  { return has_rotations() ? Group::element(m_rotation(h)) : Group::identity(); }

  // Whether what is given of an edge fits together.
  bool is_consistent(const Halfedge h) const
  {
    if(!has_rotations())
      return true;
    const auto g = rotation(h);
    return g == Group::inverse(rotation(opposite(h, m_tmesh))) &&
           (g == Group::identity() || !has_cuts() || is_cut(h));
  }

  // Edges that count as open even if their sides are the same to the bit.
  bool is_cut_anyway(const Halfedge h) const
  {
    return is_cut(h) || rotation(h) != Group::identity() ||
           rotation(opposite(h, m_tmesh)) != Group::identity(); // perhaps not inverse
  }

  // The same, or empty if there is none.
  std::function<bool(Halfedge)> predicate_of_cuts() const
  {
    if(!has_cuts() && !has_rotations())
      return {};
    return [this](const Halfedge h) { return is_cut_anyway(h); };
  }

private:
  const TriangleMesh& m_tmesh;
  std::function<bool(Halfedge)> m_is_cut;
  std::function<int(Halfedge)> m_rotation;
};

// By how much an edge violates [MC19] Eq. (4), times `scale`: for the given rotation, or the best.
template <typename Group, typename TriangleMesh, typename Halfedge>
double transition_violation(const Edge_sides& sides,
                            const Given_transitions<Group, TriangleMesh>& given, const Halfedge h,
                            const double scale)
{
  const Edge_vectors vectors(sides);
  const bool is_known = given.has_rotations() || (given.has_cuts() && !given.is_cut(h));
  Mismatched_edge<Halfedge> edge;
  set_rotation<Group>(edge, vectors, is_known ? given.rotation(h) : vectors.best_fit<Group>(scale),
                      scale);
  return edge.residual;
}

template <typename TriangleMesh, typename VertexIndexMap, typename Halfedge>
std::string
edge_name(const TriangleMesh& tmesh, const VertexIndexMap& vertex_indices, const Halfedge h)
{
  return "the edge between vertices " + std::to_string(get(vertex_indices, source(h, tmesh))) +
         " and " + std::to_string(get(vertex_indices, target(h, tmesh)));
}

// One run; the member functions are its steps, in order.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Transition_reader
{
  using Data = Transition_data<TriangleMesh>;
  using Given = Given_transitions<Group, TriangleMesh>;
  using Halfedge = typename Data::Halfedge;

public:
  Transition_reader(const TriangleMesh& tmesh,
                    const HalfedgeUVMap& uv_map,
                    const VertexIndexMap& vertex_indices,
                    const Given& given,
                    const double tolerance)
    : m_tmesh(tmesh)
    , m_uv_map(uv_map)
    , m_vertex_indices(vertex_indices)
    , m_given(given)
    , m_tolerance(tolerance)
  { }

  Data run();

private:
  bool read_rotations(std::vector<Surveyed_edge<Halfedge>>& surveyed,
                      const Vertex_numbers& numbers,
                      Data& data) const
  {
    for(Surveyed_edge<Halfedge>& s : surveyed)
      if(must_turn(m_tmesh, m_vertex_indices, s))
        s = {{opposite(s.halfedge, m_tmesh), s.target, s.source}, s.sides.turned()};
    data.edges.reserve(surveyed.size());
    for(const std::size_t i : canonical_order(m_tmesh, m_vertex_indices, numbers, surveyed)) {
      data.edges.emplace_back();
      static_cast<Surveyed_edge<Halfedge>&>(data.edges.back()) = surveyed[i];
      if(!read_rotation_of(data.edges.back(), data))
        return false;
    }
    return true;
  }

  bool read_rotation_of(Mismatched_edge<Halfedge>& edge, Data& data) const
  {
    const Edge_vectors vectors(edge.sides);
    measure_length_and_gap<Group>(edge, vectors, m_scale);
    edge.is_cut = !m_given.has_cuts() || m_given.is_cut(edge.halfedge);
    if(m_given.has_rotations()) {
      const auto g = m_given.rotation(edge.halfedge);
      set_rotation<Group>(edge, vectors, g, m_scale);
      if(g != Group::inverse(m_given.rotation(opposite(edge.halfedge, m_tmesh)))) {
        fail(data, Outcome::INVALID_ROTATIONS, edge.halfedge,
             " has rotations that are not inverse to each other; those of opposite halfedges must "
             "add up to a multiple of " + std::to_string(Group::order));
        return false;
      }
      if(g != Group::identity() && !edge.is_cut) {
        fail(data, Outcome::INVALID_ROTATIONS, edge.halfedge,
             " has a rotation, but is no cut edge; make it one, or let it have rotation 0");
        return false;
      }
    } else {
      set_rotation<Group>(edge, vectors, edge.is_cut ? vectors.best_fit<Group>(m_scale)
                                                     : Group::identity(), m_scale);
    }
    return true;
  }

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
    const std::string hint = hint_on_other_symmetry(data);
    fail(data, Outcome::NOT_SEAMLESS, worst->halfedge,
         " has sides that differ by " + short_number(worst_violation / (data.extent * m_scale)) +
         " of the extent, more than the tolerance of " + short_number(m_tolerance) +
         (count > 1 ? ", as with " + counted(count - 1, "other edge") : std::string()) +
         (hint.empty() ? "; if this is the accuracy of the parametrization, raise the tolerance"
                       : hint));
    return false;
  }

  // Given cuts and rotations are those of the symmetry, so that there is no other.
  std::string hint_on_other_symmetry(const Data& data) const
  {
    std::vector<Edge_sides> edges;
    for(const Mismatched_edge<Halfedge>& edge : data.edges)
      edges.push_back(edge.sides);
    return m_given.has_cuts() || m_given.has_rotations()
      ? std::string() : hint_on_symmetry(edges, m_tolerance * data.extent, Group::order);
  }

  // Returns false if an edge takes a rotation from its surroundings that misses by too much.
  bool tell_cuts_from_noise(const Vertex_numbers& numbers, Data& data) const
  {
    double residual = 0;
    for(const Mismatched_edge<Halfedge>& edge : data.edges)
      residual = (std::max)(residual, edge.residual);
    if(std::none_of(data.edges.begin(), data.edges.end(),
                    [&](const Mismatched_edge<Halfedge>& edge) {
                      return edge.length <= 16 * residual || may_be_noise<Group>(edge, residual);
                    }))
      return true;
    const std::vector<Edge_ends> ends = numbers.ends(data.edges);
    const Vertex_incidences incidences(numbers.size(), ends);
    if(!m_given.has_rotations()) {
      data.number_of_edges_decided_by_surroundings =
        Seam_estimator<Group, TriangleMesh, Halfedge>(
          m_tmesh, m_scale, m_tolerance * (data.extent * m_scale), epsilon(), ends, incidences,
          data.edges).run();
      if(data.number_of_edges_decided_by_surroundings > 0 && !check_residuals(data))
        return false;
    }
    if(!m_given.has_cuts())
      mark_merged_edges<Group>(m_tmesh, incidences, data.edges);
    return true;
  }

  static constexpr double epsilon()
  {
    return std::numeric_limits<typename Uv_number<HalfedgeUVMap>::type>::epsilon();
  }

  void fail(Data& data, const Outcome status, const Halfedge h,
            const std::string& what) const
  {
    data.refusal = Refusal(status, edge_name(m_tmesh, m_vertex_indices, h) + what);
    data.edges.clear(); // incomplete
  }

  const TriangleMesh& m_tmesh;
  const HalfedgeUVMap& m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  const Given& m_given;
  double m_tolerance;
  double m_scale = 1; // lengths are measured after multiplication with it
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
Transition_data<TriangleMesh>
Transition_reader<Group, TriangleMesh, HalfedgeUVMap, VertexIndexMap>::run()
{
  Data data;
  if(!(m_tolerance >= 0)) {
    data.refusal = Refusal(Outcome::INVALID_ARGUMENT, "the tolerance is " +
                           short_number(m_tolerance) + "; it must not be negative");
    return data;
  }
  Uv_survey<TriangleMesh> survey =
    survey_uv(m_tmesh, m_uv_map, m_vertex_indices, m_given.predicate_of_cuts());
  data.extent = survey.extent;
  data.refusal = std::move(survey.refusal);
  if(data.refusal)
    return data;
  m_scale = unit_scale(data.extent);
  Vertex_numbers numbers(num_vertices(m_tmesh));
  numbers.mark_ends(survey.mismatched_edges);
  numbers.assign_numbers();
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

// Whether indices are as for CGAL's functions: different, and less than the number of vertices.
// Callers can give others, which would be places outside of arrays.
template <typename TriangleMesh, typename VertexIndexMap>
bool are_valid_indices(const TriangleMesh& tmesh, const VertexIndexMap& vertex_indices)
{
  std::vector<bool> is_taken(std::size_t(num_vertices(tmesh)), false);
  for(const auto v : vertices(tmesh)) {
    const std::size_t i = std::size_t(get(vertex_indices, v));
    if(i >= is_taken.size() || is_taken[i])
      return false;
    is_taken[i] = true;
  }
  return true;
}

// The residual, relative to the extent, up to which a map counts as seamless by default.
constexpr double default_tolerance = 1e-4;

// \param has_given_indices whether the indices are the caller's, and may be wrong
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
Transition_data<TriangleMesh>
read_transitions(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                 const VertexIndexMap& vertex_indices, const bool has_given_indices,
                 const Given_transitions<Group, TriangleMesh>& given, const double tolerance)
{
  if(has_given_indices && !are_valid_indices(tmesh, vertex_indices)) {
    Transition_data<TriangleMesh> data;
    data.refusal = Refusal(Outcome::INVALID_ARGUMENT,
                           "the indices of vertex_index_map must be different, from 0 to " +
                           std::to_string(num_vertices(tmesh)) + " - 1, as many as there are "
                           "vertices; leave the parameter out to have them made");
    return data;
  }
  return Transition_reader<Group, TriangleMesh, HalfedgeUVMap, VertexIndexMap>(
           tmesh, uv_map, vertex_indices, given, tolerance).run();
}

template <typename NamedParameters>
double chosen_tolerance(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::tolerance), default_tolerance);
}

// As the named parameters ask for.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Transition_data<TriangleMesh>
read_transitions(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const NamedParameters& np)
{
  return read_transitions<Group>(tmesh, uv_map, CGAL::get_initialized_vertex_index_map(tmesh, np),
                                 is_given<NamedParameters, CGAL::internal_np::vertex_index_t>,
                                 Given_transitions<Group, TriangleMesh>(tmesh, np),
                                 chosen_tolerance(np));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_TRANSITIONS_H
