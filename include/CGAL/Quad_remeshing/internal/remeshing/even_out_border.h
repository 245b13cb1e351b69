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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_EVEN_OUT_BORDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_EVEN_OUT_BORDER_H

#include <CGAL/license/Quad_remeshing.h>

// Borders that lie on no isocurve are followed in steps. At the corners of steps of a straight
// border, one quad and three quads meet in turn, so that the one has an angle of 180 degrees. Edges
// of quads next to the border are moved until there are two and two. In large steps, some quads lie
// on the border with all vertices; they are removed before.

#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: all faces are quads, and no vertex moves.
class Border_evener
  : private Remeshing_types
{
public:
  // \param is_feature of the edges of the quads
  // \param surface the surface on whose border the border of the quads lies
  Border_evener(Mesh& quads, const Feature_map& is_feature, const Mesh& surface)
    : m_quads(quads), m_is_feature(is_feature)
  {
    for(const auto h : surface.halfedges())
      if(!surface.is_border(h) && surface.is_border(surface.target(h)))
        m_angles[surface.point(surface.target(h))] += angle_to_next(surface, h);
  }

  // At most `farthest` edges of quads are moved for each vertex of the border.
  void run()
  {
    remove_flat_quads();
    std::set<Halfedge> is_known;
    std::vector<std::vector<Vertex> > loops;
    for(const Halfedge h : m_quads.halfedges())
      if(m_quads.is_border(h) && is_known.count(h) == 0) {
        loops.emplace_back();
        for(const Halfedge g : CGAL::halfedges_around_face(h, m_quads)) {
          is_known.insert(g);
          loops.back().push_back(m_quads.target(g));
        }
      }
    for(std::vector<Vertex>& loop : loops) {
      m_loop = std::move(loop);
      run_on_loop();
    }
  }

private:
  static constexpr std::ptrdiff_t farthest = 8; // edges along the border

  // From the corners of steps on.
  void remove_flat_quads()
  {
    std::vector<Vertex> corners(m_quads.vertices().begin(), m_quads.vertices().end());
    while(!corners.empty()) {
      const Vertex v = corners.back();
      corners.pop_back();
      if(m_quads.is_removed(v) || !m_quads.is_border(v) || m_quads.degree(v) != 2 ||
         wanted(v) != 2)
        continue;
      const Halfedge at_corner = m_quads.halfedge(v);
      const Halfedge h = m_quads.is_border(at_corner) ? m_quads.opposite(at_corner)
                                                      : m_quads.next(at_corner);
      const Halfedge to_opposite = m_quads.next(h);
      if(m_quads.is_border(m_quads.target(to_opposite)) || !is_flat(h))
        continue;
      corners.push_back(m_quads.target(h));
      corners.push_back(m_quads.target(m_quads.next(to_opposite)));
      m_is_feature[m_quads.edge(to_opposite)] = true;
      m_is_feature[m_quads.edge(m_quads.next(to_opposite))] = true;
      CGAL::Euler::remove_face(h, m_quads);
    }
    m_quads.collect_garbage();
  }

  // Up to rounding, which is far below what a quad inside has.
  bool is_flat(const Halfedge h) const
  {
    std::array<Point, 4> p;
    Halfedge g = h;
    for(Point& q : p) {
      q = m_quads.point(m_quads.target(g));
      g = m_quads.next(g);
    }
    const double size = CGAL::squared_distance(p[0], p[2]) + CGAL::squared_distance(p[1], p[3]);
    const auto is_small = [&](const std::size_t i, const std::size_t j, const std::size_t k) {
      return CGAL::cross_product(p[j] - p[i], p[k] - p[i]).squared_length() <=
             1e-20 * size * size;
    };
    return is_small(0, 1, 2) && is_small(0, 2, 3) && is_small(1, 2, 3);
  }

  // Vertices near by come first.
  void run_on_loop()
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_loop.size());
    for(std::ptrdiff_t distance = 1; distance <= (std::min)(farthest, n - 1); ++distance)
      for(std::ptrdiff_t i = 0; i < n; ++i)
        for(const std::ptrdiff_t along : {1, -1})
          if(excess(at(i)) < 0 && excess(at(i + along * distance)) > 0)
            pass_on(i + along * distance, i);
  }

  Vertex at(const std::ptrdiff_t i) const
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_loop.size());
    return m_loop[std::size_t((i + n) % n)];
  }

  // The number of quads at a border vertex beyond the wanted one.
  int excess(const Vertex v) const { return int(m_quads.degree(v)) - 1 - wanted(v); }

  // As many as make angles that are nearest to 90 degrees. Vertices that are not on the surface's
  // lie on its edges.
  int wanted(const Vertex v) const
  {
    const auto found = m_angles.find(m_quads.point(v));
    return found == m_angles.end() ? 2 : (std::max)(1, int(std::lround(found->second / 90)));
  }

  // A quad from one vertex of the border to another one, not across corners.
  void pass_on(const std::ptrdiff_t from, const std::ptrdiff_t to)
  {
    const std::ptrdiff_t step = from < to ? 1 : -1;
    for(std::ptrdiff_t i = from + step; i != to; i += step)
      if(wanted(at(i)) != 2)
        return;
    for(std::ptrdiff_t i = from; i != to; i += step)
      if(!move_edge(at(i), at(i + step)))
        return;
  }

  // An edge inside that ends at a vertex of the border comes to end at the next one: the diagonal
  // of two quads becomes another one. Returns false if it can't.
  bool move_edge(const Vertex from, const Vertex to)
  {
    Halfedge side = m_quads.halfedge(to, from);
    const bool is_left = !m_quads.is_border(side);
    if(!is_left)
      side = m_quads.opposite(side);
    const Halfedge h = is_left ? m_quads.next(side) : m_quads.prev(side);
    const Halfedge opposite = m_quads.opposite(h);
    const Vertex inside = is_left ? m_quads.target(h) : m_quads.source(h);
    if(m_quads.is_border(opposite) || m_is_feature[m_quads.edge(h)] || !can_spare(inside))
      return false;
    // In the face of six vertices, `to` and its opposite are the targets of these.
    const Halfedge at_to = is_left ? m_quads.prev(side) : side;
    const Halfedge at_other =
      is_left ? m_quads.next(m_quads.next(opposite)) : m_quads.next(opposite);
    const Vertex other = m_quads.target(at_other);
    if(has_repeated_vertex(h) || m_quads.halfedge(to, other) != Mesh::null_halfedge())
      return false;
    CGAL::Euler::join_face(h, m_quads);
    const Halfedge moved = CGAL::Euler::split_face(at_to, at_other, m_quads);
    m_is_feature[m_quads.edge(moved)] = false;
    return true;
  }

  bool can_spare(const Vertex v) const
  { return m_quads.is_border(v) ? excess(v) > 0 : m_quads.degree(v) > 3; }

  // Whether the two quads at an edge meet elsewhere, too.
  bool has_repeated_vertex(const Halfedge h) const
  {
    std::vector<Vertex> v;
    for(const Halfedge g : {h, m_quads.opposite(h)})
      for(const Vertex w : CGAL::vertices_around_face(g, m_quads))
        v.push_back(w);
    std::sort(v.begin(), v.end());
    return std::unique(v.begin(), v.end()) - v.begin() < 6;
  }

  Mesh& m_quads;
  Feature_map m_is_feature;
  std::map<Point, double> m_angles; // of the surface, at the vertices of its border
  std::vector<Vertex> m_loop;       // the vertices of a border
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_EVEN_OUT_BORDER_H
