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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_ROUNDING_DISPLACEMENT_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_ROUNDING_DISPLACEMENT_H

#include <CGAL/license/Seamless_snapping.h>

// The displacement that takes a map to rounded translations and levels and is as even as possible:
// of least Dirichlet energy in the domain, in floating point. What is made of it is exact anyway.

#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_system.h>
#include <CGAL/Seamless_snapping/internal/volume/Separated_integers.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Integers for all translations of sheets and all levels, near the values of a map, that agree: the
// system of places is solved on the grid of the integers. Rounding each on its own would contradict
// itself where sheets meet.
// Invariant: the system is eliminated. After `solve()`, what the slots hold meets all constraints,
// and so does each place that is moved within its freedom: translations and levels are integers,
// and coordinates that can't move, such as coordinates across a singular curve.
class Integer_places
{
  using Group = Cube_rotations;

public:
  Integer_places(const Volume_structure& structure, const Number_format& format)
    : m_structure(structure), m_integers(format, 0), m_system(structure),
      m_solver(m_system.rows(), m_system.weights(), format, m_system.weights().size(), false)
  { }

  const Linear_solver& linear_solver() const { return m_solver; }

  // \param u per corner
  // \param separations differences that are to be at least 1
  // \param ties of charts whose translations are integers
  // Returns false if the number type does not hold the integers.
  bool solve(const std::vector<Uvw>& u, const std::vector<Separation>& separations,
             const Chart_ties& ties)
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
    std::vector<double> values;
    for(const Grid_value& v : target.values)
      values.push_back(static_cast<double>(v.base) + v.offset);
    m_number_of_joined =
      separate_integers(m_system.rows(), ties, m_system.weights(), values, separations, m_x);
    return true;
  }

  // Differences that are below 1.
  std::size_t number_of_joined() const { return m_number_of_joined; }

  // Coordinate c of the sector of a corner, in all members alike.
  std::int64_t operator()(const Corner_index corner, const std::size_t c) const
  {
    return m_x[m_structure.members.column(corner, c)];
  }

private:
  // The means of the members, moved so that coordinates of the first slot are 0 where they are
  // free: else their rounding would disturb the rounding of the others.
  std::vector<Grid_value> targets(const std::vector<Uvw>& u) const
  {
    const Sector_means means(u, m_structure);
    std::vector<Grid_value> result;
    Member_index first_member = 0;
    for(const Volume_places::Place& place : m_structure.places.places) {
      const Place_freedom& freedom = m_structure.members.freedom(first_member);
      std::array<Grid_value, 3> first;
      for(std::size_t slot = 0; slot < place.number_of_slots; ++slot)
        for(std::size_t c = 0; c < 3; ++c) {
          Grid_value x = means(place, slot, c, m_integers);
          if(slot == 0) // which is turned by the identity
            first[c] = x;
          const int g = freedom.rotation[slot];
          const std::size_t source = Group::source(g, c);
          if(const int free = freedom.first[source]; free >= 0) {
            const Grid_value& f = first[std::size_t(free)];
            const int sign = Group::sign(g, c) * freedom.sign[source];
            x = {x.base - sign * f.base, x.offset - sign * f.offset};
          }
          result.push_back(x);
        }
      first_member += place.number_of_members();
    }
    return result;
  }

  const Volume_structure& m_structure;
  Grid m_integers;
  Place_system m_system;
  Linear_solver m_solver;
  std::vector<std::int64_t> m_x; // per coordinate of a slot
  std::size_t m_number_of_joined = 0;
};

// Invariant: a corner's coordinate is to move by a base, and by the move of its member. The moves
// are those that come nearest to the map, until `spread()` makes them even.
class Rounding_displacement
{
  using Values = std::vector<double>;

public:
  // \param u per corner
  Rounding_displacement(const Volume_structure& structure, const Integer_places& integers,
                        const std::vector<Uvw>& u)
    : m_bases(u.size()), m_terms(u.size()), m_moves(structure.members.number_of_unknowns(), 0)
  {
    for(std::size_t i = 0; i < u.size(); ++i) {
      const Corner_index corner = Corner_index(i);
      for(std::size_t c = 0; c < 3; ++c) {
        m_bases[i][c] = static_cast<double>(integers(corner, c)) - u[i][c];
        m_terms[i][c] = structure.members.term(corner, c);
      }
    }
    move_near(structure.members, structure.sectors);
    for(std::size_t i = 0; i < u.size(); i += 4)
      m_weights.push_back(weights_of_cell(&u[i]));
  }

  // The moves of members, per unknown.
  const Values& moves() const { return m_moves; }

  // By conjugate gradients; ends after so many iterations.
  static constexpr int largest_number_of_iterations = 2000;
  void spread()
  {
    constexpr double precision = 1e-4;
    Values diagonal(m_moves.size(), 0), residual(m_moves.size(), 0), image;
    for(std::size_t i = 0; i < m_bases.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        if(m_terms[i][c].sign != 0)
          diagonal[m_terms[i][c].unknown] += weight_of_corner(i);
    for(double& d : diagonal)
      d = d > 0 ? d : 1;
    add_gradient(m_moves, true, residual);
    for(double& r : residual)
      r = -r;
    Values direction(residual.size());
    for(std::size_t j = 0; j < residual.size(); ++j)
      direction[j] = residual[j] / diagonal[j];
    double size = product(residual, direction);
    const double end = precision * precision * size;
    for(int i = 0; i < largest_number_of_iterations && size > end; ++i) {
      image.assign(residual.size(), 0);
      add_gradient(direction, false, image);
      const double step = size / product(direction, image);
      if(!std::isfinite(step))
        return;
      double next_size = 0;
      for(std::size_t j = 0; j < residual.size(); ++j) {
        m_moves[j] += step * direction[j];
        residual[j] -= step * image[j];
        next_size += residual[j] * residual[j] / diagonal[j];
      }
      for(std::size_t j = 0; j < residual.size(); ++j)
        direction[j] = residual[j] / diagonal[j] + next_size / size * direction[j];
      size = next_size;
    }
  }

  double energy() const
  {
    double result = 0;
    for(std::size_t c = 0; c < m_weights.size(); ++c)
      for(std::size_t k = 0; k < 3; ++k)
        for_each_edge(c, [&](const std::size_t i, const std::size_t j, const double weight) {
          const double d = value(m_moves, true, i, k) - value(m_moves, true, j, k);
          result += weight * d * d / 2;
        });
    return result;
  }

private:
  using Weights = std::array<double, 6>; // per edge of a cell

  // Each sector of a member counts once.
  void move_near(const Volume_members& members, const Volume_sectors& sectors)
  {
    for(Member_index m = 0; m < members.size(); ++m) {
      std::array<double, 3> sum{}, count{};
      const std::size_t first = members.first_unknown(m);
      members.for_each_corner(m, [&](const std::size_t slot, const Corner_index i) {
        const Sector_number s = members.sector(m, slot);
        const double weight = 1 / static_cast<double>(sectors.corners[s].size());
        for(std::size_t c = 0; c < 3; ++c)
          if(const Volume_members::Term& t = m_terms[std::size_t(i)][c]; t.sign != 0) {
            sum[t.unknown - first] -= weight * t.sign * m_bases[std::size_t(i)][c];
            count[t.unknown - first] += weight;
          }
      });
      for(std::size_t k = 0; k < 3; ++k)
        if(count[k] > 0)
          m_moves[first + k] = sum[k] / count[k];
    }
  }

  // The cotangent weights of the six edges; weights of thin cells are bounded.
  static Weights weights_of_cell(const Uvw* const u)
  {
    constexpr double least_volume = 1e-4; // against the third power of the size
    std::array<Uvw, 3> e;
    double size = 0;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t c = 0; c < 3; ++c) {
        e[i][c] = u[i + 1][c] - u[0][c];
        size = (std::max)(size, std::abs(e[i][c]));
      }
    if(!(size > 0))
      return {};
    for(Uvw& edge : e)
      for(double& x : edge)
        x /= size;
    const std::array<Uvw, 4> n = facet_normals(e); // without scale
    const double volume = inner_product(e[0], n[1]);
    const double scale = size / (std::max)(std::abs(volume), least_volume);
    Weights result{};
    std::size_t edge = 0;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = i + 1; j < 4; ++j, ++edge)
        for(std::size_t c = 0; c < 3; ++c)
          result[edge] -= scale * n[i][c] * n[j][c];
    return result;
  }

  // Calls f(i, j, weight) for the corners of the edges of a cell.
  template <typename F>
  void for_each_edge(const std::size_t cell, const F& f) const
  {
    std::size_t edge = 0;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = i + 1; j < 4; ++j, ++edge)
        f(4 * cell + i, 4 * cell + j, m_weights[cell][edge]);
  }

  double weight_of_corner(const std::size_t corner) const
  {
    double result = 0;
    for_each_edge(corner / 4, [&](const std::size_t i, const std::size_t j, const double weight) {
      result += i == corner || j == corner ? weight : 0;
    });
    return result;
  }

  double value(const Values& moves, const bool with_base, const std::size_t i,
               const std::size_t c) const
  {
    const Volume_members::Term& t = m_terms[i][c];
    return (with_base ? m_bases[i][c] : 0) + (t.sign != 0 ? t.sign * moves[t.unknown] : 0);
  }

  void add_gradient(const Values& moves, const bool with_base, Values& gradient) const
  {
    for(std::size_t cell = 0; cell < m_weights.size(); ++cell)
      for(std::size_t c = 0; c < 3; ++c) {
        std::array<double, 4> x, slope{};
        for(std::size_t i = 0; i < 4; ++i)
          x[i] = value(moves, with_base, 4 * cell + i, c);
        for_each_edge(cell, [&](const std::size_t i, const std::size_t j, const double weight) {
          const double d = weight * (x[i % 4] - x[j % 4]);
          slope[i % 4] += d;
          slope[j % 4] -= d;
        });
        for(std::size_t i = 0; i < 4; ++i)
          if(const Volume_members::Term& t = m_terms[4 * cell + i][c]; t.sign != 0)
            gradient[t.unknown] += t.sign * slope[i];
      }
  }

  static double product(const Values& a, const Values& b)
  { return std::inner_product(a.begin(), a.end(), b.begin(), 0.); }

  std::vector<Uvw> m_bases;                                   // per corner
  std::vector<std::array<Volume_members::Term, 3> > m_terms;  // per corner
  std::vector<Weights> m_weights;                             // per cell
  Values m_moves;                                             // per unknown
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_ROUNDING_DISPLACEMENT_H
