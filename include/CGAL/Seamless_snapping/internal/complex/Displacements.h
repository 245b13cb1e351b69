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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_DISPLACEMENTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_DISPLACEMENTS_H

#include <CGAL/license/Seamless_snapping.h>

// How the least-squares optimum of all sectors follows shifts of the targets of some: the linear
// part of the solution, in real numbers. For shifts of few sectors the displacement of any sector
// takes constant time, once the reduced system has answered.

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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
  // What a shift of targets leads to.
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
    Column_index column = -1; // its own unknown, or that of the branch or chain
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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_DISPLACEMENTS_H
