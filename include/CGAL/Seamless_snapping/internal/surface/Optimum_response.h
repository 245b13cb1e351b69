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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPTIMUM_RESPONSE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPTIMUM_RESPONSE_H

#include <CGAL/license/Seamless_snapping.h>

// How the least-squares optimum of the full system answers when targets of some points are shifted. A linear
// map; that of the reduced system, carried over to the sectors between its nodes.

#include <CGAL/Seamless_snapping/internal/algebra/solve_on_grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Reduced_system.h>
#include <CGAL/Seamless_snapping/internal/surface/Uv_points.h>

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Displacements of a few points, each point at most once.
using Point_shift = std::vector<std::pair<Point_index, Uv> >;

inline void add_shift(Point_shift& shift, const Point_index p, const Uv& d)
{
  for(auto& s : shift)
    if(s.first == p) {
      s.second = {{s.second[0] + d[0], s.second[1] + d[1]}};
      return;
    }
  shift.emplace_back(p, d);
}

inline Uv shift_of(const Point_shift& shift, const Point_index p)
{
  for(const auto& s : shift)
    if(s.first == p)
      return s.second;
  return {{0, 0}};
}

template <typename TriangleMesh, typename HalfedgeUVMap>
class Optimum_response
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using System = Reduced_system<TriangleMesh, HalfedgeUVMap>;

public:
  // What a shift of targets leads to.
  struct Response
  {
    Point_shift shift;
    Eigen::VectorXd unknowns; // displacements of the reduced system's
  };

  Optimum_response(const Sectors& sectors, const Branches& branches, const System& system)
    : m_sectors(sectors), m_system(system), m_roles(sectors.number_of_sectors()),
      m_project(std::visit([&](const auto& s) { return difference_projection(s, system.point().weights); },
                           system.system()))
  {
    for(std::size_t s = 0; s < m_roles.size(); ++s)
      if(system.unknown(Sector_index(s)) >= 0)
        m_roles[s] = {Kind::NODE, system.unknown(Sector_index(s)), 0, 0};
    for(std::size_t b = 0; b < branches.cut.size(); ++b)
      if(system.translation(b) >= 0)
        assign_pairs(b, branches.cut.begin(b), branches.cut.end(b));
    for(std::size_t b = 0; b < branches.aligned.size(); ++b)
      if(system.coordinate(b) >= 0)
        assign_aligned(b, branches.aligned.begin(b), branches.aligned.end(b));
  }

  Response operator()(const Point_shift& shift) const
  {
    Eigen::VectorXd reduced = Eigen::VectorXd::Zero(Eigen::Index(m_system.point().weights.size()));
    for(const auto& s : shift)
      add_to_reduced(s.first, s.second, reduced);
    return {shift, m_project(reduced)};
  }

  Uv displacement(const Response& response, const Point_index p) const
  {
    const Uv own = shift_of(response.shift, p);
    const Role role = this->role(p);
    const auto unknown = [&](const std::size_t c) {
      return response.unknowns[role.column + Eigen::Index(c)];
    };
    switch(role.kind) {
    case Kind::FREE: break;
    case Kind::NODE: return {{unknown(0), unknown(1)}};
    case Kind::ALIGNED: {
      Uv d = own;
      d[std::size_t(role.parameter)] = unknown(0);
      return d;
    }
    case Kind::PLUS: return plus_displacement(response, p, role);
    case Kind::MINUS: {
      const Uv plus = plus_displacement(response, role.partner, this->role(role.partner));
      const Uv rotated = rotation_matrix(role.parameter)(plus);
      return {{rotated[0] + unknown(0), rotated[1] + unknown(1)}};
    }
    }
    return own;
  }

  // Whether the component is computed from others, so that it can't be set by itself.
  bool is_dependent(const Point_index p, const std::size_t c) const
  {
    const Role role = this->role(p);
    switch(role.kind) {
    case Kind::FREE: break;
    case Kind::NODE: return m_system.is_constrained(p, c);
    case Kind::ALIGNED: return std::size_t(role.parameter) == c;
    case Kind::PLUS:
    case Kind::MINUS: return true;
    }
    return false;
  }

  double weight(const Point_index p) const
  {
    return std::size_t(p) < m_roles.size() ? m_sectors.sector(p).weight : 1.;
  }

private:
  // Nodes are unknowns; the sectors between them come in pairs beside a cut, or share a coordinate.
  enum class Kind { FREE, NODE, PLUS, MINUS, ALIGNED };

  struct Role
  {
    Kind kind = Kind::FREE;
    Column_index column = -1; // its own unknown, or that of the branch
    Sector_index partner = -1;
    int parameter = 0; // the rotation from plus to minus, or the component
  };

  Role role(const Point_index p) const
  {
    return std::size_t(p) < m_roles.size() ? m_roles[std::size_t(p)] : Role();
  }

  void assign_pairs(const std::size_t b, const Directed_cut* first, const Directed_cut* last)
  {
    const int k = m_system.directed_rotation(*first);
    for(const Directed_cut* d = first; d != last - 1; ++d) {
      const Sector_index plus = m_sectors.target_sector(*d);
      const Sector_index minus = m_sectors.source_sector(opposite_cut(*d));
      m_roles[std::size_t(plus)] = {Kind::PLUS, m_system.translation(b), minus, k};
      m_roles[std::size_t(minus)] = {Kind::MINUS, m_system.translation(b), plus, k};
    }
  }

  void assign_aligned(const std::size_t b, const std::int32_t* first, const std::int32_t* last)
  {
    const int c = int(m_system.align_component(*first));
    for(const std::int32_t* d = first; d != last - 1; ++d)
      m_roles[std::size_t(m_system.align_sector(*d, true))] = {Kind::ALIGNED, m_system.coordinate(b), -1, c};
  }

  // The branch's unknowns are weighted means over its pairs or sectors.
  void add_to_reduced(const Point_index p, const Uv& d, Eigen::VectorXd& reduced) const
  {
    const Role role = this->role(p);
    const auto add = [&](const std::size_t c, const double x) {
      reduced[role.column + Eigen::Index(c)] += x;
    };
    switch(role.kind) {
    case Kind::FREE: break;
    case Kind::NODE:
      add(0, d[0]);
      add(1, d[1]);
      break;
    case Kind::ALIGNED:
      add(0, d[std::size_t(role.parameter)] * weight(p) / branch_weight(role));
      break;
    case Kind::PLUS:
    case Kind::MINUS: {
      const double part = shared_weight(weight(p), weight(role.partner)) / branch_weight(role);
      const Uv change = role.kind == Kind::MINUS ? d : rotation_matrix(role.parameter)(d);
      const double sign = role.kind == Kind::MINUS ? part : -part;
      add(0, sign * change[0]);
      add(1, sign * change[1]);
      break;
    }
    }
  }

  double branch_weight(const Role& role) const
  {
    return m_system.point().weights[std::size_t(role.column)];
  }

  // As in `Snapped_coordinates`: the weighted mean of what both sides want.
  Uv plus_displacement(const Response& response, const Sector_index plus, const Role& role) const
  {
    const Uv own = shift_of(response.shift, plus), other = shift_of(response.shift, role.partner);
    const Uv rotated = rotation_matrix(role.parameter)(own);
    const Uv gap{{other[0] - rotated[0] - response.unknowns[role.column],
                  other[1] - rotated[1] - response.unknowns[role.column + 1]}};
    const Uv back = rotation_matrix(inverse_rotation(role.parameter))(gap);
    const double part = weight(role.partner) / (weight(plus) + weight(role.partner));
    return {{own[0] + part * back[0], own[1] + part * back[1]}};
  }

  const Sectors& m_sectors;
  const System& m_system;
  std::vector<Role> m_roles; // per sector
  Difference_projection m_project;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_OPTIMUM_RESPONSE_H
