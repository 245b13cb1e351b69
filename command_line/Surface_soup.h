// Polygons that share points as those of an oriented surface do, made from any polygons.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_SOUP_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_SOUP_H

#include "Model.h"
#include "Polygon_soup.h"
#include "Repairs.h"

#include <cstddef>
#include <string>
#include <vector>

using Polygon = std::vector<std::size_t>;

struct Surface_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<std::size_t> file_points, file_faces; // the numbers that they have in the file
  std::vector<std::size_t> places; // for each point of the file, the first one in the same place
  std::vector<char> is_turned;                      // per polygon
};

// Throws `Failure` that names a face of the file.
[[noreturn]] void refuse(const Polygon_soup& soup, std::size_t face, const std::string& why);

// Moves points to the place of the nearest one of those before that stay, if there is one that is
// no farther away. Returns how many have moved.
std::size_t merge_points(double distance, Polygon_soup& soup);

// Removes, welds, turns, and cuts, and counts all that. Throws `Failure`.
Surface_soup make_surface(const Polygon_soup& soup, Repairs& repairs);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_SOUP_H
