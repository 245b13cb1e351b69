// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_MAGNITUDES_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_MAGNITUDES_H

#include <CGAL/license/Linear_snapping.h>

// Means of absolute values and of squares, for figures in reports.

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Invariant: the sums are in units of the largest value, so that they neither overflow nor vanish.
class Magnitudes
{
public:
  void add(const double value, const double weight = 1)
  {
    // what two numbers differ by can exceed the largest number
    const double size = (std::min)(std::abs(value), (std::numeric_limits<double>::max)());
    if(size > m_largest) {
      const double ratio = m_largest / size;
      m_sum *= ratio;
      m_squares *= ratio * ratio;
      m_largest = size;
    }
    const double part = m_largest > 0 ? size / m_largest : 0;
    m_sum += weight * part;
    m_squares += weight * part * part;
    m_weights += weight;
  }

  double sum_of_weights() const { return m_weights; }
  double largest() const { return m_largest; }
  double mean() const { return m_weights > 0 ? m_sum / m_weights * m_largest : 0; }
  double root_mean_square() const { return root(m_weights); }

  // The root of the sum of squares, divided by n.
  double root(const double n) const { return n > 0 ? std::sqrt(m_squares / n) * m_largest : 0; }

private:
  double m_largest = 0, m_sum = 0, m_squares = 0, m_weights = 0;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_EXACT_MAGNITUDES_H
