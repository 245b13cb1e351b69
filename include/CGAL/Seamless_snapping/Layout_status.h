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

#ifndef CGAL_SEAMLESS_SNAPPING_LAYOUT_STATUS_H
#define CGAL_SEAMLESS_SNAPPING_LAYOUT_STATUS_H

#include <CGAL/license/Seamless_snapping.h>

// How the computation of a layout ends.

#include <ostream>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingLayout

The outcome of `motorcycle_graph()`. After any other than `PARTITIONED` the graph is empty.
*/
enum class Layout_status
{
  PARTITIONED,        ///< the surface is divided, and all checks held
  INEXACT_ARITHMETIC, ///< the processor or the compiler doesn't compute as IEEE 754 says
  INVALID_ARGUMENT,   ///< no face, given rotations that contradict each other, and the like
  NOT_TRIANGULAR,     ///< a face of the input is not a triangle
  NOT_FINITE,         ///< a coordinate is NaN, infinite, or beyond 1e300
  NOT_SEAMLESS,       ///< the map is not exactly seamless
  NOT_POSITIVE,       ///< faces are flipped or degenerate in the domain
  NOT_ALIGNED,        ///< a feature edge does not lie on an isocurve, or a border edge where that
                      ///< is asked for
  TOO_LARGE,          ///< the curves are longer than allowed
  INTERNAL_ERROR      ///< the result failed its own exact verification and was discarded
};

/*!
\ingroup PkgSeamlessSnappingLayout
returns the status in words.
*/
inline const char* to_string(const Layout_status status)
{
  switch(status) {
  case Layout_status::PARTITIONED:        return "partitioned";
  case Layout_status::INEXACT_ARITHMETIC: return "inexact arithmetic";
  case Layout_status::INVALID_ARGUMENT:   return "invalid argument";
  case Layout_status::NOT_TRIANGULAR:     return "not triangular";
  case Layout_status::NOT_FINITE:         return "not finite";
  case Layout_status::NOT_SEAMLESS:       return "not seamless";
  case Layout_status::NOT_POSITIVE:       return "not positive";
  case Layout_status::NOT_ALIGNED:        return "not aligned";
  case Layout_status::TOO_LARGE:          return "too large";
  case Layout_status::INTERNAL_ERROR:     break;
  }
  return "internal error";
}

/*!
\ingroup PkgSeamlessSnappingLayout
writes the status in words.
*/
inline std::ostream& operator<<(std::ostream& os, const Layout_status status)
{
  return os << to_string(status);
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_LAYOUT_STATUS_H
