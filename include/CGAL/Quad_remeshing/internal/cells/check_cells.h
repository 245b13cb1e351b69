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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CHECK_CELLS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CHECK_CELLS_H

#include <CGAL/license/Quad_remeshing.h>

// What the theorem says of the cells, checked exactly for each part of the surface whose border
// lies on the grid: as many corners as cells of its area have, and the surface's Euler
// characteristic.

#include <CGAL/Quad_remeshing/internal/cells/Grid_cells.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Cell_counts
{
  std::ptrdiff_t points = 0, darts = 0, cells = 0;
  std::size_t corners = 0, open_darts = 0; // corners of cells

  std::ptrdiff_t euler_characteristic() const { return points - darts / 2 + cells; }

  Cell_counts& operator+=(const Cell_counts& more)
  {
    points += more.points;
    darts += more.darts;
    cells += more.cells;
    corners += more.corners;
    open_darts += more.open_darts;
    return *this;
  }
};

inline void add_point(const Grid_darts& darts, const Grid_cells& cells, const std::size_t p,
                      Cell_counts& c)
{
  ++c.points;
  for(std::size_t d = darts.first(p); d < darts.first(p + 1); ++d) {
    ++c.darts;
    c.open_darts += darts.twins[d] < 0 ? 1 : 0;
    if(cells.cell(d) == no_cell)
      continue;
    ++c.corners;
    c.cells += cells.first_dart(std::size_t(cells.cell(d))) == d ? 1 : 0;
  }
}

template <typename ConcurrencyTag>
std::vector<Cell_counts> count_cells(const Lattice_points& points, const Grid_darts& darts,
                                     const Grid_cells& cells, const Surface_parts& parts)
{
  return sums_of_parts<Cell_counts, ConcurrencyTag>(
    points.size(), parts.size(),
    [&](const std::size_t p) { return parts.part_of_face(face_of(points[p].corner)); },
    [&](const std::size_t p, Cell_counts& counts) { add_point(darts, cells, p, counts); });
}

// The first part whose cells are not discs; or the number of parts. `is_area_right` tells whether
// that is all that is wrong there.
template <typename Group>
std::size_t first_bad_part(const Surface_parts& parts, const std::vector<Cell_counts>& counts,
                           bool& is_area_right)
{
  std::size_t i = 0;
  for(is_area_right = true; i < parts.size(); ++i) {
    const Surface_part& part = parts[i];
    const Cell_counts& count = counts[i];
    const Exact_rational corners(Cell_shape<Group>::corners_of_unit * part.twice_area / 2);
    if(part.number_of_unaligned_edges > 0) {
      is_area_right = corners >= Exact_rational(count.corners);
      if(!is_area_right)
        break;
      continue;
    }
    is_area_right = count.open_darts == 0 && corners == Exact_rational(count.corners);
    if(!is_area_right || count.euler_characteristic() != part.euler_characteristic)
      break;
  }
  return i;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CHECK_CELLS_H
