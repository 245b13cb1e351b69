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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H

#include <CGAL/license/Seamless_snapping.h>

// The few faces whose orientation the moves of sectors can change. A face whose corners all move by
// no more than its height allows needs no second look; what is left is checked exactly, as often as
// it takes.

#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/prefetch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The largest change of a coordinate of a sector's corner.
template <typename Cuts, typename HalfedgeUVMap>
double largest_move(const Cuts& cuts, const HalfedgeUVMap& uv_map, const Uv_state& state)
{
  double result = 0;
  const auto add = [&](const Uv& before, const Uv& after) {
    result = (std::max)({result, std::abs(after[0] - before[0]), std::abs(after[1] - before[1])});
  };
  for(std::size_t s = 0; s < cuts.complex.number_of_sectors(); ++s)
    add(cuts.complex.coordinates[s], state[s]);
  for(const auto& mixed : cuts.complex.mixed_sectors)
    for(auto h = cuts.corners_begin(mixed.sector); h != cuts.corners_end(mixed.sector); ++h)
      add(get_uv(uv_map, *h), state[std::size_t(mixed.sector)]);
  return result;
}

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
  for(const auto f : faces(tmesh)) {
    const Uv_triangle t = uv_triangle(tmesh, uv_map, halfedge(f, tmesh));
    if(!is_surely_positive(t, 0) && orientation(t) != CGAL::POSITIVE)
      return true;
  }
  return false;
}

// Corners of sectors whose face may lose its positive orientation, or has none, when no coordinate
// moves by more than `reach`. Faces with several such corners come several times.
template <typename TriangleMesh, typename Cuts, typename HalfedgeUVMap>
std::vector<typename Cuts::Halfedge>
corners_at_risk(const TriangleMesh& tmesh, const Cuts& cuts, const HalfedgeUVMap& uv_map,
                const double reach)
{
  constexpr std::size_t lookahead = 24; // corners
  std::vector<typename Cuts::Halfedge> result;
  for(std::size_t i = 0; i < cuts.corners.size(); ++i) {
    if(i + lookahead < cuts.corners.size())
      for(const auto soon : {next(cuts.corners[i + lookahead], tmesh),
                             prev(cuts.corners[i + lookahead], tmesh)})
        prefetch(uv_map, soon);
    if(!is_surely_positive(uv_triangle(tmesh, uv_map, cuts.corners[i]), reach))
      result.push_back(cuts.corners[i]);
  }
  return result;
}

// Invariant: contains each face once.
template <typename Points>
class Watched_faces
{
public:
  explicit Watched_faces(Points& points) : m_points(points) { }

  void add(const typename Points::Halfedge corner) { add(m_points.corner(corner).face); }

  void add(const Face_index f)
  {
    if(m_is_known.size() <= std::size_t(f))
      m_is_known.resize(std::size_t(f) + 1, false);
    if(!m_is_known[std::size_t(f)])
      m_faces.push_back(f);
    m_is_known[std::size_t(f)] = true;
  }

  // Those that are not positive, among the faces that were positive in the input, or all others.
  std::vector<Face_index> not_positive(const Uv_state& state, const bool were_positive) const
  {
    std::vector<Face_index> result;
    for(const Face_index f : m_faces)
      if(m_points.domain_face(f).was_positive == were_positive && !m_points.is_positive(state, f))
        result.push_back(f);
    return result;
  }

private:
  Points& m_points;
  std::vector<Face_index> m_faces;
  std::vector<bool> m_is_known; // per face that was met
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H
