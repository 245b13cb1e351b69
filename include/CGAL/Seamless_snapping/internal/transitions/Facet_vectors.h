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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_FACET_VECTORS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_FACET_VECTORS_H

#include <CGAL/license/Seamless_snapping.h>

// The two sides of a facet between tetrahedra, and which rotation takes the one to the other,
// exactly. The rest is floating point: how far a rotation misses, and which misses least.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/transitions/Cube_rotations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The coordinates of the vertices of a facet, in the charts of both cells.
struct Facet_sides
{
  std::array<Uvw, 3> here, there;

  bool are_identical() const { return here == there; }

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

// The vectors from the first vertex to the others, without their rounding errors.
// \pre differences of coordinates don't overflow
class Facet_vectors
{
  using Group = Cube_rotations;

public:
  explicit Facet_vectors(const Facet_sides& s)
  {
    for(std::size_t i = 0; i < 2; ++i)
      for(std::size_t c = 0; c < 3; ++c) {
        set(m_here[i], c, {s.here[i + 1][c], s.here[0][c]});
        set(m_there[i], c, {s.there[i + 1][c], s.there[0][c]});
      }
  }

  // Whether `g` turns those here into those there, in one coordinate of there. Signs and swaps keep
  // the rounded part and the error apart, so that these can be compared one by one.
  bool match(const int g, const std::size_t c) const
  {
    const std::size_t from = Group::source(g, c);
    const double sign = Group::sign(g, c);
    for(std::size_t i = 0; i < 2; ++i)
      if(sign * m_here[i].rounded[from] != m_there[i].rounded[c] ||
         sign * m_here[i].error[from] != m_there[i].error[c])
        return false;
    return true;
  }

  bool match(const int g) const { return match(g, 0) && match(g, 1) && match(g, 2); }

  bool match_some() const
  {
    for(int g = 0; g < Group::order; ++g)
      if(match(g))
        return true;
    return false;
  }

  // The largest coordinate by which `g` misses.
  double residual(const int g) const
  {
    double largest = 0;
    for(std::size_t i = 0; i < 2; ++i) {
      const Uvw rounded = Group::apply(g, m_here[i].rounded);
      const Uvw error = Group::apply(g, m_here[i].error);
      for(std::size_t c = 0; c < 3; ++c)
        largest = (std::max)(largest, std::abs((rounded[c] - m_there[i].rounded[c]) +
                                               (error[c] - m_there[i].error[c])));
    }
    return largest;
  }

private:
  struct Vector
  {
    Uvw rounded, error;
  };

  static void set(Vector& v, const std::size_t c, const Exact_difference& d)
  {
    v.rounded[c] = d.rounded;
    v.error[c] = d.error;
  }

  std::array<Vector, 2> m_here, m_there;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_FACET_VECTORS_H
