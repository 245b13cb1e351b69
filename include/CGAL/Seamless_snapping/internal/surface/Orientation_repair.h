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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_REPAIR_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_REPAIR_H

#include <CGAL/license/Seamless_snapping.h>

// The step after the exact solution (Sec. 5.4): finds the faces that lost their positive orientation, exactly,
// and gives it back to them where an exact solution near by has it.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/surface/Kernel_moves.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Orientation_repair
{
public:
  using Points = Uv_points<TriangleMesh, HalfedgeUVMap, VertexIndexMap>;
  using Sectors = typename Points::Sectors;
  using Halfedge = typename Points::Halfedge;

  // \param repair_flips whether faces that are not positive in the input are to be repaired too
  Orientation_repair(const Sectors& sectors, const Transition_data<TriangleMesh>& transitions,
                     const Align_edges<TriangleMesh>& align_edges, const HalfedgeUVMap& uv_map,
                     const VertexIndexMap& vertex_indices, const Grid& grid, const bool repair_flips)
    : m_points(sectors, uv_map, vertex_indices), m_uv_map(uv_map), m_watched(m_points),
      m_find_move(m_points, transitions, align_edges), m_move(m_points, m_find_move, grid),
      m_repair_flips(repair_flips)
  { }

  const Points& points() const { return m_points; }

  // Repairs the coordinates of an exact solution, and keeps them exact.
  void run(Uv_state& state, Snapping_report& report)
  {
    const Sectors& sectors = m_points.sectors();
    m_watched.add_all(corners_at_risk(sectors, m_uv_map, largest_move(sectors, m_uv_map, state)));
    if(m_repair_flips)
      for(const auto f : faces(m_points.mesh())) {
        const Halfedge h = halfedge(f, m_points.mesh());
        if(!is_surely_positive(uv_triangle(m_points.mesh(), m_uv_map, h), 0))
          m_watched.add(h);
      }
    std::vector<Watched> lost = m_watched.not_positive(state, true);
    report.number_of_lost_faces = lost.size();
    lost = m_move.repair(lost, state);
    report.number_of_faces_repaired_by_moves = report.number_of_lost_faces - lost.size();
    report.lost_faces = face_indices(lost);
    if(m_repair_flips) {
      std::vector<Watched> flips = m_watched.not_positive(state, false);
      const std::size_t before = flips.size();
      flips = m_move.repair(flips, state);
      report.number_of_repaired_flips = before - flips.size();
      report.remaining_flips = face_indices(flips);
    }
  }

private:
  using Watched = typename Watched_faces<Points>::Watched;

  // In the order of iteration over all faces.
  std::vector<std::size_t> face_indices(const std::vector<Watched>& watched) const
  {
    std::vector<std::size_t> result;
    std::unordered_set<Halfedge> wanted;
    for(const Watched& w : watched)
      wanted.insert(w.face.corners[0]);
    if(wanted.empty())
      return result;
    std::size_t index = 0;
    for(const auto f : faces(m_points.mesh())) {
      if(wanted.count(halfedge(f, m_points.mesh())) != 0)
        result.push_back(index);
      ++index;
    }
    return result;
  }

  Points m_points;
  const HalfedgeUVMap& m_uv_map;
  Watched_faces<Points> m_watched;
  Vertex_move_finder<Points> m_find_move;
  Kernel_moves<Points, typename Uv_number<HalfedgeUVMap>::type> m_move;
  bool m_repair_flips;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_REPAIR_H
