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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHARTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHARTS_H

#include <CGAL/license/Seamless_snapping.h>

// Other charts for the cells of a volume, in which most facets are no cuts.

#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// In place of u, the system is about g u + shift, with the g and shift of the cell's chart. Turning
// and moving the chart of a cell changes nothing but what is called the transitions across its
// facets. Without charts, each cell keeps its own.
struct Volume_charts
{
  using Group = Cube_rotations;

  std::vector<std::int32_t> chart_of_cell;
  std::vector<Group::Element> elements; // per chart
  std::vector<Uvw> shifts;              // per chart
  std::vector<std::int32_t> roots;      // per chart: one that is joined with it

  bool are_given() const { return chart_of_cell.empty(); }
  std::size_t chart(const std::size_t corner) const
  {
    return std::size_t(chart_of_cell[corner / 4]);
  }

  // A name of all charts that are joined with that of a corner.
  std::size_t root(const Corner_index corner) const
  {
    return are_given() ? 0 : std::size_t(roots[chart(std::size_t(corner))]);
  }

  // From the coordinates of the input to those of the system.
  Group::Element element(const std::size_t corner) const
  {
    return are_given() ? Group::identity() : elements[chart(corner)];
  }

  double shift(const std::size_t corner, const std::size_t c) const
  {
    return are_given() ? 0 : shifts[chart(corner)][c];
  }

  // Coordinate c in the system of what has coordinates `u` in the input.
  double coordinate(const Uvw& u, const std::size_t corner, const std::size_t c) const
  {
    if(are_given())
      return u[c];
    const Group::Element g = elements[chart(corner)];
    return Group::sign(g, c) * u[Group::source(g, c)] + shifts[chart(corner)][c];
  }

  // Which coordinate of the system coordinate c of the input becomes.
  std::size_t column(const std::size_t corner, const std::size_t c) const
  {
    return Group::source(Group::inverse(element(corner)), c);
  }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHARTS_H
