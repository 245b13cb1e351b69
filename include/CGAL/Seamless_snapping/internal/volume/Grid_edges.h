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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_GRID_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_GRID_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// The edges that have to lie on integer lines in an integer-grid map: singular ones, and those at
// which the boundary turns back.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_transitions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

constexpr int no_axis = -1;

// The coordinate that a rotation about a coordinate axis leaves alone; `no_axis` for the identity
// and for rotations about other axes.
inline int axis_of(const Cube_rotations::Element g)
{
  int result = no_axis;
  for(std::size_t c = 0; c < 3 && g != Cube_rotations::identity(); ++c)
    if(Cube_rotations::source(g, c) == c && Cube_rotations::sign(g, c) > 0)
      result = int(c);
  return result;
}

struct Grid_edge
{
  Flat_volume::Aligned_edge edge; // its direction is known if transitions tell it
  bool is_interior;
  bool is_skew; // transitions turn about an axis that is none of the coordinates'
};

// Walks around each edge once, or once for each part of the mesh that touches it.
// \pre the volume holds all cells of the mesh
class Grid_edge_finder
{
  using Group = Cube_rotations;

public:
  Grid_edge_finder(const Flat_volume& volume, const Volume_transitions& transitions)
    : m_volume(volume),
      m_element(elements_of_facets(volume, transitions, false, Group::identity())),
      m_is_aligned(volume.opposite.size(), 0), m_is_done(6 * volume.number_of_cells(), 0)
  {
    for(const Corner_index facet : volume.aligned_facets)
      m_is_aligned[std::size_t(facet)] = 1;
  }

  std::vector<Grid_edge> find()
  {
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] == no_facet)
        for(const Corner_index third : corners_of_facet(Corner_index(f)))
          walk(Corner_index(f), third);
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      for(const Corner_index third : corners_of_facet(Corner_index(f)))
        walk(Corner_index(f), third);
    return std::move(m_result);
  }

private:
  static constexpr double pi = 3.14159265358979323846;

  char& is_done(const Corner_index i, const Corner_index j)
  {
    constexpr std::size_t pair[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
    return m_is_done[6 * std::size_t(i / 4) + pair[i % 4][j % 4]];
  }

  // Around the edge that a facet has opposite to its corner `third`.
  void walk(const Corner_index facet, const Corner_index third)
  {
    if(is_done(facet, third) != 0)
      return;
    double angle = 0;
    bool is_folded = false;
    int g = Group::identity();
    CGAL::Orientation sign = CGAL::ZERO;
    Facet_ring ring(m_volume, facet, third);
    do {
      const Corner_index former = ring.facet();
      ring.turn();
      is_done(former, ring.facet()) = 1;
      const CGAL::Orientation now =
        orientation(uvw_of_cell(m_volume.coordinates, std::size_t(former / 4)));
      is_folded = is_folded || now == CGAL::ZERO || (sign != CGAL::ZERO && now != sign);
      sign = now;
      angle += angle_between(former, ring.facet());
      if(!ring.can_cross())
        break;
      g = Group::compose(m_element[std::size_t(ring.facet())], g);
      if(ring.is_closed())
        break;
      ring.cross();
    } while(true);
    const bool is_interior = ring.can_cross();
    if(is_interior ? g != Group::identity() || (!is_folded && angle > 4 * pi - pi / 4)
                   : !is_folded && angle > 2 * pi - pi / 4 &&
                       m_is_aligned[std::size_t(facet)] != 0 &&
                       m_is_aligned[std::size_t(ring.facet())] != 0)
      add(facet, third, is_interior, is_interior ? g : Group::identity());
  }

  void add(const Corner_index facet, const Corner_index third, const bool is_interior, const int g)
  {
    std::array<Corner_index, 2> ends{{-1, -1}};
    for(const Corner_index corner : corners_of_facet(facet))
      if(corner != third)
        ends[ends[0] < 0 ? 0 : 1] = corner;
    m_result.push_back({{ends[0], ends[1], axis_of(g)}, is_interior,
                        g != Group::identity() && axis_of(g) == no_axis});
  }

  // In a cell, between the facets opposite to two corners.
  double angle_between(const Corner_index i, const Corner_index j) const
  {
    std::array<const Uvw*, 2> ends{{nullptr, nullptr}};
    for(const Corner_index corner : corners_of_facet(i))
      if(corner != j)
        ends[ends[0] == nullptr ? 0 : 1] = &m_volume.uvw(corner);
    const Uvw &a = *ends[0], &b = *ends[1], &p = m_volume.uvw(i), &q = m_volume.uvw(j);
    const Uvw m = normal(a, b, p), n = normal(a, b, q);
    const double cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
    const Uvw x{{m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2], m[0] * n[1] - m[1] * n[0]}};
    return std::atan2(std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), cosine);
  }

  // Of unit length, but for degenerate triangles.
  static Uvw normal(const Uvw& a, const Uvw& b, const Uvw& p)
  {
    Uvw e, f;
    double scale = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      e[c] = b[c] - a[c];
      f[c] = p[c] - a[c];
      scale = (std::max)({scale, std::abs(e[c]), std::abs(f[c])});
    }
    Uvw n{};
    for(std::size_t c = 0; c < 3 && scale > 0; ++c) {
      const std::size_t d = (c + 1) % 3, k = (c + 2) % 3;
      n[c] = (e[d] / scale) * (f[k] / scale) - (e[k] / scale) * (f[d] / scale);
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for(std::size_t c = 0; c < 3 && length > 0; ++c)
      n[c] /= length;
    return n;
  }

  const Flat_volume& m_volume;
  std::vector<signed char> m_element; // per facet: to the other side
  std::vector<char> m_is_aligned;     // per facet, on one of its sides
  std::vector<char> m_is_done;        // per edge of a cell
  std::vector<Grid_edge> m_result;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_GRID_EDGES_H
