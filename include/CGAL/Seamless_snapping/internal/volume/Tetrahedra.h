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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_TETRAHEDRA_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_TETRAHEDRA_H

#include <CGAL/license/Seamless_snapping.h>

// The combinatorics of the caller's tetrahedra, checked: vertices and neighbors of all cells.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/match_facets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// 32 bytes a cell. Invariant: there are at most four times as many vertices as cells.
struct Tetrahedra
{
  std::vector<std::int32_t> vertices; // per corner
  std::vector<Corner_index> opposite; // per facet
  std::size_t number_of_vertices = 0; // 1 + the largest index
  std::vector<std::int32_t> names;    // per vertex, ascending; none where they are the indices

  std::size_t number_of_cells() const { return vertices.size() / 4; }

  std::int32_t name(const std::int32_t v) const
  {
    return names.empty() ? v : names[std::size_t(v)];
  }

  // The vertex of that name, or a negative number.
  std::int32_t vertex_of_name(const std::int64_t name) const
  {
    if(names.empty())
      return 0 <= name && std::size_t(name) < number_of_vertices ? std::int32_t(name) : -1;
    const auto found = std::lower_bound(names.begin(), names.end(), name);
    return found != names.end() && *found == name ? std::int32_t(found - names.begin()) : -1;
  }
};

// Where names are much larger than their number, arrays are not to grow with them.
inline void renumber_vertices(Tetrahedra& tetrahedra)
{
  if(tetrahedra.number_of_vertices <= tetrahedra.vertices.size())
    return;
  std::vector<std::int32_t> names(tetrahedra.vertices);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for(std::int32_t& v : tetrahedra.vertices)
    v = std::int32_t(std::lower_bound(names.begin(), names.end(), v) - names.begin());
  tetrahedra.number_of_vertices = names.size();
  tetrahedra.names.swap(names);
}

// So that three numbers per corner can be counted in 31 bits.
constexpr std::size_t largest_number_of_tetrahedra = std::size_t(1) << 27;
constexpr std::size_t largest_vertex_index = (std::size_t(1) << 31) - 2;

inline Refusal invalid_cells(const std::string& message)
{
  return {Outcome::INVALID_ARGUMENT, message};
}

inline std::string name_of_facet(const Tetrahedra& tetrahedra, const Corner_index facet)
{
  std::vector<std::int64_t> names;
  for(const Corner_index corner : corners_of_facet(facet))
    names.push_back(tetrahedra.name(tetrahedra.vertices[std::size_t(corner)]));
  std::sort(names.begin(), names.end());
  return name_of("facet", names);
}

template <typename Number>
bool is_index_below(const Number i, const std::size_t end)
{
  return !(i < Number(0)) && static_cast<std::size_t>(i) < end;
}

template <typename TetrahedronRange>
std::optional<Refusal> read_vertices(const TetrahedronRange& tetrahedra, Tetrahedra& result)
{
  const std::size_t size = static_cast<std::size_t>(tetrahedra.size());
  if(size == 0)
    return invalid_cells("the mesh has no cell; was it read?");
  if(size > largest_number_of_tetrahedra)
    return invalid_cells("the mesh has more than " + std::to_string(largest_number_of_tetrahedra) +
                         " cells; divide it");
  result.vertices.resize(4 * size);
  std::size_t first = 0;
  for(const auto& cell : tetrahedra) {
    const auto name = [&] { return "cell " + std::to_string(first / 4); };
    if(cell.size() != 4)
      return invalid_cells(name() + " has " + std::to_string(cell.size()) +
                           " vertices in place of 4");
    std::size_t i = first;
    for(const auto v : cell) {
      if(!is_index_below(v, largest_vertex_index + 1))
        return invalid_cells(name() + " has a vertex whose index is negative or too large");
      for(std::size_t j = first; j < i; ++j)
        if(result.vertices[j] == static_cast<std::int32_t>(v))
          return invalid_cells(name() + " has vertex " + std::to_string(v) + " twice; remove it");
      result.vertices[i++] = static_cast<std::int32_t>(v);
      result.number_of_vertices = (std::max)(result.number_of_vertices, std::size_t(v) + 1);
    }
    first = i;
  }
  renumber_vertices(result);
  return std::nullopt;
}

// The facet of cell `d` with the vertices of `facet`, or `no_facet`.
inline Corner_index facet_of_cell(const Tetrahedra& tetrahedra, const Corner_index d,
                                  const Corner_index facet)
{
  Corner_index result = no_facet;
  for(Corner_index i = 4 * d; i < 4 * d + 4; ++i) {
    bool is_on_facet = false;
    for(const Corner_index corner : corners_of_facet(facet))
      is_on_facet = is_on_facet || tetrahedra.vertices[std::size_t(corner)] ==
                                     tetrahedra.vertices[std::size_t(i)];
    if(!is_on_facet && result != no_facet)
      return no_facet; // two other vertices
    if(!is_on_facet)
      result = i;
  }
  return result;
}

// The neighbors as the caller gives them: for each cell, those opposite to its vertices.
template <typename NeighborRange>
std::optional<Refusal> read_neighbors(const NeighborRange& neighbors, Tetrahedra& tetrahedra)
{
  const std::size_t size = tetrahedra.number_of_cells();
  if(static_cast<std::size_t>(neighbors.size()) != size)
    return invalid_cells("cell_neighbors is not of the size of the range of cells");
  const auto one_sided = [](const Corner_index c, const Corner_index d) {
    return invalid_cells("cell_neighbors: cell " + std::to_string(c) + " has the neighbor " +
                         std::to_string(d) + ", but not the other way round");
  };
  tetrahedra.opposite.assign(4 * size, no_facet);
  Corner_index facet = 0;
  for(const auto& cell : neighbors) {
    const auto name = [&] { return "cell_neighbors, cell " + std::to_string(facet / 4) + ": "; };
    if(cell.size() != 4)
      return invalid_cells(name() + "there must be 4");
    for(const auto d : cell) {
      Corner_index& here = tetrahedra.opposite[std::size_t(facet)]; // known from an earlier cell
      const bool is_cell = is_index_below(d, size);
      if(is_cell ? here < 0 || here / 4 != static_cast<Corner_index>(d) : here >= 0 || !(d < 0)) {
        const Corner_index c = facet / 4;
        const Corner_index other =
          is_cell ? facet_of_cell(tetrahedra, static_cast<Corner_index>(d), facet) : no_facet;
        if(!(d < 0) && (other < 0 || other / 4 == c))
          return invalid_cells(name() + std::to_string(d) + " is no cell with the facet opposite "
                               "to vertex " + std::to_string(facet % 4));
        if(here >= 0)
          return one_sided(here / 4, c);
        if(other / 4 < c || tetrahedra.opposite[std::size_t(other)] >= 0)
          return one_sided(c, other / 4);
        here = other;
        tetrahedra.opposite[std::size_t(other)] = facet;
      }
      ++facet;
    }
  }
  return std::nullopt;
}

// The neighbors by common vertices. Two cells with the same vertices are one that is there twice.
inline std::optional<Refusal> find_neighbors(Tetrahedra& tetrahedra)
{
  const auto third = Facet_matcher(tetrahedra.vertices, tetrahedra.number_of_vertices)
                       .run(tetrahedra.opposite);
  if(third != no_facet)
    return Refusal(Outcome::NOT_MANIFOLD,
                   name_of_facet(tetrahedra, third) + " belongs to more than two cells; remove "
                     "those that are there twice, or divide the mesh into manifold parts");
  for(std::size_t f = 0; f < tetrahedra.opposite.size(); f += 4) {
    const Corner_index first = tetrahedra.opposite[f];
    if(first >= 0 && first / 4 == tetrahedra.opposite[f + 1] / 4 &&
       tetrahedra.opposite[f + 1] >= 0)
      return Refusal(Outcome::NOT_MANIFOLD,
                     "cells " + std::to_string(f / 4) + " and " + std::to_string(first / 4) +
                       " have the same vertices; remove one of them");
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_TETRAHEDRA_H
