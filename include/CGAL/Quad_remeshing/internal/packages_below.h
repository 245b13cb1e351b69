// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PACKAGES_BELOW_H
#define CGAL_QUAD_REMESHING_INTERNAL_PACKAGES_BELOW_H

#include <CGAL/license/Quad_remeshing.h>

// The names of the package below are also names of this package.

#include <CGAL/Isocurves_and_layouts/internal/packages_below.h>

namespace CGAL {
namespace Quad_remeshing {

using namespace Isocurves_and_layouts;

namespace internal {

using namespace Isocurves_and_layouts::internal;

} // namespace internal

namespace parameters {

using namespace Isocurves_and_layouts::parameters;

} // namespace parameters
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PACKAGES_BELOW_H
