// Parametrization, quantization and extraction of quads: declared here, they are compiled once, in
// remeshing.cpp. Few programs need them, and only these include this file.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_REMESHING_H
#define SEAMLESS_SNAPPING_PRECOMPILED_REMESHING_H

#include "mesh.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

namespace seamless_snapping_precompiled {

using Features_of_map = std::decay_t<decltype(CGAL::Quad_remeshing::internal::strip(
    CGAL::Quad_remeshing::parameters::edge_is_constrained_map(Edge_bool_map())))>;

} // namespace seamless_snapping_precompiled

#define SEAMLESS_SNAPPING_INSTANTIATE_EXTRACTION(PREFIX, TAG)                                      \
  PREFIX template bool Cell_extractor<Quarter_turns>::find_points<TAG>();                          \
  PREFIX template bool Cell_extractor<Quarter_turns>::find_cells<TAG>();

#define SEAMLESS_SNAPPING_INSTANTIATE_REMESHING(PREFIX)                                            \
  PREFIX template Quantization quantize_map(                                                       \
    const seamless_snapping_precompiled::Mesh&, const seamless_snapping_precompiled::Uv_map&,      \
    const seamless_snapping_precompiled::Features_of_map&, const Quantization_options&);           \
  SEAMLESS_SNAPPING_INSTANTIATE_EXTRACTION(PREFIX, CGAL::Sequential_tag)                           \
  SEAMLESS_SNAPPING_INSTANTIATE_EXTRACTION(PREFIX, CGAL::Parallel_if_available_tag)

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_REMESHING(extern)

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_REMESHING_H
