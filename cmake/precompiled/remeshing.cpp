// Remeshing, compiled for all programs that share it.

#include "remeshing.h"

#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface_impl.h>
#include <CGAL/Quad_remeshing/internal/quad_remesh_impl.h>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_REMESHING()

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL
