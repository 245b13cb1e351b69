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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATION_FINDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATION_FINDER_H

#include <CGAL/license/Seamless_snapping.h>

// Differences of coordinates that have to stay at least 1 when a map is rounded to integers: those
// between levels, singular curves, and nodes that see each other along a line of the map. Joined,
// they would leave the cells between them no volume.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_places.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_transitions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A sum of columns of the system of places that is positive in the map.
using Separation = Entries<std::int64_t>;

// From each corner walks go along the axes in which its vertex can't move once there are integers,
// through the cells and from chart to chart. On its way a walk sees the corners of the cells that
// it passes. If a corner is fixed along the axis, too, it stays apart from the start of the walk.
// Bruckler, Bommes, and Campen (Volume Parametrization Quantization for Hexahedral Meshing, 2022)
// have walls of a motorcycle complex in place of walks. Walks are in floating point, because they
// only propose conditions: the rounded map is checked exactly.
class Separation_finder
{
  using Group = Cube_rotations;

public:
  Separation_finder(const Flat_volume& volume, const Volume_transitions& transitions,
                    const Volume_members& members)
    : m_volume(volume), m_members(members),
      m_element(elements_of_facets(volume, transitions, true, -1)),
      m_least_distance(1e-10 * volume.extent)
  { }

  std::vector<Separation> find()
  {
    for(std::size_t i = 0; i < m_volume.vertices.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        if(is_fixed(Corner_index(i), c))
          for(const int sign : {1, -1})
            walk(Corner_index(i), c, sign);
    return {m_found.begin(), m_found.end()};
  }

private:
  // In units. Roundings join nothing that is farther away, or farther from the line of a walk.
  static constexpr double largest_distance = 2, largest_offset = 1;
  static constexpr int largest_number_of_steps = 500; // of a walk, from cell to cell

  // In the chart of the cell at hand. Its start lies at `start`, moved along the mesh.
  struct Walk
  {
    std::size_t cell, axis;
    int sign;
    Uvw start, at;
    std::array<bool, 3> is_start_fixed;
    Separation level; // the coordinate of the start along the axis
  };

  bool is_fixed(const Corner_index i, const std::size_t c) const
  { return m_members.term(i, c).sign == 0; }

  void add(Separation& terms, const Corner_index i, const std::size_t c, const int factor) const
  { terms.push_back({Column_index(m_members.column(i, c)), factor}); }

  void walk(const Corner_index i, const std::size_t c, const int sign)
  {
    Walk w{std::size_t(i / 4), c, sign, m_volume.uvw(i), m_volume.uvw(i), {}, {}};
    for(std::size_t k = 0; k < 3; ++k)
      w.is_start_fixed[k] = is_fixed(i, k);
    add(w.level, i, c, 1);
    Corner_index entered = i; // the facets at the corner are opposite to the other corners
    for(int step = 0; step < largest_number_of_steps; ++step) {
      const Exit exit = find_exit(w, entered, step == 0);
      if(exit.facet < 0)
        return;
      note_corners(w);
      w.at[w.axis] += w.sign * exit.distance;
      if(w.sign * (w.at[w.axis] - w.start[w.axis]) > largest_distance || !cross(w, exit.facet))
        return;
      entered = m_volume.opposite[std::size_t(exit.facet)];
    }
  }

  struct Exit
  {
    Corner_index facet;
    double distance;
  };

  // \param entered the facet through which the walk came; or the corner at which it starts
  Exit find_exit(const Walk& w, const Corner_index entered, const bool is_start) const
  {
    const Uvw_tetrahedron u = uvw_of_cell(m_volume.coordinates, w.cell);
    const std::array<Uvw, 3> e{
      {vector_to(u[0], u[1]), vector_to(u[0], u[2]), vector_to(u[0], u[3])}};
    const std::array<Uvw, 4> normals = facet_normals(e);
    const Uvw from = vector_to(u[0], w.at);
    const double volume = inner_product(e[0], normals[1]);
    Exit result{no_facet, 0};
    if(!(volume > 0))
      return result;
    std::array<double, 4> weight{{volume, 0, 0, 0}}; // barycentric coordinates
    for(std::size_t k = 1; k < 4; ++k) {
      weight[k] = inner_product(normals[k], from);
      weight[0] -= weight[k];
    }
    for(Corner_index k = 0; k < 4; ++k) {
      const double s = w.sign * normals[std::size_t(k)][w.axis]; // how it changes
      if(is_start && k != entered % 4 && s < 0)
        return {no_facet, 0}; // another cell at the vertex contains the walk
      if(!(s < 0) || (!is_start && k == entered % 4))
        continue;
      const double distance = (std::max)(0., -weight[std::size_t(k)] / s);
      if(result.facet < 0 || distance < result.distance)
        result = {Corner_index(4 * w.cell) + k, distance};
    }
    return result;
  }

  void note_corners(const Walk& w)
  {
    for(Corner_index j = Corner_index(4 * w.cell); j < Corner_index(4 * w.cell + 4); ++j) {
      if(!is_fixed(j, w.axis))
        continue;
      const Uvw& u = m_volume.uvw(j);
      const double distance = w.sign * (u[w.axis] - w.start[w.axis]);
      if(!(distance > m_least_distance && distance < largest_distance))
        continue;
      bool is_beside = false; // of two fixed differences the larger one is to stay
      for(std::size_t c = 0; c < 3; ++c)
        if(c != w.axis) {
          const double offset = std::abs(u[c] - w.start[c]);
          is_beside = is_beside || offset > largest_offset ||
                      (w.is_start_fixed[c] && is_fixed(j, c) && offset > distance);
        }
      if(is_beside)
        continue;
      Separation terms = w.level;
      for(Entry<std::int64_t>& e : terms)
        e.coefficient *= -w.sign;
      add(terms, j, w.axis, w.sign);
      sort_and_sum(terms);
      if(!terms.empty())
        m_found.insert(std::move(terms));
    }
  }

  // Returns false if there is no cell on the other side.
  bool cross(Walk& w, const Corner_index facet) const
  {
    const Corner_index other = m_volume.opposite[std::size_t(facet)];
    if(other < 0)
      return false;
    const int g = m_element[std::size_t(facet)];
    w.cell = std::size_t(other / 4);
    if(g < 0)
      return true;
    const Corner_index here = corners_of_facet(facet)[0], there = m_volume.across(facet, here);
    const Uvw shift = m_volume.translation(facet, g);
    const Uvw start = Group::apply(g, w.start), at = Group::apply(g, w.at);
    std::array<bool, 3> is_start_fixed{};
    std::size_t axis = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      w.start[c] = start[c] + shift[c];
      w.at[c] = at[c] + shift[c];
      is_start_fixed[c] = w.is_start_fixed[Group::source(g, c)];
      if(Group::source(g, c) == w.axis)
        axis = c;
    }
    const int sign = Group::sign(g, axis);
    for(Entry<std::int64_t>& e : w.level)
      e.coefficient *= sign;
    add(w.level, here, w.axis, -sign); // the translation
    add(w.level, there, axis, 1);
    sort_and_sum(w.level);
    w.is_start_fixed = is_start_fixed;
    w.axis = axis;
    w.sign *= sign;
    return true;
  }

  const Flat_volume& m_volume;
  const Volume_members& m_members;
  std::vector<signed char> m_element; // per facet: to the other side; -1 where there is no cut
  double m_least_distance;
  std::set<Separation> m_found;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATION_FINDER_H
