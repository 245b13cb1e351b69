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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H

#include <CGAL/license/Quad_remeshing.h>

// The cut graph: edges through all cones along which the surface opens to one disk per component.

#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Grows shortest paths from a set of vertices that is extended while they grow.
class Shortest_paths
{
public:
  explicit Shortest_paths(const Triangle_surface& surface)
    : m_surface(surface)
    , m_distance(surface.number_of_vertices(), std::numeric_limits<double>::infinity())
    , m_entered_by(surface.number_of_vertices(), no_index)
  { }

  // Takes the time of what has been reached.
  void clear()
  {
    for(const std::size_t v : m_reached)
      m_distance[v] = std::numeric_limits<double>::infinity();
    m_reached.clear();
    m_queue = Queue();
  }

  void add_source(const std::size_t v) { reach(v, 0, no_index); }

  // Settles vertices until `stop(v)`, and returns that one; `none` when all are settled. Paths lead
  // over edges for which may_follow(halfedge, distance up to its end) only.
  template <typename Stop, typename MayFollow>
  std::size_t run(const Stop& stop, const MayFollow& may_follow)
  {
    while(!m_queue.empty()) {
      const auto [d, v] = m_queue.top();
      m_queue.pop();
      if(d > m_distance[v])
        continue;
      relax_neighbors(v, may_follow);
      if(stop(v))
        return v;
    }
    return none;
  }

  template <typename Stop>
  std::size_t run(const Stop& stop)
  { return run(stop, [](Corner_index, double) { return true; }); }

  double distance(const std::size_t v) const { return m_distance[v]; }

  // A halfedge of the last edge on the path to `v`; its other end is the vertex before.
  Corner_index entered_by(const std::size_t v) const { return m_entered_by[v]; }

  std::size_t predecessor(const std::size_t v) const
  {
    const Corner_index h = m_entered_by[v];
    return m_surface.vertex(h) == v ? m_surface.source(h) : m_surface.vertex(h);
  }

private:
  using Entry = std::pair<double, std::size_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> >;

  template <typename MayFollow>
  void relax_neighbors(const std::size_t v, const MayFollow& may_follow)
  {
    const auto relax = [&](const std::size_t to, const Corner_index h) {
      const double d = m_distance[v] + m_surface.length[h];
      if(d < m_distance[to] && may_follow(h, d))
        reach(to, d, h);
    };
    for_each_corner(m_surface, v, [&](const Corner_index h) {
      relax(m_surface.source(h), h);
      const Corner_index out = m_surface.next(h); // has no corner at `v` along the border
      if(m_surface.is_border_edge(out))
        relax(m_surface.vertex(out), out);
    });
  }

  void reach(const std::size_t v, const double distance, const Corner_index h)
  {
    if(m_distance[v] == std::numeric_limits<double>::infinity())
      m_reached.push_back(v);
    m_distance[v] = distance;
    m_entered_by[v] = h;
    m_queue.emplace(distance, v);
  }

  const Triangle_surface& m_surface;
  std::vector<double> m_distance;
  std::vector<Corner_index> m_entered_by;
  std::vector<std::size_t> m_reached;
  Queue m_queue;
};

// Invariant: the complement of the cut edges is connected in each component.
class Cut_graph
{
public:
  explicit Cut_graph(const Triangle_surface& surface)
    : m_surface(surface)
    , m_is_cut(surface.number_of_halfedges(), false)
    , m_is_reached(surface.is_border)
  {
    open_handles();
  }

  // Connects the vertices that `is_cone` holds for, each to the nearest part of the graph. Paths
  // that are attached at one end only leave the complement a disk.
  void connect(const std::vector<char>& is_cone)
  {
    Shortest_paths paths(m_surface);
    std::vector<char> has_source(m_surface.number_of_components, false);
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      if(m_is_reached[v]) {
        has_source[m_surface.component_of_vertex(v)] = true;
        paths.add_source(v);
      }
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      if(is_cone[v] && !has_source[m_surface.component_of_vertex(v)]) {
        has_source[m_surface.component_of_vertex(v)] = true;
        m_is_reached[v] = true;
        paths.add_source(v);
      }

    const auto is_unreached_cone = [&](const std::size_t v)
    {
      return is_cone[v] && !m_is_reached[v];
    };
    for(std::size_t v = paths.run(is_unreached_cone); v != none;
        v = paths.run(is_unreached_cone)) {
      while(!m_is_reached[v]) {
        m_is_reached[v] = true;
        cut(paths.entered_by(v));
        const std::size_t w = paths.predecessor(v);
        paths.add_source(v);
        v = w;
      }
    }
  }

  const std::vector<char>& is_cut() const { return m_is_cut; }

private:
  void cut(const Corner_index h)
  {
    m_is_cut[h] = true;
    if(!m_surface.is_border_edge(h))
      m_is_cut[m_surface.opposite(h)] = true;
  }

  // A system of short loops, and paths between border loops: with T the shortest paths from the
  // border (or from one vertex) and T* a spanning tree of the dual graph that crosses the most
  // costly edges first, the edges in neither close one loop each [Erickson and Whittlesey 2005].
  void open_handles()
  {
    Shortest_paths paths(m_surface);
    std::vector<char> has_source(m_surface.number_of_components, false);
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      if(m_surface.is_border[v])
        add_root(v, paths, has_source);
    for(Flat_face_index f = 0; f < m_surface.number_of_faces(); ++f)
      if(!has_source[m_surface.component[f]])
        add_root(m_surface.vertex(3 * f), paths, has_source);
    paths.run([](std::size_t) { return false; });

    std::vector<char> is_reached = m_surface.is_border;
    for(const Corner_index h : edges_outside_of_trees(paths)) {
      cut(h);
      for(std::size_t v : {m_surface.source(h), m_surface.vertex(h)})
        for(; !is_reached[v] && paths.entered_by(v) != no_index; v = paths.predecessor(v)) {
          is_reached[v] = true;
          cut(paths.entered_by(v));
        }
    }
    prune();
    for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
      if(m_is_cut[h])
        m_is_reached[m_surface.vertex(h)] = true;
  }

  void add_root(const std::size_t v, Shortest_paths& paths, std::vector<char>& has_source) const
  {
    has_source[m_surface.component_of_vertex(v)] = true;
    paths.add_source(v);
  }

  std::vector<Corner_index> edges_outside_of_trees(const Shortest_paths& paths) const
  {
    std::vector<char> in_tree(m_surface.number_of_halfedges(), false);
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      const Corner_index h = paths.entered_by(v);
      if(h == no_index)
        continue;
      in_tree[h] = true;
      if(!m_surface.is_border_edge(h))
        in_tree[m_surface.opposite(h)] = true;
    }

    std::vector<std::pair<double, Corner_index> > candidates;
    for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
      if(m_surface.represents_edge(h) && !m_surface.is_border_edge(h) && !in_tree[h])
        candidates.emplace_back(-(paths.distance(m_surface.source(h))
                                  + paths.distance(m_surface.vertex(h)) + m_surface.length[h]), h);
    std::sort(candidates.begin(), candidates.end());

    boost::disjoint_sets_with_storage<> trees(std::size_t(m_surface.number_of_faces()));
    std::vector<Corner_index> remaining;
    for(const auto& [cost, h] : candidates) {
      const auto f = std::size_t(m_surface.face(h));
      const auto g = std::size_t(m_surface.face(m_surface.opposite(h)));
      if(trees.find_set(f) == trees.find_set(g))
        remaining.push_back(h);
      trees.union_set(f, g);
    }
    return remaining;
  }

  // Removes dead ends in the interior: the common part of the two paths of a loop.
  void prune()
  {
    std::vector<std::size_t> degree(m_surface.number_of_vertices(), 0), stack;
    for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
      if(m_is_cut[h])
        ++degree[m_surface.vertex(h)];
    const auto is_dead_end = [&](const std::size_t v)
    {
      return degree[v] == 1 && !m_surface.is_border[v];
    };
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      if(is_dead_end(v))
        stack.push_back(v);
    while(!stack.empty()) {
      const std::size_t v = stack.back();
      stack.pop_back();
      if(!is_dead_end(v))
        continue;
      for_each_corner(m_surface, v, [&](const Corner_index h) {
        if(!m_is_cut[h])
          return;
        m_is_cut[h] = m_is_cut[m_surface.opposite(h)] = false;
        const std::size_t w = m_surface.source(h);
        --degree[v];
        --degree[w];
        if(is_dead_end(w))
          stack.push_back(w);
      });
    }
  }

  const Triangle_surface& m_surface;
  std::vector<char> m_is_cut;     // per halfedge
  std::vector<char> m_is_reached; // per vertex: on the border or on the graph
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H
