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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_DIRECTIONS_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_DIRECTIONS_H

#include <CGAL/license/Quad_remeshing.h>

// The crosses that the caller prescribes, by one direction in space for each face.

#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Quad_remeshing/internal/parametrization/read_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The vector times a power of two, with coordinates of at most 2.
inline Point near_one(Point vector)
{
  double size = 0;
  for(const double x : vector)
    size = (std::max)(size, std::abs(x));
  if(size > 0)
    for(double& x : vector)
      x = std::ldexp(x, -std::ilogb(size));
  return vector;
}

// 0 where the direction has no part in the plane of its face that is more than rounding, or the
// face has no area.
inline Complex cross_of_direction(const Point& direction, const Point& first_edge,
                                  const Point& second_edge)
{
  const Point e = near_one(first_edge), d = near_one(direction);
  const Point n = near_one(cross(e, near_one(second_edge)));
  const double length = std::sqrt(dot(n, n));
  const double along = dot(e, d) * length, across = dot(cross(e, d), n);
  constexpr double least_part = 1e-6; // of the direction
  const bool is_normal = std::hypot(along, across) <=
                         least_part * length * std::sqrt(dot(e, e)) * std::sqrt(dot(d, d));
  return is_normal ? Complex(0) : cross_of_angle(std::atan2(across, along));
}

// Empty where no face has a direction.
template <typename TriangleMesh, typename VertexPointMap, typename FaceDirectionMap>
Prescribed_field read_directions(const TriangleMesh& tmesh,
                                 const Flat_numbering<TriangleMesh>& numbering,
                                 const VertexPointMap vertex_points,
                                 const FaceDirectionMap face_direction)
{
  const auto coordinates = [](const auto& p) {
    return Point{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  };
  Prescribed_field field;
  const auto& halfedges = numbering.halfedges_of_corners();
  for(std::size_t h = 0; h < halfedges.size(); h += 3) {
    const Point direction = coordinates(get(face_direction, face(halfedges[h], tmesh)));
    for(const double x : direction)
      if(!std::isfinite(x))
        throw Refusal(Outcome::NOT_FINITE, "the direction of face " + std::to_string(h / 3) +
                                             " has a NaN or infinite coordinate");
    std::array<Point, 3> corners;
    for(std::size_t i = 0; i < 3; ++i)
      corners[i] = coordinates(get(vertex_points, target(halfedges[h + i], tmesh)));
    field.push_back(
      cross_of_direction(direction, corners[0] - corners[2], corners[1] - corners[0]));
  }
  const bool has_none = std::all_of(field.begin(), field.end(),
                                    [](const Complex& z) { return z == Complex(0); });
  return has_none ? Prescribed_field() : field;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_DIRECTIONS_H
