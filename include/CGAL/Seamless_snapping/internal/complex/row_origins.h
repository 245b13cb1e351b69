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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_ROW_ORIGINS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_ROW_ORIGINS_H

#include <CGAL/license/Seamless_snapping.h>

// Where the rows of a system come from: places of a complex, for messages.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The origin of a row of the system: a branch, chain, path, or equation of the complex. Sums
// contradict nothing: each defines an unknown.
struct Row_origin
{
  enum Kind { BRANCH, CHAIN, PATH, EQUATION, SUM };
  Kind kind;
  std::size_t index;
  bool is_at_end; // or at the beginning of the branch or chain
};

// An equation of an integer-grid map, what it rounds, and by how much.
template <typename Group>
struct Rounding
{
  enum Kind { BRANCH, CHAIN, POINT };
  Kind kind;
  std::size_t index; // branch, chain, or sector
  double rounded; // the integer
  double value;   // in the input
  typename Cut_complex<Group>::Equation equation;

  double distance() const { return std::abs(rounded - value); }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_ROW_ORIGINS_H
