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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_FORMAT_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_FORMAT_H

#include <CGAL/license/Seamless_snapping.h>

// Rounding to a number format that is known at run time only.

#include <CGAL/Seamless_snapping/internal/exact/Grid.h>
#include <CGAL/Seamless_snapping/internal/exact/rounded_to.h>

#include <limits>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The number of the format, that of float or double, nearest to `x`.
inline double rounded_to(const Number_format& format, const double x)
{
  return format.digits == std::numeric_limits<float>::digits ? rounded_to<float>(x) : x;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_EXACT_ROUNDED_TO_FORMAT_H
