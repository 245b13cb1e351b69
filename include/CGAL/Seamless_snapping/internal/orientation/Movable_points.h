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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H

#include <CGAL/license/Seamless_snapping.h>

// The points of the domain whose coordinates repairs of orientations may change, and how far apart
// the numbers are that they can take.

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/Sector_links.h>
#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: what is computed when it is first asked for is kept; most runs repair nothing.
template <typename Group_>
class Movable_points
{
public:
  using Group = Group_;

  Movable_points(const Cut_complex<Group>& complex, const Complex_solver<Group>& solver,
                 Point_stars& stars)
    : m_complex(complex), m_solver(solver), m_stars(stars)
  { }

  const Cut_complex<Group>& complex() const { return m_complex; }
  Point_stars& stars() const { return m_stars; }
  bool is_sector(const Point_index p) const { return std::size_t(p) < m_stars.number_of_sectors(); }

  // The links between sectors.
  const Sector_links<Group>& links() const
  {
    if(!m_links)
      m_links.emplace(m_complex);
    return *m_links;
  }

  const Domain_face& domain_face(const Face_index f) const { return m_stars.domain_face(f); }

  const Uv& uv(const Uv_state& state, const Point_index p) const
  {
    return std::size_t(p) < state.size() ? state[std::size_t(p)] : m_stars.free_input(p);
  }

  Uv_triangle triangle(const Uv_state& state, const Domain_face& f) const
  {
    return {{uv(state, f.points[0]), uv(state, f.points[1]), uv(state, f.points[2])}};
  }

  bool is_positive(const Uv_state& state, const Face_index f) const
  {
    return orientation(triangle(state, domain_face(f))) == CGAL::POSITIVE;
  }

  void set_uv(Uv_state& state, const Point_index p, const Uv& u) const
  {
    while(state.size() <= std::size_t(p))
      state.push_back(m_stars.free_input(Point_index(state.size())));
    state[std::size_t(p)] = u;
  }

  // Whether no constraint concerns it.
  bool is_free(const Point_index p) const { return !is_sector(p) || grid_step(p) == 0; }

  // A multiple of the distance of neighboring numbers that the point can take: those of the coarser
  // of its grids or, where no constraint concerns it, of its coordinates' type, anywhere in the
  // ring around it.
  double spacing(const Point_index p) const
  {
    if(!is_free(p))
      return grid_step(p);
    double largest = 0;
    for(const Face_corner& corner : m_stars.star(p))
      for(const Uv& u : domain_face(corner.face).input)
        largest = (std::max)({largest, std::abs(u[0]), std::abs(u[1])});
    return Grid::finest(m_solver.format(), largest).step();
  }

private:
  // 0 for sectors of merged corners only.
  double grid_step(const Sector_index s) const
  {
    if(m_grid_steps.empty()) {
      m_grid_steps.assign(m_stars.number_of_sectors(), 0);
      m_solver.components().for_each_sector([&](const Sector_index t, const auto& components) {
        double& step = m_grid_steps[std::size_t(t)];
        for(const Component_index k : components)
          if(k >= 0)
            step = (std::max)(step, m_solver.grids()[std::size_t(k)].step());
      });
    }
    return m_grid_steps[std::size_t(s)];
  }

  const Cut_complex<Group>& m_complex;
  const Complex_solver<Group>& m_solver;
  Point_stars& m_stars;
  mutable std::optional<Sector_links<Group> > m_links;
  mutable std::vector<double> m_grid_steps; // per sector
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
