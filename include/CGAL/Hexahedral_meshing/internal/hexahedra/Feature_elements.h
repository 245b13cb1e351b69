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
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_conditions.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedron.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>

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
class Feature_element_finder
{
public:
  Feature_element_finder(const Grid_map& map, const Grid_vertices& vertices)
    : m_map(map), m_corners(map, vertices)
  { }

  // \param is_mirrored per cell: hexahedra list their corners in the other order
  // Fills in the quadrilaterals and edges. Until the features of the caller are looked up,
  // `feature_facets` are aligned facets of the volume, and `feature_edges` lines of the complex.
  // Vertices are -1 if there is an error of ours.
  void run(const Feature_complex& complex, const std::vector<char>& is_mirrored,
           Hexahedral_mesh& mesh)
  {
    const std::vector<Corner_index>& facets = m_map.volume().aligned_facets;
    for(std::size_t i = 0; i < facets.size(); ++i)
      for_each_quadrilateral(facets[i], is_mirrored[std::size_t(facets[i] / 4)] != 0,
                             [&](const Quadrilateral& q) {
        if(m_found_quadrilaterals.insert(sorted(q)).second) {
          mesh.quadrilaterals.push_back(q);
          mesh.patches.push_back(complex.patches[i]);
          mesh.feature_facets.push_back(std::int32_t(i));
        }
      });
    for(std::size_t i = 0; i < complex.lines.size(); ++i)
      for_each_edge(complex.lines[i], [&](const Edge& edge) {
        if(m_found_edges.insert(sorted(edge)).second) {
          mesh.edges.push_back(sorted(edge));
          mesh.curves.push_back(complex.curves[i]);
          mesh.feature_edges.push_back(std::int32_t(i));
        }
      });
  }

private:
  using Quadrilateral = std::array<std::int32_t, 4>;
  using Edge = std::array<std::int32_t, 2>;

  // Calls f(vertices), counterclockwise as seen from outside, for the centers in a facet.
  template <typename F>
  void for_each_quadrilateral(const Corner_index facet, const bool is_mirrored, const F& f)
  {
    const Flat_volume& volume = m_map.volume();
    const std::size_t k = constant_coordinate(volume, facet);
    const bool is_seen_from_above =
      (volume.uvw(facet)[k] < volume.uvw(corners_of_facet(facet)[0])[k]) != is_mirrored;
    Uvw shift{0.5, 0.5, 0.5};
    shift[k] = 0;
    const Cell_sides sides = m_map.sides(facet / 4);
    m_corners.enter(facet / 4, sides);
    for_each_grid_point(sides, facet / 4, shift, [&](const Cell_point& center) {
      if((center.facets >> facet % 4 & 1) == 0)
        return;
      Quadrilateral q;
      for(std::size_t i = 0; i < 4; ++i) {
        Uvw corner = center.p;
        corner[(k + 1) % 3] += i == 1 || i == 2 ? 0.5 : -0.5;
        corner[(k + 2) % 3] += i > 1 ? 0.5 : -0.5;
        q[is_seen_from_above ? i : 3 - i] = m_corners.vertex(center.p, corner);
      }
      f(q);
    });
  }

  // Calls f(vertices) for the middles on a line. The ends of feature facets may lie off the grid.
  template <typename F>
  void for_each_edge(const Flat_volume::Aligned_edge& line, const F& f)
  {
    if(!is_on_grid_line(m_map.volume(), line))
      return;
    const std::size_t k = std::size_t(direction_of(m_map.volume(), line));
    const Uvw &a = m_map.volume().uvw(line.a), &b = m_map.volume().uvw(line.b);
    const Cell_sides sides = m_map.sides(line.a / 4);
    m_corners.enter(line.a / 4, sides);
    Uvw middle = a;
    for(middle[k] = std::ceil((std::min)(a[k], b[k]) - 0.5) + 0.5;
        middle[k] <= (std::max)(a[k], b[k]); ++middle[k]) {
      Uvw low = middle, high = middle;
      low[k] -= 0.5;
      high[k] += 0.5;
      f(Edge{{m_corners.vertex(middle, low), m_corners.vertex(middle, high)}});
    }
  }

  const Grid_map& m_map;
  Corner_finder m_corners;
  std::set<Quadrilateral> m_found_quadrilaterals; // by sorted vertices
  std::set<Edge> m_found_edges;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_ELEMENTS_H
