#include "Polygon_soup.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

formats::Polygons read_by_CGAL(const std::string& filename)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons))
    throw Failure(UNREADABLE, filename + ": not a mesh of the format that the suffix names (.obj, "
                              ".ply, .off, and .stl files are read best)");
  formats::Polygons soup;
  for(const auto& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(std::vector<std::size_t>& polygon : polygons)
    soup.polygons.push_back({std::move(polygon), 0});
  return soup;
}

} // namespace

Polygon_soup read_polygon_soup(const std::string& filename)
{
  check_no_tetrahedra(filename);
  const std::string text = read_file(filename);
  Polygon_soup soup;
  soup.format = is_special_file(filename) ? formats::format_of_polygons(text) : suffix_of(filename);
  const bool is_parsed = soup.format == "obj" || soup.format == "ply" || soup.format == "off" ||
                         soup.format == "stl";
  const formats::File_status status = formats::read_polygons(
    [&] {
      return is_parsed ? formats::parse_polygons(text, soup.format) : read_by_CGAL(filename);
    },
    soup);
  if(!status)
    throw Failure(UNREADABLE, filename + ": " + in_words_of_user(status.message));
  soup.first_number = soup.format == "obj" ? 1 : 0;
  return soup;
}
