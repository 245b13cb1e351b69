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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_ELEMENTS_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_ELEMENTS_H

#include <CGAL/license/Hexahedral_meshing.h>

// The quadrilaterals and edges of hexahedra that lie on the boundary and on features. As a
// hexahedron is a half-integer point, a quadrilateral is its center in a facet, and an edge is its
// middle on a line.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Corner_finder.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Feature_complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Each element is listed once, with the first facet or line that contains its middle.
struct Feature_elements
{
  std::vector<std::array<std::int32_t, 4> > quadrilaterals; // counterclockwise, seen from outside
  std::vector<std::int32_t> facets;                         // aligned ones, per quadrilateral
  std::vector<std::array<std::int32_t, 2> > edges;          // ascending vertices
  std::vector<std::int32_t> lines;                          // per edge
};

class Feature_element_finder
{
public:
  Feature_element_finder(const Grid_map& map, const Grid_vertices& vertices)
    : m_map(map), m_corners(map, vertices)
  { }

  // \param is_mirrored per cell: hexahedra list their corners in the other order
  // Vertices are -1 if there is an error of ours.
  Feature_elements run(const std::vector<Flat_volume::Aligned_edge>& lines,
                       const std::vector<char>& is_mirrored)
  {
    const std::vector<Corner_index>& facets = m_map.volume().aligned_facets;
    for(std::size_t i = 0; i < facets.size(); ++i)
      add_quadrilaterals(facets[i], std::int32_t(i), is_mirrored[std::size_t(facets[i] / 4)] != 0);
    for(std::size_t i = 0; i < lines.size(); ++i)
      add_edges(lines[i], std::int32_t(i));
    return std::move(m_result);
  }

private:
  void add_quadrilaterals(const Corner_index facet, const std::int32_t number,
                          const bool is_mirrored)
  {
    const auto corners = corners_of_facet(facet);
    const auto& uvw = [&](const Corner_index i) -> const Uvw& { return m_map.volume().uvw(i); };
    std::size_t k = 0; // the coordinate that is constant
    while(uvw(corners[0])[k] != uvw(corners[1])[k] || uvw(corners[0])[k] != uvw(corners[2])[k])
      ++k;
    const bool is_seen_from_above = (uvw(facet)[k] < uvw(corners[0])[k]) != is_mirrored;
    Uvw shift{0.5, 0.5, 0.5};
    shift[k] = 0;
    const Cell_sides sides = m_map.sides(facet / 4);
    m_corners.enter(facet / 4, sides);
    for_each_grid_point(sides, facet / 4, shift, [&](const Cell_point& center) {
      if((center.facets >> facet % 4 & 1) == 0)
        return;
      std::array<std::int32_t, 4> q;
      for(std::size_t i = 0; i < 4; ++i) {
        Uvw corner = center.p;
        corner[(k + 1) % 3] += i == 1 || i == 2 ? 0.5 : -0.5;
        corner[(k + 2) % 3] += i > 1 ? 0.5 : -0.5;
        q[is_seen_from_above ? i : 3 - i] = m_corners.vertex(center.p, corner);
      }
      std::array<std::int32_t, 4> key = q;
      std::sort(key.begin(), key.end());
      if(m_found_quadrilaterals.insert(key).second) {
        m_result.quadrilaterals.push_back(q);
        m_result.facets.push_back(number);
      }
    });
  }

  void add_edges(const Flat_volume::Aligned_edge& line, const std::int32_t number)
  {
    const Uvw &a = m_map.volume().uvw(line.a), &b = m_map.volume().uvw(line.b);
    std::size_t k = 0; // the coordinate that changes
    while(k < 3 && !(a[k] != b[k] && is_on_grid(a, b, (k + 1) % 3) &&
                     is_on_grid(a, b, (k + 2) % 3)))
      ++k;
    if(k == 3) // feature facets may end anywhere
      return;
    const Cell_sides sides = m_map.sides(line.a / 4);
    m_corners.enter(line.a / 4, sides);
    Uvw middle = a;
    for(middle[k] = std::ceil((std::min)(a[k], b[k]) - 0.5) + 0.5;
        middle[k] <= (std::max)(a[k], b[k]); ++middle[k]) {
      Uvw low = middle, high = middle;
      low[k] -= 0.5;
      high[k] += 0.5;
      const std::int32_t v = m_corners.vertex(middle, low), w = m_corners.vertex(middle, high);
      const std::array<std::int32_t, 2> edge{{(std::min)(v, w), (std::max)(v, w)}};
      if(m_found_edges.insert(edge).second) {
        m_result.edges.push_back(edge);
        m_result.lines.push_back(number);
      }
    }
  }

  static bool is_on_grid(const Uvw& a, const Uvw& b, const std::size_t c)
  { return a[c] == b[c] && a[c] == std::round(a[c]); }

  const Grid_map& m_map;
  Corner_finder m_corners;
  Feature_elements m_result;
  std::set<std::array<std::int32_t, 4> > m_found_quadrilaterals; // by sorted vertices
  std::set<std::array<std::int32_t, 2> > m_found_edges;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_ELEMENTS_H
