// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_MEASURE_GRID_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_MEASURE_GRID_H

#include <CGAL/license/Quad_remeshing.h>

// How far a parametrization in plain arrays is from an integer-grid map.

#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Linear_snapping::internal::distance_to_integer; // and for more types:

inline double distance_to_integer(const Uv& u)
{
  return (std::max)(distance_to_integer(u[0]), distance_to_integer(u[1]));
}

inline bool is_integer(const Exact_level& x)
{
  return x.is_double() && x.approximation() == std::round(x.approximation());
}

inline double distance_to_integer(const Exact_level& x)
{
  return std::abs(x.minus(Exact_level(std::round(x.approximation()))).approximation());
}

enum class Cone_place { ON_POINT, ON_LINE, IN_CELL };

// The coordinates of a cone are integers or not in all charts alike, where these differ by
// integers.
template <typename Group>
Cone_place cone_place(const Basic_chart_mesh<Group>& mesh, const std::size_t vertex)
{
  int lines = 0;
  for(int c = 0; c < Group::number_of_functionals; ++c)
    lines +=
      is_integer(mesh.component(mesh.corner_at_vertex[vertex], std::size_t(c))) ? 1 : 0;
  return lines > 1 ? Cone_place::ON_POINT : lines == 1 ? Cone_place::ON_LINE : Cone_place::IN_CELL;
}

// Half-integers, both.
inline bool is_half_integer(const Uv& u)
{
  return std::abs(u[0] - std::floor(u[0])) == 0.5 && std::abs(u[1] - std::floor(u[1])) == 0.5;
}

// Of some faces, in units and in floating point: their area, and how often lines of the grid cross
// their edges, about.
struct Grid_size
{
  double area = 0, crossings = 0;
};

template <typename Group>
Grid_size grid_size(const Basic_chart_mesh<Group>& mesh, const std::size_t begin,
                    const std::size_t end)
{
  Grid_size result;
  for(std::size_t f = begin; f < end; ++f) {
    const Uv_triangle t = triangle(mesh, f);
    result.area += ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) -
                    (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])) / 2;
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t c = 0; c < 2; ++c)
        result.crossings += std::abs(t[k][c] - t[(k + 1) % 3][c]);
  }
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_MEASURE_GRID_H
