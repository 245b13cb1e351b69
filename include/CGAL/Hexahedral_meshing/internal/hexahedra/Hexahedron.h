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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRON_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRON_H

#include <CGAL/license/Hexahedral_meshing.h>

// The corners of a hexahedron in the order of VTK: around the bottom, and likewise around the top.
// In this order, the edge along an axis leads from corner k to corner k ^ step_along[axis].

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

using Hexahedron = std::array<std::int32_t, 8>;

// An edge or a facet is known by its vertices in ascending order.
template <typename Vertices>
Vertices sorted(Vertices vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

constexpr std::size_t step_along[3] = {1, 3, 4};

// The coordinates of corner k of the unit cube are 0 or 1.
constexpr std::size_t coordinate_of_corner(const std::size_t k, const std::size_t axis)
{ return (axis == 0 ? k ^ k >> 1 : k >> axis) & 1; }

// The edges at every other corner are left-handed in the order of the axes.
constexpr bool is_left_handed(const std::size_t k) { return ((k ^ k >> 2) & 1) != 0; }

// The facet at corner k across an axis, from this corner on, counterclockwise as seen from outside.
template <typename T>
std::array<T, 4> facet_at(const std::array<T, 8>& h, const std::size_t k, const std::size_t axis)
{
  const std::size_t next = is_left_handed(k) ? 1 : 2;
  const std::size_t a = step_along[(axis + next) % 3], b = step_along[(axis + 3 - next) % 3];
  return {h[k], h[k ^ a], h[k ^ a ^ b], h[k ^ b]};
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_HEXAHEDRON_H
