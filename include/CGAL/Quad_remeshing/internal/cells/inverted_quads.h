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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_INVERTED_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_INVERTED_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Which quads in space are inverted, exactly for the points as they are.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Quad_in_space = std::array<std::array<double, 3>, 4>;

template <typename Number>
using Vector_in_space = std::array<Number, 3>;

template <typename Number>
Vector_in_space<Number> vector_between(const Quad_in_space& q, const std::size_t from,
                                       const std::size_t to)
{
  Vector_in_space<Number> result;
  for(std::size_t c = 0; c < 3; ++c)
    result[c] = Number(q[to][c]) - Number(q[from][c]);
  return result;
}

// At a corner, twice the product of the area vectors of its two sides and of the whole quad.
template <typename Number>
Number corner_area(const Quad_in_space& q, const std::size_t corner,
                   const Vector_in_space<Number>& normal)
{
  return inner_product(vector_product(vector_between<Number>(q, corner, (corner + 1) % 4),
                                      vector_between<Number>(q, corner, (corner + 3) % 4)),
                       normal);
}

template <typename Number>
Vector_in_space<Number> area_vector(const Quad_in_space& q)
{
  return vector_product(vector_between<Number>(q, 0, 2), vector_between<Number>(q, 1, 3));
}

// The least value over the corners.
template <typename Number>
Number least_corner_area(const Quad_in_space& q, const Vector_in_space<Number>& normal)
{
  Number least = corner_area(q, 0, normal);
  for(std::size_t k = 1; k < 4; ++k)
    least = (std::min)(least, corner_area(q, k, normal));
  return least;
}

// Whether a corner turns the other way than the quad as a whole does, or the quad has no area, or a
// side no length.
inline bool is_inverted(const Quad_in_space& q)
{
  double size = 0; // of vectors between corners
  for(std::size_t k = 1; k < 4; ++k)
    for(const double x : vector_between<double>(q, 0, k)) {
      if(!std::isfinite(2 * x))
        return true;
      size = (std::max)(size, 2 * std::abs(x));
    }

  // With u = 2^-53, components of products of two vectors are wrong by at most 8 u size^2, and such
  // a value by at most 140 u size^4, which is less than 1e-13 size^4.
  if(size > 1e-60 && size < 1e60) {
    const double least = least_corner_area(q, area_vector<double>(q));
    const double error = 1e-13 * (size * size) * (size * size);
    if(least > error || least < -error)
      return least < 0;
  }
  for(std::size_t k = 0; k < 4; ++k)
    if(q[k] == q[(k + 1) % 4])
      return true;
  using Exact = CGAL::Exact_rational;
  const Vector_in_space<Exact> normal = area_vector<Exact>(q);
  const bool has_area = normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
  return !has_area || least_corner_area(q, normal) < 0;
}

// In a report.
// \param face its number among the faces that were written
// \param first the first ones, of which ten are listed
inline void count_quad(const std::size_t face, std::size_t& number, std::vector<std::size_t>& first)
{
  constexpr std::size_t listed_at_most = 10;
  ++number;
  if(first.size() < listed_at_most)
    first.push_back(face);
}

template <typename Report>
void count_inverted_quad(const std::size_t face, Report& report)
{ count_quad(face, report.number_of_inverted_quads, report.first_inverted_quads); }

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_INVERTED_QUADS_H
