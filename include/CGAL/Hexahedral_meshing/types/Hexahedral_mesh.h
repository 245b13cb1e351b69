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

A mesh of hexahedra with its boundary and its features, as `hexahedral_mesh()` makes it and files
hold it. Indices are numbers of points.

To carry marks of your own into files, such as the number of a material or of a boundary condition,
replace `patches` by the marks of the `feature_facets`, or `curves` by the marks of the
`feature_edges`.
*/
struct Hexahedral_mesh
{
  std::vector<std::array<double, 3> > points; ///< of the vertices
  /// the vertices of each hexahedron: around the bottom, and likewise around the top,
  /// counterclockwise as seen from above
  std::vector<std::array<std::int32_t, 8> > hexahedra;
  /// the quadrilaterals of the boundary, counterclockwise as seen from outside, and the
  /// quadrilaterals on feature facets inside
  std::vector<std::array<std::int32_t, 4> > quadrilaterals;
  /// for each quadrilateral: the number of its patch, from 1. Patches meet in the `edges`.
  std::vector<std::int32_t> patches;
  /// for each quadrilateral: the index of the feature facet that contains its center, among the
  /// `feature_facets` of the caller; -1 if there is none
  std::vector<std::int32_t> feature_facets;
  /// edges on feature edges, and the edges at which the quadrilaterals bend, branch, or end
  std::vector<std::array<std::int32_t, 2> > edges;
  /// for each edge: the number of its curve, from 1. Curves end where other than two edges meet.
  std::vector<std::int32_t> curves;
  /// for each edge: the index of the feature edge that contains its middle, among the
  /// `feature_edges` of the caller; -1 if there is none
  std::vector<std::int32_t> feature_edges;
};

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESH_H
