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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_ROUND_HOLONOMY_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_ROUND_HOLONOMY_H

#include <CGAL/license/Quad_remeshing.h>

// A field that follows a connection, and its rotations: what the connection turns by around handles
// and from border to border is rounded to quarter turns, and nothing changes around the vertices.

#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

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

// What the connection turns by across the edges adds up to an integer around each vertex, but the
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

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_ROUND_HOLONOMY_H
