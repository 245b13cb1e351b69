// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SEAMLESS_PARAMETRIZER_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SEAMLESS_PARAMETRIZER_H

#include <CGAL/license/Quad_remeshing.h>

// The whole construction on flat arrays, one line a step.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Parametrization_options.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Positive_solver.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Surface_complex.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/cross_field.h>
#include <CGAL/Quad_remeshing/internal/parametrization/field_with_cones.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Quad_remeshing/internal/parametrization/sizes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

struct Parametrization_result
{
  Coordinates uv;                  // per sector
  std::vector<std::size_t> sector; // per halfedge
  std::vector<int> cone_index;     // per vertex
  std::vector<Corner_index> released; // one halfedge of each edge that is not aligned after all
  std::vector<char> is_cut;           // per halfedge; also border ones
  std::vector<Quarter_turns::Element> rotation; // per halfedge
};

inline void check_options(const Parametrization_options& options, const Triangle_surface& surface)
{
  const auto refuse = [](const Message& reason)
  {
    throw Refusal(Outcome::INVALID_ARGUMENT, reason);
  };
  if(*std::max_element(surface.length.begin(), surface.length.end()) == 0)
    refuse("all points of the mesh coincide");
  if(!(options.target_edge_length > 0) || !std::isfinite(options.target_edge_length))
    refuse(term("target_edge_length") + " must be positive");
  if(options.curvature_alignment != 0 && !(options.curvature_alignment >= 1e-9 &&
                                           std::isfinite(options.curvature_alignment)))
    refuse(term("curvature_alignment") + " must be 0, or at least 1e-9");
  if(!(options.curvature_adaptivity >= 1) || !std::isfinite(options.curvature_adaptivity))
    refuse(term("curvature_adaptivity") + " must be at least 1");
  if(options.largest_cone_index < 1 || options.largest_cone_index >= Quarter_turns::order)
    refuse("largest_cone_index must be 1, 2, or 3");
  if(!(options.least_cone_distance >= 0))
    refuse("least_cone_distance must not be negative");
  if(options.least_cone_distance > 0 && !options.cone_index.empty())
    refuse("least_cone_distance can't be combined with given cones");
  if(options.number_of_stiffening_rounds < 0)
    refuse("number_of_iterations must not be negative");
  const bool is_aligned = std::find(surface.is_aligned.begin(), surface.is_aligned.end(), true)
                          != surface.is_aligned.end();
  if(!options.cone_index.empty() &&
     (is_aligned || options.curvature_alignment > 0 || !options.directions.empty()))
    refuse("given cones can't be combined with alignment or given directions");
}

template <typename Report>
void report_topology(const Triangle_surface& surface, const Topology& topo, Report& report)
{
  report.number_of_faces = surface.number_of_faces();
  report.number_of_components = surface.number_of_components;
  report.number_of_border_loops = topo.number_of_loops;
  for(std::size_t c = 0; c < surface.number_of_components; ++c) {
    const std::ptrdiff_t chi = topo.euler_characteristic[c];
    report.euler_characteristic += chi;
    report.genus += (2 - chi - static_cast<std::ptrdiff_t>(topo.border_loops[c])) / 2;
  }
}

// Writes the extent and the largest difference of the two sides of a cut edge after rotation.
template <typename Report>
void measure(const Triangle_surface& surface, const std::vector<char>& is_cut,
             const std::vector<Quarter_turns::Element>& rotation,
             const Surface_complex& complex, const Coordinates& uv,
             Report& report)
{
  for(std::size_t c = 0; c < 2; ++c) {
    const auto [lowest, highest] = std::minmax_element(
      uv.begin(), uv.end(), [c](const auto& p, const auto& q) { return p[c] < q[c]; });
    report.extent = (std::max)(report.extent, (*highest)[c] - (*lowest)[c]);
  }

  const auto difference = [&](const Corner_index h)
  {
    const auto& p = uv[complex.sector(h)];
    const auto& q = uv[complex.sector(surface.prev(h))];
    return std::array<double, 2>{p[0] - q[0], p[1] - q[1]};
  };
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(!is_cut[h] || !surface.represents_edge(h))
      continue;
    ++report.number_of_cut_edges;
    const auto d = Quarter_turns::apply(rotation[h], difference(h));
    const auto e = difference(surface.opposite(h));
    for(std::size_t c = 0; c < 2; ++c)
      report.violation = (std::max)(report.violation, std::abs(d[c] + e[c]));
  }
}

template <typename Report>
void scale_coordinates(const int exponent, const Number_format& format, Coordinates& uv,
                       Report& report)
{
  constexpr double largest_extent = 1e300; // snap_to_seamless() refuses larger coordinates
  const bool has_extent = report.extent > 0;
  report.extent = std::ldexp(report.extent, exponent);
  report.violation = std::ldexp(report.violation, exponent);
  // No coordinate is larger, because one vertex of each component is at the origin.
  const double extent = rounded_to(format, report.extent);
  if(!(extent <= largest_extent)
     || (has_extent && extent < std::ldexp(1., format.minimum_exponent + format.digits - 1)))
    throw Refusal(Outcome::INVALID_ARGUMENT,
                  "the coordinates leave the range of their number type: " +
                    term("set target_edge_length to about the length of an edge"));
  for(auto& p : uv)
    for(double& x : p)
      x = std::ldexp(x, exponent);
}

// Transitions know indices up to multiples of 4: in a map without flips, the angles around the
// vertices tell. Untangling takes an index of 4, as of a spike, for 0.
inline void update_indices(const Triangle_surface& surface, const Surface_complex& complex,
                           Parametrization_result& result)
{
  if(number_of_flips(surface, complex, result.uv) > 0)
    return;
  std::vector<double> sum(surface.number_of_vertices(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const auto& p = result.uv[complex.sector(h)];
    const auto& q = result.uv[complex.sector(surface.next(h))];
    const auto& r = result.uv[complex.sector(surface.prev(h))];
    const double qx = q[0] - p[0], qy = q[1] - p[1], rx = r[0] - p[0], ry = r[1] - p[1];
    sum[surface.vertex(h)] += std::atan2(qx * ry - qy * rx, qx * rx + qy * ry);
  }
  for(std::size_t v = 0; v < sum.size(); ++v)
    if(!surface.is_border[v])
      result.cone_index[v] = Quarter_turns::order - int(std::lround(sum[v] / quarter_turn));
}

// Coordinates are rounded to `format`. The surface loses the alignment of edges that are released.
template <typename Report>
Parametrization_result parametrize(Triangle_surface& surface,
                                   const Parametrization_options& options,
                                   const Number_format& format, const Make_solver make_solver,
                                   Report& report)
{
  Step_timer timer(report);
  Parametrization_result result;

  if(options.may_release)
    result.released = release_third_edges(surface);
  const Topology topo = topology(surface);
  report_topology(surface, topo, report);
  timer.finish("topology");

  Matching matching;
  std::vector<double> angles, log_size = options.log_size;
  Wanted_field wanted;
  {
    Timed_solver solver(report.seconds_in_solvers, make_solver);
    if(options.curvature_adaptivity > 1)
      adapt_to_curvature(surface, diffused_curvature(surface, solver),
                         options.curvature_adaptivity, log_size);
    if(!log_size.empty())
      turn_by_sizes(surface, log_size);
    wanted = wanted_field(surface, options);
    if(!options.cone_index.empty()) {
      angles = field_with_cones(surface, topo, options.cone_index, matching, solver);
    } else {
      angles = cross_field(surface, wanted, options.random_seed, solver);
      matching = match_crosses(surface, angles);
    }
  }
  double cone_distance = std::ldexp(options.least_cone_distance, -surface.exponent);
  if(!log_size.empty())
    cone_distance *= measure_by_sizes(surface, log_size);
  timer.finish("field");

  Singularities singular = singularities(surface, topo, matching);
  if(options.cone_index.empty()) {
    const bool is_spread =
      spread_large_indices(surface, angles, options.largest_cone_index, options.may_release,
                           singular.index, matching, result.released);
    const bool is_opened = open_collapsed_sectors(surface, angles, options.largest_cone_index,
                                                  singular.index, matching);
    if(straighten_sides_of_narrow_sectors(surface, angles, options.largest_cone_index,
                                          singular.index, matching) || is_opened || is_spread)
      singular = singularities(surface, topo, matching);
  }
  if(options.least_cone_distance > 0) {
    Timed_solver solver(report.seconds_in_solvers, make_solver);
    if(cancel_cones(surface, wanted, cone_distance, singular.index, angles, matching, solver))
      singular = singularities(surface, topo, matching);
  }
  if(options.known_fields && !options.known_fields->insert(matching.turns).second)
    throw Refusal(Outcome::INVALID_ARGUMENT, "the field is known");
  check_index_theorem(surface, topo, matching, singular);
  if(!options.cone_index.empty() && singular.index != options.cone_index)
    throw Refusal(Outcome::INTERNAL_ERROR,
                  "the field does not have the given cones");
  result.cone_index = singular.index;

  Cut_graph graph(surface);
  graph.connect(std::vector<char>(singular.index.begin(), singular.index.end()));
  const std::vector<Quarter_turns::Element> rotation =
    comb(surface, graph.is_cut(), matching, angles);
  matching = Matching(); // frees memory: the system that follows is large
  wanted = Wanted_field();
  surface.bending = std::vector<double>();
  timer.finish("cut graph");

  Positive_solver<Report> solver(surface, graph.is_cut(), rotation, angles, singular.index, options,
                                 make_solver, report);
  solver.run(options.number_of_untangling_iterations);
  result.uv = solver.take();
  update_indices(surface, solver.complex(), result);
  if(!options.cone_index.empty() && result.cone_index != options.cone_index) {
    solver.run(0);
    result.uv = solver.take();
    result.cone_index = options.cone_index;
  }
  report.border_turning =
    std::accumulate(result.cone_index.begin(), result.cone_index.end(),
                    Quarter_turns::order * report.euler_characteristic, std::minus<>());
  result.released.insert(result.released.end(), solver.released().begin(),
                         solver.released().end());
  const Surface_complex& complex = solver.complex();
  report.number_of_cut_branches = complex.complex().number_of_branches();
  int exponent = 0;
  // To the unit length that the caller wants, in two steps: what is to be measured is rounded to
  // the number type of the result, but not scaled by powers of two yet.
  const double unit = std::frexp(options.target_edge_length, &exponent);
  for(auto& p : result.uv)
    for(double& x : p)
      x = rounded_to(format, x / unit);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    result.sector.push_back(complex.sector(h));
    report.number_of_aligned_edges += (surface.is_aligned[h] && surface.represents_edge(h)) ? 1 : 0;
  }
  timer.finish("coordinates");

  report.number_of_flipped_faces = number_of_flips(surface, complex, result.uv);
  measure(surface, graph.is_cut(), rotation, complex, result.uv, report);
  scale_coordinates(surface.exponent - exponent, format, result.uv, report);
  result.is_cut = graph.is_cut();
  result.rotation = rotation;
  timer.finish("measuring");
  return result;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SEAMLESS_PARAMETRIZER_H
