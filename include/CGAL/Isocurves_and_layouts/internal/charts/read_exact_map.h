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
#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_READ_EXACT_MAP_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_READ_EXACT_MAP_H

#include <CGAL/license/Isocurves_and_layouts.h>

// An exactly seamless map as arrays, for all that needs one; or why it is refused.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>

#include <CGAL/tags.h>

#include <optional>
#include <type_traits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// Fills `mesh`, unless it returns a refusal.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename NamedParameters, typename Group>
std::optional<Refusal> read_exact_map(const TriangleMesh& tmesh,
                                      const Flat_numbering<TriangleMesh>& numbering,
                                      const HalfedgeUVMap& uv_map, const NamedParameters& np,
                                      Basic_chart_mesh<Group>& mesh)
{
  if(auto refusal = inexact_arithmetic())
    return refusal;
  if(faces(tmesh).size() == 0)
    return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face; was it read?");
  using Seam_group = Symmetry_group<NamedParameters>;
  static_assert(std::is_same_v<Group, Ray_group<Seam_group::order> >,
                "quads, their quantization, and layouts take maps of rotational symmetry 1, 2, and "
                "4 only; triangles those of 3 and 6");
  Transition_data<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> seams;
  call_both<ConcurrencyTag>([&] { seams = read_transitions<Seam_group>(tmesh, uv_map, np); },
                            [&] {
                              if(!numbering.refusal())
                                read_charts<ConcurrencyTag>(tmesh, numbering, uv_map, mesh);
                            });
  if(mesh.corners.empty() && !numbering.refusal())
    return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face; was it read?");
  if(seams.refusal)
    return seams.refusal;
  if(!seams.is_exact)
    return Refusal(Outcome::NOT_SEAMLESS,
                   "the map is not exactly seamless: sides of edges differ by up to " +
                     short_number(seams.violation) + "; call snap_to_seamless() first");
  add_transitions<Seam_group, ConcurrencyTag>(tmesh, numbering, seams, mesh);
  return std::nullopt;
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_READ_EXACT_MAP_H
