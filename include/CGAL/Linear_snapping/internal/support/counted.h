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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COUNTED_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COUNTED_H

#include <CGAL/license/Linear_snapping.h>

// Numbers of things in words.

#include <cstddef>
#include <string>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// "1 face", "2 faces", "2 boundary vertices", "2 branches"
inline std::string counted(const std::size_t n, const std::string& noun)
{
  const auto ends_in = [&](const std::string& end) {
    return noun.size() >= end.size() &&
           noun.compare(noun.size() - end.size(), end.size(), end) == 0;
  };
  const std::string plural = ends_in("vertex") ? noun.substr(0, noun.size() - 2) + "ices"
                                               : noun + (ends_in("ch") ? "es" : "s");
  return std::to_string(n) + " " + (n == 1 ? noun : plural);
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COUNTED_H
