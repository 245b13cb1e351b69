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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CUT_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CUT_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// Sectors and branches of the cut graph, and the coordinates of each corner as sums of the few
// vectors that determine them.

#include <CGAL/Seamless_snapping/internal/parameterization/Matching.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Triangle_surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

// A sum of R^k x over planar vectors x: pairs of the index of x and k.
using Rotated_sum = std::vector<std::pair<std::size_t, int> >;

inline Rotated_sum rotated(Rotated_sum sum, const int turns)
{
  for(auto& term : sum)
    term.second = (term.second + turns) % 4;
  return sum;
}

// Invariant: the coordinates of all corners of a sector are one Rotated_sum over the vectors
//   0 ... V-1      the coordinates of the first sector of each vertex,
//   V ... V+B-1    the translations of the branches,
// and the transition across a cut edge is the same expression at both of its ends, whatever the
// values of the vectors are, except at the vertices of `closings()`.
class Cut_complex
{
public:
  // The full turn around an interior vertex: `translation` is to equal (I - R^rotation) x, where x
  // is the position of its first sector.
  struct Closing
  {
    std::size_t vertex;
    int rotation;
    Rotated_sum translation;
  };

  Cut_complex(const Triangle_surface& surface, const std::vector<char>& is_cut,
              const std::vector<int>& rotation)
    : m_surface(surface)
    , m_is_cut(is_cut)
    , m_rotation(rotation)
    , m_sector(surface.number_of_halfedges(), none)
    , m_branch(surface.number_of_halfedges(), none)
    , m_is_forward(surface.number_of_halfedges(), false)
    , m_is_node(surface.number_of_vertices(), false)
  {
    find_nodes();
    find_branches();
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      add_sectors(v);
  }

  std::size_t number_of_vectors() const
  {
    return m_surface.number_of_vertices() + m_number_of_branches;
  }

  std::size_t number_of_branches() const { return m_number_of_branches; }
  std::size_t number_of_sectors() const { return m_position.size(); }

  std::size_t sector(const std::size_t corner) const { return m_sector[corner]; }
  const Rotated_sum& position(const std::size_t sector) const { return m_position[sector]; }
  const std::vector<Closing>& closings() const { return m_closings; }

private:
  // Branches end on the border, at cones, and wherever not exactly two cut edges meet.
  void find_nodes()
  {
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      std::size_t degree = 0;
      int turns = 0;
      for_each_corner(m_surface, v, [&](const Corner_index h) {
        degree += m_is_cut[h] ? 1 : 0;
        turns += m_rotation[h];
      });
      m_is_node[v] = degree > 0 && (m_surface.is_border[v] || degree != 2 || turns % 4 != 0);
    }
  }

  void find_branches()
  {
    for(const bool only_from_nodes : {true, false})
      for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
        if(m_is_cut[h] && m_branch[h] == none
           && (!only_from_nodes || m_is_node[m_surface.source(h)]))
          follow_branch(h);
  }

  // Both ends of an edge see the same transition, and so do the two edges at a vertex that is no
  // node: one translation is enough for the branch.
  void follow_branch(Corner_index h)
  {
    while(m_branch[h] == none) {
      const Corner_index o = m_surface.opposite(h);
      m_branch[h] = m_branch[o] = m_number_of_branches;
      m_is_forward[h] = true;
      if(m_is_node[m_surface.vertex(h)])
        break;
      h = m_surface.next(h);
      while(!m_is_cut[h])
        h = m_surface.next(m_surface.opposite(h));
    }
    ++m_number_of_branches;
  }

  // Across `h` from the chart of its face, whose coordinates are `x`: R^k x + t; backwards on the
  // branch the translation is -R^k t.
  Rotated_sum across(const Corner_index h, const Rotated_sum& x) const
  {
    Rotated_sum result = rotated(x, m_rotation[h]);
    result.emplace_back(m_surface.number_of_vertices() + m_branch[h],
                        m_is_forward[h] ? 0 : (m_rotation[h] + 2) % 4);
    return result;
  }

  void add_sectors(const std::size_t v)
  {
    const Corner_index start = first_corner_of_sector(v);
    Corner_index h = start;
    Rotated_sum x{{v, 0}};
    m_position.push_back(x);
    while(true) {
      m_sector[h] = m_position.size() - 1;
      const Corner_index following = m_surface.counterclockwise(h);
      const bool is_last = (following == no_index || following == start);
      if(following != no_index && m_is_cut[h]) {
        x = across(h, x);
        if(!is_last)
          m_position.push_back(x);
        else if(m_is_node[v])
          m_closings.push_back({v, x.front().second, Rotated_sum(x.begin() + 1, x.end())});
      }
      if(is_last)
        break;
      h = following;
    }
  }

  Corner_index first_corner_of_sector(const std::size_t v) const
  {
    Corner_index start = m_surface.corner_at_vertex[v];
    if(m_surface.is_border[v])
      return start;
    for_each_corner(m_surface, v, [&](const Corner_index h) {
      if(m_is_cut[h])
        start = m_surface.counterclockwise(h);
    });
    return start;
  }

  const Triangle_surface& m_surface;
  const std::vector<char>& m_is_cut;
  const std::vector<int>& m_rotation;
  std::vector<std::size_t> m_sector; // per corner
  std::vector<std::size_t> m_branch; // per halfedge
  std::vector<char> m_is_forward;    // per halfedge: it runs along its branch
  std::vector<char> m_is_node;       // per vertex
  std::size_t m_number_of_branches = 0;
  std::vector<Rotated_sum> m_position; // per sector
  std::vector<Closing> m_closings;
};

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_CUT_COMPLEX_H
