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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRINCIPAL_CROSSES_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRINCIPAL_CROSSES_H

#include <CGAL/license/Quad_remeshing.h>

// The principal directions of curvature as crosses, as clear as they are.

#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
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

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PRINCIPAL_CROSSES_H
