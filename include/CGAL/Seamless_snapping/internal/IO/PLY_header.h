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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_HEADER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_HEADER_H

#include <CGAL/license/Seamless_snapping.h>

// The head of a PLY file: which elements with which properties follow, and how they are written.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

enum class PLY_format { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

enum class PLY_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

// In bytes, in binary files.
inline std::size_t size_of(const PLY_type type)
{
  switch(type) {
  case PLY_type::INT8: case PLY_type::UINT8: return 1;
  case PLY_type::INT16: case PLY_type::UINT16: return 2;
  case PLY_type::DOUBLE: return 8;
  default: return 4;
  }
}

inline bool is_integer(const PLY_type type)
{
  return type != PLY_type::FLOAT && type != PLY_type::DOUBLE;
}

struct PLY_property
{
  std::string_view name;
  PLY_type type;
  std::string_view type_name; // where it stands in the header
  bool is_list = false;
  PLY_type count_type = PLY_type::UINT8; // of lists
};

struct PLY_element
{
  std::string_view name;
  unsigned long long count;
  std::vector<PLY_property> properties;

  // Returns the index of the property of one of the names, `properties.size()` if there is none.
  std::size_t find(const std::vector<std::string_view>& names) const
  {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&names](const PLY_property& p) {
      return std::find(names.begin(), names.end(), p.name) != names.end();
    });
    return static_cast<std::size_t>(found - properties.begin());
  }
};

struct PLY_header
{
  PLY_format format = PLY_format::ASCII;
  std::vector<PLY_element> elements;
  std::size_t size = 0; // in bytes
};

class PLY_header_parser
{
public:
  explicit PLY_header_parser(const std::string_view text) : m_text(text) { }

  // To be called once. Throws `File_refusal`.
  PLY_header parse()
  {
    if(next_line() != "ply")
      refuse("the file does not begin with 'ply'");
    bool has_format = false;
    for(std::string_view line = next_line(); line != "end_header"; line = next_line()) {
      if(line.empty() && m_position == m_text.size())
        refuse("the header has no end ('end_header')");
      const std::vector<std::string_view> tokens = split(line);
      const std::string_view keyword = tokens.empty() ? std::string_view() : tokens[0];
      if(keyword == "format") {
        parse_format(tokens);
        has_format = true;
      } else if(keyword == "element") {
        parse_element(tokens);
      } else if(keyword == "property") {
        parse_property(tokens);
      } else if(keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        refuse(quoted(keyword) + " is not a keyword");
      }
    }
    if(!has_format)
      refuse("the header tells no format");
    m_header.size = m_position;
    return std::move(m_header);
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const { throw File_refusal(m_line, reason); }

  // Lines end with LF, CRLF, or CR.
  std::string_view next_line()
  {
    ++m_line;
    const std::size_t begin = m_position;
    const std::size_t end = (std::min)(m_text.find_first_of("\r\n", begin), m_text.size());
    m_position = (std::min)(end + (m_text.substr(end, 2) == "\r\n" ? 2 : 1), m_text.size());
    return m_text.substr(begin, end - begin);
  }

  static std::vector<std::string_view> split(const std::string_view line)
  {
    std::vector<std::string_view> tokens;
    for(std::size_t begin = line.find_first_not_of(" \t"); begin < line.size(); ) {
      const std::size_t end = (std::min)(line.find_first_of(" \t", begin), line.size());
      tokens.push_back(line.substr(begin, end - begin));
      begin = line.find_first_not_of(" \t", end);
    }
    return tokens;
  }

  void parse_format(const std::vector<std::string_view>& tokens)
  {
    const std::string_view name = tokens.size() > 1 ? tokens[1] : std::string_view();
    if(name == "ascii")
      m_header.format = PLY_format::ASCII;
    else if(name == "binary_little_endian")
      m_header.format = PLY_format::LITTLE_ENDIAN_BYTES;
    else if(name == "binary_big_endian")
      m_header.format = PLY_format::BIG_ENDIAN_BYTES;
    else
      refuse(quoted(name) + " is not a format");
  }

  void parse_element(const std::vector<std::string_view>& tokens)
  {
    if(tokens.size() != 3)
      refuse("an element needs a name and a number");
    for(const PLY_element& other : m_header.elements)
      if(other.name == tokens[1])
        refuse("there are two elements " + quoted(tokens[1]));
    PLY_element element{tokens[1], 0, {}};
    if(!parse_integer(tokens[2], element.count))
      refuse(quoted(tokens[2]) + " is not a number of elements");
    m_header.elements.push_back(element);
  }

  void parse_property(const std::vector<std::string_view>& tokens)
  {
    if(m_header.elements.empty())
      refuse("a property comes before any element");
    PLY_property property{};
    property.is_list = tokens.size() > 1 && tokens[1] == "list";
    if(tokens.size() != (property.is_list ? 5 : 3))
      refuse("a property needs a type and a name");
    if(property.is_list) {
      property.count_type = parse_type(tokens[2]);
      if(!is_integer(property.count_type))
        refuse("the length of a list is not an integer");
    }
    property.type_name = tokens[tokens.size() - 2];
    property.type = parse_type(property.type_name);
    property.name = tokens.back();
    m_header.elements.back().properties.push_back(property);
  }

  PLY_type parse_type(const std::string_view token) const
  {
    constexpr std::array<std::pair<const char*, PLY_type>, 16> names = {{
      {"char", PLY_type::INT8}, {"int8", PLY_type::INT8},
      {"uchar", PLY_type::UINT8}, {"uint8", PLY_type::UINT8},
      {"short", PLY_type::INT16}, {"int16", PLY_type::INT16},
      {"ushort", PLY_type::UINT16}, {"uint16", PLY_type::UINT16},
      {"int", PLY_type::INT32}, {"int32", PLY_type::INT32},
      {"uint", PLY_type::UINT32}, {"uint32", PLY_type::UINT32},
      {"float", PLY_type::FLOAT}, {"float32", PLY_type::FLOAT},
      {"double", PLY_type::DOUBLE}, {"float64", PLY_type::DOUBLE}
    }};
    const auto found = std::find_if(names.begin(), names.end(),
                                    [token](const auto& name) { return name.first == token; });
    if(found == names.end())
      refuse(quoted(token) + " is not a type");
    return found->second;
  }

  std::string_view m_text;
  PLY_header m_header;
  std::size_t m_position = 0;
  std::size_t m_line = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_HEADER_H
