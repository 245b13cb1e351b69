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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MISMATCHED_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MISMATCHED_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The mismatched edges of a uv map, whose two sides have different coordinates: by how much their
// transitions miss, in an order that does not depend on the mesh data structure, and which of them
// meet at which vertex.

#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// An edge, by one of its halfedges, and the mesh's indices of its ends.
template <typename Halfedge>
struct Indexed_edge
{
  Halfedge halfedge;
  std::size_t source, target;
};

// The coordinates of the sides of a mismatched edge, so that the mesh need not be asked again; and
// what they tell, once the edge is directed towards its end of larger index.
struct Measured_edge
{
  Edge_sides sides{};
  int rotation = 0;      // element of the transition from face(halfedge) to the opposite face
  bool is_cut = true;    // else the corners of both sides are merged
  bool is_exact = false; // whether [MC19] Eq. (4) holds exactly
  // in units of the extent, rounded up to a power of two:
  double residual = 0;   // by how much [MC19] Eq. (4) is violated
  double length = 0;     // edge
  double gap = 0;        // between the sides: for k = 0 the length of the translation
};

template <typename Halfedge>
struct Mismatched_edge
  : Indexed_edge<Halfedge>, Measured_edge
{ };

// --- measures: up to rounding, in units that keep the smallest and the largest maps in range

// The power of two by which lengths are multiplied.
inline double unit_scale(const double extent)
{
  int exponent = 0;
  std::frexp(extent, &exponent);
  return std::ldexp(1., (std::min)(-exponent, 1000));
}

// Measures [MC19] Eq. (4) for one rotation. \pre the coordinates are in range
template <typename Group>
void set_rotation(Measured_edge& edge, const Side_vectors<Group>& vectors,
                  const typename Group::Element g, const double scale)
{
  edge.rotation = g;
  edge.is_exact = vectors.match(g);
  edge.residual = edge.is_exact ? 0 : vectors.residual(g, scale);
}

template <typename Group>
void measure_length_and_gap(Measured_edge& edge, const Side_vectors<Group>& vectors,
                            const double scale)
{
  const Edge_sides& sides = edge.sides;
  edge.length = vectors.length(scale);
  const auto gap = [&](const Uv& u, const Uv& v) {
    return scale * Group::norm({u[0] - v[0], u[1] - v[1]});
  };
  edge.gap = (std::max)(gap(sides.a, sides.a_opposite), gap(sides.b, sides.b_opposite));
}

// The product of the rotations around a vertex, counterclockwise, but for one edge. Without
// exception it is the rotation of the index: crossing counterclockwise over an edge leads from the
// face of the halfedge that points to the vertex to the opposite one, and the angles of the sectors
// make up the rest of a full turn.
template <typename Group, typename Edges>
typename Group::Element holonomy(const Vertex_incidences& incidences, const Edges& edges,
                                 const Vertex_index v, const Edge_index except = -1)
{
  auto product = Group::identity(); // the elements commute, as all rotations of the plane do
  for(const Incidence& i : incidences[v])
    if(i.edge != except) {
      const auto g = edges[std::size_t(i.edge)].rotation;
      product = Group::compose(i.points_to_vertex ? g : Group::inverse(g), product);
    }
  return product;
}

// The halfedge of an edge that points to the vertex of the incidence.
template <typename Surface, typename Edge>
typename Surface::Halfedge halfedge_towards(const Surface& surface, const std::vector<Edge>& edges,
                                            const Incidence& i)
{
  const auto h = edges[std::size_t(i.edge)].halfedge;
  return i.points_to_vertex ? h : surface.opposite(h);
}

// --- order

// Numbers without gaps for the ends of some edges, in the order of the mesh's indices.
class Vertex_numbers
{
public:
  // \param number_of_vertices of the mesh; indices of views of a mesh may be larger
  template <typename... Edges>
  explicit Vertex_numbers(const std::size_t number_of_vertices, const Edges&... lists)
    : m_numbers(number_of_vertices, -1)
  {
    (mark_ends(lists), ...);
    for(Vertex_index& number : m_numbers)
      if(number >= 0)
        number = m_size++;
  }

  std::size_t size() const { return std::size_t(m_size); }
  Vertex_index operator[](const std::size_t index) const { return m_numbers[index]; }

  template <typename Edges>
  std::vector<Edge_ends> ends(const Edges& edges) const
  {
    std::vector<Edge_ends> result;
    result.reserve(edges.size());
    for(const auto& edge : edges)
      result.push_back({m_numbers[edge.source], m_numbers[edge.target]});
    return result;
  }

private:
  template <typename Edges>
  void mark_ends(const Edges& edges)
  {
    for(const auto& edge : edges)
      for(const std::size_t index : {edge.source, edge.target}) {
        if(index >= m_numbers.size())
          m_numbers.resize(index + 1, -1);
        m_numbers[index] = 0;
      }
  }

  std::vector<Vertex_index> m_numbers; // -1 for none
  Vertex_index m_size = 0;
};

// The order of edges by the indices of their ends: two mesh data structures that number their
// vertices alike get the same. Parallel edges are told apart by the vertices opposite to them.
// \pre each edge is directed towards its end of larger index
template <typename Surface, typename Edge>
std::vector<std::size_t> canonical_order(const Surface& surface, const Vertex_numbers& numbers,
                                         const std::vector<Edge>& edges)
{
  const auto apexes = [&](const Edge& edge) {
    const auto g = surface.opposite(edge.halfedge);
    return std::make_pair(
        std::size_t(surface.vertex(surface.next(edge.halfedge))),
        std::size_t(surface.vertex(surface.next(g))));
  };
  Lists<std::size_t> by_source(numbers.size(), [&](const auto& add) {
    for(std::size_t i = 0; i < edges.size(); ++i)
      add(numbers[edges[i].source], i);
  });
  by_source.sort_each([&](const std::size_t i, const std::size_t j) {
    return edges[i].target != edges[j].target ? edges[i].target < edges[j].target
                                              : apexes(edges[i]) < apexes(edges[j]);
  });
  return by_source.elements();
}

// Whether an edge runs against the direction that `canonical_order` wants.
template <typename Surface, typename Edge>
bool must_turn(const Surface& surface, const Edge& edge)
{
  if(edge.source != edge.target)
    return edge.source > edge.target;
  const auto h = edge.halfedge, g = surface.opposite(h);
  return surface.vertex(surface.next(h)) >
         surface.vertex(surface.next(g));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MISMATCHED_EDGES_H
