// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// Solves a complex: exact coordinates of its sectors, near the input or near targets beside it. The
// elimination and the factorization are made once, and serve all targets.

#include <CGAL/Seamless_snapping/internal/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/expand_solution.h>
#include <CGAL/Seamless_snapping/internal/complex/linear_target.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the reduced system of the complex is eliminated. A solution was found for the grids of
// `grids()`, if `solve()` was called and has returned one.
template <typename Group>
class Complex_solver
{
public:
  using Coordinates = std::vector<typename Cut_complex<Group>::Vector>;

  Complex_solver(const Cut_complex<Group>& complex, const Number_format& format)
    : m_complex(complex), m_format(format), m_system(complex),
      m_solver(m_system.rows(), m_system.weights(), format,
               m_system.number_of_representable_columns(), false),
      m_components(complex, m_system, m_solver),
      m_largest(largest_coordinates(complex, m_components, m_solver.number_of_components()))
  {
    for(const double largest : m_largest)
      m_grids.push_back(Grid::finest(format, largest));
  }

  Complex_solver(const Complex_solver&) = delete; // its members refer to each other
  Complex_solver& operator=(const Complex_solver&) = delete;

  const Reduced_system<Group>& system() const { return m_system; }
  const Linear_solver& linear_solver() const { return m_solver; }
  const Coordinate_components<Group>& components() const { return m_components; }
  const Number_format& format() const { return m_format; }
  const std::vector<Grid>& grids() const { return m_grids; } // per component

  // Of all grids; 1 if there is none.
  double coarsest_step() const
  {
    double step = 0;
    for(const Grid& grid : m_grids)
      step = (std::max)(step, grid.step());
    return step > 0 ? step : 1;
  }

  // Exact coordinates near the input; `grids()` become those of the solution. Returns why there are
  // none, if so.
  std::optional<Refusal> solve(Snapped_coordinates<Group>& snapped)
  {
    if(!m_solver.is_consistent())
      return Refusal{Snapping_status::INCONSISTENT, {}, m_solver.certificate()};
    for(;;) {
      Linear_solution solution;
      if(m_solver.solve(target(), solution) >= 0)
        return Refusal{Snapping_status::NOT_REPRESENTABLE, {}, {}};
      const std::vector<Grid> tried(m_grids);
      m_grids = solution.grids;
      snapped = expand({}, solution);
      if(snapped.misfit < 0)
        return std::nullopt;
      // Rare: coordinates that grow past a power of two need a coarser grid. Where right-hand sides
      // want a finer one, there is none.
      const std::size_t k = std::size_t(snapped.misfit);
      if(m_grids[k].exponent() < tried[k].exponent())
        return Refusal{Snapping_status::NOT_REPRESENTABLE, {}, {}};
      m_grids[k] = Grid(m_format, m_grids[k].exponent() + 1);
    }
  }

  // The same for targets beside the input, on the grids of the first solution. Returns false if
  // there are none.
  bool solve_shifted(const Target_shifts<Group>& shifts, Coordinates& coordinates) const
  {
    Linear_solution solution;
    if(!are_in_range(shifts) || m_solver.solve(linear_target(shifts), solution) >= 0)
      return false;
    for(std::size_t k = 0; k < m_grids.size(); ++k)
      if(solution.grids[k].exponent() != m_grids[k].exponent())
        return false;
    Snapped_coordinates<Group> snapped = expand(shifts, solution);
    coordinates.swap(snapped.coordinates);
    return snapped.misfit < 0;
  }

  // What the linear solver approximates where no target is shifted.
  Linear_target target() const { return linear_target({}); }

private:
  Linear_target linear_target(const Target_shifts<Group>& shifts) const
  {
    const Grid_coordinates<Group> coordinates(m_complex, m_grids, shifts);
    return {m_grids,
            Linear_target_builder<Group>(m_complex, m_system, m_components, coordinates).build()};
  }

  // Whether shifts can be added to coordinates in steps of any of the grids.
  bool are_in_range(const Target_shifts<Group>& shifts) const
  {
    constexpr double largest = machine_integer_bound / 4;
    for(const auto& shift : shifts)
      for(const double by : shift.second)
        for(const Grid& grid : m_grids)
          if(!(std::abs(grid.in_steps(by)) < largest))
            return false;
    return true;
  }

  Snapped_coordinates<Group> expand(const Target_shifts<Group>& shifts,
                                    const Linear_solution& solution) const
  {
    Snapped_coordinates<Group> result;
    for(std::size_t k = 0; k < m_largest.size(); ++k) // a right-hand side may want a very fine grid
      if(solution.grids[k].in_steps(m_largest[k]) >= machine_integer_bound / 4)
        result.misfit = Component_index(k);
    if(result.misfit >= 0)
      return result;
    const Grid_coordinates<Group> targets(m_complex, solution.grids, shifts);
    return Solution_expander<Group>(m_complex, m_system, m_components, targets, solution, m_format,
                                    coarsest_step()).take();
  }

  const Cut_complex<Group>& m_complex;
  Number_format m_format;
  Reduced_system<Group> m_system;
  Linear_solver m_solver;
  Coordinate_components<Group> m_components;
  std::vector<double> m_largest; // per component: absolute value of a coordinate
  std::vector<Grid> m_grids;     // per component
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_COMPLEX_SOLVER_H
