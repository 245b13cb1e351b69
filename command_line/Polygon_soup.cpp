#include "Polygon_soup.h"

#include "Failure.h"
#include "files.h"

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_values.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

using Soup = SS::internal::Corner_soup<double, void>;
using Scanner = SS::internal::OBJ_scanner; // comments and lines are as in OBJ files
using SS::internal::File_refusal;

std::array<double, 3> parse_point(Scanner& scanner, std::string_view token)
{
  std::array<double, 3> point;
  for(double& x : point) {
    if(token.empty())
      scanner.refuse("a point needs 3 coordinates");
    x = SS::internal::parse_number<double>(scanner, token);
    token = scanner.next_token();
  }
  return point;
}

std::size_t parse_count(const Scanner& scanner, const std::string_view token, const char* const of)
{
  std::size_t count = 0;
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, count);
  if(token.empty() || result.ptr != end || result.ec != std::errc())
    scanner.refuse(SS::internal::quoted(token) + " is not " + of);
  return count;
}

// A line for each point and each face. What follows in it, as colors, is skipped.
Soup parse_OFF(const std::string_view text)
{
  Scanner scanner(text);
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
  Soup soup;
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

void add_triangle(const std::array<std::array<double, 3>, 3>& points, const std::size_t line,
                  Soup& soup)
{
  const std::size_t n = soup.points.size();
  soup.points.insert(soup.points.end(), points.begin(), points.end());
  soup.polygons.push_back({{n, n + 1, n + 2}, line});
}

// Only what stands at 'vertex' matters.
Soup parse_STL_text(const std::string_view text)
{
  Scanner scanner(text);
  Soup soup;
  std::array<std::array<double, 3>, 3> points;
  std::size_t n = 0, line = 0;
  for(std::string_view keyword = scanner.next_statement(); !keyword.empty();
      keyword = scanner.next_statement()) {
    if(keyword == "outer")
      line = scanner.line();
    else if(keyword == "endloop") {
      if(n != 3)
        scanner.refuse("the face has " + std::to_string(n) + " corners, but needs 3");
      add_triangle(points, line, soup);
      n = 0;
    } else if(keyword == "vertex") {
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

std::size_t number_of_binary_STL_faces(const std::string_view text)
{
  return SS::internal::from_bytes<std::uint32_t>(text.substr(size_of_STL_head - 4, 4),
                                                 SS::internal::PLY_format::LITTLE_ENDIAN_BYTES);
}

Soup parse_binary_STL(const std::string_view text)
{
  Soup soup;
  const std::size_t number = number_of_binary_STL_faces(text);
  for(std::size_t i = 0; i < number; ++i) {
    if(text.size() < size_of_STL_head + (i + 1) * size_of_STL_face)
      throw File_refusal(0, "the file ends in face " + std::to_string(i) + " of " +
                              std::to_string(number));
    std::array<std::array<double, 3>, 3> points;
    for(std::size_t k = 0; k < 9; ++k)
      points[k / 3][k % 3] = SS::internal::from_bytes<float>(
        text.substr(size_of_STL_head + i * size_of_STL_face + 12 + 4 * k, 4),
        SS::internal::PLY_format::LITTLE_ENDIAN_BYTES);
    add_triangle(points, 0, soup);
  }
  return soup;
}

// Some programs begin binary files with "solid", too: these have zeros, or the size that they tell.
Soup parse_STL(const std::string_view text)
{
  const bool is_binary =
    text.size() >= size_of_STL_head &&
    (text.substr(0, 5) != "solid" || text.find('\0') != text.npos ||
     text.size() == size_of_STL_head + number_of_binary_STL_faces(text) * size_of_STL_face);
  return is_binary ? parse_binary_STL(text) : parse_STL_text(text);
}

// Of the other formats that CGAL reads, which tells no reason.
Soup read_other_soup(const std::string& filename)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons))
    throw File_refusal(0, "not a mesh of the format that the suffix names (.obj, .ply, .off, and "
                          ".stl files are read best)");
  Soup soup;
  for(const auto& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(std::vector<std::size_t>& polygon : polygons)
    soup.polygons.push_back({std::move(polygon), 0});
  return soup;
}

std::string format_of_text(const std::string_view text)
{
  if(text.substr(0, 3) == "ply")
    return "ply";
  if(text.substr(0, 5) == "solid")
    return "stl";
  return text.substr(0, text.find_first_of(" \t\r\n")).find("OFF") == text.npos ? "obj" : "off";
}

Soup parse(const std::string& filename, const std::string& format, const std::string_view text)
{
  if(format == "obj")
    return SS::internal::OBJ_parser<double, void>(text).parse();
  if(format == "ply")
    return SS::internal::PLY_parser<double, void>(text).parse();
  if(format == "off")
    return parse_OFF(text);
  return format == "stl" ? parse_STL(text) : read_other_soup(filename);
}

// What text tells by itself.
void check(const Soup& soup)
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

} // namespace

Polygon_soup read_polygon_soup(const std::string& filename)
{
  const std::string text = read_file(filename);
  const std::string format = is_special_file(filename) ? format_of_text(text)
                                                       : suffix_of(filename);
  try {
    const SS::internal::Protect_exact_arithmetic protect; // of the mode in which numbers are read
    Polygon_soup result{parse(filename, format, text), format, format == "obj" ? 1u : 0u};
    check(result);
    return result;
  } catch(const File_refusal& refusal) {
    throw Failure(UNREADABLE, filename + ": " + refusal.message());
  }
}
