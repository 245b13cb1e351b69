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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_VALUES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_VALUES_H

#include <CGAL/license/Seamless_snapping.h>

// The values in a PLY file, one after the other, as they stand there: text or bytes.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Whether this machine holds the byte of least value first.
inline bool is_little_endian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

// A value of a binary file.
template <typename T>
T from_bytes(const std::string_view bytes, const PLY_format format)
{
  std::array<char, sizeof(T)> copy;
  std::copy(bytes.begin(), bytes.begin() + sizeof(T), copy.begin());
  if((format == PLY_format::LITTLE_ENDIAN_BYTES) != is_little_endian())
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
  if((format == PLY_format::LITTLE_ENDIAN_BYTES) != is_little_endian())
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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_VALUES_H
