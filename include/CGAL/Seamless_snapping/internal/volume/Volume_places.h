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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_PLACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_PLACES_H

#include <CGAL/license/Seamless_snapping.h>

// Vertices at which the same sheets and levels meet in the same way: they have the same equations,
// so that one of them stands for all in the system.

#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_sectors.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Places have slots, and each of their members has a sector in each slot. What the arcs of two
// vertices have in common is told by the names of sheets and levels alone, so that members need
// not be near each other. Where corners of the mesh touch at a vertex, each part is a member.
// Arcs and levels are those of the first member, whose sectors are named by slots.
struct Volume_places
{
  struct Place
  {
    std::size_t first_slot, number_of_slots;
    std::size_t first_arc, end_of_arcs, first_level, end_of_levels;
    std::vector<Sector_number> members; // the sectors of the first in the order of slots, and so on

    bool is_constrained() const
    { return first_arc != end_of_arcs || first_level != end_of_levels; }
    std::size_t number_of_members() const { return members.size() / number_of_slots; }
    Sector_number sector(const std::size_t member, const std::size_t slot) const
    {
      return members[member * number_of_slots + slot];
    }
  };

  std::vector<Place> places;
  std::vector<Sector_arc> arcs;     // by place; sectors are slots, counted from the place's first
  std::vector<Sector_level> levels; // likewise
  std::size_t number_of_slots = 0;
};

class Place_finder
{
public:
  Place_finder(const Volume_sectors& sectors, const Volume_charts& charts)
    : m_sectors(sectors), m_charts(charts), m_links(sectors.number_of_sectors()),
      m_levels(sectors.number_of_sectors()), m_slot(sectors.number_of_sectors(), -1)
  {
    for(const Sector_arc& arc : sectors.arcs) {
      m_links[std::size_t(arc.plus)].push_back({2 * arc.sheet, arc.minus});
      m_links[std::size_t(arc.minus)].push_back({2 * arc.sheet + 1, arc.plus});
    }
    for(std::vector<Link>& links : m_links)
      std::sort(links.begin(), links.end());
    for(const Sector_level& level : sectors.levels)
      m_levels[std::size_t(level.sector)].push_back({level.coordinate, level.level});
  }

  Volume_places find()
  {
    std::vector<char> is_done(m_sectors.number_of_sectors(), 0);
    for(std::size_t s = 0; s < is_done.size(); ++s)
      if(is_done[s] == 0) {
        const std::vector<Sector_number> part = part_of(Sector_number(s));
        for(const Sector_number t : part)
          is_done[std::size_t(t)] = 1;
        add(part);
      }
    return std::move(m_result);
  }

private:
  using Link = std::pair<std::int32_t, Sector_number>;  // the sheet and the direction, and where to
  using Label = std::pair<std::int32_t, Level_number>; // the coordinate and its level
  using Word = std::vector<std::int32_t>;

  // The sectors that arcs connect with one, in the order that their labels tell.
  std::vector<Sector_number> part_of(const Sector_number root)
  {
    std::vector<Sector_number> part(1, root);
    m_slot[std::size_t(root)] = 0;
    for(std::size_t i = 0; i < part.size(); ++i)
      for(const Link& link : m_links[std::size_t(part[i])])
        if(m_slot[std::size_t(link.second)] < 0) {
          m_slot[std::size_t(link.second)] = std::int32_t(part.size());
          part.push_back(link.second);
        }
    for(const Sector_number s : part)
      m_slot[std::size_t(s)] = -1;
    return part;
  }

  // All that is known of a part, with slots for sectors.
  Word word_of(const std::vector<Sector_number>& part)
  {
    Word word;
    for(std::size_t i = 0; i < part.size(); ++i)
      m_slot[std::size_t(part[i])] = std::int32_t(i);
    for(const Sector_number s : part) {
      for(const Link& link : m_links[std::size_t(s)])
        word.insert(word.end(), {link.first, m_slot[std::size_t(link.second)]});
      word.push_back(-1);
      for(const Label& label : m_levels[std::size_t(s)])
        word.insert(word.end(), {label.first, label.second});
      word.push_back(-1);
    }
    for(const Sector_number s : part)
      m_slot[std::size_t(s)] = -1;
    if(!m_charts.are_given()) // their grids differ
      word.push_back(std::int32_t(m_charts.root(m_sectors.corners[part[0]].front())));
    return word;
  }

  // Whether two arcs at a sector have the same label, so that these tell no order.
  bool is_ambiguous(const std::vector<Sector_number>& part) const
  {
    for(const Sector_number s : part) {
      const std::vector<Link>& links = m_links[std::size_t(s)];
      for(std::size_t i = 1; i < links.size(); ++i)
        if(links[i].first == links[i - 1].first)
          return true;
    }
    return false;
  }

  // The order of sectors with the least word makes equal patterns equal words.
  void add(const std::vector<Sector_number>& part)
  {
    if(is_ambiguous(part))
      return add_place(part);
    std::vector<Sector_number> best = part;
    Word least = word_of(part);
    for(std::size_t i = 1; i < part.size(); ++i) {
      std::vector<Sector_number> other = part_of(part[i]);
      Word word = word_of(other);
      if(word < least) {
        least.swap(word);
        best.swap(other);
      }
    }
    const auto [found, is_new] = m_place_of_word.emplace(std::move(least),
                                                         m_result.places.size());
    if(is_new)
      return add_place(best);
    std::vector<Sector_number>& members = m_result.places[found->second].members;
    members.insert(members.end(), best.begin(), best.end());
  }

  void add_place(const std::vector<Sector_number>& part)
  {
    Volume_places::Place place{m_result.number_of_slots, part.size(), m_result.arcs.size(), 0,
                               m_result.levels.size(), 0, part};
    for(std::size_t i = 0; i < part.size(); ++i)
      m_slot[std::size_t(part[i])] = std::int32_t(i);
    for(const Sector_number s : part) {
      const Sector_number slot = m_slot[std::size_t(s)];
      for(const Link& link : m_links[std::size_t(s)])
        if(link.first % 2 == 0)
          m_result.arcs.push_back({slot, m_slot[std::size_t(link.second)], link.first / 2});
      for(const Label& label : m_levels[std::size_t(s)])
        m_result.levels.push_back({slot, label.first, label.second});
    }
    for(const Sector_number s : part)
      m_slot[std::size_t(s)] = -1;
    place.end_of_arcs = m_result.arcs.size();
    place.end_of_levels = m_result.levels.size();
    m_result.number_of_slots += part.size();
    m_result.places.push_back(std::move(place));
  }

  const Volume_sectors& m_sectors;
  const Volume_charts& m_charts;
  std::vector<std::vector<Link> > m_links;   // per sector
  std::vector<std::vector<Label> > m_levels; // per sector
  std::vector<std::int32_t> m_slot;          // per sector, of the part at hand; else -1
  std::unordered_map<Word, std::size_t, boost::hash<Word> > m_place_of_word;
  Volume_places m_result;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_PLACES_H
