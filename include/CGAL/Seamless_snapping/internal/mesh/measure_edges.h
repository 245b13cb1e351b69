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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MEASURE_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MEASURE_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// Measures mismatched edges: by how much transitions miss, lengths, and gaps. Up to rounding, in
// units that keep the smallest and the largest maps in range.

#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The power of two by which lengths are multiplied.
inline double unit_scale(const double extent)
{
  int exponent = 0;
  std::frexp(extent, &exponent);
  return std::ldexp(1., (std::min)(-exponent, 1000));
}

// Measures [MC19] Eq. (4) for one rotation. \pre the coordinates are in range
template <typename Group, typename Halfedge>
void set_rotation(Mismatched_edge<Halfedge>& edge, const Edge_vectors& vectors,
                  const typename Group::Element g, const double scale)
{
  edge.rotation = g;
  edge.is_exact = vectors.match<Group>(g);
  edge.residual = edge.is_exact ? 0 : vectors.residual<Group>(g, scale);
}

template <typename Group, typename Halfedge>
void measure_length_and_gap(Mismatched_edge<Halfedge>& edge, const Edge_vectors& vectors,
                            const double scale)
{
  const Edge_sides& sides = edge.sides;
  edge.length = vectors.length<Group>(scale);
  const auto gap = [&](const Uv& u, const Uv& v) {
    return scale * Group::norm({u[0] - v[0], u[1] - v[1]});
  };
  edge.gap = (std::max)(gap(sides.a, sides.a_opposite), gap(sides.b, sides.b_opposite));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_MEASURE_EDGES_H
