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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_PLACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_PLACES_H

#include <CGAL/license/Seamless_snapping.h>

// Integers for all translations of sheets and all levels, near those of a map, that agree: the
// system of places is solved on the grid of the integers. Rounding each on its own would contradict
// itself where sheets meet.

#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_system.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_members.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the system is eliminated. After `solve()`, what the slots hold meets all constraints,
// and so does each place that is moved within its freedom: translations and levels are integers,
// and coordinates that can't move, as those across a singular curve.
class Integer_places
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;

public:
  Integer_places(const Volume_sectors& sectors, const Volume_places& places,
                 const Volume_members& members, const Number_format& format)
    : m_sectors(sectors), m_places(places), m_members(members), m_integers(format, 0),
      m_system(sectors, places),
      m_solver(m_system.rows(), m_system.weights(), format, m_system.weights().size(), false)
  { }

  const Linear_solver& linear_solver() const { return m_solver; }

  // \param u per corner
  // Returns false if the number type does not hold the integers.
  bool solve(const std::vector<Uvw>& u)
  {
    Linear_target target{std::vector<Grid>(m_solver.number_of_components(), m_integers),
                         targets(u)};
    Linear_solution solution;
    if(m_solver.solve(target, solution) >= 0)
      return false;
    for(const Grid& grid : solution.grids)
      if(grid.exponent() != 0)
        return false;
    m_x.swap(solution.x);
    for(std::size_t j = 0; j < m_x.size(); ++j)
      if(m_solver.component(Column_index(j)) < 0 && !m_integers.nearest(target.values[j], m_x[j]))
        return false;
    return true;
  }

  // Coordinate c of the sector of a corner, in all members alike.
  std::int64_t operator()(const Corner_index corner, const std::size_t c) const
  {
    const Place& place = m_members.place(m_members.member_of_corner(corner));
    return m_x[3 * (place.first_slot + m_members.slot_of_corner(corner)) + c];
  }

private:
  // The means of the members, moved so that coordinates of the first slot are 0 where they are
  // free: else their rounding would disturb that of the others.
  std::vector<Grid_value> targets(const std::vector<Uvw>& u) const
  {
    std::vector<Grid_value> result;
    std::vector<Uvw> means;
    Member_index first_member = 0;
    for(const Place& place : m_places.places) {
      mean_of_slots(place, u, means);
      const Place_freedom& freedom = m_members.freedom(first_member);
      const Uvw first = means.front();
      for(std::size_t slot = 0; slot < place.number_of_slots; ++slot)
        for(std::size_t c = 0; c < 3; ++c) {
          const std::size_t source = Group::source(freedom.rotation[slot], c);
          double x = means[slot][c];
          if(const int free = freedom.first[source]; free >= 0)
            x -= Group::sign(freedom.rotation[slot], c) * freedom.sign[source] *
                 first[std::size_t(free)];
          result.push_back(m_integers.split(x));
        }
      first_member += place.number_of_members();
    }
    return result;
  }

  // The corners of a sector are in one place, or nearly so: one of them is enough here.
  void mean_of_slots(const Place& place, const std::vector<Uvw>& u,
                     std::vector<Uvw>& means) const
  {
    means.assign(place.number_of_slots, Uvw());
    for(std::size_t i = 0; i < place.members.size(); ++i) {
      const Uvw& x = u[std::size_t(m_sectors.corners[place.members[i]].front())];
      const Uvw& first = // digits are lost less relative to the first
        u[std::size_t(m_sectors.corners[place.members[i % place.number_of_slots]].front())];
      for(std::size_t c = 0; c < 3; ++c)
        means[i % place.number_of_slots][c] += x[c] - first[c];
    }
    for(std::size_t slot = 0; slot < place.number_of_slots; ++slot)
      for(std::size_t c = 0; c < 3; ++c) {
        double& mean = means[slot][c];
        mean = mean / static_cast<double>(place.number_of_members()) +
               u[std::size_t(m_sectors.corners[place.members[slot]].front())][c];
      }
  }

  const Volume_sectors& m_sectors;
  const Volume_places& m_places;
  const Volume_members& m_members;
  Grid m_integers;
  Place_system m_system;
  Linear_solver m_solver;
  std::vector<std::int64_t> m_x; // per coordinate of a slot
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_INTEGER_PLACES_H
