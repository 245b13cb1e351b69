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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H

#include <CGAL/license/Seamless_snapping.h>

#include <CGAL/Seamless_snapping/internal/linear/nonnegative_program.h>

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_NONNEGATIVE_PROGRAM_H
