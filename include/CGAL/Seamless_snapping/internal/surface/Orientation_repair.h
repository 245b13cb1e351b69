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
#include <CGAL/Seamless_snapping/internal/surface/Orientation_program.h>
#include <CGAL/Seamless_snapping/internal/surface/Shifted_solution.h>
#include <CGAL/Seamless_snapping/internal/surface/height_weights.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <unordered_set>
#include <utility>
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
  using Solution = Shifted_solution<TriangleMesh, HalfedgeUVMap>;

  // \param repair_flips whether faces that are not positive in the input are to be repaired too
  Orientation_repair(const Sectors& sectors, const Transition_data<TriangleMesh>& transitions,
                     const Align_edges<TriangleMesh>& align_edges, const HalfedgeUVMap& uv_map,
                     const VertexIndexMap& vertex_indices, const Solution& solution,
                     const bool repair_flips)
    : m_points(sectors, uv_map, vertex_indices), m_uv_map(uv_map), m_solution(solution),
      m_watched(m_points), m_find_move(m_points, transitions, align_edges),
      m_move(m_points, m_find_move, solution.grid()), m_repair_flips(repair_flips)
  { }

  const Points& points() const { return m_points; }

  // Repairs the coordinates of an exact solution, and keeps them exact.
  void run(Uv_state& state, Snapping_report& report)
  {
    const Sectors& sectors = m_points.sectors();
    m_reach = largest_move(sectors, m_uv_map, state);
    report.run.largest_change_before_repair = m_reach;
    watch_within(m_reach);
    if(m_repair_flips)
      watch_flips();
    const std::size_t lost = m_watched.not_positive(state, true).size();
    const std::size_t flipped = flips(state).size();
    if(lost == 0 && flipped == 0)
      return;
    report.run.number_of_lost_faces = lost;
    m_far = (std::max)(far * (std::max)(m_reach, report.violation_before),
                       16 * m_solution.grid().step());
    m_flip_reach = (std::max)(m_far, largest_reach * report.extent);
    m_optimum = {nullptr, state};
    Attempt best{state, {}, {}};
    make_attempts(best, report);
    report.lost_faces = face_indices(best.lost);
    if(m_repair_flips) {
      report.run.number_of_repaired_flips = flipped - best.flips.size();
      report.remaining_flips = face_indices(best.flips);
    }
    state = std::move(best.state);
  }

private:
  using Halfedge = typename Points::Halfedge;
  using Watched = typename Watched_faces<Points>::Watched;
  using Program = Orientation_program<Points, TriangleMesh, HalfedgeUVMap>;

  // Coordinates, the faces that lost their orientation in them, and the flips that remain to be repaired.
  struct Attempt
  {
    Uv_state state;
    std::vector<Watched> lost, flips;
  };

  // The exact solution for targets that are not shifted, and the weights it has, where these aren't all 1.
  struct Optimum
  {
    std::shared_ptr<const Sectors> sectors;
    Uv_state state;
  };

  // First what changes least: moves of single vertices, then, for what they can't repair, the nearest solution
  // that keeps the faces. Weights change the whole solution (in trials, by 40 % where programs add 0.2 % to the
  // root-mean-square change), and come in only where there are too many faces for a program.
  void make_attempts(Attempt& best, Snapping_report& report)
  {
    std::size_t remaining = report.run.number_of_lost_faces;
    const auto count = [&](std::size_t& repaired) {
      repaired += remaining - best.lost.size();
      remaining = best.lost.size();
    };
    best = repaired_by_moves(best.state, m_reach);
    count(report.run.number_of_faces_repaired_by_moves);
    if(m_reach > largest_reach * report.extent)
      return;
    if(remaining > largest_program)
      repair_by_weights(best);
    count(report.run.number_of_faces_repaired_by_weights);
    if(remaining > 0 || !best.flips.empty())
      repair_by_program(best);
    count(report.run.number_of_faces_repaired_by_program);
    if(remaining > 0)
      best = repaired_by_moves(best.state, m_far);
    count(report.run.number_of_faces_repaired_by_moves);
  }

  void watch_flips()
  {
    for(const auto f : faces(m_points.mesh())) {
      const Halfedge h = halfedge(f, m_points.mesh());
      if(!is_surely_positive(uv_triangle(m_points.mesh(), m_uv_map, h), 0))
        m_watched.add(h);
    }
  }

  std::vector<Watched> flips(const Uv_state& state) const
  {
    return m_repair_flips ? m_watched.not_positive(state, false) : std::vector<Watched>();
  }

  // Faces that snapping costs are to be repaired without larger changes than snapping makes; flips of the input
  // can be of any size.
  Attempt repaired_by_moves(const Uv_state& state, const double reach) const
  {
    Attempt result{state, {}, {}};
    result.lost = m_move.repair(m_watched.not_positive(state, true), reach, result.state);
    result.flips = m_move.repair(flips(result.state), std::numeric_limits<double>::infinity(),
                                 result.state);
    for(std::vector<Watched>* faces : {&result.lost, &result.flips}) // moves for others may have saved some
      faces->erase(std::remove_if(faces->begin(), faces->end(), [&](const Watched& w) {
                     return orientation(m_points.uv(result.state, w.face)) == CGAL::POSITIVE;
                   }), faces->end());
    return result;
  }

  // Fewer faces that snapping costs come first; flips of the input are repaired at no face's price.
  static bool is_better(const Attempt& a, const Attempt& b)
  {
    return a.lost.size() < b.lost.size() ||
           (a.flips.size() < b.flips.size() && is_subset(a.lost, b.lost) && is_subset(a.flips, b.flips));
  }

  // Each face has one first corner.
  static std::unordered_set<Halfedge> first_corners(const std::vector<Watched>& faces)
  {
    std::unordered_set<Halfedge> result;
    for(const Watched& w : faces)
      result.insert(w.face.corners[0]);
    return result;
  }

  static bool is_subset(const std::vector<Watched>& a, const std::vector<Watched>& b)
  {
    const std::unordered_set<Halfedge> known = first_corners(b);
    return std::all_of(a.begin(), a.end(),
                       [&](const Watched& w) { return known.count(w.face.corners[0]) != 0; });
  }

  static bool contains(const std::vector<Watched>& faces, const Watched& w)
  {
    return std::any_of(faces.begin(), faces.end(), [&](const Watched& other) {
      return other.face.corners[0] == w.face.corners[0];
    });
  }

  // All faces that sectors can turn over if they move that far.
  void watch_within(const double reach)
  {
    if(reach <= m_watched_reach)
      return;
    m_watched.add_all(corners_at_risk(m_points.sectors(), m_uv_map, reach));
    m_watched_reach = reach;
  }

  // For crowds of faces, whatever their number: solves again, for a target that spares slivers.
  void repair_by_weights(Attempt& best)
  {
    watch_within(m_far);
    const auto weighted = std::make_shared<const Sectors>(m_points.sectors().with_weights(
      height_weights(m_points.sectors(), m_uv_map, m_far)));
    Uv_state state;
    if(!m_solution.solve(*weighted, {}, state) || !is_near(state, m_far))
      return;
    const Attempt attempt = repaired_by_moves(state, m_reach);
    if(!is_better(attempt, best))
      return;
    best = attempt;
    m_optimum = {weighted, state};
  }

  void repair_by_program(Attempt& best)
  {
    watch_within(m_far);
    const Sectors& sectors = m_optimum.sectors ? *m_optimum.sectors : m_points.sectors();
    const Program program(m_points, sectors, m_solution, m_optimum.state);
    for(const double reach : {m_reach, m_far})
      for(const double margin : area_margins)
        if(!best.lost.empty())
          search(program, margin, reach, false, best);
    for(const double margin : area_margins)
      if(!best.flips.empty())
        search(program, margin, m_flip_reach, true, best);
  }

  // Solves with the conditions of the faces that remain, and again with those of faces that this costs, linearized
  // at the previous solution.
  // \param reach the largest change of a coordinate
  void search(const Program& program, const double margin, const double reach, const bool with_flips,
              Attempt& best)
  {
    std::vector<Watched> active = best.lost, given_up;
    if(with_flips)
      active.insert(active.end(), best.flips.begin(), best.flips.end());
    Uv_state at = m_optimum.state, next;
    Eigen::VectorXd forces;
    active.resize((std::min)(active.size(), largest_program));
    for(int idle = 0; idle < 4 && !active.empty() && m_work < largest_work; ++idle) {
      m_work += active.size();
      if(!program.solve(active, margin, at, next, forces))
        return;
      if(!is_near(next, reach)) { // the conditions exclude each other: without the one that asks for most
        Eigen::Index most = 0;
        forces.maxCoeff(&most);
        given_up.push_back(active[std::size_t(most)]);
        active.erase(active.begin() + most);
        --idle;
        continue;
      }
      watch_within(largest_move(m_points.sectors(), m_uv_map, next));
      watch_moved_vertices(next);
      const Attempt attempt = repaired_by_moves(next, m_reach);
      bool has_changed = is_better(attempt, best);
      if(has_changed)
        best = attempt;
      if(best.lost.empty() && (best.flips.empty() || !with_flips))
        return;
      for(const Watched& w : attempt.lost)
        if(active.size() < largest_program && !contains(active, w) && !contains(given_up, w)) {
          active.push_back(w);
          has_changed = true;
        }
      idle = has_changed ? -1 : idle;
      at = next;
    }
  }

  bool is_near(const Uv_state& state, const double reach) const
  {
    bool result = largest_move(m_points.sectors(), m_uv_map, state) <= reach;
    for(std::size_t p = m_points.sectors().number_of_sectors(); p < state.size(); ++p) {
      const Uv before = m_points.uv({}, Point_index(p));
      result = result && std::abs(state[p][0] - before[0]) <= reach &&
               std::abs(state[p][1] - before[1]) <= reach;
    }
    return result;
  }

  void watch_moved_vertices(const Uv_state& state)
  {
    for(std::size_t p = m_points.sectors().number_of_sectors(); p < state.size(); ++p)
      m_points.for_each_corner(Point_index(p), [&](const Halfedge h) { m_watched.add(h); });
  }

  // In the order of iteration over all faces.
  std::vector<std::size_t> face_indices(const std::vector<Watched>& watched) const
  {
    std::vector<std::size_t> result;
    const std::unordered_set<Halfedge> wanted = first_corners(watched);
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

  static constexpr double far = 4; // times the violation or, where that is larger, the optimum's largest change
  // Of the extent. Where constraints ask for larger changes, linearized orientations mean nothing.
  static constexpr double largest_reach = 0.01;
  // Faces of one program, and of all together: what takes some seconds.
  static constexpr std::size_t largest_program = 1000, largest_work = 4000;

  Points m_points;
  const HalfedgeUVMap& m_uv_map;
  const Solution& m_solution;
  Watched_faces<Points> m_watched;
  Vertex_move_finder<Points> m_find_move;
  Kernel_moves<Points, typename Uv_number<HalfedgeUVMap>::type> m_move;
  bool m_repair_flips;
  Optimum m_optimum;
  std::size_t m_work = 0;
  // The largest change; that which repairs may make; that of programs for flips of the input; and
  // that for which all faces are watched.
  double m_reach = 0, m_far = 0, m_flip_reach = 0, m_watched_reach = -1;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_ORIENTATION_REPAIR_H
