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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_DOMAIN_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_DOMAIN_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The domain of a layout: a chart mesh with its walls, which are features and border edges on
// isocurves; the rest of its border, which is oblique; and the vertices at which curves start.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

enum class Start_kind : char
{
  NONE,   // no curve starts here
  CONE,   // an interior vertex whose angle is not 360 degrees
  CORNER, // where walls end, meet, or turn
  GIVEN,  // by the caller
  SEED    // in a part of the surface without any other
};

// Invariant: all walls lie on isocurves; the two walls at a vertex without curves are opposite. So
// both border edges of a vertex without curves are walls, or both are oblique.
struct Layout_domain
{
  Chart_mesh mesh;
  std::vector<char> is_wall;      // per corner: its edge
  std::vector<char> is_on_wall;   // per vertex
  std::vector<Start_kind> starts; // per vertex
  bool has_oblique_border = false;

  bool is_start(const std::size_t v) const { return starts[v] != Start_kind::NONE; }

  // A border edge that lies on no isocurve.
  bool is_oblique(const Corner_index h) const
  { return mesh.is_border_edge(h) && !is_wall[std::size_t(h)]; }

  // Curves end there: on the border, but on no wall.
  bool is_inside_oblique_border(const std::size_t v) const
  { return mesh.is_border[v] && !is_on_wall[v] && !is_start(v); }
};

// The first and the last edge of the star of a border vertex, counterclockwise: the border edges
// that leave it and point to it.
inline Corner_index border_edge_from(const Chart_mesh& mesh, const std::size_t v)
{ return Chart_mesh::next(mesh.corner_at_vertex[v]); }

inline Corner_index border_edge_to(const Chart_mesh& mesh, const std::size_t v)
{
  Corner_index h = mesh.corner_at_vertex[v];
  while(mesh.counterclockwise(h) != no_index)
    h = mesh.counterclockwise(h);
  return h;
}

// Arcs leave a vertex in slots, counterclockwise: one for each ray, one for an oblique border edge
// before these, and one behind.
struct Vertex_slots
{
  std::int32_t first_ray = 0, number = 0;
};

inline Vertex_slots slots_of_vertex(const Layout_domain& domain, const std::size_t v)
{
  const Chart_mesh& mesh = domain.mesh;
  Vertex_slots result;
  result.number = std::int32_t(rays_from_vertex(mesh, v).size());
  if(!mesh.is_border[v])
    return result;
  result.first_ray = domain.is_oblique(border_edge_from(mesh, v)) ? 1 : 0;
  result.number += result.first_ray + (domain.is_oblique(border_edge_to(mesh, v)) ? 1 : 0);
  return result;
}

// The halfedge along which a ray leads, in either direction, if it leads along an edge.
inline Corner_index edge_of_ray(const Vertex_ray& ray)
{
  switch(ray.kind) {
  case Ray_kind::ALONG_FIRST_EDGE: return Chart_mesh::next(ray.corner);
  case Ray_kind::ALONG_LAST_EDGE:  return ray.corner;
  case Ray_kind::THROUGH_FACE:     break;
  }
  return no_index;
}

inline bool is_along_wall(const Layout_domain& domain, const Vertex_ray& ray)
{
  const Corner_index h = edge_of_ray(ray);
  return h != no_index && domain.is_wall[std::size_t(h)];
}

// Features are walls: `is_feature` tells of corners whether their edge is one, or is empty; and
// border edges: all, or the border edges that lie on isocurves.
inline void mark_walls(const std::vector<char>& is_feature, const bool is_border_wall,
                       Layout_domain& domain)
{
  const Chart_mesh& mesh = domain.mesh;
  domain.is_wall.assign(mesh.corners.size(), false);
  domain.is_on_wall.assign(mesh.number_of_vertices(), false);
  for(std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Corner_index h = Corner_index(i);
    const bool is_wall = (!is_feature.empty() && is_feature[i]) ||
                         (mesh.is_border_edge(h) && (is_border_wall || is_on_isocurve(mesh, h)));
    domain.has_oblique_border =
      domain.has_oblique_border || (mesh.is_border_edge(h) && !is_wall);
    if(!is_wall)
      continue;
    domain.is_wall[i] = true;
    domain.is_on_wall[mesh.vertex(h)] = domain.is_on_wall[mesh.source(h)] = true;
  }
}

// Whether the walls at a vertex run straight on, with as much angle on either side as on a regular
// surface.
inline bool is_straight_wall(const Layout_domain& domain, const std::size_t v)
{
  const Vertex_rays rays = rays_from_vertex(domain.mesh, v);
  std::size_t walls = 0, sum = 0;
  for(std::size_t k = 0; k < rays.size(); ++k)
    if(is_along_wall(domain, rays[k])) {
      ++walls;
      sum += k;
    }
  const Chart_mesh& mesh = domain.mesh;
  if(mesh.is_border[v])
    return rays.size() == 3 && walls == 2 && !domain.is_oblique(border_edge_from(mesh, v)) &&
           !domain.is_oblique(border_edge_to(mesh, v));
  return rays.size() == 4 && walls == 2 && sum % 2 == 0;
}

// The vertices at which the geometry asks for curves. `is_given` marks vertices at which the caller
// does, or is empty.
// \pre the walls are marked, and lie on isocurves
inline void mark_starts(const std::vector<char>& is_given, Layout_domain& domain)
{
  const std::size_t n = domain.mesh.number_of_vertices();
  domain.starts.assign(n, Start_kind::NONE);
  for(std::size_t v = 0; v < n; ++v) {
    if(domain.mesh.is_singular[v])
      domain.starts[v] = Start_kind::CONE;
    else if(domain.is_on_wall[v] && !is_straight_wall(domain, v))
      domain.starts[v] = Start_kind::CORNER;
    else if(!is_given.empty() && is_given[v])
      domain.starts[v] = Start_kind::GIVEN;
  }
}

// Parts of the surface between walls in which no curve would start, such as tori and annuli without
// cones: each gets one vertex at which curves start. Which one depends on the coordinates, not on
// numbers.

// The key by which vertices are compared: the coordinates of all corners, least first.
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

// A vertex of a wall if the part has one, because its curves make fewer patches; among these the
// vertex with the least coordinates.
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
  const std::vector<std::int32_t> parts =
    connected_parts(std::size_t(mesh.number_of_faces()), [&](const Corner_index h)
                    { return domain.is_wall[std::size_t(h)] ? no_index : mesh.opposite(h); });
  std::vector<char> has_start(parts.size(), false);
  const auto part = [&](const Corner_index h) { return parts[std::size_t(mesh.face(h))]; };
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(domain.is_start(mesh.vertex(h)))
      has_start[std::size_t(part(h))] = true;

  std::vector<std::pair<std::int32_t, std::size_t> > candidates; // part, vertex
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!has_start[std::size_t(part(h))])
      candidates.emplace_back(part(h), mesh.vertex(h));
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  for(auto i = candidates.begin(); i != candidates.end();) {
    std::vector<std::size_t> vertices;
    for(const std::int32_t p = i->first; i != candidates.end() && i->first == p; ++i)
      vertices.push_back(i->second);
    domain.starts[choose_seed(domain, vertices)] = Start_kind::SEED;
  }
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_DOMAIN_H
