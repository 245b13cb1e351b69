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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// The function `snap_to_seamless()`, a step a line: what each step returns is all that the next
// ones know of it.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/mesh/coinciding_border_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_cut_complex.h>
#include <CGAL/Seamless_snapping/internal/orientation/Flip_untangler.h>
#include <CGAL/Seamless_snapping/internal/orientation/Mesh_stars.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>
#include <CGAL/Seamless_snapping/internal/snapping/Snapping_options.h>
#include <CGAL/Seamless_snapping/internal/snapping/check_paths.h>
#include <CGAL/Seamless_snapping/internal/snapping/explain_refusal.h>
#include <CGAL/Seamless_snapping/internal/snapping/integer_grid_rows.h>
#include <CGAL/Seamless_snapping/internal/snapping/move_charts.h>
#include <CGAL/Seamless_snapping/internal/snapping/round_one_after_another.h>
#include <CGAL/Seamless_snapping/internal/snapping/spread_rounding.h>
#include <CGAL/Seamless_snapping/internal/snapping/write_coordinates.h>
#include <CGAL/Seamless_snapping/types/File_status.h>
#include <CGAL/Seamless_snapping/types/Flip_repair.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/snapping/surface_solvers.h>
#endif

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Below, it is enough to move the vertices of the cuts.
constexpr double negligible_rounding = 1e-4;

// Of cones that untangling makes, one after the other.
constexpr int largest_number_of_roundings = 8;

// \tparam may_round whether rounding to an integer-grid map is compiled
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap,
          bool may_round, bool may_untangle>
class Surface_snapper
{
  using Given = Given_transitions<Group, TriangleMesh>;
  using Options = Snapping_options<TriangleMesh>;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Cuts = Surface_cuts<Group, TriangleMesh>;
  using Stars = Mesh_stars<Group, TriangleMesh, HalfedgeUVMap, VertexIndexMap>;
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  // The faces that the displacement turns over, and by how much it changes edges.
  using Cost = std::pair<std::size_t, double>;
  static constexpr Cost infinite_cost{std::size_t(-1), 0};

  struct Choice
  {
    std::vector<Rounding<Group> > roundings;
    Cost cost = infinite_cost;
  };

  using Corners = std::vector<std::pair<Halfedge, Point> >;
  using Spreader = Rounding_spreader<Group, TriangleMesh, HalfedgeUVMap, VertexIndexMap>;

public:
  Surface_snapper(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                  const VertexIndexMap& vertex_indices, const Given& given, const Options& options)
    : m_tmesh(tmesh)
    , m_uv_map(uv_map)
    , m_vertex_indices(vertex_indices)
    , m_given(given)
    , m_options(options)
    , m_timer(m_report, options.is_verbose)
    , m_flip_repair(options.flip_repair)
    , m_iterations(options.number_of_untangling_iterations)
  { }

  Snapping_report run();

private:
  std::optional<Refusal> snap()
  {
    if(faces(m_tmesh).size() == 0)
      return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face; was it read?");
    const auto transitions =
      read_transitions<Group>(m_tmesh, m_uv_map, m_vertex_indices, m_options.has_given_indices,
                              m_given, m_options.tolerance);
    fill_in(transitions);
    m_timer.finish("transitions");
    if(transitions.refusal)
      return transitions.refusal;
    if constexpr(may_round)
      if(m_options.rounds)
        if(const auto refusal = check_range())
          return refusal;

    const auto aligned_edges =
      read_aligned_edges<Group>(m_tmesh, m_uv_map, m_vertex_indices, m_options.edges_to_align,
                                m_options.tolerance * transitions.extent);
    m_report.violation_before = (std::max)(transitions.violation, aligned_edges.violation());
    Constraint_list<TriangleMesh> constraints = m_options.constraints;
    if(aligned_edges.refusal() || constraints.refusal())
      return aligned_edges.refusal() ? aligned_edges.refusal() : constraints.refusal();

    if constexpr(may_round)
      if(m_options.rounds) {
        if(!m_has_spread) // else the displacement may hide them by folds
          m_grid_points = corners_at_grid_points<Group>(m_tmesh, m_uv_map, aligned_edges,
                                                        unit_scale(transitions.extent));
        constraints.add_grid_points(m_grid_points);
      }
    Cuts cuts = read_cut_complex(m_tmesh, m_uv_map, m_vertex_indices, transitions, aligned_edges,
                                 constraints);
    fill_in(cuts);
    if(!m_is_rounded)
      if(const auto refusal = check_paths(cuts.complex, constraints,
                                           m_options.connection_tolerance, m_report))
        return refusal;
    m_timer.finish("cut complex");
    std::vector<Rounding<Group> > roundings;
    if constexpr(may_round)
      if(m_options.rounds) {
        const auto refusal = round_to_integers(cuts, constraints, roundings);
        m_timer.finish("rounding");
        const bool is_far = refusal || largest_distance(roundings) > negligible_rounding;
        if(is_far && !m_has_spread &&
           has_other_charts(transitions, cuts, constraints, refusal.has_value(), roundings))
          return snap();
        if(refusal)
          return refusal;
        if(is_far && !m_has_spread)
          return spread_and_snap(cuts);
        for(const Rounding<Group>& rounding : roundings)
          cuts.complex.equations.push_back(rounding.equation);
      }

    const bool was_exact = transitions.is_exact && is_exact(cuts.complex, cuts.complex.coordinates);
    if(was_exact && !(m_flip_repair != Flip_repair::NONE && has_flips(m_tmesh, m_uv_map)))
      return std::nullopt;
    m_timer.finish("verification of the input");

    Complex_solver<Group> solver(
      cuts.complex, Number_format::of<typename Uv_number<HalfedgeUVMap>::type>());
    m_report.linear_solver = solver.linear_solver().figures();
    m_timer.finish("elimination");
    Snapped_coordinates<Group> snapped{cuts.complex.coordinates, {}, solver.coarsest_step(), -1};
    if(!was_exact)
      if(const auto refusal = solver.solve(snapped))
        return explained(*refusal, cuts, constraints, roundings, solver.system(), m_tmesh,
                         m_vertex_indices);
    m_timer.finish("solution");

    Stars stars(m_tmesh, cuts, m_uv_map, m_vertex_indices);
    // cones of integer-grid maps become vertices of quads
    constexpr Untangling how = may_round ? Untangling::ANGLES_FIRST : Untangling::NEAR_BY_FIRST;
    typename Orientation_repair<Group>::Untangle untangle = nullptr;
    if constexpr(may_untangle)
      if(m_flip_repair == Flip_repair::UNTANGLE)
        untangle = &untangle_flips<Group, how>;
    Orientation_repair<Group>(cuts.complex, solver, stars, m_flip_repair != Flip_repair::NONE,
                              m_iterations, untangle)
      .run(snapped.coordinates, m_report);
    m_timer.finish("orientation");
    if(was_exact && m_report.run.number_of_repaired_flips == 0)
      return std::nullopt; // nothing moves

    if(!is_exact(cuts.complex, snapped.coordinates))
      return Refusal(Outcome::INTERNAL_ERROR,
                     "the result failed its exact verification and "
                     "was discarded; please report this");
    m_timer.finish("verification");
    return write(cuts, stars, snapped);
  }

  // Before the search for integers and repairs that no extraction takes.
  std::optional<Refusal> check_range() const
  {
    for(const auto h : halfedges(m_tmesh)) {
      if(is_border(h, m_tmesh))
        continue;
      const Uv u = get_uv(m_uv_map, h);
      if((std::max)(std::abs(u[0]), std::abs(u[1])) > largest_grid_coordinate)
        return Refusal(Outcome::NOT_REPRESENTABLE,
                       "a coordinate of vertex " +
                         std::to_string(get(m_vertex_indices, target(h, m_tmesh))) +
                         " is too large: beyond 2^46, where units can't be counted safely; move or "
                         "shrink the map");
    }
    return std::nullopt;
  }

  // Where integers are far, charts are moved to where they may be nearer; and back, if what can be
  // chosen there is not better. Returns whether they were moved.
  bool has_other_charts(const Transition_data<TriangleMesh>& transitions, const Cuts& cuts,
                        const Constraint_list<TriangleMesh>& constraints, const bool is_refused,
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
      restore(m_before);
      return true;
    }
    m_choice = std::move(choice);
    m_charts = Charts::CHOSEN;
    if(m_options.rounding_tolerance == 0 || !constraints.corner_constraints().empty())
      return false;
    m_before = all_coordinates();
    if(!Chart_mover<Group, TriangleMesh, HalfedgeUVMap>(m_tmesh, m_uv_map, transitions, cuts)
         .run(negligible_rounding))
      return false;
    m_charts = Charts::MOVED;
    return true;
  }

  Corners all_coordinates() const
  {
    Corners result;
    for(const auto h : halfedges(m_tmesh))
      if(!is_border(h, m_tmesh))
        result.emplace_back(h, get(m_uv_map, h));
    return result;
  }

  void restore(const Corners& corners)
  {
    for(const auto& [h, point] : corners)
      put(m_uv_map, h, point);
  }

  // The uv map is a copy then, which can be changed before anything is known to succeed.
  std::optional<Refusal> spread_and_snap(const Cuts& cuts)
  {
    m_is_rounded = m_has_spread = true;
    // those that the displacement may have made
    m_flip_repair = (std::max)(m_flip_repair, Flip_repair::NEAR_BY);
    Spreader spreader(m_tmesh, m_uv_map, m_vertex_indices, cuts);
    if(!spreader.compute(m_choice.roundings))
      return Refusal(Outcome::INTERNAL_ERROR, "the roundings could not be spread over the "
                     "surface; please report this");
    if(const Rounding<Group>* const worst = farthest(m_choice.roundings, cuts))
      m_report.largest_rounding = worst->distance();
    spreader.move();
    m_timer.finish("displacement");
    return snap();
  }

  // The nearest integers, or those that are chosen one after another: whichever turn over fewer
  // faces and change edges less.
  Choice choose_integers(const Cuts& cuts, const std::vector<Rounding<Group> >& nearest) const
  {
    Spreader spreader(m_tmesh, m_uv_map, m_vertex_indices, cuts);
    std::vector<Rounding<Group> > others = nearest;
    const bool has_others =
      round_one_after_another(cuts.complex, cuts.grid_points, format(), spreader, others);
    Choice result{nearest, cost(spreader, nearest)};
    const Rounding<Group>* const worst = farthest(others, cuts);
    if(!has_others || (worst != nullptr && worst->distance() > m_options.rounding_tolerance))
      return result;
    const Cost with_others = cost(spreader, others);
    if(with_others < result.cost)
      result = {std::move(others), with_others};
    return result;
  }

  static Cost cost(Spreader& spreader, const std::vector<Rounding<Group> >& roundings)
  {
    return spreader.compute(roundings) ? Cost(spreader.number_of_flips(), spreader.energy())
                                       : infinite_cost;
  }

  // Untangling can turn folds into cones, which are not rounded then. Rounds these, too, and
  // untangles what that folds, until no cone is new; undoes what fails.
  void round_new_cones()
  {
    for(int i = 0; i < largest_number_of_roundings && has_point_off_grid(); ++i) {
      const Corners before = all_coordinates();
      const Snapping_report report = m_report;
      m_is_rounded = true;
      m_has_spread = false;
      if(!snap() && number_of_flips(m_report) <= number_of_flips(report)) {
        // flips of the input: those since then came with the displacement
        m_report.run.number_of_repaired_flips = report.run.number_of_repaired_flips;
        continue;
      }
      restore(before);
      m_report = report;
      return;
    }
  }

  bool has_point_off_grid() const
  {
    const auto aligned_edges =
      read_aligned_edges<Group>(m_tmesh, m_uv_map, m_vertex_indices, m_options.edges_to_align,
                                m_options.tolerance * m_report.extent);
    const auto corners = corners_at_grid_points<Group>(m_tmesh, m_uv_map, aligned_edges,
                                                       unit_scale(m_report.extent));
    return std::any_of(corners.begin(), corners.end(), [&](const Halfedge h) {
      const Uv u = get_uv(m_uv_map, h);
      return u[0] != std::round(u[0]) || u[1] != std::round(u[1]);
    });
  }

  static std::size_t number_of_flips(const Snapping_report& report)
  { return report.lost_faces.size() + report.remaining_flips.size(); }

  static double largest_distance(const std::vector<Rounding<Group> >& roundings)
  {
    double result = 0;
    for(const Rounding<Group>& rounding : roundings)
      result = (std::max)(result, rounding.distance());
    return result;
  }

  // The integers near by.
  std::optional<Refusal> round_to_integers(const Cuts& cuts,
                                           const Constraint_list<TriangleMesh>& constraints,
                                           std::vector<Rounding<Group> >& roundings)
  {
    if(auto refusal =
         Integer_rounding<Group>(cuts.complex, cuts.grid_points).run(format(), roundings)) {
      refusal->message = constraints.empty()
        ? "the integers near by would be too large for the number type; scale the map down"
        : "the further constraints don't hold for any integers near by; correct or remove them";
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
                   name_of_rounding(*worst, cuts, m_tmesh, m_vertex_indices) + " is " +
                     short_number(worst->distance()) + " off the integer that it is rounded to, "
                     "more than the rounding_tolerance of " + short_number(tolerance) +
                     "; raise it, or scale the map up by grid_scale");
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

  static Number_format format()
  { return Number_format::of<typename Uv_number<HalfedgeUVMap>::type>(); }

  // Whether it moves a point of the border along it, as that at the end of a slit.
  bool is_free(const Rounding<Group>& rounding, const Cuts& cuts) const
  {
    return rounding.kind == Rounding<Group>::POINT &&
           CGAL::is_border(target(*cuts.corners_begin(Sector_index(rounding.index)), m_tmesh),
                           m_tmesh).has_value();
  }

  // A mesh without cuts may have been cut open: then the user's seams are borders here.
  void note_coinciding_border_edges()
  {
    if constexpr(CGAL::graph_has_property<TriangleMesh, CGAL::vertex_point_t>::value) {
      const std::size_t number = number_of_coinciding_border_edges(
        m_tmesh, get(CGAL::vertex_point, m_tmesh));
      if(number > 0)
        m_report.message = note_on_coinciding_border_edges(number);
    }
  }

  void fill_in(const Transition_data<TriangleMesh>& transitions)
  {
    m_report.run.number_of_faces = faces(m_tmesh).size(); // num_faces() counts removed ones too
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

  std::optional<Refusal> write(const Cuts& cuts, const Stars& stars,
                               const Snapped_coordinates<Group>& snapped)
  {
    Corner_changes figures;
    Coordinate_writer<Group, TriangleMesh, HalfedgeUVMap, Stars> writer(cuts, stars, m_uv_map);
    if(!writer.write(snapped.coordinates, figures))
      return Refusal(Outcome::INTERNAL_ERROR, "the uv map does not keep what is written to "
                     "it, so that what it had was written back; each corner needs a place of its "
                     "own, and the full precision of the points' number type");
    figures.fill_in(m_report, snapped.optimal_changes);
    m_report.grid_step = snapped.unit;
    m_report.status = Outcome::SNAPPED;
    m_timer.finish("writing");
    return std::nullopt;
  }

  const TriangleMesh& m_tmesh;
  HalfedgeUVMap m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  const Given& m_given;
  const Options& m_options;
  Snapping_report m_report;
  Step_timer m_timer;
  Flip_repair m_flip_repair;
  std::size_t m_iterations; // that the search for repairs may still take
  enum class Charts { AS_GIVEN, MOVED, CHOSEN } m_charts = Charts::AS_GIVEN;
  Corners m_before; // the charts were moved
  Choice m_choice;
  bool m_is_rounded = false; // once, and checked: what comes is no matter of tolerances
  bool m_has_spread = false; // the last roundings
  std::vector<Halfedge> m_grid_points;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap,
          bool may_round, bool may_untangle>
Snapping_report
Surface_snapper<Group, TriangleMesh, HalfedgeUVMap, VertexIndexMap, may_round, may_untangle>::run()
{
  std::optional<Refusal> refusal = snap();
  if constexpr(may_round && may_untangle)
    if(!refusal && m_options.rounds && m_flip_repair == Flip_repair::UNTANGLE)
      round_new_cones();
  if(refusal) {
    refuse(m_report, *refusal);
    m_report.certificate = std::move(refusal->certificate);
  }
  m_report.run.number_of_untangling_iterations =
    m_options.number_of_untangling_iterations - m_iterations;
  m_timer.finish("release of memory");
  if(m_report && m_report.run.number_of_cut_edges == 0)
    note_coinciding_border_edges();
  m_timer.finish("notes");
  return std::move(m_report);
}

// Changes and orientations against the input times a number, where there were steps between.
// Returns the area of the result in the domain.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename ScaledMap>
double compare_with_input(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                        const ScaledMap& result, const double scale, Snapping_report& report)
{
  report.largest_change = 0;
  report.lost_faces.clear();
  report.remaining_flips.clear();
  double area = 0;
  std::size_t index = 0;
  for(const auto f : faces(tmesh)) {
    Uv_triangle before, after;
    std::size_t k = 0;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      const Uv u = get_uv(uv_map, h), v = get_uv(result, h);
      before[k] = u;
      after[k++] = v;
      for(const double change : Group::to_cartesian({v[0] - scale * u[0], v[1] - scale * u[1]}))
        report.largest_change = (std::max)(report.largest_change, std::abs(change));
    }
    area += ((after[1][0] - after[0][0]) * (after[2][1] - after[0][1]) -
             (after[1][1] - after[0][1]) * (after[2][0] - after[0][0])) / 2;
    if(orientation(after) != CGAL::POSITIVE)
      (orientation(before) == CGAL::POSITIVE ? report.lost_faces : report.remaining_flips)
        .push_back(index);
    ++index;
  }
  return area;
}

inline std::string number_of_faces_in_words(const std::vector<std::size_t>& faces,
                                            const std::string& one, const std::string& many)
{
  return std::to_string(faces.size()) + (faces.size() == 1 ? one : many) + " (" +
         (faces.size() == 1 ? "" : "the first is ") + "number " + std::to_string(faces.front()) +
         ", counted from 0)";
}

// What became of the orientations, in words; and in the status, where repairs were asked for.
inline void tell_of_faces(const Flip_repair repair, const std::size_t iterations,
                          Snapping_report& report)
{
  const bool is_asked = repair != Flip_repair::NONE;
  const bool has_flips = is_asked && !report.remaining_flips.empty();
  if(!report || (!has_flips && report.lost_faces.empty()))
    return;
  std::string note;
  if(has_flips)
    note = number_of_faces_in_words(report.remaining_flips, " face is still flipped or degenerate",
                                    " faces are still flipped or degenerate");
  if(!report.lost_faces.empty())
    note += (has_flips ? ", and " : "") +
            number_of_faces_in_words(report.lost_faces, " face that was positive no longer is",
                                     " faces that were positive no longer are");
  if(is_asked)
    report.status = Outcome::FLIPS_REMAIN;
  if(const std::size_t n = report.run.number_of_faces_without_area; n > 0)
    note += "; seams and alignments leave " + std::to_string(n) +
            " of them no area, whatever the coordinates are: correct the seams, or align less";
  else if(is_asked && report.run.number_of_untangling_iterations == iterations)
    note += "; the search for repairs ended at number_of_untangling_iterations: raise it";
  else if(repair == Flip_repair::NEAR_BY)
    note += "; Flip_repair::UNTANGLE changes more of the map";
  report.message += (report.message.empty() ? "" : "; ") + note;
}

// The named parameters as values: the rest does not know their types.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Snapping_report snap_surface(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                             const NamedParameters& np)
{
  constexpr bool may_round = is_given<NamedParameters, CGAL::internal_np::integer_grid_t>;
  using Flip_parameter = std::decay_t<decltype(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::repair_flips))>;
  constexpr bool may_untangle = // others have no free coordinates
    Group::is_signed_permutation && std::is_same<Flip_parameter, Flip_repair>::value;
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const Given_transitions<Group, TriangleMesh> given(tmesh, np);
  const auto options = snapping_options<Group>(tmesh, np);
  return Surface_snapper<Group, TriangleMesh, HalfedgeUVMap, std::decay_t<decltype(vertex_indices)>,
                         may_round, may_untangle>(
           tmesh, uv_map, vertex_indices, given, options).run();
}

// The same for the map times a number: into a copy, which is written back if all succeeds.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Snapping_report snap_scaled(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                            const NamedParameters& np, const double scale)
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = typename Uv_number<HalfedgeUVMap>::type;
  if(!(scale > 0 && std::isfinite(scale)))
    return refused<Snapping_report>(
      Report(Outcome::INVALID_ARGUMENT, "grid_scale must be positive and finite"));
  auto scaled = get(CGAL::dynamic_halfedge_property_t<Point>(), tmesh);
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh)) {
      const Uv u = get_uv(uv_map, h);
      put(scaled, h, Point(Number(scale * u[0]), Number(scale * u[1])));
    }
  Snapping_report report = snap_surface<Group>(tmesh, scaled, np);
  if(!report)
    return report;
  const double area = compare_with_input<Group>(tmesh, uv_map, scaled, scale, report);
  // nothing but flips makes it less than half a cell, and faces between no integers
  if(area < 0.25 && !report.lost_faces.empty()) {
    refuse(report, Outcome::NOT_INTEGER,
           "at the nearest integers, the map covers no cell; scale the map up by grid_scale");
    return report;
  }
  report.status = Outcome::SNAPPED;
  for(const auto h : halfedges(tmesh))
    if(!is_border(h, tmesh))
      put(uv_map, h, get(scaled, h));
  return report;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_SURFACE_H
