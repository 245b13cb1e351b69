// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_SEEDS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_SEEDS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Parts of the surface in which no curve would start, such as tori and annuli without cones: each
// gets one vertex at which curves start. Which one depends on the coordinates, not on numbers.

#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// The parts that walls divide the surface into, per face: a face of the part. Sides of a wall may
// belong to the same part.
inline std::vector<std::int32_t> parts_between_walls(const Layout_domain& domain)
{
  const Chart_mesh& mesh = domain.mesh;
  const std::size_t n = std::size_t(mesh.number_of_faces());
  std::vector<std::int32_t> ranks(n, 0), parents(n);
  boost::disjoint_sets<std::int32_t*, std::int32_t*> sets(ranks.data(), parents.data());
  for(std::size_t f = 0; f < n; ++f)
    sets.make_set(std::int32_t(f));
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!domain.is_wall[std::size_t(h)] && h < mesh.opposite(h))
      sets.union_set(mesh.face(h), mesh.face(mesh.opposite(h)));
  for(std::size_t f = 0; f < n; ++f)
    parents[f] = sets.find_set(std::int32_t(f));
  return parents;
}

// What vertices are compared by: the coordinates of all corners, least first.
inline std::vector<Uv> coordinates_around(const Chart_mesh& mesh, const std::size_t v)
{
  std::vector<Uv> result;
  for_each_corner(mesh, v, [&](const Corner_index h) { result.push_back(mesh.uv(h)); });
  std::sort(result.begin(), result.end());
  return result;
}

inline std::size_t vertex_with_least_coordinates(const Chart_mesh& mesh,
                                                 const std::vector<std::size_t>& vertices)
{
  std::size_t best = vertices.front();
  std::vector<Uv> least = coordinates_around(mesh, best);
  for(const std::size_t v : vertices) {
    std::vector<Uv> coordinates = coordinates_around(mesh, v);
    if(coordinates < least) {
      least = std::move(coordinates);
      best = v;
    }
  }
  return best;
}

// A vertex of a wall if the part has one, as its curves make fewer patches; among these the one
// with the least coordinates.
inline std::size_t choose_seed(const Layout_domain& domain, std::vector<std::size_t>& vertices)
{
  if(std::any_of(vertices.begin(), vertices.end(),
                 [&](const std::size_t v) { return domain.is_on_wall[v] != 0; }))
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [&](const std::size_t v)
                                  { return domain.is_on_wall[v] == 0; }),
                   vertices.end());
  return vertex_with_least_coordinates(domain.mesh, vertices);
}

// \pre all other starts are marked
inline void add_seeds(Layout_domain& domain)
{
  const Chart_mesh& mesh = domain.mesh;
  const std::vector<std::int32_t> parts = parts_between_walls(domain);
  std::vector<char> has_start(parts.size(), false);
  const auto part = [&](const Corner_index h)
    { return std::size_t(parts[std::size_t(mesh.face(h))]); };
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(domain.is_start(mesh.vertex(h)))
      has_start[part(h)] = true;

  std::vector<std::pair<std::size_t, std::size_t> > candidates; // part, vertex
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!has_start[part(h)])
      candidates.emplace_back(part(h), mesh.vertex(h));
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  for(auto i = candidates.begin(); i != candidates.end();) {
    std::vector<std::size_t> vertices;
    for(const std::size_t p = i->first; i != candidates.end() && i->first == p; ++i)
      vertices.push_back(i->second);
    domain.starts[choose_seed(domain, vertices)] = Start_kind::SEED;
  }
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_SEEDS_H
