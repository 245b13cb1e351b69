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

#ifndef CGAL_LINEAR_SNAPPING_COMPILED_H
#define CGAL_LINEAR_SNAPPING_COMPILED_H

#include <CGAL/license/Linear_snapping.h>

// All that does not depend on the caller's types, for the one source of a program that compiles it.

#include <CGAL/Linear_snapping/internal/linear/Linear_solver_impl.h>
#include <CGAL/Linear_snapping/internal/linear/snap_values_impl.h>

/*!
  \file CGAL/Linear_snapping/compiled.h
  \ingroup PkgLinearSnappingRef

  compiles what does not depend on the types of meshes and coordinates: most of this package.

  It is not needed: each source that calls a function of this package compiles for itself what this
  function needs. In a program where that takes too long, link the CMake target
  `Seamless_snapping::compiled`. Without CMake, define the macro `CGAL_SEAMLESS_SNAPPING_COMPILED`
  for all sources, and include this header in one of them. The linker misses functions where no
  source, or more than one, does so.

  \sa \ref LSnappingCompiling
*/

#endif // CGAL_LINEAR_SNAPPING_COMPILED_H
