// Snapping of maps with other rotations than quarter turns: declared here, it is compiled once, in
// symmetries.cpp. Few programs need it, and only these include this file.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H

#include "surface.h"

#define SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, GROUP, UV_MAP, MAY_ROUND)                   \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX_READER(PREFIX, GROUP, UV_MAP)                              \
  SEAMLESS_SNAPPING_INSTANTIATE_SNAPPER(PREFIX, GROUP, UV_MAP, MAY_ROUND, false)

#define SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRIES(PREFIX)                                           \
  SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, internal::Rotation_group<2>,                      \
                                         seamless_snapping_precompiled::Uv_map, false)             \
  SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, internal::Rotation_group<3>,                      \
                                         seamless_snapping_precompiled::Uv_map, false)             \
  SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, internal::Rotation_group<6>,                      \
                                         seamless_snapping_precompiled::Uv_map, false)             \
  SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRY(PREFIX, internal::Rotation_group<6>,                      \
                                         seamless_snapping_precompiled::Scaled_uv_map, true)

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRIES(extern)

} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SYMMETRIES_H
