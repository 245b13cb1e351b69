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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DECIMAL_NUMBERS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DECIMAL_NUMBERS_H

#include <CGAL/license/Seamless_snapping.h>

// The numbers of a file: from decimals to floating point and back, and the refusal of other words.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Whether a decimal number that is beyond the range of its type is too large, not too small: looks
// where its first digit other than 0 stands. `std::from_chars` does not tell.
inline bool is_at_least_one(std::string_view number)
{
  const std::size_t e = (std::min)(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const std::size_t first = (std::min)(mantissa.find_first_of("123456789"), e);
  const std::size_t point = (std::min)(mantissa.find('.'), e);
  const long long leading = first < point ? static_cast<long long>(point - first) - 1
                                          : -static_cast<long long>(first - point);
  if(e == number.size())
    return leading >= 0;

  const bool negative = number.substr(e + 1, 1) == "-";
  const std::size_t digits = e + (number.find_first_of("+-", e) == e + 1 ? 2 : 1);
  long long exponent = 0;
  if(std::from_chars(number.data() + digits, number.data() + number.size(), exponent).ec
       != std::errc())
    return !negative; // an exponent of twenty digits outweighs any mantissa
  return leading + (negative ? -exponent : exponent) >= 0;
}

// Whether a token is an integer that its type holds; if so, sets the value.
template <typename Integer>
bool parse_integer(const std::string_view token, Integer& value)
{
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  return result.ptr == end && result.ec == std::errc();
}

// Returns the number of type `Number` (`float` or `double`) that is nearest to the decimal `token`;
// 0, with the token's sign, if it is smaller than the smallest one. Independent of the locale.
// `scanner.refuse(reason)` throws.
template <typename Number, typename Scanner>
Number parse_number(const Scanner& scanner, const std::string_view token)
{
  const char sign = token.empty() ? ' ' : token[0];
  const bool minus = sign == '-';
  const bool plus = sign == '+'; // which `std::from_chars` does not know
  const std::string_view digits = token.substr(minus || plus ? 1 : 0);
  const std::string_view number = plus ? digits : token;
  const char first = digits.empty() ? ' ' : digits[0];
  if(first != '.' && (first < '0' || first > '9')) // "nan", "inf", "+-1", and words
    scanner.refuse(quoted(token) + " is not a finite number");

  Number value = 0;
  const char* const end = number.data() + number.size();
  const std::from_chars_result result = read_decimal(number, value);
  if(result.ptr != end || result.ec == std::errc::invalid_argument)
    scanner.refuse(quoted(token) + " is not a number");
  if(result.ec == std::errc::result_out_of_range) {
    if(is_at_least_one(digits))
      scanner.refuse(quoted(token) + " is too large for the number type");
    value = minus ? -Number(0) : Number(0);
  }
  return value;
}

// Appends a decimal that, taken for a `double`, is `x`. Throws unless `x` is finite.
inline void append_number(const double x, std::string& text)
{
  if(!std::isfinite(x))
    throw File_refusal(0, "a coordinate is not finite; nothing is written");
  append_decimal(text, x);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DECIMAL_NUMBERS_H
