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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CORNER_FINDER_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CORNER_FINDER_H

#include <CGAL/license/Hexahedral_meshing.h>

// The corners of hexahedra: the ends of straight walks from their centers.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_vertices.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Walks along a segment that lies in an open cube of the grid but for its end, and hence meets
// nothing singular before that. At edges and vertices of the mesh it goes on to all cells across
// facets that the segment meets: one of them contains the end.
class Straight_walk
{
public:
  explicit Straight_walk(const Grid_map& map)
    : m_map(map)
  { }

  // \param sides the sides of the cell, which contains p and does not contain q
  // Sets the end; returns false if there is none, which is an error of ours.
  bool run(const Cell_sides& sides, const std::int32_t cell, const Uvw& p, const Uvw& q,
           Cell_point& end)
  {
    m_steps.clear();
    m_steps.push_back({cell, p, q});
    leave(0, sides);
    for(std::size_t k = 1; k < m_steps.size(); ++k) {
      const Cell_sides sides_of_next = m_map.sides(m_steps[k].cell);
      const int facets = leave(k, sides_of_next);
      if(facets == outside)
        continue;
      end = {m_steps[k].cell, m_steps[k].q, facets};
      return true;
    }
    return false;
  }

private:
  struct Step // in a chart of its own
  {
    std::int32_t cell;
    Uvw p, q;
  };

  // Adds the steps across facets; or returns the facets on which the end lies if it is here.
  int leave(const std::size_t k, const Cell_sides& sides)
  {
    int beyond[4], size = 0, result = 0;
    for(int i = 0; i < 4; ++i) {
      const CGAL::Sign s = sides.side(i, m_steps[k].q);
      if(s == CGAL::NEGATIVE)
        beyond[size++] = i;
      result |= int(s == CGAL::ZERO) << i;
    }
    if(size == 0)
      return result;
    for(int i = 0; i < size; ++i) // a single one is the exit, because the segment meets the cell
      if(size == 1 || meets(sides, m_steps[k], beyond[i]))
        cross(k, beyond[i]);
    return outside;
  }

  // Whether the segment meets a facet, beyond which its end lies.
  static bool meets(const Cell_sides& sides, const Step& step, const int facet)
  {
    if(sides.side(facet, step.p) == CGAL::NEGATIVE)
      return false;
    bool is_left = false, is_right = false;
    const auto& u = sides.corners();
    for(int i = 1; i < 4; ++i) {
      const int a = (facet + i) % 4, b = (facet + i % 3 + 1) % 4;
      const CGAL::Orientation s =
        orientation({{step.p, step.q, u[std::size_t(a)], u[std::size_t(b)]}});
      is_left = is_left || s == CGAL::POSITIVE;
      is_right = is_right || s == CGAL::NEGATIVE;
    }
    return !(is_left && is_right);
  }

  void cross(const std::size_t k, const int i)
  {
    const Corner_index facet = 4 * m_steps[k].cell + i, other = m_map.opposite(facet);
    if(other < 0)
      return;
    const Step next{other / 4, m_map.across(facet, m_steps[k].p),
                    m_map.across(facet, m_steps[k].q)};
    for(const Step& step : m_steps)
      if(step.cell == next.cell && step.q == next.q)
        return;
    m_steps.push_back(next);
  }

  const Grid_map& m_map;
  std::vector<Step> m_steps;
};

// Finds the vertices at the corners of the hexahedra around centers in one cell after the other.
// Two such hexahedra that have a corner in common, as the cell's chart has it, share the vertex:
// the triangle of it with both centers meets nothing singular before.
class Corner_finder
{
public:
  Corner_finder(const Grid_map& map, const Grid_vertices& vertices)
    : m_map(map), m_vertices(vertices), m_walk(map), m_known(number_of_hashes)
  { }

  void enter(const std::int32_t cell, const Cell_sides& sides)
  {
    m_cell = cell;
    m_sides = &sides;
  }

  // The vertex in the corner q of the hexahedron around p; -1 if there is an error of ours.
  std::int32_t vertex(const Uvw& p, const Uvw& q)
  {
    std::uint64_t hash = 0;
    for(const double x : q)
      hash = (hash ^ std::uint64_t(std::int64_t(x))) * 0x9e3779b97f4a7c15u;
    Known& known = m_known[std::size_t(hash >> 32) % m_known.size()];
    if(known.cell != m_cell || known.q != q)
      known = {m_cell, find(p, q), q};
    return known.vertex;
  }

private:
  static constexpr std::size_t number_of_hashes = 2048; // as many as stay in a cache

  struct Known
  {
    std::int32_t cell = -1, vertex = -1;
    Uvw q{};
  };

  std::int32_t find(const Uvw& p, const Uvw& q)
  {
    Cell_point end{m_cell, q, m_sides->facets_at(q)};
    if(end.facets == outside && !m_walk.run(*m_sides, m_cell, p, q, end))
      return -1;
    return m_vertices.find(end.facets == 0 ? end : m_map.place(end));
  }

  const Grid_map& m_map;
  const Grid_vertices& m_vertices;
  Straight_walk m_walk;
  std::int32_t m_cell = -1;
  const Cell_sides* m_sides = nullptr;
  std::vector<Known> m_known; // the last corner of each hash
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CORNER_FINDER_H
