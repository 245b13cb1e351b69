// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_NONPOSITIVE_FACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_NONPOSITIVE_FACES_H

#include <CGAL/license/Seamless_snapping.h>

// The faces that are flipped or degenerate in the domain: no isocurve can be followed through them.

#include <CGAL/Seamless_snapping/internal/exact/orientation.h>
#include <CGAL/Seamless_snapping/internal/tracing/Chart_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
Uv_triangle triangle(const Basic_chart_mesh<Group>& mesh, const std::size_t face)
{
  const Corner_index h = Corner_index(3 * face);
  return {mesh.uv(h), mesh.uv(h + 1), mesh.uv(h + 2)};
}

// In order.
template <typename Group>
std::vector<std::size_t> nonpositive_faces(const Basic_chart_mesh<Group>& mesh)
{
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < mesh.corners.size() / 3; ++f)
    if(orientation(triangle(mesh, f)) != CGAL::POSITIVE)
      result.push_back(f);
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_NONPOSITIVE_FACES_H
