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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// From the solution of the reduced system to the coordinates of all sectors: those between the nodes
// follow from the translations and constant coordinates of their branches (Sec. 5.3.1, steps 2 and 3).

#include <CGAL/Seamless_snapping/internal/exact/rounded_to.h>
#include <CGAL/Seamless_snapping/internal/surface/Reduced_system.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant after construction: if `fits()`, components that are constrained are grid elements that
// satisfy all constraints; the others keep their values, or the mean of their corners' where these differ,
// and need no grid.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Snapped_coordinates
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Coordinates = Sector_coordinates<TriangleMesh, HalfedgeUVMap>;
  using System = Reduced_system<TriangleMesh, HalfedgeUVMap>;
  using Number = typename Uv_number<HalfedgeUVMap>::type;

public:
  // `coordinates` on the grid of `solution`
  Snapped_coordinates(const Sectors& sectors, const Branches& branches, const System& system,
                      const Coordinates& coordinates, const Grid_solution& solution)
    : m_sectors(sectors), m_system(system), m_coordinates(coordinates), m_solution(solution),
      m_is_too_fine(solution.grid.in_steps(sectors.largest_coordinate()) >= machine_integer_bound / 4),
      m_uv(sectors.number_of_sectors())
  {
    for(std::size_t s = 0; s < m_uv.size(); ++s)
      set_unsnapped(Sector_index(s));
    for(std::size_t b = 0; b < branches.cut.size(); ++b)
      snap_cut_branch(b, branches.cut.begin(b), branches.cut.end(b));
    for(std::size_t b = 0; b < branches.aligned.size(); ++b)
      snap_align_branch(b, branches.aligned.begin(b), branches.aligned.end(b));
  }

  // Whether all coordinates are numbers of the format; else a coarser grid is needed.
  bool fits() const { return m_fits; }

  // The sum of the squared changes of all components, had they not been rounded to the grid: the least-squares
  // optimum, in steps of the grid of the largest coordinates.
  double optimal_squares() const { return m_optimal_squares; }

  // Hands over the coordinates of all sectors.
  std::vector<Uv> take() { return std::move(m_uv); }

private:
  void set_unsnapped(const Sector_index s)
  {
    Uv& uv = m_uv[std::size_t(s)];
    uv = m_sectors.sector(s).uv;
    if(!m_sectors.sector(s).is_uniform()) {
      const Uv mean = m_coordinates.mean(s);
      for(std::size_t c = 0; c < 2; ++c)
        uv[c] = rounded_to<Number>(mean[c]);
      add_optimal_change(s, std::sqrt(m_coordinates.squares_within(s)));
    }
    const Column_index unknown = m_system.unknown(s);
    if(unknown < 0)
      return;
    const Grid_uv u = m_coordinates[s];
    for(std::size_t c = 0; c < 2; ++c)
      if(m_system.is_constrained(s, c)) {
        set(s, c, m_solution.x[std::size_t(unknown) + c]);
        add_optimal_change(s, optimal_change(u, c, unknown + Column_index(c)));
      }
  }

  // By how much the real-valued optimum of an unknown differs from a component of a sector.
  double optimal_change(const Grid_uv& u, const std::size_t c, const Column_index unknown) const
  {
    const Grid_value& optimum = m_solution.target[std::size_t(unknown)];
    return static_cast<double>(optimum.base - u.base[c]) + (optimum.offset - u.offset[c]);
  }

  // \param change in steps of the sector's grid
  void add_optimal_change(const Sector_index s, double change)
  {
    if(const int magnification = m_sectors.sector(s).magnification)
      change = std::ldexp(change, -magnification);
    m_optimal_squares += change * change;
  }

  void set(const Sector_index s, const std::size_t c, const std::int64_t x)
  {
    m_fits = m_fits && m_solution.grid.is_representable(x);
    double& u = m_uv[std::size_t(s)][c];
    u = m_solution.grid.value(x);
    if(const int magnification = m_sectors.sector(s).magnification)
      u = std::ldexp(u, -magnification);
  }

  // Given t, the pair of sectors takes the grid point nearest to its optimum: u+ the one nearest to the
  // weighted mean of u+ and R^-1 (u- - t), and u- = R u+ + t exactly.
  void snap_cut_branch(const std::size_t b, const Directed_cut* first, const Directed_cut* last)
  {
    const Column_index unknown = m_system.translation(b);
    if(unknown < 0)
      return;
    if(m_is_too_fine) { // and some right-hand side needs it
      m_fits = false;
      return;
    }
    const int k = m_system.directed_rotation(*first);
    const Rotation& r = rotation_matrix(k);
    const Rotation& inverse = rotation_matrix(inverse_rotation(k));
    const Grid_vector t{{m_solution.x[std::size_t(unknown)], m_solution.x[std::size_t(unknown) + 1]}};
    const Grid_uv grid_t{t, {{0, 0}}};
    const Uv rounding = inverse(Uv{{optimal_change(grid_t, 0, unknown), optimal_change(grid_t, 1, unknown + 1)}});
    for(const Directed_cut* d = first; d != last - 1; ++d) {
      const Sector_index plus = m_sectors.target_sector(*d);
      const Sector_index minus = m_sectors.source_sector(opposite_cut(*d));
      const Grid_uv a = m_coordinates[plus];
      const Grid_uv z = m_coordinates[minus];
      const double w_plus = m_sectors.sector(plus).weight, w_minus = m_sectors.sector(minus).weight;
      const double share = w_minus / (w_plus + w_minus);
      const Uv gap = inverse(transition_gap(a, z, r, t));
      Grid_vector x;
      for(std::size_t c = 0; c < 2; ++c) {
        x[c] = a.base[c] + nearest_integer(a.offset[c] + gap[c] * share);
        add_optimal_change(plus, (gap[c] - rounding[c]) * share);
        add_optimal_change(minus, (gap[c] - rounding[c]) * (1 - share));
      }
      const Grid_vector rotated = r(x);
      for(std::size_t c = 0; c < 2; ++c) {
        set(plus, c, x[c]);
        set(minus, c, rotated[c] + t[c]);
      }
    }
  }

  void snap_align_branch(const std::size_t b, const std::int32_t* first, const std::int32_t* last)
  {
    const Column_index unknown = m_system.coordinate(b);
    if(unknown < 0)
      return;
    const std::size_t c = m_system.align_component(*first);
    for(const std::int32_t* d = first; d != last - 1; ++d) {
      const Sector_index s = m_system.align_sector(*d, true);
      set(s, c, m_solution.x[std::size_t(unknown)]);
      add_optimal_change(s, optimal_change(m_coordinates[s], c, unknown));
    }
  }

  const Sectors& m_sectors;
  const System& m_system;
  const Coordinates& m_coordinates;
  const Grid_solution& m_solution;
  bool m_is_too_fine; // to compute with all coordinates as integers
  std::vector<Uv> m_uv; // per sector
  double m_optimal_squares = 0;
  bool m_fits = true;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SNAPPED_COORDINATES_H
