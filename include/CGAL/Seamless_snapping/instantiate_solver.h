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

#ifndef CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// Compiles the solver, for programs in which only one source shall do that.

#include <CGAL/Seamless_snapping/internal/complex/Free_unknowns_impl.h>
#include <CGAL/Seamless_snapping/internal/layout/Refined_faces_impl.h>
#include <CGAL/Seamless_snapping/internal/layout/make_layout_impl.h>
#include <CGAL/Seamless_snapping/internal/linear/Linear_solver_impl.h>
#include <CGAL/Seamless_snapping/internal/linear/snap_values_impl.h>
#include <CGAL/Seamless_snapping/internal/quantization/quantize_surface_impl.h>
#include <CGAL/Seamless_snapping/internal/separate_complex_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/volume_snappers_impl.h>

/*!
  \file CGAL/Seamless_snapping/instantiate_solver.h
  \ingroup PkgSeamlessSnappingRef

  compiles the solver, which knows neither the mesh nor the type of its coordinates.

  It is not needed: each source that calls a function of this package compiles the solver for
  itself. In a program where that takes too long, define the macro
  `CGAL_SEAMLESS_SNAPPING_SEPARATE_SOLVER` for all sources, and include this header in one of them.
  The linker misses functions where no source, or more than one, does so.

  \sa \ref SSnappingCompiling
*/

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX_SOLVER()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SOLVER_H
