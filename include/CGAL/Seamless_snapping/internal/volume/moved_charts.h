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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MOVED_CHARTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MOVED_CHARTS_H

#include <CGAL/license/Seamless_snapping.h>

// Where charts lie means nothing: they are moved to where translations and levels are nearer to
// integers.

#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Charts are classes of cells between which no cut runs. From one to the next, the first cut gets
// an integer translation; then all charts of a component of the mesh are moved by one vector, which
// takes the levels of aligned facets and edges as near to integers as their mean allows.
class Volume_chart_mover
{
  using Group = Cube_rotations;

public:
  Volume_chart_mover(const Flat_volume& volume, const Volume_transitions& transitions,
              const Volume_alignment& alignment)
    : m_volume(volume), m_alignment(alignment),
      m_element(elements_of_facets(volume, transitions, true, -1)),
      m_is_reached(volume.number_of_cells(), 0), m_rotation(volume.number_of_cells()),
      m_shift(volume.number_of_cells()), m_component(volume.number_of_cells())
  { }

  // The coordinates of all corners, moved.
  std::vector<Uvw> run()
  {
    for(std::size_t c = 0; c < m_is_reached.size(); ++c)
      if(m_is_reached[c] == 0)
        reach_component(c);
    const std::vector<Uvw> common = common_shifts();
    std::vector<Uvw> result = m_volume.coordinates;
    for(std::size_t i = 0; i < result.size(); ++i) {
      const Uvw by = Group::apply(m_rotation[i / 4], common[m_component[i / 4]]);
      for(std::size_t c = 0; c < 3; ++c)
        result[i][c] += m_shift[i / 4][c] + by[c];
    }
    return result;
  }

private:
  // Cells of a chart before those beyond its cuts, so that they get the same shift.
  void reach_component(const std::size_t root)
  {
    std::vector<Corner_index> cuts; // reached, as the cell on this side sees them
    reach_chart(root, Group::identity(), Uvw(), cuts);
    for(std::size_t i = 0; i < cuts.size(); ++i) {
      const Corner_index facet = cuts[i], there = m_volume.opposite[std::size_t(facet)];
      if(m_is_reached[std::size_t(there / 4)] != 0)
        continue;
      const int g = m_element[std::size_t(facet)];
      const Corner_index corner = corners_of_facet(facet)[0];
      const std::size_t here = std::size_t(facet / 4);
      Uvw u = m_volume.uvw(corner), shift;
      for(std::size_t c = 0; c < 3; ++c)
        u[c] += m_shift[here][c];
      u = Group::apply(g, u);
      for(std::size_t c = 0; c < 3; ++c) {
        const double t = m_volume.uvw(m_volume.across(facet, corner))[c] - u[c];
        shift[c] = std::round(t) - t;
      }
      reach_chart(std::size_t(there / 4), Group::compose(g, m_rotation[here]), shift, cuts);
    }
    ++m_number_of_components;
  }

  void reach_chart(const std::size_t first, const int rotation, const Uvw& shift,
                   std::vector<Corner_index>& cuts)
  {
    std::vector<std::size_t> cells(1, first);
    m_is_reached[first] = 1;
    for(std::size_t i = 0; i < cells.size(); ++i) {
      m_rotation[cells[i]] = rotation;
      m_shift[cells[i]] = shift;
      m_component[cells[i]] = m_number_of_components;
      for(std::size_t facet = 4 * cells[i]; facet < 4 * cells[i] + 4; ++facet) {
        const Corner_index other = m_volume.opposite[facet];
        if(other < 0)
          continue;
        if(m_element[facet] >= 0) {
          cuts.push_back(Corner_index(facet));
        } else if(m_is_reached[std::size_t(other / 4)] == 0) {
          m_is_reached[std::size_t(other / 4)] = 1;
          cells.push_back(std::size_t(other / 4));
        }
      }
    }
  }

  // Per component, in the chart of its first cell.
  std::vector<Uvw> common_shifts() const
  {
    constexpr double turn = 2 * 3.14159265358979323846;
    using Phase = std::complex<double>;
    std::vector<std::array<Phase, 3> > sums(m_number_of_components);
    const auto add = [&](const Corner_index corner, const int c) {
      const std::size_t cell = std::size_t(corner / 4);
      const double level = m_volume.uvw(corner)[std::size_t(c)] + m_shift[cell][std::size_t(c)];
      const int g = m_rotation[cell];
      sums[m_component[cell]][Group::source(g, std::size_t(c))] +=
        std::polar(1., Group::sign(g, std::size_t(c)) * turn * (level - std::round(level)));
    };
    for(std::size_t i = 0; i < m_volume.aligned_facets.size(); ++i)
      add(corners_of_facet(m_volume.aligned_facets[i])[0], m_alignment.coordinate[i]);
    for(std::size_t i = 0; i < m_volume.aligned_edges.size(); ++i)
      for(int c = 0; c < 3; ++c)
        if(c != m_alignment.direction[i])
          add(m_volume.aligned_edges[i].a, c);
    std::vector<Uvw> result(m_number_of_components);
    for(std::size_t k = 0; k < result.size(); ++k)
      for(std::size_t c = 0; c < 3; ++c)
        result[k][c] = std::abs(sums[k][c]) > 0 ? -std::arg(sums[k][c]) / turn : 0.;
    return result;
  }

  const Flat_volume& m_volume;
  const Volume_alignment& m_alignment;
  std::vector<signed char> m_element;   // per facet: to the other side; -1 where there is no cut
  std::vector<char> m_is_reached;       // per cell
  std::vector<int> m_rotation;          // per cell: from the first chart of its component
  std::vector<Uvw> m_shift;             // per cell: the same for all of a chart
  std::vector<std::size_t> m_component; // per cell
  std::size_t m_number_of_components = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MOVED_CHARTS_H
