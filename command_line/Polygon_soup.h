// A mesh without texture coordinates as it is in a file.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H

#include "formats/polygon_parsers.h"

#include <cstddef>
#include <string>

struct Polygon_soup : formats::Polygons
{
  std::string format;           // "obj", "ply", or another format
  std::size_t first_number = 0; // by which the file counts
};

// The format is that of the name's suffix; the standard input tells its own. All points are finite,
// all indices in range, and there is a face. CGAL reads the formats that are not OBJ, PLY, OFF, or
// STL; then a refusal has neither line nor reason. Throws `Failure`.
Polygon_soup read_polygon_soup(const std::string& filename);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H
