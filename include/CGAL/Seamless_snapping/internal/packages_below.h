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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PACKAGES_BELOW_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PACKAGES_BELOW_H

#include <CGAL/license/Seamless_snapping.h>

// The names of the package below are also names of this package.

#include <CGAL/Linear_snapping/types/parameters.h>

namespace CGAL {
namespace Seamless_snapping {

using namespace Linear_snapping;

namespace internal {

using namespace Linear_snapping::internal;

} // namespace internal

namespace parameters {

using namespace Linear_snapping::parameters;

} // namespace parameters
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PACKAGES_BELOW_H
