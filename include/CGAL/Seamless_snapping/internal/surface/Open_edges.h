// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPEN_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPEN_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The open edges of a uv map, in an order that does not depend on the mesh data structure, and which of
// them meet at which vertex.

#include <boost/graph/graph_traits.hpp>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Edge_index = std::int32_t;   // of an open edge
using Vertex_index = std::int32_t; // of an end of an open or aligned edge

template <typename Halfedge>
struct Open_edge
{
  Halfedge halfedge;     // towards the end of larger index
  int rotation = 0;      // k of the transition from face(halfedge) to the opposite face
  bool is_cut = true;    // else the corners of both sides are merged
  bool is_exact = false; // whether Eq. (4) holds exactly
  // in units of the extent, rounded up to a power of two:
  double residual = 0;   // by how much Eq. (4) is violated
  double length = 0;     // of the edge
  double gap = 0;        // between the sides: for k = 0 the length of the translation
};

// An end of an edge at a vertex: `points_to_vertex` tells whether the edge's halfedge does.
struct Incidence
{
  Edge_index edge;
  bool points_to_vertex;
};

// The vertices at the ends of open or aligned edges, numbered by first appearance.
template <typename TriangleMesh>
class Vertex_numbers
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Vertex_map =
    typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int> >::const_type;

public:
  explicit Vertex_numbers(const TriangleMesh& tmesh)
    : m_tmesh(&tmesh), m_index(get(CGAL::dynamic_vertex_property_t<int>(), tmesh))
  { }

  void add_ends(const std::vector<Halfedge>& halfedges)
  {
    for(const Halfedge h : halfedges) {
      add(source(h, *m_tmesh));
      add(target(h, *m_tmesh));
    }
  }

  std::size_t size() const { return m_vertices.size(); }
  Vertex vertex(const Vertex_index v) const { return m_vertices[std::size_t(v)]; }
  Vertex_index source_index(const Halfedge h) const { return index(source(h, *m_tmesh)); }
  Vertex_index target_index(const Halfedge h) const { return index(target(h, *m_tmesh)); }

private:
  Vertex_index index(const Vertex v) const { return get(m_index, v) - 1; }

  void add(const Vertex v)
  {
    if(get(m_index, v) != 0) // 0 means none
      return;
    m_vertices.push_back(v);
    put(m_index, v, static_cast<int>(m_vertices.size()));
  }

  const TriangleMesh* m_tmesh;
  Vertex_map m_index;
  std::vector<Vertex> m_vertices;
};

// Which edges of a list end at each numbered vertex.
class Vertex_incidences
{
public:
  template <typename TriangleMesh, typename Halfedge>
  Vertex_incidences(const Vertex_numbers<TriangleMesh>& vertices,
                    const std::vector<Halfedge>& halfedges)
    : m_begin(vertices.size() + 1, 0), m_incidences(2 * halfedges.size())
  {
    for(const Halfedge h : halfedges) {
      ++m_begin[std::size_t(vertices.source_index(h)) + 1];
      ++m_begin[std::size_t(vertices.target_index(h)) + 1];
    }
    for(std::size_t v = 0; v < vertices.size(); ++v)
      m_begin[v + 1] += m_begin[v];
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for(std::size_t i = 0; i < halfedges.size(); ++i) {
      const Edge_index e = static_cast<Edge_index>(i);
      m_incidences[next[std::size_t(vertices.source_index(halfedges[i]))]++] = {e, false};
      m_incidences[next[std::size_t(vertices.target_index(halfedges[i]))]++] = {e, true};
    }
  }

  std::size_t degree(const Vertex_index v) const
  { return m_begin[std::size_t(v) + 1] - m_begin[std::size_t(v)]; }
  const Incidence* begin(const Vertex_index v) const
  { return m_incidences.data() + m_begin[std::size_t(v)]; }
  const Incidence* end(const Vertex_index v) const
  { return m_incidences.data() + m_begin[std::size_t(v) + 1]; }

private:
  std::vector<std::size_t> m_begin;
  std::vector<Incidence> m_incidences;
};

// Sorts one halfedge per edge by the indices of its ends, and directs each towards its end of larger
// index: two mesh data structures that number their vertices alike get the same list. Parallel edges
// are told apart by the vertices opposite to them.
template <typename TriangleMesh, typename VertexIndexMap, typename Halfedge>
void sort_canonically(const TriangleMesh& tmesh, const VertexIndexMap& vertex_indices,
                      std::vector<Halfedge>& halfedges)
{
  struct Key
  {
    std::array<std::size_t, 4> indices;
    Halfedge halfedge;
  };
  const auto apex = [&](const Halfedge h) {
    return std::size_t(get(vertex_indices, target(next(h, tmesh), tmesh)));
  };
  std::vector<Key> keys;
  keys.reserve(halfedges.size());
  for(Halfedge h : halfedges) {
    std::size_t low = std::size_t(get(vertex_indices, source(h, tmesh)));
    std::size_t high = std::size_t(get(vertex_indices, target(h, tmesh)));
    const Halfedge g = opposite(h, tmesh);
    if(low > high || (low == high && apex(h) > apex(g))) {
      std::swap(low, high);
      h = g;
    }
    keys.push_back({{{low, high, apex(h), apex(opposite(h, tmesh))}}, h});
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& a, const Key& b) { return a.indices < b.indices; });
  for(std::size_t i = 0; i < keys.size(); ++i)
    halfedges[i] = keys[i].halfedge;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPEN_EDGES_H
