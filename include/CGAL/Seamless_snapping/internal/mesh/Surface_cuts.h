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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SURFACE_CUTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SURFACE_CUTS_H

#include <CGAL/license/Seamless_snapping.h>

// A complex that was read off a mesh, and the way back: which corners each sector has, and what the
// constraints of the complex are called.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the corners of a sector are consecutive, clockwise. Sectors are made for the ends of
// all cut, merged, and aligned edges, and for the vertices of further constraints.
template <typename Group, typename Halfedge>
struct Surface_cuts
{
  Cut_complex<Group> complex;
  Lists<Halfedge> corners;         // per sector
  std::vector<std::array<Halfedge, 2> > branch_ends, chain_ends; // the first and the last edge
  // One sector of each vertex that is to be a point of an integer grid; ascending.
  std::vector<Sector_index> grid_points;
  std::size_t number_of_singular_vertices = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SURFACE_CUTS_H
