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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MATCH_FACETS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MATCH_FACETS_H

#include <CGAL/license/Seamless_snapping.h>

// The neighbors of the cells of a tetrahedral mesh that is given by vertices alone.

#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Facets meet in the bucket of their least vertex.
class Facet_matcher
{
public:
  // \param vertices per corner, from 0 to `number_of_vertices` - 1
  Facet_matcher(const std::vector<std::int32_t>& vertices, const std::size_t number_of_vertices)
    : m_vertices(vertices)
  {
    std::vector<std::int32_t> begin(number_of_vertices + 1, 0);
    for(std::size_t f = 0; f < vertices.size(); ++f)
      ++begin[std::size_t(key(Corner_index(f))[0]) + 1];
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      begin[v + 1] += begin[v];
    m_facets.resize(vertices.size());
    std::vector<std::int32_t> next(begin);
    for(std::size_t f = 0; f < vertices.size(); ++f)
      m_facets[std::size_t(next[std::size_t(key(Corner_index(f))[0])]++)] = Corner_index(f);
    m_begin.swap(begin);
  }

  // Fills in, per facet, the cell on the other side, or -1. Returns a facet that more than two
  // cells have, or `no_facet`.
  Corner_index run(std::vector<std::int32_t>& neighbors)
  {
    neighbors.assign(m_vertices.size(), -1);
    std::vector<std::pair<Key, Corner_index> > bucket;
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v) {
      bucket.clear();
      for(std::int32_t i = m_begin[v]; i < m_begin[v + 1]; ++i)
        bucket.emplace_back(key(m_facets[std::size_t(i)]), m_facets[std::size_t(i)]);
      std::sort(bucket.begin(), bucket.end());
      for(std::size_t i = 0; i + 1 < bucket.size(); ++i) {
        if(bucket[i].first != bucket[i + 1].first)
          continue;
        if(i + 2 < bucket.size() && bucket[i + 2].first == bucket[i].first)
          return bucket[i].second;
        neighbors[std::size_t(bucket[i].second)] = bucket[i + 1].second / 4;
        neighbors[std::size_t(bucket[i + 1].second)] = bucket[i].second / 4;
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
  std::vector<std::int32_t> m_begin;  // per vertex
  std::vector<Corner_index> m_facets; // by their least vertices
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_MATCH_FACETS_H
