// The names of the library's parsers, which all of this folder shares: the program reads a file as the
// library does, and then knows where each number stands.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PARSERS_OF_LIBRARY_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PARSERS_OF_LIBRARY_H

#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <array>

namespace formats {

using namespace CGAL::Seamless_snapping::internal;
using CGAL::Seamless_snapping::IO::File_status;

using Soup = Corner_soup<double, double>; // the content of a file
using UV = std::array<double, 2>;

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PARSERS_OF_LIBRARY_H
