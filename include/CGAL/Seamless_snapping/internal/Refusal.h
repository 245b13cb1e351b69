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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H

#include <CGAL/license/Seamless_snapping.h>

// Why a function can't do what it is asked for.

#include <CGAL/Seamless_snapping/Snapping_report.h>

#include <CGAL/Exact_integer.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Refusal
{
  Snapping_status status;
  std::string message;
  std::vector<std::pair<std::size_t, CGAL::Exact_integer> > certificate; // see `Snapping_report`
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H
