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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_UNTANGLER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_UNTANGLER_H

#include <CGAL/license/Seamless_snapping.h>

// Cells of a volume that are not positive, or not any more after snapping, become positive by exact
// moves of vertices, one at a time, with all their sectors, within their freedom: transitions,
// levels, and integers stay as they are.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

enum class Cells_to_untangle
{
  LOST,            // those with positive rest shapes; they keep even thin ones
  ALL,
  ALL_BY_ALL_MEANS // others may lose their orientation on the way
};

struct Volume_untangling
{
  Cells_to_untangle cells;
  std::size_t number_of_passes;
  std::size_t reach;     // layers of cells around these whose vertices move
  double largest_change = (std::numeric_limits<double>::infinity)(); // against the rest shape
};

// The cells that are positive in the one map, and not in the other.
inline std::vector<std::size_t> lost_cells(const std::vector<Uvw>& before,
                                           const std::vector<Uvw>& after)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < before.size() / 4; ++c) {
    const Uvw_tetrahedron u = uvw_of_cell(before, c), v = uvw_of_cell(after, c);
    if(u != v && orientation(v) != CGAL::POSITIVE && orientation(u) == CGAL::POSITIVE)
      result.push_back(c);
  }
  return result;
}

// Each move makes the distortion of the star of a vertex less, in which cells without positive
// volume weigh most: the energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray, and Sokolov
// (Foldover-free maps in 50 lines of code, 2021), vertex by vertex. Floating point proposes moves;
// orientations are decided exactly, and no cell loses its own.
class Volume_untangler
{
  using Group = Cube_rotations;
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

public:
  // \param rest the shapes that cells are to keep, per corner, where they are positive
  // \param coordinates of all corners; vertices of the volume that are fixed keep theirs
  Volume_untangler(const Volume_members& members, const Flat_volume& volume,
                   const std::vector<Uvw>& rest, const Number_format& format,
                   std::vector<Uvw>& coordinates)
    : m_members(members), m_volume(volume), m_rest(rest), m_format(format),
      m_coordinates(coordinates)
  { }

  // Passes over the vertices of cells to repair, and of layers of cells around them, which grow
  // where that does not help. Returns the number of passes. No cell loses its orientation, and
  // cells that are to keep their shapes move only if that repairs some.
  std::size_t run(const Volume_untangling& untangling)
  {
    constexpr std::size_t patience = 8, end_of_patience = 40; // passes without a cell repaired
    const std::vector<Uvw> before = m_coordinates;
    m_untangling = untangling;
    std::size_t passes = 0, reach = 1, idle = 0;
    const std::vector<std::size_t> bad_before = bad_cells();
    std::vector<std::size_t> bad = bad_before;
    std::size_t least = bad.size();
    while(!bad.empty() && passes < untangling.number_of_passes) {
      ++passes;
      Progress::tell_each_second([&] { return counted(bad.size(), "cell") + " to repair"; });
      choose_epsilon(bad);
      bool has_moved = false;
      for(const Member_index m : members_around(bad, reach))
        has_moved = improve(m) || has_moved;
      bad = bad_cells();
      idle = bad.size() < least ? 0 : idle + 1;
      least = (std::min)(least, bad.size());
      if(has_moved && idle % patience != patience - 1)
        continue;
      if(reach >= untangling.reach || idle >= end_of_patience)
        break;
      ++reach;
    }
    if(!std::includes(bad_before.begin(), bad_before.end(), bad.begin(), bad.end()) ||
       (keeps_near() && bad.size() == bad_before.size()))
      m_coordinates = before;
    return passes;
  }

private:
  std::vector<std::size_t> bad_cells() const
  {
    return keeps_near() ? lost_cells(m_rest, m_coordinates) : nonpositive_cells(m_coordinates);
  }

  bool keeps_near() const { return m_untangling.cells == Cells_to_untangle::LOST; }

  static bool is_positive(const Uvw_tetrahedron& u) { return orientation(u) == CGAL::POSITIVE; }

  bool may_lose() const { return m_untangling.cells == Cells_to_untangle::ALL_BY_ALL_MEANS; }

  // The more cells are inverted, the more they may weigh without bound.
  void choose_epsilon(const std::vector<std::size_t>& cells)
  {
    double least = 0;
    for(const std::size_t c : cells)
      least = (std::min)(least, (edges(uvw_of_cell(m_coordinates, c)) * rest_of(c).inverse())
                                  .determinant());
    m_epsilon = std::sqrt(1e-4 + 0.04 * least * least);
  }

  // In ascending order.
  std::vector<Member_index> members_around(const std::vector<std::size_t>& cells,
                                           const std::size_t reach) const
  {
    std::vector<char> is_reached(m_members.size(), 0);
    std::vector<Member_index> result;
    const auto add_members = [&](const std::size_t c) {
      for(std::size_t i = 4 * c; i < 4 * c + 4; ++i)
        if(m_volume.is_fixed[std::size_t(m_volume.vertices[i])] == 0) {
          const Member_index m = m_members.member_of_corner(Corner_index(i));
          if(std::exchange(is_reached[m], char(1)) == 0)
            result.push_back(m);
        }
    };
    for(const std::size_t c : cells)
      add_members(c);
    for(std::size_t layer = 1, begin = 0; layer < reach; ++layer) {
      const std::size_t end = result.size();
      for(; begin < end; ++begin)
        m_members.for_each_corner(result[begin], [&](std::size_t, const Corner_index i) {
          add_members(std::size_t(i / 4));
        });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // The data of a cell for the energy if a corner moves by d: its Jacobian becomes J + d g^T.
  struct Star_cell
  {
    Matrix jacobian;
    Vector slope;      // g
    Vector volume_slope;
    double volume;     // against the volume of the rest shape
    std::array<Vector, 3> directions; // moves of the corner, per unknown of the member
  };

  // Returns whether the vertex has moved.
  bool improve(const Member_index m)
  {
    constexpr double least_gain = 1e-3; // smaller ones hardly end
    const int dimension = m_members.freedom(m).dimension();
    if(dimension == 0)
      return false;
    const std::vector<Star_cell> star = star_of(m);
    const double epsilon = m_epsilon;
    const auto [least, largest] = range_of_moves(m);
    Vector z = Vector::Zero();
    double energy = energy_of(star, z, epsilon);
    const double first_energy = energy;
    for(int i = 0; i < 3; ++i) {
      const Vector step = newton_step(star, z, epsilon, dimension);
      double length = 1;
      for(; length > 1e-4; length /= 2) {
        const Vector to = (z + length * step).cwiseMax(least).cwiseMin(largest);
        if(const double next = energy_of(star, to, epsilon);
           next < energy && (may_lose() || keeps_volumes(star, to))) {
          z = to;
          energy = next;
          break;
        }
      }
      if(length <= 1e-4)
        break;
    }
    if(!(energy < (1 - least_gain) * first_energy))
      return false;
    for(int i = 0; i < 4; ++i, z /= 2) // where exact signs tell otherwise, a shorter one
      if(has_moved(m, z))
        return true;
    return false;
  }

  std::vector<Star_cell> star_of(const Member_index m) const
  {
    std::vector<Star_cell> star;
    m_members.for_each_corner(m, [&](const std::size_t slot, const Corner_index i) {
      const std::size_t c = std::size_t(i / 4);
      const Matrix rest = rest_of(c);
      const Matrix inverse = rest.inverse();
      Star_cell result;
      result.jacobian = edges(uvw_of_cell(m_coordinates, c)) * inverse;
      if(i % 4 == 0)
        result.slope = -inverse.colwise().sum().transpose();
      else
        result.slope = inverse.row(i % 4 - 1).transpose();
      const Matrix& j = result.jacobian;
      result.volume = j.determinant();
      Matrix cofactors;
      for(int k = 0; k < 3; ++k)
        cofactors.col(k) = j.col((k + 1) % 3).cross(j.col((k + 2) % 3));
      result.volume_slope = cofactors * result.slope;
      for(Vector& d : result.directions)
        d.setZero();
      for(std::size_t k = 0; k < 3; ++k)
        if(const Volume_members::Term t = m_members.term(m, slot, k); t.sign != 0)
          result.directions[t.unknown - m_members.first_unknown(m)][Eigen::Index(k)] = t.sign;
      star.push_back(result);
    });
    return star;
  }

  static Matrix edges(const Uvw_tetrahedron& u)
  {
    Matrix result;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t c = 0; c < 3; ++c)
        result(Eigen::Index(c), Eigen::Index(i)) = u[i + 1][c] - u[0][c];
    return result;
  }

  // The shape that the cell has in the input; a regular tetrahedron of about its size, if it is not
  // positive there or thin.
  Matrix rest_of(const std::size_t c) const
  {
    constexpr double least_volume = 1e-3; // against the third power of the size
    const Matrix rest = edges(uvw_of_cell(m_rest, c));
    const double size = rest.norm();
    const double least = keeps_near() ? 0 : least_volume;
    if(!may_lose() && rest.determinant() > least * size * size * size)
      return rest;
    Matrix regular;
    regular << 1, 1, 0,
               1, 0, 1,
               0, 1, 1; // a cell of negative orientation
    return -(size > 0 ? size : m_volume.extent * 1e-3) / regular.norm() * regular;
  }

  static Vector move(const Star_cell& c, const Vector& z)
  {
    return c.directions[0] * z[0] + c.directions[1] * z[1] + c.directions[2] * z[2];
  }

  static double regularized(const double volume, const double epsilon)
  {
    return (volume + std::sqrt(epsilon * epsilon + volume * volume)) / 2;
  }

  static double energy_of(const std::vector<Star_cell>& star, const Vector& z,
                          const double epsilon)
  {
    double result = 0;
    for(const Star_cell& c : star) {
      const Vector d = move(c, z);
      const double x = regularized(c.volume + d.dot(c.volume_slope), epsilon);
      const double v = c.volume + d.dot(c.volume_slope);
      result += (c.jacobian + d * c.slope.transpose()).squaredNorm() / 3 / std::cbrt(x * x) +
                (v * v + 1) / (2 * x);
    }
    return result;
  }

  // Whether cells that have positive volume keep it.
  static bool keeps_volumes(const std::vector<Star_cell>& star, const Vector& z)
  {
    for(const Star_cell& c : star)
      if(c.volume > 0 && !(c.volume + move(c, z).dot(c.volume_slope) > 0))
        return false;
    return true;
  }

  // With the positive part of second derivatives.
  static Vector newton_step(const std::vector<Star_cell>& star, const Vector& z,
                            const double epsilon, const int dimension)
  {
    Vector gradient = Vector::Zero();
    Matrix hessian = Matrix::Zero();
    for(const Star_cell& c : star) {
      const Vector d = move(c, z);
      const Matrix j = c.jacobian + d * c.slope.transpose();
      const double v = c.volume + d.dot(c.volume_slope), x = regularized(v, epsilon);
      const double dx = (1 + v / std::sqrt(epsilon * epsilon + v * v)) / 2;
      const double t = j.squaredNorm() / 3, power = 1 / std::cbrt(x * x);
      const double dt = power / 3;
      const double dv = -2. / 3 * t * power / x * dx + v / x - (v * v + 1) * dx / (2 * x * x);
      const double dvv = 10. / 9 * t * power / (x * x) * dx * dx +
                         1 / x + (v * v + 1) * dx * dx / (x * x * x);
      const Vector g = 2 * dt * j * c.slope + dv * c.volume_slope;
      const Matrix h = 2 * dt * c.slope.squaredNorm() * Matrix::Identity() +
                       dvv * c.volume_slope * c.volume_slope.transpose();
      for(int a = 0; a < dimension; ++a) {
        const Vector& p = c.directions[std::size_t(a)];
        gradient[a] += p.dot(g);
        for(int b = 0; b < dimension; ++b)
          hessian(a, b) += p.dot(h * c.directions[std::size_t(b)]);
      }
    }
    for(int a = dimension; a < 3; ++a)
      hessian(a, a) = 1;
    const Vector result = -hessian.ldlt().solve(gradient);
    return result.allFinite() ? result : Vector::Zero();
  }

  // Moves the vertex, unless the numbers do not hold the result, or a cell would lose its
  // orientation.
  bool has_moved(const Member_index m, const Vector& z)
  {
    return m_members.try_move(m, m_coordinates, [&] { return has_added(m, z); },
                              [&](const std::size_t c) {
                                return may_lose() || is_positive(uvw_of_cell(m_coordinates, c));
                              });
  }

  // Calls f(coordinate, coordinate at rest, unknown of the member, sign).
  template <typename F>
  void for_each_coordinate(const Member_index m, const F& f)
  {
    m_members.for_each_corner(m, [&](const std::size_t slot, const Corner_index i) {
      for(std::size_t c = 0; c < 3; ++c)
        if(const Volume_members::Term t = m_members.term(m, slot, c); t.sign != 0)
          f(m_coordinates[std::size_t(i)][c], m_rest[std::size_t(i)][c],
            t.unknown - m_members.first_unknown(m), t.sign);
    });
  }

  // The least and the largest move per unknown after which no coordinate has changed too much.
  std::pair<Vector, Vector> range_of_moves(const Member_index m)
  {
    const double infinity = (std::numeric_limits<double>::infinity)();
    std::pair<Vector, Vector> result(Vector::Constant(-infinity), Vector::Constant(infinity));
    for_each_coordinate(m, [&](const double u, const double rest, const std::size_t k,
                               const int sign) {
      double &least = result.first[Eigen::Index(k)], &largest = result.second[Eigen::Index(k)];
      const double change = sign * (u - rest);
      least = (std::max)(least, (std::min)(0., -m_untangling.largest_change - change));
      largest = (std::min)(largest, (std::max)(0., m_untangling.largest_change - change));
    });
    return result;
  }

  // Adds one number, with signs, to all coordinates of an unknown, if all sums are exact, and near
  // the rest shape. That number takes one of the coordinates to a grid on which the number type
  // holds all of them.
  bool has_added(const Member_index m, const Vector& z)
  {
    std::array<double, 3> largest{}, shift{};
    std::array<bool, 3> is_known{};
    for_each_coordinate(m, [&](const double u, double, const std::size_t k, int) {
      largest[k] = (std::max)(largest[k], std::abs(u) + std::abs(z[Eigen::Index(k)]));
    });
    for_each_coordinate(m, [&](const double u, double, const std::size_t k, const int sign) {
      if(is_known[k])
        return;
      const Grid grid = Grid::finest(m_format, largest[k]);
      is_known[k] = true;
      shift[k] = sign * (grid.value(nearest_integer(grid.in_steps(u + sign * z[Eigen::Index(k)]))) -
                         u);
    });
    bool is_exact = true;
    for_each_coordinate(m, [&](double& u, const double rest, const std::size_t k, const int sign) {
      const Exact_difference sum(u, -sign * shift[k]);
      is_exact = is_exact && sum.error == 0 &&
                 Grid::finest(m_format, largest[k]).split(sum.rounded).offset == 0 &&
                 std::abs(sum.rounded - rest) <= m_untangling.largest_change;
      u = sum.rounded;
    });
    return is_exact;
  }

  const Volume_members& m_members;
  const Flat_volume& m_volume;
  const std::vector<Uvw>& m_rest;
  Number_format m_format;
  std::vector<Uvw>& m_coordinates;
  Volume_untangling m_untangling{};
  double m_epsilon = 1;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_UNTANGLER_H
