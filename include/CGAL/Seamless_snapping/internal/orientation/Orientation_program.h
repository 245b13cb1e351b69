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

// The exact solution nearest to the input that keeps some faces positive. It repairs faces that
// moves of single vertices can't repair, such as slivers at cones. A quadratic program over all
// sectors and the vertices of these faces, with one linearized condition per face. In its dual, the
// multipliers of the conditions are forces that shift the targets of the faces' corners; so the
// program has only as many unknowns as faces, needs no neighborhood to be chosen, and the ordinary
// exact solution for the shifted targets takes its solution to the grid.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/nonnegative_program.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/orientation/Kernel_moves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// How the least-squares optimum of all sectors follows shifts of the targets of some: the linear
// part of the solution, in real numbers. For shifts of few sectors the displacement of any sector
// takes constant time, once the reduced system has answered.

// Shifts, or gradients, of a few sectors and other points.
template <typename Group>
using Sparse_vectors =
  std::vector<std::pair<Sector_index, typename Cut_complex<Group>::Vector> >;

template <typename Group>
class Displacements
{
  using Vector = typename Cut_complex<Group>::Vector;
  static constexpr std::size_t dimension = Group::dimension;

public:
  // The effect of a shift of targets.
  struct Response
  {
    Sparse_vectors<Group> shift;
    std::vector<double> unknowns; // displacements of the reduced system's
  };

  Displacements(const Cut_complex<Group>& complex, const Complex_solver<Group>& solver)
    : m_solver(solver), m_system(solver.system()), m_roles(complex.number_of_sectors())
  {
    for(std::size_t s = 0; s < m_roles.size(); ++s)
      if(m_system.unknown(Sector_index(s)) >= 0)
        m_roles[s] = {Role::NODE, m_system.unknown(Sector_index(s)), -1, Group::identity(), 0};
    for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
      for(const auto& pair : complex.inner_pairs(b)) {
        const Column_index t = m_system.translation(b);
        m_roles[std::size_t(pair.plus)] = {Role::PLUS, t, pair.minus, complex.element[b], 0};
        m_roles[std::size_t(pair.minus)] = {Role::MINUS, t, pair.plus, complex.element[b], 0};
      }
    for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
      for(const Sector_index s : complex.inner_links(c))
        m_roles[std::size_t(s)] = {Role::LINK, m_system.level(c), -1, Group::identity(),
                                   complex.functional[c]};
  }

  Response operator()(const Sparse_vectors<Group>& shift) const
  {
    std::vector<double> reduced(m_system.weights().size(), 0.);
    for(const auto& s : shift)
      add_to_reduced(s.first, s.second, reduced);
    return {shift, m_solver.linear_solver().displacements(reduced)};
  }

  Vector operator()(const Response& response, const Sector_index p) const
  {
    const Vector own = shift_of(response, p);
    const Role role = this->role(p);
    switch(role.kind) {
    case Role::FREE: break;
    case Role::NODE: return unknown(response, role);
    case Role::LINK: return link_displacement(response, own, role);
    case Role::PLUS: return plus_displacement(response, p, role);
    case Role::MINUS: {
      const Vector plus = plus_displacement(response, role.partner, this->role(role.partner));
      return sum(Group::apply(role.element, plus), unknown(response, role), 1);
    }
    }
    return own;
  }

  // Whether the coordinate is computed from others, so that it can't be set by itself.
  bool is_dependent(const Sector_index p, const std::size_t c) const
  {
    const Role role = this->role(p);
    switch(role.kind) {
    case Role::FREE: break;
    case Role::NODE: return m_solver.linear_solver().component(role.column + Column_index(c)) >= 0;
    case Role::LINK: return Group::shortest_at_level_1(role.functional)[c] != 0;
    case Role::PLUS:
    case Role::MINUS: return true;
    }
    return false;
  }

private:
  // Nodes are unknowns; the sectors between them come in pairs beside a cut, or are links of a
  // chain.
  struct Role
  {
    enum Kind { FREE, NODE, PLUS, MINUS, LINK };
    Kind kind = FREE;
    Column_index column = -1; // its own unknown, or the unknown of the branch or chain
    Sector_index partner = -1;
    typename Group::Element element = Group::identity(); // from plus to minus
    int functional = 0;
  };

  Role role(const Sector_index p) const
  {
    return std::size_t(p) < m_roles.size() ? m_roles[std::size_t(p)] : Role();
  }

  static Vector shift_of(const Response& response, const Sector_index p)
  {
    for(const auto& s : response.shift)
      if(s.first == p)
        return s.second;
    return Vector{};
  }

  static Vector sum(Vector a, const Vector& b, const double factor)
  {
    for(std::size_t c = 0; c < dimension; ++c)
      a[c] += factor * b[c];
    return a;
  }

  static Vector unknown(const Response& response, const Role& role)
  {
    Vector result;
    for(std::size_t c = 0; c < dimension; ++c)
      result[c] = response.unknowns[std::size_t(role.column) + c];
    return result;
  }

  // The unknowns of a branch or chain are means over its pairs or links.
  void add_to_reduced(const Sector_index p, const Vector& d, std::vector<double>& reduced) const
  {
    const Role role = this->role(p);
    switch(role.kind) {
    case Role::FREE: break;
    case Role::NODE: add_vector(role.column, d, 1, reduced); break;
    case Role::LINK:
      reduced[std::size_t(role.column)] += Group::value(role.functional, d) *
                                           (Group::squares_at_level_1 / weight(role));
      break;
    case Role::PLUS:
      add_vector(role.column, Group::apply(role.element, d), -0.5 / weight(role), reduced);
      break;
    case Role::MINUS: add_vector(role.column, d, 0.5 / weight(role), reduced); break;
    }
  }

  void add_vector(const Column_index column, const Vector& d, const double factor,
                  std::vector<double>& reduced) const
  {
    for(std::size_t c = 0; c < dimension; ++c)
      reduced[std::size_t(column) + c] += factor * d[c];
    if constexpr(Reduced_system<Group>::has_sums)
      reduced[std::size_t(m_system.sum(column))] += factor * (d[0] + d[1]);
  }

  double weight(const Role& role) const { return m_system.weights()[std::size_t(role.column)]; }

  // The mean of what both sides want, as in `Solution_expander`.
  Vector
  plus_displacement(const Response& response, const Sector_index plus, const Role& role) const
  {
    const Vector own = shift_of(response, plus), other = shift_of(response, role.partner);
    const Vector gap = sum(sum(other, Group::apply(role.element, own), -1),
                           unknown(response, role), -1);
    return sum(own, Group::apply(Group::inverse(role.element), gap), 0.5);
  }

  static Vector link_displacement(const Response& response, const Vector& own, const Role& role)
  {
    const double missing =
      response.unknowns[std::size_t(role.column)] - Group::value(role.functional, own);
    return sum(own, Group::shortest_at_level_1(role.functional), missing);
  }

  const Complex_solver<Group>& m_solver;
  const Reduced_system<Group>& m_system;
  std::vector<Role> m_roles; // per sector
};

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
    s.diagonal().array() += 1e-9; // lengths are 1; for conditions that exclude each other
    forces = minimize_nonnegative(s, missing, work);
    if(!forces.allFinite())
      return false;
    Vectors shift(m_shift);
    for(Eigen::Index i = 0; i < n; ++i)
      for(const auto& p : conditions[std::size_t(i)].force)
        add(shift, p.first, {{forces[i] * p.second[0], forces[i] * p.second[1]}});
    Target_shifts<Group> shifts; // per sector
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

  // Coordinates that no equation determines move with their targets.
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
  Vectors m_last_shift; // in the last solution
  double m_unit;
  Displacements<Group> m_displacements;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_PROGRAM_H
