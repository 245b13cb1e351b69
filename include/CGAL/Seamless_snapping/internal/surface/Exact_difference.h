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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_EXACT_DIFFERENCE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_EXACT_DIFFERENCE_H

#include <CGAL/license/Seamless_snapping.h>

// Differences of floating point numbers, exactly, at the price of a few additions: the rounded
// difference together with its rounding error, which is a floating point number itself, determines the
// difference. Needs rounding to nearest.

#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Uv = std::array<double, 2>;

struct Exact_difference
{
  double rounded;
  double error;

  // a - b; the error is wrong only if the rounded difference overflows (see `is_valid`)
  Exact_difference(const double a, const double b)
  {
    rounded = a - b;
    const double b_part = a - rounded;
    const double a_part = rounded + b_part;
    error = (a - a_part) + (b_part - b);
  }

  bool is_valid() const { return std::isfinite(rounded); }

  friend bool operator==(const Exact_difference& x, const Exact_difference& y)
  { return x.rounded == y.rounded && x.error == y.error; }
};

// The two sides of an edge as they appear in the charts of its faces: `a`, `b` are the ends in the one,
// `a_opposite`, `b_opposite` the same ends in the other.
struct Edge_sides
{
  Uv a, b, a_opposite, b_opposite;

  // Without branches: nearly all edges of a mesh come here, and nearly all are.
  bool are_identical() const
  {
    return (int(a[0] == a_opposite[0]) & int(a[1] == a_opposite[1]) &
            int(b[0] == b_opposite[0]) & int(b[1] == b_opposite[1])) != 0;
  }

  // as seen from the opposite halfedge
  Edge_sides turned() const { return {b_opposite, a_opposite, b, a}; }
};

// R_k (b - a) = b' - a', Eq. (4), in rationals: for differences beyond the largest double.
inline bool match_in_rationals(const Edge_sides& s, const int k)
{
  const std::array<Exact_rational, 2> d{Exact_rational(s.b[0]) - Exact_rational(s.a[0]),
                                        Exact_rational(s.b[1]) - Exact_rational(s.a[1])};
  const auto& m = rotation_matrix(k).m;
  for(std::size_t c = 0; c < 2; ++c) {
    const Exact_rational rotated(Exact_rational(m[c][0]) * d[0] + Exact_rational(m[c][1]) * d[1]);
    const Exact_rational other(Exact_rational(s.b_opposite[c]) - Exact_rational(s.a_opposite[c]));
    if(rotated != other)
      return false;
  }
  return true;
}

// The edge vectors of both sides.
class Edge_vectors
{
public:
  explicit Edge_vectors(const Edge_sides& s)
    : m_side{{Exact_difference(s.b[0], s.a[0]), Exact_difference(s.b[1], s.a[1])}},
      m_opposite{{Exact_difference(s.b_opposite[0], s.a_opposite[0]),
                  Exact_difference(s.b_opposite[1], s.a_opposite[1])}}
  { }

  bool are_valid() const
  {
    return m_side[0].is_valid() && m_side[1].is_valid() &&
           m_opposite[0].is_valid() && m_opposite[1].is_valid();
  }

  // Whether R_k turns the one into the other, exactly. Signs and swaps of components keep the rounded
  // part and the error apart, so that these can be compared one by one.
  bool match(const int k) const
  {
    const Rotation& r = rotation_matrix(k);
    return r(rounded(m_side)) == rounded(m_opposite) && r(error(m_side)) == error(m_opposite);
  }

  // The larger component of the difference, times `scale`: a power of two that brings lengths near 1.
  double residual(const int k, const double scale) const
  {
    const Rotation& r = rotation_matrix(k);
    const Uv a = r(rounded(m_side)), b = rounded(m_opposite);
    const Uv a_error = r(error(m_side)), b_error = error(m_opposite);
    double largest = 0;
    for(std::size_t c = 0; c < 2; ++c)
      largest = (std::max)(largest, std::abs((a[c] * scale - b[c] * scale) +
                                             (a_error[c] * scale - b_error[c] * scale)));
    return largest;
  }

  // The length of the longer side, in the maximum norm, times `scale`.
  double length(const double scale) const
  {
    return scale * (std::max)((std::max)(std::abs(m_side[0].rounded), std::abs(m_side[1].rounded)),
                              (std::max)(std::abs(m_opposite[0].rounded),
                                         std::abs(m_opposite[1].rounded)));
  }

private:
  using Vector = std::array<Exact_difference, 2>;
  static Uv rounded(const Vector& v) { return {v[0].rounded, v[1].rounded}; }
  static Uv error(const Vector& v) { return {v[0].error, v[1].error}; }

  Vector m_side, m_opposite;
};

// Eq. (4) for a given rotation, exactly.
inline bool satisfies_transition(const Edge_sides& s, const int k)
{
  if(k == 0 && s.are_identical())
    return true;
  const Edge_vectors vectors(s);
  return vectors.are_valid() ? vectors.match(k) : match_in_rationals(s, k);
}

// Whether some rotation satisfies it.
inline bool satisfies_some_transition(const Edge_sides& s)
{
  if(s.are_identical())
    return true;
  for(int k = 0; k < number_of_rotations; ++k)
    if(satisfies_transition(s, k))
      return true;
  return false;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_EXACT_DIFFERENCE_H
