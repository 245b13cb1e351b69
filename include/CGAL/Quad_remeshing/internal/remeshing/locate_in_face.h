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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LOCATE_IN_FACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LOCATE_IN_FACE_H

#include <CGAL/license/Quad_remeshing.h>

// Where a point lies in a triangle near by.

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Barycentric coordinates of the projection to the plane of the triangle, cut off at 0. In a
// triangle without area, those on its longest side.
inline std::array<double, 3> barycentric_coordinates(
  const std::array<std::array<double, 3>, 3>& triangle, const std::array<double, 3>& point)
{
  std::array<double, 3> result{};
  const auto dot = [&](const std::size_t i, const std::size_t j, const std::array<double, 3>& p) {
    double sum = 0; // side from i to j, and from i to p
    for(std::size_t c = 0; c < 3; ++c)
      sum += (triangle[j][c] - triangle[i][c]) * (p[c] - triangle[i][c]);
    return sum;
  };
  const double a = dot(0, 1, triangle[1]), b = dot(0, 1, triangle[2]), c = dot(0, 2, triangle[2]);
  const double d = dot(0, 1, point), e = dot(0, 2, point);
  const double det = a * c - b * b;
  if(det > 1e-14 * a * c) {
    result[1] = (std::max)(0., (c * d - b * e) / det);
    result[2] = (std::max)(0., (a * e - b * d) / det);
    result[0] = (std::max)(0., 1 - result[1] - result[2]);
  } else {
    std::size_t i = 0, j = 1;
    for(const auto& [k, l] : {std::pair<std::size_t, std::size_t>(1, 2), {2, 0}})
      if(dot(k, l, triangle[l]) > dot(i, j, triangle[j])) {
        i = k;
        j = l;
      }
    const double length = dot(i, j, triangle[j]);
    result[j] = length > 0 ? (std::min)((std::max)(dot(i, j, point) / length, 0.), 1.) : 0;
    result[i] = 1 - result[j];
  }
  const double sum = result[0] + result[1] + result[2];
  for(double& x : result)
    x /= sum;
  return result;
}

// In the order of `CGAL::Polygon_mesh_processing::Face_location`.
template <typename TriangleMesh, typename VertexPointMap, typename Point>
std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3> >
locate_in_face(const Point& point,
               const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
               const TriangleMesh& tmesh, const VertexPointMap& point_map)
{
  const auto coordinates = [](const auto& p) {
    return std::array<double, 3>{CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                 CGAL::to_double(p.z())};
  };
  const auto h = halfedge(f, tmesh);
  return {f, barycentric_coordinates({coordinates(get(point_map, source(h, tmesh))),
                                      coordinates(get(point_map, target(h, tmesh))),
                                      coordinates(get(point_map, target(next(h, tmesh), tmesh)))},
                                     coordinates(point))};
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LOCATE_IN_FACE_H
