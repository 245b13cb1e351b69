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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SNAPPER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SNAPPER_H

#include <CGAL/license/Seamless_snapping.h>

// The function `snap_to_seamless()`, one line for each step. Later steps know only the results of
// earlier ones.

#include <CGAL/Linear_snapping/internal/exact/Magnitudes.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Linear_snapping/internal/support/write_all_or_nothing.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/complex/row_origins.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_cut_complex.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/orientation/Mesh_stars.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/snapping/explain_refusal.h>
#include <CGAL/Seamless_snapping/internal/snapping/solve_complex.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The corners that change. The new coordinates are kept once for all corners of a point: a corner
// takes little memory, of which new pages are the larger part of the time.
template <typename Halfedge>
struct Surface_changes
{
  struct Corner
  {
    Halfedge corner;
    Sector_index point;
    Uv before;
  };

  Corner_change<Halfedge, Uv> operator()(const std::size_t i) const
  {
    const Corner& c = corners[i];
    return {c.corner, c.before, points[std::size_t(c.point)]};
  }

  std::vector<Uv> points;
  std::vector<Corner> corners;
};

// Collects the corners that change, and measures by how much. `Stars` know the points that repairs
// of orientations have met: the sectors, and then vertices without a sector.
template <typename Group, typename Surface, typename Stars>
class Change_collector
{
  using Halfedge = typename Surface::Halfedge;
  using Cuts = Surface_cuts<Group, Halfedge>;

public:
  // \param uv the exact coordinates, per point
  Change_collector(const Cuts& cuts, const Stars& stars, const Surface& surface,
                   std::vector<Uv> uv)
    : m_cuts(cuts), m_stars(stars), m_surface(surface), m_changes{std::move(uv), {}}
  {
    for(std::size_t i = number_of_sectors(); i < m_changes.points.size(); ++i)
      collect_free_point(Sector_index(i));
    collect_sectors();
  }

  Surface_changes<Halfedge> take() { return std::move(m_changes); }

  // The changes of all Cartesian coordinates. Each sector, and each vertex without one, counts
  // once; corners that differ share its weight.
  const Magnitudes& changes() const { return m_magnitudes; }

private:
  // A zero that stays one keeps its sign.
  static Uv with_signs_of_zeros(Uv uv, const Uv& before)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(uv[c] == 0 && before[c] == 0)
        uv[c] = before[c];
    return uv;
  }

  void measure(const Uv& before, const Uv& after, const double weight)
  {
    for(const double x : Group::to_cartesian({after[0] - before[0], after[1] - before[1]}))
      m_magnitudes.add(x, weight);
  }

  void collect_free_point(const Sector_index p)
  {
    const Uv& after = m_changes.points[std::size_t(p)];
    double count = 0;
    m_stars.for_each_corner(p, [&](const auto) { count += 1; });
    m_stars.for_each_corner(p, [&](const auto corner) {
      const Uv before = m_surface.uv(corner);
      if(before == after)
        return;
      m_changes.corners.push_back({corner, p, before});
      measure(before, after, 1 / count);
    });
  }

  void collect_sectors()
  {
    constexpr std::ptrdiff_t lookahead = 32; // corners
    const std::vector<Halfedge>& corners = m_cuts.corners.elements();
    const Halfedge* const end = corners.data() + corners.size();
    m_changes.corners.reserve(m_changes.corners.size() + corners.size());
    for(std::size_t i = 0; i < number_of_sectors(); ++i) {
      const Sector_index s = Sector_index(i);
      const Uv& before = m_cuts.complex.coordinates[i];
      Uv& after = m_changes.points[i];
      after = with_signs_of_zeros(after, before);
      const bool is_mixed = m_cuts.complex.find_mixed_sector(s) != nullptr;
      if(!is_mixed)
        measure(before, after, 1);
      const double weight = 1. / static_cast<double>(m_cuts.corners[s].size());
      for(const Halfedge& h : m_cuts.corners[s]) {
        if(end - &h > lookahead)
          m_surface.prefetch((&h)[lookahead]);
        m_changes.corners.push_back({h, s, m_surface.uv(h)});
        if(is_mixed)
          measure(m_changes.corners.back().before, after, weight);
      }
    }
  }

  std::size_t number_of_sectors() const { return m_cuts.complex.number_of_sectors(); }

  const Cuts& m_cuts;
  const Stars& m_stars;
  const Surface& m_surface;
  Surface_changes<Halfedge> m_changes;
  Magnitudes m_magnitudes;
};

template <typename Halfedge>
struct Snapping_options
{
  std::vector<Halfedge> edges_to_align; // one halfedge of each
  Constraint_list<Halfedge> constraints;
  double tolerance;
  double connection_tolerance;
  double rounding_tolerance;
  bool rounds; // to an integer-grid map
  Flip_repair flip_repair;
  std::size_t number_of_untangling_iterations;

  // The options with `number(h)` for each halfedge h.
  template <typename Number>
  auto renumbered(const Number& number) const
  {
    std::vector<decltype(number(Halfedge()))> edges;
    for(const Halfedge h : edges_to_align)
      edges.push_back(number(h));
    return Snapping_options<decltype(number(Halfedge()))>{
      std::move(edges), constraints.renumbered(number), tolerance, connection_tolerance,
      rounding_tolerance, rounds, flip_repair, number_of_untangling_iterations};
  }
};

template <typename Group, typename Surface>
class Surface_snapper
{
protected:
  using Halfedge = typename Surface::Halfedge;
  using Given = Given_transitions<Group, Halfedge>;
  using Options = Snapping_options<Halfedge>;
  using Aligned = Aligned_edges<Group, Halfedge>;
  using Cuts = Surface_cuts<Group, Halfedge>;

public:
  Surface_snapper(Surface& surface, const Given& given, const Options& options,
                  const Solve_complex<Group> solve)
    : m_surface(surface)
    , m_given(given)
    , m_options(options)
    , m_solve(solve)
    , m_timer(m_report)
    , m_flip_repair(options.flip_repair)
    , m_iterations(options.number_of_untangling_iterations)
  { }

  // Finds the coordinates.
  Snapping_report run();

  // Writes them, once. That is to be the last step: what throws behind it leaves them written.
  std::optional<Refusal> write()
  {
    const Surface_changes<Halfedge> changes = std::exchange(m_changes, {});
    return write_all_or_nothing(
      changes.corners.size(), changes, [&](const Halfedge h) { return m_surface.uv(h); },
      [&](const auto& change, const Uv& to) { m_surface.set_uv(change.corner, to); });
  }

protected:
  std::optional<Refusal> snap()
  {
    Transition_data<Halfedge> transitions;
    Aligned aligned_edges;
    Cuts cuts;
    if(auto refusal = read(transitions, aligned_edges))
      return refusal;
    if(auto refusal = read(transitions, aligned_edges, m_options.constraints, true, cuts))
      return refusal;
    return solve(transitions.is_exact, cuts, {});
  }

  // Fills in what is read, unless it is refused.
  std::optional<Refusal> read(Transition_data<Halfedge>& transitions, Aligned& aligned_edges)
  {
    if(m_surface.number_of_faces() == 0)
      return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face; was it read?");
    transitions = Transition_reader<Group, Surface>(m_surface, m_given, m_options.tolerance).run();
    fill_in(transitions);
    m_timer.finish("transitions");
    if(transitions.refusal)
      return transitions.refusal;
    aligned_edges = Aligned(m_surface, m_options.edges_to_align,
                            m_options.tolerance * transitions.extent);
    m_report.violation_before = (std::max)(transitions.violation, aligned_edges.violation());
    if(!m_violation_of_input) {
      m_violation_of_input = m_report.violation_before;
      m_extent_of_input = m_report.extent;
    }
    return aligned_edges.refusal() ? aligned_edges.refusal() : m_options.constraints.refusal;
  }

  // \param must_check_paths whether a path that misses is an error
  std::optional<Refusal> read(const Transition_data<Halfedge>& transitions,
                              const Aligned& aligned_edges,
                              const Constraint_list<Halfedge>& constraints,
                              const bool must_check_paths, Cuts& cuts)
  {
    cuts = read_cut_complex(m_surface, transitions, aligned_edges, constraints);
    fill_in(cuts);
    if(must_check_paths)
      if(const auto refusal = check_paths(cuts.complex, constraints,
                                           m_options.connection_tolerance, m_report))
        return refusal;
    m_timer.finish("cut complex");
    return std::nullopt;
  }

  // Solves a complex with these roundings as its last equations.
  std::optional<Refusal> solve(const bool has_exact_transitions, const Cuts& cuts,
                               const std::vector<Rounding<Group> >& roundings)
  {
    const bool is_inside_out = m_options.flip_repair != Flip_repair::NONE && is_mirrored(m_surface);
    if(is_inside_out)
      m_report.message = remedy_for_mirrored_maps;
    const bool was_exact =
      has_exact_transitions && is_exact(cuts.complex, cuts.complex.coordinates);
    if(was_exact && !(m_flip_repair != Flip_repair::NONE && has_flips(m_surface)))
      return std::nullopt;
    m_timer.finish("verification of the input");

    Mesh_stars<Group, Surface> stars(m_surface, cuts);
    Complex_solution solution;
    const Flip_repair repair =
      is_inside_out ? (std::min)(m_flip_repair, Flip_repair::NEAR_BY) : m_flip_repair;
    const Solution_repairs repairs{repair, m_options.rounds, m_iterations};
    if(const auto refusal =
         m_solve(cuts.complex, was_exact, m_surface.format(), stars, repairs, m_report, m_timer,
                 solution))
      return refusal->status == Outcome::INTERNAL_ERROR
               ? refusal
               : explained(*refusal, m_surface, cuts, m_options.constraints, roundings,
                           solution.contradiction);
    if(!solution.coordinates.empty())
      collect_changes(cuts, stars, solution);
    return std::nullopt;
  }

  Snapping_report report(const std::optional<Refusal>& refusal)
  {
    if(refusal) {
      refuse(m_report, *refusal);
      m_report.certificate = refusal->certificate;
    }
    if(m_violation_of_input) { // steps on the way to integers begin at others
      m_report.violation_before = *m_violation_of_input;
      m_report.extent = m_extent_of_input;
    }
    m_report.run.number_of_untangling_iterations =
      m_options.number_of_untangling_iterations - m_iterations;
    m_timer.finish("release of memory");
    return std::move(m_report);
  }

  Surface& m_surface;
  const Given& m_given;
  const Options& m_options;
  const Solve_complex<Group> m_solve;
  Snapping_report m_report;
  Step_timer m_timer;
  Surface_changes<Halfedge> m_changes; // to be written
  Flip_repair m_flip_repair;
  std::size_t m_iterations; // that the search for repairs may still take

private:
  std::optional<double> m_violation_of_input;
  double m_extent_of_input = 0;

  void fill_in(const Transition_data<Halfedge>& transitions)
  {
    m_report.run.number_of_faces = m_surface.number_of_faces();
    m_report.run.number_of_cut_edges = transitions.number_of_cuts;
    m_report.run.number_of_merged_edges = transitions.edges.size() - transitions.number_of_cuts;
    m_report.run.number_of_edges_decided_by_surroundings =
      transitions.number_of_edges_decided_by_surroundings;
    m_report.extent = transitions.extent;
    m_report.violation_before = transitions.violation;
  }

  void fill_in(const Cuts& cuts)
  {
    const Cut_complex<Group>& complex = cuts.complex;
    m_report.run.number_of_singular_vertices = cuts.number_of_singular_vertices;
    m_report.run.number_of_sectors = complex.number_of_sectors();
    m_report.run.number_of_nodes =
      std::size_t(std::count(complex.is_node.begin(), complex.is_node.end(), true));
    m_report.run.number_of_cut_branches = complex.number_of_branches();
    m_report.run.number_of_align_branches = complex.number_of_chains();
  }

  void collect_changes(const Cuts& cuts, const Mesh_stars<Group, Surface>& stars,
                       Complex_solution& solution)
  {
    Change_collector<Group, Surface, Mesh_stars<Group, Surface> > collector(
      cuts, stars, m_surface, std::move(solution.coordinates));
    m_report.largest_change = collector.changes().largest();
    m_report.mean_change = collector.changes().mean();
    m_report.rms_change = collector.changes().root_mean_square();
    // no exact solution can undercut that sum of squares
    m_report.optimal_rms_change =
      solution.optimal_changes.root(collector.changes().sum_of_weights());
    m_report.status = Outcome::SNAPPED;
    m_changes = collector.take();
    m_timer.finish("changes");
  }
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group, typename Surface>
Snapping_report Surface_snapper<Group, Surface>::run()
{
  return report(snap());
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SURFACE_SNAPPER_H
