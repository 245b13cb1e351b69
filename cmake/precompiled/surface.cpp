// The functions on surfaces, compiled for all programs that use the precompiled headers.

#include "surface.h"

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SURFACE()

} // namespace Seamless_snapping
} // namespace CGAL
