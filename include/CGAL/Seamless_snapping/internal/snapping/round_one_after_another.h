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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_ROUND_ONE_AFTER_ANOTHER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_ROUND_ONE_AFTER_ANOTHER_H

#include <CGAL/license/Seamless_snapping.h>

// Where integers are far, coordinates that are rounded independently stretch and shrink what lies
// between them. So integers are chosen one after another, as Bommes, Zimmer and Kobbelt do
// (Mixed-Integer Quadrangulation, 2009): the nearest first, and the map follows before the next
// ones are. What is chosen is exact: there always are integers for the rest.

#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A part of those that are left is chosen at a time, and all that nothing keeps from being integers
// any more. So n of them take at most 4 log(n) + 4 steps, each a solution of the factorized system
// or, for those that move others, some more. How these respond to each other is a dense matrix: to
// bound it, all but so many are chosen at once.
constexpr std::size_t parts_of_roundings = 4;
constexpr std::size_t most_that_follow = 4000;
constexpr double nearly_integer = 1e-4;

// \param spreader of the complex
// \param roundings all of them; receives others. Distances stay those from the complex.
// \return whether there are others
template <typename Group, typename Spreader>
bool round_one_after_another(const Cut_complex<Group>& complex,
                             const std::vector<Sector_index>& points, const Number_format& format,
                             Spreader& spreader, std::vector<Rounding<Group> >& roundings)
{
  Cut_complex<Group> moved = complex;
  std::vector<Rounding<Group> > now = roundings, chosen, more;
  std::vector<std::size_t> left(now.size());
  std::iota(left.begin(), left.end(), std::size_t(0));
  for(;;) {
    std::sort(left.begin(), left.end(), [&](const std::size_t i, const std::size_t j) {
      return std::make_pair(now[i].distance(), i) < std::make_pair(now[j].distance(), j);
    });
    std::size_t part = (left.size() + parts_of_roundings - 1) / parts_of_roundings, n = 0;
    if(left.size() > most_that_follow)
      part = (std::max)(part, left.size() - most_that_follow);
    more.clear();
    for(; n < left.size() && (n < part || now[left[n]].distance() < nearly_integer); ++n) {
      more.push_back(now[left[n]]);
      more.back().value = roundings[left[n]].value;
    }
    left.erase(left.begin(), left.begin() + std::ptrdiff_t(n));
    if(left.empty())
      break;
    if(!(chosen.empty() ? spreader.compute(more) : spreader.compute_further(more)))
      return false;
    chosen.insert(chosen.end(), more.begin(), more.end());
    for(std::size_t s = 0; s < moved.number_of_sectors(); ++s) {
      const auto d = spreader(Sector_index(s));
      for(std::size_t c = 0; c < Group::dimension; ++c)
        moved.coordinates[s][c] = complex.coordinates[s][c] + d[c];
    }
    Integer_rounding<Group> rounding(moved, points);
    for(const Rounding<Group>& r : chosen)
      rounding.fix(r);
    now.clear();
    if(rounding.run(format, now))
      return false;
  }
  for(std::size_t i = 0; i < roundings.size(); ++i) {
    now[i].value = roundings[i].value;
    roundings[i] = std::move(now[i]);
  }
  return true;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_ROUND_ONE_AFTER_ANOTHER_H
