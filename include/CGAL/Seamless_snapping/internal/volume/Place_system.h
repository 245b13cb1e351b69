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
// such that the arcs of a sheet have one translation, and levels one value.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Seamless_snapping/internal/volume/Place_coordinates.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: column 3 s + c is coordinate c of slot s, the mean over the members of the place, and
// weighs as much as they do. So this system has the optimum of that of all members.
class Place_system
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;

public:
  Place_system(const Volume_sectors& sectors, const Volume_places& places)
    : m_sectors(sectors), m_places(places), m_builder(3 * places.number_of_slots)
  {
    for(const Place& place : places.places)
      m_weights.insert(m_weights.end(), 3 * place.number_of_slots,
                       static_cast<double>(place.number_of_members()));
    choose_references();
    for(const Place& place : places.places) {
      for(std::size_t i = place.first_arc; i < place.end_of_arcs; ++i)
        add_arc(place, places.arcs[i]);
      for(std::size_t i = place.first_level; i < place.end_of_levels; ++i)
        add_level(place, places.levels[i]);
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
      for(std::size_t i = place.first_arc; i < place.end_of_arcs; ++i) {
        Reference& reference = m_reference[std::size_t(m_places.arcs[i].sheet)];
        if(reference.place == nullptr ||
           place.number_of_slots < reference.place->number_of_slots)
          reference = {&place, &m_places.arcs[i]};
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
    append(Coordinate_classes::column(place, arc.minus, c), sign);
    append(Coordinate_classes::column(place, arc.plus, Group::source(g, c)),
           -sign * Group::sign(g, c));
  }

  void add_level(const Place& place, const Sector_level& level)
  {
    std::int64_t& first = m_first_of_level[std::size_t(level.level)];
    const std::size_t column =
      Coordinate_classes::column(place, level.sector, std::size_t(level.coordinate));
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
