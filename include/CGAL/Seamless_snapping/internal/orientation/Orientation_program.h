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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_PROGRAM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_PROGRAM_H

#include <CGAL/license/Seamless_snapping.h>

// The exact solution nearest to the input, among those that keep some faces positive: for what
// single vertices can't repair, such as slivers at cones. A quadratic program over all sectors and
// the vertices of these faces, with one linearized condition per face. In its dual, the multipliers
// of the conditions are forces that shift the targets of the faces' corners; so the program has
// only as many unknowns as faces, needs no neighborhood to be chosen, and the ordinary exact
// solution for the shifted targets takes its solution to the grid.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/nonnegative_program.h>
#include <CGAL/Seamless_snapping/internal/complex/Displacements.h>
#include <CGAL/Seamless_snapping/internal/orientation/Kernel_moves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
class Orientation_program
{
  using Vectors = Sparse_vectors<Group>;
  using Response = typename Displacements<Group>::Response;

public:
  // \param optimum the exact solution for targets that are not shifted
  Orientation_program(const Movable_points<Group>& points, const Complex_solver<Group>& solver,
                      Uv_state optimum)
    : m_points(points)
    , m_solver(solver)
    , m_optimum(std::move(optimum))
    , m_unit(solver.coarsest_step())
    , m_displacements(points.complex(), solver)
  { }

  // \param margin the part of its wanted area that each face is to have
  // \param at where the conditions are linearized
  // \param forces receives the multiplier of each face
  // \param work see `minimize_nonnegative()`
  bool solve(const std::vector<Face_index>& active, const double margin, const Uv_state& at,
             Uv_state& result, Eigen::VectorXd& forces, double& work)
  {
    std::vector<Condition> conditions;
    for(const Face_index f : active)
      conditions.push_back(condition(f, margin, at));
    const Eigen::Index n = Eigen::Index(conditions.size());
    Eigen::MatrixXd s(n, n);
    Eigen::VectorXd missing(n);
    for(Eigen::Index j = 0; j < n; ++j) {
      missing[j] = conditions[std::size_t(j)].missing;
      const Response response = m_displacements(conditions[std::size_t(j)].force);
      for(Eigen::Index i = 0; i < n; ++i)
        s(i, j) = change(conditions[std::size_t(i)], response);
    }
    s = (0.5 * (s + s.transpose())).eval();
    s.diagonal().array() += 1e-9; // of lengths 1; for conditions that exclude each other
    forces = minimize_nonnegative(s, missing, work);
    if(!forces.allFinite())
      return false;
    Vectors shift(m_shift);
    for(Eigen::Index i = 0; i < n; ++i)
      for(const auto& p : conditions[std::size_t(i)].force)
        add(shift, p.first, {{forces[i] * p.second[0], forces[i] * p.second[1]}});
    Target_shifts<Group> shifts; // of sectors
    for(const auto& p : shift)
      if(m_points.is_sector(p.first))
        shifts[p.first] = {{p.second[0] * m_unit, p.second[1] * m_unit}};
    if(!m_solver.solve_shifted(shifts, result))
      return false;
    set_free_coordinates(shift, result);
    m_last_shift = std::move(shift);
    return true;
  }

  const Uv_state& start() const { return m_optimum; }

  // Lets further programs start from the last solution: its faces are so many that they come in
  // turns.
  void start_from(const Uv_state& solution)
  {
    m_shift = m_last_shift;
    m_optimum = solution;
  }

private:
  // form . displacement >= missing, for displacements from the optimum in units. The force is the
  // gradient of the form, by which targets are shifted; it has length 1.
  struct Condition
  {
    Vectors form, force;
    double missing;
  };

  static void add(Vectors& vectors, const Point_index p, const Uv& d)
  {
    for(auto& v : vectors)
      if(v.first == p) {
        v.second = {{v.second[0] + d[0], v.second[1] + d[1]}};
        return;
      }
    vectors.emplace_back(p, d);
  }

  Condition condition(const Face_index f, const double margin, const Uv_state& at) const
  {
    const Domain_face& face = m_points.domain_face(f);
    const Uv_triangle now = m_points.triangle(at, face);
    Condition result;
    double by_rounding = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const Uv& a = now[(i + 1) % 3];
      const Uv& b = now[(i + 2) % 3];
      const Uv g{{(a[1] - b[1]) / m_unit, (b[0] - a[0]) / m_unit}};
      by_rounding += std::sqrt(dot(g, g)) * (m_points.spacing(face.points[i]) / m_unit);
      add(result.form, face.points[i], g);
    }
    const double wanted = wanted_area<Group>(face.input, face.was_positive, m_unit);
    result.missing = (std::max)(margin * wanted, by_rounding) - twice_area(now, m_unit);
    double square = 0;
    for(const auto& g : result.form) {
      const Uv &here = m_points.uv(at, g.first), &there = m_points.uv(m_optimum, g.first);
      result.missing += dot(g.second, {{(here[0] - there[0]) / m_unit,
                                        (here[1] - there[1]) / m_unit}});
      square += dot(g.second, Group::gradient(g.second));
    }
    const double length = square > 0 ? std::sqrt(square) : 1;
    result.missing /= length;
    for(auto& g : result.form) {
      g.second = {{g.second[0] / length, g.second[1] / length}};
      result.force.emplace_back(g.first, Group::gradient(g.second));
    }
    return result;
  }

  double change(const Condition& condition, const Response& response) const
  {
    double result = 0;
    for(const auto& g : condition.form)
      result += dot(g.second, m_displacements(response, g.first));
    return result;
  }

  // What no equation determines moves with its target.
  void set_free_coordinates(const Vectors& shift, Uv_state& result) const
  {
    for(std::size_t i = 0; i < shift.size(); ++i) {
      const Point_index p = shift[i].first;
      Uv u = m_points.uv(std::size_t(p) < result.size() ? result : m_optimum, p);
      for(std::size_t c = 0; c < 2; ++c) {
        const double done = i < m_shift.size() ? m_shift[i].second[c] : 0; // by the optimum
        if(!m_displacements.is_dependent(p, c))
          u[c] = rounded_to(m_solver.format(), m_points.uv(m_optimum, p)[c] +
                                                 (shift[i].second[c] - done) * m_unit);
      }
      m_points.set_uv(result, p, u);
    }
  }

  const Movable_points<Group>& m_points;
  const Complex_solver<Group>& m_solver;
  Uv_state m_optimum; // that programs start from
  Vectors m_shift;    // its targets, in units
  Vectors m_last_shift; // of the last solution
  double m_unit;
  Displacements<Group> m_displacements;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_PROGRAM_H
