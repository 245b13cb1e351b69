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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WANTED_UNITS_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WANTED_UNITS_H

#include <CGAL/license/Quad_remeshing.h>

// The vectors that the edges of a complex should have, in units.

#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Wanted_vector = std::array<double, 2>;

// The vector wanted for a halfedge, in units.
// \param scales units per step of the input's grid, per part
inline Wanted_vector wanted_units(const Intrinsic_complex& complex, const Corner_index h,
                                  const std::vector<double>& scales)
{
  const double scale = scales[std::size_t(complex.part[std::size_t(h / 3)])];
  const Grid_vector& v = complex.corner(h).vector;
  return {scale * static_cast<double>(v[0]), scale * static_cast<double>(v[1])};
}

// Errors of long edges weigh less.
inline double weight_of_edge(const Wanted_vector& wanted)
{
  return 1 / (1 + std::hypot(wanted[0], wanted[1]));
}

// The wanted units of all halfedges.
inline std::vector<Wanted_vector> wanted_units(const Intrinsic_complex& complex,
                                               const std::vector<double>& scales)
{
  std::vector<Wanted_vector> result;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    result.push_back(wanted_units(complex, h, scales));
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_WANTED_UNITS_H
