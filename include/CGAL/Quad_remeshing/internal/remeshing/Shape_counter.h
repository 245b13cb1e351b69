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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_COUNTER_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_COUNTER_H

#include <CGAL/license/Quad_remeshing.h>

// Measures how well quads are shaped, in floating point.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/types/Quad_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The area vector of a quad, times two.
inline Space_vector quad_normal(const Quad_in_space& q) { return area_vector<double>(q); }

// The sines of the angles, as seen along `normal`; -1 where there is no angle.
inline std::array<double, 4> sines_of_angles(const Quad_in_space& q, const Space_vector& normal)
{
  std::array<Space_vector, 4> sides;
  std::array<double, 4> lengths, result;
  for(std::size_t i = 0; i < 4; ++i) {
    sides[i] = vector_to(q[i], q[(i + 1) % 4]);
    lengths[i] = norm(sides[i]);
  }
  const double size = norm(normal);
  for(std::size_t i = 0, before = 3; i < 4; before = i++) {
    const double scale = lengths[i] * lengths[before] * size;
    result[i] = scale > 0 ? inner_product(vector_product(sides[before], sides[i]), normal) / scale
                          : -1.;
  }
  return result;
}

// The least of them: 1 for rectangles, negative if a corner is inverted; the scaled Jacobian.
inline double scaled_jacobian(const Quad_in_space& q, const Space_vector& normal)
{
  const std::array<double, 4> sines = sines_of_angles(q, normal);
  return (std::min)(1., *std::min_element(sines.begin(), sines.end()));
}

// Less is to be mended, and far less is no bend of the quad.
constexpr double slightly_against = -0.02, clearly_against = -0.3; // sines, times cosines to a side

// Whether a corner faces against a side of the surface, as two corners of a bow tie do. If the bow
// tie bends a little, its area vector is along the surface, and no corner is against that.
inline bool has_corner_against(const Quad_in_space& q, const Space_vector& side,
                               const double bound)
{ return side != Space_vector{} && scaled_jacobian(q, side) < bound; }

// As seen along its own normal.
inline double scaled_jacobian(const Quad_in_space& q) { return scaled_jacobian(q, quad_normal(q)); }

inline std::array<double, 4> lengths_of_sides(const Quad_in_space& q)
{
  std::array<double, 4> result;
  for(std::size_t i = 0; i < 4; ++i) {
    const Space_vector side = vector_to(q[i], q[(i + 1) % 4]);
    result[i] = std::hypot(side[0], side[1], side[2]);
  }
  return result;
}

// The longest side over the shortest one.
inline double aspect_ratio(const std::array<double, 4>& sides)
{
  const auto [shortest, longest] = std::minmax_element(sides.begin(), sides.end());
  return *shortest > 0 ? *longest / *shortest : std::numeric_limits<double>::infinity();
}

inline bool is_thin(const double scaled_jacobian) { return scaled_jacobian < 0.1; }

// The quad, times a power of two, so that no product of four lengths is 0 or infinite; one point if
// it has infinite coordinates, or NaN.
// \param exponent receives the exponent of the power by which the result is smaller
inline Quad_in_space scaled_to_size(Quad_in_space q, int& exponent)
{
  double size = 0;
  exponent = 0;
  for(std::size_t k = 1; k < 4; ++k)
    for(const double x : vector_between<double>(q, 0, k)) {
      if(!std::isfinite(x))
        return {};
      size = (std::max)(size, std::abs(x));
    }
  if(size == 0 || (size > 1e-60 && size < 1e60))
    return q;
  exponent = std::ilogb(size);
  for(Space_vector& p : q)
    for(double& x : p)
      x = std::ldexp(x, -exponent);
  return q;
}

class Shape_counter
{
public:
  // \param face its number
  void add(const std::size_t face, const Quad_in_space& quad)
  {
    constexpr double most_of_short_quads = 10; // sides over others
    int exponent = 0;
    const Quad_in_space q = scaled_to_size(quad, exponent);
    const std::array<double, 4> sides = lengths_of_sides(q);
    const double jacobian = scaled_jacobian(q), aspect = aspect_ratio(sides);
    m_shapes.least_scaled_jacobian = (std::min)(m_shapes.least_scaled_jacobian, jacobian);
    m_shapes.largest_aspect_ratio = (std::max)(m_shapes.largest_aspect_ratio, aspect);
    m_shapes.number_of_long_quads += aspect > most_of_short_quads ? 1 : 0;
    if(is_thin(jacobian))
      count_quad(face, m_shapes.number_of_thin_quads, m_shapes.first_thin_quads);
    m_sum += jacobian;
    const double shortest = *std::min_element(sides.begin(), sides.end());
    m_quads.push_back({face, aspect, std::ldexp(shortest, exponent)});
    m_sum_of_sides += std::ldexp(sides[0] + sides[1] + sides[2] + sides[3], exponent);
  }

  Quad_shapes shapes() const
  {
    constexpr double largest_aspect = 100; // of quads that are not degenerate
    constexpr double least_side = 1e-6;    // the same, as a part of the mean side
    Quad_shapes result = m_shapes;
    if(m_quads.empty())
      return result;
    const auto number = double(m_quads.size());
    result.mean_scaled_jacobian = m_sum / number;
    for(const Sides& s : m_quads)
      if(s.aspect > largest_aspect || s.shortest < least_side * m_sum_of_sides / (4 * number))
        count_quad(s.face, result.number_of_degenerate_quads, result.first_degenerate_quads);
    return result;
  }

private:
  struct Sides
  {
    std::size_t face;
    double aspect, shortest;
  };

  Quad_shapes m_shapes;
  double m_sum = 0; // of the scaled Jacobians
  double m_sum_of_sides = 0;
  std::vector<Sides> m_quads;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_COUNTER_H
