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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_PLACE_ON_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_PLACE_ON_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// Where the points of the grid lie in their faces.

#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Weights = std::array<double, 3>; // of the corners 3 f, 3 f + 1, 3 f + 2

struct Surface_location
{
  std::size_t face = 0; // of the input
  Weights weights{};
};

// Twice the area of a positive triangle, with a small relative error.
inline double area_near(const Uv& a, const Uv& b, const Uv& c)
{
  const double first = (b[0] - a[0]) * (c[1] - a[1]), second = (b[1] - a[1]) * (c[0] - a[0]);
  const double area = first - second;
  if(area > 1e-6 * (std::abs(first) + std::abs(second)))
    return area;
  const auto u = exact(a), v = exact(b), w = exact(c);
  return CGAL::to_double(cross_product({Exact_rational(v[0] - u[0]), Exact_rational(v[1] - u[1])},
                                       {Exact_rational(w[0] - u[0]), Exact_rational(w[1] - u[1])}));
}

template <typename Group>
Weights weights(const Basic_chart_mesh<Group>& mesh, const Lattice_point& p)
{
  Weights result{};
  const std::size_t corner = std::size_t(p.corner % 3);
  switch(p.place) {
  case Lattice_place::VERTEX:
    result[corner] = 1;
    return result;
  case Lattice_place::EDGE: {
    const Uv &a = mesh.uv(mesh.prev(p.corner)), &b = mesh.uv(p.corner);
    const std::size_t c = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
    result[corner] = (p.uv[c] - a[c]) / (b[c] - a[c]);
    result[(corner + 2) % 3] = (b[c] - p.uv[c]) / (b[c] - a[c]);
    return result;
  }
  case Lattice_place::FACE:
    break;
  }
  const Uv_triangle t = triangle(mesh, face_of(p.corner));
  double sum = 0;
  for(std::size_t k = 0; k < 3; ++k)
    sum += result[k] = area_near(p.uv, t[(k + 1) % 3], t[(k + 2) % 3]);
  for(double& w : result)
    w /= sum;
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_PLACE_ON_SURFACE_H
