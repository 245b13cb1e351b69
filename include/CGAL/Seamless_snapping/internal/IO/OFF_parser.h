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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OFF_PARSER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OFF_PARSER_H

#include <CGAL/license/Seamless_snapping.h>

// Reads the format OFF: polygons, and no coordinates per corner.

#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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
inline Corner_soup<double, void> parse_OFF(const std::string_view text)
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
  Corner_soup<double, void> soup;
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OFF_PARSER_H
