// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CELL_SIDES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CELL_SIDES_H

#include <CGAL/license/Hexahedral_meshing.h>

// On which side of the facets of a cell a point of its chart lies, exactly: by floating point with
// an error bound, and by exact arithmetic if that does not tell.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

constexpr int outside = -1; // in place of the facets that a point lies on

// Invariant: the cell is positive. Facet i is opposite to corner i.
class Cell_sides
{
public:
  explicit Cell_sides(const Uvw_tetrahedron& u)
    : m_u(u)
  {
    for(int i = 0; i < 4; ++i)
      set(i);
  }

  // Positive on the side of the facet where the cell is.
  CGAL::Sign side(const int i, const Uvw& p) const
  {
    double bound;
    const double value = this->value(i, p, bound);
    if(std::abs(value) > bound)
      return value > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    if(bound == 0)
      return CGAL::ZERO; // the point lies in the anchor, or on an axis-parallel edge or plane
    Uvw_tetrahedron t = m_u;
    t[std::size_t(i)] = p;
    return orientation(t);
  }

  // A bit for each facet that the point lies on; `outside` if the cell does not contain the point.
  int facets_at(const Uvw& p) const
  {
    int result = 0;
    for(int i = 0; i < 4; ++i) {
      const CGAL::Sign s = side(i, p);
      if(s == CGAL::NEGATIVE)
        return outside;
      result |= int(s == CGAL::ZERO) << i;
    }
    return result;
  }

  // Six times the volume of a point with a facet, and a bound of its error.
  double value(const int i, const Uvw& p, double& bound) const
  {
    const Plane& f = m_planes[std::size_t(i)];
    const double x = p[0] - f.anchor[0], y = p[1] - f.anchor[1], z = p[2] - f.anchor[2];
    bound = f.bound[0] * std::abs(x) + f.bound[1] * std::abs(y) + f.bound[2] * std::abs(z);
    return f.normal[0] * x + f.normal[1] * y + f.normal[2] * z;
  }

  // Narrows an interval of third coordinates: no point of the cell that has the two first
  // coordinates of `p` is lost.
  void clip_row(const Uvw& p, double& least, double& largest) const
  {
    for(const Plane& f : m_planes) {
      const double x = p[0] - f.anchor[0], y = p[1] - f.anchor[1];
      const double length = largest - least + std::abs(least - f.anchor[2]);
      const double value = f.normal[0] * x + f.normal[1] * y +
                           2 * (f.bound[0] * std::abs(x) + f.bound[1] * std::abs(y) +
                                f.bound[2] * length);
      // inside is where value + normal[2] (z - anchor[2]) >= 0, or somewhat less
      if(!(std::abs(f.normal[2]) > f.bound[2])) {
        if(value < 0)
          largest = -std::numeric_limits<double>::infinity();
        continue;
      }
      const double z = f.anchor[2] - value / f.normal[2];
      if(f.normal[2] > 0 && z > least)
        least = z - slack * (std::abs(z) + std::abs(f.anchor[2]));
      if(f.normal[2] < 0 && z < largest)
        largest = z + slack * (std::abs(z) + std::abs(f.anchor[2]));
    }
  }

  const Uvw_tetrahedron& corners() const { return m_u; }

private:
  struct Plane
  {
    Uvw anchor, normal;
    Uvw bound; // of the error of the value, per unit of distance from the anchor
  };

  // Each term has at most eight operations, each with an error of 2^-53.
  static constexpr double relative_bound = 2e-15;
  static constexpr double slack = 1e-14;
  static constexpr double least_difference = 1e-90; // products of three don't underflow

  static bool is_axis_parallel(const Uvw& edge)
  {
    return int(edge[0] == 0) + int(edge[1] == 0) + int(edge[2] == 0) >= 2;
  }

  // An axis-parallel edge comes first: for points on it, no error is left.
  void set(const int i)
  {
    std::array<std::size_t, 3> v{{std::size_t((i + 1) % 4), std::size_t((i + 2) % 4),
                                  std::size_t((i + 3) % 4)}};
    for(int k = 0; k < 2 && !is_axis_parallel(vector_to(m_u[v[0]], m_u[v[1]])); ++k)
      v = {v[1], v[2], v[0]};
    Plane& f = m_planes[std::size_t(i)];
    f.anchor = m_u[v[0]];
    Uvw a = vector_to(f.anchor, m_u[v[1]]), b = vector_to(f.anchor, m_u[v[2]]);
    double factor = relative_bound;
    for(const Uvw& edge : {a, b})
      for(const double x : edge)
        if(x != 0 && std::abs(x) < least_difference)
          factor = std::numeric_limits<double>::infinity();
    if(i % 2 == 0) // facets opposite to even corners are listed the other way round
      a.swap(b);
    f.normal = vector_product(a, b);
    for(std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
      f.bound[c] = factor * (std::abs(a[d] * b[e]) + std::abs(a[e] * b[d]));
    }
  }

  Uvw_tetrahedron m_u;
  std::array<Plane, 4> m_planes;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_CELL_SIDES_H
