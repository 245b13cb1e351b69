// The solver does not know the mesh, and is the same in all programs: declared here, it is compiled
// once, in solver.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H

#include <CGAL/Seamless_snapping/internal/linear/snap_values.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>

#define SEAMLESS_SNAPPING_INSTANTIATE(PREFIX, INTEGER)                                             \
  PREFIX template class Unit_pivot_elimination<INTEGER>;                                           \
  PREFIX template class Kernel_lattice<INTEGER>;                                                   \
  PREFIX template class Lattice_reduction<INTEGER>;

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE(extern, std::int64_t)
SEAMLESS_SNAPPING_INSTANTIATE(extern, Exact_integer)
extern template class Complex_solver<Rotation_group<4> >;
extern template class Orientation_repair<Rotation_group<4> >;

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
