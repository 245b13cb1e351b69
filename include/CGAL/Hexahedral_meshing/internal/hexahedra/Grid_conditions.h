// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_CONDITIONS_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_CONDITIONS_H

#include <CGAL/license/Hexahedral_meshing.h>

// The conditions on a map that describes hexahedra, checked exactly: each refusal names the first
// place and the remedy.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// The coordinate that is constant on a facet; 3 if there is none.
inline std::size_t constant_coordinate(const Flat_volume& volume, const Corner_index facet)
{
  const Uvw s = spread(volume, corners_of_facet(facet));
  return std::size_t(std::find(s.begin(), s.end(), 0.) - s.begin());
}

// Checks the conditions, and keeps what they tell of the mesh.
// \pre the volume holds all cells, and its boundary is aligned
class Grid_conditions
{
  using Group = Cube_rotations;

public:
  explicit Grid_conditions(const Flat_volume& volume)
    : m_volume(volume)
  { }

  std::optional<Refusal> check()
  {
    using This = Grid_conditions;
    for(const auto check : {&This::check_size, &This::check_orientations, &This::check_cuts,
                            &This::check_aligned_facets, &This::check_aligned_edges,
                            &This::check_singular_edges})
      if(auto refusal = (this->*check)())
        return refusal;
    return std::nullopt;
  }

  // Per facet: the rotation to its other side, or -1 if both have the same coordinates.
  std::vector<signed char> take_elements()
  { return elements_of_facets(m_volume, m_transitions, false, -1); }

  // The characteristic of the mesh, as if parts that touch in edges and vertices only were apart.
  std::ptrdiff_t euler_characteristic()
  {
    const std::size_t number_of_cells = m_volume.number_of_cells();
    const std::size_t number_of_border_facets = std::size_t(
      std::count(m_volume.opposite.begin(), m_volume.opposite.end(), no_facet));
    const std::size_t facets = (4 * number_of_cells + number_of_border_facets) / 2;
    return std::ptrdiff_t(number_of_vertices() + facets) -
           std::ptrdiff_t(m_number_of_edges + number_of_cells);
  }

  // The lengths of interior singular edges in the domain, by quarter turns around them.
  const std::map<int, double>& singular_lengths() const { return m_singular_lengths; }

  // In the domain: of the cells, and of the facets of the boundary. Sums in floating point, with
  // bounds of their errors.
  std::pair<double, double> volume() const
  {
    double result = 0, bound = 0;
    for(std::size_t c = 0; c < m_volume.number_of_cells(); ++c) {
      const Uvw_tetrahedron u = uvw_of_cell(m_volume.coordinates, c);
      std::array<double, 3> size{};
      for(std::size_t i = 1; i < 4; ++i)
        for(std::size_t k = 0; k < 3; ++k)
          size[k] = (std::max)(size[k], std::abs(u[i][k] - u[0][k]));
      result += six_times_volume(u) / 6;
      bound += 1e-15 * size[0] * size[1] * size[2] + 2e-16 * result; // of the product, and the sum
    }
    return {result, 2 * bound};
  }

  double border_area() const
  {
    double result = 0;
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] == no_facet) {
        const auto c = corners_of_facet(Corner_index(f));
        const Uvw n = vector_product(vector_to(m_volume.uvw(c[0]), m_volume.uvw(c[1])),
                                     vector_to(m_volume.uvw(c[0]), m_volume.uvw(c[2])));
        result += (std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2])) / 2; // two of them are zero
      }
    return result;
  }

private:
  Message name_of_cell(const std::size_t c) const
  { return name_of_element("cell", std::size_t(m_volume.cell_names[c])); }

  static std::string among(const std::size_t number, const char* const noun)
  { return number == 1 ? "" : " (the first of " + counted(number, noun) + ")"; }

  std::optional<Refusal> check_size()
  {
    for(std::size_t i = 0; i < m_volume.coordinates.size(); ++i)
      for(const double x : m_volume.coordinates[i])
        if(std::abs(x) > largest_grid_coordinate)
          return Refusal(Outcome::TOO_LARGE, name_of_cell(i / 4) + " has a coordinate beyond 2^46, "
                         "where integers and their halves can't be told apart" +
                         remedy("scale the map down"));
    return std::nullopt;
  }

  std::optional<Refusal> check_orientations()
  {
    const std::vector<std::size_t> bad = nonpositive_cells(m_volume.coordinates);
    if(bad.empty())
      return std::nullopt;
    return Refusal(Outcome::NOT_POSITIVE, name_of_cell(bad[0]) + among(bad.size(), "such cell") +
                   " is flipped or degenerate in the domain" +
                   remedy("snap_volume_to_seamless() with repair_flips(Flip_repair::UNTANGLE) "
                          "makes cells positive if it can"));
  }

  // Each open facet has one rotation that holds exactly, because its image has an area.
  std::optional<Refusal> check_cuts()
  {
    const std::size_t size = m_volume.open_facets.size();
    m_transitions.element.assign(size, Group::identity());
    m_transitions.is_cut.assign(size, 1);
    std::vector<Corner_index> inexact, off_grid;
    for(std::size_t i = 0; i < size; ++i) {
      const Corner_index facet = m_volume.open_facets[i];
      if(const auto g = Facet_vectors(m_volume.sides(facet)).exact_fit()) {
        m_transitions.element[i] = *g;
        if(translation_distance(m_volume, facet, *g, m_volume.coordinates) != 0)
          off_grid.push_back(facet);
      } else {
        inexact.push_back(facet);
      }
    }
    if(!inexact.empty())
      return Refusal(Outcome::NOT_SEAMLESS, "the two sides of " +
                     m_volume.name_of_facet(inexact[0]) + among(inexact.size(), "such facet") +
                     " differ by no rotation of the cube, exactly" +
                     remedy("snap_volume_to_seamless() makes the map exactly seamless"));
    if(!off_grid.empty())
      return not_integer("the translation across " + m_volume.name_of_facet(off_grid[0]) +
                         among(off_grid.size(), "such facet") + " is no integer");
    return std::nullopt;
  }

  static Refusal not_integer(const Message& what)
  {
    return {Outcome::NOT_INTEGER,
            what + remedy("snap_volume_to_seamless() with integer_grid(true) makes an integer-grid "
                          "map")};
  }

  std::optional<Refusal> check_aligned_facets()
  {
    std::vector<Corner_index> askew, off_grid;
    for(const Corner_index facet : m_volume.aligned_facets) {
      const std::size_t k = constant_coordinate(m_volume, facet);
      if(k == 3)
        askew.push_back(facet);
      else if(distance_to_integer(m_volume.uvw(corners_of_facet(facet)[0])[k]) != 0)
        off_grid.push_back(facet);
    }
    const auto name = [&](const std::vector<Corner_index>& facets) {
      const bool is_border = m_volume.opposite[std::size_t(facets[0])] == no_facet;
      return (is_border ? "the boundary " : "the feature ") + m_volume.name_of_facet(facets[0]) +
             among(facets.size(), "such facet");
    };
    if(!askew.empty())
      return Refusal(Outcome::NOT_ALIGNED, name(askew) + " lies in no plane of a constant "
                     "coordinate, exactly" + remedy("snap_volume_to_seamless() aligns it"));
    if(!off_grid.empty())
      return not_integer(name(off_grid) + " lies between the planes of the grid");
    return std::nullopt;
  }

  std::optional<Refusal> check_aligned_edges()
  {
    for(const Flat_volume::Aligned_edge& edge : m_volume.aligned_edges)
      if(!is_on_line(m_volume, edge, direction_of(m_volume, edge)))
        return Refusal(Outcome::NOT_ALIGNED, "along the feature " + m_volume.name_of_edge(edge) +
                       ", more than one coordinate changes" +
                       remedy("snap_volume_to_seamless() aligns it"));
      else if(!is_on_grid_line(m_volume, edge))
        return not_integer("the feature " + m_volume.name_of_edge(edge) +
                           " lies between the lines of the grid");
    return std::nullopt;
  }

  std::optional<Refusal> check_singular_edges()
  {
    Grid_edge_finder finder(m_volume, m_transitions);
    const std::vector<Grid_edge> edges = finder.find();
    m_number_of_edges = finder.number_of_edges();
    for(const Grid_edge& grid_edge : edges) {
      const Flat_volume::Aligned_edge& edge = grid_edge.edge;
      const std::size_t axis = std::size_t(direction_of(m_volume, edge));
      if(grid_edge.is_skew || !is_on_grid_line(m_volume, edge))
        return not_integer("the singular " + m_volume.name_of_edge(edge) + " (of " +
                           counted(edges.size(), "singular edge") + ") is on no line of the grid");
      if(grid_edge.is_interior)
        m_singular_lengths[grid_edge.quarter_turns] += std::abs(
          m_volume.uvw(edge.b)[axis] - m_volume.uvw(edge.a)[axis]);
    }
    return std::nullopt;
  }

  // Classes of corners whose cells share facets at them.
  std::size_t number_of_vertices() const
  {
    Signed_union_find corners(m_volume.vertices.size());
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] > Corner_index(f))
        for(const Corner_index corner : corners_of_facet(Corner_index(f)))
          corners.unite(std::size_t(corner), std::size_t(m_volume.across(Corner_index(f), corner)));
    std::vector<std::int32_t> numbers;
    return corners.number(numbers);
  }

  const Flat_volume& m_volume;
  Volume_transitions m_transitions; // of the open facets, all of which are cuts
  std::size_t m_number_of_edges = 0;
  std::map<int, double> m_singular_lengths;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_GRID_CONDITIONS_H
