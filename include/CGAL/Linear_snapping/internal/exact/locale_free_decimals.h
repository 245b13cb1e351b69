// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_LOCALE_FREE_DECIMALS_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_LOCALE_FREE_DECIMALS_H

#include <CGAL/license/Linear_snapping.h>

// Floating point numbers as decimal text, independent of the locale: `std::from_chars` and
// `std::to_chars`, or streams if the standard library has these functions for integers only, as
// libc++ before version 20.

#include <charconv>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The end of the decimal number that `text` begins with: digits with at most one point among them,
// at least one digit, then perhaps an exponent. 0 if there is none.
inline std::size_t end_of_decimal(const std::string_view text)
{
  const auto skip_digits = [&](std::size_t i)
  {
    while(i < text.size() && text[i] >= '0' && text[i] <= '9')
      ++i;
    return i;
  };
  const std::size_t begin = text.substr(0, 1) == "-" ? 1 : 0;
  std::size_t end = skip_digits(begin);
  std::size_t digits = end - begin;
  if(text.substr(end, 1) == ".") {
    const std::size_t fraction = end + 1;
    end = skip_digits(fraction);
    digits += end - fraction;
  }
  if(digits == 0)
    return 0;
  if(text.substr(end, 1) == "e" || text.substr(end, 1) == "E") {
    const std::string_view sign = text.substr(end + 1, 1);
    const std::size_t exponent = end + (sign == "+" || sign == "-" ? 2 : 1);
    if(skip_digits(exponent) > exponent)
      end = skip_digits(exponent);
  }
  return end;
}

// As `std::from_chars` without infinity and NaN; a number beyond the range gives
// `std::errc::result_out_of_range` if it is too large, and the nearest one if it is too small.
template <typename Number>
std::from_chars_result read_decimal_by_stream(const std::string_view text, Number& value)
{
  const std::size_t end = end_of_decimal(text);
  if(end == 0)
    return {text.data(), std::errc::invalid_argument};
  std::istringstream is{std::string(text.substr(0, end))};
  is.imbue(std::locale::classic());
  Number read = 0;
  const bool failed = !(is >> read); // some libraries fail on numbers below the smallest normal one
  const Number largest = (std::numeric_limits<Number>::max)();
  if(failed && (read >= largest || read <= -largest))
    return {text.data() + end, std::errc::result_out_of_range};
  value = read;
  return {text.data() + end, std::errc()};
}

// With as many digits as determine the number.
template <typename Number>
std::string decimal_by_stream(const Number x,
                              const int digits = std::numeric_limits<Number>::max_digits10)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(digits);
  os << x;
  return os.str();
}

template <typename Number>
std::from_chars_result read_decimal(const std::string_view text, Number& value)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(text.data(), text.data() + text.size(), value);
#else
  return read_decimal_by_stream(text, value);
#endif
}

// The shortest text that is read as the same double, where the library knows it.
inline void append_decimal(std::string& text, const double x)
{
#ifdef __cpp_lib_to_chars
  char buffer[32]; // 24 are enough for the shortest form of a double
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), x).ptr);
#else
  text += decimal_by_stream(x);
#endif
}

// With three digits, for messages. Independent of the rounding mode, too.
inline std::string short_number(const double x)
{
#ifdef __cpp_lib_to_chars
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof(buffer), x, std::chars_format::general,
                                3).ptr};
#else
  return decimal_by_stream(x, 3);
#endif
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_LOCALE_FREE_DECIMALS_H
