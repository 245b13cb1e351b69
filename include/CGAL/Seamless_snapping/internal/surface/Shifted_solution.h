// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SHIFTED_SOLUTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SHIFTED_SOLUTION_H

#include <CGAL/license/Seamless_snapping.h>

// The exact solution once more, for other targets or weights of the sectors.

#include <CGAL/Seamless_snapping/internal/algebra/solve_on_grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Optimum_response.h>
#include <CGAL/Seamless_snapping/internal/surface/snapped_coordinates.h>

#include <cstddef>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap>
class Shifted_solution
{
public:
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Coordinates = Sector_coordinates<TriangleMesh, HalfedgeUVMap>;
  using System = Reduced_system<TriangleMesh, HalfedgeUVMap>;

  // \param grid of a solution that was found before
  Shifted_solution(const Branches& branches, const Transition_data<TriangleMesh>& transitions,
                   const Align_edges<TriangleMesh>& align_edges,
                   const Constraint_list<TriangleMesh>& constraints, const HalfedgeUVMap& uv_map,
                   const Grid& grid)
    : m_branches(branches), m_transitions(transitions), m_align_edges(align_edges),
      m_constraints(constraints), m_uv_map(uv_map), m_grid(grid)
  { }

  const Branches& branches() const { return m_branches; }
  const Grid& grid() const { return m_grid; }

  Coordinates coordinates(const Sectors& sectors) const
  {
    return Coordinates(sectors, m_uv_map, m_grid);
  }

  System system(const Sectors& sectors, const Coordinates& coordinates) const
  {
    return System(sectors, m_branches, m_transitions, m_align_edges, m_constraints, coordinates, m_grid);
  }

  // The coordinates of all sectors. Returns false if there are none on the grid.
  // \param shift of targets, in steps of the grid
  bool solve(const Sectors& sectors, const Point_shift& shift, Uv_state& state) const
  {
    Coordinates targets = coordinates(sectors);
    for(const auto& s : shift)
      if(std::size_t(s.first) < sectors.number_of_sectors() && !targets.shift(s.first, s.second))
        return false;
    const System reduced = system(sectors, targets);
    Snapping_report report; // of no interest: the same system had a solution before
    Step_timer timer(report.run);
    Grid_solution solution{m_grid, {}, {}};
    const bool solved = std::visit([&](const auto& s) {
      return solve_on_grid(s, reduced.point(), solution, report, timer);
    }, reduced.system());
    if(!solved || solution.grid.exponent() != m_grid.exponent())
      return false;
    Snapped_coordinates<TriangleMesh, HalfedgeUVMap> snapped(sectors, m_branches, reduced, targets,
                                                             solution);
    if(!snapped.fits())
      return false;
    state = snapped.take();
    return true;
  }

private:
  const Branches& m_branches;
  const Transition_data<TriangleMesh>& m_transitions;
  const Align_edges<TriangleMesh>& m_align_edges;
  const Constraint_list<TriangleMesh>& m_constraints;
  const HalfedgeUVMap& m_uv_map;
  const Grid& m_grid;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SHIFTED_SOLUTION_H
