// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_PACKAGES_BELOW_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_PACKAGES_BELOW_H

#include <CGAL/license/Hexahedral_meshing.h>

// The names of the packages below are also names of this package.

#include <CGAL/Seamless_snapping/internal/packages_below.h>

namespace CGAL {

namespace Seamless_snapping {
namespace IO { } // if no file is read
} // namespace Seamless_snapping

namespace Hexahedral_meshing {

using namespace Seamless_snapping;

namespace IO {

using namespace Seamless_snapping::IO;

} // namespace IO

namespace internal {

using namespace Seamless_snapping::internal;

} // namespace internal

namespace parameters {

using namespace Seamless_snapping::parameters;

} // namespace parameters
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_PACKAGES_BELOW_H
