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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The edges of a triangle soup: whether it is an oriented surface, and where it is not; and how its
// vertices have to be split so that a halfedge data structure can hold it.
// CGAL's functions on soups make any soup fit, by turning faces round and by cutting along edges;
// here a file is taken as it is or refused, with the lines of the faces at fault.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Side 3t + i of a soup runs from vertex i of triangle t to the next one.
using Side_index = std::size_t;

inline Side_index next_side(Side_index s) { return s % 3 == 2 ? s - 2 : s + 1; }
inline Side_index previous_side(Side_index s) { return s % 3 == 0 ? s + 2 : s - 1; }

// The sides of all triangles, sorted by the edges they lie on.
// `Triangle` has members `vertices` (three indices) and `line`, which is 0 in files that are not
// made of lines: faces are told by their indices there, and these and vertices are counted from 0.
template <typename Triangle>
class Soup_edges
{
public:
  static constexpr Side_index no_side = static_cast<Side_index>(-1);

  // Keeps a reference to the triangles, but reads them in `check_manifold()` only.
  explicit Soup_edges(const std::vector<Triangle>& triangles)
    : m_triangles(&triangles)
  {
    // by their lower vertices first, as counted: few sides share one
    std::vector<std::size_t> end;
    for(Side_index s = 0; s < 3 * triangles.size(); ++s) {
      const std::size_t low = side(s).low;
      if(low >= end.size())
        end.resize((std::max)(low + 1, 2 * end.size()), 0);
      ++end[low];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    m_sides.resize(3 * triangles.size());
    std::vector<std::size_t> begin(end);
    for(Side_index s = m_sides.size(); s-- > 0;)
      m_sides[--begin[side(s).low]] = side(s);
    for(std::size_t v = 0; v < end.size(); ++v)
      std::sort(&m_sides[0] + begin[v], &m_sides[0] + end[v], [](const Side& a, const Side& b) {
        return std::tie(a.high, a.side) < std::tie(b.high, b.side);
      });
  }

  // Throws `File_refusal` unless each edge has one side, or two that run in opposite directions.
  // Of several edges at fault, the one whose fault shows first in the file is named.
  // `when` begins the message.
  void check_manifold(const std::string& when = "") const
  {
    std::size_t first_fault = m_sides.size();
    for(std::size_t i = 0; i < m_sides.size(); i = end_of_edge(i)) {
      const std::size_t fault = faulty_side(i);
      if(fault != m_sides.size()
         && (first_fault == m_sides.size() || m_sides[fault].side < m_sides[first_fault].side))
        first_fault = fault;
    }
    if(first_fault != m_sides.size())
      refuse(first_fault, when);
  }

  // For each side the one on the other side of the edge, or `no_side` on the border.
  // \pre `check_manifold()` has passed
  std::vector<Side_index> mates() const
  {
    std::vector<Side_index> mates(m_sides.size(), no_side);
    for(std::size_t i = 0; i < m_sides.size(); i = end_of_edge(i))
      if(end_of_edge(i) == i + 2) {
        mates[m_sides[i].side] = m_sides[i + 1].side;
        mates[m_sides[i + 1].side] = m_sides[i].side;
      }
    return mates;
  }

  // The sides without another one on their edge, in the order of the file.
  std::vector<Side_index> border_sides() const
  {
    std::vector<Side_index> border;
    for(std::size_t i = 0; i < m_sides.size(); i = end_of_edge(i))
      if(end_of_edge(i) == i + 1)
        border.push_back(m_sides[i].side);
    std::sort(border.begin(), border.end());
    return border;
  }

  // Returns a side between two vertices, or `no_side` if they share no edge.
  Side_index find(std::size_t u, std::size_t v) const
  {
    const Side sought{(std::min)(u, v), (std::max)(u, v), 0};
    const auto side = std::lower_bound(m_sides.begin(), m_sides.end(), sought,
                                       [](const Side& a, const Side& b) {
                                         return std::tie(a.low, a.high) < std::tie(b.low, b.high);
                                       });
    const bool found = side != m_sides.end() && is_same_edge(*side, sought);
    return found ? side->side : no_side;
  }

private:
  struct Side
  {
    std::size_t low;  // the vertices of the edge
    std::size_t high;
    Side_index side;
  };

  Side side(const Side_index s) const
  {
    const std::array<std::size_t, 3>& v = (*m_triangles)[s / 3].vertices;
    const auto [low, high] = std::minmax(v[s % 3], v[next_side(s) % 3]);
    return {low, high, s};
  }

  static bool is_same_edge(const Side& a, const Side& b)
  {
    return a.low == b.low && a.high == b.high;
  }

  // In the following, `i` is the position of the first side of an edge in the sorted sequence.
  std::size_t end_of_edge(std::size_t i) const
  {
    std::size_t end = i + 1;
    while(end < m_sides.size() && is_same_edge(m_sides[i], m_sides[end]))
      ++end;
    return end;
  }

  bool runs_upwards(const Side& s) const
  {
    return (*m_triangles)[s.side / 3].vertices[s.side % 3] == s.low;
  }

  // The position of the first side that does not fit to those before it, `m_sides.size()` if none.
  std::size_t faulty_side(std::size_t i) const
  {
    const std::size_t end = end_of_edge(i);
    if(end - i >= 2 && runs_upwards(m_sides[i]) == runs_upwards(m_sides[i + 1]))
      return i + 1;
    return end - i > 2 ? i + 2 : m_sides.size();
  }

  std::size_t line(const Side& s) const { return (*m_triangles)[s.side / 3].line; }

  // Where the faces of sides are in the file, as in "lines 7 and 8".
  std::string places(const std::vector<Side>& sides, const std::string& separator) const
  {
    std::string result;
    for(const Side& s : sides)
      result += (result.empty() ? line(s) == 0 ? "faces " : "lines " : separator)
                + std::to_string(line(s) == 0 ? s.side / 3 : line(s));
    return result;
  }

  [[noreturn]] void refuse(std::size_t fault, const std::string& when) const
  {
    std::size_t i = fault;
    while(i > 0 && is_same_edge(m_sides[i - 1], m_sides[fault]))
      --i;
    const std::size_t number = end_of_edge(i) - i;
    const std::size_t first_number = line(m_sides[fault]) == 0 ? 0 : 1; // of vertices in the file
    const std::string edge = when + "edge " + std::to_string(m_sides[i].low + first_number) + " "
                             + std::to_string(m_sides[i].high + first_number);
    if(number > 2)
      throw File_refusal(line(m_sides[fault]),
                         edge + " is not manifold: " + std::to_string(number)
                         + " faces share it ("
                         + places({m_sides[i], m_sides[i + 1], m_sides[i + 2]}, ", ")
                         + (number > 3 ? ", ...)" : ")"));

    throw File_refusal(line(m_sides[fault]),
                       edge + " has the same direction in two faces ("
                       + places({m_sides[i], m_sides[i + 1]}, " and ") + "): "
                       + (have_same_vertices(m_sides[i], m_sides[i + 1])
                            ? "they have the same vertices; remove one of them"
                          : is_orientable() ? "orient the faces consistently first"
                                          : "the surface is not orientable"));
  }

  bool have_same_vertices(const Side& a, const Side& b) const
  {
    const auto &v = (*m_triangles)[a.side / 3].vertices, &w = (*m_triangles)[b.side / 3].vertices;
    return std::is_permutation(v.begin(), v.end(), w.begin());
  }

  // Whether some choice of orientations makes all edges of two faces fit.
  bool is_orientable() const
  {
    // 2t stands for triangle t as it is, 2t + 1 for t turned round; sets of what goes together
    boost::disjoint_sets_with_storage<> sets(2 * m_triangles->size());
    for(std::size_t t = 0; t < 2 * m_triangles->size(); ++t)
      sets.make_set(t);
    for(std::size_t i = 0; i < m_sides.size(); i = end_of_edge(i))
      if(end_of_edge(i) == i + 2) {
        const std::size_t t0 = 2 * (m_sides[i].side / 3);
        const std::size_t t1 = 2 * (m_sides[i + 1].side / 3);
        const std::size_t turned = runs_upwards(m_sides[i]) == runs_upwards(m_sides[i + 1]) ? 1 : 0;
        sets.union_set(t0, t1 + turned);
        sets.union_set(t0 + 1, t1 + 1 - turned);
      }
    for(std::size_t t = 0; t < 2 * m_triangles->size(); t += 2)
      if(sets.find_set(t) == sets.find_set(t + 1))
        return false;
    return true;
  }

  const std::vector<Triangle>* m_triangles;
  std::vector<Side> m_sides;
};

// Gives each fan of triangles around a vertex a vertex of its own: the fan that comes first keeps
// the vertex, the others get copies of it at the end of `points`. Returns the vertex of each copy.
template <typename Triangle, typename Point>
std::vector<std::size_t> split_non_manifold_vertices(const std::vector<Side_index>& mates,
                                        std::vector<Triangle>& triangles,
                                        std::vector<Point>& points)
{
  constexpr Side_index no_side = Soup_edges<Triangle>::no_side;
  std::vector<std::size_t> origins;
  std::vector<bool> has_fan(points.size(), false);
  std::vector<bool> is_done(mates.size(), false); // of the vertex at the start of each side

  for(Side_index s = 0; s < mates.size(); ++s) {
    if(is_done[s])
      continue;
    std::size_t vertex = triangles[s / 3].vertices[s % 3];
    if(has_fan[vertex]) {
      origins.push_back(vertex);
      points.push_back(Point(points[vertex]));
      vertex = points.size() - 1;
    } else {
      has_fan[vertex] = true;
    }

    // round the vertex one way until the fan ends or closes, then the other way
    for(Side_index i = s; i != no_side && !is_done[i]; i = mates[previous_side(i)]) {
      is_done[i] = true;
      triangles[i / 3].vertices[i % 3] = vertex;
    }
    for(Side_index m = mates[s]; m != no_side && !is_done[next_side(m)]; m = mates[next_side(m)]) {
      is_done[next_side(m)] = true;
      triangles[m / 3].vertices[next_side(m) % 3] = vertex;
    }
  }
  return origins;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_EDGES_H
