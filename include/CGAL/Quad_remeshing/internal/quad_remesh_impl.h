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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H

#include <CGAL/license/Quad_remeshing.h>

// The calls of `quad_remesh()`: on a surface without its small parts, and on quads of a map.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/Quad_search.h>
#include <CGAL/Quad_remeshing/internal/measure_quads_impl.h>
#include <CGAL/Quad_remeshing/internal/remeshing/leave_out_small_parts.h>
#include <CGAL/Quad_remeshing/internal/remeshing/vertex_far_away.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
double growth_by(const Mirror& mirror, const Marked_surface& input)
{
  return 2 * area_in_squares(Surface_to_remesh(input, mirror)) /
         area_in_squares(Surface_to_remesh(input, std::nullopt));
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report remesh(Marked_surface& input, const std::optional<Mirror>& mirror,
                        const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  if(const auto h = halfedge_from_far_away(input.mesh)) {
    const auto& p = input.mesh.point(input.mesh.source(*h));
    return refused<Remeshing_report>(
      Outcome::INVALID_ARGUMENT,
      name_of_face(std::size_t(input.mesh.face(*h))) + " has a vertex at (" +
        short_number(p.x()) + ", " + short_number(p.y()) + ", " + short_number(p.z()) +
        "), which is a million times as far away as nearly all others" +
        remedy("move it, or remove it"));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Small_parts small_parts(input, options.area_threshold,
                          options.quantization.is_coarsest
                            ? infinity : options.quantization.number_of_quads);
  small_parts.leave_out();
  Remeshing_report report = Quad_search(input, mirror, options, quads, is_feature).run();
  report.number_of_parts_left_out = small_parts.number();
  report.area_of_parts_left_out = small_parts.area();
  return report;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report smooth(const Marked_surface& input, const Quantization& quantization,
                        const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  Surface_to_remesh surface(input, std::nullopt);
  std::optional<Surface_locator> locator;
  Remeshing_run run(surface, options);
  if(has_similar_lengths(run))
    Quad_remesher(run, locator, quads, is_feature).run_on_quads(quantization);
  return run.report;
}

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
namespace parametrization {
CGAL_QUAD_REMESHING_PARAMETRIZE()
} // namespace parametrization
#endif

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H
