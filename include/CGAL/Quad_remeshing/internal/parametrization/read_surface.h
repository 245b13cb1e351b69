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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// From the points of a mesh to a Triangle_surface, with refusals; and the crosses that the caller
// prescribes, by one direction in space for each face.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Refuses what is no manifold.
inline void check_connectivity(const Triangle_surface& surface)
{
  if(const auto refusal = find_several_fans(surface))
    throw *refusal;
  if(surface.corners.empty())
    throw Refusal(Outcome::INVALID_ARGUMENT,
                  "the mesh has no face; was it read?");
}

inline void find_components(Triangle_surface& surface)
{
  const std::vector<std::int32_t> parts =
    connected_parts(std::size_t(surface.number_of_faces()),
                    [&](const Corner_index h) { return surface.opposite(h); });
  surface.component.assign(parts.begin(), parts.end());
  surface.number_of_components = 1 + *std::max_element(surface.component.begin(),
                                                       surface.component.end());
}

using Point = Place;

// Signed dihedral angles: what the intrinsic layout does not know, for alignment to curvature.
inline void measure_bending(Triangle_surface& surface, const std::vector<Point>& points)
{
  using S = Triangle_surface;
  const auto normal = [&](const Corner_index h)
  {
    const Point& p = points[surface.source(h)];
    return vector_product(vector_to(p, points[surface.vertex(h)]),
                          vector_to(p, points[surface.vertex(S::next(h))]));
  };
  surface.bending.assign(surface.number_of_halfedges(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    const Point n = normal(h), m = normal(surface.opposite(h));
    const Point e = vector_to(points[surface.source(h)], points[surface.vertex(h)]);
    const double length = std::sqrt(inner_product(e, e));
    if(length > 0)
      surface.bending[h] =
        std::atan2(inner_product(vector_product(n, m), e) / length, inner_product(n, m));
  }
}

// \param points of the vertices
inline void read_geometry(std::vector<Point> points, Triangle_surface& surface)
{
  double size = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    for(const double x : points[v]) {
      if(!std::isfinite(x))
        throw Refusal(Outcome::NOT_FINITE,
                      surface.describe_vertex(v) + " has a NaN or infinite coordinate");
      size = (std::max)(size, std::abs(x));
    }
  surface.exponent = (size > 0) ? std::ilogb(size) : 0;
  for(Point& p : points)
    for(double& x : p)
      x = std::ldexp(x, -surface.exponent);

  surface.length.resize(surface.number_of_halfedges());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Point e = vector_to(points[surface.source(h)], points[surface.vertex(h)]);
    surface.length[h] = std::sqrt(inner_product(e, e));
  }
  measure_bending(surface, points);
  mollify_lengths(surface);
  lay_out_faces(surface);
}

// 0 where the direction has no part in the plane of its face that is more than rounding, or the
// face has no area.
inline Complex cross_of_direction(const Point& direction, const Point& first_edge,
                                  const Point& second_edge)
{
  const Point e = scaled_to_unit_size(first_edge), d = scaled_to_unit_size(direction);
  const Point n = scaled_to_unit_size(vector_product(e, scaled_to_unit_size(second_edge)));
  const double length = std::sqrt(inner_product(n, n));
  const double along = inner_product(e, d) * length;
  const double across = inner_product(vector_product(e, d), n);
  constexpr double least_part = 1e-6; // of the direction, in the plane of the face
  const bool is_normal =
    std::hypot(along, across) <= least_part * length * std::sqrt(inner_product(e, e)) *
                                   std::sqrt(inner_product(d, d));
  return is_normal ? Complex(0) : cross_of_angle(std::atan2(across, along));
}

// Empty where no face has a direction.
// \param points of the vertices
// \param directions of the faces
inline Prescribed_field read_directions(const Triangle_surface& surface,
                                        const std::vector<Point>& points,
                                        const std::vector<Point>& directions)
{
  Prescribed_field field;
  for(std::size_t f = 0; f < directions.size(); ++f) {
    for(const double x : directions[f])
      if(!std::isfinite(x))
        throw Refusal(Outcome::NOT_FINITE, "the direction of " + name_of_face(f) +
                                             " has a NaN or infinite coordinate");
    const auto corner = [&](const int i) -> const Point&
      { return points[surface.vertex(Corner_index(3 * f) + i)]; };
    field.push_back(
      cross_of_direction(directions[f], vector_to(corner(2), corner(0)),
                         vector_to(corner(0), corner(1))));
  }
  const bool has_none = std::all_of(field.begin(), field.end(),
                                    [](const Complex& z) { return z == Complex(0); });
  return has_none ? Prescribed_field() : field;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_SURFACE_H
