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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ALIGNMENT_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ALIGNMENT_H

#include <CGAL/license/Seamless_snapping.h>

// Which coordinate is to be constant on each aligned facet, and which two along each aligned edge.

#include <CGAL/Seamless_snapping/internal/volume/Volume_transitions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Volume_alignment
{
  std::vector<int> coordinate; // per aligned facet: the constant one
  std::vector<int> direction;  // per aligned edge: the one that is not constant
  double violation = 0;        // the largest difference of a coordinate that is to be constant
  Message worst;           // where that is
};

// The coordinate that is not constant along an edge.
inline int direction_of(const Flat_volume& volume, const Flat_volume::Aligned_edge& edge)
{
  if(edge.direction >= 0)
    return edge.direction;
  const Uvw d = vector_to(volume.uvw(edge.a), volume.uvw(edge.b));
  return int(std::max_element(d.begin(), d.end(), [](const double x, const double y)
                              { return std::abs(x) < std::abs(y); }) - d.begin());
}

// Calls f(corners, c, name) for the corners of each aligned facet or edge, and each coordinate that
// is constant there.
template <typename F>
void for_each_level(const Flat_volume& volume, const Volume_alignment& alignment, const F& f)
{
  for(std::size_t i = 0; i < volume.aligned_facets.size(); ++i)
    f(corners_of_facet(volume.aligned_facets[i]), std::size_t(alignment.coordinate[i]),
      [&] { return volume.name_of_facet(volume.aligned_facets[i]); });
  for(std::size_t i = 0; i < volume.aligned_edges.size(); ++i)
    for(std::size_t c = 0; c < 3; ++c)
      if(const Flat_volume::Aligned_edge& edge = volume.aligned_edges[i];
         int(c) != alignment.direction[i])
        f(std::array<Corner_index, 2>{{edge.a, edge.b}}, c,
          [&] { return volume.name_of_edge(edge); });
}

// A facet that is thinner than the noise takes the coordinate of the facets around it, which lie in
// the same plane unless there is a crease.
class Facet_alignment_reader
{
  using Group = Cube_rotations;

public:
  Facet_alignment_reader(const Flat_volume& volume, const Volume_transitions& transitions)
    : m_volume(volume),
      m_element(elements_of_facets(volume, transitions, false, Group::identity())),
      m_place(volume.places_in(volume.aligned_facets)), m_noise(transitions.noise)
  { }

  Volume_alignment read()
  {
    fit_facets();
    std::vector<std::size_t> undecided;
    for(std::size_t i = 0; i < m_volume.aligned_facets.size(); ++i) {
      m_is_decided.push_back(is_clear(i));
      if(m_is_decided[i] == 0)
        undecided.push_back(i);
    }
    decide_by_surroundings( // where nothing tells, what fits best stays
      std::move(undecided), [&](const std::size_t i) { return most_wanted_coordinate(i); },
      [&](const std::size_t i, const int k) {
        m_result.coordinate[i] = k;
        m_is_decided[i] = 1;
      });
    for(const Flat_volume::Aligned_edge& edge : m_volume.aligned_edges)
      m_result.direction.push_back(direction_of(m_volume, edge));
    for_each_level(m_volume, m_result, [&](const auto& corners, const std::size_t c,
                                           const auto& name) {
      if(const double miss = spread(m_volume, corners)[c]; miss > m_result.violation) {
        m_result.violation = miss;
        m_result.worst = name();
      }
    });
    return std::move(m_result);
  }

private:
  void fit_facets()
  {
    for(const Corner_index facet : m_volume.aligned_facets) {
      const Uvw s = spread(m_volume, corners_of_facet(facet));
      const auto least = std::min_element(s.begin(), s.end());
      m_result.coordinate.push_back(int(least - s.begin()));
      raise_at(m_volume, facet, *least, m_noise);
    }
  }

  double largest_spread(const Corner_index facet) const
  { return largest_noise_in_residuals * largest_at(m_volume, m_noise, facet); }

  // Whether one coordinate alone may be the constant one.
  bool is_clear(const std::size_t i) const
  {
    const Uvw s = spread(m_volume, corners_of_facet(m_volume.aligned_facets[i]));
    const double largest = largest_spread(m_volume.aligned_facets[i]);
    return std::count_if(s.begin(), s.end(), [&](const double x) { return x <= largest; }) <= 1;
  }

  std::optional<int> most_wanted_coordinate(const std::size_t i) const
  {
    const Corner_index facet = m_volume.aligned_facets[i];
    const Uvw s = spread(m_volume, corners_of_facet(facet));
    return most_wanted<3>(
      facet, [&](const Corner_index third) { return wanted_at_edge(facet, third); },
      [&](const int k) { return s[std::size_t(k)]; }, largest_spread(facet));
  }

  // The coordinate of the next aligned facet around the edge opposite to `third`, in the chart of
  // this one, if that is decided.
  std::optional<int> wanted_at_edge(const Corner_index facet, const Corner_index third) const
  {
    Facet_ring ring(m_volume, facet, third);
    int g = Group::identity(); // from the chart of the facet's cell
    for(ring.turn(); !ring.is_closed(); ring.turn()) {
      const std::int32_t i = m_place[std::size_t(ring.facet())];
      if(i >= 0)
        return wanted_by(std::size_t(i), ring.facet(), g);
      if(!ring.can_cross())
        return std::nullopt;
      g = Group::compose(m_element[std::size_t(ring.facet())], g);
      ring.cross();
    }
    return std::nullopt;
  }

  // \param facet aligned facet i, from the side of a cell to whose chart `g` leads
  std::optional<int> wanted_by(const std::size_t i, const Corner_index facet, int g) const
  {
    if(m_is_decided[i] == 0)
      return std::nullopt;
    if(m_volume.aligned_facets[i] != facet) // its coordinate belongs to the other cell
      g = Group::compose(m_element[std::size_t(facet)], g);
    return int(Group::source(g, std::size_t(m_result.coordinate[i])));
  }

  const Flat_volume& m_volume;
  std::vector<signed char> m_element; // per facet: to the other side
  std::vector<std::int32_t> m_place;  // per facet: among the aligned ones, or -1
  std::vector<double> m_noise;        // per vertex
  std::vector<char> m_is_decided;     // per aligned facet
  Volume_alignment m_result;
};

// All that is asked of the coordinates.
struct Volume_constraints
{
  Volume_transitions transitions;
  Volume_alignment alignment;
};

inline Volume_constraints read_constraints(const Flat_volume& volume)
{
  Volume_constraints result{Facet_transition_reader(volume).read(), {}};
  result.alignment = Facet_alignment_reader(volume, result.transitions).read();
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_ALIGNMENT_H
