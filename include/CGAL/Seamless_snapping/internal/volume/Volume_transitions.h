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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_TRANSITIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_TRANSITIONS_H

#include <CGAL/license/Seamless_snapping.h>

// Which rotation each open facet has, and whether it is a cut: what is noise, and what is meant.

#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Differences of a facet that is no cut are at most so many times the residuals near by.
constexpr double largest_gap_in_residuals = 5;
// A rotation whose residual is at most so many times the residuals near by may be meant.
constexpr double largest_noise_in_residuals = 2;

// Facets that are not open have the identity, and are no cuts.
struct Volume_transitions
{
  std::vector<Cube_rotations::Element> element; // per open facet
  std::vector<char> is_cut;                     // per open facet
  std::vector<double> noise;                    // per vertex: residuals near by
  double violation = 0;                         // the largest
  Corner_index worst = no_facet;                // where that is
  std::size_t number_of_cuts = 0;
  std::size_t number_decided_by_surroundings = 0;
};

// Per facet, the rotation to its other side; `of_others` where a facet is not open or, if only cuts
// are asked for, is no cut.
inline std::vector<signed char> elements_of_facets(const Flat_volume& volume,
                                                   const Volume_transitions& transitions,
                                                   const bool of_cuts_only, const int of_others)
{
  std::vector<signed char> result(volume.opposite.size(), static_cast<signed char>(of_others));
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i) {
    if(of_cuts_only && transitions.is_cut[i] == 0)
      continue;
    const std::size_t facet = std::size_t(volume.open_facets[i]);
    const int g = transitions.element[i];
    result[facet] = static_cast<signed char>(g);
    result[std::size_t(volume.opposite[facet])] =
      static_cast<signed char>(Cube_rotations::inverse(g));
  }
  return result;
}

// Raises the values at the vertices of a facet to at least `x`.
inline void raise_at(const Flat_volume& volume, const Corner_index facet, const double x,
                     std::vector<double>& noise)
{
  for(const Corner_index corner : corners_of_facet(facet)) {
    double& y = noise[std::size_t(volume.vertex(corner))];
    y = (std::max)(y, x);
  }
}

// The largest value at the vertices of a facet.
inline double largest_at(const Flat_volume& volume, const std::vector<double>& noise,
                         const Corner_index facet)
{
  double result = 0;
  for(const Corner_index corner : corners_of_facet(facet))
    result = (std::max)(result, noise[std::size_t(volume.vertex(corner))]);
  return result;
}

// Decides for facets by their surroundings, layer by layer: all of a layer are decided before the
// next, so that their order does not matter. Returns the facets without decided surroundings.
// \param wanted(i) the choice that the surroundings of facet i ask for, if they do
template <typename Wanted, typename Decide>
std::vector<std::size_t> decide_by_surroundings(std::vector<std::size_t> undecided,
                                                const Wanted& wanted, const Decide& decide)
{
  for(;;) {
    std::vector<std::size_t> waiting;
    std::vector<std::pair<std::size_t, int> > decided;
    for(const std::size_t i : undecided)
      if(const std::optional<int> choice = wanted(i))
        decided.emplace_back(i, *choice);
      else
        waiting.push_back(i);
    if(decided.empty())
      return waiting;
    for(const auto& [i, choice] : decided)
      decide(i, choice);
    undecided.swap(waiting);
  }
}

// The choice with an allowed misfit that most edges of a facet ask for; among several, the one that
// fits best; none if no edge decides.
// \param wanted_at_edge(third) what the edge opposite to a corner asks for, if it does
template <int number_of_choices, typename Wanted_at_edge, typename Misfit>
std::optional<int> most_wanted(const Corner_index facet, const Wanted_at_edge& wanted_at_edge,
                               const Misfit& misfit, const double largest_misfit)
{
  std::array<int, number_of_choices> votes{};
  for(const Corner_index third : corners_of_facet(facet))
    if(const std::optional<int> choice = wanted_at_edge(third))
      ++votes[std::size_t(*choice)];
  std::optional<int> best;
  for(int k = 0; k < number_of_choices; ++k) {
    const int lead = best ? votes[std::size_t(k)] - votes[std::size_t(*best)] : 1;
    if(votes[std::size_t(k)] > 0 && misfit(k) <= largest_misfit &&
       (lead > 0 || (lead == 0 && misfit(k) < misfit(*best))))
      best = k;
  }
  return best;
}

// Reads rotations off the coordinates of each facet. Where a facet is so thin that several fit, the
// facets around its edges decide: around a regular edge, rotations multiply to the identity.
class Facet_transition_reader
{
  using Group = Cube_rotations;

public:
  explicit Facet_transition_reader(const Flat_volume& volume)
    : m_volume(volume), m_place(volume.places_in(volume.open_facets))
  { }

  Volume_transitions read()
  {
    fit_facets();
    std::vector<std::size_t> undecided;
    for(std::size_t i = 0; i < m_volume.open_facets.size(); ++i)
      if(!decide_alone(i))
        undecided.push_back(i);
    m_result.number_decided_by_surroundings = undecided.size();
    undecided = decide_by_surroundings(
      std::move(undecided), [&](const std::size_t i) { return most_wanted_rotation(i); },
      [&](const std::size_t i, const int g) { decide(i, g); });
    for(const std::size_t i : undecided)
      decide(i, may_be_no_cut(i) ? Group::identity() : m_result.element[i]);
    measure();
    return std::move(m_result);
  }

private:
  // The best fit of each facet, and from these what is noise at each vertex.
  void fit_facets()
  {
    const std::size_t size = m_volume.open_facets.size();
    m_result.element.assign(size, Group::identity());
    m_result.is_cut.assign(size, 1);
    m_result.noise.assign(m_volume.number_of_vertices(), 0);
    m_is_decided.assign(size, 0);
    for(std::size_t i = 0; i < size; ++i) {
      const Facet_vectors vectors(m_volume.sides(m_volume.open_facets[i]));
      m_result.element[i] = vectors.best_fit();
      raise_at(m_volume, m_volume.open_facets[i], vectors.residual(m_result.element[i]),
               m_result.noise);
    }
  }

  double noise_at(const Corner_index facet) const
  { return largest_at(m_volume, m_result.noise, facet); }

  bool may_be_no_cut(const std::size_t i) const
  {
    const Corner_index facet = m_volume.open_facets[i];
    return m_volume.sides(facet).difference() <= largest_gap_in_residuals * noise_at(facet);
  }

  // Returns false if several rotations fit.
  bool decide_alone(const std::size_t i)
  {
    const Corner_index facet = m_volume.open_facets[i];
    const double largest = largest_noise_in_residuals * noise_at(facet);
    const Facet_vectors vectors(m_volume.sides(facet));
    for(int g = 0; g < Group::order; ++g)
      if(g != m_result.element[i] && vectors.residual(g) <= largest)
        return false;
    decide(i, m_result.element[i]);
    return true;
  }

  void decide(const std::size_t i, const int g)
  {
    m_result.element[i] = g;
    m_result.is_cut[i] = g != Group::identity() || !may_be_no_cut(i);
    m_is_decided[i] = 1;
  }

  // The one that makes most edges regular.
  std::optional<int> most_wanted_rotation(const std::size_t i) const
  {
    const Corner_index facet = m_volume.open_facets[i];
    const Facet_vectors vectors(m_volume.sides(facet));
    return most_wanted<Group::order>(
      facet, [&](const Corner_index third) { return wanted_at_edge(facet, third); },
      [&](const int g) { return vectors.residual(g); },
      largest_noise_in_residuals * noise_at(facet));
  }

  // The rotation that makes the edge opposite to `third` regular, if all its other facets are
  // decided and it is no edge of the border.
  std::optional<int> wanted_at_edge(const Corner_index facet, const Corner_index third) const
  {
    Facet_ring ring(m_volume, facet, third);
    int g = Group::identity(); // from the chart of the facet's cell to that of the current one
    for(ring.turn(); !ring.is_closed(); ring.turn()) {
      if(!ring.can_cross())
        return std::nullopt;
      const std::int32_t i = m_place[std::size_t(ring.facet())];
      if(i >= 0) {
        if(m_is_decided[std::size_t(i)] == 0)
          return std::nullopt;
        g = Group::compose(element(ring.facet()), g);
      }
      ring.cross();
    }
    return g;
  }

  // Across a facet, from the side of the cell that it belongs to.
  int element(const Corner_index facet) const
  {
    const std::size_t i = std::size_t(m_place[std::size_t(facet)]);
    const int g = m_result.element[i];
    return m_volume.open_facets[i] == facet ? g : Group::inverse(g);
  }

  void measure()
  {
    for(std::size_t i = 0; i < m_result.element.size(); ++i) {
      const Facet_sides sides = m_volume.sides(m_volume.open_facets[i]);
      const double miss = m_result.is_cut[i] != 0
        ? Facet_vectors(sides).residual(m_result.element[i]) : sides.difference();
      m_result.number_of_cuts += std::size_t(m_result.is_cut[i]);
      if(miss > m_result.violation) {
        m_result.violation = miss;
        m_result.worst = m_volume.open_facets[i];
      }
    }
  }

  const Flat_volume& m_volume;
  std::vector<std::int32_t> m_place; // per facet: among the open ones, or -1
  std::vector<char> m_is_decided;    // per open facet
  Volume_transitions m_result;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_TRANSITIONS_H
