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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CURVATURE_FIELD_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CURVATURE_FIELD_H

#include <CGAL/license/Quad_remeshing.h>

// A field of crosses that follows the principal directions of curvature where these are clear, and
// is smooth elsewhere.

#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/smoothest_field.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parametrization {

// The cross along the principal directions of each face, as long as its anisotropy (the difference
// of the principal curvatures) times the mean edge length, at most 1. A face is bent across its
// edges: as a line field each edge counts with its angle and length [Knoeppel et al. 2013, Sec. 4].
inline Prescribed_field principal_crosses(const Triangle_surface& surface)
{
  const std::vector<double> mean_length = component_means(surface, surface.length);
  std::vector<Complex> bending(surface.number_of_faces(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    bending[surface.face(h)] += surface.bending[h] * surface.length[h]
                                * std::polar(1., 2 * surface.direction[h]);

  Prescribed_field crosses(surface.number_of_faces());
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    // A single face is a noisy estimate: its neighbors are taken into account.
    Complex sum = bending[f];
    double area = surface.area[f];
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h) {
      if(surface.is_border_edge(h))
        continue;
      const Corner_index o = surface.opposite(h), g = surface.face(o);
      sum += bending[g] * std::polar(1., 2 * surface.transport(o));
      area += surface.area[g];
    }
    const double anisotropy = std::abs(sum) / area * mean_length[surface.component[f]];
    crosses[f] = (anisotropy > 0) ? std::polar((std::min)(anisotropy, 1.), 2 * std::arg(sum)) : 0;
  }
  return crosses;
}

// Minimizes the energy of the field plus `strength` times the squared distance to the principal
// crosses per mean face.
template <typename Solver>
std::vector<double> curvature_field(const Triangle_surface& surface,
                                    const Prescribed_field& prescribed, const double strength,
                                    Timed_solver<Solver>& solver)
{
  Prescribed_field wanted = principal_crosses(surface);
  for(Complex& z : wanted)
    z *= strength;
  Cross_field_system<Solver> system(surface, prescribed, strength, 1., solver);
  return angles_of_field(system.solve(wanted));
}

} // namespace parametrization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CURVATURE_FIELD_H
