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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MAKE_CHART_MESH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MAKE_CHART_MESH_H

#include <CGAL/license/Quad_remeshing.h>

// A complex in units as a mesh with charts: each triangle has one of its own, with one vertex at
// the origin. So quads are extracted from it as from any integer-grid map.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline Uv to_uv(const Grid_vector& v)
{
  return {static_cast<double>(v[0]), static_cast<double>(v[1])};
}

// \pre the complex is compact, and its units are below 2^46
inline Chart_mesh make_chart_mesh(const Intrinsic_complex& complex)
{
  Chart_mesh mesh;
  mesh.corner_at_vertex = complex.corner_at_vertex;
  mesh.is_border = complex.is_border;
  mesh.corners.resize(complex.corners.size());
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
    Chart_corner& corner = mesh.corners[std::size_t(h)];
    static_cast<Flat_corner&>(corner) = complex.corner(h);
    corner.transition = no_index;
    const Grid_vector& first = complex.corner(3 * (h / 3)).units;
    if(h % 3 == 2)
      corner.uv = {0, 0};
    else
      corner.uv = to_uv(h % 3 == 0 ? first : sum(first, complex.corner(h).units));
    mesh.extent = (std::max)({mesh.extent, std::abs(corner.uv[0]), std::abs(corner.uv[1])});
  }
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!mesh.is_border_edge(h))
      add_transition(mesh, h, complex.corner(h).rotation);
  mark_singular_vertices<CGAL::Sequential_tag>(mesh);
  return mesh;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_MAKE_CHART_MESH_H
