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

#include <algorithm>
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

struct Edge_ends
{
  Vertex_index source, target;
};

// The vertices at the ends of open or aligned edges, numbered in the order of their indices.
template <typename TriangleMesh, typename VertexIndexMap>
class Vertex_numbers
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;

public:
  Vertex_numbers(const TriangleMesh& tmesh, const VertexIndexMap& vertex_indices)
    : m_tmesh(tmesh), m_vertex_indices(vertex_indices)
  { }

  // Numbers the ends of all halfedges of the lists.
  void number_ends(const std::vector<const std::vector<Halfedge>*>& lists)
  {
    const auto for_each_end = [&](const auto& f) {
      for(const std::vector<Halfedge>* halfedges : lists)
        for(const Halfedge h : *halfedges) {
          f(source(h, m_tmesh));
          f(target(h, m_tmesh));
        }
    };
    m_numbers.assign(num_vertices(m_tmesh), -1);
    for_each_end([&](const Vertex v) {
      const std::size_t i = index(v);
      if(i >= m_numbers.size())
        m_numbers.resize(i + 1, -1);
      m_numbers[i] = 0;
    });
    Vertex_index count = 0;
    for(Vertex_index& number : m_numbers)
      if(number == 0)
        number = count++;
    m_vertices.resize(std::size_t(count));
    for_each_end([&](const Vertex v) { m_vertices[std::size_t(m_numbers[index(v)])] = v; });
  }

  std::size_t size() const { return m_vertices.size(); }
  Vertex vertex(const Vertex_index v) const { return m_vertices[std::size_t(v)]; }

  Edge_ends ends(const Halfedge h) const
  {
    return {m_numbers[index(source(h, m_tmesh))], m_numbers[index(target(h, m_tmesh))]};
  }

  std::vector<Edge_ends> ends(const std::vector<Halfedge>& halfedges) const
  {
    std::vector<Edge_ends> result;
    result.reserve(halfedges.size());
    for(const Halfedge h : halfedges)
      result.push_back(ends(h));
    return result;
  }

private:
  std::size_t index(const Vertex v) const { return std::size_t(get(m_vertex_indices, v)); }

  const TriangleMesh& m_tmesh;
  const VertexIndexMap& m_vertex_indices;
  std::vector<Vertex_index> m_numbers; // by index, -1 for none
  std::vector<Vertex> m_vertices;
};

// An end of an edge at a vertex: `points_to_vertex` tells whether the edge's halfedge does.
struct Incidence
{
  Edge_index edge;
  bool points_to_vertex;
};

// Which edges of a list end at each numbered vertex, in the order of the list.
class Vertex_incidences
{
public:
  Vertex_incidences(const std::size_t number_of_vertices, const std::vector<Edge_ends>& ends)
    : m_begin(number_of_vertices + 1, 0), m_incidences(2 * ends.size())
  {
    for(const Edge_ends& e : ends) {
      ++m_begin[std::size_t(e.source) + 1];
      ++m_begin[std::size_t(e.target) + 1];
    }
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      m_begin[v + 1] += m_begin[v];
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for(std::size_t i = 0; i < ends.size(); ++i) {
      const Edge_index e = static_cast<Edge_index>(i);
      m_incidences[next[std::size_t(ends[i].source)]++] = {e, false};
      m_incidences[next[std::size_t(ends[i].target)]++] = {e, true};
    }
  }

  std::size_t number_of_vertices() const { return m_begin.size() - 1; }
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
                      const Vertex_numbers<TriangleMesh, VertexIndexMap>& vertices,
                      std::vector<Halfedge>& halfedges)
{
  const auto apex = [&](const Halfedge h) {
    return std::size_t(get(vertex_indices, target(next(h, tmesh), tmesh)));
  };
  struct Directed { Halfedge halfedge; Edge_ends ends; };
  std::vector<Directed> directed;
  directed.reserve(halfedges.size());
  std::vector<std::size_t> begin(vertices.size() + 1, 0); // by source, for a counting sort
  for(Halfedge h : halfedges) {
    Edge_ends ends = vertices.ends(h);
    if(ends.source > ends.target ||
       (ends.source == ends.target && apex(h) > apex(opposite(h, tmesh)))) {
      std::swap(ends.source, ends.target);
      h = opposite(h, tmesh);
    }
    directed.push_back({h, ends});
    ++begin[std::size_t(ends.source) + 1];
  }
  for(std::size_t v = 0; v < vertices.size(); ++v)
    begin[v + 1] += begin[v];
  std::vector<Directed> sorted(directed.size());
  std::vector<std::size_t> next_place(begin.begin(), begin.end() - 1);
  for(const Directed& d : directed)
    sorted[next_place[std::size_t(d.ends.source)]++] = d;
  for(std::size_t v = 0; v < vertices.size(); ++v)
    std::sort(sorted.begin() + std::ptrdiff_t(begin[v]), sorted.begin() + std::ptrdiff_t(begin[v + 1]),
              [&](const Directed& a, const Directed& b) {
                if(a.ends.target != b.ends.target)
                  return a.ends.target < b.ends.target;
                return std::make_pair(apex(a.halfedge), apex(opposite(a.halfedge, tmesh))) <
                       std::make_pair(apex(b.halfedge), apex(opposite(b.halfedge, tmesh)));
              });
  for(std::size_t i = 0; i < sorted.size(); ++i)
    halfedges[i] = sorted[i].halfedge;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPEN_EDGES_H
