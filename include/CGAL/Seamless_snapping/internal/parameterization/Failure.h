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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FAILURE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FAILURE_H

#include <CGAL/license/Seamless_snapping.h>

// How the steps of a parametrization fail: each throws, and the public function catches. Nothing
// has been written to the caller's map by then.

#include <CGAL/Seamless_snapping/Parameterization_report.h>

#include <string>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

struct Failure
{
  Parameterization_status status;
  std::string message;
};

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FAILURE_H
