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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_H

#include <CGAL/license/Seamless_snapping.h>

// A map that is not seamless for the symmetry that it is read with may well be for another one, or
// in other coordinates. This finds out which, for the message of a refusal. Floating point is used
// throughout.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A sentence that names the symmetry of least order that all edges have up to the tolerance; empty
// if there is none.
// \param edges all edges that the given order does not explain
// \param tolerance a distance
// \param N the given order
Message hint_on_symmetry(const std::vector<Edge_sides>& edges, double tolerance, int N);

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/mesh/hint_on_symmetry_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_H
