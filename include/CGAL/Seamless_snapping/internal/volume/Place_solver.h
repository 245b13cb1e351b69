// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// From the places to exact coordinates of all corners near the input: solves the system of places,
// and lets each member go to the grid point nearest to its optimum.

#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_system.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the system is eliminated. Coordinates whose class holds exactly in the input are kept.
class Place_solver
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;

public:
  // \param is_inexact per coordinate of a slot: whether a constraint on it does not hold
  Place_solver(const Flat_volume& volume, const Volume_structure& structure,
               const std::vector<char>& is_inexact, const Number_format& format)
    : m_volume(volume), m_charts(structure.charts), m_sectors(structure.sectors),
      m_places(structure.places), m_members(structure.members),
      m_means(volume.coordinates, structure), m_format(format), m_system(structure),
      m_classes(structure),
      m_solver(m_system.rows(), m_system.weights(), format, m_system.weights().size(), false),
      m_moves(m_classes.size(), 0)
  {
    for(std::size_t j = 0; j < is_inexact.size(); ++j)
      if(is_inexact[j] != 0)
        m_moves[m_classes.root(j)] = 1;
    std::vector<double> largest(m_classes.size(), 0);
    for(const Place& place : m_places.places)
      for(std::size_t i = 0; i < place.members.size(); ++i)
        for(std::size_t c = 0; c < 3; ++c) {
          double& x = largest[m_classes.root(place.column(i % place.number_of_slots, c))];
          x = (std::max)(x, m_means.largest(place.members[i], c));
        }
    for(const double x : largest)
      m_grids.push_back(Grid::finest(format, x));
  }

  const Linear_solver& linear_solver() const { return m_solver; }

  double coarsest_step() const
  {
    double result = 0;
    for(std::size_t j = 0; j < m_grids.size(); ++j)
      if(m_classes.root(j) == j && m_moves[j] != 0)
        result = (std::max)(result, m_grids[j].step());
    return result;
  }

  const Grid& grid(const std::size_t column) const { return m_grids[m_classes.root(column)]; }
  bool moves(const std::size_t column) const { return m_moves[m_classes.root(column)] != 0; }

  // Fills in the coordinates of all corners. Returns false if no grid has a solution.
  bool solve(std::vector<Uvw>& coordinates)
  {
    for(;;) {
      m_misfit = -1;
      if(!solve_system())
        return false;
      if(m_misfit < 0) {
        expand(coordinates);
        if(m_misfit < 0)
          return true;
      }
      // Rare: coordinates that grow past a power of two need a coarser grid.
      Grid& grid = m_grids[std::size_t(m_misfit)];
      if(grid.exponent() >= m_format.maximum_exponent)
        return false;
      grid = Grid(m_format, (std::max)(grid.exponent() + 1, m_wanted_exponent));
    }
  }

private:
  // The values of the slots.
  bool solve_system()
  {
    Linear_target target{std::vector<Grid>(m_solver.number_of_components(), Grid(m_format, 0)),
                         targets()};
    std::vector<std::size_t> root_of_component(m_solver.number_of_components());
    for(std::size_t j = 0; j < m_classes.size(); ++j)
      if(const Component_index k = m_solver.component(Column_index(j)); k >= 0) {
        root_of_component[std::size_t(k)] = m_classes.root(j);
        target.grids[std::size_t(k)] = grid(j);
      }
    Linear_solution solution{target.grids, std::vector<std::int64_t>(target.values.size(), 0),
                             std::vector<Grid_value>(target.values.size())};
    for(std::size_t k = 0; k < root_of_component.size(); ++k) {
      if(m_moves[root_of_component[k]] == 0)
        continue;
      if(!m_solver.solve_component(Component_index(k), target, solution))
        return false;
      if(solution.grids[k].exponent() != target.grids[k].exponent())
        note_misfit(root_of_component[k], solution.grids[k].exponent());
    }
    m_x.swap(solution.x);
    for(std::size_t j = 0; j < m_classes.size(); ++j)
      if(m_solver.component(Column_index(j)) < 0 && moves(j) &&
         !grid(j).nearest(target.values[j], m_x[j]))
        note_misfit(m_classes.root(j));
    return true;
  }

  void note_misfit(const std::size_t root,
                   const int wanted_exponent = (std::numeric_limits<int>::min)())
  {
    m_misfit = std::int64_t(root);
    m_wanted_exponent = wanted_exponent;
  }

  // The mean of the members, per coordinate of a slot.
  std::vector<Grid_value> targets() const
  {
    std::vector<Grid_value> result;
    for(const Place& place : m_places.places)
      for(std::size_t slot = 0; slot < place.number_of_slots; ++slot)
        for(std::size_t c = 0; c < 3; ++c)
          result.push_back(m_means(place, slot, c, grid(result.size())));
    return result;
  }

  void expand(std::vector<Uvw>& coordinates)
  {
    coordinates = m_volume.coordinates;
    for(Member_index m = 0; m < m_members.size(); ++m)
      set_member(m, coordinates);
  }

  // The integers by which the unknowns of a member take it nearest to its corners: for each the
  // mean over all slots. A single member is there already.
  std::array<std::int64_t, 3> displacement(const Member_index m) const
  {
    const Place& place = m_members.place(m);
    std::array<Mean_of_grid_values, 3> means;
    for(std::size_t slot = 0; place.number_of_members() > 1 && slot < place.number_of_slots; ++slot)
      for(std::size_t c = 0; c < 3; ++c) {
        const std::size_t column = m_members.column(m, slot, c);
        const Volume_members::Term t = m_members.term(m, slot, c);
        if(t.sign == 0 || !moves(column))
          continue;
        const Grid_value u = m_means(m_members.sector(m, slot), c, grid(column));
        means[t.unknown - m_members.first_unknown(m)].add(
          {t.sign * (u.base - m_x[column]), t.sign * u.offset});
      }
    return {means[0].rounded(), means[1].rounded(), means[2].rounded()};
  }

  void set_member(const Member_index m, std::vector<Uvw>& coordinates)
  {
    const std::array<std::int64_t, 3> moved = displacement(m);
    for(std::size_t slot = 0; slot < m_members.place(m).number_of_slots; ++slot)
      for(std::size_t c = 0; c < 3; ++c) {
        const std::size_t column = m_members.column(m, slot, c);
        if(!moves(column))
          continue;
        const Volume_members::Term t = m_members.term(m, slot, c);
        const std::int64_t by =
          t.sign == 0 ? 0 : t.sign * moved[t.unknown - m_members.first_unknown(m)];
        if(!set_sector(m_members.sector(m, slot), c, grid(column), m_x[column] + by, coordinates))
          return note_misfit(m_classes.root(column));
      }
  }

  // Sets coordinate c, x in the system, of all corners of a sector. Returns false if some can't be
  // represented.
  bool set_sector(const Sector_number s, const std::size_t c, const Grid& grid,
                  const std::int64_t x, std::vector<Uvw>& coordinates) const
  {
    if(!grid.is_representable(x))
      return false;
    for(const Corner_index i : m_sectors.corners[s]) {
      const int g = m_charts.element(std::size_t(i));
      const Grid_value shift = grid.split(m_charts.shift(std::size_t(i), c));
      const std::int64_t in_chart = Group::sign(g, c) * (x - shift.base);
      if(!grid.is_representable(in_chart) || shift.offset != 0)
        return false;
      double& u = coordinates[std::size_t(i)][Group::source(g, c)];
      if(const double to = grid.value(in_chart); u != to) // a zero that stays one keeps its sign
        u = to;
    }
    return true;
  }

  const Flat_volume& m_volume;
  const Volume_charts& m_charts;
  const Volume_sectors& m_sectors;
  const Volume_places& m_places;
  const Volume_members& m_members;
  Sector_means m_means;
  Number_format m_format;
  Place_system m_system;
  Coordinate_classes m_classes;
  Linear_solver m_solver;
  std::vector<char> m_moves;     // per class, at its root: whether something is inexact
  std::vector<Grid> m_grids;     // likewise
  std::vector<std::int64_t> m_x; // per coordinate of a slot, in steps
  std::int64_t m_misfit = -1;    // the root of a class that needs a coarser grid
  int m_wanted_exponent = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SOLVER_H
