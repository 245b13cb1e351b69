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

#ifndef CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESHING_REPORT_H
#define CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESHING_REPORT_H

#include <CGAL/license/Hexahedral_meshing.h>

// The report of `hexahedral_mesh()`.

#include <CGAL/Hexahedral_meshing/types/Hexahedra_report.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedron_shapes.h>

#include <cstddef>

namespace CGAL {
namespace Hexahedral_meshing {

/*!
\ingroup PkgHexahedralMeshingRef

The report of `hexahedral_mesh()`: the report of the extraction, the scales that were tried, and the
shapes. Converts to `bool`: `true` if and only if the mesh was written.
*/
struct Hexahedral_meshing_report
  : public Hexahedra_report
{
  double grid_scale = 1; ///< the factor of the coordinates
  std::size_t number_of_attempts = 0; ///< the number of scales that the function tried
  /// why the first scale failed; empty if it did not
  Message reason_for_more;
  Hexahedron_shapes shapes_before; ///< the shapes before vertices moved
  Hexahedron_shapes shapes;        ///< the shapes of the result
};

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_TYPES_HEXAHEDRAL_MESHING_REPORT_H
