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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_COMPLEX_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_COMPLEX_H

#include <CGAL/license/Hexahedral_meshing.h>

// The boundary and the features of an integer-grid map: patches of facets that meet in lines, and
// curves of such lines.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Lines are the feature edges, and the edges at which the facets bend, branch, or end.
struct Feature_complex
{
  std::vector<std::int32_t> patches; // per aligned facet of the volume, from 1
  std::vector<Flat_volume::Aligned_edge> lines;
  std::vector<std::int32_t> curves; // per line, from 1. Curves end where other than two lines meet.
};

// \pre the conditions hold, and the boundary is aligned
class Feature_complex_finder
{
  using Edge = std::array<std::int32_t, 2>; // vertices, ascending

public:
  explicit Feature_complex_finder(const Flat_volume& volume)
    : m_volume(volume), m_facet(volume.places_in(volume.aligned_facets))
  { }

  Feature_complex run()
  {
    for(const Flat_volume::Aligned_edge& edge : m_volume.aligned_edges)
      m_lines.emplace(ends(edge.a, edge.b), edge);
    for(std::size_t f = 0; f < m_facet.size(); ++f)
      if(m_facet[f] >= 0)
        for(const Corner_index third : corners_of_facet(Corner_index(f)))
          walk(Corner_index(f), third);
    Signed_union_find patches(m_volume.aligned_facets.size());
    for(const Flat_pair& pair : m_flat_pairs)
      if(m_lines.count(pair.edge) == 0)
        patches.unite(std::size_t(pair.facets[0]), std::size_t(pair.facets[1]));
    Feature_complex result;
    result.patches = numbers(patches);
    std::map<std::int32_t, std::vector<std::size_t> > lines_of_vertex;
    for(const auto& [vertices, edge] : m_lines) {
      for(const std::int32_t v : vertices)
        lines_of_vertex[v].push_back(result.lines.size());
      result.lines.push_back(edge);
    }
    Signed_union_find curves(result.lines.size());
    for(const auto& [v, lines] : lines_of_vertex)
      if(lines.size() == 2)
        curves.unite(lines[0], lines[1]);
    result.curves = numbers(curves);
    return result;
  }

private:
  struct Flat_pair // of facets in one plane that meet in an edge
  {
    Edge edge;
    std::array<std::int32_t, 2> facets;
  };

  Edge ends(const Corner_index a, const Corner_index b) const
  {
    const std::int32_t v = m_volume.vertex(a), w = m_volume.vertex(b);
    return {(std::min)(v, w), (std::max)(v, w)};
  }

  // Around an edge of a facet, through cells, to the next facet.
  void walk(const Corner_index facet, const Corner_index third)
  {
    constexpr double right_angle = 1.57079632679489661923;
    double angle = 0;
    Facet_ring ring(m_volume, facet, third);
    while(true) {
      const Corner_index former = ring.facet();
      ring.turn();
      angle += dihedral_angle(m_volume, former, ring.facet());
      if(m_facet[std::size_t(ring.facet())] >= 0)
        break;
      ring.cross();
    }
    const std::array<Corner_index, 2> e = edge_of_facet(facet, third);
    const std::int32_t one = m_facet[std::size_t(facet)],
                       other = m_facet[std::size_t(ring.facet())];
    if(one == other || std::lround(angle / right_angle) != 2)
      m_lines.emplace(ends(e[0], e[1]), Flat_volume::Aligned_edge{e[0], e[1]});
    else if(one < other)
      m_flat_pairs.push_back({ends(e[0], e[1]), {{one, other}}});
  }

  // The number of each element's class, from 1.
  static std::vector<std::int32_t> numbers(Signed_union_find& classes)
  {
    std::vector<std::int32_t> result;
    classes.number(result);
    for(std::int32_t& number : result)
      ++number;
    return result;
  }

  const Flat_volume& m_volume;
  std::vector<std::int32_t> m_facet; // per facet of a cell: the number of an aligned one, or -1
  std::map<Edge, Flat_volume::Aligned_edge> m_lines;
  std::vector<Flat_pair> m_flat_pairs;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_FEATURE_COMPLEX_H
