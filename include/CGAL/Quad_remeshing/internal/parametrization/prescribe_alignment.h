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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRESCRIBE_ALIGNMENT_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRESCRIBE_ALIGNMENT_H

#include <CGAL/license/Quad_remeshing.h>

// The directions that alignment prescribes to the field, face by face.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

using Complex = std::complex<double>;

// A cross is represented by the fourth power of any of its four unit directions.
inline Complex cross_of_angle(const double angle)
{
  return std::polar(1., Quarter_turns::order * angle);
}

inline Complex unit_cross(const Complex& z)
{
  return (std::abs(z) > 0) ? z / std::abs(z) : Complex(1);
}

// One value per face: the cross to keep, or 0 where the field is free.
using Prescribed_field = std::vector<Complex>;

// Where a sector between two aligned edges is narrower than this, rounding would give both edges
// the same isocurve, and the faces between them would collapse.
constexpr double narrow_sector = 50 * pi / 180;

// Turns the crosses of the faces in a sector to 45 degrees of its bisector, so that the edges at
// its two sides are taken for one isocurve of each kind.
inline void open_sector(const Triangle_surface& surface,
                        const Corner_index first_corner, // outgoing edge: the first side
                        const std::size_t number_of_corners,
                        const double sector_angle,
                        Prescribed_field& field)
{
  Corner_index h = first_corner;
  double direction = surface.direction[surface.next(h)] + sector_angle / 2 - quarter_turn / 2;
  for(std::size_t i = 0; i < number_of_corners; ++i) {
    field[surface.face(h)] = cross_of_angle(direction);
    if(i + 1 < number_of_corners) {
      direction += surface.transport(h);
      h = surface.counterclockwise(h);
    }
  }
}

// Opens the sectors at vertex `v` that need it: the narrow ones, and those of a single face, where
// the two sides compete for one cross.
inline void open_sectors(const Triangle_surface& surface, const std::size_t v,
                         Prescribed_field& field)
{
  Corner_index first = no_index; // a corner whose outgoing edge is aligned
  for_each_corner(surface, v, [&](const Corner_index h) {
    if(first == no_index && surface.is_aligned[surface.next(h)])
      first = h;
  });
  if(first == no_index)
    return;

  Corner_index start = first, h = first;
  std::size_t count = 0;
  double sector_angle = 0;
  do {
    ++count;
    sector_angle += surface.angle[h];
    const Corner_index following = surface.counterclockwise(h);
    if(surface.is_aligned[h]) {
      const bool is_whole_turn = (following == start); // a single aligned edge ends here
      if(!is_whole_turn && (count == 1 || sector_angle < narrow_sector))
        open_sector(surface, start, count, sector_angle, field);
      start = following;
      count = 0;
      sector_angle = 0;
    }
    h = following;
  } while(h != no_index && h != first);
}

// Elsewhere, the field follows the directions of the caller, if there are any.
inline Prescribed_field prescribe_alignment(const Triangle_surface& surface,
                                            const Prescribed_field& directions)
{
  Prescribed_field field(surface.number_of_faces(), 0);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    std::size_t count = 0;
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h) {
      if(surface.is_aligned[h]) {
        ++count;
        field[f] = cross_of_angle(surface.direction[h]);
      }
    }
    if(count == 3)
      throw Refusal(Outcome::INVALID_ALIGNMENT,
                    "all three edges of face " + std::to_string(f) + " are to be aligned, which "
                    "would collapse it: split the face or release an edge");
  }
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    open_sectors(surface, v, field);
  for(std::size_t f = 0; f < directions.size(); ++f)
    if(field[f] == Complex(0))
      field[f] = directions[f];
  return field;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRESCRIBE_ALIGNMENT_H
