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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MESH_STARS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MESH_STARS_H

#include <CGAL/license/Seamless_snapping.h>

// Reads from a mesh what repairs of orientations ask for.

#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>
#include <CGAL/Seamless_snapping/internal/support/prefetch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
Uv_triangle uv_triangle(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                        const Halfedge corner)
{
  return {{get_uv(uv_map, corner), get_uv(uv_map, next(corner, tmesh)),
           get_uv(uv_map, prev(corner, tmesh))}};
}

// Whether there are faces that are not positive.
template <typename TriangleMesh, typename HalfedgeUVMap>
bool has_flips(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  for(const auto f : faces(tmesh))
    if(orientation(uv_triangle(tmesh, uv_map, halfedge(f, tmesh))) != CGAL::POSITIVE)
      return true;
  return false;
}

// Invariant: the faces that were met are found by their own halfedge, the points that are not
// sectors by their corners.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Mesh_stars : public Point_stars
{
  using Cuts = Surface_cuts<Group, TriangleMesh>;
  using Halfedge = typename Cuts::Halfedge;

public:
  Mesh_stars(const TriangleMesh& tmesh, const Cuts& cuts, const HalfedgeUVMap& uv_map,
             const VertexIndexMap& vertex_indices)
    : Point_stars(cuts.complex.number_of_sectors()), m_tmesh(tmesh), m_cuts(cuts),
      m_uv_map(uv_map), m_vertex_indices(vertex_indices)
  { }

  std::vector<Face_corner> star(const Point_index p) override
  {
    std::vector<Halfedge> corners; // meeting faces changes the lists that are walked
    for_each_corner(p, [&](const Halfedge h) { corners.push_back(h); });
    std::vector<Face_corner> result;
    for(const Halfedge h : corners) {
      const Halfedge first = halfedge(face(h, m_tmesh), m_tmesh);
      result.push_back({face_index(first), h == first ? 0u : h == next(first, m_tmesh) ? 1u : 2u});
    }
    return result;
  }

  std::vector<Face_index> faces_at_risk(const double reach) override
  {
    constexpr std::size_t lookahead = 24; // corners
    const std::vector<Halfedge>& corners = m_cuts.corners;
    std::vector<Face_index> result;
    for(std::size_t i = 0; i < corners.size(); ++i) {
      if(i + lookahead < corners.size())
        for(const auto soon : {next(corners[i + lookahead], m_tmesh),
                               prev(corners[i + lookahead], m_tmesh)})
          prefetch(m_uv_map, soon);
      if(!is_surely_positive(uv_triangle(m_tmesh, m_uv_map, corners[i]), reach))
        result.push_back(face_index(halfedge(face(corners[i], m_tmesh), m_tmesh)));
    }
    return result;
  }

  std::vector<Face_index> possible_flips() override
  {
    std::vector<Face_index> result;
    for(const auto f : faces(m_tmesh)) {
      const Halfedge h = halfedge(f, m_tmesh);
      if(!is_surely_positive(uv_triangle(m_tmesh, m_uv_map, h), 0))
        result.push_back(face_index(h));
    }
    return result;
  }

  void meet_all_faces() override
  {
    for(const auto f : faces(m_tmesh))
      face_index(halfedge(f, m_tmesh));
  }

  double largest_move(const Uv_state& state) const override
  {
    double result = 0;
    const auto add = [&](const Uv& before, const Uv& after) {
      result = (std::max)(result, Group::norm({after[0] - before[0], after[1] - before[1]}));
    };
    for(std::size_t s = 0; s < number_of_sectors(); ++s)
      add(m_cuts.complex.coordinates[s], state[s]);
    for(const auto& mixed : m_cuts.complex.mixed_sectors)
      for(auto h = m_cuts.corners_begin(mixed.sector); h != m_cuts.corners_end(mixed.sector); ++h)
        add(get_uv(m_uv_map, *h), state[std::size_t(mixed.sector)]);
    return result;
  }

  std::vector<std::size_t> numbers_in_mesh(const std::vector<Face_index>& some) const override
  {
    std::vector<std::size_t> result;
    if(some.empty())
      return result;
    std::vector<bool> is_wanted(number_of_faces(), false);
    for(const Face_index f : some)
      is_wanted[std::size_t(f)] = true;
    std::size_t number = 0;
    for(const auto f : faces(m_tmesh)) {
      const auto found = m_face_of_halfedge.find(halfedge(f, m_tmesh));
      if(found != m_face_of_halfedge.end() && is_wanted[std::size_t(found->second)])
        result.push_back(number);
      ++number;
    }
    return result;
  }

  template <typename F>
  void for_each_corner(const Point_index p, const F& f) const
  {
    if(std::size_t(p) < number_of_sectors()) {
      for(auto h = m_cuts.corners_begin(p); h != m_cuts.corners_end(p); ++h)
        f(*h);
      return;
    }
    // all around, or up to the border on either side: beyond, there may be more corners of the
    // vertex
    const Halfedge first = m_free_corners[std::size_t(p) - number_of_sectors()];
    Halfedge h = first;
    do {
      f(h);
      h = opposite(next(h, m_tmesh), m_tmesh);
    } while(h != first && !is_border(h, m_tmesh));
    if(h == first)
      return;
    for(h = opposite(first, m_tmesh); !is_border(h, m_tmesh); h = opposite(h, m_tmesh)) {
      h = prev(h, m_tmesh);
      f(h);
    }
  }

private:
  Face_index face_index(const Halfedge first)
  {
    const auto found = m_face_of_halfedge.find(first);
    if(found != m_face_of_halfedge.end())
      return found->second;
    const Face_index f = Face_index(m_faces.size());
    m_face_of_halfedge.emplace(first, f);
    Domain_face result{};
    Halfedge h = first;
    for(std::size_t i = 0; i < 3; ++i, h = next(h, m_tmesh)) {
      result.points[i] = point(h);
      result.input[i] = get_uv(m_uv_map, h);
    }
    result.was_positive = orientation(result.input) == CGAL::POSITIVE;
    m_faces.push_back(result);
    return f;
  }

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
    m_free_inputs.push_back(get_uv(m_uv_map, corner));
    for_each_corner(p, [&](const Halfedge h) { m_free_points.emplace(h, p); });
    return p;
  }

  // The sectors' vertices are in the order of the mesh's indices, so that no table is needed.
  Sector_index sector(const Halfedge corner) const
  {
    const auto& first_sector = m_cuts.complex.first_sector;
    if(number_of_sectors() == 0)
      return -1;
    const std::size_t index = vertex_index(corner);
    std::size_t low = 0, high = m_cuts.complex.number_of_vertices();
    while(high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (vertex_index(*m_cuts.corners_begin(first_sector[middle])) <= index ? low : high) = middle;
    }
    for(Sector_index s = first_sector[low]; s != first_sector[low + 1]; ++s)
      if(std::find(m_cuts.corners_begin(s), m_cuts.corners_end(s), corner) != m_cuts.corners_end(s))
        return s;
    return -1;
  }

  std::size_t vertex_index(const Halfedge corner) const
  {
    return std::size_t(get(m_vertex_indices, target(corner, m_tmesh)));
  }

  const TriangleMesh& m_tmesh;
  const Cuts& m_cuts;
  const HalfedgeUVMap& m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  std::unordered_map<Halfedge, Face_index> m_face_of_halfedge;
  std::unordered_map<Halfedge, Point_index> m_free_points;
  std::vector<Halfedge> m_free_corners; // one per point that is not a sector
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MESH_STARS_H
