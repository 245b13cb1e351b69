// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_MAP_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_MAP_H

#include <CGAL/license/Hexahedral_meshing.h>

// The cells of an integer-grid map, ready to be walked through: from chart to chart across facets,
// and to the place of a point.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Cell_sides.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// A point of the mesh, as a cell sees it. Its place is the least cell that contains it.
struct Cell_point
{
  std::int32_t cell;
  Uvw p;
  int facets; // a bit for each facet of the cell that it lies on

  friend bool operator==(const Cell_point& a, const Cell_point& b)
  { return a.cell == b.cell && a.p == b.p; }
};

// Invariants: all cells are positive, all transitions hold exactly and have integer translations.
class Grid_map
{
  using Group = Cube_rotations;

public:
  static constexpr signed char no_cut = -1;

  // \param elements per facet: the rotation to its other side, or `no_cut`
  Grid_map(const Flat_volume& volume, std::vector<signed char> elements)
    : m_volume(volume), m_elements(std::move(elements))
  { }

  const Flat_volume& volume() const { return m_volume; }
  std::size_t number_of_cells() const { return m_volume.number_of_cells(); }

  Cell_sides sides(const std::int32_t cell) const
  { return Cell_sides(uvw_of_cell(m_volume.coordinates, std::size_t(cell))); }

  Corner_index opposite(const Corner_index facet) const
  { return m_volume.opposite[std::size_t(facet)]; }

  // A point in the chart of a facet's cell, as the chart on the other side has it.
  Uvw across(const Corner_index facet, const Uvw& p) const
  {
    const signed char element = m_elements[std::size_t(facet)];
    if(element == no_cut)
      return p;
    const Uvw translation = m_volume.translation(facet, element); // integers, without an error
    Uvw result = Group::apply(element, p);
    for(std::size_t c = 0; c < 3; ++c)
      result[c] += translation[c];
    return result;
  }

  // Calls f(cell point) for all cells that contain a point, over the facets on which it lies, the
  // cell that is given first; until f returns false.
  template <typename F>
  void for_each_cell_at(const Cell_point& start, const F& f) const
  {
    if(!f(start) || start.facets == 0)
      return;
    std::vector<Cell_point> found{start};
    for(std::size_t k = 0; k < found.size(); ++k)
      for(int i = 0; i < 4; ++i) {
        const Corner_index facet = 4 * found[k].cell + i;
        if((found[k].facets >> i & 1) == 0 || opposite(facet) < 0)
          continue;
        const std::int32_t cell = opposite(facet) / 4;
        bool is_new = true;
        for(const Cell_point& other : found)
          is_new = is_new && other.cell != cell;
        if(!is_new)
          continue;
        const Uvw p = across(facet, found[k].p);
        found.push_back({cell, p, sides(cell).facets_at(p)});
        if(!f(found.back()))
          return;
      }
  }

  Cell_point place(const Cell_point& point) const
  {
    Cell_point result = point;
    for_each_cell_at(point, [&](const Cell_point& other) {
      if(other.cell < result.cell)
        result = other;
      return true;
    });
    return result;
  }

  bool is_in_place(const Cell_point& point) const
  {
    bool result = true;
    for_each_cell_at(point, [&](const Cell_point& other) {
      result = other.cell >= point.cell;
      return result;
    });
    return result;
  }

private:
  const Flat_volume& m_volume;
  std::vector<signed char> m_elements;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_MAP_H
