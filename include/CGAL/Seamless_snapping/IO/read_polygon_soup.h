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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_READ_POLYGON_SOUP_H
#define CGAL_SEAMLESS_SNAPPING_IO_READ_POLYGON_SOUP_H

#include <CGAL/license/Seamless_snapping.h>

// Reads meshes without coordinates per corner, as polygons; refusals tell line and cause.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/internal/IO/soup_parsers.h>
#include <CGAL/Seamless_snapping/types/File_status.h>
#include <CGAL/Seamless_snapping/types/Polygon_soup.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

inline std::string format_of_polygons(const std::string_view text)
{
  if(text.substr(0, 3) == "ply")
    return "ply";
  if(begins_with_solid(text) || has_size_of_binary_STL(text))
    return "stl";
  // OFF files may begin with comments of the same form as those of OBJ files
  return OBJ_scanner(text).next_statement().find("OFF") == text.npos ? "obj" : "off";
}

inline bool is_format_of_polygons(const std::string& format)
{
  return format == "obj" || format == "ply" || format == "off" || format == "stl";
}

inline IO::Polygon_soup parse_polygons(const std::string_view text, const std::string& format)
{
  if(format == "obj")
    return OBJ_parser<double, void>(text).parse();
  if(format == "ply")
    return PLY_parser<double, void>(text).parse();
  return format == "off" ? parse_OFF(text) : parse_STL(text);
}

// Of the other formats that CGAL reads, which tells no reason.
inline IO::Polygon_soup read_other_polygons(const std::string& filename)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons))
    throw File_refusal(0, "not a mesh of the format that the suffix names (.obj, .ply, .off, and "
                          ".stl files are read best)");
  IO::Polygon_soup soup;
  for(const auto& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(std::vector<std::size_t>& polygon : polygons)
    soup.polygons.push_back({std::move(polygon), 0});
  return soup;
}

inline void check_polygons(const IO::Polygon_soup& soup)
{
  if(soup.polygons.empty())
    throw File_refusal(0, "the file has no face");
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(const double x : soup.points[i])
      if(!std::isfinite(x))
        throw File_refusal(0, "vertex " + std::to_string(i) + " has a NaN or infinite coordinate");
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    for(const std::size_t v : soup.polygons[i].vertices)
      if(v >= soup.points.size())
        throw File_refusal(0, "face " + std::to_string(i) + " has a vertex that does not exist");
}

// What `parse()` returns, in which `format` is still missing.
template <typename Parse>
IO::File_status read_checked(const Parse& parse, const std::string& format, IO::Polygon_soup& soup)
{
  const Protect_exact_arithmetic protect; // of the mode in which numbers are read
  return status_of_writing([&] {
    IO::Polygon_soup result = parse();
    check_polygons(result);
    result.format = format;
    soup = std::move(result);
  });
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

reads a mesh without coordinates per corner from a stream, in the format OBJ, PLY, OFF, or STL.
Faces may have any number of corners, and need not form a surface: what is to be repaired is left to
the caller. Coordinates of textures and normals, colors, and all else that the file holds are
skipped.

A file is refused, with the line and the reason, if it is malformed, if it has a coordinate that is
not a finite number or a face with a vertex that does not exist, and if it has no face.

\param is the input stream; it is left at its end
\param soup receives what is read; it is left as it was if the file is refused
\param format `"obj"`, `"ply"`, `"off"`, or `"stl"`; else the text tells it by its first word, or
       by its size, as binary STL files do

\return an object that converts to `true` if the mesh was read, and that holds the reason and the
        line otherwise

\par Complexity
Linear in the size of the file.

\sa `CGAL::Polygon_mesh_processing::orient_polygon_soup()`
*/
inline File_status read_polygon_soup(std::istream& is, Polygon_soup& soup,
                                     const std::string& format = std::string())
{
  std::string text, chosen;
  if(const File_status status = internal::status_of_writing([&] { text = internal::text_of(is); });
     !status)
    return status;
  chosen = internal::is_format_of_polygons(format) ? format : internal::format_of_polygons(text);
  return internal::read_checked([&] { return internal::parse_polygons(text, chosen); }, chosen,
                                soup);
}

/*!
\ingroup PkgSeamlessSnappingIO

reads a mesh without coordinates per corner from the file of a name, whose suffix tells the format:
those of the function that reads from a stream, or one of the others that
`CGAL::IO::read_polygon_soup()` reads, which tells neither line nor reason. Refusals, what `soup`
receives, what is returned, and complexity are as there.

\param filename the name of the file
\param soup receives what is read
*/
inline File_status read_polygon_soup(const std::string& filename, Polygon_soup& soup)
{
  const std::string format = CGAL::IO::internal::get_file_extension(filename);
  return internal::read_checked(
    [&] {
      return internal::is_format_of_polygons(format)
               ? internal::parse_polygons(internal::text_of(filename), format)
               : internal::read_other_polygons(filename);
    },
    format, soup);
}

} // namespace IO

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_READ_POLYGON_SOUP_H
