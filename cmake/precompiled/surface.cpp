// The functions on surfaces, compiled for all programs that use the precompiled headers.

#include "surface.h"

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(, seamless_snapping_precompiled::Plain)
SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(, seamless_snapping_precompiled::Features)
SEAMLESS_SNAPPING_INSTANTIATE_SURFACE(, seamless_snapping_precompiled::Aligned)
template auto
seam_transitions(const seamless_snapping_precompiled::Mesh&, seamless_snapping_precompiled::Uv_map,
                 const seamless_snapping_precompiled::Plain&);

} // namespace Seamless_snapping
} // namespace CGAL
