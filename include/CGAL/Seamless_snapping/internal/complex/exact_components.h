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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXACT_COMPONENTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXACT_COMPONENTS_H

#include <CGAL/license/Seamless_snapping.h>

// Which components of the reduced system hold exactly in the input: they are left alone to the bit,
// whatever is mended elsewhere.

#include <CGAL/Seamless_snapping/internal/complex/Grid_coordinates.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// \return per component
template <typename Group>
std::vector<char> exact_components(const Cut_complex<Group>& complex,
                                   const Coordinate_components<Group>& components,
                                   const std::size_t number_of_components)
{
  std::vector<char> result(number_of_components, true);
  const auto mark = [&](const Components<Group::dimension>& inexact) {
    for(const Component_index k : inexact)
      if(k >= 0)
        result[std::size_t(k)] = false;
  };
  // Sectors can cancel in a row, so that all of it are looked at: those that are left tell.
  const auto mark_branch = [&](const std::size_t b) {
    for(const auto* pair : {complex.pairs_begin(b), complex.pairs_end(b) - 1})
      for(const Sector_index s : {pair->plus, pair->minus})
        mark(components.of_node(s));
    if(complex.has_inner_pairs(b))
      mark(components.of_minus(b));
  };
  const auto& u = complex.coordinates;
  for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
    if(!branch_is_exact(complex, b, u))
      mark_branch(b);
  for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
    if(!chain_is_exact(complex, c, u))
      for(const Sector_index s : {*complex.links_begin(c), *(complex.links_end(c) - 1)})
        mark(components.of_node(s));
  for(const auto& path : complex.paths)
    if(path_misfit(complex, path, u) != 0) {
      for(const Sector_index s : {path.a, path.b})
        mark(components.of_node(s));
      for(const auto& crossing : path.crossings)
        mark_branch(std::size_t(crossing.branch));
    }
  for(const auto& equation : complex.equations)
    if(!equation_is_exact<Group>(equation, u))
      for(const auto& term : equation.terms)
        mark(components.of_node(term.sector));
  if(!complex.mixed_sectors.empty())
    components.for_each_sector([&](const Sector_index s, const auto& inexact) {
      if(complex.find_mixed_sector(s) != nullptr)
        mark(inexact);
    });
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_EXACT_COMPONENTS_H
