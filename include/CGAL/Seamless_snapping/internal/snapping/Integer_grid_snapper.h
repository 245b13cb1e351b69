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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_SNAPPER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_SNAPPER_H

#include <CGAL/license/Seamless_snapping.h>

// Snapping to integer-grid maps: chooses integers before it solves, and changes the map on the way
// to them, which is a copy.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/singular_vertices.h>
#include <CGAL/Seamless_snapping/internal/snapping/Surface_snapper.h>
#include <CGAL/Seamless_snapping/internal/snapping/explain_refusal.h>
#include <CGAL/Seamless_snapping/internal/snapping/move_charts.h>
#include <CGAL/Seamless_snapping/internal/snapping/spread_rounding.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Below, it is enough to move the vertices of the cuts.
constexpr double negligible_rounding = 1e-4;

// The roundings of cones that untangling makes, one after the other.
constexpr int largest_number_of_roundings = 8;

// Corners at vertices that have to be points of the grid though neither cuts nor levels tell of
// them: inner vertices of 720 degrees or more, around some of which the rotations cancel; and, on
// borders along isocurves, vertices of 360 degrees or more, where the border turns back, or goes
// straight on after more than a half turn.
template <typename Group>
std::vector<Corner_index>
corners_at_grid_points(const Flat_surface& surface,
                       const Aligned_edges<Group, Corner_index>& aligned_edges, const double scale,
                       const int order)
{
  std::vector<Corner_index> result;
  for(const Corner_index first : surface.one_per_vertex())
    if(unfolded_angle<Group>(surface, first, scale, order) > 2 * order - 0.5 &&
       !has_border_at_target(surface, first))
      result.push_back(first);
  for(const auto& edge : aligned_edges.edges())
    if(surface.is_border(surface.opposite(edge.halfedge)) &&
       unfolded_angle<Group>(surface, edge.halfedge, scale, order) > order - 0.5)
      result.push_back(edge.halfedge);
  return result;
}

template <typename Group>
class Integer_grid_snapper : public Surface_snapper<Group, Flat_surface>
{
  using Base = Surface_snapper<Group, Flat_surface>;
  using typename Base::Aligned;
  using typename Base::Cuts;
  using Base::m_flip_repair;
  using Base::m_given;
  using Base::m_options;
  using Base::m_report;
  using Base::m_surface;
  using Base::m_timer;
  // The faces that the displacement turns over, and by how much it changes edges.
  using Cost = std::pair<std::size_t, double>;
  static constexpr Cost infinite_cost{std::size_t(-1), 0};

  struct Choice
  {
    std::vector<Rounding<Group> > roundings;
    Cost cost = infinite_cost;
  };

public:
  using Base::Base;

  Snapping_report run()
  {
    std::optional<Refusal> refusal = m_options.rounds ? snap() : Base::snap();
    if(!refusal && m_options.rounds && m_flip_repair != Flip_repair::NONE)
      refusal = round_new_cones();
    return this->report(refusal);
  }

private:
  std::optional<Refusal> snap()
  {
    Transition_data<Corner_index> transitions;
    Aligned aligned_edges;
    if(auto refusal = this->read(transitions, aligned_edges))
      return refusal;
    if(auto refusal = check_range())
      return refusal;
    if(!m_has_spread) // else the displacement may hide them by folds
      m_grid_points = corners_at_grid_points<Group>(
        m_surface, aligned_edges, unit_scale(transitions.extent), m_given.order());
    Constraint_list<Corner_index> constraints = m_options.constraints;
    constraints.grid_points = m_grid_points;
    Cuts cuts;
    if(auto refusal = this->read(transitions, aligned_edges, constraints, !m_is_rounded, cuts))
      return refusal;
    std::vector<Rounding<Group> > roundings;
    const auto refusal = round_to_integers(cuts, constraints, roundings);
    m_timer.finish("rounding");
    const bool is_far = refusal ||
                        std::any_of(roundings.begin(), roundings.end(), [](const auto& rounding)
                                    { return rounding.distance() > negligible_rounding; });
    if(is_far && !m_has_spread &&
       has_other_charts(transitions, cuts, constraints, refusal.has_value(), roundings))
      return snap();
    if(refusal)
      return refusal;
    if(is_far && !m_has_spread)
      return spread_and_snap(cuts);
    for(const Rounding<Group>& rounding : roundings)
      cuts.complex.equations.push_back(rounding.equation);
    const auto unsolved = this->solve(transitions.is_exact, cuts, roundings);
    return unsolved ? unsolved : this->write();
  }

  // Before the search for integers and repairs that no extraction takes.
  std::optional<Refusal> check_range() const
  {
    for(Corner_index h = 0; h < m_surface.number_of_corners(); ++h) {
      const Uv& u = m_surface.uv(h);
      if((std::max)(std::abs(u[0]), std::abs(u[1])) > largest_grid_coordinate)
        return Refusal(Outcome::NOT_REPRESENTABLE,
                       "a coordinate of " + vertex_name(m_surface, h) +
                         " is too large: beyond 2^46, where units can't be counted safely" +
                         remedy("move or shrink the map"));
    }
    return std::nullopt;
  }

  // If integers are far, charts move to places at which integers may be nearer; and back, if the
  // result there is not better. Returns whether they moved.
  bool has_other_charts(const Transition_data<Corner_index>& transitions, const Cuts& cuts,
                        const Constraint_list<Corner_index>& constraints, const bool is_refused,
                        const std::vector<Rounding<Group> >& roundings)
  {
    if(m_charts == Charts::CHOSEN)
      return false;
    Choice choice;
    if(!is_refused)
      choice = choose_integers(cuts, roundings);
    m_timer.finish("choice of integers");
    if(m_charts == Charts::MOVED) {
      m_charts = Charts::CHOSEN;
      if(choice.cost < m_choice.cost) {
        m_choice = std::move(choice);
        return false;
      }
      m_surface.set_all_uv(m_before);
      return true;
    }
    m_choice = std::move(choice);
    m_charts = Charts::CHOSEN;
    if(m_options.rounding_tolerance == 0 || !constraints.equations.empty())
      return false;
    m_before = m_surface.all_uv();
    if(!Chart_mover<Group>(m_surface, transitions, cuts).run(negligible_rounding))
      return false;
    m_charts = Charts::MOVED;
    return true;
  }

  std::optional<Refusal> spread_and_snap(const Cuts& cuts)
  {
    const double before = m_is_rounded ? m_report.largest_rounding : 0;
    m_is_rounded = m_has_spread = true;
    // for flips that the displacement may have made
    m_flip_repair = (std::max)(m_flip_repair, Flip_repair::NEAR_BY);
    Rounding_spreader<Group> spreader(m_surface, cuts);
    if(!spreader.compute(m_choice.roundings))
      return Refusal(Outcome::INTERNAL_ERROR, "the roundings could not be spread over the "
                     "surface; please report this");
    if(const Rounding<Group>* const worst = farthest(m_choice.roundings, cuts))
      m_report.largest_rounding = (std::max)(before, worst->distance());
    spreader.move();
    m_timer.finish("displacement");
    return snap();
  }

  // The nearest integers, or integers that are chosen one after another: the result with fewer
  // flipped faces and smaller changes of edges.
  Choice choose_integers(const Cuts& cuts, const std::vector<Rounding<Group> >& nearest) const
  {
    Rounding_spreader<Group> spreader(m_surface, cuts);
    std::vector<Rounding<Group> > others = nearest;
    const bool has_others =
      round_one_after_another(cuts.complex, cuts.grid_points, m_surface.format(), spreader,
                              others);
    Choice result{nearest, cost(spreader, nearest)};
    const Rounding<Group>* const worst = farthest(others, cuts);
    if(!has_others || (worst != nullptr && worst->distance() > m_options.rounding_tolerance))
      return result;
    const Cost with_others = cost(spreader, others);
    if(with_others < result.cost)
      result = {std::move(others), with_others};
    return result;
  }

  static Cost cost(Rounding_spreader<Group>& spreader,
                   const std::vector<Rounding<Group> >& roundings)
  {
    return spreader.compute(roundings) ? Cost(spreader.number_of_flips(), spreader.energy())
                                       : infinite_cost;
  }

  // Repairs can turn folds into cones, which are not rounded then. Rounds these, too, and
  // repairs what that folds, until no cone is new; undoes what fails or, where repairs are asked
  // for, costs faces. Where they are not, folds that are left may look like cones. Without folds,
  // cones off the grid are refused.
  std::optional<Refusal> round_new_cones()
  {
    const bool is_asked = m_options.flip_repair != Flip_repair::NONE;
    const auto has_new_cone = [&] {
      return (is_asked || number_of_flips(m_report) == 0) && has_point_off_grid();
    };
    for(int i = 0; i < largest_number_of_roundings && has_new_cone(); ++i) {
      const std::vector<Uv> before = m_surface.all_uv();
      const Snapping_report report = m_report;
      m_is_rounded = true;
      m_has_spread = false;
      m_charts = Charts::AS_GIVEN; // what was chosen before knows nothing of the new cones
      if(!snap() && (!is_asked || number_of_flips(m_report) <= number_of_flips(report))) {
        // flips of the input: later flips came with the displacement
        m_report.run.number_of_repaired_flips = report.run.number_of_repaired_flips;
        continue;
      }
      m_surface.set_all_uv(before);
      m_report = report;
      break;
    }
    if(!has_new_cone())
      return std::nullopt;
    m_report.message = "repairs of flipped faces have made cones that are no points of the grid" +
                       remedy(scale_up);
    if(number_of_flips(m_report) > 0)
      return std::nullopt;
    return Refusal(Outcome::NOT_INTEGER, m_report.message);
  }

  bool has_point_off_grid() const
  {
    const Aligned aligned_edges(m_surface, m_options.edges_to_align,
                                m_options.tolerance * m_report.extent);
    const auto corners = corners_at_grid_points<Group>(
      m_surface, aligned_edges, unit_scale(m_report.extent), m_given.order());
    return std::any_of(corners.begin(), corners.end(), [&](const Corner_index h) {
      const Uv u = m_surface.uv(h);
      return u[0] != std::round(u[0]) || u[1] != std::round(u[1]);
    });
  }

  static std::size_t number_of_flips(const Snapping_report& report)
  { return report.lost_faces.size() + report.remaining_flips.size(); }

  // The integers near by.
  std::optional<Refusal> round_to_integers(const Cuts& cuts,
                                           const Constraint_list<Corner_index>& constraints,
                                           std::vector<Rounding<Group> >& roundings)
  {
    if(auto refusal = Integer_rounding<Group>(cuts.complex, cuts.grid_points)
                        .run(m_surface.format(), roundings)) {
      refusal->message = constraints.empty()
        ? "the integers near by would be too large for the number type" +
            remedy("scale the map down")
        : "the further constraints don't hold for any integers near by" +
            remedy("correct or remove them");
      return refusal;
    }
    const Rounding<Group>* worst = farthest(roundings, cuts);
    if(worst == nullptr || m_is_rounded)
      return std::nullopt;
    m_report.largest_rounding = worst->distance();
    const double tolerance = m_options.rounding_tolerance;
    if(worst->distance() <= tolerance)
      return std::nullopt;
    return Refusal(Outcome::NOT_INTEGER,
                   name_of_rounding(*worst, m_surface, cuts) + " must move by " +
                     short_number(worst->distance()) + " to reach the integer that fits the "
                     "others, but " + term("the rounding_tolerance is") + " " +
                     short_number(tolerance) +
                     remedy("raise rounding_tolerance to at least this distance, or scale the map "
                            "up by grid_scale"));
  }

  // Null if there is none but of points that are free to move.
  const Rounding<Group>* farthest(const std::vector<Rounding<Group> >& roundings,
                                  const Cuts& cuts) const
  {
    const Rounding<Group>* result = nullptr;
    for(const Rounding<Group>& rounding : roundings)
      if(!is_free(rounding, cuts) &&
         (result == nullptr || rounding.distance() > result->distance()))
        result = &rounding;
    return result;
  }

  // Whether it moves a point of the border along it, as that at the end of a slit.
  bool is_free(const Rounding<Group>& rounding, const Cuts& cuts) const
  {
    return rounding.kind == Rounding<Group>::POINT &&
           has_border_at_target(m_surface, cuts.corners[rounding.index].front());
  }

  enum class Charts { AS_GIVEN, MOVED, CHOSEN } m_charts = Charts::AS_GIVEN;
  std::vector<Uv> m_before; // the charts were moved
  Choice m_choice;
  bool m_is_rounded = false; // once, and checked: what comes is no matter of tolerances
  bool m_has_spread = false; // the last roundings
  std::vector<Corner_index> m_grid_points;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_INTEGER_GRID_SNAPPER_H
