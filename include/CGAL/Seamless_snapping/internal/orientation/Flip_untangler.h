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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FLIP_UNTANGLER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FLIP_UNTANGLER_H

#include <CGAL/license/Seamless_snapping.h>

// Removes flips that moves near by can't: by untangling under all constraints of the complex, and
// the exact solution near the result.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/orientation/Vertex_angles.h>
#include <CGAL/Seamless_snapping/internal/untangling/Constrained_triangles.h>
#include <CGAL/Seamless_snapping/internal/untangling/untangle.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The wanted shape of a face: the shape in the input, unless it is flipped or a sliver there. Then
// the shape has equal sides.
inline Reference_shape wanted_shape(const Domain_face& face)
{
  constexpr double thinnest = 0.05; // height, relative to the longest edge
  const Uv_triangle& t = face.input;
  const Uv first{{t[1][0] - t[0][0], t[1][1] - t[0][1]}};
  const Uv second{{t[2][0] - t[0][0], t[2][1] - t[0][1]}};
  double longest = std::hypot(second[0] - first[0], second[1] - first[1]);
  longest = (std::max)({longest, std::hypot(first[0], first[1]),
                        std::hypot(second[0], second[1])});
  const double doubled_area = first[0] * second[1] - first[1] * second[0];
  if(doubled_area >= thinnest * longest * longest)
    return Reference_shape(first, second);
  return Reference_shape({{longest, 0}}, {{longest / 2, longest * std::sqrt(0.75)}});
}

template <typename Group>
class Flip_untangler
{
public:
  Flip_untangler(const Movable_points<Group>& points, const Complex_solver<Group>& solver)
    : m_points(points), m_solver(solver)
  { }

  // Changes exact coordinates into others with fewer flips, if they are found.
  // \pre all faces were met
  // \param iterations over all faces that are allowed; receives the number that is left
  // \param without_area receives the number of faces that seams and alignments leave no area
  // \return whether the coordinates were changed: not where constraints link too many of them
  bool run(Uv_state& state, const Untangling how, std::size_t& iterations,
           std::size_t& without_area) const
  try {
    const Constrained_triangles map = constrained_triangles(state);
    without_area = std::size_t(
      std::count_if(map.triangles.begin(), map.triangles.end(),
                    [](const Constrained_triangles::Triangle& t) { return !t.can_have_area; }));
    Untangler<double> untangler(map);
    if(iterations == 0 || map.not_positive(untangler.unknowns()).empty())
      return false;
    const double used = std::ceil(untangler.run(double(iterations), how));
    iterations -= std::size_t((std::min)(double(iterations), used));
    const std::vector<double>& unknowns = untangler.unknowns();

    Uv_state solution;
    if(!m_solver.solve_shifted(shifts_to(map, unknowns), solution))
      return false;
    Uv_state result(solution);
    for(std::size_t p = 0; p < map.start.size(); ++p) {
      const Uv to = map.point(p, unknowns);
      m_points.set_uv(result, Point_index(p), {{rounded_to(m_solver.format(), to[0]),
                                                rounded_to(m_solver.format(), to[1])}});
    }
    // the others are of no constraint's concern
    m_solver.components().for_each_sector([&](const Sector_index s, const auto& components) {
      for(std::size_t c = 0; c < 2; ++c)
        if(components[c] >= 0)
          result[std::size_t(s)][c] = solution[std::size_t(s)][c];
    });
    state.swap(result);
    return true;
  } catch(const Refusal& refusal) {
    if(refusal.status != Outcome::TOO_LARGE)
      throw;
    return false;
  }

private:
  // The targets of sectors whose corners differ are their means.
  Target_shifts<Group> shifts_to(const Constrained_triangles& map,
                                 const std::vector<double>& unknowns) const
  {
    std::vector<Uv> targets(m_points.complex().coordinates);
    for(const auto& mixed : m_points.complex().mixed_sectors)
      for(std::size_t c = 0; c < 2; ++c)
        targets[std::size_t(mixed.sector)][c] += mixed.deviation[c];
    Target_shifts<Group> shifts;
    for(std::size_t s = 0; s < targets.size(); ++s) {
      const Uv to = map.point(s, unknowns), &from = targets[s];
      if(to != from)
        shifts[Sector_index(s)] = {{to[0] - from[0], to[1] - from[1]}};
    }
    return shifts;
  }

  Constrained_triangles constrained_triangles(const Uv_state& state) const
  {
    const Free_coordinates<Group> coordinates(m_points.complex());
    Constrained_triangles map;
    map.number_of_unknowns = coordinates.number_of_unknowns();
    for(std::size_t p = 0; p < m_points.stars().size(); ++p) {
      map.start.push_back(m_points.uv(state, Point_index(p)));
      if(m_points.is_sector(Point_index(p))) {
        map.rows.push_back({{coordinates.coordinate(p, 0), coordinates.coordinate(p, 1)}});
      } else {
        const std::size_t first = map.number_of_unknowns;
        map.rows.push_back({{Sparse_row{{first, 1.}}, Sparse_row{{first + 1, 1.}}}});
        map.number_of_unknowns += 2;
      }
    }
    for(std::size_t f = 0; f < m_points.stars().number_of_faces(); ++f) {
      const Domain_face& face = m_points.domain_face(Face_index(f));
      map.triangles.push_back({{{std::size_t(face.points[0]), std::size_t(face.points[1]),
                                 std::size_t(face.points[2])}}, wanted_shape(face)});
    }
    add_angles(map);
    const std::vector<double> zeros(map.number_of_unknowns, 0.);
    for(const std::size_t t : map.not_positive(zeros))
      map.triangles[t].can_have_area = can_have_area(map, t);
    return map;
  }

  // Seams and alignments can leave a triangle no area, whatever the unknowns are. Twice the area is
  // a polynomial of degree 2 in them: if it is not 0, it is so at one of 2^24 numbers with a
  // probability of 2^-23 at most.
  static bool can_have_area(const Constrained_triangles& map, const std::size_t t)
  {
    using Number = CGAL::Exact_rational;
    std::array<std::array<Number, 2>, 3> corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = map.triangles[t].points[i];
      for(std::size_t c = 0; c < 2; ++c) {
        corners[i][c] = Number(map.start[p][c]);
        for(const auto& [unknown, factor] : map.rows[p][c])
          corners[i][c] += Number(factor) * Number(any_number(unknown));
      }
    }
    return CGAL::sign_of_determinant<Number>(
             corners[1][0] - corners[0][0], corners[1][1] - corners[0][1],
             corners[2][0] - corners[0][0], corners[2][1] - corners[0][1]) != CGAL::ZERO;
  }

  static double any_number(const std::size_t unknown)
  {
    std::mt19937 random(static_cast<std::mt19937::result_type>(unknown));
    return static_cast<double>(random() % (1u << 24));
  }

  void add_angles(Constrained_triangles& map) const
  {
    const Vertex_angles<Group> angles(m_points);
    for(std::size_t p = 0; p < m_points.stars().size(); ++p)
      map.vertex.push_back(angles.vertex(Point_index(p)));
    std::vector<typename Vertex_angles<Group>::Input_sum> sums(
      m_points.complex().number_of_vertices() + map.start.size());
    for(std::size_t f = 0; f < m_points.stars().number_of_faces(); ++f) {
      const Domain_face& face = m_points.domain_face(Face_index(f));
      for(std::size_t k = 0; k < 3; ++k)
        angles.add(face, k, sums[map.vertex[std::size_t(face.points[k])]]);
    }
    for(const auto& sum : sums)
      map.angle.push_back(sum.value());
  }

  const Movable_points<Group>& m_points;
  const Complex_solver<Group>& m_solver;
};

// As Orientation_repair takes it.
template <typename Group, Untangling how>
bool untangle_flips(const Movable_points<Group>& points, const Complex_solver<Group>& solver,
                    Uv_state& state, std::size_t& iterations, std::size_t& faces_without_area)
{
  return Flip_untangler<Group>(points, solver).run(state, how, iterations, faces_without_area);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FLIP_UNTANGLER_H
