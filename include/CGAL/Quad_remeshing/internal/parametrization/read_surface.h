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

// Reads a mesh of any type into a Triangle_surface, and refuses what is not a triangulated
// manifold; and the crosses that the caller prescribes, by one direction in space for each face.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The connectivity of a mesh, whose indices are those of `numbering`.
template <typename TriangleMesh>
Triangle_surface read_connectivity(const TriangleMesh& tmesh,
                                   const Flat_numbering<TriangleMesh>& numbering)
{
  if(const auto& refusal = numbering.refusal())
    throw *refusal;
  Triangle_surface surface;
  read_flat_mesh<CGAL::Sequential_tag>(tmesh, numbering, surface,
                                       [](Flat_corner&, const auto&) { });
  if(const auto refusal = find_several_fans(surface))
    throw *refusal;
  if(surface.corners.empty())
    throw Refusal(Outcome::INVALID_ARGUMENT,
                  "the mesh has no face; was it read?");
  return surface;
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

using Point = std::array<double, 3>;

inline Point operator-(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline double dot(const Point& p, const Point& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Point cross(const Point& p, const Point& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// Signed dihedral angles: what the intrinsic layout does not know, for alignment to curvature.
inline void measure_bending(Triangle_surface& surface, const std::vector<Point>& points)
{
  using S = Triangle_surface;
  const auto normal = [&](const Corner_index h)
  {
    const Point& p = points[surface.source(h)];
    return cross(points[surface.vertex(h)] - p, points[surface.vertex(S::next(h))] - p);
  };
  surface.bending.assign(surface.number_of_halfedges(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    const Point n = normal(h), m = normal(surface.opposite(h));
    const Point e = points[surface.vertex(h)] - points[surface.source(h)];
    const double length = std::sqrt(dot(e, e));
    if(length > 0)
      surface.bending[h] = std::atan2(dot(cross(n, m), e) / length, dot(n, m));
  }
}

template <typename TriangleMesh, typename VertexPointMap>
void read_geometry(const Flat_numbering<TriangleMesh>& numbering,
                   const VertexPointMap vertex_points,
                   Triangle_surface& surface)
{
  std::vector<Point> points;
  double size = 0;
  for(std::size_t v = 0; v < numbering.vertices_in_order().size(); ++v) {
    const auto& p = get(vertex_points, numbering.vertices_in_order()[v]);
    points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    for(const double x : points.back()) {
      if(!std::isfinite(x))
        throw Refusal(Outcome::NOT_FINITE,
                      surface.describe_vertex(v) + " has a NaN or infinite coordinate");
      size = (std::max)(size, std::abs(x));
    }
  }
  surface.exponent = (size > 0) ? std::ilogb(size) : 0;
  for(Point& p : points)
    for(double& x : p)
      x = std::ldexp(x, -surface.exponent);

  surface.length.resize(surface.number_of_halfedges());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Point e = points[surface.vertex(h)] - points[surface.source(h)];
    surface.length[h] = std::sqrt(dot(e, e));
  }
  measure_bending(surface, points);
  mollify_lengths(surface);
  lay_out_faces(surface);
}

template <typename TriangleMesh, typename EdgeIsConstrainedMap>
void read_alignment(const TriangleMesh& tmesh,
                    const Flat_numbering<TriangleMesh>& numbering,
                    const EdgeIsConstrainedMap edge_is_constrained,
                    const bool align_border,
                    Triangle_surface& surface)
{
  surface.is_aligned.resize(surface.number_of_halfedges());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    surface.is_aligned[h] = get(edge_is_constrained,
                                edge(numbering.halfedges_of_corners()[h], tmesh))
                            || (align_border && surface.is_border_edge(h));
}

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

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_READ_SURFACE_H
