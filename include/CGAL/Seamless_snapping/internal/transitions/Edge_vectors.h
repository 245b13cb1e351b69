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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_EDGE_VECTORS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_EDGE_VECTORS_H

#include <CGAL/license/Seamless_snapping.h>

// The two sides of an edge, and which transition takes the one to the other: [MC19] Eq. (4),
// exactly. The rest is floating point: how far a transition misses, and which misses least.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The coordinates at both ends a, b of an edge, on both sides.
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

// The vectors from a to b on both sides of an edge, without their rounding errors.
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

  // Whether `g` turns the one into the other, exactly. Signs and swaps of coordinates keep the
  // rounded part and the error apart, so that these can be compared one by one.
  // \pre are_valid()
  template <typename Group>
  bool match(const typename Group::Element g) const
  {
    if constexpr(Group::is_signed_permutation) {
      return Group::apply(g, rounded(m_side)) == rounded(m_opposite) &&
             Group::apply(g, error(m_side)) == error(m_opposite);
    } else {
      const auto& m = Group::matrix(g);
      for(std::size_t c = 0; c < 2; ++c) {
        std::array<double, 6> terms{{-m_opposite[c].rounded, -m_opposite[c].error, 0, 0, 0, 0}};
        for(std::size_t d = 0; d < 2; ++d) { // entries are -1, 0, or 1
          terms[2 + 2 * d] = m[c][d] * m_side[d].rounded;
          terms[3 + 2 * d] = m[c][d] * m_side[d].error;
        }
        if(!exact_sum_is_zero(terms.data(), terms.size()))
          return false;
      }
      return true;
    }
  }

  // The largest functional of the difference, times `scale`: a power of two that brings lengths
  // near 1.
  template <typename Group>
  double residual(const typename Group::Element g, const double scale) const
  {
    const Uv a = Group::apply(g, rounded(m_side)), b = rounded(m_opposite);
    const Uv a_error = Group::apply(g, error(m_side)), b_error = error(m_opposite);
    Uv missing;
    for(std::size_t c = 0; c < 2; ++c)
      missing[c] = (a[c] * scale - b[c] * scale) + (a_error[c] * scale - b_error[c] * scale);
    return Group::norm(missing);
  }

  // The element of least residual, as in [EBCK13], of symmetry n; the first of several.
  template <typename Group>
  typename Group::Element best_fit(const double scale, const int n) const
  {
    typename Group::Element best = Group::identity();
    double least = residual<Group>(best, scale);
    for(int turns = 1; turns < n; ++turns) {
      const double other = residual<Group>(Group::element(turns, n), scale);
      if(other < least) {
        best = Group::element(turns, n);
        least = other;
      }
    }
    return best;
  }

  // The length of the longer side, times `scale`.
  template <typename Group>
  double length(const double scale) const
  {
    return scale * (std::max)(Group::norm(rounded(m_side)), Group::norm(rounded(m_opposite)));
  }

private:
  using Vector = std::array<Exact_difference, 2>;
  static Uv rounded(const Vector& v) { return {v[0].rounded, v[1].rounded}; }
  static Uv error(const Vector& v) { return {v[0].error, v[1].error}; }

  Vector m_side, m_opposite;
};

// Whether sides match exactly, for coordinates whose differences may overflow.
template <typename Group>
bool match_exactly(const Edge_sides& s, const typename Group::Element g)
{
  const auto& m = Group::matrix(g);
  for(std::size_t c = 0; c < 2; ++c) {
    const std::array<double, 6> terms{{m[c][0] * s.b[0], -m[c][0] * s.a[0], m[c][1] * s.b[1],
                                       -m[c][1] * s.a[1], -s.b_opposite[c], s.a_opposite[c]}};
    if(!exact_sum_is_zero(terms.data(), terms.size()))
      return false;
  }
  return true;
}

// [MC19] Eq. (4) for one element, exactly. \pre the coordinates are finite
template <typename Group>
bool satisfies_transition(const Edge_sides& s, const typename Group::Element g)
{
  if(g == Group::identity() && s.are_identical())
    return true;
  const Edge_vectors vectors(s);
  return vectors.are_valid() ? vectors.match<Group>(g) : match_exactly<Group>(s, g);
}

// By how much u + v differs at the ends of an edge: 0 only if it does not, exactly.
// \pre the coordinates are finite
inline double change_of_sum(const Uv& a, const Uv& b)
{
  const std::array<double, 4> terms{{b[0], -a[0], b[1], -a[1]}};
  if(exact_sum_is_zero(terms.data(), terms.size()))
    return 0;
  return (std::max)(std::abs((b[0] - a[0]) + (b[1] - a[1])),
                    std::numeric_limits<double>::denorm_min());
}

// Whether [MC19] Eq. (4) holds for some element of symmetry n.
template <typename Group>
bool satisfies_some_transition(const Edge_sides& s, const int n)
{
  if(s.are_identical())
    return true;
  for(int turns = 0; turns < n; ++turns)
    if(satisfies_transition<Group>(s, Group::element(turns, n)))
      return true;
  return false;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_EDGE_VECTORS_H
