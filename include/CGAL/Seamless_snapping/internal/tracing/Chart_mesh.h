// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_CHART_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_CHART_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// A parametrized mesh in plain arrays: what isocurves are traced on.

#include <CGAL/Seamless_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Chart_corner : Flat_corner
{
  Uv uv;                              // of the target of the halfedge
  std::int32_t transition = no_index; // no_index: the same coordinates on both sides
};

// u' = R u + t, from the face of a halfedge to the opposite one. The translation is that of the
// source of the halfedge, exactly; in an exactly seamless map it is also that of the target.
struct Chart_transition
{
  Quarter_turns::Element rotation;
  std::array<Exact_difference, 2> translation;
};

// Invariant: an interior halfedge has a transition if and only if its two sides have different
// coordinates or charts.
struct Chart_mesh : Flat_mesh<Chart_corner>
{
  std::vector<Chart_transition> transitions;
  std::vector<char> is_singular; // per vertex
  double extent = 0;             // the larger side of the bounding box of the coordinates
  double violation = 0;          // the largest one of a transition
  bool is_exact = true;          // all transitions hold exactly

  const Uv& uv(const Corner_index h) const { return corner(h).uv; }

  Quarter_turns::Element rotation(const Corner_index h) const
  {
    const std::int32_t t = corner(h).transition;
    return t == no_index ? Quarter_turns::identity() : transitions[std::size_t(t)].rotation;
  }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_CHART_MESH_H
