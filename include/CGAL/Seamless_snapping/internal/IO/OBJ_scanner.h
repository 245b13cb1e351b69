// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H

#include <CGAL/license/Seamless_snapping.h>

// The text of an OBJ file as statements and tokens, and tokens as numbers. Knows where lines end,
// and nothing of what the statements mean.

#include <CGAL/Seamless_snapping/internal/IO/locale_free_decimals.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Why a file is refused, and the line to look at (0: none). Never leaves the reader and the writer.
class OBJ_refusal
  : public std::runtime_error
{
public:
  OBJ_refusal(std::size_t line, const std::string& reason)
    : std::runtime_error(reason), m_line(line)
  { }

  std::size_t line() const { return m_line; }

private:
  std::size_t m_line;
};

// Walks through a text; stands within or at the end of the statement that starts at `line()`.
// Lines end with LF, CRLF, or CR; a backslash before the end of a line joins it to the next one,
// except in comments, where it is text (as in the path of a folder).
class OBJ_scanner
{
public:
  explicit OBJ_scanner(std::string_view text)
    : m_text(text)
  {
    const std::string_view utf8_mark("\xEF\xBB\xBF");
    if(m_text.substr(0, utf8_mark.size()) == utf8_mark)
      m_position = utf8_mark.size();
  }

  // Goes to the next statement and returns its keyword, which is empty at the end of the text;
  // `line()` is then that of the last statement.
  std::string_view next_statement()
  {
    while(m_position < m_text.size()) {
      if(m_has_started) {
        while(!next_token().empty()) { }
        skip_comment();
        skip_line_end();
      }
      m_has_started = true;
      skip_blanks();
      const std::size_t line = m_physical_line;
      const std::string_view keyword = next_token();
      if(!keyword.empty()) {
        m_line = line;
        return keyword;
      }
    }
    return std::string_view();
  }

  // Returns the next token of the statement, which is empty at the statement's end.
  std::string_view next_token()
  {
    skip_blanks();
    const std::size_t begin = m_position;
    if(begin < m_text.size() && m_text[begin] == '#')
      return std::string_view();
    while(m_position < m_text.size() && !is_blank(m_text[m_position])
          && !is_line_end(m_text[m_position]) && !at_continuation())
      ++m_position;
    return m_text.substr(begin, m_position - begin);
  }

  // The line on which the statement starts, counted from 1.
  std::size_t line() const { return m_line; }

  [[noreturn]] void refuse(const std::string& reason) const { throw OBJ_refusal(m_line, reason); }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  bool at_continuation() const
  {
    return m_text[m_position] == '\\' && m_position + 1 < m_text.size()
           && is_line_end(m_text[m_position + 1]);
  }

  void skip_blanks()
  {
    while(m_position < m_text.size()) {
      if(is_blank(m_text[m_position])) {
        ++m_position;
      } else if(at_continuation()) {
        ++m_position;
        skip_line_end();
      } else {
        return;
      }
    }
  }

  void skip_comment()
  {
    while(m_position < m_text.size() && !is_line_end(m_text[m_position]))
      ++m_position;
  }

  void skip_line_end()
  {
    if(m_position == m_text.size())
      return;
    const bool crlf = m_text.substr(m_position, 2) == "\r\n";
    m_position += crlf ? 2 : 1;
    ++m_physical_line;
  }

  std::string_view m_text;
  std::size_t m_position = 0;
  std::size_t m_physical_line = 1;
  std::size_t m_line = 1;
  bool m_has_started = false;
};

// The token in quotes, fit for a message: not too long, printable characters only.
inline std::string quoted(std::string_view token)
{
  const std::size_t longest = 40;
  std::string result = "'";
  for(const char c : token.substr(0, longest))
    result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (token.size() > longest ? "...'" : "'");
}

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

// Returns the number of type `Number` (`float` or `double`) that is nearest to the decimal `token`;
// 0, with the token's sign, if it is smaller than the smallest one. Independent of the locale.
template <typename Number>
Number parse_number(const OBJ_scanner& scanner, const std::string_view token)
{
  const bool minus = token.substr(0, 1) == "-";
  const bool plus = token.substr(0, 1) == "+"; // which `std::from_chars` does not know
  const std::string_view digits = token.substr(minus || plus ? 1 : 0);
  const std::string_view number = plus ? digits : token;
  if(digits.find_first_of(".0123456789") != 0) // "nan", "inf", "+-1", and words
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H
