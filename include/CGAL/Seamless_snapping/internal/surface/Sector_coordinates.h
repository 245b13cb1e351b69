// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// The coordinates of sectors relative to a grid.

#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>
#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Grid_vector = std::array<std::int64_t, 2>;

// A real point relative to the grid.
struct Grid_uv
{
  Grid_vector base;
  Uv offset;
};

// In steps of the sector's own grid, computed when asked for, which is cheaper than to store them. Sectors whose
// corners differ are represented by their mean.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Sector_coordinates
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;

public:
  Sector_coordinates(const Sectors& sectors, const HalfedgeUVMap& uv_map, const Grid& grid)
    : m_sectors(sectors), m_grid(grid), m_deviations(sectors.mixed_sectors().size()),
      m_squares(sectors.mixed_sectors().size())
  {
    for(const Sector_index s : sectors.mixed_sectors())
      set_mean(s, uv_map);
  }

  // In steps of the grid of the largest coordinates; adds to earlier shifts. Returns false if the sum
  // is too large for the grid's integers.
  bool shift(const Sector_index s, const Uv& by)
  {
    Uv& sum = m_shifts[s];
    for(std::size_t c = 0; c < 2; ++c)
      sum[c] += std::ldexp(by[c], m_sectors.sector(s).magnification);
    constexpr double largest = machine_integer_bound / 4;
    return std::abs(sum[0]) < largest && std::abs(sum[1]) < largest;
  }

  Grid_uv operator[](const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    const bool is_plain = sector.is_uniform() && sector.magnification == 0 && m_shifts.empty();
    return is_plain ? split(sector.uv) : changed_coordinates(s); // nearly all are
  }

  // The mean of corners that differ, on no grid.
  Uv mean(const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    const Uv& deviation = m_deviations[std::size_t(sector.mixed)];
    return {{sector.uv[0] + deviation[0], sector.uv[1] + deviation[1]}};
  }

  // The mean squared distance of the corners from their mean, in steps of the sector's grid.
  double squares_within(const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    return sector.is_uniform() ? 0 : m_squares[std::size_t(sector.mixed)];
  }

private:
  Grid_uv split(const Uv& uv) const
  {
    const Grid_value u = m_grid.split(uv[0]), v = m_grid.split(uv[1]);
    return {{{u.base, v.base}}, {{u.offset, v.offset}}};
  }

  Grid_uv changed_coordinates(const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    const int magnification = sector.magnification;
    Grid_uv result = split({{std::ldexp(sector.uv[0], magnification),
                             std::ldexp(sector.uv[1], magnification)}});
    for(std::size_t c = 0; c < 2 && !sector.is_uniform(); ++c)
      result.offset[c] += in_steps(m_deviations[std::size_t(sector.mixed)][c], magnification);
    const auto found = m_shifts.find(s);
    for(std::size_t c = 0; c < 2 && found != m_shifts.end(); ++c)
      result.offset[c] += found->second[c];
    return result;
  }

  double in_steps(const double x, const int magnification) const
  {
    return m_grid.in_steps(magnification == 0 ? x : std::ldexp(x, magnification));
  }

  // The corners are so close together that their differences are exact, or nearly so.
  void set_mean(const Sector_index s, const HalfedgeUVMap& uv_map)
  {
    const Sector& sector = m_sectors.sector(s);
    Uv sum{{0, 0}};
    double squares = 0;
    const auto first = m_sectors.corners_begin(s), last = m_sectors.corners_end(s);
    for(auto h = first; h != last; ++h) {
      const Uv corner = get_uv(uv_map, *h);
      for(std::size_t c = 0; c < 2; ++c) {
        const double difference = corner[c] - sector.uv[c];
        const double steps = in_steps(difference, sector.magnification);
        sum[c] += difference;
        squares += steps * steps;
      }
    }
    const double count = static_cast<double>(last - first);
    for(std::size_t c = 0; c < 2; ++c) {
      m_deviations[std::size_t(sector.mixed)][c] = sum[c] / count;
      const double steps = in_steps(sum[c], sector.magnification);
      squares -= steps * (steps / count);
    }
    m_squares[std::size_t(sector.mixed)] = (std::max)(squares, 0.) / count;
  }

  const Sectors& m_sectors;
  Grid m_grid;
  std::vector<Uv> m_deviations; // of the means of mixed sectors from their first corners
  std::vector<double> m_squares;
  std::unordered_map<Sector_index, Uv> m_shifts;
};

// u- - R u+ - t for sectors beside a cut: exact in the bases.
inline Uv transition_gap(const Grid_uv& plus, const Grid_uv& minus, const Rotation& r,
                         const Grid_vector& t)
{
  const Grid_vector base = r(plus.base);
  const Uv offset = r(plus.offset);
  Uv gap;
  for(std::size_t c = 0; c < 2; ++c)
    gap[c] = static_cast<double>(minus.base[c] - base[c] - t[c]) + (minus.offset[c] - offset[c]);
  return gap;
}

// How two sectors of weights a and b share what separates them: the price per unit of squared gap.
inline double shared_weight(const double a, const double b) { return a * b / (a + b); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_COORDINATES_H
