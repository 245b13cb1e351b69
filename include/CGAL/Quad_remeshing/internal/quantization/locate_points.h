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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_LOCATE_POINTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_LOCATE_POINTS_H

#include <CGAL/license/Quad_remeshing.h>

// Where the points of the grid on a coarse complex lie on the input: at the point of the coarse
// triangle with the same barycentric coordinates; its vectors in the input's size lead there.

#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/Straight_walk.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Point_locator
{
public:
  Point_locator(const Integer_mesh& input, const Intrinsic_complex& complex,
                const Chart_mesh& charts)
    : m_input(input), m_complex(complex), m_charts(charts)
  { }

  Surface_location locate(const Lattice_point& p) const
  {
    const Corner_index h = p.corner;
    switch(p.place) {
    case Lattice_place::VERTEX:
      return walk(Intrinsic_complex::next(h), Straight_target{});
    case Lattice_place::EDGE:
      return walk(h, on_edge(h, to_integers(p.uv)));
    case Lattice_place::FACE:
      break;
    }
    return locate_in_face(h / 3, to_integers(p.uv));
  }

private:
  static Grid_vector to_integers(const Uv& u)
  { return {std::int64_t(u[0]), std::int64_t(u[1])}; }

  // A fraction of the halfedge.
  Straight_target on_edge(const Corner_index h, const Grid_vector& p) const
  {
    const Grid_vector& units = m_complex.corner(h).units;
    const std::size_t c = units[0] != 0 ? 0 : 1;
    const std::int64_t part =
      p[c] - to_integers(m_charts.uv(Intrinsic_complex::prev(h)))[c];
    return {{{m_complex.corner(h).vector, Grid_vector{}}}, {{absolute_value(part), 0}},
            absolute_value(units[c])};
  }

  // From the vertex of the face that is nearest, by barycentric coordinates.
  Surface_location locate_in_face(const Flat_face_index f, const Grid_vector& p) const
  {
    std::array<std::int64_t, 3> weight; // of the corners
    for(Corner_index k = 0; k < 3; ++k) {
      const Corner_index opposite = Intrinsic_complex::prev(3 * f + k); // its edge
      const Grid_vector source = to_integers(m_charts.uv(Intrinsic_complex::prev(opposite)));
      weight[std::size_t(k)] =
        cross_product(m_complex.corner(opposite).units, difference(p, source));
    }
    const Corner_index nearest = 3 * f + Corner_index(
      std::max_element(weight.begin(), weight.end()) - weight.begin());
    const Corner_index out = Intrinsic_complex::next(nearest);
    const Corner_index before = Intrinsic_complex::prev(nearest);
    return walk(out, Straight_target{
      {{m_complex.corner(out).vector, negated(m_complex.corner(nearest).vector)}},
      {{weight[std::size_t(out % 3)], weight[std::size_t(before % 3)]}},
      weight[0] + weight[1] + weight[2]});
  }

  // From the source of a halfedge of the complex, in whose chart the target is given.
  Surface_location walk(const Corner_index h, Straight_target target) const
  {
    const Direction_at_corner& departure = m_complex.corner(h).departure;
    for(Grid_vector& side : target.side)
      side = rotated(departure.turns, side);
    return Straight_walk(m_input, target).run(departure.corner);
  }

  const Integer_mesh& m_input;
  const Intrinsic_complex& m_complex;
  const Chart_mesh& m_charts;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_LOCATE_POINTS_H
