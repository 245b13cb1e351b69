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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SURVEY_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SURVEY_H

#include <CGAL/license/Seamless_snapping.h>

// The pass over all cells: finds the facets whose two sides are not the same to the bit, and
// copies the cells at the vertices that constraints concern. Later steps know neither the
// caller's mesh nor its map.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/volume/Tetrahedra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename CornerUVWMap>
Uvw get_uvw(const CornerUVWMap& uvw_map, const std::size_t corner)
{
  const auto& p = get(uvw_map, corner);
  return {static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())};
}

// The features: vertices of facets and edges, each in ascending order.
struct Volume_features
{
  std::set<std::array<std::int64_t, 3> > facets;
  std::set<std::array<std::int64_t, 2> > edges;
};

// Differences of larger ones overflow, or their determinants do.
constexpr double largest_uvw = 1e300;

template <typename CornerUVWMap>
class Volume_survey
{
public:
  Volume_survey(const Tetrahedra& tetrahedra, const CornerUVWMap& uvw_map)
    : m_tetrahedra(tetrahedra), m_uvw_map(uvw_map),
      m_is_marked(tetrahedra.number_of_vertices, 0)
  { }

  // Fills in the cells at facets whose sides differ and at aligned facets and edges, and those at
  // some further vertices, but for their coordinates. Returns what is wrong with the input, if so.
  std::optional<Refusal> run(const bool align_boundary, const Volume_features& features,
                             const std::vector<std::int64_t>& further_vertices,
                             Flat_volume& volume)
  {
    for(const std::int64_t name : further_vertices)
      m_is_marked[std::size_t(m_tetrahedra.vertex_of_name(name))] = 1;
    if(auto refusal = find_facets(align_boundary))
      return refusal;
    if(auto refusal = find_features(features, align_boundary))
      return refusal;
    if(auto refusal = copy_cells(volume))
      return refusal;
    volume.extent = 0;
    for(std::size_t c = 0; c < 3; ++c)
      volume.extent = (std::max)(volume.extent, m_largest[c] - m_least[c]);
    return std::nullopt;
  }

private:
  std::optional<Refusal> find_facets(const bool align_boundary)
  {
    if(auto refusal = find_split_vertices())
      return refusal;
    for(std::size_t c = 0; c < m_tetrahedra.number_of_cells(); ++c) {
      const bool may_differ = is_at_vertex(c, m_is_split);
      for(Corner_index facet = Corner_index(4 * c); facet < Corner_index(4 * c + 4); ++facet) {
        if(m_tetrahedra.neighbors[std::size_t(facet)] < 0) {
          if(align_boundary)
            add(facet, m_aligned_facets);
          continue;
        }
        if(!may_differ && !m_tetrahedra.has_given_neighbors) // a wrong one would hide a boundary
          continue;
        Corner_index other;
        if(auto refusal = find_opposite(m_tetrahedra, facet, other))
          return refusal;
        if(may_differ && facet < other && !are_identical(facet, other))
          add(facet, m_open_facets);
      }
    }
    return std::nullopt;
  }

  // Whether a vertex of a cell has a mark.
  bool is_at_vertex(const std::size_t c, const std::vector<char>& marks) const
  {
    const std::int32_t* const v = m_tetrahedra.vertices.data() + 4 * c;
    return (marks[std::size_t(v[0])] | marks[std::size_t(v[1])] | marks[std::size_t(v[2])] |
            marks[std::size_t(v[3])]) != 0;
  }

  void add(const Corner_index facet, std::vector<Corner_index>& facets)
  {
    facets.push_back(facet);
    for(const Corner_index corner : corners_of_facet(facet))
      m_is_marked[std::size_t(vertex(corner))] = 1;
  }

  // Most vertices have one image, with which each corner is compared: that reads the map once, in
  // order, where a comparison of facets would jump between their cells.
  std::optional<Refusal> find_split_vertices()
  {
    m_least.fill(std::numeric_limits<double>::infinity());
    m_largest.fill(-std::numeric_limits<double>::infinity());
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Uvw> image(m_tetrahedra.number_of_vertices, {none, none, none});
    m_is_split.assign(image.size(), 0);
    for(std::size_t i = 0; i < m_tetrahedra.vertices.size(); ++i) {
      const Uvw u = uvw(Corner_index(i));
      if(!add_to_extent(u))
        return Refusal(Outcome::NOT_FINITE,
                       name_of_element("cell", i / 4) + ": a coordinate at " +
                         name_of_vertex(std::size_t(name(Corner_index(i)))) +
                         " is NaN, infinite, or beyond 1e300" +
                         remedy("correct it, or scale the map down"));
      const std::size_t v = std::size_t(vertex(Corner_index(i)));
      if(std::isnan(image[v][0]))
        image[v] = u;
      else if(image[v] != u)
        m_is_split[v] = 1;
    }
    return std::nullopt;
  }

  bool add_to_extent(const Uvw& u)
  {
    for(std::size_t c = 0; c < 3; ++c) {
      if(!(std::abs(u[c]) <= largest_uvw))
        return false;
      m_least[c] = (std::min)(m_least[c], u[c]);
      m_largest[c] = (std::max)(m_largest[c], u[c]);
    }
    return true;
  }

  bool are_identical(const Corner_index facet, const Corner_index other) const
  {
    const auto others = corners_of_facet(other);
    for(const Corner_index corner : corners_of_facet(facet)) {
      std::size_t i = 0;
      while(vertex(others[i]) != vertex(corner))
        ++i;
      if(uvw(corner) != uvw(others[i]))
        return false;
    }
    return true;
  }

  // A cell has a feature only if all its vertices belong to features.
  std::optional<Refusal> find_features(const Volume_features& features, const bool aligns_boundary)
  {
    if(features.facets.empty() && features.edges.empty())
      return std::nullopt;
    std::vector<char> is_feature(m_tetrahedra.number_of_vertices, 0);
    note_vertices(features.facets, is_feature);
    note_vertices(features.edges, is_feature);
    Volume_features missing = features;
    for(std::size_t c = 0; c < m_tetrahedra.number_of_cells(); ++c) {
      int count = 0;
      for(std::size_t i = 4 * c; i < 4 * c + 4; ++i)
        count += is_feature[std::size_t(m_tetrahedra.vertices[i])];
      if(count >= 2)
        find_features_of_cell(Corner_index(4 * c), aligns_boundary, missing);
    }
    if(!missing.facets.empty())
      return refusal("facet", *missing.facets.begin());
    if(!missing.edges.empty())
      return refusal("edge", *missing.edges.begin());
    return std::nullopt;
  }

  template <typename Elements>
  void note_vertices(const Elements& elements, std::vector<char>& is_feature) const
  {
    for(const auto& element : elements)
      for(const std::int64_t name : element)
        if(const std::int32_t v = m_tetrahedra.vertex_of_name(name); v >= 0)
          is_feature[std::size_t(v)] = 1;
  }

  void find_features_of_cell(const Corner_index first, const bool aligns_boundary,
                             Volume_features& missing)
  {
    for(Corner_index i = first; i < first + 4; ++i) {
      const auto f = corners_of_facet(i);
      std::array<std::int64_t, 3> facet{{name(f[0]), name(f[1]), name(f[2])}};
      std::sort(facet.begin(), facet.end());
      const bool is_there = aligns_boundary && m_tetrahedra.neighbors[std::size_t(i)] < 0;
      if(missing.facets.erase(facet) > 0 && !is_there)
        add(i, m_aligned_facets);
      for(Corner_index j = first; j < i; ++j) {
        const auto [low, high] = std::minmax({name(i), name(j)});
        if(missing.edges.erase(std::array<std::int64_t, 2>{{low, high}}) == 0)
          continue;
        m_aligned_edges.push_back({i, j});
        for(const Corner_index corner : {i, j})
          m_is_marked[std::size_t(vertex(corner))] = 1;
      }
    }
  }

  template <std::size_t size>
  static Refusal refusal(const char* const what, const std::array<std::int64_t, size>& element)
  {
    return {Outcome::INVALID_ARGUMENT,
            "feature " + name_of(what, {element.begin(), element.end()}) +
              " is in no cell; correct the features, or leave them out", {}};
  }

  std::optional<Refusal> copy_cells(Flat_volume& volume)
  {
    std::vector<Corner_index> place(m_tetrahedra.number_of_cells(), -1);
    for(std::size_t c = 0; c < place.size(); ++c)
      if(is_at_vertex(c, m_is_marked)) {
        place[c] = Corner_index(volume.cell_names.size());
        volume.cell_names.push_back(std::int32_t(c));
      }
    volume.turned = m_tetrahedra.turned;
    const std::size_t size = 4 * volume.number_of_cells();
    volume.vertices.reserve(size);
    volume.opposite.reserve(size);
    std::vector<std::int32_t> new_vertex(m_tetrahedra.number_of_vertices, -1);
    for(const std::int32_t c : volume.cell_names)
      for(std::size_t i = 4 * std::size_t(c); i < 4 * std::size_t(c) + 4; ++i) {
        const std::size_t old = std::size_t(m_tetrahedra.vertices[i]);
        std::int32_t& v = new_vertex[old];
        if(v < 0) {
          v = std::int32_t(volume.vertex_names.size());
          volume.vertex_names.push_back(name(Corner_index(i)));
          volume.is_fixed.push_back(m_is_marked[old] == 0);
        }
        volume.vertices.push_back(v);
        Corner_index other = no_facet;
        if(m_tetrahedra.neighbors[i] >= 0) {
          if(auto refusal = find_opposite(m_tetrahedra, Corner_index(i), other))
            return refusal;
          other = moved(other, place);
        }
        volume.opposite.push_back(other);
      }
    for(const Corner_index f : m_open_facets)
      volume.open_facets.push_back(moved(f, place));
    for(const Corner_index f : m_aligned_facets)
      volume.aligned_facets.push_back(moved(f, place));
    for(const Flat_volume::Aligned_edge& e : m_aligned_edges)
      volume.aligned_edges.push_back({moved(e.a, place), moved(e.b, place)});
    return std::nullopt;
  }

  // The number of a corner or facet in the copy.
  static Corner_index moved(const Corner_index i, const std::vector<Corner_index>& place)
  {
    const Corner_index cell = place[std::size_t(i / 4)];
    return cell < 0 ? facet_elsewhere : 4 * cell + i % 4;
  }

  std::int32_t vertex(const Corner_index corner) const
  {
    return m_tetrahedra.vertices[std::size_t(corner)];
  }

  Uvw uvw(const Corner_index corner) const
  {
    return get_uvw(m_uvw_map, m_tetrahedra.turned.key(std::size_t(corner)));
  }

  std::int32_t name(const Corner_index corner) const { return m_tetrahedra.name(vertex(corner)); }

  const Tetrahedra& m_tetrahedra;
  const CornerUVWMap& m_uvw_map;
  Uvw m_least, m_largest;
  std::vector<char> m_is_marked; // per vertex: some constraint concerns it
  std::vector<char> m_is_split;  // per vertex: its corners have several images
  std::vector<Corner_index> m_open_facets, m_aligned_facets;
  std::vector<Flat_volume::Aligned_edge> m_aligned_edges;
};

// Exchanges two corners of all cells of each component of the mesh in which most cells have a
// negative orientation in the domain: these are listed the other way round, or the component is
// mirrored as a whole, and no cell is flipped against the others.
template <typename CornerUVWMap>
void turn_negative_components(const CornerUVWMap& uvw_map, Tetrahedra& tetrahedra)
{
  const std::size_t size = tetrahedra.number_of_cells();
  std::vector<signed char> sign(size, 0);
  bool is_some_negative = false;
  for(std::size_t c = 0; c < size; ++c) {
    Uvw_tetrahedron u;
    bool is_finite = true; // else the survey refuses the map
    for(std::size_t i = 0; i < 4; ++i) {
      u[i] = get_uvw(uvw_map, tetrahedra.turned.key(4 * c + i));
      is_finite = is_finite && std::isfinite(u[i][0]) && std::isfinite(u[i][1]) &&
                  std::isfinite(u[i][2]);
    }
    if(is_finite)
      sign[c] = static_cast<signed char>(orientation(u));
    is_some_negative = is_some_negative || sign[c] < 0;
  }
  if(!is_some_negative)
    return;
  Signed_union_find components(size);
  for(std::size_t f = 0; f < tetrahedra.neighbors.size(); ++f)
    if(tetrahedra.neighbors[f] >= 0)
      components.unite(f / 4, std::size_t(tetrahedra.neighbors[f]));
  turn_minorities(components, [&](const std::size_t c) { return sign[c]; }, tetrahedra);
}

// Separate, as by then what the survey needs can be gone.
template <typename CornerUVWMap>
void read_coordinates(const CornerUVWMap& uvw_map, Flat_volume& volume)
{
  volume.coordinates.reserve(volume.vertices.size());
  for(std::size_t i = 0; i < volume.vertices.size(); ++i)
    volume.coordinates.push_back(get_uvw(uvw_map, volume.key(i)));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_VOLUME_SURVEY_H
