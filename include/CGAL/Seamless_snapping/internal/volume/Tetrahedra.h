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

// The combinatorics of the caller's tetrahedra: vertices and neighbors of all cells.

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Whether two cells list their common facet in the same cyclic order: then they are listed in
// different orientations. Facets opposite to odd corners are listed the other way round.
inline bool are_listed_alike(const std::vector<std::int32_t>& vertices, const Corner_index facet,
                             const Corner_index other)
{
  const auto vertex = [&](const Corner_index corner) { return vertices[std::size_t(corner)]; };
  const auto here = corners_of_facet(facet), there = corners_of_facet(other);
  int is_same = 0;
  for(std::size_t i = 0; i < 3; ++i)
    is_same |= int(vertex(here[0]) == vertex(there[i])) &
               int(vertex(here[1]) == vertex(there[(i + 1) % 3]));
  return (is_same != 0) == ((facet - other) % 2 == 0);
}

// The neighbors of the cells of a mesh that is given by vertices alone: facets meet in the bucket
// of their least vertex.
class Facet_matcher
{
public:
  // \param vertices per corner, from 0 to `number_of_vertices` - 1
  Facet_matcher(const std::vector<std::int32_t>& vertices, const std::size_t number_of_vertices)
    : m_vertices(vertices), m_buckets(number_of_vertices, [&](const auto& add) {
        for(std::size_t f = 0; f < vertices.size(); ++f)
          add(key(Corner_index(f))[0], Corner_index(f));
      })
  { }

  // Fills in, per facet, the cell on the other side, or -1, and whether all facets are listed in
  // opposite orders by their two cells. Returns a facet that more than two cells have, or
  // `no_facet`.
  Corner_index run(std::vector<std::int32_t>& neighbors, bool& are_coherent)
  {
    are_coherent = true;
    neighbors.assign(m_vertices.size(), -1);
    std::vector<std::pair<Key, Corner_index> > bucket;
    for(std::size_t v = 0; v < m_buckets.size(); ++v) {
      bucket.clear();
      for(const Corner_index facet : m_buckets[v])
        bucket.emplace_back(key(facet), facet);
      std::sort(bucket.begin(), bucket.end());
      for(std::size_t i = 0; i + 1 < bucket.size(); ++i) {
        if(bucket[i].first != bucket[i + 1].first)
          continue;
        if(i + 2 < bucket.size() && bucket[i + 2].first == bucket[i].first)
          return bucket[i].second;
        neighbors[std::size_t(bucket[i].second)] = bucket[i + 1].second / 4;
        neighbors[std::size_t(bucket[i + 1].second)] = bucket[i].second / 4;
        are_coherent = are_coherent &&
                       !are_listed_alike(m_vertices, bucket[i].second, bucket[i + 1].second);
        ++i;
      }
    }
    return no_facet;
  }

private:
  using Key = std::array<std::int32_t, 3>;

  Key key(const Corner_index facet) const
  {
    Key result;
    const auto corners = corners_of_facet(facet);
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = m_vertices[std::size_t(corners[i])];
    std::sort(result.begin(), result.end());
    return result;
  }

  const std::vector<std::int32_t>& m_vertices;
  Lists<Corner_index> m_buckets; // facets per vertex
};

// 32 bytes a cell. Invariants: there are at most four times as many vertices as cells; where
// neighbors were not given, all cells of a component that has an orientation have the same.
struct Tetrahedra
{
  std::vector<std::int32_t> vertices;  // per corner
  std::vector<std::int32_t> neighbors; // per facet: the cell on the other side, or -1
  std::size_t number_of_vertices = 0;  // 1 + the largest index
  std::vector<std::int32_t> names;     // per vertex, ascending; none where they are the indices
  bool has_given_neighbors = false;    // which may be wrong
  Turned_cells turned;

  std::size_t number_of_cells() const { return vertices.size() / 4; }

  // The other side of a facet that has a neighbor; `no_facet` if the neighbor has no such facet.
  Corner_index opposite(const Corner_index facet) const
  {
    const auto vertex = [&](const Corner_index i) { return vertices[std::size_t(i)]; };
    const auto corners = corners_of_facet(facet);
    const Corner_index first = 4 * neighbors[std::size_t(facet)];
    Corner_index result = no_facet;
    for(Corner_index i = first; i < first + 4; ++i)
      if(vertex(i) != vertex(corners[0]) && vertex(i) != vertex(corners[1]) &&
         vertex(i) != vertex(corners[2])) {
        if(result != no_facet)
          return no_facet; // two other vertices
        result = i;
      }
    return result;
  }

  // Lists a cell in the other orientation.
  void turn(const std::size_t c)
  {
    turned.is_turned.resize(number_of_cells(), 0);
    turned.is_turned[c] ^= 1;
    std::swap(vertices[4 * c], vertices[4 * c + 1]);
    std::swap(neighbors[4 * c], neighbors[4 * c + 1]);
  }

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

// If names are much larger than their number, arrays must not grow with them.
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

inline Refusal invalid_cells(const Message& message)
{
  return {Outcome::INVALID_ARGUMENT, message};
}

inline Message name_of_facet(const Tetrahedra& tetrahedra, const Corner_index facet)
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
    return invalid_cells("the mesh has no cell");
  if(size > largest_number_of_tetrahedra)
    return invalid_cells("the mesh has more than " + std::to_string(largest_number_of_tetrahedra) +
                         " cells" + remedy("divide it"));
  result.vertices.resize(4 * size);
  std::size_t first = 0;
  for(const auto& cell : tetrahedra) {
    const auto name = [&] { return name_of_element("cell", first / 4); };
    if(cell.size() != 4)
      return invalid_cells(name() + " has " + std::to_string(cell.size()) +
                           " vertices in place of 4");
    std::size_t i = first;
    for(const auto v : cell) {
      if(!is_index_below(v, largest_vertex_index + 1))
        return invalid_cells(name() + " has a vertex whose index is negative or too large");
      for(std::size_t j = first; j < i; ++j)
        if(result.vertices[j] == static_cast<std::int32_t>(v))
          return invalid_cells(name() + " has " + name_of_vertex(std::size_t(v)) + " twice" +
                               remedy("remove it"));
      result.vertices[i++] = static_cast<std::int32_t>(v);
      result.number_of_vertices = (std::max)(result.number_of_vertices, std::size_t(v) + 1);
    }
    first = i;
  }
  renumber_vertices(result);
  return std::nullopt;
}

// The neighbors as the caller gives them: for each cell, the cells opposite to its vertices. The
// survey checks that they fit.
template <typename NeighborRange>
std::optional<Refusal> read_neighbors(const NeighborRange& neighbors, Tetrahedra& tetrahedra)
{
  const std::size_t size = tetrahedra.number_of_cells();
  if(static_cast<std::size_t>(neighbors.size()) != size)
    return invalid_cells("cell_neighbors is not of the size of the range of cells");
  tetrahedra.has_given_neighbors = true;
  tetrahedra.neighbors.resize(4 * size);
  std::size_t facet = 0;
  for(const auto& cell : neighbors) {
    const auto name = [&] {
      return term("cell_neighbors") + ", " + name_of_element("cell", facet / 4) + ": ";
    };
    if(cell.size() != 4)
      return invalid_cells(name() + "there must be 4");
    for(const auto d : cell) {
      if(!(d < 0) && (!is_index_below(d, size) || static_cast<std::size_t>(d) == facet / 4))
        return invalid_cells(name() + std::to_string(d) + " is no other cell" +
                             remedy("without a neighbor, the number must be negative"));
      tetrahedra.neighbors[facet++] = d < 0 ? -1 : static_cast<std::int32_t>(d);
    }
  }
  return std::nullopt;
}

// Sets the other side of a facet that has a neighbor. Returns what is wrong with that, if so.
inline std::optional<Refusal> find_opposite(const Tetrahedra& tetrahedra, const Corner_index facet,
                                            Corner_index& other)
{
  other = tetrahedra.opposite(facet);
  const bool is_mutual = other >= 0 && tetrahedra.neighbors[std::size_t(other)] == facet / 4;
  if(is_mutual && !(tetrahedra.has_given_neighbors &&
                    are_listed_alike(tetrahedra.vertices, facet, other)))
    return std::nullopt;
  const std::size_t c = std::size_t(facet / 4);
  const std::string d = std::to_string(tetrahedra.neighbors[std::size_t(facet)]);
  const Message place = term("cell_neighbors");
  if(is_mutual)
    return invalid_cells(place + ": " + name_of_element("cells", c) + " and " + d +
                         " list their common " + name_of_facet(tetrahedra, facet) +
                         " in the same order" + remedy("list all cells in one orientation, or "
                                                       "leave cell_neighbors out"));
  if(other < 0)
    return invalid_cells(place + ", " + name_of_element("cell", c) + ": " + d +
                         " is no cell with the facet opposite to vertex " +
                         std::to_string(tetrahedra.turned.key(std::size_t(facet)) % 4));
  return invalid_cells(place + ": " + name_of_element("cell", c) + " has the neighbor " + d +
                       ", but not the other way round");
}

// Turns the cells of each component with the sign of the minority. A component that has no
// orientation stays as it is listed.
// \param components cells that agree have the same sign
// \param vote(c) of a cell: 1, -1, or 0
template <typename Vote>
void turn_minorities(Signed_union_find& components, const Vote& vote, Tetrahedra& tetrahedra)
{
  std::vector<std::int32_t> surplus(components.size(), 0); // per root: of cells that agree with it
  for(std::size_t c = 0; c < components.size(); ++c)
    surplus[components.root(c)] += components.find(c).sign * vote(c);
  for(std::size_t c = 0; c < components.size(); ++c) {
    const auto [root, sign] = components.find(c);
    if(!components.is_zero(root) && (surplus[root] < 0) == (sign > 0))
      tetrahedra.turn(c);
  }
}

// Makes the cells of each component agree with most of them.
inline void turn_cells(Tetrahedra& tetrahedra)
{
  Signed_union_find components(tetrahedra.number_of_cells());
  for(std::size_t f = 0; f < tetrahedra.neighbors.size(); ++f)
    if(const std::int32_t d = tetrahedra.neighbors[f]; d > std::int32_t(f / 4)) {
      const auto facet = Corner_index(f);
      components.unite(f / 4, std::size_t(d),
                       are_listed_alike(tetrahedra.vertices, facet, tetrahedra.opposite(facet))
                         ? -1 : 1);
    }
  turn_minorities(components, [](std::size_t) { return 1; }, tetrahedra);
}

// The neighbors by common vertices. Two cells with the same vertices are one that is there twice.
inline std::optional<Refusal> find_neighbors(Tetrahedra& tetrahedra)
{
  bool are_coherent;
  const auto third = Facet_matcher(tetrahedra.vertices, tetrahedra.number_of_vertices)
                       .run(tetrahedra.neighbors, are_coherent);
  if(third != no_facet)
    return Refusal(Outcome::NOT_MANIFOLD,
                   name_of_facet(tetrahedra, third) + " belongs to more than two cells" +
                     remedy("remove duplicate cells, or divide the mesh into manifold parts"));
  for(std::size_t f = 0; f < tetrahedra.neighbors.size(); f += 4)
    if(const std::int32_t d = tetrahedra.neighbors[f]; d >= 0 && d == tetrahedra.neighbors[f + 1])
      return Refusal(Outcome::NOT_MANIFOLD,
                     name_of_element("cells", f / 4) + " and " + std::to_string(d) +
                       " have the same vertices" + remedy("remove one of them"));
  if(!are_coherent)
    turn_cells(tetrahedra);
  return std::nullopt;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_TETRAHEDRA_H
