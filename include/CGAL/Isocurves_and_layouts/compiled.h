// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_COMPILED_H
#define CGAL_ISOCURVES_AND_LAYOUTS_COMPILED_H

#include <CGAL/license/Isocurves_and_layouts.h>

// All that does not depend on the caller's types, for the one source of a program that compiles it.

#include <CGAL/Isocurves_and_layouts/internal/layout/Refined_faces_impl.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout_impl.h>
#include <CGAL/Seamless_snapping/compiled.h>

/*!
  \file CGAL/Isocurves_and_layouts/compiled.h
  \ingroup PkgIsocurvesAndLayoutsRef

  compiles what does not depend on the types of meshes and coordinates: most of this package, and of
  those that it needs.

  It is not needed: each source that calls a function of this package compiles for itself what this
  function needs. In a program where that takes too long, link the CMake target
  `Seamless_snapping::compiled`. Without CMake, define the macro `CGAL_SEAMLESS_SNAPPING_COMPILED`
  for all sources, and include this header in one of them. The linker misses functions where no
  source, or more than one, does so.

  \sa \ref SSnappingCompiling
*/

#endif // CGAL_ISOCURVES_AND_LAYOUTS_COMPILED_H
