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
// exactly: one of the 24 rotations of the cube, which permute the coordinates and change signs, so
// that applying them rounds nothing. The rest is floating point: how far a rotation misses, and
// which misses least.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Elements are numbers from 0 to 23; the identity is 0. Only this class knows more of them.
class Cube_rotations
{
public:
  static constexpr std::size_t dimension = 3;
  static constexpr int order = 24;

  using Element = int;

  static constexpr Element identity() { return 0; }
  // First `h`, then `g`.
  static Element compose(const Element g, const Element h)
  {
    return tables.product[g][h];
  }
  static Element inverse(const Element g) { return tables.inverse[g]; }

  // (g u)[c] = sign(g, c) u[source(g, c)]
  static std::size_t source(const Element g, const std::size_t c)
  {
    return std::size_t(tables.rotation[g].source[c]);
  }
  static int sign(const Element g, const std::size_t c)
  {
    return tables.rotation[g].sign[c];
  }

  // g v, for three numbers.
  template <typename Vector>
  static Vector apply(const Element g, const Vector& v)
  {
    Vector result{};
    for(std::size_t c = 0; c < dimension; ++c)
      result[c] = sign(g, c) < 0 ? -v[source(g, c)] : v[source(g, c)];
    return result;
  }

private:
  struct Rotation
  {
    int source[3], sign[3];

    constexpr bool operator==(const Rotation& other) const
    {
      for(int c = 0; c < 3; ++c)
        if(source[c] != other.source[c] || sign[c] != other.sign[c])
          return false;
      return true;
    }
  };

  static constexpr Rotation product(const Rotation& g, const Rotation& h)
  {
    Rotation result{};
    for(int c = 0; c < 3; ++c) {
      result.source[c] = h.source[g.source[c]];
      result.sign[c] = g.sign[c] * h.sign[g.source[c]];
    }
    return result;
  }

  // Plain arrays: arrays of the library can't be assigned to in constant expressions of C++17.
  struct Tables
  {
    Rotation rotation[order];
    int product[order][order];
    int inverse[order];
  };

  // The permutations, the cyclic ones first, with the signs that make the determinant 1.
  static constexpr Tables make_tables()
  {
    Tables t{};
    int size = 0;
    for(const int step : {1, 2})
      for(int first = 0; first < 3; ++first)
        for(int signs = 0; signs < 4; ++signs) {
          Rotation& r = t.rotation[size++];
          for(int c = 0; c < 3; ++c)
            r.source[c] = (first + c * step) % 3;
          r.sign[0] = (signs & 1) != 0 ? -1 : 1;
          r.sign[1] = (signs & 2) != 0 ? -1 : 1;
          r.sign[2] = (step == 1 ? 1 : -1) * r.sign[0] * r.sign[1];
        }
    for(int g = 0; g < order; ++g)
      for(int h = 0; h < order; ++h) {
        const Rotation gh = Cube_rotations::product(t.rotation[g], t.rotation[h]);
        for(int k = 0; k < order; ++k)
          if(t.rotation[k] == gh)
            t.product[g][h] = k;
        if(t.product[g][h] == identity())
          t.inverse[g] = h;
      }
    return t;
  }

  static const Tables tables;
};

inline constexpr Cube_rotations::Tables Cube_rotations::tables = Cube_rotations::make_tables();

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

  // Whether `g` turns the vectors here into the vectors there, in one coordinate of there. Signs
  // and swaps keep the rounded part and the error apart, so that these can be compared one by one.
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
