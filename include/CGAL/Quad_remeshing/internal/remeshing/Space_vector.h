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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SPACE_VECTOR_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SPACE_VECTOR_H

#include <CGAL/license/Quad_remeshing.h>

// Points and vectors in space, in floating point.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Space_vector = std::array<double, 3>;

using Space_segment = std::array<Space_vector, 2>;
using Space_triangle = std::array<Space_vector, 3>;

inline Space_vector to_vector(const Remeshing_types::Point& p) { return {p.x(), p.y(), p.z()}; }
inline Remeshing_types::Point to_point(const Space_vector& p) { return {p[0], p[1], p[2]}; }

// \pre the face is a triangle
inline Space_triangle triangle_of(const Remeshing_types::Mesh& mesh, const Remeshing_types::Face f)
{
  const auto h = mesh.halfedge(f);
  return {to_vector(mesh.point(mesh.source(h))), to_vector(mesh.point(mesh.target(h))),
          to_vector(mesh.point(mesh.target(mesh.next(h))))};
}

inline Space_vector between(const Space_vector& a, const Space_vector& b, const double part)
{
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}
inline double norm(const Space_vector& a) { return std::hypot(a[0], a[1], a[2]); }

inline Space_vector scaled_to_one(const Space_vector& a)
{
  const double n = norm(a);
  return n > 0 ? Space_vector{a[0] / n, a[1] / n, a[2] / n} : Space_vector{};
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SPACE_VECTOR_H
