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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_PROGRAM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_PROGRAM_H

#include <CGAL/license/Seamless_snapping.h>

// The exact solution nearest to the input, among those that keep some faces positive: for what single vertices
// can't repair, such as slivers at cones. A quadratic program over all sectors and the vertices of these faces,
// with one linearized condition per face. In its dual, the multipliers of the conditions are forces that shift the
// targets of the faces' corners; so the program has only as many unknowns as faces, needs no neighborhood to be
// chosen, and the ordinary exact solution for the shifted targets takes its solution to the grid.

#include <CGAL/Seamless_snapping/internal/algebra/nonnegative_program.h>
#include <CGAL/Seamless_snapping/internal/exact/rounded_to.h>
#include <CGAL/Seamless_snapping/internal/surface/Kernel_moves.h>
#include <CGAL/Seamless_snapping/internal/surface/Optimum_response.h>
#include <CGAL/Seamless_snapping/internal/surface/Shifted_solution.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Points, typename TriangleMesh, typename HalfedgeUVMap>
class Orientation_program
{
  using Sectors = typename Points::Sectors;
  using Solution = Shifted_solution<TriangleMesh, HalfedgeUVMap>;
  using Response = typename Optimum_response<TriangleMesh, HalfedgeUVMap>::Response;
  using Number = typename Uv_number<HalfedgeUVMap>::type;

public:
  using Watched = typename Watched_faces<Points>::Watched;

  // \param sectors with the weights of the target
  // \param optimum the exact solution for targets that are not shifted
  Orientation_program(const Points& points, const Sectors& sectors, const Solution& solution,
                      const Uv_state& optimum)
    : m_points(points), m_sectors(sectors), m_solution(solution), m_optimum(optimum),
      m_step(solution.grid().step()), m_coordinates(solution.coordinates(sectors)),
      m_system(solution.system(sectors, m_coordinates)),
      m_response(sectors, solution.branches(), m_system)
  { }

  // \param margin the part of its wanted area that each face is to have
  // \param at where the conditions are linearized
  // \param forces receives the multiplier of each face
  bool solve(const std::vector<Watched>& active, const double margin, const Uv_state& at,
             Uv_state& result, Eigen::VectorXd& forces) const
  {
    std::vector<Condition> conditions;
    for(const Watched& w : active)
      conditions.push_back(condition(w, margin, at));
    const Eigen::Index n = Eigen::Index(conditions.size());
    Eigen::MatrixXd s(n, n);
    Eigen::VectorXd missing(n);
    for(Eigen::Index j = 0; j < n; ++j) {
      missing[j] = conditions[std::size_t(j)].missing;
      const Response response = m_response(conditions[std::size_t(j)].force);
      for(Eigen::Index i = 0; i < n; ++i)
        s(i, j) = change(conditions[std::size_t(i)], response);
    }
    s = (0.5 * (s + s.transpose())).eval();
    s.diagonal().array() += 1e-9; // of lengths 1; for conditions that exclude each other
    forces = minimize_nonnegative(s, missing);
    if(!forces.allFinite())
      return false;
    Point_shift shift;
    for(Eigen::Index i = 0; i < n; ++i)
      for(const auto& p : conditions[std::size_t(i)].force)
        add_shift(shift, p.first, {{forces[i] * p.second[0], forces[i] * p.second[1]}});
    if(!m_solution.solve(m_sectors, shift, result))
      return false;
    set_free_components(shift, result);
    return true;
  }

private:
  // gradient . displacement >= missing, for displacements from the optimum in steps of the grid. The gradient
  // has length 1 in the metric of the weights.
  struct Condition
  {
    Point_shift gradient;
    Point_shift force; // the shift of targets in its direction
    double missing;
  };

  Condition condition(const Watched& w, const double margin, const Uv_state& at) const
  {
    const Uv_triangle now = m_points.uv(at, w.face);
    Condition result;
    double by_rounding = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const Uv& a = now[(i + 1) % 3];
      const Uv& b = now[(i + 2) % 3];
      const Uv g{{(a[1] - b[1]) / m_step, (b[0] - a[0]) / m_step}};
      by_rounding += std::sqrt(dot(g, g)) *
                     (m_points.spacing(w.face.points[i], m_solution.grid()) / m_step);
      add_shift(result.gradient, w.face.points[i], g);
    }
    const double wanted = wanted_area(m_points.input(w.face), w.was_positive, m_step);
    result.missing = (std::max)(margin * wanted, by_rounding) - twice_area(now, m_step);
    double square = 0;
    for(const auto& g : result.gradient) {
      const Uv here = m_points.uv(at, g.first), there = m_points.uv(m_optimum, g.first);
      result.missing += dot(g.second, {{(here[0] - there[0]) / m_step, (here[1] - there[1]) / m_step}});
      square += dot(g.second, g.second) / m_response.weight(g.first);
    }
    const double length = square > 0 ? std::sqrt(square) : 1;
    result.missing /= length;
    for(auto& g : result.gradient) {
      g.second = {{g.second[0] / length, g.second[1] / length}};
      const double weight = m_response.weight(g.first);
      result.force.emplace_back(g.first, Uv{{g.second[0] / weight, g.second[1] / weight}});
    }
    return result;
  }

  double change(const Condition& condition, const Response& response) const
  {
    double result = 0;
    for(const auto& g : condition.gradient)
      result += dot(g.second, m_response.displacement(response, g.first));
    return result;
  }

  // What no equation determines moves with its target.
  void set_free_components(const Point_shift& shift, Uv_state& result) const
  {
    for(const auto& s : shift) {
      Uv u = std::size_t(s.first) < result.size() ? m_points.uv(result, s.first)
                                                  : m_points.uv(m_optimum, s.first);
      for(std::size_t c = 0; c < 2; ++c)
        if(!m_response.is_dependent(s.first, c))
          u[c] = rounded_to<Number>(m_points.uv(m_optimum, s.first)[c] + s.second[c] * m_step);
      m_points.set_uv(result, s.first, u);
    }
  }

  const Points& m_points;
  const Sectors& m_sectors;
  const Solution& m_solution;
  const Uv_state& m_optimum;
  double m_step;
  typename Solution::Coordinates m_coordinates;
  typename Solution::System m_system;
  Optimum_response<TriangleMesh, HalfedgeUVMap> m_response;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_PROGRAM_H
