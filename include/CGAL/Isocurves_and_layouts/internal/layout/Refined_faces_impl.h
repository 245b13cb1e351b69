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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_IMPL_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_IMPL_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Everything that is refined is refined by the constructor.

#include <CGAL/Isocurves_and_layouts/internal/layout/Refined_faces.h>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Refined_faces::Refined_faces(const Chart_mesh& mesh, const Curve_set& curves,
                             const Layout& layout)
  : m_mesh(mesh), m_curves(curves), m_layout(layout), m_on_edges(add_points())
{
  mark_inner_points();
  add_edges();
  for(Flat_face_index f = 0; f < mesh.number_of_faces(); ++f)
    cut_face(f);
  link_border();
  m_is_covered = spread_patches();
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_REFINED_FACES_IMPL_H
