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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COMPILED_ONCE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COMPILED_ONCE_H

#include <CGAL/license/Linear_snapping.h>

// Code that does not depend on the caller's types is compiled in each source that calls it or, if
// the macro is defined, only in sources that include its definition. Functions that are no
// templates are declared in one header and defined in another one, whose name ends in `_impl.h`.

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
#define CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
#else
#define CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION inline
#endif

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_COMPILED_ONCE_H
