// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_TYPES_EXTRACTION_REPORT_H
#define CGAL_QUAD_REMESHING_TYPES_EXTRACTION_REPORT_H

#include <CGAL/license/Quad_remeshing.h>

// How the extraction of quads or triangles ends.

#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingQuads

The result of `extract_quad_mesh()`, `extract_quad_soup()`, `extract_triangle_mesh()`, and
`extract_triangle_soup()`. Converts to `bool`: `true` if and only if the result was written.
*/
struct Extraction_report
  : public Report
{
  /// \name Size of the Result
  /// @{
  std::size_t number_of_vertices = 0; ///< vertices that were written
  std::size_t number_of_faces = 0;    ///< faces that were written
  /// faces that are no quads, or no triangles, around cones between the lines of the grid: a cone
  /// of index \f$ i \f$ gives a \f$ (4 - i) \f$-gon
  std::size_t number_of_other_polygons = 0;
  /// pieces of cells that the border cuts off, or holes; they were left out
  std::size_t number_of_cut_cells = 0;
  /// quads that are inverted in space: at a corner, the sides turn against the quad as a whole, or
  /// the area or a side is zero. This is decided exactly, for the points as doubles.
  std::size_t number_of_inverted_quads = 0;
  /// the first of these quads, at most ten, counted from 0 in the order in which the faces were
  /// written
  std::vector<std::size_t> first_inverted_quads;
  /// @}

  /// \name Input
  /// @{
  double area = 0;                  ///< the area of all faces, in units of one quad or triangle
  std::size_t number_of_cones = 0;  ///< interior vertices whose angle is not 360 degrees
  std::size_t number_of_cones_in_cells = 0; ///< cones between the lines of the grid
  /// border edges that lie on no line of the grid, or lead to the end of a slit that is no point of
  /// the grid
  std::size_t number_of_unaligned_border_edges = 0;
  std::size_t number_of_unaligned_features = 0; ///< feature edges that lie on no line of the grid
  /// faces that are flipped or degenerate in the domain, in the order of iteration over all faces,
  /// from 0
  std::vector<std::size_t> nonpositive_faces;
  /// @}
};

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_TYPES_EXTRACTION_REPORT_H
