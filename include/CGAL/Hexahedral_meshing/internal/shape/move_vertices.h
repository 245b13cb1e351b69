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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_H

#include <CGAL/license/Hexahedral_meshing.h>

// Moves of vertices that make hexahedra positive.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>

#include <cstddef>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// At most so many rounds over the vertices near hexahedra that are not positive. Vertices of
// patches and curves stay there.
// \pre features are kept
void move_vertices(Extraction& extraction, std::size_t number_of_rounds);

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Hexahedral_meshing/internal/shape/move_vertices_impl.h>
#endif

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_H
