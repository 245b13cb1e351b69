// The reduced constraint system of a seamless parametrization, Sec. 5.3, as the package sets it up:
// for exact_reference.h and other solvers.

#ifndef SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H
#define SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H

#include "exact_reference.h"

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_cut_complex.h>
#include <CGAL/Seamless_snapping/internal/snapping/snap_surface.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace reduced_system {

struct Values_and_system
{
  CGAL::Seamless_snapping::internal::Scaled_system own_system; // in the package's form
  std::vector<double> weights;                                 // of its unknowns
  exact_reference::System system;                              // the same
  std::vector<double> xbar;
  std::size_t number_of_nodes = 0;
};

inline exact_reference::System
to_reference(const CGAL::Seamless_snapping::internal::Integer_system& system)
{
  exact_reference::System result;
  result.columns = system.number_of_columns();
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    const auto exact = system.exact_row(i);
    exact_reference::Row row;
    for(const auto& e : exact.entries)
      row.push_back({ std::size_t(e.column), exact_reference::Rational(e.coefficient) });
    exact_reference::Rational b(exact.right_hand_side);
    for(int k = 0; k < system.right_hand_scale(); ++k)
      b /= 2;
    for(int k = 0; k > system.right_hand_scale(); --k)
      b *= 2;
    result.add_row(row, b);
  }
  return result;
}

// Throws std::runtime_error if the package would refuse the input.
inline void check(const std::optional<CGAL::Seamless_snapping::internal::Refusal>& refusal)
{
  if(refusal)
    throw std::runtime_error(refusal->message);
}

// The parameters are those of snap_to_seamless(). Translations, which need not be doubles, are
// rounded.
template <typename Graph, typename UVMap, typename NamedParameters>
Values_and_system reduced_seamless_system(const Graph& g, const UVMap& uv,
                                          const NamedParameters& wrapped)
{
  namespace internal = CGAL::Seamless_snapping::internal;
  using Group = internal::Quarter_turns;
  const auto np = internal::strip(wrapped);
  const auto surface = internal::uv_surface(g, uv, np);
  const auto options = internal::snapping_options<Group>(g, np);
  const auto transitions = internal::read_transitions<Group>(g, uv, np);
  check(transitions.refusal);
  const internal::Aligned_edges<Group, typename decltype(surface)::Halfedge> aligned_edges(
    surface, options.edges_to_align, options.tolerance * transitions.extent);
  check(aligned_edges.refusal());
  check(options.constraints.refusal);
  const auto cuts = internal::read_cut_complex(surface, transitions, aligned_edges,
                                               options.constraints);
  const internal::Complex_solver<Group> solver(cuts.complex, internal::Number_format::of<double>());

  Values_and_system result;
  result.own_system = solver.system().rows();
  result.weights = solver.system().weights();
  result.system = to_reference(result.own_system.system);
  const internal::Linear_target target = solver.target();
  for(std::size_t j = 0; j < target.values.size(); ++j) {
    const auto k = solver.linear_solver().component(internal::Column_index(j));
    const double steps = static_cast<double>(target.values[j].base) + target.values[j].offset;
    result.xbar.push_back(k < 0 ? 0 : steps * target.grids[std::size_t(k)].step());
  }
  for(const char is_node : cuts.complex.is_node)
    result.number_of_nodes += is_node ? 1 : 0;
  return result;
}

} // namespace reduced_system

#endif // SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H
