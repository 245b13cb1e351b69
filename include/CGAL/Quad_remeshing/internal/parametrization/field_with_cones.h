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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H

#include <CGAL/license/Quad_remeshing.h>

// A field with cones where the caller wants them: the trivial connection of [Crane, Desbrun,
// Schroeder 2010] with handles rounded to quarter turns.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Cross_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Matching.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/round_holonomy.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// A closed component has a field with the given indices if and only if they add up to 4 chi; with a
// border, the border turns by what is missing. The angle of a cone is 4 - index quarter turns.
inline void check_prescribed_indices(const Triangle_surface& surface, const Topology& topo,
                                     const std::vector<int>& index)
{
  std::vector<std::ptrdiff_t> sum(surface.number_of_components, 0);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    if(index[v] >= Quarter_turns::order)
      throw Refusal(Outcome::INVALID_CONES,
                    surface.describe_vertex(v) + " is to have the index "
                    + std::to_string(index[v]) + ": from 4 on, no angle is left for its faces");
    sum[surface.component_of_vertex(v)] += index[v];
  }
  for(std::size_t c = 0; c < surface.number_of_components; ++c) {
    const std::ptrdiff_t expected = Quarter_turns::order * topo.euler_characteristic[c];
    if(topo.border_loops[c] == 0 && sum[c] != expected)
      throw Refusal(Outcome::INVALID_CONES,
                    "the indices of the cones of component " + std::to_string(c) + " add up to "
                    + std::to_string(sum[c]) + "; on this closed surface it must be "
                    + std::to_string(expected));
  }
}

// The smallest deviation across each halfedge that has the given indices around the vertices: the
// gradient of a vertex function, which is 0 on the border.
template <typename Solver>
std::vector<double> deviation_of_cones(const Triangle_surface& surface,
                                       const std::vector<int>& index, Timed_solver<Solver>& solver)
{
  std::vector<std::size_t> unknown(surface.number_of_vertices(), none);
  std::vector<char> has_border(surface.number_of_components, false);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(surface.is_border[v])
      has_border[surface.component_of_vertex(v)] = true;
  std::size_t count = 0;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const std::size_t c = surface.component_of_vertex(v);
    if(!has_border[c])
      has_border[c] = true; // one value of a closed component is arbitrary: also 0
    else if(!surface.is_border[v])
      unknown[v] = count++;
  }

  const auto weight = [&](const Corner_index h) { return 1 / dual_weight(surface, h); };
  Sparse_system<Solver> system(count, solver);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t i = unknown[surface.vertex(h)], j = unknown[surface.source(h)];
    if(surface.is_border_edge(h) || i == none)
      continue;
    system.add(i, i, weight(h));
    if(j != none)
      system.add(i, j, -weight(h));
  }
  system.factor();

  const std::vector<double> defect = angle_defects(surface);
  std::vector<double> b(count, 0);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    if(unknown[v] != none)
      b[unknown[v]] = defect[v] - index[v] * quarter_turn;
  const std::vector<double> x = system.solve(b);

  std::vector<double> deviation(surface.number_of_halfedges(), 0);
  const auto potential = [&](std::size_t v) { return unknown[v] == none ? 0 : x[unknown[v]]; };
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!surface.is_border_edge(h))
      deviation[h] = weight(h) * (potential(surface.vertex(h)) - potential(surface.source(h)));
  return deviation;
}

// The smoothest field with the given rotations: turns each cross that is not fixed such that the
// squared deviations become smallest, plus the squared angles to the nearest directions of given
// crosses, with their lengths as weights.
template <typename Solver>
void smoothen_matched_field(const Triangle_surface& surface, const std::vector<char>& is_fixed,
                            const Prescribed_field& wanted, std::vector<double>& angles,
                            Matching& matching, Timed_solver<Solver>& solver)
{
  Sparse_system<Solver> system(surface.number_of_faces(), solver);
  std::vector<double> b(surface.number_of_faces(), 0);
  std::vector<char> has_anchor(surface.number_of_components, false);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    if(is_fixed[f]) {
      has_anchor[surface.component[f]] = true;
      system.add(f, f, 1);
    } else if(wanted[f] != Complex(0)) {
      has_anchor[surface.component[f]] = true;
      const double weight = std::abs(wanted[f]);
      system.add(f, f, weight);
      b[f] += weight * std::arg(wanted[f] * std::conj(cross_of_angle(angles[f])))
              / Quarter_turns::order;
    }
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Flat_face_index f = surface.face(h);
    if(!has_anchor[surface.component[f]])
      system.add(f, f, 1);
    has_anchor[surface.component[f]] = true;
    if(surface.is_border_edge(h) || is_fixed[f])
      continue;
    const double weight = dual_weight(surface, h);
    system.add(f, f, weight);
    if(!is_fixed[surface.face(surface.opposite(h))])
      system.add(f, surface.face(surface.opposite(h)), -weight);
    b[f] -= weight * matching.deviation[h];
  }
  system.factor();
  const std::vector<double> turn = system.solve(b);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    angles[f] += turn[f];
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!surface.is_border_edge(h))
      matching.deviation[h] += turn[surface.face(h)] - turn[surface.face(surface.opposite(h))];
}

template <typename Solver>
std::vector<double> field_with_cones(const Triangle_surface& surface, const Topology& topo,
                                     const std::vector<int>& index, Matching& matching,
                                     Timed_solver<Solver>& solver)
{
  check_prescribed_indices(surface, topo, index);
  const std::vector<double> deviation = deviation_of_cones(surface, index, solver);
  Integrated_field field = integrate_connection(surface, deviation);
  matching = match_along_connection(surface, deviation, field);
  const std::size_t size = std::size_t(surface.number_of_faces());
  smoothen_matched_field(surface, std::vector<char>(size, false), Prescribed_field(size),
                         field.angles, matching, solver);
  return field.angles;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_FIELD_WITH_CONES_H
