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

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
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
  PLY_type count_type = PLY_type::UINT8; // for lists
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

// The values in a PLY file, one after the other, as they stand there: text or bytes.

// Whether this machine holds the byte of least value first.
constexpr bool is_little_endian = boost::endian::order::native == boost::endian::order::little;

// A value of a binary file.
template <typename T>
T from_bytes(const std::string_view bytes, const PLY_format format)
{
  std::array<char, sizeof(T)> copy;
  std::copy(bytes.begin(), bytes.begin() + sizeof(T), copy.begin());
  if((format == PLY_format::LITTLE_ENDIAN_BYTES) != is_little_endian)
    std::reverse(copy.begin(), copy.end());
  T value;
  std::memcpy(&value, copy.data(), sizeof(T));
  return value;
}

template <typename T>
void append_bytes(const T value, const PLY_format format, std::string& text)
{
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), &value, sizeof(T));
  if((format == PLY_format::LITTLE_ENDIAN_BYTES) != is_little_endian)
    std::reverse(copy.begin(), copy.end());
  text.append(copy.data(), copy.size());
}

// Walks through the body of a file.
class PLY_values
{
public:
  PLY_values(const std::string_view text, const PLY_header& header)
    : m_text(text), m_format(header.format), m_position(header.size)
  { }

  // Names the place of the values that come next, for messages.
  void set_place(const std::string_view element, const unsigned long long index)
  {
    m_element = element;
    m_index = index;
  }

  // The next value as it stands in the file.
  std::string_view next(const PLY_type type)
  {
    std::size_t size = size_of(type);
    if(m_format == PLY_format::ASCII) {
      m_position = (std::min)(m_text.find_first_not_of(" \t\r\n", m_position), m_text.size());
      size = (std::min)(m_text.find_first_of(" \t\r\n", m_position), m_text.size()) - m_position;
    }
    if(size == 0 || size > m_text.size() - m_position)
      refuse("the file ends here");
    m_position += size;
    return m_text.substr(m_position - size, size);
  }

  long long integer(const std::string_view value, const PLY_type type) const
  {
    if(m_format == PLY_format::ASCII) {
      long long result = 0;
      if(!parse_integer(value, result))
        refuse(quoted(value) + " is not an integer");
      return result;
    }
    switch(type) {
    case PLY_type::INT8: return from_bytes<std::int8_t>(value, m_format);
    case PLY_type::UINT8: return from_bytes<std::uint8_t>(value, m_format);
    case PLY_type::INT16: return from_bytes<std::int16_t>(value, m_format);
    case PLY_type::UINT16: return from_bytes<std::uint16_t>(value, m_format);
    case PLY_type::INT32: return from_bytes<std::int32_t>(value, m_format);
    case PLY_type::UINT32: return from_bytes<std::uint32_t>(value, m_format);
    default: refuse("an integer is needed, but the type is floating point");
    }
  }

  // The nearest number of this type.
  template <typename Number>
  Number number(const std::string_view value, const PLY_type type) const
  {
    if(m_format == PLY_format::ASCII)
      return parse_number<Number>(*this, value);
    if(is_integer(type))
      return static_cast<Number>(integer(value, type));
    const double x = type == PLY_type::FLOAT ? double(from_bytes<float>(value, m_format))
                                             : from_bytes<double>(value, m_format);
    if(!std::isfinite(x))
      refuse("a number is not finite");
    if(std::abs(x) > (std::numeric_limits<Number>::max)())
      refuse("a number is too large for the number type");
    return static_cast<Number>(x);
  }

  std::size_t next_length(const PLY_property& property)
  {
    if(!property.is_list)
      return 1;
    const long long length = integer(next(property.count_type), property.count_type);
    if(length < 0)
      refuse("a list has a negative length");
    return static_cast<std::size_t>(length);
  }

  void skip(const PLY_property& property)
  {
    for(std::size_t length = next_length(property); length > 0; --length)
      next(property.type);
  }

  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw File_refusal(0, printable(m_element) + " " + std::to_string(m_index) + ": " + reason);
  }

private:
  std::string_view m_text;
  PLY_format m_format;
  std::size_t m_position;
  std::string_view m_element;
  unsigned long long m_index = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_HEADER_H
