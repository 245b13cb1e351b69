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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_VERTEX_FAR_AWAY_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_VERTEX_FAR_AWAY_H

#include <CGAL/license/Quad_remeshing.h>

// Few vertices that lie far from all others, as mistakes do: their triangles would be nearly all
// of the area, and get nearly all of the quads.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Distances from the middle one of all vertices, by each coordinate.
// \pre points are finite
inline std::vector<double> distances_from_median(const Remeshing_types::Mesh& mesh)
{
  const std::size_t n = mesh.number_of_vertices();
  std::array<double, 3> median;
  std::vector<double> values(n);
  for(int c = 0; c < 3; ++c) {
    std::transform(mesh.points().begin(), mesh.points().end(), values.begin(),
                   [c](const auto& p) { return p[c]; });
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(n / 2), values.end());
    median[std::size_t(c)] = values[n / 2];
  }
  std::transform(mesh.points().begin(), mesh.points().end(), values.begin(), [&](const auto& p)
    { return std::hypot(p.x() - median[0], p.y() - median[1], p.z() - median[2]); });
  return values;
}

// A halfedge of a face from a vertex that is a million times as far away as nearly all others, of
// which one is its neighbor. A surface whose triangles become larger and larger has no such gap.
inline std::optional<Remeshing_types::Halfedge>
halfedge_from_far_away(const Remeshing_types::Mesh& mesh)
{
  constexpr double many_times = 1e6; // times as far away as other vertices
  constexpr std::size_t part = 100; // one of so many vertices; more are no mistake
  if(mesh.number_of_vertices() == 0 || !has_finite_points(mesh)) // refused later
    return std::nullopt;
  const std::vector<double> distances = distances_from_median(mesh);
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  double farthest = std::numeric_limits<double>::infinity(); // of the vertices that are near
  for(std::size_t i = n - (std::min)(n, 1 + (std::max)(n / part, std::size_t(1))); i + 1 < n; ++i)
    if(sorted[i] > 0 && sorted[i + 1] / many_times > sorted[i]) {
      farthest = sorted[i];
      break;
    }
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h) && distances[std::size_t(mesh.source(h))] > farthest &&
       !(distances[std::size_t(mesh.target(h))] > farthest))
      return h;
  return std::nullopt;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_VERTEX_FAR_AWAY_H
