#include "Polygon_soup.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <sstream>
#include <string>

namespace IO = CGAL::Seamless_snapping::IO;

Polygon_soup read_polygon_soup(const std::string& filename)
{
  check_no_tetrahedra(filename);
  std::istringstream text(read_file(filename));
  Polygon_soup soup;
  const IO::File_status status = is_special_file(filename)
                                   ? IO::read_polygon_soup(text, soup)
                                   : IO::read_polygon_soup(filename, soup);
  if(!status)
    throw Failure(UNREADABLE, filename + ": " + in_words_of_user(status.message));
  soup.first_number = soup.format == "obj" ? 1 : 0;
  return soup;
}
