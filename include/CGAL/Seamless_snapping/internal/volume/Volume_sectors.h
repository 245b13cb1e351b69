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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SECTORS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SECTORS_H

#include <CGAL/license/Seamless_snapping.h>

// The sectors at the vertices of a volume, and what links them: all that constraints say of
// coordinates, without the mesh.
//
// A sector is a class of corners at a vertex, between whose cells no cut runs. An arc leads from
// the sector on the one side of a cut facet to that on the other. A sheet is a class of cut facets
// that share a rotation and a translation, since some vertex of both has the same arc for them. A
// level is a class of coordinates of sectors that aligned facets and edges make equal.

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Sector_number = std::int32_t;
using Sheet_number = std::int32_t;
using Level_number = std::int32_t;

// u(minus) = g u(plus) + t, with the g and t of the sheet
struct Sector_arc
{
  Sector_number plus, minus;
  Sheet_number sheet;

  auto key() const { return std::tie(plus, minus, sheet); }
  friend bool operator<(const Sector_arc& a, const Sector_arc& b) { return a.key() < b.key(); }
  friend bool operator==(const Sector_arc& a, const Sector_arc& b) { return a.key() == b.key(); }
};

// A coordinate of a sector has a level.
struct Sector_level
{
  Sector_number sector;
  int coordinate;
  Level_number level;
};

// Invariants: the sectors of a vertex are consecutive. Arcs and levels are sorted; no arc is there
// twice. The arcs of a vertex, with t and levels the same everywhere, are all that the transitions
// and alignments of facets ask for: see the page on volumes of the manual.
struct Volume_sectors
{
  std::vector<Sector_number> sector;     // per corner; -1 at fixed vertices
  Lists<Corner_index> corners;           // per sector
  std::vector<Sector_arc> arcs;
  std::vector<Sector_level> levels;
  std::vector<Cube_rotations::Element> sheet_element; // per sheet
  std::size_t number_of_levels = 0;

  std::size_t number_of_sectors() const { return corners.size(); }
};

class Sector_builder
{
  using Group = Cube_rotations;

public:
  Sector_builder(const Flat_volume& volume, const Volume_constraints& constraints)
    : m_volume(volume), m_transitions(constraints.transitions), m_alignment(constraints.alignment)
  { }

  Volume_sectors build()
  {
    number_sectors();
    find_sheets();
    find_levels();
    return std::move(m_result);
  }

private:
  // All facets but cuts join the corners on both sides.
  void number_sectors()
  {
    const std::vector<signed char> cut = elements_of_facets(m_volume, m_transitions, true, -1);
    Signed_union_find classes(m_volume.vertices.size());
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f) {
      const Corner_index facet = Corner_index(f);
      if(m_volume.opposite[f] < facet || cut[f] >= 0)
        continue;
      for(const Corner_index corner : corners_of_facet(facet))
        if(!is_fixed(corner))
          classes.unite(std::size_t(corner), std::size_t(m_volume.across(facet, corner)));
    }
    sort_corners(classes);
  }

  bool is_fixed(const Corner_index corner) const
  {
    return m_volume.is_fixed[std::size_t(m_volume.vertex(corner))] != 0;
  }

  // By vertex, then by the first corner of the sector.
  void sort_corners(Signed_union_find& classes)
  {
    const Lists<Corner_index> of_vertices(m_volume.number_of_vertices(), [&](const auto& add) {
      for(std::size_t i = 0; i < m_volume.vertices.size(); ++i)
        if(!is_fixed(Corner_index(i)))
          add(m_volume.vertices[i], Corner_index(i));
    });
    std::vector<Sector_number>& sector = m_result.sector;
    sector.assign(m_volume.vertices.size(), -1);
    Sector_number n = 0;
    for(const Corner_index i : of_vertices.elements()) {
      const std::size_t root = classes.root(std::size_t(i)); // the first corner
      sector[std::size_t(i)] = root == std::size_t(i) ? n++ : sector[root];
    }
    m_result.corners = Lists<Corner_index>(std::size_t(n), [&](const auto& add) {
      for(std::size_t i = 0; i < sector.size(); ++i)
        if(sector[i] >= 0)
          add(sector[i], Corner_index(i));
    });
  }

  // The arc of a cut facet at a vertex, in a form that does not depend on the facet's sides.
  struct Facet_arc
  {
    Sector_number first, second;
    int element; // from the first to the second
    std::size_t facet;
    int sign;    // whether the first is on the side of the cell that the facet belongs to

    std::tuple<Sector_number, Sector_number, int> key() const
    {
      return std::make_tuple(first, second, element);
    }
  };

  Facet_arc facet_arc(const std::size_t i, const Corner_index corner) const
  {
    const Corner_index facet = m_volume.open_facets[i];
    const Facet_arc arc{m_result.sector[std::size_t(corner)],
                        m_result.sector[std::size_t(m_volume.across(facet, corner))],
                        m_transitions.element[i], i, 1};
    const Facet_arc reversed{arc.second, arc.first, Group::inverse(arc.element), i, -1};
    return reversed.key() < arc.key() ? reversed : arc;
  }

  // Facets with the same arc at some vertex have the same rotation and translation.
  void find_sheets()
  {
    std::vector<Facet_arc> arcs;
    for(std::size_t i = 0; i < m_volume.open_facets.size(); ++i)
      if(m_transitions.is_cut[i] != 0)
        for(const Corner_index corner : corners_of_facet(m_volume.open_facets[i]))
          arcs.push_back(facet_arc(i, corner));
    std::sort(arcs.begin(), arcs.end(), [](const Facet_arc& a, const Facet_arc& b) {
      return std::make_tuple(a.key(), a.facet) < std::make_tuple(b.key(), b.facet);
    });
    Signed_union_find sheets(m_volume.open_facets.size());
    for(std::size_t i = 1; i < arcs.size(); ++i)
      if(arcs[i].key() == arcs[i - 1].key())
        sheets.unite(arcs[i - 1].facet, arcs[i].facet, arcs[i - 1].sign * arcs[i].sign);
    number_sheets(sheets);
    // a one-sided sheet has an arc both ways somewhere, and needs no treatment
    for(const Facet_arc& arc : arcs) {
      const bool is_plus = arc.sign * sheets.find(arc.facet).sign > 0;
      m_result.arcs.push_back({is_plus ? arc.first : arc.second, is_plus ? arc.second : arc.first,
                               m_sheet[arc.facet]});
    }
    std::sort(m_result.arcs.begin(), m_result.arcs.end());
    m_result.arcs.erase(std::unique(m_result.arcs.begin(), m_result.arcs.end()),
                        m_result.arcs.end());
  }

  void number_sheets(Signed_union_find& sheets)
  {
    m_sheet.assign(m_volume.open_facets.size(), -1);
    for(std::size_t i = 0; i < m_sheet.size(); ++i)
      if(m_transitions.is_cut[i] != 0) {
        const std::size_t root = sheets.root(i); // the first facet of the sheet
        if(root == i)
          m_result.sheet_element.push_back(m_transitions.element[i]);
        m_sheet[i] = root == i ? Sheet_number(m_result.sheet_element.size() - 1) : m_sheet[root];
      }
  }

  void find_levels()
  {
    Signed_union_find classes(3 * m_result.number_of_sectors());
    std::vector<std::size_t> members;
    for_each_level(m_volume, m_alignment, [&](const auto& corners, const std::size_t c,
                                              const auto&) {
      const std::size_t first = members.size();
      for(const Corner_index corner : corners)
        members.push_back(3 * std::size_t(m_result.sector[std::size_t(corner)]) + c);
      for(std::size_t j = first + 1; j < members.size(); ++j)
        classes.unite(members[first], members[j]);
    });
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    std::vector<Level_number> number(classes.size(), -1);
    for(const std::size_t m : members) {
      Level_number& level = number[classes.root(m)]; // the root is the least member
      if(level < 0)
        level = Level_number(m_result.number_of_levels++);
      m_result.levels.push_back({Sector_number(m / 3), int(m % 3), level});
    }
  }

  const Flat_volume& m_volume;
  const Volume_transitions& m_transitions;
  const Volume_alignment& m_alignment;
  std::vector<Sheet_number> m_sheet; // per open facet
  Volume_sectors m_result;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SECTORS_H
