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

#ifndef CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRA_REPORT_H
#define CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRA_REPORT_H

#include <CGAL/license/Hexahedral_meshing.h>

// The report of `extract_hexahedra()`.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <cstddef>
#include <map>

namespace CGAL {
namespace Hexahedral_meshing {

/*!
\ingroup PkgHexahedralMeshingRef

The report of `extract_hexahedra()`: the outcome, and the numbers of extracted elements. It converts
to `true` if and only if the hexahedra were written. On failure, numbers of steps that were not
reached are zero.
*/
struct Hexahedra_report
  : public Report
{
  std::size_t number_of_hexahedra = 0; ///< the volume of the map
  std::size_t number_of_vertices = 0;  ///< of the hexahedra
  std::size_t number_of_edges = 0;     ///< of the hexahedra, as pairs of vertices
  std::size_t number_of_quadrilaterals = 0; ///< on the boundary and inside
  /// quadrilaterals that belong to a single hexahedron: the area of the boundary of the map
  std::size_t number_of_boundary_quadrilaterals = 0;
  /// the number of edges, less the number of pairs of vertices that an edge joins
  std::size_t number_of_double_edges = 0;
  /// the number of interior edges by the number of hexahedra around them, if that is not four
  std::map<int, std::size_t> irregular_edges;
};

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRA_REPORT_H
