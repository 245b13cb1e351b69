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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_SIDE_VECTORS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_SIDE_VECTORS_H

#include <CGAL/license/Seamless_snapping.h>

// The two sides of an edge between triangles, or of a facet between tetrahedra, and which
// transition takes the one to the other: [MC19] Eq. (4), exactly. The rest is floating point: how
// far a transition misses, and which misses least.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

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

// The coordinates of the vertices of a facet, in the charts of both cells.
struct Facet_sides
{
  std::array<Uvw, 3> here, there;

  // The largest difference of a coordinate: by how much the identity without translation misses.
  double difference() const
  {
    double largest = 0;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t c = 0; c < 3; ++c)
        largest = (std::max)(largest, std::abs(here[i][c] - there[i][c]));
    return largest;
  }
};

// The vectors from the first vertex to the others, on both sides, without their rounding errors.
template <typename Group>
class Side_vectors
{
  static constexpr std::size_t dimension = Group::dimension;
  using Element = typename Group::Element;
  using Point = std::array<double, dimension>;
  using Points = std::array<Point, dimension>;

public:
  explicit Side_vectors(const Edge_sides& s)
    : Side_vectors(Points{{s.a, s.b}}, Points{{s.a_opposite, s.b_opposite}})
  { }

  explicit Side_vectors(const Facet_sides& s) : Side_vectors(s.here, s.there) { }

  // Whether no difference of coordinates overflows.
  bool are_valid() const
  {
    bool result = true;
    for(const Vectors* vectors : {&m_here, &m_there})
      for(const Vector& v : *vectors)
        for(const double x : v.rounded)
          result = result && std::isfinite(x);
    return result;
  }

  // Whether `g` turns the vectors here into the vectors there, exactly, in one coordinate of there.
  // Signs and swaps of coordinates keep the rounded part and the error apart, so that these can be
  // compared one by one.
  // \pre are_valid()
  bool match(const Element g, const std::size_t c) const
  {
    for(std::size_t i = 0; i + 1 < dimension; ++i) {
      const Vector &u = m_here[i], &v = m_there[i];
      if constexpr(Group::is_signed_permutation) {
        if(Group::apply(g, u.rounded)[c] != v.rounded[c] ||
           Group::apply(g, u.error)[c] != v.error[c])
          return false;
      } else {
        const auto& m = Group::matrix(g)[c]; // entries are -1, 0, or 1
        const std::array<double, 6> terms{{-v.rounded[c], -v.error[c],
                                           m[0] * u.rounded[0], m[0] * u.error[0],
                                           m[1] * u.rounded[1], m[1] * u.error[1]}};
        if(!exact_sum_is_zero(terms.data(), terms.size()))
          return false;
      }
    }
    return true;
  }

  bool match(const Element g) const
  {
    bool result = true;
    for(std::size_t c = 0; c < dimension; ++c)
      result = result && match(g, c);
    return result;
  }

  // The first element that matches, if there is one.
  std::optional<Element> exact_fit() const
  {
    for(int i = 0; i < Group::order; ++i)
      if(match(Group::element(i, Group::order)))
        return Group::element(i, Group::order);
    return std::nullopt;
  }

  // By how much `g` misses, times `scale`: a power of two that brings lengths near 1.
  double residual(const Element g, const double scale = 1) const
  {
    double largest = 0;
    for(std::size_t i = 0; i + 1 < dimension; ++i) {
      const Vector u{Group::apply(g, m_here[i].rounded), Group::apply(g, m_here[i].error)};
      const Vector& v = m_there[i];
      Point missing;
      for(std::size_t c = 0; c < dimension; ++c)
        missing[c] = (u.rounded[c] * scale - v.rounded[c] * scale) +
                     (u.error[c] * scale - v.error[c] * scale);
      largest = (std::max)(largest, Group::norm(missing));
    }
    return largest;
  }

  // The element of least residual, as in [EBCK13], of symmetry n; the first of several.
  Element best_fit(const double scale = 1, const int n = Group::order) const
  {
    Element best = Group::identity();
    double least = residual(best, scale);
    for(int i = 1; i < n && least > 0; ++i) {
      const double other = residual(Group::element(i, n), scale);
      if(other < least) {
        best = Group::element(i, n);
        least = other;
      }
    }
    return best;
  }

  // The length of the longer side, times `scale`.
  double length(const double scale) const
  {
    return scale * (std::max)(Group::norm(m_here[0].rounded), Group::norm(m_there[0].rounded));
  }

private:
  struct Vector { Point rounded, error; };
  using Vectors = std::array<Vector, dimension - 1>;

  Side_vectors(const Points& here, const Points& there)
    : m_here(vectors(here)), m_there(vectors(there))
  { }

  static Vectors vectors(const Points& points)
  {
    Vectors result;
    for(std::size_t i = 0; i + 1 < dimension; ++i)
      for(std::size_t c = 0; c < dimension; ++c) {
        const Exact_difference d(points[i + 1][c], points[0][c]);
        result[i].rounded[c] = d.rounded;
        result[i].error[c] = d.error;
      }
    return result;
  }

  Vectors m_here, m_there;
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
  const Side_vectors<Group> vectors(s);
  return vectors.are_valid() ? vectors.match(g) : match_exactly<Group>(s, g);
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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_SIDE_VECTORS_H
