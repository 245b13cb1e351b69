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

#ifndef CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESH_H
#define CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESH_H

#include <CGAL/license/Hexahedral_meshing.h>

// A mesh of hexahedra in plain arrays.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {

/*!
\ingroup PkgHexahedralMeshingRef

A mesh of hexahedra with its boundary, as `hexahedral_mesh()` makes it and files hold it.
Indices are numbers of points.
*/
struct Hexahedral_mesh
{
  std::vector<std::array<double, 3> > points; ///< of the vertices
  /// the vertices of each hexahedron: around the bottom, and likewise around the top,
  /// counterclockwise as seen from above
  std::vector<std::array<std::int32_t, 8> > hexahedra;
  /// quadrilaterals of the boundary, counterclockwise as seen from outside
  std::vector<std::array<std::int32_t, 4> > quadrilaterals;
  /// for each quadrilateral: the number of its patch, from 1. Patches meet in sharp edges.
  std::vector<std::int32_t> patches;
  /// sharp edges: the edges of the boundary with other than two hexahedra
  std::vector<std::array<std::int32_t, 2> > edges;
};

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESH_H
