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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_QUARTER_TURNS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_QUARTER_TURNS_H

#include <CGAL/license/Seamless_snapping.h>

// The rotations of transitions, as integer matrices. Any finite subgroup of GL(2,Z) in their place
// would do for all that is built on them.

#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

constexpr int number_of_rotations = 4;

// Row by row; rotation[k] turns by k 90 degrees counterclockwise.
struct Rotation
{
  std::array<std::array<int, 2>, 2> m;

  template <typename Vector> // a pair of numbers
  Vector operator()(const Vector& v) const
  {
    using Number = typename Vector::value_type;
    return {Number(m[0][0]) * v[0] + Number(m[0][1]) * v[1],
            Number(m[1][0]) * v[0] + Number(m[1][1]) * v[1]};
  }
};

inline const Rotation& rotation_matrix(const int k)
{
  static constexpr Rotation rotations[number_of_rotations] = {
    {{{{{ 1, 0}}, {{0,  1}}}}}, {{{{{0, -1}}, {{ 1, 0}}}}},
    {{{{{-1, 0}}, {{0, -1}}}}}, {{{{{0,  1}}, {{-1, 0}}}}}};
  return rotations[k];
}

inline int inverse_rotation(const int k)
{
  return (number_of_rotations - k) % number_of_rotations;
}

// R_k turns component c of a vector into this one, times `sign`.
struct Turned_component
{
  std::size_t component;
  int sign;
};

inline Turned_component turned_component(const int k, const std::size_t c)
{
  const auto& m = rotation_matrix(k).m;
  return m[0][c] != 0 ? Turned_component{0, m[0][c]} : Turned_component{1, m[1][c]};
}

// The same without the sign.
inline int rotated_component(const int k, const int c)
{
  return int(turned_component(k, std::size_t(c)).component);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_QUARTER_TURNS_H
