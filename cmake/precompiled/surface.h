// The functions on surfaces for the types that most programs use: declared here, they are compiled
// once, in surface.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H

#include "mesh.h"

#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace seamless_snapping_precompiled {

// Without parameters, with features, and with features and borders.
namespace SS = CGAL::Seamless_snapping;
using Plain = CGAL::parameters::Default_named_parameters;
using Features = decltype(SS::parameters::edge_is_constrained_map(Edge_bool_map()));
using Aligned =
    decltype(SS::parameters::edge_is_constrained_map(Edge_bool_map()).align_border(true));

// What all calls share, whatever they ask for.
using Vertex_point_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;
using Vertex_index_map = std::decay_t<decltype(
    CGAL::get_initialized_vertex_index_map(std::declval<const Mesh&>(), std::declval<Plain>()))>;
using Surface = SS::internal::Uv_surface<Mesh, Uv_map, Vertex_index_map>;
using Surface_without_indices = SS::internal::Uv_surface<Mesh, Uv_map, SS::internal::No_indices>;

} // namespace seamless_snapping_precompiled

// Singular vertices, and what else knows no coordinates, or no mesh.
#define SEAMLESS_SNAPPING_INSTANTIATE_READERS(PREFIX)                                              \
  PREFIX template class internal::Constraint_reader<seamless_snapping_precompiled::Mesh>;          \
  PREFIX template class internal::Flat_numbering<seamless_snapping_precompiled::Mesh>;             \
  PREFIX template std::vector<std::pair<SM_Halfedge_index, int> >                                  \
  internal::singular_vertices<internal::Quarter_turns>(                                            \
    const seamless_snapping_precompiled::Surface_without_indices&, double, int,                    \
    const std::vector<internal::Mismatched_edge<SM_Halfedge_index> >&);                            \
  PREFIX template std::optional<internal::Refusal> internal::check_paths(                          \
    const internal::Cut_complex<internal::Quarter_turns>&,                                         \
    const internal::Constraint_list<SM_Halfedge_index>&, double, Snapping_report&);                \
  PREFIX template std::size_t internal::number_of_coinciding_border_edges(                         \
    const seamless_snapping_precompiled::Mesh&,                                                    \
    const seamless_snapping_precompiled::Vertex_point_map&);

#define SEAMLESS_SNAPPING_INSTANTIATE_SURVEY(PREFIX, SURFACE)                                      \
  PREFIX template std::optional<internal::Refusal> internal::find_bad_face(const SURFACE&);        \
  PREFIX template internal::Uv_survey<SURFACE::Halfedge> internal::survey_uv(                      \
    const SURFACE&, const std::function<bool(SURFACE::Halfedge)>&);

#define SEAMLESS_SNAPPING_INSTANTIATE_SNAPPERS(PREFIX, GROUP, SURFACE)                             \
  PREFIX template class internal::Transition_reader<GROUP, SURFACE>;                               \
  PREFIX template class internal::Cut_complex_reader<GROUP, SURFACE>;                              \
  PREFIX template Snapping_report internal::Surface_snapper<GROUP, SURFACE>::run();

#define SEAMLESS_SNAPPING_INSTANTIATE_CHECKS(PREFIX, PARAMETERS)                                   \
  PREFIX template bool is_seamless(const seamless_snapping_precompiled::Mesh&,                     \
                                   seamless_snapping_precompiled::Uv_map, const PARAMETERS&);      \
  PREFIX template Seamlessness measure_seamlessness(const seamless_snapping_precompiled::Mesh&,    \
                                                    seamless_snapping_precompiled::Uv_map,         \
                                                    const PARAMETERS&);

#define SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(PREFIX)                                              \
  SEAMLESS_SNAPPING_INSTANTIATE_READERS(PREFIX)                                                    \
  SEAMLESS_SNAPPING_INSTANTIATE_SURVEY(PREFIX, seamless_snapping_precompiled::Surface)             \
  SEAMLESS_SNAPPING_INSTANTIATE_SURVEY(PREFIX, internal::Flat_surface)                             \
  SEAMLESS_SNAPPING_INSTANTIATE_SNAPPERS(PREFIX, internal::Quarter_turns,                          \
                                         seamless_snapping_precompiled::Surface)                   \
  SEAMLESS_SNAPPING_INSTANTIATE_SNAPPERS(PREFIX, internal::Rotation_group<6>,                      \
                                         seamless_snapping_precompiled::Surface)                   \
  SEAMLESS_SNAPPING_INSTANTIATE_SNAPPERS(PREFIX, internal::Quarter_turns, internal::Flat_surface)  \
  SEAMLESS_SNAPPING_INSTANTIATE_CHECKS(PREFIX, seamless_snapping_precompiled::Plain)               \
  SEAMLESS_SNAPPING_INSTANTIATE_CHECKS(PREFIX, seamless_snapping_precompiled::Features)            \
  SEAMLESS_SNAPPING_INSTANTIATE_CHECKS(PREFIX, seamless_snapping_precompiled::Aligned)

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(extern)

} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H
