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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H

#include <CGAL/license/Quad_remeshing.h>

// A field with given cones: the trivial connection of [Crane, Desbrun, Schroeder 2010] with handles
// rounded to quarter turns.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Cross_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/cross_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// A field that follows a connection, and its rotations: what the connection turns by around handles
// and from border to border is rounded to quarter turns, and nothing changes around the vertices.
struct Integrated_field
{
  std::vector<double> angles;    // per face
  std::vector<char> is_followed; // per halfedge: the edge is crossed by the tree of faces
};

// Follows the connection along a spanning tree of the faces of each component.
inline Integrated_field integrate_connection(const Triangle_surface& surface,
                                             const std::vector<double>& deviation)
{
  Integrated_field field{std::vector<double>(surface.number_of_faces(), 0),
                         std::vector<char>(surface.number_of_halfedges(), false)};
  for_each_edge_of_face_trees(
    surface, [](Corner_index) { return true; },
    [&](const Corner_index h) {
      const Flat_face_index g = surface.opposite(h);
      field.is_followed[h] = field.is_followed[g] = true;
      field.angles[surface.face(g)] =
        field.angles[surface.face(h)] + surface.transport(h) - deviation[h];
    });
  return field;
}

// Spanning trees of the vertices along edges that were not followed, from the border, or from one
// vertex of a closed component: halfedges away from the roots, in the order of growth.
inline std::vector<Corner_index> trees_of_vertices(const Triangle_surface& surface,
                                                  const std::vector<char>& is_followed)
{
  std::vector<Corner_index> tree;
  std::vector<std::size_t> queue;
  std::vector<char> is_visited(surface.number_of_vertices(), false);
  const auto visit = [&](const std::size_t v)
  {
    is_visited[v] = true;
    queue.push_back(v);
  };
  std::size_t i = 0;
  const auto grow = [&]()
  {
    for(; i < queue.size(); ++i)
      for_each_corner(surface, queue[i], [&](const Corner_index h) {
        if(surface.is_border_edge(h) || is_followed[h] || is_visited[surface.source(h)])
          return;
        visit(surface.source(h));
        tree.push_back(surface.opposite(h));
      });
  };

  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(surface.is_border[v])
      visit(v);
  grow();
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(!is_visited[v]) {
      visit(v);
      grow();
    }
  return tree;
}

// The turns of the connection across the edges add up to an integer around each vertex, but the
// rounded numbers may not: 0.4 + 0.4 - 0.8 = 0, where three chains of edges meet. Only the edges in
// neither kind of tree are rounded, one for each handle loop and path between borders; then
// the vertices, from the leaves to the roots, determine the others.
inline Matching match_along_connection(const Triangle_surface& surface,
                                       const std::vector<double>& deviation,
                                       const Integrated_field& field)
{
  const Corner_index n = surface.number_of_halfedges();
  std::vector<double> holonomy(n, 0), sum(surface.number_of_vertices(), 0);
  for(Corner_index h = 0; h < n; ++h)
    if(!surface.is_border_edge(h)) {
      holonomy[h] = turn_across(surface, field.angles, h) - deviation[h];
      sum[surface.vertex(h)] += holonomy[h] / quarter_turn;
    }

  Matching matching{std::vector<int>(n, 0), std::vector<double>(n, 0)};
  std::vector<int> missing; // per vertex: the sum of the rotations that are still to be set
  for(const double s : sum)
    missing.push_back(static_cast<int>(std::lround(s)));
  const auto set = [&](const Corner_index h, const int turns)
  {
    set_turns(surface, field.angles, h, turns, matching);
    missing[surface.vertex(h)] -= turns;
    missing[surface.source(h)] += turns;
  };

  const std::vector<Corner_index> tree = trees_of_vertices(surface, field.is_followed);
  std::vector<char> is_in_tree(n, false);
  for(const Corner_index h : tree)
    is_in_tree[h] = is_in_tree[surface.opposite(h)] = true;
  for(Corner_index h = 0; h < n; ++h)
    if(surface.represents_edge(h) && !surface.is_border_edge(h) && !is_in_tree[h])
      set(h, nearest_turns(holonomy[h]));
  for(auto it = tree.rbegin(); it != tree.rend(); ++it)
    set(*it, missing[surface.vertex(*it)]);
  return matching;
}

// A closed component has a field with the given indices if and only if they add up to 4 chi; with a
// border, the border turns by what is missing. The angle of a cone is 4 - index quarter turns.
inline void check_prescribed_indices(const Triangle_surface& surface, const Topology& topo,
                                     const std::vector<int>& index)
{
  std::vector<std::ptrdiff_t> sum(surface.number_of_components, 0);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    if(index[v] >= Quarter_turns::order)
      throw Refusal(Outcome::INVALID_CONES,
                    surface.describe_vertex(v) + " is to have the index "
                    + std::to_string(index[v]) + ": from 4 on, no angle is left for its faces");
    sum[surface.component_of_vertex(v)] += index[v];
  }
  for(std::size_t c = 0; c < surface.number_of_components; ++c) {
    const std::ptrdiff_t expected = Quarter_turns::order * topo.euler_characteristic[c];
    if(topo.border_loops[c] == 0 && sum[c] != expected)
      throw Refusal(Outcome::INVALID_CONES,
                    "the indices of the cones of component " + std::to_string(c) + " add up to "
                    + std::to_string(sum[c]) + "; on this closed surface it must be "
                    + std::to_string(expected));
  }
}

// The smallest deviation across each halfedge that has the given indices around the vertices: the
// gradient of a vertex function, which is 0 on the border.
inline std::vector<double> deviation_of_cones(const Triangle_surface& surface,
                                              const std::vector<int>& index, Timed_solver& solver)
{
  std::vector<std::size_t> unknown(surface.number_of_vertices(), none);
  std::vector<char> has_border(surface.number_of_components, false);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(surface.is_border[v])
      has_border[surface.component_of_vertex(v)] = true;
  std::size_t count = 0;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const std::size_t c = surface.component_of_vertex(v);
    if(!has_border[c])
      has_border[c] = true; // one value of a closed component is arbitrary: also 0
    else if(!surface.is_border[v])
      unknown[v] = count++;
  }

  const auto weight = [&](const Corner_index h) { return 1 / dual_weight(surface, h); };
  Sparse_system system(count, solver);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t i = unknown[surface.vertex(h)], j = unknown[surface.source(h)];
    if(surface.is_border_edge(h) || i == none)
      continue;
    system.add(i, i, weight(h));
    if(j != none)
      system.add(i, j, -weight(h));
  }
  system.factor();

  const std::vector<double> defect = angle_defects(surface);
  std::vector<double> b(count, 0);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(unknown[v] != none)
      b[unknown[v]] = defect[v] - index[v] * quarter_turn;
  const std::vector<double> x = system.solve(b);

  std::vector<double> deviation(surface.number_of_halfedges(), 0);
  const auto potential = [&](std::size_t v) { return unknown[v] == none ? 0 : x[unknown[v]]; };
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!surface.is_border_edge(h))
      deviation[h] = weight(h) * (potential(surface.vertex(h)) - potential(surface.source(h)));
  return deviation;
}

// The smoothest field with the given rotations: turns each cross that is not fixed such that the
// squared deviations become smallest, plus the squared angles to the nearest directions of given
// crosses, with their lengths as weights.
inline void smoothen_matched_field(const Triangle_surface& surface,
                                   const std::vector<char>& is_fixed,
                                   const Prescribed_field& wanted, std::vector<double>& angles,
                                   Matching& matching, Timed_solver& solver)
{
  Sparse_system system(surface.number_of_faces(), solver);
  std::vector<double> b(surface.number_of_faces(), 0);
  std::vector<char> has_anchor(surface.number_of_components, false);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    if(is_fixed[f]) {
      has_anchor[surface.component[f]] = true;
      system.add(f, f, 1);
    } else if(wanted[f] != Complex(0)) {
      has_anchor[surface.component[f]] = true;
      const double weight = std::abs(wanted[f]);
      system.add(f, f, weight);
      b[f] += weight * std::arg(wanted[f] * std::conj(cross_of_angle(angles[f])))
              / Quarter_turns::order;
    }
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Flat_face_index f = surface.face(h);
    if(!has_anchor[surface.component[f]])
      system.add(f, f, 1);
    has_anchor[surface.component[f]] = true;
    if(surface.is_border_edge(h) || is_fixed[f])
      continue;
    const double weight = dual_weight(surface, h);
    system.add(f, f, weight);
    if(!is_fixed[surface.face(surface.opposite(h))])
      system.add(f, surface.face(surface.opposite(h)), -weight);
    b[f] -= weight * matching.deviation[h];
  }
  system.factor();
  const std::vector<double> turn = system.solve(b);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    angles[f] += turn[f];
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!surface.is_border_edge(h))
      matching.deviation[h] += turn[surface.face(h)] - turn[surface.face(surface.opposite(h))];
}

inline std::vector<double> field_with_cones(const Triangle_surface& surface, const Topology& topo,
                                            const std::vector<int>& index, Matching& matching,
                                            Timed_solver& solver)
{
  check_prescribed_indices(surface, topo, index);
  const std::vector<double> deviation = deviation_of_cones(surface, index, solver);
  Integrated_field field = integrate_connection(surface, deviation);
  matching = match_along_connection(surface, deviation, field);
  const std::size_t size = std::size_t(surface.number_of_faces());
  smoothen_matched_field(surface, std::vector<char>(size, false), Prescribed_field(size),
                         field.angles, matching, solver);
  return field.angles;
}

// Cones of opposite index that lie close together cancel: where quads are to be large, a field
// with both of them forces small ones. The rotations across a path from one to the other change.

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

  // Calls `visit(halfedge)` for the halfedges of the path to a vertex that was visited last, from
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

// Keeps the faces that are farther than that from all edges across which the field turns by more
// than an eighth, as it does where rotations have changed.
inline void fix_far_faces(const Triangle_surface& surface, const Matching& matching,
                          const double distance, std::vector<char>& is_fixed)
{
  Shortest_paths paths(surface);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(std::abs(matching.deviation[h]) >= quarter_turn / 2)
      paths.add_source(surface.vertex(h));
  std::vector<char> is_near(surface.number_of_vertices(), false);
  paths.run([&](const std::size_t v) { is_near[v] = true; return false; },
            [&](Corner_index, const double d) { return d <= distance; });
  for(Corner_index h = 0; h < surface.number_of_halfedges(); h += 3)
    if(!is_near[surface.vertex(h)] && !is_near[surface.vertex(h + 1)] &&
       !is_near[surface.vertex(h + 2)])
      is_fixed[surface.face(h)] = true;
}

// Cancels opposite cones of up to that distance, and makes the field the wanted one with the new
// rotations; on large surfaces near these only, because two cones that cancel hardly matter some
// distances away. Returns whether there were some.
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
  constexpr double distances_around = 8; // cone distances; farther faces keep their directions
  if(is_large(surface))
    fix_far_faces(surface, matching, distances_around * distance, is_fixed);
  smoothen_matched_field(surface, is_fixed, crosses, angles, matching, solver);
  return true;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H
