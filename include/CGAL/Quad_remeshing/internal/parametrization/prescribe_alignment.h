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

// If a sector between two aligned edges is narrower than this, rounding would give both edges
// the same isocurve, and the faces between them would collapse.
constexpr double narrow_sector = 50 * pi / 180; // a narrower sector counts as a quarter turn

// Turns the crosses of the faces in a sector to 45 degrees of its bisector, so that the edges at
// its two sides are taken for one isocurve of each kind.
inline void open_sector(const Triangle_surface& surface, const Aligned_sector& sector,
                        Prescribed_field& field)
{
  double direction = surface.direction[surface.next(sector.first)] + sector.angle / 2 -
                     quarter_turn / 2;
  for_each_corner(surface, sector, [&](const Corner_index h) {
    field[surface.face(h)] = cross_of_angle(direction);
    if(!surface.is_aligned[h])
      direction += surface.transport(h);
  });
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
                    "all three edges of " + name_of_face(std::size_t(f)) +
                      " are to be aligned, which would collapse it: split the face, release an "
                      "edge, or leave out the face");
  }
  // A face of two aligned edges is opened last, as a sector of several faces can be opened by the
  // rotations between them, too.
  for(const bool are_single : {false, true})
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      for_each_sector(surface, v, [&](const Aligned_sector& sector) {
        if((sector.number_of_corners == 1) == are_single &&
           (are_single || sector.angle < narrow_sector))
          open_sector(surface, sector, field);
      });
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
