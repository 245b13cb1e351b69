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

// Reads the other formats of CGAL, whose reader gives no reason.
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

// Checks the result of `parse()`, and adds the format.
template <typename Parse>
IO::File_status read_checked(const Parse& parse, const std::string& format, IO::Polygon_soup& soup)
{
  const Protect_exact_arithmetic protect; // sets the rounding mode for reading numbers
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

Faces may have any number of corners, and need not form a surface: the function repairs nothing. It
skips texture coordinates, normals, colors, and all other data. It refuses a file, with the line and
the reason, if the file is malformed, if a coordinate is not finite, if a face has a vertex that
does not exist, or if there is no face.

\param is the input stream; it is left at its end
\param soup receives the mesh; stays as it was if the file is refused
\param format `"obj"`, `"ply"`, `"off"`, or `"stl"`. By default, the function recognizes the format
       by the first word of the text, or by its size for binary STL files.

\return a status that converts to `true` if the mesh was read; otherwise it holds the reason and the
        line

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

reads a mesh without coordinates per corner from a file, whose suffix names the format.

The function reads the formats OBJ, PLY, OFF, and STL itself, as from a stream. It reads the other
formats of `CGAL::IO::read_polygon_soup()` by this function, which gives neither line nor reason for
a refusal. Return value and complexity are as for streams.

\param filename the name of the file
\param soup receives the mesh; stays as it was if the file is refused
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
