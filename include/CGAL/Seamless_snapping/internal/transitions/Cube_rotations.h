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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CUBE_ROTATIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CUBE_ROTATIONS_H

#include <CGAL/license/Seamless_snapping.h>

// The 24 rotations of the cube, which are the rotations of transitions between tetrahedra: they
// permute the coordinates and change signs, so that applying them rounds nothing.

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
  static constexpr bool is_signed_permutation = true;

  using Element = int;

  static constexpr Element identity() { return 0; }
  static constexpr Element element(const int i, int) { return i; }
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

  static double norm(const std::array<double, dimension>& v)
  { return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

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

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_CUBE_ROTATIONS_H
