// Remeshing, compiled for all programs that share it.

#include "remeshing.h"

#include <CGAL/Seamless_snapping/internal/quantization/quantize_surface_impl.h>
#include <CGAL/Seamless_snapping/quad_remesh_impl.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_REMESHING()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL
