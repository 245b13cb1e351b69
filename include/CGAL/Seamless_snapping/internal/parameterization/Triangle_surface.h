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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_TRIANGLE_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_TRIANGLE_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// A triangle mesh as flat arrays: connectivity, and the intrinsic geometry (lengths, angles, one
// plane layout per face) that all steps of the parametrization work on. The steps know nothing of
// the mesh type of the caller.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

constexpr std::size_t no_index = static_cast<std::size_t>(-1);
constexpr double pi = 3.14159265358979323846;
constexpr double quarter_turn = pi / 2;

// Invariant: halfedge `3 f + i` is the i-th of face `f`, counterclockwise. As elsewhere in the
// package it stands for the corner of `f` at its target.
struct Triangle_surface
{
  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
  std::size_t number_of_components = 0;

  // per halfedge
  std::vector<std::size_t> target;
  std::vector<std::size_t> opposite; // `no_index` along the border
  std::vector<double> length;
  std::vector<double> angle;         // of the corner
  std::vector<double> direction;     // of the halfedge, in the plane layout of its face
  std::vector<double> bending;       // signed dihedral angle, positive if convex; 0 on the border
  std::vector<char> is_aligned;      // the edge is to lie on an isocurve (equal for both halfedges)

  // per face
  std::vector<double> area;
  std::vector<std::size_t> component;

  // per vertex: an incoming halfedge; along the border, that of the first face in
  // counterclockwise order
  std::vector<std::size_t> first_corner;
  std::vector<char> is_border;

  static std::size_t face(const std::size_t h) { return h / 3; }
  static std::size_t next(const std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::size_t prev(const std::size_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::size_t number_of_halfedges() const { return target.size(); }
  std::size_t source(const std::size_t h) const { return target[prev(h)]; }
  bool is_border_edge(const std::size_t h) const { return opposite[h] == no_index; }

  // One halfedge stands for each edge.
  bool represents_edge(const std::size_t h) const { return is_border_edge(h) || h < opposite[h]; }

  // The corner that follows counterclockwise at the same vertex, across `h`.
  std::size_t next_corner(const std::size_t h) const
  {
    return is_border_edge(h) ? no_index : prev(opposite[h]);
  }

  // The corner that precedes it, across the outgoing edge of the face.
  std::size_t previous_corner(const std::size_t h) const { return opposite[next(h)]; }

  // A direction at angle `a` in the layout of face(h) has the angle `a + transport(h)` in that of
  // the face across `h`: unfold the two faces along the edge.
  double transport(const std::size_t h) const
  {
    return direction[opposite[h]] + pi - direction[h];
  }
};

// Calls `function(corner)` for the corners of vertex `v` in counterclockwise order.
template <typename Function>
void for_each_corner(const Triangle_surface& surface, const std::size_t v, const Function& function)
{
  const std::size_t first = surface.first_corner[v];
  std::size_t h = first;
  do {
    function(h);
    h = surface.next_corner(h);
  } while(h != no_index && h != first);
}

// The curvature concentrated at each vertex: what the angles lack of 2 pi, or of pi on the border.
inline std::vector<double> angle_defects(const Triangle_surface& surface)
{
  std::vector<double> defect(surface.number_of_vertices);
  for(std::size_t v = 0; v < surface.number_of_vertices; ++v)
    defect[v] = surface.is_border[v] ? pi : 2 * pi;
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h)
    defect[surface.target[h]] -= surface.angle[h];
  return defect;
}

// Fills the arrays that follow from `length`: angles, areas and directions. The layout of a face
// has its first halfedge along the x-axis.
inline void lay_out_faces(Triangle_surface& surface)
{
  using S = Triangle_surface;
  surface.angle.resize(surface.number_of_halfedges());
  surface.direction.resize(surface.number_of_halfedges());
  surface.area.resize(surface.number_of_faces);
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    const double a = surface.length[h], b = surface.length[S::next(h)];
    const double c = surface.length[S::prev(h)];
    // Kahan's formula for half of the angle: stable for needles.
    const double numerator = (c + (a - b)) * (c - (a - b));
    const double denominator = (a + b + c) * (a + b - c);
    surface.angle[h] = 2 * std::atan2(std::sqrt((std::max)(numerator, 0.)),
                                      std::sqrt((std::max)(denominator, 0.)));
  }
  for(std::size_t f = 0; f < surface.number_of_faces; ++f) {
    const std::size_t h = 3 * f;
    surface.direction[h] = 0;
    surface.direction[h + 1] = pi - surface.angle[h];
    surface.direction[h + 2] = surface.direction[h + 1] + pi - surface.angle[h + 1];
    surface.area[f] = surface.length[h] * surface.length[h + 1] * std::sin(surface.angle[h]) / 2;
  }
}

// Lengthens all edges by the same small amount such that no triangle is degenerate. Only the
// lengths matter to the steps that follow, so that this lets them run on any mesh; it is zero for
// meshes without (nearly) degenerate faces.
inline void mollify_lengths(Triangle_surface& surface)
{
  using S = Triangle_surface;
  double mean = 0;
  for(const double l : surface.length)
    mean += l / static_cast<double>(surface.length.size());
  const double margin = 1e-6 * mean;
  double increase = 0;
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    const double slack = surface.length[h] + surface.length[S::next(h)]
                         - surface.length[S::prev(h)];
    increase = (std::max)(increase, margin - slack);
  }
  for(double& l : surface.length)
    l += increase;
}

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_TRIANGLE_SURFACE_H
