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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_POLYGON_SOUP_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_POLYGON_SOUP_H

#include <CGAL/license/Seamless_snapping.h>

// Polygons without coordinates per corner, as a file holds them.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

Polygons as in a file, with their line numbers. The polygons need not form a surface. All indices
count from 0. See `read_polygon_soup()`.
*/
struct Polygon_soup
{
  /// A face.
  struct Polygon
  {
    std::vector<std::size_t> vertices; ///< indices of points
    std::size_t line = 0;              ///< counted from 1; 0 in files that are not made of lines
  };

  /// A segment of an `l` element of an OBJ file.
  struct Segment
  {
    std::array<std::size_t, 2> vertices; ///< indices of points
    std::size_t line;                    ///< counted from 1; 0 in files that are not made of lines
  };

  std::vector<std::array<double, 3> > points; ///< in the order of the file
  std::vector<Polygon> polygons;              ///< in the order of the file
  std::vector<Segment> segments;              ///< in the order of the file
  std::string format;                         ///< "obj", "ply", or another format
};

} // namespace IO

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_POLYGON_SOUP_H
