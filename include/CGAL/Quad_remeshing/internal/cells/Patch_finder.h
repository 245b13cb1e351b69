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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_PATCH_FINDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_PATCH_FINDER_H

#include <CGAL/license/Quad_remeshing.h>

// Divides a quad mesh into rectangular patches, as `motorcycle_graph()` divides a parametrized
// surface; but curves run along the edges of quads, so that there is nothing but combinatorics.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/types/Quad_patches.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// \pre all faces are quads, and the faces around each vertex form one fan
template <typename QuadMesh, typename FeatureMap>
class Patch_finder
{
  using Graph_traits = boost::graph_traits<QuadMesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Edge = typename Graph_traits::edge_descriptor;
  using Face = typename Graph_traits::face_descriptor;
  template <typename Tag>
  using Map = typename boost::property_map<QuadMesh, Tag>::const_type;

public:
  // \param features tells for each edge whether it is to lie between patches
  // \param may_cross whether curves run on where they meet others
  Patch_finder(const QuadMesh& mesh, const FeatureMap& features, const bool may_cross)
    : m_mesh(mesh), m_may_cross(may_cross),
      m_is_arc(get(CGAL::dynamic_edge_property_t<char>(), mesh)),
      m_arrives(get(CGAL::dynamic_halfedge_property_t<char>(), mesh)),
      m_kind(get(CGAL::dynamic_vertex_property_t<Kind>(), mesh)),
      m_is_covered(get(CGAL::dynamic_face_property_t<char>(), mesh))
  {
    for(const Edge e : edges(mesh))
      put(m_is_arc, e, is_border(e, mesh) || get(features, e));
    for(const Halfedge h : halfedges(mesh))
      put(m_arrives, h, false);
    for(const Face f : faces(mesh))
      put(m_is_covered, f, false);
    for(const Vertex v : vertices(mesh))
      put(m_kind, v, kind_at_start(v));
  }

  // Calls `put_patch(face, i)` for all faces of patch i. Returns what is wrong, if so.
  template <typename Put_patch>
  std::optional<Refusal> run(Quad_patches<QuadMesh>& result, const Put_patch& put_patch)
  {
    add_seeds();
    race();
    for(const Face f : faces(m_mesh))
      if(!get(m_is_covered, f)) {
        const Quad_patch<QuadMesh> patch = patch_around(f);
        if(!cover(patch, [&](const Face g) { put_patch(g, result.patches.size()); }))
          return Refusal(Outcome::INTERNAL_ERROR,
                         "patches failed the check that they are rectangles; please report this");
        result.patches.push_back(patch);
      }
    for(const Vertex v : vertices(m_mesh))
      result.number_of_t_junctions += is_t_junction(v) ? 1 : 0;
    return std::nullopt;
  }

private:
  // The things that a curve can meet at a vertex: nothing, a curve, a wall (a border or feature
  // that runs straight on), or a node, at which curves start. `add_seeds()` has the same order.
  enum class Kind : char { FREE, CURVE, WALL, NODE };

  bool is_arc(const Halfedge h) const { return get(m_is_arc, edge(h, m_mesh)); }
  Kind kind(const Halfedge h) const { return get(m_kind, target(h, m_mesh)); }

  // The sides of a quad, seen from its lower one; and the lower sides of the quads around.
  Halfedge right(const Halfedge h) const { return next(h, m_mesh); }
  Halfedge top(const Halfedge h) const { return next(next(h, m_mesh), m_mesh); }
  Halfedge left(const Halfedge h) const { return prev(h, m_mesh); }
  Halfedge go_right(const Halfedge h) const { return next(opposite(right(h), m_mesh), m_mesh); }
  Halfedge go_up(const Halfedge h) const { return opposite(top(h), m_mesh); }
  Halfedge go_left(const Halfedge h) const { return prev(opposite(left(h), m_mesh), m_mesh); }
  Halfedge go_down(const Halfedge h) const { return top(opposite(h, m_mesh)); }

  // Before there are curves. Nothing starts where two walls leave two quads on each side, or on one
  // side of a border.
  Kind kind_at_start(const Vertex v) const
  {
    if(halfedge(v, m_mesh) == Graph_traits::null_halfedge())
      return Kind::FREE; // there are no faces
    std::size_t number_of_quads = 0, number_of_walls = 0;
    std::size_t quads_before[2] = {0, 0}; // the first two walls
    for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh)) {
      if(is_arc(h) && number_of_walls++ < 2)
        quads_before[number_of_walls - 1] = number_of_quads;
      number_of_quads += is_border(h, m_mesh) ? 0 : 1;
    }
    if(number_of_walls == 0)
      return number_of_quads == 4 ? Kind::FREE : Kind::NODE;
    const std::size_t between = quads_before[1] - quads_before[0];
    const std::size_t others = number_of_quads - between;
    const auto is_straight = [](const std::size_t n) { return n == 0 || n == 2; };
    return number_of_walls == 2 && is_straight(between) && is_straight(others) ? Kind::WALL
                                                                               : Kind::NODE;
  }

  // Makes a node of one vertex in each part between walls that has none; on a wall, where there is
  // one, because its curves make fewer patches.
  void add_seeds()
  {
    const auto is_reached = get(CGAL::dynamic_face_property_t<char>(), m_mesh);
    for(const Face f : faces(m_mesh))
      put(is_reached, f, false);
    std::vector<Face> part;
    for(const Face first : faces(m_mesh)) {
      if(get(is_reached, first))
        continue;
      Vertex seed = target(halfedge(first, m_mesh), m_mesh);
      part.assign(1, first);
      put(is_reached, first, true);
      while(!part.empty()) {
        const Face f = part.back();
        part.pop_back();
        for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
          if(kind(h) > get(m_kind, seed))
            seed = target(h, m_mesh);
          const Face g = face(opposite(h, m_mesh), m_mesh);
          if(!is_arc(h) && !get(is_reached, g)) {
            put(is_reached, g, true);
            part.push_back(g);
          }
        }
      }
      put(m_kind, seed, Kind::NODE);
    }
  }

  // Curves leave the nodes along all edges that are no walls, an edge at a time, and mark them.
  // Each edge is passed once, which bounds the race.
  void race()
  {
    std::vector<Halfedge> curves, arrived; // next, and in this round
    for(const Halfedge h : halfedges(m_mesh))
      if(!is_arc(h) && get(m_kind, source(h, m_mesh)) == Kind::NODE)
        curves.push_back(h);
    while(!curves.empty()) {
      arrived.clear();
      for(const Halfedge h : curves)
        if(!is_arc(h)) { // else two have met head on
          put(m_is_arc, edge(h, m_mesh), true);
          put(m_arrives, h, true);
          arrived.push_back(h);
        }
      curves.clear();
      for(const Halfedge h : arrived)
        if(const Halfedge on = go_right(h); runs_on(h, on))
          curves.push_back(on);
      for(const Halfedge h : arrived) {
        put(m_arrives, h, false);
        if(kind(h) == Kind::FREE)
          put(m_kind, target(h, m_mesh), Kind::CURVE);
      }
    }
  }

  // If curves meet at the same time, the curve ends that has the other curve on its right.
  bool runs_on(const Halfedge h, const Halfedge on) const
  {
    if(kind(h) == Kind::NODE || kind(h) == Kind::WALL || is_arc(on))
      return false;
    const Halfedge from_right = prev(opposite(h, m_mesh), m_mesh);
    return m_may_cross || (kind(h) == Kind::FREE && !get(m_arrives, from_right));
  }

  // The patch of a quad. Where it were none, walks end when they have seen as many quads as there
  // are.
  Quad_patch<QuadMesh> patch_around(const Face f) const
  {
    const std::size_t number = num_faces(m_mesh);
    Halfedge h = halfedge(f, m_mesh);
    for(std::size_t i = 0; i < number && !is_arc(left(h)); ++i)
      h = go_left(h);
    for(std::size_t i = 0; i < number && !is_arc(h); ++i)
      h = go_down(h);
    Quad_patch<QuadMesh> result{h, 1, 1};
    for(Halfedge g = h; result.width < number && !is_arc(right(g)); g = go_right(g))
      ++result.width;
    for(Halfedge g = h; result.height < number && !is_arc(top(g)); g = go_up(g))
      ++result.height;
    return result;
  }

  // Whether arcs are around the patch, and none inside, and no quad has been met before.
  template <typename Visit>
  bool cover(const Quad_patch<QuadMesh>& patch, const Visit& visit)
  {
    Halfedge row = patch.corner;
    for(std::size_t j = 0; j < patch.height; ++j) {
      Halfedge h = row;
      for(std::size_t i = 0; i < patch.width; ++i) {
        const Face f = face(h, m_mesh);
        if(get(m_is_covered, f) || is_arc(h) != (j == 0) || is_arc(left(h)) != (i == 0) ||
           is_arc(top(h)) != (j + 1 == patch.height) || is_arc(right(h)) != (i + 1 == patch.width))
          return false;
        put(m_is_covered, f, true);
        visit(f);
        if(i + 1 < patch.width)
          h = go_right(h);
      }
      if(j + 1 < patch.height)
        row = go_up(row);
    }
    return true;
  }

  bool is_t_junction(const Vertex v) const
  {
    if(get(m_kind, v) != Kind::CURVE && get(m_kind, v) != Kind::WALL)
      return false;
    std::size_t number_of_arcs = 0, number_of_quads = 0;
    for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh)) {
      number_of_arcs += is_arc(h) ? 1 : 0;
      number_of_quads += is_border(h, m_mesh) ? 0 : 1;
    }
    return number_of_arcs == 3 && number_of_quads == 4;
  }

  const QuadMesh& m_mesh;
  bool m_may_cross;
  Map<CGAL::dynamic_edge_property_t<char> > m_is_arc;          // between patches
  Map<CGAL::dynamic_halfedge_property_t<char> > m_arrives;     // a curve, in this round
  Map<CGAL::dynamic_vertex_property_t<Kind> > m_kind;
  Map<CGAL::dynamic_face_property_t<char> > m_is_covered;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_PATCH_FINDER_H
