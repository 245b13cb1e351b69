// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CANCEL_CONES_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CANCEL_CONES_H

#include <CGAL/license/Quad_remeshing.h>

// Cones of opposite index that lie close together cancel: where quads are to be large, a field
// with both of them forces small ones. The rotations across a path from one to the other change.

#include <CGAL/Quad_remeshing/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/cross_field.h>
#include <CGAL/Quad_remeshing/internal/parametrization/field_with_cones.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Shortest paths along edges, up to a length. They don't touch features and the border, nor lead
// between faces whose directions are prescribed.
class Cone_paths
{
public:
  Cone_paths(const Triangle_surface& surface, const std::vector<char>& is_fixed,
             const double longest)
    : m_surface(surface), m_is_fixed(is_fixed), m_longest(longest), m_paths(surface),
      m_is_barrier(surface.is_border)
  {
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
      if(surface.is_aligned[h])
        m_is_barrier[surface.vertex(h)] = m_is_barrier[surface.source(h)] = true;
  }

  // Calls `visit(vertex, distance)` for each vertex that is reached, in the order of distances,
  // until it returns false.
  template <typename Visit>
  void run(const std::size_t start, const Visit& visit)
  {
    m_paths.clear();
    m_paths.add_source(start);
    m_paths.run([&](const std::size_t v) { return !visit(v, m_paths.distance(v)); },
                [&](const Corner_index h, const double distance)
                { return distance <= m_longest && may_follow(h); });
  }

  // Of the path to a vertex that was visited last: calls `visit(halfedge)` for its halfedges, from
  // the end; each leads back to the vertex before.
  template <typename Visit>
  void for_each_edge_to(const std::size_t end, const Visit& visit) const
  {
    for(Corner_index h = m_paths.entered_by(end); h != no_index;
        h = m_paths.entered_by(m_surface.vertex(h)))
      visit(h);
  }

private:
  // Not along the border, whose vertices are barriers.
  bool may_follow(const Corner_index h) const
  {
    return !m_is_barrier[m_surface.source(h)] && !m_is_barrier[m_surface.vertex(h)] &&
           !(m_is_fixed[m_surface.face(h)] && m_is_fixed[m_surface.face(m_surface.opposite(h))]);
  }

  const Triangle_surface& m_surface;
  const std::vector<char>& m_is_fixed; // per face
  double m_longest;
  Shortest_paths m_paths;
  std::vector<char> m_is_barrier; // per vertex
};

// Whether crosses turn on a way around a part of the surface, per component without cones.
inline std::vector<char> has_turns(const Triangle_surface& surface, const Matching& matching)
{
  std::vector<int> turns(std::size_t(surface.number_of_faces()), 0);
  for_each_edge_of_face_trees(
    surface, [](const Corner_index) { return true; },
    [&](const Corner_index h) {
      turns[surface.face(surface.opposite(h))] = turns[surface.face(h)] + matching.turns[h];
    });
  std::vector<char> result(surface.number_of_components, false);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!surface.is_border_edge(h) &&
       (turns[surface.face(h)] + matching.turns[h] - turns[surface.face(surface.opposite(h))]) %
         Quarter_turns::order != 0)
      result[surface.component[surface.face(h)]] = true;
  return result;
}

// The cones of a component, and the paths along which pairs of them have cancelled.
struct Component_cones
{
  bool is_closed = true;
  int sum_of_positive = 0, sum = 0; // of indices
  std::vector<std::vector<Corner_index> > cancelled;

  // No map of a torus has one cone of each sign and no others [Izmestiev et al. 2013], nor one
  // without cones turns.
  bool can_have_map(const bool has_turns) const
  {
    return !is_closed || sum != 0 || sum_of_positive > 1 || (sum_of_positive == 0 && !has_turns);
  }
};

// Changes the rotations such that opposite cones of up to that distance cancel, the closest first;
// the last ones of a torus stay where it has no map without them.
// The deviations of the field are not small after that. Returns the number of pairs.
inline std::size_t cancel_rotations(const Triangle_surface& surface,
                                    const std::vector<double>& angles,
                                    const std::vector<char>& is_fixed, const double distance,
                                    std::vector<int> index, Matching& matching)
{
  constexpr std::size_t most_partners = 8; // in a round: where cones are dense, few are enough
  Cone_paths paths(surface, is_fixed, distance);
  std::vector<Component_cones> components(surface.number_of_components);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    Component_cones& component = components[surface.component_of_vertex(v)];
    component.is_closed = component.is_closed && !surface.is_border[v];
    component.sum_of_positive += (std::max)(index[v], 0);
    component.sum += index[v];
  }
  std::size_t count = 0, before = 0;
  do {
    before = count;
    std::vector<std::tuple<double, std::size_t, std::size_t> > pairs; // the positive one first
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      if(index[v] > 0)
        paths.run(v, [&, most = pairs.size() + most_partners](const std::size_t w, const double d) {
          if(index[w] < 0)
            pairs.emplace_back(d, v, w);
          return pairs.size() < most;
        });
    std::sort(pairs.begin(), pairs.end());
    for(const auto& [d, from, to] : pairs) {
      if(index[from] <= 0 || index[to] >= 0)
        continue;
      paths.run(from, [&, end = to](const std::size_t v, double) { return v != end; });
      Component_cones& component = components[surface.component_of_vertex(from)];
      component.cancelled.emplace_back();
      paths.for_each_edge_to(to, [&](const Corner_index h) {
        set_turns(surface, angles, h, matching.turns[h] - 1, matching);
        component.cancelled.back().push_back(h);
      });
      --component.sum_of_positive;
      --index[from];
      ++index[to];
      ++count;
    }
  } while(count > before);
  const std::vector<char> turns = has_turns(surface, matching);
  for(std::size_t c = 0; c < components.size(); ++c) {
    Component_cones& component = components[c];
    for(; !component.cancelled.empty() && !component.can_have_map(turns[c]);
        component.cancelled.pop_back(), ++component.sum_of_positive, --count)
      for(const Corner_index h : component.cancelled.back())
        set_turns(surface, angles, h, matching.turns[h] + 1, matching);
  }
  return count;
}

// Cancels opposite cones of up to that distance, and makes the field the wanted one with the new
// rotations. Returns whether there were some.
inline bool cancel_cones(const Triangle_surface& surface, const Wanted_field& wanted,
                         const double distance, const std::vector<int>& index,
                         std::vector<double>& angles, Matching& matching, Timed_solver& solver)
{
  std::vector<char> is_fixed;
  for(const Complex& direction : wanted.prescribed)
    is_fixed.push_back(direction != Complex(0));
  if(cancel_rotations(surface, angles, is_fixed, distance, index, matching) == 0)
    return false;
  const std::vector<double> mean_area = component_means(surface, surface.area);
  Prescribed_field crosses = wanted.crosses;
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    crosses[f] *= wanted.strength * surface.area[f] / mean_area[surface.component[f]];
  smoothen_matched_field(surface, is_fixed, crosses, angles, matching, solver);
  return true;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CANCEL_CONES_H
