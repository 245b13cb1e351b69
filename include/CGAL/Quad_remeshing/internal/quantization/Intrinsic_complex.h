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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTRINSIC_COMPLEX_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTRINSIC_COMPLEX_H

#include <CGAL/license/Quad_remeshing.h>

// A triangulation of a parametrized surface that need not be a mesh: edges may be loops, and two
// vertices may have several edges. It keeps no coordinates but the vectors along its edges, in two
// sizes: exactly as in the map, and in units of quads.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Intrinsic_corner : Integer_corner
{
  Grid_vector units{};            // the vector in quads; 0 as long as it is not known
  Direction_at_corner departure;  // where the halfedge leaves its source, on the input
};

// Invariant: as for Integer_mesh, for the vectors and, once these are known, for the units. Faces
// whose corners have no vertex are not there any more, nor are vertices without a corner.
struct Intrinsic_complex : Flat_mesh<Intrinsic_corner>
{
  std::vector<char> is_regular;    // per vertex: 360 degrees, or 180 degrees on the border
  std::vector<std::int32_t> part;  // per face: the connected part of the surface

  bool has_face(const Flat_face_index f) const { return corner(3 * f).vertex != no_index; }
};

using Edge_vector = Grid_vector Intrinsic_corner::*; // `vector` or `units`

// The angle at a corner, in axes passed: these add up to the quarter turns around a vertex.
template <typename Corner, typename Vector>
int axes_at_corner(const Flat_mesh<Corner>& mesh, const Corner_index h, const Vector vector)
{
  return axes_between(mesh.corner(Flat_mesh<Corner>::next(h)).*vector,
                      negated(mesh.corner(h).*vector));
}

template <typename Corner, typename Vector>
int axes_around_vertex(const Flat_mesh<Corner>& mesh, const std::size_t v, const Vector vector)
{
  int sum = 0;
  for_each_corner(mesh, v, [&](const Corner_index h) { sum += axes_at_corner(mesh, h, vector); });
  return sum;
}

using Linear_snapping::internal::orientation; // and of faces:

inline int orientation(const Intrinsic_complex& complex, const Flat_face_index f,
                       const Edge_vector vector)
{
  return cross_sign(complex.corner(3 * f).*vector, complex.corner(3 * f + 1).*vector);
}

// The complex with the faces of the mesh.
inline Intrinsic_complex make_complex(const Integer_mesh& mesh)
{
  Intrinsic_complex result;
  result.corner_at_vertex = mesh.corner_at_vertex;
  result.is_border = mesh.is_border;
  result.part = mesh.part;
  result.corners.resize(mesh.corners.size());
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h) {
    Intrinsic_corner& corner = result.corners[std::size_t(h)];
    static_cast<Integer_corner&>(corner) = mesh.corner(h);
    corner.departure.corner = Integer_mesh::prev(h);
  }
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    result.is_regular.push_back(axes_around_vertex(mesh, v, &Integer_corner::vector) ==
                                (mesh.is_border[v] ? 2 : 4));
  return result;
}

// The defect of a halfedge in words, or nothing.
inline std::string defect(const Intrinsic_complex& complex, const Corner_index h,
                          const Edge_vector vector)
{
  const Intrinsic_corner& corner = complex.corner(h);
  const Corner_index n = Intrinsic_complex::next(h), p = Intrinsic_complex::prev(h);
  const Grid_vector& a = corner.*vector;
  if(h % 3 == 0 &&
     sum(sum(a, complex.corner(n).*vector), complex.corner(p).*vector) != Grid_vector{0, 0})
    return "an open triangle";
  if(h % 3 == 0 && orientation(complex, h / 3, vector) <= 0)
    return "a triangle that is not positive";
  if(corner.is_wall && a[0] != 0 && a[1] != 0)
    return "a wall that has left its isocurve";
  if(corner.opposite == no_index)
    return corner.is_wall ? "" : "a border edge that is no wall";
  const Intrinsic_corner& opposite = complex.corner(corner.opposite);
  if(opposite.opposite != h || opposite.is_wall != corner.is_wall ||
     std::size_t(opposite.vertex) != complex.source(h) ||
     std::size_t(corner.vertex) != complex.source(corner.opposite))
    return "an edge of two sides that don't belong together";
  if(opposite.rotation != Quarter_turns::inverse(corner.rotation) ||
     rotated(corner.rotation, a) != negated(opposite.*vector))
    return "an edge of two sides that don't match";
  return "";
}

// The defect of the complex in words, or nothing. `angles` are the angles around the vertices, in
// quarter turns.
inline std::string defect(const Intrinsic_complex& complex, const std::vector<int>& angles,
                          const Edge_vector vector)
{
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
    if(!complex.has_face(h / 3))
      continue;
    const std::string found = defect(complex, h, vector);
    if(!found.empty())
      return found;
  }
  for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    if(complex.corner_at_vertex[v] != no_index) {
      if(complex.vertex(complex.corner_at_vertex[v]) != v)
        return "a vertex with the corner of another";
      if(axes_around_vertex(complex, v, vector) != angles[v])
        return "a vertex with another angle";
    }
  return "";
}

inline Uv to_uv(const Grid_vector& v)
{
  return {static_cast<double>(v[0]), static_cast<double>(v[1])};
}

// The complex in units as a mesh with charts: each triangle has one of its own, with one vertex at
// the origin. So quads are extracted from it as from any integer-grid map.
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

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTRINSIC_COMPLEX_H
