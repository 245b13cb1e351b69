// A mesh without texture coordinates as it is in a file.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H

#include <CGAL/Seamless_snapping/IO/read_polygon_soup.h>

#include <cstddef>
#include <string>

struct Polygon_soup : CGAL::Seamless_snapping::IO::Polygon_soup
{
  std::size_t first_number = 0; // by which the file counts
};

// The format is that of the name's suffix; the standard input tells its own. All points are finite,
// all indices in range, and there is a face. Throws `Failure` with the line and the reason.
Polygon_soup read_polygon_soup(const std::string& filename);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_SOUP_H
