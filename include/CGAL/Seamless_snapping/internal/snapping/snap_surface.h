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

// From the arguments of `snap_to_seamless()` to a run, on the mesh itself or on a copy, and its
// report.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/write_all_or_nothing.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/Segments_in_space.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/snapping/Surface_snapper.h>
#include <CGAL/Seamless_snapping/internal/snapping/snap_flat_surface.h>
#include <CGAL/Seamless_snapping/types/File_status.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline Message number_of_faces_in_words(const std::vector<std::size_t>& faces,
                                        const std::string& one, const std::string& many)
{
  return std::to_string(faces.size()) +
         (faces.size() == 1 ? one + " (" : many + " (the first is ") +
         name_of_face(faces.front()) + ")";
}

// Writes into the message which faces are not positive, and into the status, if repairs were asked
// for.
// \param number_of_iterations that the search for repairs may take
inline void tell_of_faces(const Flip_repair repair, const std::size_t number_of_iterations,
                          Snapping_report& report)
{
  const bool is_asked = repair != Flip_repair::NONE;
  const bool has_flips = is_asked && !report.remaining_flips.empty();
  if(!report || (!has_flips && report.lost_faces.empty()))
    return;
  Message note;
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
  else if(is_asked && report.run.number_of_untangling_iterations == number_of_iterations)
    note += remedy("the search for repairs ended at number_of_untangling_iterations: raise it");
  else if(repair == Flip_repair::NEAR_BY && report.message.empty())
    note += remedy("Flip_repair::UNTANGLE changes more of the map");
  report.message += (report.message.empty() ? "" : "; ") + note;
}

// Returns how many border edges have the same two points as another border edge. A mesh that has
// such edges looks as if it was cut open: a seam of the user is a border to every function here.
template <typename TriangleMesh, typename VertexPointMap>
std::size_t number_of_coinciding_border_edges(const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const auto coordinates = [&vpm](const auto v) {
    const Point& p = get(vpm, v);
    return std::array<FT, 3>{p.x(), p.y(), p.z()};
  };

  Segments_in_space<FT> border;
  for(const auto h : halfedges(tmesh))
    if(is_border(h, tmesh))
      border.add(coordinates(source(h, tmesh)), coordinates(target(h, tmesh)), 0);
  std::size_t result = 0;
  border.for_each_coincidence([&result](const auto first, const auto last) {
    result += static_cast<std::size_t>(last - first);
  });
  return result;
}

// A mesh without cuts may have been cut open: then the user's seams are borders here.
template <typename TriangleMesh, typename NamedParameters>
void note_coinciding_border_edges(const TriangleMesh& tmesh, const NamedParameters& np,
                                  Snapping_report& report)
{
  [[maybe_unused]] const auto count = [&](const auto& points) {
    if(const std::size_t number = number_of_coinciding_border_edges(tmesh, points); number > 0)
      report.message = note_on_coinciding_border_edges(number);
  };
  if(!report || report.run.number_of_cut_edges > 0)
    return;
  if constexpr(is_given<NamedParameters, CGAL::internal_np::vertex_point_t>)
    count(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point));
  else if constexpr(CGAL::graph_has_property<TriangleMesh, CGAL::vertex_point_t>::value)
    count(get(CGAL::vertex_point, tmesh));
}

// Relative to the extent of the coordinates.
constexpr double default_connection_tolerance = 0.01;

template <typename Group, typename TriangleMesh, typename NamedParameters>
Snapping_options<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
snapping_options(const TriangleMesh& tmesh, const NamedParameters& np)
{
  return {edges_to_align(tmesh, np),
          read_constraints<Group>(tmesh, np),
          chosen_tolerance(np),
          chosen(np, CGAL::internal_np::connection_tolerance, default_connection_tolerance),
          chosen(np, CGAL::internal_np::rounding_tolerance, default_rounding_tolerance),
          chosen(np, CGAL::internal_np::integer_grid, false),
          chosen_flip_repair(np),
          chosen_number_of_untangling_iterations(np)};
}

template <typename Group, typename NamedParameters>
constexpr bool may_untangle() // others have no free coordinates
{
  using Flip_parameter = std::decay_t<decltype(CGAL::parameters::get_parameter(
    std::declval<const NamedParameters&>(), CGAL::internal_np::repair_flips))>;
  return Group::is_signed_permutation && std::is_same<Flip_parameter, Flip_repair>::value;
}

// \param add_notes to the report, before the coordinates are written
template <typename Group, typename Surface>
Snapping_report snap_in_place(Surface& surface,
                              const Given_transitions<Group, typename Surface::Halfedge>& given,
                              const Snapping_options<typename Surface::Halfedge>& options,
                              const Solve_complex<Group> solve,
                              const std::function<void(Snapping_report&)>& add_notes)
{
  Surface_snapper<Group, Surface> snapper(surface, given, options, solve);
  Snapping_report report = snapper.run();
  add_notes(report);
  if(const auto refusal = snapper.write())
    refuse(report, *refusal);
  return report;
}

// Snaps a copy of the map, which is written back if all succeeds.
// \param index is to take the index of each halfedge
// \param add_notes to a report, before
template <typename Group, typename Surface, typename IndexMap>
Snapping_report snap_copy(Surface& input, const double scale, const IndexMap& index,
                          const Given_transitions<Group, typename Surface::Halfedge>& given,
                          const Snapping_options<typename Surface::Halfedge>& options,
                          const Solve_complex<Group> solve,
                          const std::function<void(Snapping_report&)>& add_notes)
{
  for(const auto& refusal : {check_indices(input), find_bad_face(input)})
    if(refusal)
      return refused<Snapping_report>(*refusal);
  std::vector<typename Surface::Halfedge> originals;
  Flat_surface surface(input, index, originals);
  const std::vector<Uv> before = surface.all_uv();
  Snapping_report report = snap_flat_surface<Group>(
    surface, scale, given.template renumbered<Corner_index>(originals),
    options.renumbered([&](const auto h) { return get(index, h); }), solve);
  if(!report)
    return report;
  add_notes(report);
  using Change = Corner_change<typename Surface::Halfedge, Uv>;
  if(const auto refusal = write_all_or_nothing(
       before.size(), [&](const std::size_t i)
       { return Change{originals[i], before[i], surface.uv(Corner_index(i))}; },
       [&](const auto h) { return input.uv(h); },
       [&](const Change& change, const Uv& to) { input.set_uv(change.corner, to); }))
    refuse(report, *refusal);
  return report;
}

// The named parameters as values: the rest does not know their types.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Snapping_report snap_surface(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                             const NamedParameters& np)
{
  const Solve_complex<Group> solve =
    &solve_complex<Group, may_untangle<Group, NamedParameters>()>;
  auto surface = uv_surface(tmesh, uv_map, np);
  const auto given = given_transitions<Group>(tmesh, np);
  const auto options = snapping_options<Group>(tmesh, np);
  const auto add_notes = [&](Snapping_report& report) {
    note_coinciding_border_edges(tmesh, np, report);
    tell_of_faces(options.flip_repair, options.number_of_untangling_iterations, report);
  };
  if constexpr(is_given<NamedParameters, CGAL::internal_np::integer_grid_t> ||
               is_given<NamedParameters, CGAL::internal_np::grid_scale_t>) {
    return snap_copy(surface, chosen(np, CGAL::internal_np::grid_scale, 1.),
                     get(CGAL::dynamic_halfedge_property_t<Corner_index>(), tmesh), given,
                     options, solve, add_notes);
  } else {
    return snap_in_place(surface, given, options, solve, add_notes);
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SNAP_SURFACE_H
