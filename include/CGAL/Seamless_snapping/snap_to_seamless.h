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

#ifndef CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// The surface function: makes an approximately seamless parametrization exactly seamless.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/surface/Surface_snapper.h>
#include <CGAL/Seamless_snapping/parameters.h>

#include <CGAL/FPU.h>
#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {

template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report snap_to_seamless(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  // Callers may sit inside interval arithmetic; splitting numbers exactly needs rounding to nearest.
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  using Parameters = std::decay_t<decltype(internal::strip(np))>;
  return internal::Surface_snapper<TriangleMesh, HalfedgeUVMap, Parameters>(
           tmesh, uv_map, internal::strip(np)).run();
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_SNAP_TO_SEAMLESS_H
