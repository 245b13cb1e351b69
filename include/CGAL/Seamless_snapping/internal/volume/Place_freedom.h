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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_FREEDOM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_FREEDOM_H

#include <CGAL/license/Seamless_snapping.h>

// How the members of a place can differ: by moves that leave translations and levels alone.

#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A move takes slot i by R_i e, where e is fixed by the rotations of all loops of arcs, and R_i e
// is 0 in coordinates that have a level. As rotations permute coordinates, this makes coordinates
// of e equal up to a sign, or 0: the integer moves have a basis of vectors without common entries.
struct Place_freedom
{
  std::vector<Cube_rotations::Element> rotation; // per slot
  // Per coordinate of e: the class, named by its first coordinate, and the sign; -1 if it is 0
  std::array<int, 3> first, sign;

  int dimension() const
  {
    int result = 0;
    for(int c = 0; c < 3; ++c)
      result += int(first[std::size_t(c)] == c);
    return result;
  }
};

inline Place_freedom freedom_of(const Volume_places::Place& place, const Volume_places& places,
                                const std::vector<Cube_rotations::Element>& sheet_element)
{
  using Group = Cube_rotations;
  Place_freedom result{std::vector<int>(place.number_of_slots, -1), {}, {}};
  std::vector<int>& rotation = result.rotation;
  rotation[0] = Group::identity();
  for(bool is_done = false; !is_done;) { // the arcs connect the slots
    is_done = true;
    for(std::size_t i = place.first_arc; i < place.end_of_arcs; ++i) {
      const Sector_arc& arc = places.arcs[i];
      int &plus = rotation[std::size_t(arc.plus)], &minus = rotation[std::size_t(arc.minus)];
      const int g = sheet_element[std::size_t(arc.sheet)];
      if((plus < 0) != (minus < 0)) {
        (plus < 0 ? plus : minus) = plus < 0 ? Group::compose(Group::inverse(g), minus)
                                             : Group::compose(g, plus);
        is_done = false;
      }
    }
  }
  Signed_union_find coordinates(3);
  for(std::size_t i = place.first_arc; i < place.end_of_arcs; ++i) {
    const Sector_arc& arc = places.arcs[i];
    const int along = Group::compose(sheet_element[std::size_t(arc.sheet)],
                                     rotation[std::size_t(arc.plus)]);
    const int loop = Group::compose(Group::inverse(rotation[std::size_t(arc.minus)]), along);
    for(std::size_t c = 0; c < 3; ++c)
      coordinates.unite(c, Group::source(loop, c), Group::sign(loop, c));
  }
  for(std::size_t i = place.first_level; i < place.end_of_levels; ++i) {
    const Sector_level& level = places.levels[i];
    coordinates.set_zero(Group::source(rotation[std::size_t(level.sector)],
                                       std::size_t(level.coordinate)));
  }
  for(std::size_t c = 0; c < 3; ++c) {
    const auto found = coordinates.find(c);
    result.first[c] = coordinates.is_zero(c) ? -1 : int(found.index);
    result.sign[c] = found.sign;
  }
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_FREEDOM_H
