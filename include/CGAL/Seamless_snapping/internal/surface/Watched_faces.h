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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WATCHED_FACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WATCHED_FACES_H

#include <CGAL/license/Seamless_snapping.h>

// The few faces whose orientation the moves of sectors can change. A face whose corners all move by no more
// than its height allows needs no second look; what is left is checked exactly, as often as it takes.

#include <CGAL/Seamless_snapping/internal/prefetch.h>
#include <CGAL/Seamless_snapping/internal/surface/Uv_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The largest change of a coordinate of a sector's corner.
template <typename Sectors, typename HalfedgeUVMap>
double largest_move(const Sectors& sectors, const HalfedgeUVMap& uv_map, const Uv_state& state)
{
  double result = 0;
  const auto add = [&](const Uv& before, const Uv& after) {
    result = (std::max)({result, std::abs(after[0] - before[0]), std::abs(after[1] - before[1])});
  };
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector_index s = Sector_index(i);
    if(sectors.sector(s).is_uniform())
      add(sectors.sector(s).uv, state[i]);
    else
      for(auto h = sectors.corners_begin(s); h != sectors.corners_end(s); ++h)
        add(get_uv(uv_map, *h), state[i]);
  }
  return result;
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
Uv_triangle uv_triangle(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const Halfedge corner)
{
  return {{get_uv(uv_map, corner), get_uv(uv_map, next(corner, tmesh)),
           get_uv(uv_map, prev(corner, tmesh))}};
}

// Whether there are faces that are not positive.
template <typename TriangleMesh, typename HalfedgeUVMap>
bool has_flips(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map)
{
  for(const auto f : faces(tmesh)) {
    const Uv_triangle t = uv_triangle(tmesh, uv_map, halfedge(f, tmesh));
    if(!is_surely_positive(t, 0) && orientation(t) != CGAL::POSITIVE)
      return true;
  }
  return false;
}

// Corners of sectors whose face may lose its positive orientation, or has none, when no coordinate moves by
// more than `reach`. Faces with several such corners come several times.
template <typename Sectors, typename HalfedgeUVMap>
auto corners_at_risk(const Sectors& sectors, const HalfedgeUVMap& uv_map, const double reach)
{
  constexpr std::ptrdiff_t lookahead = 24; // corners
  std::vector<typename Sectors::Halfedge> result;
  for(std::size_t i = 0; i < sectors.number_of_sectors(); ++i) {
    const Sector_index s = Sector_index(i);
    for(auto h = sectors.corners_begin(s); h != sectors.corners_end(s); ++h) {
      if(sectors.corners_end() - h > lookahead)
        for(const auto soon : {next(h[lookahead], sectors.mesh()), prev(h[lookahead], sectors.mesh())})
          prefetch(uv_map, soon);
      if(!is_surely_positive(uv_triangle(sectors.mesh(), uv_map, *h), reach))
        result.push_back(*h);
    }
  }
  return result;
}

// Invariant: contains each face once, and knows whether it was positive in the input.
template <typename Points>
class Watched_faces
{
public:
  using Halfedge = typename Points::Halfedge;
  using Face = typename Points::Face;

  struct Watched
  {
    Face face;
    bool was_positive;
  };

  explicit Watched_faces(Points& points) : m_points(points) { }

  void add(const Halfedge corner)
  {
    const auto& tmesh = m_points.mesh();
    const Halfedge h = halfedge(face(corner, tmesh), tmesh); // the same for all corners
    if(!m_known.insert(h).second)
      return;
    const Face f = m_points.face(h);
    m_faces.push_back({f, orientation(m_points.input(f)) == CGAL::POSITIVE});
  }

  template <typename Corners>
  void add_all(const Corners& corners)
  {
    for(const Halfedge h : corners)
      add(h);
  }

  // Those that are not positive, among the faces that were positive in the input, or all others.
  std::vector<Watched> not_positive(const Uv_state& state, const bool were_positive) const
  {
    std::vector<Watched> result;
    for(const Watched& w : m_faces)
      if(w.was_positive == were_positive &&
         orientation(m_points.uv(state, w.face)) != CGAL::POSITIVE)
        result.push_back(w);
    return result;
  }

private:
  Points& m_points;
  std::vector<Watched> m_faces;
  std::unordered_set<Halfedge> m_known;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_WATCHED_FACES_H
