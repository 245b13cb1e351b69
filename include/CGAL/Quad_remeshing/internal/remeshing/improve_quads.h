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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_IMPROVE_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_IMPROVE_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Improves quads that smoothing leaves inverted or thin: moves their vertices and the vertices next
// to them along the surface or their feature, in any direction that helps. Removes vertices of two
// edges, whose quads no place on a flat surface can mend.

#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: vertices stay on the surface, and on the features and borders where they are; they do
// not move at all where these turn or meet.
class Quad_improver
  : private Remeshing_types
{
public:
  // \param is_feature whether an edge is a feature or border
  Quad_improver(Mesh& quads, const Feature_map& is_feature, const Feature_lines& lines,
                Quad_smoother& smoother)
    : m_quads(quads), m_is_feature(is_feature), m_lines(lines), m_smoother(smoother)
  { }

  void move_vertices()
  {
    m_last_move.assign(m_quads.num_vertices(), 0);
    m_last_try = m_last_move;
    for(std::size_t round = 0; round < largest_number_of_rounds; ++round) {
      bool has_changed = false;
      for(const Vertex v : vertices_near_thin_quads())
        has_changed = move(v) || has_changed;
      if(!has_changed)
        return;
    }
  }

  // Moves vertices of quads that are still inverted or flat, whatever that costs the quads around.
  // Cones on a feature slide, too, if it is straight enough in space.
  void move_vertices_of_flat_quads()
  {
    m_thin = flat;
    m_steepness = 50;
    move_vertices();
    m_thin = thin;
    m_steepness = 8;
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
  // The vertices of the quads to improve, and their neighbors. The worst come first; otherwise
  // their neighbors adapt to them.
  std::vector<Vertex> vertices_near_thin_quads()
  {
    std::vector<Vertex> result;
    std::set<Vertex> is_known;
    const auto add = [&](const Vertex v) {
      if(is_known.insert(v).second)
        result.push_back(v);
    };
    for(const Face f : faces(m_quads)) {
      if(scaled_jacobian(m_smoother.quad(f)) >= m_thin)
        continue;
      for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads)) {
        add(v);
        for(const Vertex w : CGAL::vertices_around_target(v, m_quads))
          add(w);
      }
    }
    std::vector<std::pair<double, Vertex> > order;
    for(const Vertex v : result) {
      collect_star(v);
      order.emplace_back(badness(), v);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::transform(order.begin(), order.end(), result.begin(),
                   [](const auto& entry) { return entry.second; });
    return result;
  }

  // Tries shorter steps as long as none helps; not again where nothing around has changed since.
  bool move(const Vertex v)
  {
    collect_star(v);
    if(!is_worth_a_try(v))
      return false;
    m_last_try[v] = ++m_time;
    const double before = badness();
    const Space_vector old = m_smoother.point(v);
    for(double step = 1; step > 0.02; step /= 2) {
      double least = before;
      Space_vector best = old;
      for(const Space_vector& p : m_lines_at_vertex.empty() ? places_around(v, step, before)
                                                            : places_on_line(old, step)) {
        m_smoother.set_point(v, p);
        const double now = badness();
        if(now < least) {
          least = now;
          best = p;
        }
      }
      m_smoother.set_point(v, best);
      if(least < 0.99 * before) {
        m_last_move[v] = m_time;
        return true;
      }
      m_smoother.set_point(v, old);
    }
    return false;
  }

  bool is_worth_a_try(const Vertex v) const
  {
    for(const Face f : m_star)
      for(const Vertex w : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
        if(m_last_move[w] >= m_last_try[v])
          return true;
    return false;
  }

  // In eight directions; where a place beside the surface is far worse, the one on it is not found.
  std::vector<Space_vector> places_around(const Vertex v, const double step, const double before)
  {
    std::vector<Space_vector> result;
    const Space_vector from = m_smoother.point(v);
    for(const Space_vector& d : m_plane.directions(step * m_plane.longest_edge)) {
      const Space_vector p{from[0] + d[0], from[1] + d[1], from[2] + d[2]};
      m_smoother.set_point(v, p);
      if(badness() < far_worse * before)
        result.push_back(m_smoother.nearest(p, from));
    }
    m_smoother.set_point(v, from);
    return result;
  }

  // Toward both neighbors, before which the vertex stays. None where the line turns in the grid.
  std::vector<Space_vector> places_on_line(const Space_vector& from, const double step) const
  {
    std::vector<Space_vector> result;
    if(!goes_straight(m_quads, m_lines_at_vertex) && !(m_thin == flat && is_straight_in_space()))
      return result;
    for(const Halfedge h : m_lines_at_vertex) {
      const Space_vector d = vector_to(from, m_smoother.point(source(h, m_quads)));
      if(const auto p = m_lines.slide(to_point(from), m_quads.point(source(h, m_quads)),
                                      0.5 * step * norm(d)))
        result.push_back(to_vector(*p));
    }
    return result;
  }

  // Up to 20 degrees.
  bool is_straight_in_space() const
  {
    if(m_lines_at_vertex.size() != 2)
      return false;
    const Halfedge g = m_lines_at_vertex[0], h = m_lines_at_vertex[1];
    const Space_vector p = m_smoother.point(target(h, m_quads));
    const Space_vector a = scaled_to_one(vector_to(p, m_smoother.point(source(g, m_quads))));
    const Space_vector b = scaled_to_one(vector_to(p, m_smoother.point(source(h, m_quads))));
    return inner_product(a, b) < -0.94;
  }

  void collect_star(const Vertex v)
  {
    m_star.clear();
    m_normals.clear();
    m_lines_at_vertex = lines_at_vertex(m_quads, m_is_feature, v);
    m_plane = m_smoother.visit_star(v, [&](const Face f, const Quad& q, const Space_vector&) {
      m_star.push_back(f);
      m_normals.push_back(upper_side(f, q));
    });
  }

  // Where a quad is to face, with the surface as it was beside it before any of its vertices moved.
  Space_vector upper_side(const Face f, const Quad& q)
  {
    const auto [it, is_new] = m_upper_side.try_emplace(f);
    if(is_new)
      it->second = m_smoother.normal_of_surface(q);
    return upper_side_or_own(q, it->second);
  }

  // Grows fast where quads are inverted. Quads that turn over are worst of all.
  double badness() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_star.size(); ++i) {
      const auto q = m_smoother.quad(m_star[i]);
      const Space_vector normal = quad_normal(q);
      sum += inner_product(normal, m_normals[i]) > 0
               ? std::exp(-m_steepness * scaled_jacobian(q, normal))
               : std::exp(2 * m_steepness);
    }
    return sum;
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
    return least <= 0 || (least < thin && scaled_jacobian(joined) > least);
  }

  static constexpr double thin = 0.2, flat = 0.02; // as scaled Jacobians
  static constexpr double far_worse = 10;          // as a ratio of badness
  static constexpr std::size_t largest_number_of_rounds = 10; // rounds over all thin quads

  Mesh& m_quads;
  Feature_map m_is_feature;
  const Feature_lines& m_lines;
  Quad_smoother& m_smoother;
  double m_thin = thin, m_steepness = 8;
  std::map<Face, Space_vector> m_upper_side;
  std::vector<std::size_t> m_last_move, m_last_try; // per vertex: when
  std::size_t m_time = 0;
  // scratch: of the vertex that moves
  std::vector<Face> m_star;
  std::vector<Space_vector> m_normals; // where the faces are to face
  std::vector<Halfedge> m_lines_at_vertex;
  Star_plane m_plane;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_IMPROVE_QUADS_H
