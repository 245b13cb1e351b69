// The solver, compiled for all programs that use the precompiled headers.

#include "solver.h"

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE(, std::int64_t)
SEAMLESS_SNAPPING_INSTANTIATE(, Exact_integer)
template class Complex_solver<Rotation_group<4> >;
template class Orientation_repair<Rotation_group<4> >;

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL
