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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CHECK_INPUT_H
#define CGAL_QUAD_REMESHING_INTERNAL_CHECK_INPUT_H

#include <CGAL/license/Quad_remeshing.h>

// The checks of a surface and options before quads are made.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_run.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Products of lengths that differ by more are 0 or infinite.
inline bool has_similar_lengths(Remeshing_run& run)
{
  constexpr double largest_ratio = 1e50; // of edge lengths: squares of their products stay finite
  double least = std::numeric_limits<double>::infinity(), longest = 0;
  std::size_t face = 0;
  for(const auto f : run.mesh().faces())
    for(const auto h : run.mesh().halfedges_around_face(run.mesh().halfedge(f))) {
      const double l = run.surface.length(h);
      if(l > longest) {
        longest = l;
        face = run.surface.original(f);
      }
      least = l > 0 ? (std::min)(least, l) : least;
    }
  return !(longest > largest_ratio * least) ||
         refuse(run.report, Outcome::INVALID_ARGUMENT,
                name_of_face(face) + " has an edge more than 1e50 times as long as the shortest "
                "one of the mesh" + remedy("remove the vertex that is far away"));
}

inline bool has_valid_tolerances(Remeshing_run& run)
{
  const bool is_negative = !(run.options.border_tolerance.value_or(0) >= 0);
  return (!is_negative && run.options.area_threshold.value_or(0) >= 0) ||
         refuse(run.report, Outcome::INVALID_ARGUMENT,
                term(is_negative ? "border_tolerance" : "area_threshold") +
                  " must not be negative");
}

inline bool has_valid_mirror(Remeshing_run& run)
{
  const std::optional<Mirror>& mirror = run.surface.mirror();
  if(mirror && !mirror->is_valid())
    return refuse(run.report, Outcome::INVALID_ARGUMENT,
                  term("symmetry_plane") + " is no plane");
  if(mirror && run.mesh().number_of_faces() == 0)
    return refuse(run.report, Outcome::INVALID_ARGUMENT,
                  "no part of the surface is on the positive side of " + term("symmetry_plane") +
                    ", or it meets itself along it");
  return true;
}

// If not, the report of the run tells why.
inline bool has_valid_input(Remeshing_run& run)
{ return has_similar_lengths(run) && has_valid_tolerances(run) && has_valid_mirror(run); }

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CHECK_INPUT_H
