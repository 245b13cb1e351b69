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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_PACKAGES_BELOW_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_PACKAGES_BELOW_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The names of the package below are also names of this package.

#include <CGAL/Seamless_snapping/internal/packages_below.h>

namespace CGAL {
namespace Seamless_snapping {

namespace IO { }

} // namespace Seamless_snapping

namespace Isocurves_and_layouts {

using namespace Seamless_snapping;

namespace internal {

using namespace Seamless_snapping::internal;

} // namespace internal

namespace parameters {

using namespace Seamless_snapping::parameters;

} // namespace parameters

namespace IO {

using namespace Seamless_snapping::IO;

} // namespace IO
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_PACKAGES_BELOW_H
