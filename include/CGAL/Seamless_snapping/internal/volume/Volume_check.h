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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H

#include <CGAL/license/Seamless_snapping.h>

// The verification: where coordinates do not satisfy, exactly, what the transitions and alignments
// ask for, and whether translations and levels are integers, facet by facet. It knows nothing of
// sectors, sheets, and places.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_transitions.h>
#include <CGAL/Seamless_snapping/types/Volume_seamlessness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The edges that have to lie on integer lines in an integer-grid map: singular edges, and edges at
// which the boundary turns back.

constexpr int no_axis = -1;

// The coordinate that a rotation about a coordinate axis leaves alone; `no_axis` for the identity
// and for rotations about other axes.
inline int axis_of(const Cube_rotations::Element g)
{
  int result = no_axis;
  for(std::size_t c = 0; c < 3 && g != Cube_rotations::identity(); ++c)
    if(Cube_rotations::source(g, c) == c && Cube_rotations::sign(g, c) > 0)
      result = int(c);
  return result;
}

struct Grid_edge
{
  Flat_volume::Aligned_edge edge; // its direction is known if transitions tell it
  bool is_interior;
  bool is_skew; // transitions turn about an axis that is none of the coordinates'
  int quarter_turns; // the angle of the cells around it
};

// Walks around each edge once, or once for each part of the mesh that touches it.
// \pre the volume holds all cells of the mesh
class Grid_edge_finder
{
  using Group = Cube_rotations;

public:
  Grid_edge_finder(const Flat_volume& volume, const Volume_transitions& transitions)
    : m_volume(volume),
      m_element(elements_of_facets(volume, transitions, false, Group::identity())),
      m_aligned(volume.places_in(volume.aligned_facets)),
      m_is_done(6 * volume.number_of_cells(), 0)
  { }

  std::vector<Grid_edge> find()
  {
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] == no_facet)
        for(const Corner_index third : corners_of_facet(Corner_index(f)))
          walk(Corner_index(f), third);
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      for(const Corner_index third : corners_of_facet(Corner_index(f)))
        walk(Corner_index(f), third);
    return std::move(m_result);
  }

  // The number of all edges; an edge counts for each part of the mesh that touches it.
  std::size_t number_of_edges() const { return m_number_of_edges; }

private:
  static constexpr double pi = 3.14159265358979323846;

  char& is_done(const Corner_index i, const Corner_index j)
  {
    constexpr std::size_t pair[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
    return m_is_done[6 * std::size_t(i / 4) + pair[i % 4][j % 4]];
  }

  // Around the edge that a facet has opposite to its corner `third`.
  void walk(const Corner_index facet, const Corner_index third)
  {
    if(is_done(facet, third) != 0)
      return;
    ++m_number_of_edges;
    double angle = 0;
    bool is_folded = false;
    int g = Group::identity();
    CGAL::Orientation sign = CGAL::ZERO;
    Facet_ring ring(m_volume, facet, third);
    do {
      const Corner_index former = ring.facet();
      ring.turn();
      is_done(former, ring.facet()) = 1;
      const CGAL::Orientation now =
        orientation(uvw_of_cell(m_volume.coordinates, std::size_t(former / 4)));
      is_folded = is_folded || now == CGAL::ZERO || (sign != CGAL::ZERO && now != sign);
      sign = now;
      angle += dihedral_angle(m_volume, former, ring.facet());
      if(!ring.can_cross())
        break;
      g = Group::compose(m_element[std::size_t(ring.facet())], g);
      if(ring.is_closed())
        break;
      ring.cross();
    } while(true);
    const bool is_interior = ring.can_cross();
    if(is_interior ? g != Group::identity() || (!is_folded && angle > 4 * pi - pi / 4)
                   : !is_folded && angle > 2 * pi - pi / 4 &&
                       m_aligned[std::size_t(facet)] >= 0 &&
                       m_aligned[std::size_t(ring.facet())] >= 0) {
      const std::array<Corner_index, 2> ends = edge_of_facet(facet, third);
      const int axis = is_interior ? axis_of(g) : no_axis;
      m_result.push_back({{ends[0], ends[1], axis}, is_interior,
                          is_interior && g != Group::identity() && axis == no_axis,
                          int(std::lround(2 * angle / pi))});
    }
  }

  const Flat_volume& m_volume;
  std::vector<signed char> m_element; // per facet: to the other side
  std::vector<std::int32_t> m_aligned; // per facet: its place among the aligned ones, or -1
  std::vector<char> m_is_done;        // per edge of a cell
  std::vector<Grid_edge> m_result;
  std::size_t m_number_of_edges = 0;
};

// Calls f(corner, c) for coordinates at which an open or aligned facet or an aligned edge is
// inexact; for transitions, in the chart of the cell on the other side. In the input, that is all.
template <typename F>
void for_each_inexact_coordinate(const Flat_volume& volume, const Volume_constraints& constraints,
                                 const std::vector<Uvw>& u, const F& f)
{
  const Volume_transitions& transitions = constraints.transitions;
  const auto compare = [&](const Corner_index a, const Corner_index b, const std::size_t c) {
    if(u[std::size_t(a)][c] != u[std::size_t(b)][c]) {
      f(a, c);
      f(b, c);
    }
  };
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i) {
    const Corner_index facet = volume.open_facets[i];
    if(transitions.is_cut[i] == 0) {
      for(const Corner_index corner : corners_of_facet(facet))
        for(std::size_t c = 0; c < 3; ++c)
          compare(corner, volume.across(facet, corner), c);
      continue;
    }
    const Facet_vectors vectors(volume.sides(facet, u));
    for(std::size_t c = 0; c < 3; ++c)
      if(!vectors.match(transitions.element[i], c))
        for(const Corner_index corner : corners_of_facet(facet))
          f(volume.across(facet, corner), c);
  }
  for_each_level(volume, constraints.alignment, [&](const auto& corners, const std::size_t c,
                                                    const auto&) {
    for(std::size_t j = 1; j < corners.size(); ++j)
      compare(corners[0], corners[j], c);
  });
}

inline bool is_exact(const Flat_volume& volume, const Volume_constraints& constraints,
                     const std::vector<Uvw>& u)
{
  bool result = true;
  for_each_inexact_coordinate(volume, constraints, u,
                              [&](Corner_index, std::size_t) { result = false; });
  const std::vector<std::int32_t> open = volume.places_in(volume.open_facets);
  for(std::size_t i = 0; i < volume.opposite.size() && result; ++i)
    if(volume.opposite[i] > Corner_index(i) && open[i] < 0)
      for(const Corner_index corner : corners_of_facet(Corner_index(i)))
        result = result && u[std::size_t(corner)] ==
                             u[std::size_t(volume.across(Corner_index(i), corner))];
  return result;
}

// The largest distance of a translation of a cut from an integer.
inline double translation_distance(const Flat_volume& volume, const Corner_index facet, const int g,
                                   const std::vector<Uvw>& u)
{
  using Group = Cube_rotations;
  const Corner_index corner = corners_of_facet(facet)[0];
  const Uvw &here = u[std::size_t(corner)],
            &there = u[std::size_t(volume.across(facet, corner))];
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    result = (std::max)(result, distance_to_integer(Exact_difference(
                                  there[c], Group::sign(g, c) * here[Group::source(g, c)])));
  return result;
}

// The distance of an edge from an integer line of some direction.
inline double line_distance(const Flat_volume::Aligned_edge& edge, const int direction,
                            const std::vector<Uvw>& u)
{
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    if(int(c) != direction)
      result = (std::max)(result, distance_to_integer(u[std::size_t(edge.a)][c]));
  return result;
}

// Whether all but one of its coordinates are constant along an edge.
inline bool is_on_line(const Flat_volume& volume, const Flat_volume::Aligned_edge& edge,
                       const int direction)
{
  for(std::size_t c = 0; c < 3; ++c)
    if(int(c) != direction && volume.uvw(edge.a)[c] != volume.uvw(edge.b)[c])
      return false;
  return true;
}

// Whether an edge lies on a line of the integer grid, exactly.
inline bool is_on_grid_line(const Flat_volume& volume, const Flat_volume::Aligned_edge& edge)
{
  const int direction = direction_of(volume, edge);
  return is_on_line(volume, edge, direction) &&
         line_distance(edge, direction, volume.coordinates) == 0;
}

// Counts what is off the integers, and measures by how much: translations and levels.
// \pre the map is exactly seamless and aligned, else distances refer to one vertex only
inline void measure_distances(const Flat_volume& volume, const Volume_constraints& constraints,
                              const std::vector<Uvw>& u, Volume_integer_grid_measure& measure)
{
  const auto& [transitions, alignment] = constraints;
  const auto note = [](const double distance, std::size_t& number, double& largest) {
    number += std::size_t(distance != 0);
    largest = (std::max)(largest, distance);
  };
  for(std::size_t i = 0; i < volume.open_facets.size(); ++i)
    if(transitions.is_cut[i] != 0)
      note(translation_distance(volume, volume.open_facets[i], transitions.element[i], u),
           measure.number_of_noninteger_cuts, measure.translation_distance);
  for(std::size_t i = 0; i < volume.aligned_facets.size(); ++i) {
    const Corner_index corner = corners_of_facet(volume.aligned_facets[i])[0];
    note(distance_to_integer(u[std::size_t(corner)][std::size_t(alignment.coordinate[i])]),
         measure.number_of_noninteger_facets, measure.alignment_distance);
  }
  for(std::size_t i = 0; i < volume.aligned_edges.size(); ++i)
    note(line_distance(volume.aligned_edges[i], alignment.direction[i], u),
         measure.number_of_noninteger_edges, measure.alignment_distance);
}

// Whether a map is exactly seamless and aligned, and on integers.
inline bool is_on_integers(const Flat_volume& volume, const Volume_constraints& constraints,
                           const std::vector<Uvw>& u)
{
  Volume_integer_grid_measure measure;
  measure_distances(volume, constraints, u, measure);
  return measure.translation_distance == 0 && measure.alignment_distance == 0 &&
         is_exact(volume, constraints, u);
}

// The corners of vertices at which other than two of the interior edges meet.
inline std::vector<Corner_index> corners_of_nodes(const Flat_volume& volume,
                                                  const std::vector<Grid_edge>& edges)
{
  std::vector<std::int32_t> number(volume.number_of_vertices(), 0);
  for(const Grid_edge& edge : edges)
    for(const Corner_index end : {edge.edge.a, edge.edge.b})
      number[std::size_t(volume.vertex(end))] += std::int32_t(edge.is_interior);
  std::vector<Corner_index> result;
  for(std::size_t i = 0; i < volume.vertices.size(); ++i)
    if(const std::int32_t n = number[std::size_t(volume.vertices[i])]; n != 0 && n != 2)
      result.push_back(Corner_index(i));
  return result;
}

inline void measure_singular_edges(const Flat_volume& volume, const Volume_transitions& transitions,
                                   Volume_integer_grid_measure& measure)
{
  const std::vector<Grid_edge> edges = Grid_edge_finder(volume, transitions).find();
  measure.number_of_singular_edges = edges.size();
  for(const Grid_edge& edge : edges) {
    measure.number_of_noninteger_singular_edges +=
      std::size_t(edge.is_skew || !is_on_grid_line(volume, edge.edge));
    if(!edge.is_skew)
      measure.alignment_distance =
        (std::max)(measure.alignment_distance,
                   line_distance(edge.edge, direction_of(volume, edge.edge), volume.coordinates));
  }
  std::map<std::int32_t, bool> is_off; // the grid, per vertex that is a node
  for(const Corner_index corner : corners_of_nodes(volume, edges)) {
    bool& is_node_off = is_off[volume.vertex(corner)];
    for(const double x : volume.uvw(corner))
      is_node_off = is_node_off || x != std::round(x);
  }
  measure.number_of_nodes = is_off.size();
  for(const auto& node : is_off)
    measure.number_of_noninteger_nodes += std::size_t(node.second);
}

inline void measure_orientations(const Flat_volume& volume, Volume_integer_grid_measure& measure)
{
  using Number = CGAL::internal::Exact_ring_selector<double>::Type;
  Number six_volumes(0);
  for(std::size_t c = 0; c < volume.number_of_cells(); ++c) {
    const Number six = exact_determinant<Number>(uvw_of_cell(volume.coordinates, c));
    six_volumes += six;
    measure.number_of_nonpositive_cells += std::size_t(!CGAL::is_positive(six));
  }
  measure.volume = CGAL::to_double(six_volumes) / 6;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_CHECK_H
