// Meshes without coordinates per corner: the text of a file, in the format OBJ, PLY, OFF, or STL, as
// polygons. They need not form a surface.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_PARSERS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_PARSERS_H

#include "parsers_of_library.h"

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace formats {

using Polygons = Corner_soup<double, void>;

inline std::array<double, 3> parse_point(OBJ_scanner& scanner, std::string_view token)
{
  std::array<double, 3> point;
  for(double& x : point) {
    if(token.empty())
      scanner.refuse("a point needs 3 coordinates");
    x = parse_number<double>(scanner, token);
    token = scanner.next_token();
  }
  return point;
}

inline std::size_t parse_count(const OBJ_scanner& scanner, const std::string_view token,
                               const char* const of)
{
  std::size_t count = 0;
  if(!parse_integer(token, count))
    scanner.refuse(quoted(token) + " is not " + of);
  return count;
}

// The format OFF: a line for each point and each face. What follows in it, as colors, is skipped.
inline Polygons parse_OFF(const std::string_view text)
{
  OBJ_scanner scanner(text); // comments and lines are as in OBJ files
  const std::string_view head = scanner.next_statement();
  if(head.size() < 3 || head.substr(head.size() - 3) != "OFF")
    scanner.refuse("the file does not begin with 'OFF'");
  if(head.find_first_of("4n") != head.npos)
    scanner.refuse("points of four coordinates and more are not read");
  std::string_view token = scanner.next_token();
  if(token == "BINARY")
    scanner.refuse("binary OFF files are not read");
  if(token.empty())
    token = scanner.next_statement();
  const std::size_t number_of_points = parse_count(scanner, token, "a number of points");
  const std::size_t number_of_faces =
    parse_count(scanner, scanner.next_token(), "a number of faces");

  const auto next_line = [&](const std::string& what) {
    const std::string_view first = scanner.next_statement();
    if(first.empty())
      scanner.refuse("the file ends before " + what);
    return first;
  };
  Polygons soup;
  for(std::size_t i = 0; i < number_of_points; ++i)
    soup.points.push_back(parse_point(scanner, next_line("point " + std::to_string(i))));
  for(std::size_t i = 0; i < number_of_faces; ++i) {
    const std::string_view first = next_line("face " + std::to_string(i));
    soup.polygons.push_back({{}, scanner.line()});
    for(std::size_t n = parse_count(scanner, first, "a number of corners"); n > 0; --n) {
      const std::size_t v = parse_count(scanner, scanner.next_token(), "the index of a vertex");
      if(v >= number_of_points)
        scanner.refuse("vertex index " + std::to_string(v) + " is out of range: the file has " +
                       std::to_string(number_of_points));
      soup.polygons.back().vertices.push_back(v);
    }
  }
  return soup;
}

inline void add_triangle(const std::array<std::array<double, 3>, 3>& points, const std::size_t line,
                         Polygons& soup)
{
  const std::size_t n = soup.points.size();
  soup.points.insert(soup.points.end(), points.begin(), points.end());
  soup.polygons.push_back({{n, n + 1, n + 2}, line});
}

// Only what stands at 'vertex' matters. Some programs write capitals.
inline Polygons parse_STL_text(const std::string_view text)
{
  OBJ_scanner scanner(text);
  Polygons soup;
  std::array<std::array<double, 3>, 3> points;
  std::size_t n = 0, line = 0;
  for(std::string_view keyword; !(keyword = scanner.next_statement()).empty();) {
    if(boost::iequals(keyword, "outer"))
      line = scanner.line();
    else if(boost::iequals(keyword, "endloop")) {
      if(n != 3)
        scanner.refuse("the face has " + std::to_string(n) + " corners, but needs 3");
      add_triangle(points, line, soup);
      n = 0;
    } else if(boost::iequals(keyword, "vertex")) {
      const auto point = parse_point(scanner, scanner.next_token());
      if(n == 3)
        scanner.refuse("the face has more than 3 corners");
      points[n++] = point;
    }
  }
  if(n != 0)
    scanner.refuse("the file ends within a face");
  return soup;
}

constexpr std::size_t size_of_STL_head = 84, size_of_STL_face = 50;

inline std::size_t number_of_binary_STL_faces(const std::string_view text)
{
  return from_bytes<std::uint32_t>(text.substr(size_of_STL_head - 4, 4),
                                                 PLY_format::LITTLE_ENDIAN_BYTES);
}

inline Polygons parse_binary_STL(const std::string_view text)
{
  Polygons soup;
  const std::size_t number = number_of_binary_STL_faces(text);
  for(std::size_t i = 0; i < number; ++i) {
    if(text.size() < size_of_STL_head + (i + 1) * size_of_STL_face)
      throw File_refusal(0, "the file ends in face " + std::to_string(i) + " of " +
                              std::to_string(number));
    std::array<std::array<double, 3>, 3> points;
    for(std::size_t k = 0; k < 9; ++k)
      points[k / 3][k % 3] = from_bytes<float>(
        text.substr(size_of_STL_head + i * size_of_STL_face + 12 + 4 * k, 4),
        PLY_format::LITTLE_ENDIAN_BYTES);
    add_triangle(points, 0, soup);
  }
  return soup;
}

inline bool has_size_of_binary_STL(const std::string_view text)
{
  return text.size() >= size_of_STL_head &&
         text.size() == size_of_STL_head + number_of_binary_STL_faces(text) * size_of_STL_face;
}

inline bool begins_with_solid(const std::string_view text)
{ return boost::istarts_with(text, "solid"); }

// Some programs begin binary files with "solid", too: these have zeros, or the size that they tell.
inline Polygons parse_STL(const std::string_view text)
{
  const bool is_binary =
    text.size() >= size_of_STL_head &&
    (!begins_with_solid(text) || text.find('\0') != text.npos || has_size_of_binary_STL(text));
  return is_binary ? parse_binary_STL(text) : parse_STL_text(text);
}

inline std::string format_of_polygons(const std::string_view text)
{
  if(text.substr(0, 3) == "ply")
    return "ply";
  if(begins_with_solid(text) || has_size_of_binary_STL(text))
    return "stl";
  // OFF files may begin with comments of the same form as in OBJ files
  return OBJ_scanner(text).next_statement().find("OFF") == text.npos ? "obj" : "off";
}

inline Polygons parse_polygons(const std::string_view text, const std::string& format)
{
  if(format == "obj")
    return OBJ_parser<double, void>(text).parse();
  if(format == "ply")
    return PLY_parser<double, void>(text).parse();
  return format == "off" ? parse_OFF(text) : parse_STL(text);
}

inline void check_polygons(const Polygons& soup)
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

// Sets `soup`, whose points are finite, whose indices are in range, and which has a face; if the
// function fails, the soup stays as it was.
// \param parse returns the polygons, or throws `File_refusal`
template <typename Parse>
File_status read_polygons(const Parse& parse, Polygons& soup)
{
  const Protect_exact_arithmetic protect; // sets the rounding mode for reading numbers
  return status_of_writing([&] {
    Polygons result = parse();
    check_polygons(result);
    soup = std::move(result);
  });
}

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_POLYGON_PARSERS_H
