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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_COLLAPSE_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_COLLAPSE_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Collapses quads that are inverted or upside down: two opposite vertices become one. Quads as thin
// as a line are collapsed, too, if no place of their vertices helps. Removes vertices of two edges,
// whose quads no place on a flat surface can mend.

#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Quad_star.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the surface of the quads stays what it is, topologically; no other quad becomes
// inverted, no vertex of two edges comes about; lines are not folded, nor are two of them joined
// but at their ends.
class Quad_collapser
  : private Remeshing_types
{
  using Corners = Quad_star::Corners;

public:
  // \param is_feature whether an edge is a feature or border
  Quad_collapser(Mesh& quads, const Feature_map& is_feature, Quad_smoother& smoother,
                 const bool has_single_precision)
    : m_quads(quads), m_is_feature(is_feature), m_smoother(smoother),
      m_star(quads, smoother, has_single_precision)
  { }

  // Returns the number of quads that were taken out.
  std::size_t run()
  {
    std::vector<Face> bad;
    for(const Face f : faces(m_quads))
      if(m_smoother.is_bad(f))
        bad.push_back(f);
    std::size_t result = 0;
    for(const Face f : bad) {
      if(m_quads.is_removed(f))
        continue;
      const Halfedge h = halfedge(f, m_quads);
      for(const Halfedge first : {h, next(h, m_quads)})
        if(m_smoother.is_bad(f) && is_collapsible(first) && meet(first)) {
          join_ends(first);
          ++result;
          break;
        }
    }
    return result;
  }

  // Makes one quad of the two around a vertex of two edges, where one of them is inverted or thin,
  // and that one is better or can be mended. Returns the number of vertices that were removed.
  std::size_t remove_vertices_of_two_edges()
  {
    std::size_t result = 0;
    std::vector<Vertex> queue;
    for(const Vertex v : vertices(m_quads))
      if(degree(v, m_quads) == 2)
        queue.push_back(v);
    while(!queue.empty()) {
      const Vertex v = queue.back();
      queue.pop_back();
      if(!is_removable(v))
        continue;
      const Halfedge h = opposite(halfedge(v, m_quads), m_quads);
      const Halfedge g = prev(h, m_quads); // to the vertex, from the other neighbor
      for(const Vertex neighbor : {target(h, m_quads), source(g, m_quads)})
        if(std::find(queue.begin(), queue.end(), neighbor) == queue.end())
          queue.push_back(neighbor);
      CGAL::Euler::join_vertex(h, m_quads);
      CGAL::Euler::join_face(g, m_quads);
      ++result;
    }
    return result;
  }

private:
  // The ends of two sides, of which the first is given.
  bool is_collapsible(const Halfedge first) const
  {
    std::array<Vertex, 4> corners;
    std::size_t k = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(first, m_quads)) {
      if(m_quads.is_border(m_quads.edge(h)) ||
         (k % 2 == 0 && m_is_feature[m_quads.edge(h)] &&
          m_is_feature[m_quads.edge(next(h, m_quads))]))
        return false;
      corners[k++] = source(h, m_quads);
    }
    const auto [a, b, c, d] = corners;
    if(degree(a, m_quads) < 3 || degree(b, m_quads) < 4 || degree(c, m_quads) < 3 ||
       degree(d, m_quads) < 4 || (is_fixed(a) && is_fixed(c)))
      return false;
    std::size_t number_of_common_neighbors = 0;
    for(const Vertex v : CGAL::vertices_around_target(a, m_quads)) {
      if(v == c)
        return false;
      for(const Vertex w : CGAL::vertices_around_target(c, m_quads))
        number_of_common_neighbors += v == w ? 1 : 0;
    }
    return number_of_common_neighbors == 2;
  }

  bool is_fixed(const Vertex v) const
  { return lines_at_vertex(m_quads, m_is_feature, v).size() > 1; }

  // Moves both ends to the best of some places. Where another quad would be inverted there, they
  // stay where they were.
  bool meet(const Halfedge first)
  {
    const Vertex a = source(first, m_quads), c = target(next(first, m_quads), m_quads);
    m_star.collect({a, c});
    const Space_vector p = m_smoother.point(a), q = m_smoother.point(c);
    std::vector<Space_vector> places;
    if(!is_fixed(c))
      places.push_back(p);
    if(!is_fixed(a))
      places.push_back(q);
    if(places.size() == 2)
      places.push_back(m_smoother.surface().nearest(
        {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}));
    double least = std::numeric_limits<double>::infinity();
    Space_vector best = p;
    for(const Space_vector& place : places) {
      m_star.set_point(a, place);
      m_star.set_point(c, place);
      if(const double now = m_star.energy(Corners::FLAT); now < least && m_star.is_mended()) {
        least = now;
        best = m_smoother.point(a);
      }
    }
    const bool is_better = std::isfinite(least);
    m_smoother.set_point(a, is_better ? best : p);
    m_smoother.set_point(c, is_better ? best : q);
    return is_better;
  }

  // The source of the first one of two sides becomes the target of the other; the quad is gone.
  void join_ends(const Halfedge first)
  {
    const Halfedge second = next(first, m_quads), third = next(second, m_quads);
    const Halfedge fourth = next(third, m_quads);
    for(const auto& [gone, kept] : {std::pair(first, second), std::pair(fourth, third)})
      if(m_is_feature[m_quads.edge(gone)])
        m_is_feature[m_quads.edge(kept)] = true;
    CGAL::Euler::split_face(fourth, second, m_quads);
    const Halfedge diagonal = next(fourth, m_quads);
    CGAL::Euler::join_face(first, m_quads);
    CGAL::Euler::join_face(fourth, m_quads);
    CGAL::Euler::join_vertex(diagonal, m_quads);
  }

  bool is_removable(const Vertex v) const
  {
    if(CGAL::is_border(v, m_quads) || degree(v, m_quads) != 2)
      return false;
    const Halfedge h = opposite(halfedge(v, m_quads), m_quads), g = prev(h, m_quads);
    if(get(m_is_feature, edge(g, m_quads)) || get(m_is_feature, edge(h, m_quads)))
      return false;
    const Vertex a = target(h, m_quads), b = source(g, m_quads);
    const Vertex x = target(next(h, m_quads), m_quads);
    const Vertex y = target(next(opposite(g, m_quads), m_quads), m_quads);
    if(a == b || x == y || degree(a, m_quads) < 3 || degree(b, m_quads) < 3)
      return false;
    const Quad joined{
      {m_smoother.point(a), m_smoother.point(x), m_smoother.point(b), m_smoother.point(y)}};
    const double least =
      (std::min)(scaled_jacobian(m_smoother.quad(face(h, m_quads))),
                 scaled_jacobian(m_smoother.quad(face(opposite(h, m_quads), m_quads))));
    return least <= 0 || (least < thin_quad && scaled_jacobian(joined) > least);
  }

  Mesh& m_quads;
  Feature_map m_is_feature;
  Quad_smoother& m_smoother;
  Quad_star m_star;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_COLLAPSE_QUADS_H
