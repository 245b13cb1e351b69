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

// Reads the faces around vertices from a mesh, for repairs of orientations.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Whether there are faces that are not positive.
template <typename Surface>
bool has_flips(const Surface& surface)
{
  for(const auto h : surface.one_per_face())
    if(orientation(uv_triangle(surface, h)) != CGAL::POSITIVE)
      return true;
  return false;
}

template <typename Surface>
bool is_mirrored(const Surface& surface)
{
  std::size_t faces = 0, flipped = 0;
  for(const auto h : surface.one_per_face()) {
    ++faces;
    flipped += orientation(uv_triangle(surface, h)) == CGAL::NEGATIVE ? 1 : 0;
  }
  return mean_mirroring(flipped, faces);
}

// Invariant: the faces that were met are found by their own halfedge, the points that are not
// sectors by their corners.
template <typename Group, typename Surface>
class Mesh_stars : public Point_stars
{
  using Halfedge = typename Surface::Halfedge;
  using Cuts = Surface_cuts<Group, Halfedge>;

public:
  Mesh_stars(const Surface& surface, const Cuts& cuts)
    : Point_stars(cuts.complex.number_of_sectors()), m_surface(surface), m_cuts(cuts)
  { }

  std::vector<Face_corner> star(const Point_index p) override
  {
    std::vector<Halfedge> corners; // meeting faces changes the lists that are walked
    for_each_corner(p, [&](const Halfedge h) { corners.push_back(h); });
    std::vector<Face_corner> result;
    for(const Halfedge h : corners) {
      const Halfedge first = m_surface.first_in_face(h);
      result.push_back({face_index(first), h == first ? 0u : h == m_surface.next(first) ? 1u : 2u});
    }
    return result;
  }

  std::vector<Face_index> faces_at_risk(const double reach) override
  {
    constexpr std::size_t lookahead = 24; // corners
    const std::vector<Halfedge>& corners = m_cuts.corners.elements();
    std::vector<Face_index> result;
    for(std::size_t i = 0; i < corners.size(); ++i) {
      if(i + lookahead < corners.size())
        for(const auto soon : {m_surface.next(corners[i + lookahead]),
                               m_surface.prev(corners[i + lookahead])})
          m_surface.prefetch(soon);
      if(!is_surely_positive(uv_triangle(m_surface, corners[i]), reach))
        result.push_back(face_index(m_surface.first_in_face(corners[i])));
    }
    return result;
  }

  std::vector<Face_index> possible_flips() override
  {
    std::vector<Face_index> result;
    for(const Halfedge h : m_surface.one_per_face())
      if(!is_surely_positive(uv_triangle(m_surface, h), 0))
        result.push_back(face_index(h));
    return result;
  }

  void meet_all_faces() override
  {
    for(const Halfedge h : m_surface.one_per_face())
      face_index(h);
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
      for(const Halfedge h : m_cuts.corners[mixed.sector])
        add(m_surface.uv(h), state[std::size_t(mixed.sector)]);
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
    for(const Halfedge h : m_surface.one_per_face()) {
      const auto found = m_face_of_halfedge.find(h);
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
      for(const Halfedge h : m_cuts.corners[p])
        f(h);
      return;
    }
    // all around, or up to the border on either side: beyond, there may be more corners of the
    // vertex
    const Halfedge first = m_free_corners[std::size_t(p) - number_of_sectors()];
    Halfedge h = first;
    do {
      f(h);
      h = m_surface.opposite(m_surface.next(h));
    } while(h != first && !m_surface.is_border(h));
    if(h == first)
      return;
    for(h = m_surface.opposite(first); !m_surface.is_border(h); h = m_surface.opposite(h)) {
      h = m_surface.prev(h);
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
    for(std::size_t i = 0; i < 3; ++i, h = m_surface.next(h)) {
      result.points[i] = point(h);
      result.input[i] = m_surface.uv(h);
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
    m_free_inputs.push_back(m_surface.uv(corner));
    for_each_corner(p, [&](const Halfedge h) { m_free_points.emplace(h, p); });
    return p;
  }

  // The sectors' vertices are in the order of the mesh's indices, so that no table is needed.
  Sector_index sector(const Halfedge corner) const
  {
    const auto& first_sector = m_cuts.complex.first_sector;
    if(number_of_sectors() == 0)
      return -1;
    const std::size_t index = m_surface.vertex(corner);
    std::size_t low = 0, high = m_cuts.complex.number_of_vertices();
    while(high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      const Halfedge corner_there = m_cuts.corners[first_sector[middle]].front();
      (m_surface.vertex(corner_there) <= index ? low : high) = middle;
    }
    for(Sector_index s = first_sector[low]; s != first_sector[low + 1]; ++s)
      if(const auto corners = m_cuts.corners[s];
         std::find(corners.begin(), corners.end(), corner) != corners.end())
        return s;
    return -1;
  }

  const Surface& m_surface;
  const Cuts& m_cuts;
  std::unordered_map<Halfedge, Face_index> m_face_of_halfedge;
  std::unordered_map<Halfedge, Point_index> m_free_points;
  std::vector<Halfedge> m_free_corners; // one per point that is not a sector
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MESH_STARS_H
