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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SEPARATE_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SEPARATE_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// Where the solver is compiled: in each source that calls it, or in the one that includes
// `instantiate_solver.h`. What belongs to it, and is not a template, is declared in one header and
// defined in another one, whose name ends in `_impl.h`.

#ifdef CGAL_SEAMLESS_SNAPPING_SEPARATE_SOLVER
#define CGAL_SEAMLESS_SNAPPING_SOLVER_FUNCTION
#else
#define CGAL_SEAMLESS_SNAPPING_SOLVER_FUNCTION inline
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SEPARATE_SOLVER_H
