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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_HEXEX_PARSER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_HEXEX_PARSER_H

#include <CGAL/license/Seamless_snapping.h>

// The tokens of a file in the HEXEX format: a tetrahedral mesh with coordinates per corner. Some
// files have fractions of integers as coordinates, which are read as the nearest doubles.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The double nearest to a positive number; of two, that whose last bit is 0. Infinite if it is
// beyond all.
inline double nearest_double(const Exact_rational& q)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double below = CGAL::to_double(q); // near by
  if(!std::isfinite(below))
    return infinity;
  while(Exact_rational(below) > q)
    below = std::nextafter(below, -infinity);
  double above = std::nextafter(below, infinity);
  while(std::isfinite(above) && Exact_rational(above) <= q) {
    below = above;
    above = std::nextafter(below, infinity);
  }
  if(!std::isfinite(above))
    return Exact_rational(below) == q ? below : infinity;
  const Exact_rational to_below(q - Exact_rational(below)), to_above(Exact_rational(above) - q);
  if(to_below != to_above)
    return to_below < to_above ? below : above;
  int exponent = 0; // even is what half the digits hold
  const double significand = std::ldexp(std::frexp(below, &exponent), 52);
  return significand == std::floor(significand) ? below : above;
}

// A decimal number or a fraction.
// \param is_rounded whether the number is a fraction that no double holds
template <typename Scanner>
double parse_number_or_fraction(const Scanner& scanner, const std::string_view token,
                                bool& is_rounded)
{
  is_rounded = false;
  const std::size_t slash = token.find('/');
  if(slash == std::string_view::npos)
    return parse_number<double>(scanner, token);
  const bool is_negative = token.front() == '-';
  const std::size_t begin = is_negative || token.front() == '+' ? 1 : 0;
  const std::string_view p = token.substr(begin, slash - begin), q = token.substr(slash + 1);
  const auto are_digits = [](const std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if(!are_digits(p) || !are_digits(q))
    scanner.refuse(quoted(token) + " is not a number");
  const auto integer = [](const std::string_view digits) {
    const std::size_t first = digits.find_first_not_of('0'); // zeros before would make it octal
    return first == std::string_view::npos ? Exact_integer(0)
                                           : Exact_integer(std::string(digits.substr(first)));
  };
  const Exact_integer numerator = integer(p), denominator = integer(q);
  if(denominator == 0)
    scanner.refuse(quoted(token) + " divides by zero");
  if(numerator == 0)
    return 0;
  const Exact_rational number(Exact_rational(numerator) / Exact_rational(denominator));
  const double nearest = nearest_double(number);
  if(!std::isfinite(nearest))
    scanner.refuse(quoted(token) + " is too large for the number type");
  is_rounded = Exact_rational(nearest) != number;
  return is_negative ? -nearest : nearest;
}

// Walks through the words of a text, and knows their lines.
class Word_scanner
{
public:
  explicit Word_scanner(const std::string_view text)
    : m_text(text)
  { }

  // The next word, in whatever line; empty at the end of the text.
  std::string_view next()
  {
    skip(" \t\r\n\f\v");
    return word();
  }

  // The next word of the current line; empty at its end.
  std::string_view next_in_line()
  {
    skip(" \t\r\f\v");
    return word();
  }

  std::size_t line() const { return m_line; }

  [[noreturn]] void refuse(const std::string& reason) const { throw File_refusal(m_line, reason); }

  template <typename Number>
  Number next_integer(const char* const what)
  {
    const std::string_view token = next();
    if(token.empty())
      refuse(std::string("the file ends where ") + what + " should be");
    Number value = 0;
    if(!parse_integer(token, value))
      refuse(quoted(token) + " should be " + what);
    return value;
  }

private:
  void skip(const std::string_view blanks)
  {
    for(; m_position < m_text.size() && blanks.find(m_text[m_position]) != std::string_view::npos;
        ++m_position)
      if(m_text[m_position] == '\n')
        ++m_line;
  }

  std::string_view word()
  {
    const std::size_t begin = m_position;
    m_position = (std::min)(m_text.find_first_of(" \t\r\n\f\v", m_position), m_text.size());
    return m_text.substr(begin, m_position - begin);
  }

  std::string_view m_text;
  std::size_t m_position = 0, m_line = 1;
};

// A file holds: the number of vertices, and their points; the number of cells, and for each four
// vertices and the coordinates of its corners. Then perhaps the number of walls alone in a line,
// and three vertices and a distance for each; and perhaps the numbers of feature vertices, edges
// and facets in a line, and their vertices.
// \tparam Mesh `IO::HEXEX_mesh`
template <typename Mesh>
class HEXEX_parser
{
public:
  explicit HEXEX_parser(const std::string_view text)
    : m_scanner(text), m_size_of_text(text.size())
  { }

  Mesh parse()
  {
    read_points();
    read_cells();
    read_tail();
    return std::move(m_mesh);
  }

private:
  // Each element takes some characters, so that a wrong number cannot ask for much memory.
  std::size_t next_count(const char* const what)
  {
    const std::size_t count = m_scanner.next_integer<std::size_t>(what);
    if(count > m_size_of_text)
      m_scanner.refuse("the file is too short for so many");
    return count;
  }

  double next_number()
  {
    const std::string_view token = m_scanner.next();
    if(token.empty())
      m_scanner.refuse("the file ends where a coordinate should be");
    return parse_number_or_fraction(m_scanner, token, m_is_rounded);
  }

  void read_points()
  {
    const std::size_t size = next_count("the number of vertices");
    m_mesh.points.resize(size);
    for(std::array<double, 3>& p : m_mesh.points)
      for(double& x : p)
        x = next_number();
  }

  std::int32_t next_vertex()
  {
    const std::int32_t v = m_scanner.next_integer<std::int32_t>("the number of a vertex");
    if(v < 0 || std::size_t(v) >= m_mesh.points.size())
      m_scanner.refuse("there is no vertex " + std::to_string(v));
    return v;
  }

  void read_cells()
  {
    const std::size_t size = next_count("the number of cells");
    m_mesh.tetrahedra.resize(size);
    m_mesh.uvw.reserve(4 * size);
    for(std::array<std::int32_t, 4>& cell : m_mesh.tetrahedra) {
      for(std::int32_t& v : cell)
        v = next_vertex();
      for(int i = 0; i < 4; ++i) {
        m_mesh.uvw.emplace_back();
        for(double& x : m_mesh.uvw.back()) {
          x = next_number();
          m_mesh.number_of_rounded_coordinates += m_is_rounded ? 1 : 0;
        }
      }
    }
  }

  // The numbers of the next line that is not empty, as long as they are integers.
  std::vector<std::size_t> counts_of_line()
  {
    std::vector<std::size_t> result;
    for(std::string_view token = m_scanner.next(); !token.empty();
        token = m_scanner.next_in_line()) {
      std::size_t value = 0;
      if(!parse_integer(token, value))
        return {0, 0}; // neither walls nor features
      result.push_back(value);
    }
    return result;
  }

  void read_tail()
  {
    std::vector<std::size_t> counts = counts_of_line();
    if(counts.size() == 1) {
      for(std::size_t i = 0; i < counts[0]; ++i) {
        m_mesh.walls.push_back({next_vertex(), next_vertex(), next_vertex()});
        next_number();
      }
      counts = counts_of_line();
    }
    if(counts.size() != 3) {
      m_mesh.unknown_line = counts.empty() ? 0 : m_scanner.line();
      return;
    }
    for(std::size_t i = 0; i < counts[0]; ++i)
      m_mesh.feature_vertices.push_back(next_vertex());
    for(std::size_t i = 0; i < counts[1]; ++i)
      m_mesh.feature_edges.push_back({next_vertex(), next_vertex()});
    for(std::size_t i = 0; i < counts[2]; ++i)
      m_mesh.feature_facets.push_back({next_vertex(), next_vertex(), next_vertex()});
    if(!m_scanner.next().empty())
      m_mesh.unknown_line = m_scanner.line();
  }

  Word_scanner m_scanner;
  std::size_t m_size_of_text;
  bool m_is_rounded = false;
  Mesh m_mesh;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_HEXEX_PARSER_H
