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

// A parametrized mesh in plain arrays: what the tracer walks on. It doesn't depend on the mesh data
// structure, and any number of threads can read it.

#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>
#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>
#include <CGAL/Seamless_snapping/internal/tracing/axis_directions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Halfedges with a face: 3 f, 3 f + 1, 3 f + 2 are those of face f, in turn.
using Corner_index = std::int32_t;
using Chart_vertex_index = std::int32_t;
constexpr std::int32_t no_index = -1;

struct Chart_corner
{
  Uv uv;                                // of the target of the halfedge
  Corner_index opposite = no_index;     // no_index: the other side is the border
  std::int32_t transition = no_index;   // no_index: the same coordinates on both sides
  Chart_vertex_index vertex = no_index; // the target
};

// u' = R u + t, from the face of a halfedge to the opposite one. The translation is that of the
// source of the halfedge, exactly; in an exactly seamless map it is also that of the target.
struct Chart_transition
{
  int rotation;
  std::array<Exact_difference, 2> translation;
};

struct Chart_mesh
{
  std::vector<Chart_corner> corners;
  std::vector<Chart_transition> transitions;
  std::vector<Corner_index> corner_at_vertex; // one that points to it; no_index if it is isolated
  std::vector<char> is_border;                // per vertex
  std::vector<char> is_singular;              // per vertex
  double extent = 0;
  double violation = 0;
  bool is_exact = true;

  static Corner_index next(const Corner_index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Corner_index prev(const Corner_index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  const Chart_corner& corner(const Corner_index h) const { return corners[std::size_t(h)]; }
  const Uv& uv(const Corner_index h) const { return corner(h).uv; }
  Corner_index opposite(const Corner_index h) const { return corner(h).opposite; }
  std::size_t vertex(const Corner_index h) const { return std::size_t(corner(h).vertex); }

  int rotation(const Corner_index h) const
  {
    const std::int32_t t = corner(h).transition;
    return t == no_index ? 0 : transitions[std::size_t(t)].rotation;
  }

  // One number for both halfedges of an edge.
  Corner_index edge_key(const Corner_index h) const
  {
    const Corner_index g = opposite(h);
    return (g == no_index || h < g) ? h : g;
  }

  // The next corners around the same vertex, or no_index at the border.
  Corner_index counterclockwise(const Corner_index h) const
  {
    const Corner_index g = opposite(h);
    return g == no_index ? no_index : prev(g);
  }
  Corner_index clockwise(const Corner_index h) const { return opposite(next(h)); }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_CHART_MESH_H
