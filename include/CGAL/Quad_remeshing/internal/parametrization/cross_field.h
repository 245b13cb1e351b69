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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_FIELD_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_FIELD_H

#include <CGAL/license/Quad_remeshing.h>

// The field of crosses of a surface, one per face: the smoothest one, or one that follows the
// curvature where this is clear. On large surfaces it comes from a coarser graph, and is smoothed
// on each finer one, in linear time.

#include <CGAL/Quad_remeshing/internal/parametrization/Cross_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Parametrization_options.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Quad_remeshing/internal/parametrization/smoothest_field.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The cross along the principal directions of each face, as long as its anisotropy (the difference
// of the principal curvatures) times the mean edge length, at most 1. A face is bent across its
// edges: as a line field each edge counts with its angle and length [Knoeppel et al. 2013, Sec. 4].
inline Prescribed_field principal_crosses(const Triangle_surface& surface)
{
  const std::vector<double> mean_length = component_means(surface, surface.length);
  std::vector<Complex> bending(surface.number_of_faces(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    bending[surface.face(h)] += surface.bending[h] * surface.length[h]
                                * std::polar(1., 2 * surface.direction[h]);

  Prescribed_field crosses(surface.number_of_faces());
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    // A single face is a noisy estimate: its neighbors are taken into account.
    Complex sum = bending[f];
    double area = surface.area[f];
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h) {
      if(surface.is_border_edge(h))
        continue;
      const Corner_index o = surface.opposite(h), g = surface.face(o);
      sum += bending[g] * std::polar(1., 2 * surface.transport(o));
      area += surface.area[g];
    }
    const double anisotropy = std::abs(sum) / area * mean_length[surface.component[f]];
    crosses[f] = (anisotropy > 0) ? std::polar((std::min)(anisotropy, 1.), 2 * std::arg(sum)) : 0;
  }
  return crosses;
}

// A field is wanted that minimizes its energy plus `strength` times the squared distance from given
// crosses per mean face, where some crosses are prescribed; with a strength of 0, of unit crosses.
struct Wanted_field
{
  Prescribed_field prescribed, crosses;
  double strength;
};

inline Wanted_field wanted_field(const Triangle_surface& surface,
                                 const Parametrization_options& options)
{
  const double strength = options.curvature_alignment;
  return {prescribe_alignment(surface, options.directions),
          strength > 0 ? principal_crosses(surface) : Prescribed_field(surface.number_of_faces()),
          strength};
}

inline Wanted_field restrict(const Clusters& clusters, const Cross_graph& graph,
                             const Wanted_field& wanted)
{
  Wanted_field result{clusters.restrict(graph, wanted.prescribed),
                      clusters.restrict(graph, wanted.crosses), wanted.strength};
  for(Complex& z : result.prescribed)
    if(z != Complex(0))
      z = unit_cross(z);
  return result;
}

inline Prescribed_field solve_directly(const Cross_graph& graph, const Wanted_field& wanted,
                                       const unsigned int seed, Timed_solver& solver)
{
  if(wanted.strength == 0)
    return smoothest_field(graph, wanted.prescribed, seed, solver);
  Prescribed_field crosses = wanted.crosses;
  for(Complex& z : crosses)
    z *= wanted.strength;
  Cross_field_system system(graph, wanted.prescribed, wanted.strength, 1., solver);
  return system.solve(crosses);
}

// Gives each node the best cross for those of its neighbors, in turn: what is smooth over a few
// nodes changes little, what is not becomes smooth. Unit crosses are made such now and then only:
// between, long ones outweigh short ones, which removes pairs of cones that cancel out.
inline void relax(const Cross_graph& graph, const Wanted_field& wanted, Prescribed_field& field)
{
  constexpr int number_of_rounds = 30, rounds_of_linear_field = 10;
  for(int round = 1; round <= number_of_rounds; ++round)
    for(std::size_t n = 0; n < graph.size(); ++n) {
      const std::size_t i = round % 2 == 0 ? n : graph.size() - 1 - n;
      field[i] = wanted.prescribed[i];
      if(field[i] != Complex(0))
        continue;
      double weights = wanted.strength * graph.mass[i];
      Complex sum = weights * wanted.crosses[i];
      for(const Cross_graph::Arc& arc : graph.arcs[i]) {
        const double weight = graph.weight(i, arc);
        weights += weight;
        sum += weight * std::conj(arc.rotation) * field[arc.target];
      }
      if(wanted.strength == 0 && round % rounds_of_linear_field == 0)
        field[i] = unit_cross(sum);
      else if(weights > 0) // it has neighbors
        field[i] = sum / weights;
    }
}

inline Prescribed_field solve_by_levels(const Cross_graph& graph, const Wanted_field& wanted,
                                        const unsigned int seed, Timed_solver& solver)
{
  constexpr std::size_t largest_direct_size = 50000;
  if(graph.size() <= largest_direct_size)
    return solve_directly(graph, wanted, seed, solver);
  const Clusters clusters(graph);
  if(clusters.size() > graph.size() / 2) // many small components
    return solve_directly(graph, wanted, seed, solver);
  Prescribed_field field = clusters.prolong(
    solve_by_levels(clusters.coarse_graph(graph), restrict(clusters, graph, wanted), seed, solver));
  relax(graph, wanted, field);
  return field;
}

// Returns the angle of one direction of the cross of each face, in the layout of the face.
inline std::vector<double> cross_field(const Triangle_surface& surface, const Wanted_field& wanted,
                                       const unsigned int seed, Timed_solver& solver)
{
  std::vector<double> angles;
  angles.reserve(surface.number_of_faces());
  for(const Complex& z : solve_by_levels(cross_graph(surface), wanted, seed, solver))
    angles.push_back(std::arg(z) / Quarter_turns::order);
  return angles;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_FIELD_H
