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

// How hexahedra meet, by their vertices alone: the numbers of quadrilaterals, of edges, and of
// hexahedra around edges, and what is wrong.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedron.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedra_report.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// If there is a bad hexahedron, the rest does not mean anything.
struct Hexahedra_topology
{
  std::int32_t bad_hexahedron = -1; // has a vertex twice, or a quadrilateral that two others have
  bool is_boundary_closed = true; // each edge is in an even number of its quadrilaterals
  std::size_t number_of_unused_vertices = 0;
};

// Sorts, and calls f(first element, number of elements) for each run of equal elements.
template <typename T, typename F>
void for_each_run(std::vector<T>& elements, const F& f)
{
  std::sort(elements.begin(), elements.end());
  for(auto i = elements.begin(), end = i; i != elements.end(); i = end) {
    while(end != elements.end() && !(*i < *end))
      ++end;
    f(*i, std::size_t(end - i));
  }
}

// Looks at each vertex with the hexahedra around it, of which there are few.
class Topology_finder
{
  using Edge = std::array<std::int32_t, 2>; // vertices, ascending

public:
  Topology_finder(const std::vector<Hexahedron>& hexahedra, const std::size_t number_of_vertices)
    : m_hexahedra(hexahedra), m_corners(number_of_vertices, [&](const auto& add) {
        for(std::size_t i = 0; i < hexahedra.size(); ++i)
          for(std::size_t k = 0; k < 8; ++k)
            add(hexahedra[i][k], std::int64_t(8 * i + k));
      })
  { }

  // Fills in the numbers of edges and quadrilaterals in the report, unless a hexahedron is bad.
  template <typename ConcurrencyTag>
  Hexahedra_topology run(ConcurrencyTag, Hexahedra_report& to_fill_in)
  {
    Hexahedra_topology result;
    Hexahedra_report report = to_fill_in;
    std::vector<Edge> boundary, boundary_edges;
    std::vector<std::pair<Edge, int> > irregular;
    for(const Part& part : results_of_chunks<Part, ConcurrencyTag>(
          m_corners.size(), [&](const Chunk& chunk) { return part_of(chunk); })) {
      if(result.bad_hexahedron < 0)
        result.bad_hexahedron = part.bad_hexahedron;
      boundary.insert(boundary.end(), part.boundary.begin(), part.boundary.end());
      irregular.insert(irregular.end(), part.irregular.begin(), part.irregular.end());
      report.number_of_edges += part.number_of_edges;
      report.number_of_quadrilaterals += part.number_of_quadrilaterals;
      result.number_of_unused_vertices += part.number_of_unused_vertices;
    }
    report.number_of_boundary_quadrilaterals = boundary.size() / 4;
    for_each_run(boundary, [&](const Edge& edge, const std::size_t number) {
      boundary_edges.push_back(edge);
      result.is_boundary_closed = result.is_boundary_closed && number % 2 == 0;
    });
    for(const auto& [edge, number] : irregular)
      if(!std::binary_search(boundary_edges.begin(), boundary_edges.end(), edge))
        ++report.irregular_edges[number];
    if(result.bad_hexahedron < 0)
      to_fill_in = report;
    return result;
  }

private:
  struct Part
  {
    std::int32_t bad_hexahedron = -1;
    std::vector<Edge> boundary; // the edges of each quadrilateral
    std::vector<std::pair<Edge, int> > irregular; // or on the boundary
    std::size_t number_of_edges = 0, number_of_quadrilaterals = 0, number_of_unused_vertices = 0;
  };

  struct Quadrilateral // at its least vertex
  {
    std::array<std::int32_t, 3> others; // the opposite one first, then ascending
    std::int32_t hexahedron;

    friend bool operator<(const Quadrilateral& a, const Quadrilateral& b)
    { return a.others < b.others; }
  };

  Part part_of(const Chunk& chunk) const
  {
    Part part;
    std::vector<std::int32_t> ends; // of edges whose other vertex is less
    std::vector<Quadrilateral> quadrilaterals;
    for(std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto v = std::int32_t(i);
      ends.clear();
      quadrilaterals.clear();
      part.number_of_unused_vertices += std::size_t(m_corners[v].empty());
      for(const std::int64_t corner : m_corners[v])
        add(std::int32_t(corner / 8), std::size_t(corner % 8), ends, quadrilaterals, part);
      for_each_run(ends, [&](const std::int32_t end, const std::size_t number) {
        ++part.number_of_edges;
        if(number != 4)
          part.irregular.push_back({{v, end}, int(number)});
      });
      for_each_run(quadrilaterals, [&](const Quadrilateral& q, const std::size_t number) {
        ++part.number_of_quadrilaterals;
        if(number == 1)
          for(const std::int32_t w : {q.others[1], q.others[2]}) {
            part.boundary.push_back({v, w});
            part.boundary.push_back({(std::min)(w, q.others[0]), (std::max)(w, q.others[0])});
          }
        if(number > 2 && part.bad_hexahedron < 0)
          part.bad_hexahedron = q.hexahedron;
      });
    }
    return part;
  }

  void add(const std::int32_t i, const std::size_t corner, std::vector<std::int32_t>& ends,
           std::vector<Quadrilateral>& quadrilaterals, Part& part) const
  {
    const Hexahedron& h = m_hexahedra[std::size_t(i)];
    const std::int32_t v = h[corner];
    if(std::count(h.begin(), h.end(), v) > 1 && part.bad_hexahedron < 0)
      part.bad_hexahedron = i;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      if(const std::int32_t end = h[corner ^ step_along[axis]]; end > v)
        ends.push_back(end);
      const auto [first, x, z, y] = facet_at(h, corner, axis);
      if(v < x && v < y && v < z)
        quadrilaterals.push_back({{z, (std::min)(x, y), (std::max)(x, y)}, i});
    }
  }

  const std::vector<Hexahedron>& m_hexahedra;
  Lists<std::int64_t> m_corners; // per vertex: 8 i + k for corner k of hexahedron i
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRA_TOPOLOGY_H
