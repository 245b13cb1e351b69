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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WALL_SLIDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WALL_SLIDER_H

#include <CGAL/license/Quad_remeshing.h>

// The wanted places of vertices on straight walls.

#include <CGAL/Quad_remeshing/internal/quantization/wanted_units.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Each straight closed wall has vertices, which may lie anywhere on it, as quads slide along. They
// are wanted where edges to walls near by have whole lengths along these: else each edge is rounded
// by up to half a unit, and the sum all around a thin part is shear that no strip lowers.
class Wall_slider
{
public:
  Wall_slider(const Intrinsic_complex& complex, std::vector<Wanted_vector>& wanted)
    : m_complex(complex), m_wanted(wanted), m_directions(complex.corners.size()),
      m_can_slide(complex.number_of_vertices()), m_groups(complex.number_of_vertices())
  {
    for(std::size_t v = 0; v < m_complex.number_of_vertices(); ++v) {
      m_groups[v].parent = v;
      m_can_slide[v] = find_directions(v);
    }
    fix_neighbors();
    find_links();
  }

  bool has_links() const { return !m_links.empty(); }

  void run()
  {
    find_ratio();
    for(const auto& [width, length, h, axis] : m_links)
      link(h, axis);
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      for(std::size_t axis = 0; axis < 2; ++axis)
        m_wanted[std::size_t(h)][axis] +=
          (slide(m_complex.vertex(h), target_sign(h, axis)) -
           slide(m_complex.source(h), source_sign(h, axis))) / m_ratio;
  }

private:
  // Vertices whose slides are known relative to each other's.
  struct Group
  {
    std::size_t parent;
    double sign = 1, offset = 0; // its slide is sign * slide of the parent + offset
  };

  // The place to which the vertex slides, at each of its corners, in the chart there: along the
  // first wall, turned from corner to corner. Returns false if the vertex is on no straight wall.
  bool find_directions(const std::size_t v)
  {
    Corner_index first = no_index;
    for_each_corner(m_complex, v, [&](const Corner_index c) {
      if(first == no_index && m_complex.corner(Intrinsic_complex::next(c)).is_wall)
        first = c;
    });
    if(first == no_index || !m_complex.is_regular[v])
      return false;
    const Grid_vector& wall = m_complex.corner(Intrinsic_complex::next(first)).vector;
    Grid_vector along = wall[0] == 0 ? Grid_vector{0, 1} : Grid_vector{1, 0};
    bool is_straight = true;
    const auto see = [&](const Corner_index h) {
      const Intrinsic_corner& corner = m_complex.corner(h);
      is_straight &= !corner.is_wall || cross_product(along, corner.vector) == 0;
    };
    Corner_index c = first;
    do {
      m_directions[std::size_t(c)] = along;
      see(Intrinsic_complex::next(c));
      see(c);
      along = rotated(m_complex.corner(c).rotation, along);
      c = m_complex.counterclockwise(c);
    } while(c != no_index && c != first);
    return is_straight;
  }

  double target_sign(const Corner_index h, const std::size_t axis) const
  { return double(m_directions[std::size_t(h)][axis]); }
  double source_sign(const Corner_index h, const std::size_t axis) const
  { return target_sign(Intrinsic_complex::prev(h), axis); }

  // If a wall has a corner or an end, none of its vertices slides: lengths matter.
  void fix_neighbors()
  {
    std::vector<std::size_t> fixed;
    for(std::size_t v = 0; v < m_can_slide.size(); ++v)
      if(!m_can_slide[v])
        fixed.push_back(v);
    const auto fix = [&](const Corner_index wall, const std::size_t v) {
      if(!m_complex.corner(wall).is_wall || !m_can_slide[v])
        return;
      m_can_slide[v] = false;
      fixed.push_back(v);
    };
    while(!fixed.empty()) {
      const std::size_t v = fixed.back();
      fixed.pop_back();
      for_each_corner(m_complex, v, [&](const Corner_index c) {
        fix(c, m_complex.source(c));
        fix(Intrinsic_complex::next(c), m_complex.vertex(Intrinsic_complex::next(c)));
      });
    }
  }

  // Units may be fewer than wanted along thin parts, where there are more than wanted across.
  void find_ratio()
  {
    double sum = 0, sum_of_wanted = 0;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.corner(h).is_wall && m_can_slide[m_complex.vertex(h)]) {
        sum += length(m_complex.corner(h).units);
        sum_of_wanted += std::hypot(m_wanted[std::size_t(h)][0], m_wanted[std::size_t(h)][1]);
      }
    if(sum > 0 && sum_of_wanted > 0)
      m_ratio = sum / sum_of_wanted;
  }

  // Edges of less than a unit across, between vertices that slide along an axis: by their width.
  void find_links()
  {
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h) {
      if(!m_complex.represents_edge(h) || m_complex.corner(h).is_wall ||
         !m_can_slide[m_complex.source(h)] || !m_can_slide[m_complex.vertex(h)])
        continue;
      const Wanted_vector& w = m_wanted[std::size_t(h)];
      for(std::size_t axis = 0; axis < 2; ++axis)
        if(std::abs(w[1 - axis]) < 1 && source_sign(h, axis) != 0 && target_sign(h, axis) != 0)
          m_links.emplace_back(std::abs(w[1 - axis]), std::abs(w[axis]), h, axis);
    }
    std::sort(m_links.begin(), m_links.end());
  }

  // The group of the root, and the dependence of the slide on the root's slide.
  Group find(const std::size_t v) const
  {
    Group result{v};
    while(m_groups[result.parent].parent != result.parent) {
      const Group& g = m_groups[result.parent];
      result.offset += result.sign * g.offset;
      result.sign *= g.sign;
      result.parent = g.parent;
    }
    return result;
  }

  double slide(const std::size_t v, const double sign) const
  { return sign == 0 ? 0. : sign * find(v).offset; }

  // Slides the target, and what is linked to it, such that the edge has a whole length along the
  // axis; unless it is linked to the source already.
  void link(const Corner_index h, const std::size_t axis)
  {
    const Group source = find(m_complex.source(h)), target = find(m_complex.vertex(h));
    if(source.parent == target.parent)
      return;
    const double s = source_sign(h, axis), t = target_sign(h, axis);
    const double length =
      m_ratio * m_wanted[std::size_t(h)][axis] + t * target.offset - s * source.offset;
    Group& root = m_groups[target.parent];
    root.parent = source.parent;
    root.sign = t * target.sign * s * source.sign;
    root.offset = t * target.sign * (std::round(length) - length);
  }

  const Intrinsic_complex& m_complex;
  std::vector<Wanted_vector>& m_wanted;
  std::vector<Grid_vector> m_directions; // per corner
  std::vector<char> m_can_slide;         // per vertex
  std::vector<Group> m_groups;           // per vertex
  std::vector<std::tuple<double, double, Corner_index, std::size_t> > m_links;
  double m_ratio = 1; // of the units to the wanted ones, along lines of sliding vertices
};

// Whether there are closed parts of less than a unit between straight walls.
inline bool has_thin_parts(const Intrinsic_complex& complex, const std::vector<double>& scales)
{
  std::vector<Wanted_vector> wanted = wanted_units(complex, scales);
  return Wall_slider(complex, wanted).has_links();
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WALL_SLIDER_H
