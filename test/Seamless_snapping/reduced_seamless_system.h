// The reduced constraint system of a seamless parametrization, Sec. 5.3, as the package sets it up:
// for exact_reference.h and other solvers.

#ifndef SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H
#define SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H

#include "exact_reference.h"

#include <CGAL/Seamless_snapping/internal/surface/Reduced_system.h>
#include <CGAL/Seamless_snapping/internal/surface/read_transitions.h>
#include <CGAL/Seamless_snapping/parameters.h>


#include <cstddef>
#include <stdexcept>
#include <variant>
#include <vector>

namespace reduced_system {

struct Values_and_system
{
  CGAL::Seamless_snapping::internal::Any_system own_system; // in the package's form
  exact_reference::System system;                           // the same
  std::vector<double> xbar;
  std::size_t number_of_nodes = 0;
};

template <typename Integer>
exact_reference::System
to_reference(const CGAL::Seamless_snapping::internal::Integer_system<Integer>& system)
{
  exact_reference::System result;
  result.columns = system.number_of_columns();
  for(std::size_t i = 0; i < system.number_of_rows(); ++i) {
    exact_reference::Row row;
    for(const auto* e = system.begin(i); e != system.end(i); ++e)
      row.push_back({ std::size_t(e->column), exact_reference::Rational(e->coefficient) });
    exact_reference::Rational b(system.right_hand_side(i));
    for(int k = 0; k < system.right_hand_scale(); ++k)
      b /= 2;
    for(int k = 0; k > system.right_hand_scale(); --k)
      b *= 2;
    result.add_row(row, b);
  }
  return result;
}

// Throws std::runtime_error if the package would refuse the input.
template <typename Step>
void check(const Step& step)
{
  if(step.status() != CGAL::Seamless_snapping::Snapping_status::ALREADY_EXACT)
    throw std::runtime_error(step.message());
}

// The parameters are those of snap_to_seamless(). Translations, which need not be doubles, are
// rounded.
template <typename Graph, typename UVMap, typename NamedParameters>
Values_and_system reduced_seamless_system(const Graph& g, const UVMap& uv,
                                          const NamedParameters& wrapped)
{
  namespace internal = CGAL::Seamless_snapping::internal;
  const auto np = internal::strip(wrapped);
  const auto transitions = internal::read_transitions(g, uv, np);
  if(transitions.status != CGAL::Seamless_snapping::Snapping_status::ALREADY_EXACT)
    throw std::runtime_error(transitions.message);
  const auto align_edges = internal::read_align_edges(g, uv, transitions.extent, np);
  const internal::Constraint_list<Graph> constraints(g, np);
  check(align_edges);
  check(constraints);
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(g, np);
  const internal::Sector_map<Graph, UVMap> sectors(g, uv, transitions, align_edges,
                                                   constraints.corners(), vertex_indices);
  const internal::Branches branches(sectors);
  const auto grid = internal::Grid::finest(internal::Number_format::of<double>(),
                                           sectors.largest_coordinate());
  const internal::Sector_coordinates<Graph, UVMap> coordinates(sectors, uv, grid);
  const internal::Reduced_system<Graph, UVMap> reduced(sectors, branches, transitions, align_edges,
                                                       constraints, coordinates, grid);

  Values_and_system result;
  result.own_system = reduced.system();
  result.system = std::visit([](const auto& system) { return to_reference(system); },
                             result.own_system);
  for(const auto& value : reduced.point().values)
    result.xbar.push_back((static_cast<double>(value.base) + value.offset) * grid.step());
  for(const bool is_node : branches.is_node)
    result.number_of_nodes += is_node ? 1 : 0;
  return result;
}

} // namespace reduced_system

#endif // SEAMLESS_SNAPPING_TEST_REDUCED_SEAMLESS_SYSTEM_H
