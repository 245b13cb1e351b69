// Remeshing, compiled for all programs that share it.

#include "remeshing.h"

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_REMESHING()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL
