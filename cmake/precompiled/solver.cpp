// The solver, compiled for all programs that use the precompiled headers.

#include "solver.h"

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_SOLVER()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL
