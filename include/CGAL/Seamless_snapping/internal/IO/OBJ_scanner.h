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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H

#include <CGAL/license/Seamless_snapping.h>

// The text of an OBJ file as statements and tokens. Knows the ends of lines, but not the meaning of
// statements.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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
  // `line()` is then the line of the last statement.
  std::string_view next_statement()
  {
    while(m_position < m_text.size()) {
      if(m_is_in_statement)
        finish_statement();
      m_is_in_statement = true;
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
    const char* const end = m_text.data() + m_text.size();
    for(;; ++m_position) {
      const char* c = m_text.data() + m_position;
      while(c != end && is_surely_in_token(*c))
        ++c;
      m_position = std::size_t(c - m_text.data());
      if(c == end || is_blank(*c) || is_line_end(*c) || at_continuation())
        return m_text.substr(begin, m_position - begin);
    }
  }

  // Takes the next token if it is v/w, both of 9 digits or less, as most corners of faces are; else
  // stays where it is.
  bool next_pair(std::uint32_t& v, std::uint32_t& w)
  {
    skip_blanks();
    const char *c = m_text.data() + m_position, *const end = m_text.data() + m_text.size();
    const auto number = [&c, end] {
      std::uint32_t result = 0;
      for(const char* const stop = end - c > 9 ? c + 9 : end; c != stop && is_digit(*c); ++c)
        result = 10 * result + std::uint32_t(*c - '0');
      return result;
    };
    v = number();
    if(c == end || *c++ != '/')
      return false;
    w = number();
    if(v == 0 || w == 0 || c == end || !(is_blank(*c) || is_line_end(*c)))
      return false;
    m_position = std::size_t(c - m_text.data());
    return true;
  }

  // Goes behind the end of the statement's last line, and returns that end, which is empty at the
  // end of the text.
  std::string_view finish_statement()
  {
    while(!next_token().empty()) { }
    skip_comment();
    const std::size_t begin = m_position;
    skip_line_end();
    m_is_in_statement = false;
    return m_text.substr(begin, m_position - begin);
  }

  // The line on which the statement starts, counted from 1.
  std::size_t line() const { return m_line; }

  [[noreturn]] void refuse(const Message& reason) const { throw File_refusal(m_line, reason); }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_surely_in_token(char c) { return c > ' ' && c != '\\'; } // nearly all are

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
  bool m_is_in_statement = false;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_SCANNER_H
