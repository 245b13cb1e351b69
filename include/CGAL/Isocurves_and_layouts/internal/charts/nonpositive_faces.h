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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_NONPOSITIVE_FACES_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_NONPOSITIVE_FACES_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The faces that are flipped or degenerate in the domain: no isocurve can be followed through them.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/orientation.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

template <typename Group>
Uv_triangle triangle(const Basic_chart_mesh<Group>& mesh, const std::size_t face)
{
  const Corner_index h = Corner_index(3 * face);
  return {mesh.uv(h), mesh.uv(h + 1), mesh.uv(h + 2)};
}

// In order.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Group>
std::vector<std::size_t> nonpositive_faces(const Basic_chart_mesh<Group>& mesh)
{
  using Faces = std::vector<std::size_t>;
  Faces result;
  const auto of_chunk = [&](const Chunk& chunk) {
    Faces faces;
    for(std::size_t f = chunk.begin; f < chunk.end; ++f)
      if(orientation(triangle(mesh, f)) != CGAL::POSITIVE)
        faces.push_back(f);
    return faces;
  };
  for(const Faces& faces : results_of_chunks<Faces, ConcurrencyTag>(mesh.corners.size() / 3,
                                                                    of_chunk))
    result.insert(result.end(), faces.begin(), faces.end());
  return result;
}

// How many there are, and the first, in words. `what` they are, such as "flipped".
inline std::string name_of_faces(const std::vector<std::size_t>& faces, const std::string& what)
{
  return std::to_string(faces.size()) + (faces.size() == 1 ? " face is " : " faces are ") + what +
         ", the first is face " + std::to_string(faces.front());
}

// Tells the report why no isocurve can be followed, if there is such a face.
inline bool are_positive(const std::vector<std::size_t>& nonpositive, Report& report,
                         const std::string& remedy =
                           "repair them by snap_to_seamless() with repair_flips(true)")
{
  return nonpositive.empty() ||
         refuse(report, Outcome::NOT_POSITIVE,
                name_of_faces(nonpositive, "flipped or degenerate in the domain") + "; " + remedy);
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_NONPOSITIVE_FACES_H
