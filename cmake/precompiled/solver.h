// The solver does not know the mesh, and is the same in all programs: declared here, it is compiled once,
// in solver.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H

#include <CGAL/Seamless_snapping/internal/algebra/snap_values.h>

#define SEAMLESS_SNAPPING_INSTANTIATE(PREFIX, INTEGER)                                             \
  PREFIX template bool solve_with(const Integer_system<INTEGER>&, const Grid_point&,               \
                                  Grid_solution&, Snapping_report&, Step_timer&);                  \
  PREFIX template Difference_projection difference_projection(const Integer_system<INTEGER>&,      \
                                                              const std::vector<double>&);         \
  PREFIX template void snap_values(const Integer_system<INTEGER>&,                                 \
                                   const std::map<std::size_t, Exact_rational>&,                   \
                                   const std::vector<double>&, const Number_format&,               \
                                   std::vector<double>&, Snapping_report&, Step_timer&);

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE(extern, std::int64_t)
SEAMLESS_SNAPPING_INSTANTIATE(extern, Exact_integer)

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
