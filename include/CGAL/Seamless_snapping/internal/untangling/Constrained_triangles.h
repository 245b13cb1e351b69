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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_CONSTRAINED_TRIANGLES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_CONSTRAINED_TRIANGLES_H

#include <CGAL/license/Seamless_snapping.h>

// A piecewise linear map of triangles whose corners are not free: their coordinates are the
// coordinates of a start plus sums of free unknowns, so that linear constraints hold for any values
// of the unknowns.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/complex/Sparse_row.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The wanted shape of a triangle in the domain, up to a rotation.
struct Reference_shape
{
  Eigen::Matrix2d inverse; // the matrix has two edges as columns: from corner 0 to 1, and to 2
  double area;

  // \pre the area is positive
  Reference_shape(const Uv& first_edge, const Uv& second_edge)
  {
    Eigen::Matrix2d edges;
    edges << first_edge[0], second_edge[0], first_edge[1], second_edge[1];
    area = edges.determinant() / 2;
    inverse = edges.inverse();
  }
};

// Invariant: points of triangles have coordinates, which are rows of unknowns below their number.
struct Constrained_triangles
{
  struct Triangle
  {
    std::array<std::size_t, 3> points; // counterclockwise
    Reference_shape shape;
    bool can_have_area = true; // else it is left as it is
  };

  std::size_t number_of_unknowns = 0;
  std::vector<Triangle> triangles;
  std::vector<Uv> start;                        // per point
  std::vector<std::array<Sparse_row, 2> > rows; // per point: what is added to it
  std::vector<std::size_t> vertex;              // per point: several have the same one at cuts
  std::vector<double> angle; // per vertex: the sum of its angles, or not a number for any

  Uv point(const std::size_t p, const std::vector<double>& unknowns) const
  {
    return {{start[p][0] + value_of(rows[p][0], unknowns),
             start[p][1] + value_of(rows[p][1], unknowns)}};
  }

  Uv_triangle triangle(const std::size_t t, const std::vector<double>& unknowns) const
  {
    const auto& p = triangles[t].points;
    return {{point(p[0], unknowns), point(p[1], unknowns), point(p[2], unknowns)}};
  }

  // The triangles whose sign is not positive, exactly, but could be.
  std::vector<std::size_t> not_positive(const std::vector<double>& unknowns) const
  {
    std::vector<std::size_t> result;
    for(std::size_t t = 0; t < triangles.size(); ++t)
      if(triangles[t].can_have_area && orientation(triangle(t, unknowns)) != CGAL::POSITIVE)
        result.push_back(t);
    return result;
  }
};

// The angles around a vertex. Transitions tell their sum up to full turns only, so that repairs of
// flips can turn a cone of 450 degrees into one of 90, and another vertex into one of 720.
constexpr double full_turn = 6.283185307179586; // in radians

// Invariant: the absolute sum is at least the signed one, and as large where nothing is folded.
class Angle_sum
{
public:
  // Adds the angle at the corner `k` of a triangle in Cartesian coordinates, or takes it away.
  void add(const Uv_triangle& t, const std::size_t k, const int sign = 1)
  {
    const Uv &p = t[k], &q = t[(k + 1) % 3], &r = t[(k + 2) % 3];
    const Uv a{{q[0] - p[0], q[1] - p[1]}}, b{{r[0] - p[0], r[1] - p[1]}};
    const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    m_signed += sign * angle;
    m_absolute += sign * std::abs(angle);
  }

  // The likely sum without folds: the sum that fits the transitions and is nearest to the present
  // sum, because folds leave most angles in place.
  double without_folds() const
  {
    const double result = m_signed + full_turn * std::round((m_absolute - m_signed) / full_turn);
    return result > full_turn / 16 ? result : result + full_turn;
  }

  // Whether nothing is folded any more, and yet the sum is another one.
  bool is_wrong(const double wanted) const
  {
    return m_absolute - m_signed < full_turn / 1024 &&
           std::abs(m_signed - wanted) > full_turn / 2;
  }

private:
  double m_signed = 0, m_absolute = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_CONSTRAINED_TRIANGLES_H
