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
#include <array>
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
// Arcs and levels belong to the first member, whose sectors are named by slots, counted from the
// place's first.
struct Volume_places
{
  struct Place
  {
    std::size_t first_slot, number_of_slots;
    std::vector<Sector_number> members; // the sectors of the first in the order of slots, and so on
    std::vector<Sector_arc> arcs;
    std::vector<Sector_level> levels;

    bool is_constrained() const { return !arcs.empty() || !levels.empty(); }
    std::size_t number_of_members() const { return members.size() / number_of_slots; }
    Sector_number sector(const std::size_t member, const std::size_t slot) const
    {
      return members[member * number_of_slots + slot];
    }
    // The column of coordinate c of a slot in the system of places, which members share.
    std::size_t column(const std::size_t slot, const std::size_t c) const
    { return 3 * (first_slot + slot) + c; }
  };

  std::vector<Place> places;
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
    // grids of charts that are not joined differ
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
    Volume_places::Place place{m_result.number_of_slots, part.size(), part, {}, {}};
    for(std::size_t i = 0; i < part.size(); ++i)
      m_slot[std::size_t(part[i])] = std::int32_t(i);
    for(const Sector_number s : part) {
      const Sector_number slot = m_slot[std::size_t(s)];
      for(const Link& link : m_links[std::size_t(s)])
        if(link.first % 2 == 0)
          place.arcs.push_back({slot, m_slot[std::size_t(link.second)], link.first / 2});
      for(const Label& label : m_levels[std::size_t(s)])
        place.levels.push_back({slot, label.first, label.second});
    }
    for(const Sector_number s : part)
      m_slot[std::size_t(s)] = -1;
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

// How the members of a place can differ: by moves that leave translations and levels alone. One
// takes slot i by R_i e, where e is fixed by the rotations of all loops of arcs, and R_i e is 0 in
// coordinates that have a level. As rotations permute coordinates, this makes coordinates of e
// equal up to a sign, or 0: the integer moves have a basis of vectors without common entries.
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

inline Place_freedom freedom_of(const Volume_places::Place& place,
                                const std::vector<Cube_rotations::Element>& sheet_element)
{
  using Group = Cube_rotations;
  Place_freedom result{std::vector<int>(place.number_of_slots, -1), {}, {}};
  std::vector<int>& rotation = result.rotation;
  rotation[0] = Group::identity();
  for(bool is_done = false; !is_done;) { // the arcs connect the slots
    is_done = true;
    for(const Sector_arc& arc : place.arcs) {
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
  for(const Sector_arc& arc : place.arcs) {
    const int along = Group::compose(sheet_element[std::size_t(arc.sheet)],
                                     rotation[std::size_t(arc.plus)]);
    const int loop = Group::compose(Group::inverse(rotation[std::size_t(arc.minus)]), along);
    for(std::size_t c = 0; c < 3; ++c)
      coordinates.unite(c, Group::source(loop, c), Group::sign(loop, c));
  }
  for(const Sector_level& level : place.levels)
    coordinates.set_zero(Group::source(rotation[std::size_t(level.sector)],
                                       std::size_t(level.coordinate)));
  for(std::size_t c = 0; c < 3; ++c) {
    const auto found = coordinates.find(c);
    result.first[c] = coordinates.is_zero(c) ? -1 : int(found.index);
    result.sign[c] = found.sign;
  }
  return result;
}

using Member_index = std::size_t;

// Invariant: a member moves by a vector e, where coordinates of one class of its freedom are equal
// up to signs: each class is an unknown. Sector i of the member moves by R_i e.
class Volume_members
{
  using Group = Cube_rotations;
  using Place = Volume_places::Place;

public:
  // A corner's coordinate moves by a sign times an unknown, or not at all (sign 0).
  struct Term
  {
    std::size_t unknown;
    int sign;
  };

  Volume_members(const Volume_sectors& sectors, const Volume_places& places)
    : m_sectors(sectors), m_places(places), m_member_of_sector(sectors.number_of_sectors())
  {
    for(std::size_t p = 0; p < places.places.size(); ++p) {
      const Place& place = places.places[p];
      m_freedoms.push_back(freedom_of(place, sectors.sheet_element));
      for(std::size_t i = 0; i < place.members.size(); ++i)
        m_member_of_sector[std::size_t(place.members[i])] =
          {m_member.size() + i / place.number_of_slots, i % place.number_of_slots};
      for(std::size_t m = 0; m < place.number_of_members(); ++m) {
        m_member.push_back({p, m});
        m_first_unknown.push_back(m_number_of_unknowns);
        m_number_of_unknowns += std::size_t(m_freedoms.back().dimension());
      }
    }
  }

  std::size_t size() const { return m_member.size(); }
  std::size_t number_of_unknowns() const { return m_number_of_unknowns; }
  const Place& place(const Member_index m) const { return m_places.places[m_member[m].first]; }
  const Place_freedom& freedom(const Member_index m) const
  {
    return m_freedoms[m_member[m].first];
  }

  // The unknowns of a member are consecutive.
  std::size_t first_unknown(const Member_index m) const { return m_first_unknown[m]; }

  Member_index member_of_corner(const Corner_index i) const
  {
    return m_member_of_sector[std::size_t(m_sectors.sector[std::size_t(i)])].first;
  }

  Sector_number sector(const Member_index m, const std::size_t slot) const
  {
    return place(m).sector(m_member[m].second, slot);
  }

  // Calls f(slot, corner) for all corners of a member.
  template <typename F>
  void for_each_corner(const Member_index m, const F& f) const
  {
    for(std::size_t slot = 0; slot < place(m).number_of_slots; ++slot)
      for(const Corner_index i : m_sectors.corners[sector(m, slot)])
        f(slot, i);
  }

  // Keeps what `move()` does to the coordinates of a member if it returns that it is a gain, and no
  // cell at the member is worse by it; else takes it back. Returns whether it is kept.
  template <typename Move, typename IsGood>
  bool try_move(const Member_index m, std::vector<Uvw>& coordinates, const Move& move,
                const IsGood& is_good) const
  {
    std::vector<Uvw> before;
    std::vector<char> was_good;
    for_each_corner(m, [&](std::size_t, const Corner_index i) {
      before.push_back(coordinates[std::size_t(i)]);
      was_good.push_back(is_good(std::size_t(i / 4)));
    });
    bool is_kept = move();
    std::size_t k = 0;
    for_each_corner(m, [&](std::size_t, const Corner_index i) {
      is_kept = is_kept && (was_good[k] == 0 || is_good(std::size_t(i / 4)));
      ++k;
    });
    k = 0;
    if(!is_kept)
      for_each_corner(m, [&](std::size_t, const Corner_index i) {
        coordinates[std::size_t(i)] = before[k++];
      });
    return is_kept;
  }

  std::size_t column(const Member_index m, const std::size_t slot, const std::size_t c) const
  { return place(m).column(slot, c); }

  std::size_t column(const Corner_index i, const std::size_t c) const
  { return column(member_of_corner(i), slot_of_corner(i), c); }

  // How coordinate c of a sector moves.
  Term term(const Member_index m, const std::size_t slot, const std::size_t c) const
  {
    const Place_freedom& f = freedom(m);
    const std::size_t source = Group::source(f.rotation[slot], c);
    if(f.first[source] < 0)
      return {0, 0};
    std::size_t unknown = first_unknown(m);
    for(int k = 0; k < f.first[source]; ++k)
      unknown += std::size_t(f.first[std::size_t(k)] == k);
    return {unknown, Group::sign(f.rotation[slot], c) * f.sign[source]};
  }

  Term term(const Corner_index i, const std::size_t c) const
  { return term(member_of_corner(i), slot_of_corner(i), c); }

private:
  std::size_t slot_of_corner(const Corner_index i) const
  { return m_member_of_sector[std::size_t(m_sectors.sector[std::size_t(i)])].second; }

  const Volume_sectors& m_sectors;
  const Volume_places& m_places;
  std::vector<std::pair<std::size_t, std::size_t> > m_member; // the place, and which of its members
  std::vector<std::size_t> m_first_unknown;                   // per member
  std::vector<std::pair<Member_index, std::size_t> > m_member_of_sector; // and which slot
  std::vector<Place_freedom> m_freedoms;                      // per place
  std::size_t m_number_of_unknowns = 0;
};

// All that constraints say of a volume. Its parts refer to each other.
struct Volume_structure
{
  Volume_sectors sectors;
  Volume_charts charts;
  Volume_places places;
  Volume_members members;

  Volume_structure(Volume_sectors of_vertices, Volume_charts of_cells)
    : sectors(std::move(of_vertices)), charts(std::move(of_cells)),
      places(Place_finder(sectors, charts).find()), members(sectors, places)
  { }
  Volume_structure(const Volume_structure&) = delete;
  Volume_structure& operator=(const Volume_structure&) = delete;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_PLACES_H
