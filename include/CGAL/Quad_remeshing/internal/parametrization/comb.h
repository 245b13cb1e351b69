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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_COMB_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_COMB_H

#include <CGAL/license/Quad_remeshing.h>

// Combing: turns the crosses by quarter turns until they agree across all edges but the cuts.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The angle that +u is turned by.
inline double angle_of(const Quarter_turns::Element g)
{
  const auto& m = Quarter_turns::matrix(g);
  return std::atan2(m[1][0], m[0][0]);
}

// Changes `angles` by multiples of a quarter turn, and returns the rotations of the transitions
// between the new charts, per halfedge: the identity across edges that are not cut.
inline std::vector<Quarter_turns::Element> comb(const Triangle_surface& surface,
                                                const std::vector<char>& is_cut,
                                                const Matching& matching,
                                                std::vector<double>& angles)
{
  const auto across = [&](const Corner_index h)
  { return Quarter_turns::element(matching.turns[h]); };
  std::vector<Quarter_turns::Element> turn(surface.number_of_faces(), Quarter_turns::identity());
  for_each_edge_of_face_trees(
    surface, [&](const Corner_index h) { return !is_cut[h]; },
    [&](const Corner_index h) {
      turn[surface.face(surface.opposite(h))] =
        Quarter_turns::compose(across(h), turn[surface.face(h)]);
    });

  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    angles[f] += angle_of(turn[f]);
  std::vector<Quarter_turns::Element> rotation(surface.number_of_halfedges(),
                                               Quarter_turns::identity());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    rotation[h] = Quarter_turns::compose(
      Quarter_turns::inverse(turn[surface.face(surface.opposite(h))]),
      Quarter_turns::compose(across(h), turn[surface.face(h)]));
    if(rotation[h] != Quarter_turns::identity() && !is_cut[h])
      throw Refusal(Outcome::INTERNAL_ERROR,
                    "the field can't be combed: a cone or a handle was not cut open");
  }
  return rotation;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_COMB_H
