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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H

#include <CGAL/license/Quad_remeshing.h>

// The coarse complex: as few vertices as possible, and round triangles.

#include <CGAL/Quad_remeshing/internal/quantization/flip.h>
#include <CGAL/Quad_remeshing/internal/quantization/remove_vertices.h>

#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// One flip for each edge at the vertices that are still to be removed: their loops become other
// edges.
inline void flip_loops(const Integer_mesh& input, Intrinsic_complex& complex)
{
  Polygon_filler filler(input, complex);
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.has_face(h / 3) && complex.vertex(h) == complex.source(h) &&
       complex.is_regular[complex.vertex(h)] &&
       is_flippable(complex, h, &Intrinsic_corner::vector))
      flip(h, complex, filler);
}

inline void coarsen(const Integer_mesh& input, Intrinsic_complex& complex)
{
  remove_vertices(input, complex);
  do {
    make_delaunay(input, complex);
    flip_loops(input, complex);
  } while(remove_vertices(input, complex) > 0);
  make_delaunay(input, complex);
}

inline Intrinsic_complex make_coarse_complex(const Integer_mesh& input)
{
  Intrinsic_complex complex = make_complex(input);
  coarsen(input, complex);
  return compacted(complex);
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H
