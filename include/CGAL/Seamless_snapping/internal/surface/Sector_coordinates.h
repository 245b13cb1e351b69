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

// In steps of the sector's own grid. Sectors whose corners differ are represented by their mean. All others are computed when asked for, which
// is cheaper than to store them.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Sector_coordinates
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;

public:
  Sector_coordinates(const Sectors& sectors, const HalfedgeUVMap& uv_map, const Grid& grid)
    : m_sectors(sectors), m_grid(grid), m_means(sectors.number_of_mixed_sectors()),
      m_squares(sectors.number_of_mixed_sectors())
  {
    if(!m_means.empty())
      for(std::size_t s = 0; s < sectors.number_of_sectors(); ++s)
        if(!sectors.sector(Sector_index(s)).is_uniform())
          set_mean(Sector_index(s), uv_map);
  }

  // In steps of the grid of the largest coordinates; adds to earlier shifts. Returns false if the sum
  // is too large for the grid's integers.
  bool shift(const Sector_index s, const Uv& by)
  {
    Uv& sum = m_shifts[s];
    for(std::size_t c = 0; c < 2; ++c)
      sum[c] += std::ldexp(by[c], m_sectors.sector(s).magnification);
    constexpr double largest = 1152921504606846976.; // 2^60
    return std::abs(sum[0]) < largest && std::abs(sum[1]) < largest;
  }

  Grid_uv operator[](const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    Grid_uv result = sector.is_uniform() ? split(sector.uv, sector.magnification) : m_means[std::size_t(sector.mixed)];
    if(m_shifts.empty())
      return result;
    const auto found = m_shifts.find(s);
    for(std::size_t c = 0; c < 2 && found != m_shifts.end(); ++c)
      result.offset[c] += found->second[c];
    return result;
  }

  // The mean squared distance of the corners from their mean, in steps of the sector's grid.
  double squares_within(const Sector_index s) const
  {
    const Sector& sector = m_sectors.sector(s);
    return sector.is_uniform() ? 0 : m_squares[std::size_t(sector.mixed)];
  }

private:
  Grid_uv split(Uv uv, const int magnification) const
  {
    for(std::size_t c = 0; c < 2 && magnification != 0; ++c)
      uv[c] = std::ldexp(uv[c], magnification);
    const Grid_value u = m_grid.split(uv[0]), v = m_grid.split(uv[1]);
    return {{{u.base, v.base}}, {{u.offset, v.offset}}};
  }

  void set_mean(const Sector_index s, const HalfedgeUVMap& uv_map)
  {
    const Sector& sector = m_sectors.sector(s);
    Grid_uv& mean = m_means[std::size_t(sector.mixed)];
    mean = split(sector.uv, sector.magnification);
    Uv sum{{0, 0}};
    double squares = 0;
    const auto first = m_sectors.corners_begin(s), last = m_sectors.corners_end(s);
    for(auto h = first; h != last; ++h) {
      const Grid_uv corner = split(get_uv(uv_map, *h), sector.magnification);
      for(std::size_t c = 0; c < 2; ++c) {
        const double d = static_cast<double>(corner.base[c] - mean.base[c]) + (corner.offset[c] - mean.offset[c]);
        sum[c] += d;
        squares += d * d;
      }
    }
    const double count = static_cast<double>(last - first);
    for(std::size_t c = 0; c < 2; ++c) {
      mean.offset[c] += sum[c] / count;
      squares -= sum[c] * sum[c] / count;
    }
    m_squares[std::size_t(sector.mixed)] = (std::max)(squares, 0.) / count;
  }

  const Sectors& m_sectors;
  Grid m_grid;
  std::vector<Grid_uv> m_means; // of mixed sectors
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
