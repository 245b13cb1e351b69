// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_UV_POINTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_UV_POINTS_H

#include <CGAL/license/Seamless_snapping.h>

// The points of the domain whose coordinates repairs of orientations may change: sectors, and vertices that
// belong to none. Joins the two under one kind of index, and finds the points of a face's corners.

#include <CGAL/Seamless_snapping/internal/algebra/Grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>
#include <CGAL/Seamless_snapping/internal/surface/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// First the sectors, then the other vertices in the order in which they are met.
using Point_index = std::int32_t;

template <typename Halfedge>
struct Uv_face
{
  std::array<Halfedge, 3> corners; // counterclockwise
  std::array<Point_index, 3> points;
};

// Coordinates of points under way. Points that were met later have those of the input.
using Uv_state = std::vector<Uv>;

// Those of the sectors among them.
struct Sector_uv
{
  const Uv_state& state;
  const Uv& uv(const Sector_index s) const { return state[std::size_t(s)]; }
};

// The input, where each sector has one coordinate pair only.
template <typename Sectors>
Uv_state input_of_sectors(const Sectors& sectors)
{
  Uv_state result;
  for(std::size_t s = 0; s < sectors.number_of_sectors(); ++s)
    result.push_back(sectors.sector(Sector_index(s)).uv);
  return result;
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Uv_points
{
public:
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Halfedge = typename Sectors::Halfedge;
  using Face = Uv_face<Halfedge>;

  Uv_points(const Sectors& sectors, const HalfedgeUVMap& uv_map, const VertexIndexMap& vertex_indices)
    : m_sectors(sectors), m_uv_map(uv_map), m_vertex_indices(vertex_indices)
  { }

  const Sectors& sectors() const { return m_sectors; }
  const TriangleMesh& mesh() const { return m_sectors.mesh(); }

  bool is_sector(const Point_index p) const { return std::size_t(p) < m_sectors.number_of_sectors(); }
  std::size_t size() const { return m_sectors.number_of_sectors() + m_free_corners.size(); }

  Point_index point(const Halfedge corner)
  {
    const Sector_index s = sector(corner);
    if(s >= 0)
      return s;
    const auto found = m_free_points.find(corner);
    if(found != m_free_points.end())
      return found->second;
    const Point_index p = Point_index(size());
    m_free_corners.push_back(corner);
    for_each_corner(p, [&](const Halfedge h) { m_free_points.emplace(h, p); });
    return p;
  }

  Face face(const Halfedge corner)
  {
    Face result{{{corner, next(corner, mesh()), prev(corner, mesh())}}, {}};
    for(std::size_t i = 0; i < 3; ++i)
      result.points[i] = point(result.corners[i]);
    return result;
  }

  Vertex_index vertex_of(const Sector_index s) const
  {
    Vertex_index low = 0, high = Vertex_index(m_sectors.number_of_vertices());
    while(high - low > 1) {
      const Vertex_index middle = low + (high - low) / 2;
      (m_sectors.first_sector(middle) <= s ? low : high) = middle;
    }
    return low;
  }

  Uv input(const Halfedge corner) const { return get_uv(m_uv_map, corner); }

  Uv_triangle input(const Face& f) const
  {
    return {{input(f.corners[0]), input(f.corners[1]), input(f.corners[2])}};
  }

  Uv uv(const Uv_state& state, const Point_index p) const
  {
    return std::size_t(p) < state.size()
      ? state[std::size_t(p)]
      : input(m_free_corners[std::size_t(p) - m_sectors.number_of_sectors()]);
  }

  Uv_triangle uv(const Uv_state& state, const Face& f) const
  {
    return {{uv(state, f.points[0]), uv(state, f.points[1]), uv(state, f.points[2])}};
  }

  // The distance of neighboring numbers that the point can take: those of its grid or, where no
  // constraint concerns it, of its coordinates' type, anywhere in the ring around it.
  double spacing(const Point_index p, const Grid& grid) const
  {
    if(is_sector(p) && m_sectors.is_constrained(vertex_of(p)))
      return std::ldexp(grid.step(), -m_sectors.sector(p).magnification);
    double largest = 0;
    for_each_corner(p, [&](const Halfedge corner) {
      for(const Halfedge h : {corner, next(corner, mesh()), prev(corner, mesh())})
        largest = (std::max)(largest, largest_component(input(h)));
    });
    return Grid::finest(grid.format(), largest).step();
  }

  void set_uv(Uv_state& state, const Point_index p, const Uv& u) const
  {
    while(state.size() <= std::size_t(p))
      state.push_back(uv(state, Point_index(state.size())));
    state[std::size_t(p)] = u;
  }

  template <typename F>
  void for_each_corner(const Point_index p, const F& f) const
  {
    if(is_sector(p)) {
      for(auto h = m_sectors.corners_begin(p); h != m_sectors.corners_end(p); ++h)
        f(*h);
      return;
    }
    // all around, or up to the border on either side: beyond, there may be more corners of the vertex
    const Halfedge first = m_free_corners[std::size_t(p) - m_sectors.number_of_sectors()];
    Halfedge h = first;
    do {
      f(h);
      h = opposite(next(h, mesh()), mesh());
    } while(h != first && !is_border(h, mesh()));
    if(h == first)
      return;
    for(h = opposite(first, mesh()); !is_border(h, mesh()); h = opposite(h, mesh())) {
      h = prev(h, mesh());
      f(h);
    }
  }

private:
  // The sectors' vertices are in the order of the mesh's indices, so that no table is needed.
  Sector_index sector(const Halfedge corner) const
  {
    if(m_sectors.number_of_sectors() == 0)
      return -1;
    const std::size_t index = vertex_index(corner);
    Vertex_index low = 0, high = Vertex_index(m_sectors.number_of_vertices());
    while(high - low > 1) {
      const Vertex_index middle = low + (high - low) / 2;
      const Halfedge h = *m_sectors.corners_begin(m_sectors.first_sector(middle));
      (vertex_index(h) <= index ? low : high) = middle;
    }
    for(Sector_index s = m_sectors.first_sector(low); s != m_sectors.first_sector(low + 1); ++s)
      if(std::find(m_sectors.corners_begin(s), m_sectors.corners_end(s), corner) != m_sectors.corners_end(s))
        return s;
    return -1;
  }

  std::size_t vertex_index(const Halfedge corner) const
  {
    return std::size_t(get(m_vertex_indices, target(corner, mesh())));
  }

  const Sectors& m_sectors;
  const HalfedgeUVMap& m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  std::unordered_map<Halfedge, Point_index> m_free_points; // by corner
  std::vector<Halfedge> m_free_corners;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_UV_POINTS_H
