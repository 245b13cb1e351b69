// The solver does not know the mesh, and is the same in all programs: declared here, it is compiled
// once, in solver.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
#define SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/linear/Integer_lattice.h>
#include <CGAL/Seamless_snapping/internal/linear/eliminate.h>
#include <CGAL/Seamless_snapping/internal/linear/lattice_reduction.h>
#include <CGAL/Seamless_snapping/internal/linear/snap_values.h>
#include <CGAL/Seamless_snapping/internal/orientation/Flip_untangler.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>
#include <CGAL/Seamless_snapping/internal/untangling/untangle.h>

#include <optional>
#include <vector>

#define SEAMLESS_SNAPPING_INSTANTIATE_LATTICE(PREFIX, INTEGER)                                     \
  PREFIX template class Unit_pivot_elimination<INTEGER>;                                           \
  PREFIX template class Kernel_lattice<INTEGER>;                                                   \
  PREFIX template class Lattice_reduction<INTEGER>;                                                \
  PREFIX template Echelon_form eliminate_in<INTEGER>(const Integer_system&);                       \
  PREFIX template void undo_elimination<INTEGER>(const Integer_system&,                            \
                                                 std::vector<Exact_rational>&);                    \
  PREFIX template void Integer_lattice::take_kernel<INTEGER>(const Integer_system&);               \
  PREFIX template Orthogonal_frame reduce_basis(std::vector<std::vector<INTEGER> >&,               \
                                                const std::vector<double>&);

#define SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, GROUP)                                       \
  PREFIX template class Reduced_system<GROUP>;                                                     \
  PREFIX template class Complex_solver<GROUP>;                                                     \
  PREFIX template bool is_exact(const Cut_complex<GROUP>&, const std::vector<Uv>&);

#define SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, GROUP)                                       \
  PREFIX template class Orientation_repair<GROUP>;                                                 \
  PREFIX template class Integer_rounding<GROUP>;

#define SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, HOW)                                      \
  PREFIX template bool untangle_flips<Rotation_group<4>, HOW>(                                     \
    const Movable_points<Rotation_group<4> >&, const Complex_solver<Rotation_group<4> >&,          \
    Uv_state&);

#define SEAMLESS_SNAPPING_INSTANTIATE_SOLVER(PREFIX)                                               \
  SEAMLESS_SNAPPING_INSTANTIATE_LATTICE(PREFIX, std::int64_t)                                      \
  SEAMLESS_SNAPPING_INSTANTIATE_LATTICE(PREFIX, Exact_integer)                                     \
  PREFIX template std::optional<Refusal> snap_values(                                              \
    const Scaled_system&, const std::vector<double>&, const Number_format&, std::vector<double>&,  \
    Snapping_report&, Step_timer&);                                                                \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<1>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<2>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<3>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<4>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_COMPLEX(PREFIX, Rotation_group<6>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<2>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<3>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<4>)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_CHANGES(PREFIX, Rotation_group<6>)                                 \
  PREFIX template class Untangler<double>;                                                         \
  SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, Untangling::NEAR_BY_FIRST)                      \
  SEAMLESS_SNAPPING_INSTANTIATE_UNTANGLING(PREFIX, Untangling::ANGLES_FIRST)

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_SOLVER(extern)

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_SOLVER_H
