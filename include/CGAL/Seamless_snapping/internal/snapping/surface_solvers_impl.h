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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// The definitions for surface_solvers.h. Only one source includes this file: the compiler then
// makes the templates for all other sources there.

#include <CGAL/Seamless_snapping/internal/snapping/surface_solvers.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INSTANTIATE_SURFACE_SOLVERS()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SOLVERS_IMPL_H
