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

#ifndef CGAL_SEAMLESS_SNAPPING_EXTRACTION_REPORT_H
#define CGAL_SEAMLESS_SNAPPING_EXTRACTION_REPORT_H

#include <CGAL/license/Seamless_snapping.h>

// How the extraction of quads or triangles ends.

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingQuads

The outcome of an extraction. After any other than `EXTRACTED` the output is untouched.
*/
enum class Extraction_status
{
  EXTRACTED,        ///< the result was written, and all checks held
  INEXACT_ARITHMETIC, ///< the processor or the compiler doesn't compute as IEEE 754 says
  INVALID_ARGUMENT, ///< no face, a scale that is not positive and finite, and the like
  NOT_TRIANGULAR,   ///< a face of the input is not a triangle
  NOT_FINITE,       ///< a coordinate is NaN, infinite, or beyond 1e300
  NOT_SEAMLESS,     ///< the map is not exactly seamless
  NOT_INTEGER,      ///< a translation or a cone is not where an integer-grid map has it
  NOT_POSITIVE,     ///< faces are flipped or degenerate in the domain
  TOO_LARGE,        ///< there are more cells than allowed, or coordinates too large to count units
  TOO_COARSE,       ///< parts of the surface are too small for the grid to enclose them by cells
  NO_FACE_GRAPH,    ///< the cells form no face graph: they have loops or double edges
  INTERNAL_ERROR    ///< the result failed its own exact verification and was discarded
};

/*!
\ingroup PkgSeamlessSnappingQuads
returns the status in words.
*/
inline const char* to_string(const Extraction_status status)
{
  switch(status) {
  case Extraction_status::EXTRACTED:        return "extracted";
  case Extraction_status::INEXACT_ARITHMETIC: return "inexact arithmetic";
  case Extraction_status::INVALID_ARGUMENT: return "invalid argument";
  case Extraction_status::NOT_TRIANGULAR:   return "not triangular";
  case Extraction_status::NOT_FINITE:       return "not finite";
  case Extraction_status::NOT_SEAMLESS:     return "not seamless";
  case Extraction_status::NOT_INTEGER:      return "not integer";
  case Extraction_status::NOT_POSITIVE:     return "not positive";
  case Extraction_status::TOO_LARGE:        return "too large";
  case Extraction_status::TOO_COARSE:       return "too coarse";
  case Extraction_status::NO_FACE_GRAPH:    return "no face graph";
  case Extraction_status::INTERNAL_ERROR:   break;
  }
  return "internal error";
}

/*!
\ingroup PkgSeamlessSnappingQuads

What `extract_quad_mesh()`, `extract_quad_soup()`, `extract_triangle_mesh()`, and
`extract_triangle_soup()` return. Converts to `bool`: `true` if and only if the result was written.
*/
struct Extraction_report
{
  Extraction_status status = Extraction_status::EXTRACTED; ///< the outcome
  /// on failure, or where pieces of cells were left out: the place, the reason, and the remedy
  std::string message;

  /// \name Size of the Result
  /// @{
  std::size_t number_of_vertices = 0; ///< vertices that were written
  std::size_t number_of_faces = 0;    ///< faces that were written
  /// those of them that are no quads: \f$ (4 - i) \f$-gons around cones of index \f$ i \f$ that lie
  /// between the lines of the grid; or that are no triangles, around such cones
  std::size_t number_of_other_polygons = 0;
  /// pieces of cells that the border cuts off, or holes; they were left out
  std::size_t number_of_cut_cells = 0;
  /// quads that are inverted in space: at a corner, their sides turn the other way than the quad as
  /// a whole does, or the quad has no area. Decided exactly, for the points as doubles.
  std::size_t number_of_inverted_quads = 0;
  /// the first of them, at most ten, counted from 0 in the order in which the faces were written
  std::vector<std::size_t> first_inverted_quads;
  /// @}

  /// \name Input
  /// @{
  double area = 0;                  ///< of all faces, in units of one quad or one triangle
  std::size_t number_of_cones = 0;  ///< interior vertices whose angle is not 360 degrees
  std::size_t number_of_cones_in_cells = 0; ///< those that lie between the lines of the grid
  /// border edges that lie on no line of the grid, or lead to the end of a slit that is no point of
  /// it
  std::size_t number_of_unaligned_border_edges = 0;
  std::size_t number_of_unaligned_features = 0; ///< feature edges that lie on no line of the grid
  /// faces that are flipped or degenerate in the domain, in the order of iteration over all faces,
  /// from 0
  std::vector<std::size_t> nonpositive_faces;
  /// @}

  /// returns `true` if and only if the result was written.
  explicit operator bool() const { return status == Extraction_status::EXTRACTED; }
};

/*!
\ingroup PkgSeamlessSnappingQuads
writes the status and, if there is one, the message.
*/
inline std::ostream& operator<<(std::ostream& os, const Extraction_report& report)
{
  os << to_string(report.status);
  if(!report.message.empty())
    os << ": " << report.message;
  return os;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_EXTRACTION_REPORT_H
