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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_IMPL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_IMPL_H

#include <CGAL/license/Seamless_snapping.h>

// Tries the symmetries, one after the other.

#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/mesh/hint_on_symmetry.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The largest distance between one side of an edge, turned by a multiple of 360 / N degrees as fits
// best, and the other side.
// \param are_lattice whether the coordinates are lattice coordinates, else Cartesian ones
inline double violation_of_symmetry(const std::vector<Edge_sides>& edges, const int N,
                                    const bool are_lattice)
{
  using Complex = std::complex<double>;
  const auto vector = [&](const Uv& a, const Uv& b) {
    const Uv v{b[0] - a[0], b[1] - a[1]};
    const Uv x = are_lattice ? Rotation_group<6>::to_cartesian(v) : v;
    return Complex(x[0], x[1]);
  };
  double largest = 0;
  for(const Edge_sides& s : edges) {
    const Complex here = vector(s.a, s.b), there = vector(s.a_opposite, s.b_opposite);
    double least = std::abs(here - there);
    for(int turns = 1; turns < N; ++turns)
      least = (std::min)(least, std::abs(std::polar(1., 2 * std::acos(-1.) * turns / N) * here -
                                         there));
    largest = (std::max)(largest, least);
  }
  return largest;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message hint_on_symmetry(const std::vector<Edge_sides>& edges, const double tolerance,
                                const int N)
{
  const bool is_lattice = N == 3 || N == 6;
  const auto fits = [&](const int order, const bool are_lattice) {
    return violation_of_symmetry(edges, order, are_lattice) <= tolerance;
  };
  const auto hint = [](const int order, const std::string& coordinates, const std::string& how) {
    const std::string n = std::to_string(order);
    return remedy("the map is seamless for N = " + n + ", in " + coordinates + " coordinates") +
           term(how + "pass rotational_symmetry(Rotational_symmetry<" + n + ">())") +
           (order == 4 ? ", the default" : "");
  };
  for(const int order : {1, 2, 4})
    if((is_lattice || order > N) && fits(order, false))
      return hint(order, "Cartesian", ": ");
  for(const int order : {3, 6}) {
    if((!is_lattice || order > N) && fits(order, true))
      return hint(order, "lattice", ": ");
    if(fits(order, false))
      return hint(order, "Cartesian", ", in which it cannot be exact: apply "
                                      "convert_to_lattice_coordinates(), and ");
  }
  return {};
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_HINT_ON_SYMMETRY_IMPL_H
