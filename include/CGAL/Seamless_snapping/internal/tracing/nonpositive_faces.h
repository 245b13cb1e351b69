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
#include <string>
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

// How many there are, and the first, in words. `what` they are, such as "flipped".
inline std::string name_of_faces(const std::vector<std::size_t>& faces, const std::string& what)
{
  return std::to_string(faces.size()) + (faces.size() == 1 ? " face is " : " faces are ") + what +
         ", the first is face " + std::to_string(faces.front());
}

// Why no isocurve can be followed.
inline std::string refusal_of_faces(const std::vector<std::size_t>& nonpositive)
{ return name_of_faces(nonpositive, "flipped or degenerate in the domain"); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_NONPOSITIVE_FACES_H
