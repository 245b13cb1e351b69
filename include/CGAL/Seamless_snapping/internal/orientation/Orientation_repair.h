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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_REPAIR_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_REPAIR_H

#include <CGAL/license/Seamless_snapping.h>

// The step after the exact solution ([MC19] Sec. 5.4): finds the faces that lost their positive
// orientation, exactly, and restores it if an exact solution near by allows this.

#include <CGAL/Seamless_snapping/internal/orientation/Free_point_relaxation.h>
#include <CGAL/Seamless_snapping/internal/orientation/Kernel_moves.h>
#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_program.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// First what changes least: moves of single vertices; then, for what they can't repair, the nearest
// exact solution that keeps the faces.
template <typename Group>
class Orientation_repair
{
public:
  // Changes exact coordinates into others with fewer flips, if it finds them; returns whether.
  // Takes from the number of iterations over all faces that are allowed.
  // \pre all faces were met
  using Untangle = bool (*)(const Movable_points<Group>&, const Complex_solver<Group>&, Uv_state&,
                            std::size_t& iterations, std::size_t& faces_without_area);

  // \param repair_flips whether faces that are not positive in the input are to be repaired too
  // \param iterations the iterations that the search may take; receives the rest
  // \param step the repair of the faces that remain, if there is one
  Orientation_repair(const Cut_complex<Group>& complex, const Complex_solver<Group>& solver,
                     Point_stars& stars, const bool repair_flips, std::size_t& iterations,
                     const Untangle step = nullptr)
    : m_solver(solver), m_stars(stars), m_points(complex, solver, stars),
      m_move(m_points, solver.format()), m_relaxation(m_points, solver.format()),
      m_repair_flips(repair_flips), m_untangle(step), m_iterations(iterations)
  { }

  // Repairs the coordinates of an exact solution, and keeps them exact.
  void run(Uv_state& state, Snapping_report& report);

private:
  using Program = Orientation_program<Group>;

  // Coordinates, the faces that lost their orientation in them, and the flips that remain to be
  // repaired.
  struct Attempt
  {
    Uv_state state;
    std::vector<Face_index> lost, flips;
  };

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
    if(remaining > 0 || !best.flips.empty())
      repair_by_program(best);
    count(report.run.number_of_faces_repaired_by_program);
    if(remaining > 0)
      best = repaired_by_moves(best.state, m_largest_repair);
    count(report.run.number_of_faces_repaired_by_moves);
  }

  // From exact coordinates on.
  void make_all_attempts(Attempt& best, Snapping_report& report)
  {
    report.run.number_of_faces_repaired_by_moves = 0;
    report.run.number_of_faces_repaired_by_program = 0;
    report.run.number_of_faces_repaired_by_untangling = 0;
    make_attempts(best, report);
    if(m_untangle != nullptr && !best.flips.empty())
      untangle(best, report);
  }

  // Flips are repaired at no face's price here, too.
  void untangle(Attempt& best, Snapping_report& report)
  {
    m_stars.meet_all_faces();
    for(std::size_t f = 0; f < m_stars.number_of_faces(); ++f)
      m_watched.add(Face_index(f));
    if(best.state != m_tangled) { // else the search has its result already
      m_tangled = m_untangled = best.state;
      m_untangle(m_points, m_solver, m_untangled, m_iterations,
                 report.run.number_of_faces_without_area);
    }
    if(m_untangled == best.state)
      return;
    const Attempt attempt = repaired_by_moves(m_untangled, m_largest_repair);
    if(attempt.flips.size() >= best.flips.size() || !is_subset(attempt.lost, best.lost))
      return;
    report.run.number_of_faces_repaired_by_untangling = best.lost.size() - attempt.lost.size();
    best = attempt;
  }

  std::vector<Face_index> flips(const Uv_state& state) const
  {
    return m_repair_flips ? m_watched.not_positive(m_points, state, false)
                          : std::vector<Face_index>();
  }

  // Faces that snapping costs are to be repaired without larger changes than snapping makes; flips
  // of the input can be of any size.
  Attempt repaired_by_moves(const Uv_state& state, const double reach) const
  {
    Attempt result{state, {}, {}};
    result.lost =
      m_move.repair(m_watched.not_positive(m_points, state, true), reach, result.state);
    result.flips = m_move.repair(flips(result.state), std::numeric_limits<double>::infinity(),
                                 result.state);
    m_relaxation.repair(result.flips, result.state);
    // others may have saved some
    for(std::vector<Face_index>* faces : {&result.lost, &result.flips})
      faces->erase(std::remove_if(faces->begin(), faces->end(), [&](const Face_index f) {
                     return m_points.is_positive(result.state, f);
                   }), faces->end());
    return result;
  }

  // Fewer faces that snapping costs come first; flips of the input are repaired at no face's price.
  static bool is_better(const Attempt& a, const Attempt& b)
  {
    return a.lost.size() < b.lost.size() ||
           (a.flips.size() < b.flips.size() && is_subset(a.lost, b.lost) &&
            is_subset(a.flips, b.flips));
  }

  static bool is_subset(std::vector<Face_index> a, std::vector<Face_index> b)
  {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return std::includes(b.begin(), b.end(), a.begin(), a.end());
  }

  // All faces that sectors can turn over if they move that far.
  void watch_within(const double reach)
  {
    if(reach <= m_watched_reach)
      return;
    m_watched.add(m_stars.faces_at_risk(reach));
    m_watched_reach = reach;
  }

  void repair_by_program(Attempt& best)
  {
    watch_within(m_largest_repair);
    Program program(m_points, m_solver, m_optimum);
    for(const double reach : {m_reach, m_largest_repair})
      for(const double margin : area_margins)
        if(!best.lost.empty())
          search(program, margin, reach, false, best);
    for(const double margin : area_margins)
      if(!best.flips.empty())
        search(program, margin, m_flip_reach, true, best);
  }

  // Solves with the conditions of the faces that remain, and again with the faces that this costs,
  // linearized at the previous solution.
  // \param reach the largest change of a functional
  void search(Program& program, const double margin, const double reach, const bool with_flips,
              Attempt& best)
  {
    std::vector<Face_index> active = best.lost, given_up;
    if(with_flips)
      active.insert(active.end(), best.flips.begin(), best.flips.end());
    Uv_state at = program.start(), next;
    Eigen::VectorXd forces;
    const bool is_crowd = active.size() > largest_program;
    active.resize((std::min)(active.size(), largest_program));
    for(int idle = 0; idle < 4 && !active.empty() && m_work < largest_work && m_multiplications > 0;
        ++idle) {
      m_work += active.size();
      if(!program.solve(active, margin, at, next, forces, m_multiplications))
        return;
      // conditions exclude each other: drop that which asks for most
      if(!is_near_input(next, reach)) {
        if(is_crowd && margin > 0)
          return; // or ask all for less
        Eigen::Index most = 0;
        forces.maxCoeff(&most);
        given_up.push_back(active[std::size_t(most)]);
        active.erase(active.begin() + most);
        --idle;
        continue;
      }
      watch_within(m_stars.largest_move(next));
      watch_moved_vertices(next);
      const Attempt attempt = repaired_by_moves(next, m_reach);
      bool has_changed = is_better(attempt, best);
      if(has_changed) {
        best = attempt;
        if(is_crowd) { // the next program is for the others
          program.start_from(next);
          return;
        }
      }
      if(best.lost.empty() && (best.flips.empty() || !with_flips))
        return;
      for(const Face_index f : attempt.lost)
        if(active.size() < largest_program && !contains(active, f) && !contains(given_up, f)) {
          active.push_back(f);
          has_changed = true;
        }
      idle = has_changed ? -1 : idle;
      at = next;
    }
  }

  static bool contains(const std::vector<Face_index>& faces, const Face_index f)
  {
    return std::find(faces.begin(), faces.end(), f) != faces.end();
  }

  bool is_near_input(const Uv_state& state, const double reach) const
  {
    bool result = m_stars.largest_move(state) <= reach;
    for(std::size_t p = m_stars.number_of_sectors(); p < state.size(); ++p) {
      const Uv& before = m_stars.free_input(Point_index(p));
      result = result &&
               Group::norm({state[p][0] - before[0], state[p][1] - before[1]}) <= reach;
    }
    return result;
  }

  void watch_moved_vertices(const Uv_state& state)
  {
    for(std::size_t p = m_stars.number_of_sectors(); p < state.size(); ++p)
      for(const Face_corner& corner : m_stars.star(Point_index(p)))
        m_watched.add(corner.face);
  }

  // Repairs may change coordinates by so many times the violation or, where that is larger, the
  // optimum's largest change.
  static constexpr double largest_growth = 4;
  // Relative to the extent. For larger changes, linearized orientations mean nothing.
  static constexpr double largest_reach = 0.01;
  // Faces of one program, and of all together.
  static constexpr std::size_t largest_program = 1000, largest_work = 6000;
  // The multiplications of programs, for each iteration and face. Real maps take up to 100.
  static constexpr double multiplications = 250;
  static constexpr std::size_t least_number_of_faces = 1000;

  const Complex_solver<Group>& m_solver;
  Point_stars& m_stars;
  Movable_points<Group> m_points;
  Watched_faces m_watched;
  Kernel_moves<Group> m_move;
  Free_point_relaxation<Group> m_relaxation;
  bool m_repair_flips;
  Untangle m_untangle;
  std::size_t& m_iterations;
  double m_multiplications = 0; // that programs may still take
  Uv_state m_tangled, m_untangled; // the last step of untangling
  Uv_state m_optimum; // the exact solution for targets that are not shifted
  std::size_t m_work = 0;
  // The largest changes: before, of repairs, and of programs for flips of the input; and the change
  // up to which all faces are watched.
  double m_reach = 0, m_largest_repair = 0, m_flip_reach = 0, m_watched_reach = -1;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group>
void Orientation_repair<Group>::run(Uv_state& state, Snapping_report& report)
{
  m_reach = m_stars.largest_move(state);
  report.run.largest_change_before_repair = m_reach;
  watch_within(m_reach);
  if(m_repair_flips)
    m_watched.add(m_stars.possible_flips());
  const std::size_t lost = m_watched.not_positive(m_points, state, true).size();
  const std::size_t flipped = flips(state).size();
  if(lost == 0 && flipped == 0)
    return;
  report.run.number_of_lost_faces = lost;
  m_largest_repair = (std::max)(largest_growth * (std::max)(m_reach, report.violation_before),
                                16 * m_solver.coarsest_step());
  m_flip_reach = (std::max)(m_largest_repair, largest_reach * report.extent);
  m_optimum = state;
  m_multiplications = multiplications * static_cast<double>(m_iterations) *
    static_cast<double>((std::max)(least_number_of_faces, report.run.number_of_faces));
  Attempt best{state, {}, {}};
  make_all_attempts(best, report);
  if(!best.flips.empty()) {
    Snapping_report other_report = report;
    Attempt other{state, {}, {}};
    m_move.allow_other_cones();
    m_work = 0;
    make_all_attempts(other, other_report);
    if(other.flips.size() < best.flips.size() && is_subset(other.lost, best.lost)) {
      best = std::move(other);
      report = std::move(other_report);
    }
  }
  report.lost_faces = m_stars.numbers_in_mesh(best.lost);
  if(m_repair_flips) {
    report.run.number_of_repaired_flips = flipped - best.flips.size();
    report.remaining_flips = m_stars.numbers_in_mesh(best.flips);
    report.run.number_of_changed_cones +=
      Vertex_angles<Group>(m_points).number_of_changed_vertices(best.state, m_watched.faces());
  }
  state = std::move(best.state);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_ORIENTATION_REPAIR_H
