// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ARC_PATH_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ARC_PATH_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The course of an arc on the surface: the places where it crosses edges and meets vertices.

#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_set.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Of the corners 3 f, 3 f + 1, 3 f + 2 of a face; rounded.
struct Face_point
{
  Flat_face_index face = no_index;
  std::array<double, 3> weights{};
};

inline Face_point point_at_vertex(const Corner_index h)
{
  Face_point result;
  result.face = Chart_mesh::face(h);
  result.weights[std::size_t(h % 3)] = 1;
  return result;
}

// `t` is 0 at the source of the halfedge, 1 at its target.
inline Face_point point_on_edge(const Corner_index h, const double t)
{
  Face_point result = point_at_vertex(h);
  result.weights[std::size_t(h % 3)] = t;
  result.weights[std::size_t((h + 2) % 3)] = 1 - t;
  return result;
}

inline double parameter_on_edge(const Chart_mesh& mesh, const Corner_index h, const std::size_t c,
                                const Exact_level& level)
{
  const double a = mesh.uv(Chart_mesh::prev(h))[c], b = mesh.uv(h)[c];
  if(level.is_double())
    return (level.approximation() - a) / (b - a);
  const Exact_rational x(a);
  return CGAL::to_double(Exact_rational((level.exact() - x) / (Exact_rational(b) - x)));
}

inline Exact_rational twice_area(const Exact_uv& p, const Uv& a, const Uv& b)
{
  const Exact_rational u = p[0].exact(), v = p[1].exact();
  const Exact_rational au(a[0]), av(a[1]), bu(b[0]), bv(b[1]);
  return Exact_rational((au - u) * (bv - v) - (av - v) * (bu - u));
}

inline Face_point face_point(const Chart_mesh& mesh, const Layout_place& place)
{
  const Corner_index h = place.halfedge;
  if(place.place == Isocurve_place::VERTEX)
    return point_at_vertex(h);
  if(place.place == Isocurve_place::EDGE) {
    const Uv &a = mesh.uv(Chart_mesh::prev(h)), &b = mesh.uv(h);
    const std::size_t c = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
    return point_on_edge(h, parameter_on_edge(mesh, h, c, place.uv[c]));
  }
  Face_point result;
  result.face = mesh.face(h);
  std::array<Exact_rational, 3> areas;
  Exact_rational sum(0);
  for(std::size_t k = 0; k < 3; ++k) {
    areas[k] = twice_area(place.uv, mesh.uv(3 * result.face + Corner_index((k + 1) % 3)),
                          mesh.uv(3 * result.face + Corner_index((k + 2) % 3)));
    sum += areas[k];
  }
  for(std::size_t k = 0; k < 3; ++k)
    result.weights[k] = CGAL::to_double(Exact_rational(areas[k] / sum));
  return result;
}

inline Face_point exit_point(const Chart_mesh& mesh, const Curve_set& curves, const Curve_index c,
                             const Segment_index s)
{
  const Segment_end& exit = curves[c].segments[std::size_t(s)].exit;
  if(exit.place == Isocurve_place::VERTEX)
    return point_at_vertex(exit.halfedge);
  const Chord& chord = curves.chord(c, s);
  return point_on_edge(exit.halfedge, parameter_on_edge(mesh, exit.halfedge,
                                                        constant_component(chord.direction),
                                                        chord.level));
}

// Through the ends of segments between both points.
inline std::vector<Face_point> path_of_arc(const Chart_mesh& mesh, const Curve_set& curves,
                                           const Layout& layout, const std::size_t a)
{
  const Layout_arc& arc = layout.arcs[a];
  std::vector<Face_point> path;
  path.push_back(face_point(mesh, layout.points[std::size_t(arc.points[0])].place));
  for(const Curve_piece& piece : arc.pieces) {
    if(!piece.is_reversed)
      for(Segment_index s = piece.begin; s < piece.end; ++s)
        path.push_back(exit_point(mesh, curves, piece.curve, s));
    else
      for(Segment_index s = piece.end; s-- > piece.begin;)
        path.push_back(exit_point(mesh, curves, piece.curve, s));
  }
  path.push_back(face_point(mesh, layout.points[std::size_t(arc.points[1])].place));
  return path;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ARC_PATH_H
