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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_HEXEX_H
#define CGAL_SEAMLESS_SNAPPING_IO_HEXEX_H

#include <CGAL/license/Seamless_snapping.h>

// Tetrahedral meshes with coordinates per corner, from and to the HEXEX format.

#include <CGAL/Seamless_snapping/internal/IO/HEXEX_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

A tetrahedral mesh with coordinates per corner, as in a file of the HEXEX format. Programs for
hexahedral meshing exchange such files.

\code{.cpp}
CGAL::Seamless_snapping::IO::HEXEX_mesh mesh;
const auto status = CGAL::Seamless_snapping::IO::read_HEXEX("hand.hexex", mesh);
\endcode
*/
struct HEXEX_mesh
{
  std::vector<std::array<double, 3> > points; ///< the point of each vertex
  std::vector<std::array<std::int32_t, 4> > tetrahedra; ///< the vertices of each cell
  /// the coordinates of corner \f$ k \f$ of cell \f$ i \f$, at \f$ 4 i + k \f$
  std::vector<std::array<double, 3> > uvw;
  /// the vertices of each wall, if the file has walls; their distances are not kept, and walls are
  /// not written
  std::vector<std::array<std::int32_t, 3> > walls;
  std::vector<std::int32_t> feature_vertices;              ///< if the file has features
  std::vector<std::array<std::int32_t, 2> > feature_edges;  ///< if the file has features
  std::vector<std::array<std::int32_t, 3> > feature_facets; ///< if the file has features
  /*!
  The number of coordinates that are fractions in the file and not representable as `double`s. They
  were rounded to the nearest `double`s. A map that is exactly seamless in the file need not be
  exactly seamless here.
  */
  std::size_t number_of_rounded_coordinates = 0;
  /// the line of the first entry that is neither a wall nor a feature, and was skipped; else 0
  std::size_t unknown_line = 0;
};

} // namespace IO

/// \cond SKIP_IN_MANUAL
namespace internal {

template <typename Number, std::size_t N>
void append_line(const std::array<Number, N>& numbers, std::string& text)
{
  for(std::size_t i = 0; i < N; ++i) {
    if constexpr(std::is_integral<Number>::value)
      text += std::to_string(numbers[i]);
    else
      append_number(numbers[i], text);
    text += i + 1 < N ? ' ' : '\n';
  }
}

inline std::string text_of_mesh(const IO::HEXEX_mesh& mesh)
{
  if(mesh.uvw.size() != 4 * mesh.tetrahedra.size())
    throw File_refusal(0, "there are not four coordinates per cell; nothing is written");
  std::string text = std::to_string(mesh.points.size()) + "\n";
  for(const auto& p : mesh.points)
    append_line(p, text);
  text += std::to_string(mesh.tetrahedra.size()) + "\n";
  for(std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    append_line(mesh.tetrahedra[i], text);
    for(std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
      text.back() = ' ';
      append_line(mesh.uvw[k], text);
    }
  }
  if(mesh.feature_vertices.empty() && mesh.feature_edges.empty() && mesh.feature_facets.empty())
    return text;
  append_line(std::array<std::size_t, 3>{{mesh.feature_vertices.size(), mesh.feature_edges.size(),
                                          mesh.feature_facets.size()}}, text);
  for(const std::int32_t v : mesh.feature_vertices)
    append_line(std::array<std::int32_t, 1>{{v}}, text);
  for(const auto& edge : mesh.feature_edges)
    append_line(edge, text);
  for(const auto& facet : mesh.feature_facets)
    append_line(facet, text);
  return text;
}

} // namespace internal
/// \endcond

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a tetrahedral mesh with coordinates per corner from a stream or a file in the HEXEX
format.

The file consists of words, separated by blanks and line ends:
-# the number of vertices, and three coordinates for each;
-# the number of cells, and for each four vertices, which count from 0, and twelve numbers
   \f$ u, v, w \f$, corner by corner;
-# optionally the number of walls, alone in a line, and for each three vertices and a distance;
-# optionally a line with the numbers of feature vertices, feature edges, and feature facets,
   followed by their vertices.

Numbers may be fractions `p/q` of integers.

\tparam Source a class derived from `std::istream`, or one that converts to `std::string`

\param source the input stream, or the name of the file
\param mesh receives the content; stays as it was if the function fails

\return a status that converts to `true` if the mesh was read; otherwise it holds the reason and
         the line

\par Complexity
Linear in the size of the file.
*/
template <typename Source>
File_status read_HEXEX(Source&& source, HEXEX_mesh& mesh)
{
  return internal::status_of_writing([&] {
    mesh = internal::HEXEX_parser<HEXEX_mesh>(internal::text_of(source)).parse();
  });
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief writes a tetrahedral mesh with coordinates per corner to a stream or a file in the HEXEX
format. The numbers read back bit for bit.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`

\param output the output stream, or the name of the file
\param mesh the mesh

\return a status that converts to `true` if the mesh was written; otherwise it holds the reason:
         there are not four coordinates per cell, a number is not finite, or the file cannot be
         written

\pre the vertices of all cells and features exist

\par Complexity
Linear in the size of the mesh.
*/
template <typename Target>
File_status write_HEXEX(Target&& output, const HEXEX_mesh& mesh)
{
  return internal::status_of_writing([&] {
    internal::write_text(output, internal::text_of_mesh(mesh));
  });
}

} // namespace IO

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_HEXEX_H
