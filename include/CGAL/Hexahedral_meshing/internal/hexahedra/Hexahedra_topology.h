// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRA_TOPOLOGY_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRA_TOPOLOGY_H

#include <CGAL/license/Hexahedral_meshing.h>

// How hexahedra meet, by their vertices alone: the quadrilaterals of the boundary, the edges with
// the number of hexahedra around them, and what is wrong.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

using Hexahedron = std::array<std::int32_t, 8>;

// The order of VTK: around the bottom, and likewise around the top.
constexpr int corner_of_cube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

// Counterclockwise as seen from outside.
constexpr int facet_of_hexahedron[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                           {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

// The corners that edges lead to from each corner: in a right-handed order.
constexpr int neighbors_of_corner[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                           {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

struct Hexahedron_facet
{
  std::int32_t hexahedron;
  int facet;
};

using Edge_of_hexahedra = std::array<std::int32_t, 2>; // vertices, ascending

// Invariant: if there is a bad hexahedron, the rest does not mean anything.
struct Hexahedra_topology
{
  std::int32_t bad_hexahedron = -1; // has a vertex twice, or a quadrilateral that two others have
  std::vector<Hexahedron_facet> boundary; // in the order of hexahedra
  std::vector<Edge_of_hexahedra> boundary_edges; // sorted
  bool is_boundary_closed = true; // each edge is in an even number of its quadrilaterals
  std::size_t number_of_edges = 0;         // pairs of vertices
  std::size_t number_of_quadrilaterals = 0;
  std::size_t number_of_unused_vertices = 0;
  // the number of interior edges by that of their hexahedra, where it is not four
  std::map<int, std::size_t> irregular_edges;
};

// Looks at each vertex with the hexahedra around it, of which there are few.
class Topology_finder
{
public:
  Topology_finder(const std::vector<Hexahedron>& hexahedra, const std::size_t number_of_vertices)
    : m_hexahedra(hexahedra), m_corners(number_of_vertices, [&](const auto& add) {
        for(std::size_t i = 0; i < hexahedra.size(); ++i)
          for(int k = 0; k < 8; ++k)
            add(hexahedra[i][std::size_t(k)], std::int64_t(8 * i + std::size_t(k)));
      })
  { }

  template <typename ConcurrencyTag>
  Hexahedra_topology run(ConcurrencyTag)
  {
    Hexahedra_topology result;
    const auto parts = results_of_chunks<Part, ConcurrencyTag>(
      m_corners.size(), [&](const Chunk& chunk) { return part_of(chunk); });
    std::vector<std::pair<Edge_of_hexahedra, int> > irregular;
    for(const Part& part : parts) {
      if(result.bad_hexahedron < 0)
        result.bad_hexahedron = part.bad_hexahedron;
      result.boundary.insert(result.boundary.end(), part.boundary.begin(), part.boundary.end());
      irregular.insert(irregular.end(), part.irregular.begin(), part.irregular.end());
      result.number_of_edges += part.number_of_edges;
      result.number_of_quadrilaterals += part.number_of_quadrilaterals;
      result.number_of_unused_vertices += part.number_of_unused_vertices;
    }
    std::sort(result.boundary.begin(), result.boundary.end(), [](const auto& a, const auto& b) {
      return std::make_pair(a.hexahedron, a.facet) < std::make_pair(b.hexahedron, b.facet);
    });
    find_boundary_edges(result);
    for(const auto& [edge, number] : irregular)
      if(!std::binary_search(result.boundary_edges.begin(), result.boundary_edges.end(), edge))
        ++result.irregular_edges[number];
    return result;
  }

private:
  struct Part
  {
    std::int32_t bad_hexahedron = -1;
    std::vector<Hexahedron_facet> boundary;
    std::vector<std::pair<Edge_of_hexahedra, int> > irregular; // or on the boundary
    std::size_t number_of_edges = 0, number_of_quadrilaterals = 0, number_of_unused_vertices = 0;
  };

  struct Quadrilateral // at its least vertex
  {
    std::array<std::int32_t, 3> others; // the opposite one first, then ascending
    Hexahedron_facet name;
  };

  Part part_of(const Chunk& chunk) const
  {
    Part part;
    std::vector<std::int32_t> ends;
    std::vector<Quadrilateral> quadrilaterals;
    for(std::size_t v = chunk.begin; v < chunk.end; ++v) {
      ends.clear();
      quadrilaterals.clear();
      part.number_of_unused_vertices += std::size_t(m_corners[v].empty());
      for(const std::int64_t corner : m_corners[v])
        add(std::int32_t(corner / 8), int(corner % 8), std::int32_t(v), ends, quadrilaterals, part);
      count_edges(std::int32_t(v), ends, part);
      match(quadrilaterals, part);
    }
    return part;
  }

  void add(const std::int32_t i, const int corner, const std::int32_t v,
           std::vector<std::int32_t>& ends, std::vector<Quadrilateral>& quadrilaterals,
           Part& part) const
  {
    const Hexahedron& h = m_hexahedra[std::size_t(i)];
    if(std::count(h.begin(), h.end(), v) > 1 && part.bad_hexahedron < 0)
      part.bad_hexahedron = i;
    for(int k = 0; k < 3; ++k) {
      const int a = neighbors_of_corner[corner][k], b = neighbors_of_corner[corner][(k + 1) % 3];
      const std::int32_t x = h[std::size_t(a)], y = h[std::size_t(b)];
      if(x > v)
        ends.push_back(x);
      const int facet = facet_at(corner, a, b);
      int opposite = 0; // the corners of a facet add up to twice the sum of two opposite ones
      for(const int c : facet_of_hexahedron[facet])
        opposite += c;
      const std::int32_t z = h[std::size_t(opposite - corner - a - b)];
      if(v < x && v < y && v < z)
        quadrilaterals.push_back({{z, (std::min)(x, y), (std::max)(x, y)}, {i, facet}});
    }
  }

  static int facet_at(const int corner, const int a, const int b)
  {
    int k = 0; // the coordinate that both edges leave alone
    while(corner_of_cube[corner][k] != corner_of_cube[a][k] ||
          corner_of_cube[corner][k] != corner_of_cube[b][k])
      ++k;
    return 2 * k + corner_of_cube[corner][k];
  }

  static void count_edges(const std::int32_t v, std::vector<std::int32_t>& ends, Part& part)
  {
    std::sort(ends.begin(), ends.end());
    for(std::size_t i = 0; i < ends.size(); ) {
      std::size_t j = i;
      while(j < ends.size() && ends[j] == ends[i])
        ++j;
      ++part.number_of_edges;
      if(j - i != 4)
        part.irregular.push_back({{v, ends[i]}, int(j - i)});
      i = j;
    }
  }

  static void match(std::vector<Quadrilateral>& quadrilaterals, Part& part)
  {
    std::sort(quadrilaterals.begin(), quadrilaterals.end(),
              [](const Quadrilateral& a, const Quadrilateral& b) { return a.others < b.others; });
    for(std::size_t i = 0; i < quadrilaterals.size(); ) {
      std::size_t j = i;
      while(j < quadrilaterals.size() && quadrilaterals[j].others == quadrilaterals[i].others)
        ++j;
      ++part.number_of_quadrilaterals;
      if(j - i == 1)
        part.boundary.push_back(quadrilaterals[i].name);
      if(j - i > 2 && part.bad_hexahedron < 0)
        part.bad_hexahedron = quadrilaterals[i].name.hexahedron;
      i = j;
    }
  }

  void find_boundary_edges(Hexahedra_topology& result) const
  {
    std::vector<Edge_of_hexahedra> edges;
    edges.reserve(4 * result.boundary.size());
    for(const Hexahedron_facet& f : result.boundary)
      for(std::size_t k = 0; k < 4; ++k) {
        const int* const corners = facet_of_hexahedron[f.facet];
        const Hexahedron& h = m_hexahedra[std::size_t(f.hexahedron)];
        const std::int32_t a = h[std::size_t(corners[k])],
                           b = h[std::size_t(corners[(k + 1) % 4])];
        edges.push_back({(std::min)(a, b), (std::max)(a, b)});
      }
    std::sort(edges.begin(), edges.end());
    for(std::size_t i = 0; i < edges.size(); ) {
      std::size_t j = i;
      while(j < edges.size() && edges[j] == edges[i])
        ++j;
      result.is_boundary_closed = result.is_boundary_closed && (j - i) % 2 == 0;
      result.boundary_edges.push_back(edges[i]);
      i = j;
    }
  }

  const std::vector<Hexahedron>& m_hexahedra;
  Lists<std::int64_t> m_corners; // per vertex: 8 i + k for corner k of hexahedron i
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRA_TOPOLOGY_H
