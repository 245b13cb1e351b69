// The functions on surfaces for the types that most programs use: declared here, they are compiled
// once, in surface.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace seamless_snapping_precompiled {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Edge_bool_map = Mesh::Property_map<Mesh::Edge_index, bool>;

namespace SS = CGAL::Seamless_snapping;

// Without parameters, with features, and with features and borders.
using Plain = CGAL::parameters::Default_named_parameters;
using Features = decltype(SS::parameters::edge_is_constrained_map(Edge_bool_map()));
using Aligned =
    decltype(SS::parameters::edge_is_constrained_map(Edge_bool_map()).align_border(true));

} // namespace seamless_snapping_precompiled

#define SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(PREFIX, PARAMETERS)                                  \
  PREFIX template Snapping_report snap_to_seamless(const seamless_snapping_precompiled::Mesh&,     \
                                                   seamless_snapping_precompiled::Uv_map,          \
                                                   const PARAMETERS&);                             \
  PREFIX template bool is_seamless(const seamless_snapping_precompiled::Mesh&,                     \
                                   seamless_snapping_precompiled::Uv_map, const PARAMETERS&);      \
  PREFIX template Seamlessness measure_seamlessness(const seamless_snapping_precompiled::Mesh&,    \
                                                    seamless_snapping_precompiled::Uv_map,         \
                                                    const PARAMETERS&);

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(extern, seamless_snapping_precompiled::Plain)
SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(extern, seamless_snapping_precompiled::Features)
SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(extern, seamless_snapping_precompiled::Aligned)
extern template auto
seam_transitions(const seamless_snapping_precompiled::Mesh&, seamless_snapping_precompiled::Uv_map,
                 const seamless_snapping_precompiled::Plain&);

} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SURFACE_H
