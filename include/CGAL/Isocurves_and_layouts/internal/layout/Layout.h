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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_H

#include <CGAL/license/Isocurves_and_layouts.h>

// A partition of a surface into rectangles, some of which an oblique border cuts: points, arcs, and
// patches. Nothing here depends on the mesh data structure.

#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_set.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_place.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Halves 2 a and 2 a + 1 of arc a run forward and back.
using Half_arc_index = std::int32_t;
using Point_index = std::int32_t;
using Patch_index = std::int32_t;

inline Half_arc_index twin(const Half_arc_index h) { return h ^ 1; }

struct Layout_point
{
  Layout_place place;            // in its unique description
  Start_kind start = Start_kind::NONE;
  std::int32_t first_slot = 0;   // one slot for each quarter turn; at the border, for each ray and
                                 // each oblique border edge
  std::int32_t number_of_slots = 0;
  std::int32_t degree = 0;       // the number of arcs
};

// The ends of segments of a curve that an arc passes.
struct Curve_piece
{
  Curve_index curve;
  Segment_index begin, end;
  bool is_reversed;
};

struct Layout_arc
{
  std::array<Point_index, 2> points;
  Exact_level length;                // 0 on an oblique border
  std::array<Curve_piece, 2> pieces; // the second one may be empty
  bool is_wall, is_oblique;
};

// The next half around the patch at the left; what lies outside of the surface is no patch.
struct Half_arc
{
  Half_arc_index next = no_index;
  std::int32_t turns = 0; // the angle at its end, in quarter turns; 0 next to an oblique border
  Patch_index patch = no_index;
  bool is_outside = false;
};

// A rectangle has one cycle around it, in four sides: the first and the third are of length
// `width`. A patch that an oblique border has cut has any number of cycles, and no sides.
struct Layout_patch
{
  std::vector<std::vector<Half_arc_index> > cycles; // each counterclockwise
  bool is_cut = false;
  std::array<std::vector<Half_arc_index>, 4> sides;
  Exact_level width, height;
  std::ptrdiff_t euler_characteristic = 1;
  Exact_rational area{0}; // if it is cut
};

struct Layout
{
  std::vector<Layout_point> points;
  std::vector<Half_arc_index> slots; // the half that leaves there, if any
  std::vector<Layout_arc> arcs;
  std::vector<Half_arc> half_arcs;
  std::vector<Layout_patch> patches;

  const Layout_arc& arc(const Half_arc_index h) const { return arcs[std::size_t(h / 2)]; }
  Point_index source(const Half_arc_index h) const { return arc(h).points[std::size_t(h % 2)]; }
  Point_index target(const Half_arc_index h) const { return source(twin(h)); }
  const Half_arc& half(const Half_arc_index h) const { return half_arcs[std::size_t(h)]; }
};

// The course of an arc on the surface: the places where it crosses edges and meets vertices.

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

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_H
