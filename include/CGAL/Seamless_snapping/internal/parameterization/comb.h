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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_COMB_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_COMB_H

#include <CGAL/license/Seamless_snapping.h>

// Combing: turns the crosses by quarter turns until they agree across all edges but the cuts.

#include <CGAL/Seamless_snapping/internal/parameterization/Failure.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Matching.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Triangle_surface.h>

#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

// Changes `angles` by multiples of a quarter turn and `matching.rotation` with them, such that the
// rotation is 0 across each edge that is not cut.
inline void comb(const Triangle_surface& surface, const std::vector<char>& is_cut,
                 std::vector<double>& angles, Matching& matching)
{
  std::vector<int> turns(surface.number_of_faces(), 0);
  for_each_edge_of_face_trees(
    surface, [&](const Corner_index h) { return !is_cut[h]; },
    [&](const Corner_index h) {
      turns[surface.face(surface.opposite(h))] =
        (turns[surface.face(h)] + matching.rotation[h]) % 4;
    });

  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    angles[f] += turns[f] * quarter_turn;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    int& rotation = matching.rotation[h];
    rotation += turns[surface.face(h)] - turns[surface.face(surface.opposite(h))];
    rotation = ((rotation % 4) + 4) % 4;
    if(rotation != 0 && !is_cut[h])
      throw Failure{Parameterization_status::INTERNAL_ERROR,
                    "the field can't be combed: a cone or a handle was not cut open"};
  }
}

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_COMB_H
