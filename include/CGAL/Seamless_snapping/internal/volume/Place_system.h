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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SYSTEM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SYSTEM_H

#include <CGAL/license/Seamless_snapping.h>

// The constraint system of [MC19] Sec. 5.3 for volumes: the coordinates of the slots of all places,
// such that the arcs of a sheet have one translation, and levels one value. They approximate the
// mean of the members of a place, on a common grid for all that depend on each other.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Classes of coordinates that some arc or level links; named by their least member. Coordinate c of
// slot s is 3 s + c. It is a coarser partition than that into components of the reduced system,
// where sheets with one arc have no row.
class Coordinate_classes
{
  using Group = Cube_rotations;

public:
  explicit Coordinate_classes(const Volume_structure& structure)
    : m_root(3 * structure.places.number_of_slots)
  {
    const Volume_sectors& sectors = structure.sectors;
    const std::size_t first_sheet = m_root.size();
    const std::size_t first_level = first_sheet + 3 * sectors.sheet_element.size();
    Signed_union_find classes(first_level + sectors.number_of_levels);
    for(const Volume_places::Place& place : structure.places.places) {
      for(const Sector_arc& arc : place.arcs) {
        const int g = sectors.sheet_element[std::size_t(arc.sheet)];
        for(std::size_t c = 0; c < 3; ++c) {
          const std::size_t minus = place.column(std::size_t(arc.minus), c);
          classes.unite(minus, place.column(std::size_t(arc.plus), Group::source(g, c)));
          classes.unite(minus, first_sheet + 3 * std::size_t(arc.sheet) + c);
        }
      }
      for(const Sector_level& level : place.levels)
        classes.unite(place.column(std::size_t(level.sector), std::size_t(level.coordinate)),
                      first_level + std::size_t(level.level));
    }
    for(std::size_t j = 0; j < m_root.size(); ++j)
      m_root[j] = classes.root(j);
  }

  std::size_t size() const { return m_root.size(); }
  std::size_t root(const std::size_t j) const { return m_root[j]; }

private:
  std::vector<std::size_t> m_root; // per coordinate of a slot
};

// The mean of grid values, without loss of digits: relative to the first, and in two parts whose
// sums have room for 2^31 values.
class Mean_of_grid_values
{
public:
  void add(const Grid_value& v)
  {
    if(m_count == 0)
      m_first = v.base;
    const std::int64_t d = v.base - m_first;
    const std::int64_t high = (d >= 0 ? d : d - (radix - 1)) / radix;
    m_high += high;
    m_low += d - high * radix;
    m_offset += v.offset;
    ++m_count;
  }

  Grid_value mean() const
  {
    const double offset = m_offset / static_cast<double>(m_count);
    const std::int64_t rest = (m_high % m_count) * radix + m_low;
    return {m_first + (m_high / m_count) * radix + rest / m_count,
            static_cast<double>(rest % m_count) / static_cast<double>(m_count) + offset};
  }

  // The integer next to the mean; 0 without values.
  std::int64_t rounded() const
  {
    const Grid_value v = m_count == 0 ? Grid_value() : mean();
    return v.base + nearest_integer(v.offset);
  }

private:
  static constexpr std::int64_t radix = std::int64_t(1) << 28;
  std::int64_t m_first = 0, m_high = 0, m_low = 0, m_count = 0;
  double m_offset = 0;
};

// The mean of the corners of sectors: they are one place in the result.
class Sector_means
{
public:
  // \param u per corner
  Sector_means(const std::vector<Uvw>& u, const Volume_structure& structure)
    : m_u(u), m_sectors(structure.sectors), m_charts(structure.charts)
  { }

  // As numbers of a grid, with what is left.
  Grid_value operator()(const Sector_number s, const std::size_t c, const Grid& grid) const
  {
    const auto corners = m_sectors.corners[s];
    const double first = coordinate(corners.front(), c);
    double deviation = 0;
    for(const Corner_index i : corners)
      deviation += coordinate(i, c) - first;
    Grid_value result = grid.split(first);
    if(deviation != 0)
      result.offset += grid.in_steps(deviation / static_cast<double>(corners.size()));
    return result;
  }

  // The mean over all members of a place.
  Grid_value operator()(const Volume_places::Place& place, const std::size_t slot,
                        const std::size_t c, const Grid& grid) const
  {
    Mean_of_grid_values mean;
    for(std::size_t m = 0; m < place.number_of_members(); ++m)
      mean.add((*this)(place.sector(m, slot), c, grid));
    return mean.mean();
  }

  // In the chart of the system, and in the chart of the input.
  double largest(const Sector_number s, const std::size_t c) const
  {
    double result = 0;
    for(const Corner_index i : m_sectors.corners[s]) {
      const double u = coordinate(i, c);
      result = (std::max)({result, std::abs(u), std::abs(u - m_charts.shift(std::size_t(i), c))});
    }
    return result;
  }

private:
  double coordinate(const Corner_index i, const std::size_t c) const
  {
    return m_charts.coordinate(m_u[std::size_t(i)], std::size_t(i), c);
  }

  const std::vector<Uvw>& m_u;
  const Volume_sectors& m_sectors;
  const Volume_charts& m_charts;
};

// Invariant: column 3 s + c is coordinate c of slot s, the mean over the members of the place, and
// weighs as much as they do. So this system has the optimum of the system of all members.
class Place_system
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;

public:
  explicit Place_system(const Volume_structure& structure)
    : m_sectors(structure.sectors), m_places(structure.places),
      m_builder(3 * m_places.number_of_slots)
  {
    for(const Place& place : m_places.places)
      m_weights.insert(m_weights.end(), 3 * place.number_of_slots,
                       static_cast<double>(place.number_of_members()));
    choose_references();
    for(const Place& place : m_places.places) {
      for(const Sector_arc& arc : place.arcs)
        add_arc(place, arc);
      for(const Sector_level& level : place.levels)
        add_level(place, level);
    }
    m_rows = m_builder.take();
  }

  const Scaled_system& rows() const { return m_rows; }
  const std::vector<double>& weights() const { return m_weights; }

private:
  struct Reference
  {
    const Place* place = nullptr;
    const Sector_arc* arc = nullptr;
  };

  // For each sheet an arc that stands for its translation: at a place with few sectors.
  void choose_references()
  {
    m_reference.resize(m_sectors.sheet_element.size());
    m_first_of_level.assign(m_sectors.number_of_levels, -1);
    for(const Place& place : m_places.places)
      for(const Sector_arc& arc : place.arcs) {
        Reference& reference = m_reference[std::size_t(arc.sheet)];
        if(reference.place == nullptr ||
           place.number_of_slots < reference.place->number_of_slots)
          reference = {&place, &arc};
      }
  }

  // u(minus) - g u(plus), which is t, less the same for the reference.
  void add_arc(const Place& place, const Sector_arc& arc)
  {
    const Reference& reference = m_reference[std::size_t(arc.sheet)];
    if(reference.arc == &arc)
      return;
    for(std::size_t c = 0; c < 3; ++c) {
      append_translation(place, arc, c, 1);
      append_translation(*reference.place, *reference.arc, c, -1);
      add_row();
    }
  }

  void append_translation(const Place& place, const Sector_arc& arc, const std::size_t c,
                          const int sign)
  {
    const int g = m_sectors.sheet_element[std::size_t(arc.sheet)];
    append(place.column(std::size_t(arc.minus), c), sign);
    append(place.column(std::size_t(arc.plus), Group::source(g, c)), -sign * Group::sign(g, c));
  }

  void add_level(const Place& place, const Sector_level& level)
  {
    std::int64_t& first = m_first_of_level[std::size_t(level.level)];
    const std::size_t column =
      place.column(std::size_t(level.sector), std::size_t(level.coordinate));
    if(first < 0) {
      first = std::int64_t(column);
      return;
    }
    append(column, 1);
    append(std::size_t(first), -1);
    add_row();
  }

  void append(const std::size_t column, const int coefficient)
  {
    m_row.push_back({Column_index(column), coefficient});
  }

  void add_row()
  {
    m_builder.add_row(m_row);
    m_row.clear();
  }

  const Volume_sectors& m_sectors;
  const Volume_places& m_places;
  System_builder m_builder;
  std::vector<double> m_weights;              // per column
  std::vector<Reference> m_reference;         // per sheet
  std::vector<std::int64_t> m_first_of_level; // per level: a column, or -1
  Entries<std::int64_t> m_row;                // under way
  Scaled_system m_rows;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_PLACE_SYSTEM_H
