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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SEAMLESS_PARAMETERIZER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SEAMLESS_PARAMETERIZER_H

#include <CGAL/license/Seamless_snapping.h>

// The whole construction on flat arrays, one line a step.

#include <CGAL/Seamless_snapping/Parameterization_report.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Cut_graph.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Matching.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Triangle_surface.h>
#include <CGAL/Seamless_snapping/internal/parameterization/comb.h>
#include <CGAL/Seamless_snapping/internal/parameterization/curvature_field.h>
#include <CGAL/Seamless_snapping/internal/parameterization/field_with_cones.h>
#include <CGAL/Seamless_snapping/internal/parameterization/poisson.h>
#include <CGAL/Seamless_snapping/internal/parameterization/prescribe_alignment.h>
#include <CGAL/Seamless_snapping/internal/parameterization/smoothest_field.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

struct Parameterization_options
{
  double target_edge_length = 1;
  double curvature_alignment = 0;
  long number_of_stiffening_rounds = 5;
  unsigned int random_seed = 0;
  std::vector<int> cone_index; // per vertex; empty: the field decides
};

struct Parameterization_result
{
  Coordinates uv;                  // per sector
  std::vector<std::size_t> sector; // per halfedge
  std::vector<int> cone_index;     // per vertex
};

inline void check_options(const Parameterization_options& options, const Triangle_surface& surface)
{
  const auto refuse = [](const std::string& reason)
  {
    throw Failure{Parameterization_status::INVALID_ARGUMENT, reason};
  };
  if(surface.number_of_faces == 0)
    refuse("the mesh has no face");
  if(!(options.target_edge_length > 0) || !std::isfinite(options.target_edge_length))
    refuse("target_edge_length must be positive");
  if(!(options.curvature_alignment >= 0) || !std::isfinite(options.curvature_alignment))
    refuse("curvature_alignment must not be negative");
  if(options.number_of_stiffening_rounds < 0)
    refuse("number_of_iterations must not be negative");
  const bool is_aligned = std::find(surface.is_aligned.begin(), surface.is_aligned.end(), true)
                          != surface.is_aligned.end();
  if(!options.cone_index.empty() && (is_aligned || options.curvature_alignment > 0))
    refuse("given cones can't be combined with alignment");
}

// Appends the time since the last call to the report.
template <typename Report>
class Step_timer
{
public:
  explicit Step_timer(Report& report) : m_report(report) { m_timer.start(); }

  void end_of(const char* step)
  {
    m_report.step_times.emplace_back(step, m_timer.time());
    m_timer.reset();
  }

private:
  Report& m_report;
  CGAL::Real_timer m_timer;
};

template <typename Report>
void report_topology(const Triangle_surface& surface, const Topology& topo, Report& report)
{
  report.number_of_faces = surface.number_of_faces;
  report.number_of_components = surface.number_of_components;
  report.number_of_border_loops = topo.number_of_loops;
  for(std::size_t c = 0; c < surface.number_of_components; ++c) {
    const std::ptrdiff_t chi = topo.euler_characteristic[c];
    report.euler_characteristic += chi;
    report.genus += (2 - chi - static_cast<std::ptrdiff_t>(topo.border_loops[c])) / 2;
  }
}

// Largest difference of the two sides of a cut edge after rotation, and the extent.
template <typename Report>
void measure(const Triangle_surface& surface, const std::vector<char>& is_cut,
             const std::vector<int>& rotation, const Parameterization_result& result,
             Report& report)
{
  std::array<double, 2> lower{(std::numeric_limits<double>::max)(),
                              (std::numeric_limits<double>::max)()};
  std::array<double, 2> upper{std::numeric_limits<double>::lowest(),
                              std::numeric_limits<double>::lowest()};
  for(const auto& p : result.uv)
    for(std::size_t c = 0; c < 2; ++c) {
      lower[c] = (std::min)(lower[c], p[c]);
      upper[c] = (std::max)(upper[c], p[c]);
    }
  report.extent = (std::max)(upper[0] - lower[0], upper[1] - lower[1]);

  const auto difference = [&](const std::size_t h)
  {
    const auto& p = result.uv[result.sector[h]];
    const auto& q = result.uv[result.sector[surface.prev(h)]];
    return std::array<double, 2>{p[0] - q[0], p[1] - q[1]};
  };
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    if(!is_cut[h] || !surface.represents_edge(h))
      continue;
    ++report.number_of_cut_edges;
    const auto d = difference(h), e = difference(surface.opposite[h]);
    for(int c = 0; c < 2; ++c) {
      const Rotated_coordinate r = rotated_coordinate(c, rotation[h]);
      const double residual = r.sign * d[static_cast<std::size_t>(r.coordinate)]
                              + e[static_cast<std::size_t>(c)];
      report.violation = (std::max)(report.violation, std::abs(residual));
    }
  }
}

// Solves, stiffens and solves again; keeps the solution with the fewest flipped faces.
template <typename Solver, typename Report>
Coordinates solve_with_stiffening(const Triangle_surface& surface,
                                  const std::vector<double>& angles, const Cut_complex& complex,
                                  const long number_of_rounds, Report& report)
{
  const Free_coordinates coordinates(surface, angles, complex);
  const Coordinate_table table(coordinates, complex.number_of_sectors());
  std::vector<double> weights(surface.number_of_faces, 1);
  Coordinates best;
  for(long round = 0; ; ++round) {
    Coordinates uv = solve_poisson<Solver>(surface, angles, complex, coordinates, table, weights,
                                           report.seconds_in_solvers);
    const std::size_t flips = number_of_flips(surface, complex, uv);
    if(round < number_of_rounds && flips > 0)
      stiffen(surface, complex, uv, weights);
    if(round == 0 || flips < report.number_of_flipped_faces) {
      best.swap(uv);
      report.number_of_flipped_faces = flips;
    }
    report.number_of_stiffening_rounds = static_cast<std::size_t>(round);
    if(round == number_of_rounds || flips == 0)
      return best;
  }
}

template <typename Solver, typename Report>
Parameterization_result parameterize(const Triangle_surface& surface,
                                     const Parameterization_options& options, Report& report)
{
  Step_timer<Report> timer(report);
  double& seconds = report.seconds_in_solvers;
  Parameterization_result result;

  const Topology topo = topology(surface);
  report_topology(surface, topo, report);
  timer.end_of("topology");

  Matching matching;
  std::vector<double> angles;
  if(!options.cone_index.empty()) {
    angles = field_with_cones<Solver>(surface, topo, options.cone_index, matching, seconds);
  } else {
    const Prescribed_field prescribed = prescribe_alignment(surface);
    angles = (options.curvature_alignment > 0)
             ? curvature_field<Solver>(surface, prescribed, options.curvature_alignment, seconds)
             : smoothest_field<Solver>(surface, prescribed, options.random_seed, seconds);
    matching = match_crosses(surface, angles);
  }
  timer.end_of("field");

  const Singularities singular = singularities(surface, topo, matching);
  check_index_theorem(surface, topo, matching, singular);
  if(!options.cone_index.empty() && singular.index != options.cone_index)
    throw Failure{Parameterization_status::INTERNAL_ERROR,
                  "the field does not have the given cones"};
  result.cone_index = singular.index;
  for(const std::ptrdiff_t t : singular.loop_turning)
    report.border_turning += t;

  Cut_graph graph(surface);
  graph.connect(std::vector<char>(singular.index.begin(), singular.index.end()));
  comb(surface, graph.is_cut(), angles, matching);
  const Cut_complex complex(surface, graph.is_cut(), matching.rotation);
  report.number_of_cut_branches = complex.number_of_branches();
  timer.end_of("cut graph");

  result.uv = solve_with_stiffening<Solver>(surface, angles, complex,
                                            options.number_of_stiffening_rounds, report);
  for(auto& p : result.uv)
    for(double& x : p)
      x /= options.target_edge_length;
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    result.sector.push_back(complex.sector(h));
    report.number_of_aligned_edges += (surface.is_aligned[h] && surface.represents_edge(h)) ? 1 : 0;
  }
  timer.end_of("coordinates");

  measure(surface, graph.is_cut(), matching.rotation, result, report);
  timer.end_of("measuring");
  return result;
}

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SEAMLESS_PARAMETERIZER_H
