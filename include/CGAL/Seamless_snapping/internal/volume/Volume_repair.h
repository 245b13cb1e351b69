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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_REPAIR_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_REPAIR_H

#include <CGAL/license/Seamless_snapping.h>

// Cells that the closest exact solution turns over, or makes degenerate, get their orientation back
// where one of their vertices can move: alone, with all its sectors, on the grid.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/linear/nonnegative_program.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_solver.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A program is a dense matrix: vertices of more cells stay.
constexpr std::size_t largest_number_of_cells_at_moved_vertex = 2000;

// Orientations are decided exactly. Floating point only proposes moves: the shortest one after
// which the cells at a vertex keep a part of their volumes.
class Volume_repair
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;
  using Move = std::array<std::int64_t, 3>; // in steps, per coordinate of the first slot

public:
  Volume_repair(const Flat_volume& input, const Volume_structure& structure,
                const Place_solver& solver, std::vector<Uvw>& coordinates)
    : m_volume(input), m_charts(structure.charts), m_members(structure.members),
      m_solver(solver), m_coordinates(coordinates)
  {
    int exponent = 0;
    std::frexp(input.extent, &exponent);
    m_scale = std::ldexp(1., -exponent); // keeps determinants in range
  }

  // The cells that were positive in the input, and are not any more.
  std::vector<std::size_t> lost_cells() const
  {
    std::vector<std::size_t> result;
    for(std::size_t c = 0; c < m_volume.number_of_cells(); ++c)
      if(is_lost(c))
        result.push_back(c);
    return result;
  }

  // Tries each vertex of each cell once, as long as the work for programs lasts.
  // \param largest_change of a coordinate, against the input
  void run(const std::vector<std::size_t>& lost, const double largest_change)
  {
    m_largest_change = largest_change;
    for(const std::size_t c : lost)
      for(std::size_t i = 4 * c; i < 4 * c + 4 && is_lost(c); ++i)
        if(m_volume.is_fixed[std::size_t(m_volume.vertices[i])] == 0)
          improve(m_members.member_of_corner(Corner_index(i)));
  }

private:
  bool is_lost(const std::size_t c) const
  {
    const Uvw_tetrahedron before = uvw_of_cell(m_volume.coordinates, c);
    const Uvw_tetrahedron now = uvw_of_cell(m_coordinates, c);
    if(before == now)
      return false;
    return orientation(now) != CGAL::POSITIVE && orientation(before) == CGAL::POSITIVE;
  }

  std::size_t number_of_lost_cells(const Member_index member) const
  {
    std::size_t result = 0;
    m_members.for_each_corner(member, [&](std::size_t, const Corner_index i) {
      result += std::size_t(is_lost(std::size_t(i / 4)));
    });
    return result;
  }

  // Tries moves that leave the cells more of their volumes or less; keeps the first one that helps
  // and costs no other cell its orientation.
  void improve(const Member_index member)
  {
    const Place& place = m_members.place(member);
    std::size_t number_of_cells = 0;
    m_members.for_each_corner(member, [&](std::size_t, Corner_index) { ++number_of_cells; });
    if(number_of_cells > largest_number_of_cells_at_moved_vertex)
      return;
    const Place_freedom& freedom = m_members.freedom(member);
    std::vector<std::size_t> directions;
    for(std::size_t c = 0; c < 3; ++c) // places without constraints also off the grid
      if(freedom.first[c] == int(c) &&
         (!place.is_constrained() || m_solver.moves(m_members.column(member, 0, c))))
        directions.push_back(c);
    if(directions.empty())
      return;
    for(const double part : {0.5, 0.1, 0.01}) {
      const Move move = proposed_move(member, freedom, directions, part);
      const std::size_t lost = number_of_lost_cells(member);
      if(m_members.try_move(
           member, m_coordinates,
           [&] { return apply(member, freedom, move) && number_of_lost_cells(member) < lost; },
           [&](const std::size_t c) { return !is_lost(c); }))
        return;
    }
  }

  // Moves the corners of a member. Returns false if the number type does not hold the result, or it
  // is far from the input.
  bool apply(const Member_index member, const Place_freedom& freedom, const Move& move)
  {
    bool is_good = true;
    m_members.for_each_corner(member, [&](const std::size_t slot, const Corner_index corner) {
      const std::size_t i = std::size_t(corner);
      const Move turned = Group::apply(element(freedom, slot, i), move);
      for(std::size_t c = 0; c < 3; ++c) {
        if(turned[c] == 0)
          continue;
        const Grid& grid =
          m_solver.grid(m_members.column(member, slot, m_charts.column(i, c)));
        const std::int64_t x = grid.split(m_coordinates[i][c]).base + turned[c];
        is_good = is_good && grid.is_representable(x);
        if(is_good)
          m_coordinates[i][c] = grid.value(x);
        is_good = is_good && std::abs(m_coordinates[i][c] - m_volume.coordinates[i][c]) <=
                               m_largest_change;
      }
    });
    return is_good;
  }

  // From the first slot of a place to the chart of a corner's cell.
  int element(const Place_freedom& freedom, const std::size_t slot, const std::size_t corner) const
  {
    return Group::compose(Group::inverse(m_charts.element(corner)), freedom.rotation[slot]);
  }

  // How the volume of a cell grows as a corner moves.
  Uvw gradient(const std::size_t corner) const
  {
    const Uvw_tetrahedron u = uvw_of_cell(m_coordinates, corner / 4);
    std::array<Uvw, 3> e;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t c = 0; c < 3; ++c)
        e[i][c] = m_scale * (u[i + 1][c] - u[0][c]);
    return facet_normals(e)[corner % 4];
  }

  double volume(const std::vector<Uvw>& u, const std::size_t c) const
  {
    return six_times_volume(uvw_of_cell(u, c), m_scale);
  }

  // The shortest move after which all cells have at least a part of their former volumes, by the
  // dual of that quadratic program.
  Move proposed_move(const Member_index member, const Place_freedom& freedom,
                     const std::vector<std::size_t>& directions, const double part)
  {
    const Eigen::Index dimension = Eigen::Index(directions.size());
    Eigen::MatrixXd a(Eigen::Index(largest_number_of_cells_at_moved_vertex), dimension);
    Eigen::VectorXd b(a.rows());
    Eigen::Index n = 0;
    m_members.for_each_corner(member, [&](const std::size_t slot, const Corner_index corner) {
      const std::size_t i = std::size_t(corner);
      const double before = volume(m_volume.coordinates, i / 4);
      if(before < 0) // has nothing to lose
        return;
      const Uvw slope = Group::apply(Group::inverse(element(freedom, slot, i)), gradient(i));
      Eigen::VectorXd row = Eigen::VectorXd::Zero(dimension);
      for(Eigen::Index d = 0; d < dimension; ++d)
        for(std::size_t c = 0; c < 3; ++c)
          if(freedom.first[c] == int(directions[std::size_t(d)]))
            row[d] += freedom.sign[c] * slope[c];
      const double length = row.norm();
      if(length > 0) {
        a.row(n) = (row / length).transpose();
        b[n++] = (part * before - volume(m_coordinates, i / 4)) / length;
      }
    });
    a.conservativeResize(n, Eigen::NoChange);
    b.conservativeResize(n);
    Move move{};
    const double unit = n == 0 ? 0 : b.maxCoeff(); // brings multipliers near 1
    if(!(unit > 0))
      return move;
    const Eigen::VectorXd y =
      unit * (a.transpose() * minimize_nonnegative(a * a.transpose(), b / unit,
                                                       m_multiplications));
    for(Eigen::Index d = 0; d < dimension; ++d) {
      const std::size_t first = directions[std::size_t(d)];
      const double steps = m_solver.grid(m_members.column(member, 0, first))
                             .in_steps(y[d] / m_scale);
      if(!(std::abs(steps) < machine_integer_bound / 4))
        return Move{};
      for(std::size_t c = 0; c < 3; ++c)
        if(freedom.first[c] == int(first))
          move[c] = freedom.sign[c] * nearest_integer(steps);
    }
    return move;
  }

  const Flat_volume& m_volume;
  const Volume_charts& m_charts;
  const Volume_members& m_members;
  const Place_solver& m_solver;
  double m_largest_change = 0;
  std::vector<Uvw>& m_coordinates; // per corner
  double m_scale = 1;
  double m_multiplications = 1e9; // that programs may still take
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_REPAIR_H
