// Snapping of maps with other rotations than quarter turns: declared here, it is compiled once, in
// symmetries.cpp. Few programs need it, and only these include this file.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H

#include "surface.h"

#define SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, GROUP)                                      \
  PREFIX template class internal::Transition_reader<                                               \
    GROUP, seamless_snapping_precompiled::Surface>;                                                \
  PREFIX template class internal::Cut_complex_reader<                                              \
    GROUP, seamless_snapping_precompiled::Surface>;                                                \
  PREFIX template Snapping_report internal::Surface_snapper<                                       \
    GROUP, seamless_snapping_precompiled::Surface, false>::run();

#define SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRIES(PREFIX)                                           \
  SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, internal::Rotation_group<6>)

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRIES(extern)

} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H
