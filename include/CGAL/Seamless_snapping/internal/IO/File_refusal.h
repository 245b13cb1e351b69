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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_REFUSAL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_REFUSAL_H

#include <CGAL/license/Seamless_snapping.h>

// The reason for refusing a file. Never leaves the readers and writers.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A remedy for files without coordinates.
constexpr const char* compute_coordinates = "approximate_seamless_parametrization() computes some";

class File_refusal
  : public std::runtime_error
{
public:
  // `line` is the one to look at; 0: none
  File_refusal(const std::size_t line, const Message& reason)
    : std::runtime_error(reason.str()), m_reason(reason), m_line(line)
  { }

  std::size_t line() const { return m_line; }

  // With the line, if there is one.
  Message message() const
  {
    return (m_line == 0 ? "" : "line " + std::to_string(m_line) + ": ") + m_reason;
  }

private:
  Message m_reason;
  std::size_t m_line;
};

// The token fit for a message: not too long, printable characters only.
inline std::string printable(std::string_view token)
{
  const std::size_t longest = 40;
  std::string result;
  for(const char c : token.substr(0, longest))
    result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (token.size() > longest ? "..." : "");
}

inline std::string quoted(std::string_view token) { return "'" + printable(token) + "'"; }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_REFUSAL_H
