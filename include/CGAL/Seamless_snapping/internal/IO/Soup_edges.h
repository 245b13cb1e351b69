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

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Side 3t + i of a soup runs from vertex i of triangle t to the next one.
using Side_index = Soup_index;

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

  // Keeps references to the triangles and names, but reads them in `check_manifold()` only.
  // \param names the vertices in messages; if empty, they are numbered as in the file
  explicit Soup_edges(const std::vector<Triangle>& triangles,
                      const std::vector<std::size_t>& names = no_names())
    : m_triangles(&triangles), m_names(&names)
  {
    if(triangles.size() > no_side / 3)
      throw File_refusal(0, "there are more than " + std::to_string(no_side / 3) + " faces");
    std::size_t number_of_vertices = 0;
    for(const Triangle& t : triangles)
      for(const std::size_t v : t.vertices)
        number_of_vertices = (std::max)(number_of_vertices, v + 1);
    m_sides = Lists<Side>(number_of_vertices, [&](const auto& add) {
      for(Side_index s = 0; s < 3 * triangles.size(); ++s) {
        const auto [low, high] = ends(s);
        add(low, Side{high, s});
      }
    });
    m_sides.sort_each([](const Side& a, const Side& b) {
      return std::tie(a.high, a.side) < std::tie(b.high, b.side);
    });
  }

  // Throws `File_refusal` unless each edge has one side, or two that run in opposite directions.
  // Names the edge whose fault shows first in the file.
  // `when` begins the message.
  void check_manifold(const std::string& when = "") const
  {
    const Side *first = nullptr, *last = nullptr, *first_fault = nullptr; // edge to be named
    for_each_edge([&](const Side* const begin, const Side* const end) {
      const Side* const fault = faulty_side(begin, end);
      if(fault != end && (first_fault == nullptr || fault->side < first_fault->side)) {
        first = begin;
        last = end;
        first_fault = fault;
      }
    });
    if(first_fault != nullptr)
      refuse(first, last, *first_fault, when);
  }

  // For each side the one on the other side of the edge, or `no_side` on the border.
  // \pre `check_manifold()` has passed
  std::vector<Side_index> mates() const
  {
    std::vector<Side_index> mates(m_sides.elements().size(), no_side);
    for_each_edge([&](const Side* const first, const Side* const last) {
      if(last - first == 2) {
        mates[first[0].side] = first[1].side;
        mates[first[1].side] = first[0].side;
      }
    });
    return mates;
  }

  // The sides without another one on their edge, in the order of the file.
  std::vector<Side_index> border_sides() const
  {
    std::vector<Side_index> border;
    for_each_edge([&](const Side* const first, const Side* const last) {
      if(last - first == 1)
        border.push_back(first->side);
    });
    std::sort(border.begin(), border.end());
    return border;
  }

  // Returns a side between two vertices, or `no_side` if they share no edge.
  Side_index find(const std::size_t u, const std::size_t v) const
  {
    const auto [low, high] = std::minmax(u, v);
    if(low >= m_sides.size())
      return no_side;
    const auto sides = m_sides[low];
    const Side* const side =
      std::lower_bound(sides.begin(), sides.end(), high,
                       [](const Side& s, const std::size_t vertex) { return s.high < vertex; });
    return side != sides.end() && side->high == high ? side->side : no_side;
  }

private:
  struct Side
  {
    Soup_index high; // the vertices of the edge; the lower one is known from the place
    Side_index side;
  };

  // The lower vertex, and the higher one.
  std::pair<Soup_index, Soup_index> ends(const Side_index s) const
  {
    const auto& v = (*m_triangles)[s / 3].vertices;
    return std::minmax(v[s % 3], v[next_side(s) % 3]);
  }

  // Calls `f(first, last)` for the sides of each edge.
  template <typename F>
  void for_each_edge(const F& f) const
  {
    for(std::size_t v = 0; v < m_sides.size(); ++v)
      for(const Side *first = m_sides[v].begin(), *const end = m_sides[v].end(); first != end; ) {
        const Side* last = first + 1;
        while(last != end && last->high == first->high)
          ++last;
        f(first, last);
        first = last;
      }
  }

  bool runs_upwards(const Side& s) const
  {
    return (*m_triangles)[s.side / 3].vertices[s.side % 3] != s.high;
  }

  // The first side of an edge that does not fit the sides before it, `last` if none.
  const Side* faulty_side(const Side* const first, const Side* const last) const
  {
    if(last - first >= 2 && runs_upwards(first[0]) == runs_upwards(first[1]))
      return first + 1;
    return last - first > 2 ? first + 2 : last;
  }

  std::size_t line(const Side& s) const { return (*m_triangles)[s.side / 3].line; }

  // The places of the faces of sides in the file, as in "lines 7 and 8".
  std::string places(const std::vector<Side>& sides, const std::string& separator) const
  {
    std::string result;
    for(const Side& s : sides)
      result += (result.empty() ? line(s) == 0 ? "faces " : "lines " : separator)
                + std::to_string(line(s) == 0 ? s.side / 3 : line(s));
    return result;
  }

  [[noreturn]] void refuse(const Side* const first, const Side* const last, const Side& fault,
                           const std::string& when) const
  {
    const auto name = [&](const std::size_t v) {
      return std::size_t(!m_names->empty() ? (*m_names)[v] : line(fault) == 0 ? v : v + 1);
    };
    const auto [low, high] = ends(fault.side);
    const Message edge = when + name_of_vertex(name(low), "edge") + " "
                         + name_of_vertex(name(high), "");
    if(last - first > 2)
      throw File_refusal(line(fault),
                         edge + " is not manifold: " + std::to_string(last - first)
                         + " faces share it (" + places({first, first + 3}, ", ")
                         + (last - first > 3 ? ", ...)" : ")") +
                         remedy("CGAL::Polygon_mesh_processing::orient_polygon_soup() cuts it"));

    throw File_refusal(line(fault),
                       edge + " has the same direction in two faces ("
                       + places({first, last}, " and ") + ")" +
                       (have_same_vertices(first[0], first[1])
                          ? ": they have the same vertices" + remedy("remove one of them")
                        : is_orientable() ? remedy("orient the faces consistently first")
                                          : Message(": the surface is not orientable")));
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
    for_each_edge([&](const Side* const first, const Side* const last) {
      if(last - first == 2) {
        const std::size_t t0 = 2 * std::size_t(first[0].side / 3);
        const std::size_t t1 = 2 * std::size_t(first[1].side / 3);
        const std::size_t turned = runs_upwards(first[0]) == runs_upwards(first[1]) ? 1 : 0;
        sets.union_set(t0, t1 + turned);
        sets.union_set(t0 + 1, t1 + 1 - turned);
      }
    });
    for(std::size_t t = 0; t < 2 * m_triangles->size(); t += 2)
      if(sets.find_set(t) == sets.find_set(t + 1))
        return false;
    return true;
  }

  static const std::vector<std::size_t>& no_names()
  {
    static const std::vector<std::size_t> none;
    return none;
  }

  const std::vector<Triangle>* m_triangles;
  const std::vector<std::size_t>* m_names;
  Lists<Side> m_sides; // by their lower vertices: few sides share one
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
  std::vector<bool> is_done(mates.size(), false); // per side, for the vertex at its start

  for(Side_index s = 0; s < mates.size(); ++s) {
    if(is_done[s])
      continue;
    Soup_index vertex = triangles[s / 3].vertices[s % 3];
    if(has_fan[vertex]) {
      if(points.size() >= no_side)
        throw File_refusal(0, "there are more than " + std::to_string(no_side) + " points");
      origins.push_back(vertex);
      points.push_back(Point(points[vertex]));
      vertex = static_cast<Soup_index>(points.size() - 1);
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
