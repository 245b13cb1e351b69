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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_PARSER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_PARSER_H

#include <CGAL/license/Seamless_snapping.h>

// The text of an OBJ file as a triangle soup or, for coordinates of type `void`, as a polygon soup
// without coordinates. Checks each statement, and no relation between statements
// but that indices are in range.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename PointNumber, typename UVNumber>
class OBJ_parser
{
public:
  using Soup = Corner_soup<PointNumber, UVNumber>;

  explicit OBJ_parser(std::string_view text)
    : m_scanner(text)
  {
    if constexpr(has_uvs)
      m_soup.triangles.reserve(text.size() / 80); // in large files, so many bytes for each
  }

  // To be called once. Throws `File_refusal`.
  Soup parse();

private:
  static constexpr bool has_uvs = !std::is_void_v<UVNumber>;

  // A fourth number is a weight, unless it begins a color, which is dropped.
  std::array<PointNumber, 3> parse_point()
  {
    std::array<PointNumber, 4> numbers{};
    if(parse_numbers("v", 3, numbers) == 4 && numbers[3] != 1)
      m_scanner.refuse("point has a weight other than 1");
    return {numbers[0], numbers[1], numbers[2]};
  }

  // The third coordinate of a texture is dropped.
  void parse_uv()
  {
    std::array<UVNumber, 2> numbers{};
    parse_numbers("vt", 2, numbers);
    m_soup.uvs.push_back(numbers);
  }

  // Returns how many numbers there are; numbers without a place are checked and dropped.
  template <typename Number, std::size_t n>
  std::size_t parse_numbers(const char* keyword, const std::size_t needed,
                            std::array<Number, n>& numbers)
  {
    std::size_t count = 0;
    for(std::string_view token; !(token = m_scanner.next_token()).empty();) {
      const Number number = parse_number<Number>(m_scanner, token);
      if(count < n)
        numbers[count] = number;
      ++count;
    }
    if(count < needed)
      m_scanner.refuse(std::string(keyword) + " needs " + std::to_string(needed)
                       + " coordinates, but has " + std::to_string(count));
    return count;
  }

  void parse_triangle()
  {
    typename Soup::Triangle triangle;
    triangle.line = line();
    std::size_t count = 0;
    while(count < 3 && m_scanner.next_pair(triangle.vertices[count], triangle.uvs[count])) {
      --triangle.vertices[count];
      --triangle.uvs[count++];
    }
    for(std::string_view token; !(token = m_scanner.next_token()).empty();) {
      if(count < 3)
        parse_corner(token, triangle.vertices[count], triangle.uvs[count]);
      ++count;
    }
    if(count != 3)
      m_scanner.refuse("face has " + std::to_string(count) + " corners"
                       + (count > 3 ? "; triangulate the mesh first" : ", but needs 3"));

    const std::array<Soup_index, 3>& v = triangle.vertices;
    if(v[0] == v[1] || v[0] == v[2] || v[1] == v[2])
      m_scanner.refuse("face uses vertex "
                       + std::to_string(std::size_t(v[0] == v[1] ? v[0] : v[2]) + 1) + " twice");
    m_soup.triangles.push_back(triangle);
  }

  Soup_index line() const
  {
    if(m_scanner.line() > largest_soup_index)
      m_scanner.refuse("the file has more lines than can be counted");
    return static_cast<Soup_index>(m_scanner.line());
  }

  // A corner is v/vt or v/vt/vn; the normal is checked to be an index and dropped.
  void parse_corner(const std::string_view token, Soup_index& vertex, Soup_index& uv) const
  {
    const std::size_t first = (std::min)(token.find('/'), token.size());
    const std::size_t second = (std::min)(token.find('/', first + 1), token.size());
    if(second < first + 2)
      m_scanner.refuse("corner " + quoted(token) + " has no texture coordinate (vt)" +
                       remedy(compute_coordinates));
    vertex = parse_index(token.substr(0, first), m_soup.points.size(), "vertex");
    uv = parse_index(token.substr(first + 1, second - first - 1), m_soup.uvs.size(),
                     "texture coordinate");
    if(second + 1 < token.size())
      parse_signed_index(token.substr(second + 1), "normal");
  }

  // Corners are v, v/vt, v//vn, or v/vt/vn.
  template <typename Polygons>
  void parse_polygon(Polygons& polygons)
  {
    typename Polygons::value_type polygon;
    polygon.line = m_scanner.line();
    for(std::string_view token; !(token = m_scanner.next_token()).empty();)
      polygon.vertices.push_back(parse_index(token.substr(0, token.find('/')),
                                             m_soup.points.size(), "vertex"));
    polygons.push_back(std::move(polygon));
  }

  void parse_polyline()
  {
    std::size_t count = 0;
    Soup_segment segment{};
    segment.line = m_scanner.line();
    for(std::string_view token; !(token = m_scanner.next_token()).empty();) {
      const std::size_t slash = token.find('/'); // in an element v/vt
      if(slash != token.npos)
        parse_signed_index(token.substr(slash + 1), "texture coordinate");
      segment.vertices[0] = segment.vertices[1];
      segment.vertices[1] = parse_index(token.substr(0, slash), m_soup.points.size(),
                                        "vertex");
      if(count > 0)
        m_soup.segments.push_back(segment);
      ++count;
    }
    if(count < 2)
      m_scanner.refuse("line element needs 2 vertices or more, but has " + std::to_string(count));
  }

  long long parse_signed_index(const std::string_view token, const char* of) const
  {
    long long index = 0;
    const char* const end = token.data() + token.size();
    const std::from_chars_result result = std::from_chars(token.data(), end, index);
    if(result.ptr != end || result.ec == std::errc::invalid_argument)
      m_scanner.refuse(quoted(token) + " is not the index of a " + of);
    if(result.ec != std::errc())
      m_scanner.refuse(of + (" index " + quoted(token)) + " is out of range");
    if(index == 0)
      m_scanner.refuse(of + std::string(" index 0: indices start at 1"));
    return index;
  }

  // A negative index counts back from the last element so far. A positive one may point forward, so
  // that its range is checked at the end.
  Soup_index parse_index(const std::string_view token, std::size_t size, const char* of) const
  {
    const long long index = parse_signed_index(token, of);
    if(index < 0 && static_cast<std::size_t>(-(index + 1)) >= size)
      m_scanner.refuse(of + (" index " + std::to_string(index)) + " is out of range: there are "
                       + std::to_string(size) + " so far");
    const std::size_t result = index > 0 ? static_cast<std::size_t>(index - 1)
                                         : size - static_cast<std::size_t>(-(index + 1)) - 1;
    if(result > largest_soup_index)
      m_scanner.refuse(of + (" index " + quoted(token)) + " is out of range");
    return static_cast<Soup_index>(result);
  }

  void check_indices() const
  {
    for(const auto& face : m_soup.faces()) {
      for(const std::size_t vertex : face.vertices)
        check_index(vertex, m_soup.points.size(), "vertex", face.line);
      if constexpr(has_uvs)
        for(const std::size_t uv : face.uvs)
          check_index(uv, m_soup.uvs.size(), "texture coordinate", face.line);
    }
    for(const Soup_segment& segment : m_soup.segments)
      for(const std::size_t vertex : segment.vertices)
        check_index(vertex, m_soup.points.size(), "vertex", segment.line);
  }

  static void check_index(std::size_t index, std::size_t size, const char* of, std::size_t line)
  {
    if(index >= size)
      throw File_refusal(line, of + (" index " + std::to_string(index + 1))
                                + " is out of range: the file has " + std::to_string(size));
  }

  OBJ_scanner m_scanner;
  Soup m_soup;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename PointNumber, typename UVNumber>
Corner_soup<PointNumber, UVNumber> OBJ_parser<PointNumber, UVNumber>::parse()
{
  // the fast path of `std::from_chars` multiplies in the current rounding mode
  const Protect_exact_arithmetic protect;

  for(std::string_view keyword; !(keyword = m_scanner.next_statement()).empty();) {
    if(keyword == "v")
      m_soup.points.push_back(parse_point());
    else if(keyword == "l")
      parse_polyline();
    else if constexpr(has_uvs) {
      if(keyword == "vt")
        parse_uv();
      else if(keyword == "f")
        parse_triangle();
    } else if(keyword == "f")
      parse_polygon(m_soup.polygons);
  }
  if(m_soup.faces().empty())
    throw File_refusal(0, "the file has no face");
  check_indices();
  return std::move(m_soup);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_PARSER_H
