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
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The smoothest field of crosses, one per node of a graph, with and without alignment.

// The linear systems of field design: with the connection Laplacian L of crosses and the diagonal
// matrix M of the areas, relative to the mean of the component, they read (a M + b L) z = M r,
// where z is kept on the prescribed nodes.
class Cross_field_system
{
public:
  Cross_field_system(const Cross_graph& graph, const Prescribed_field& prescribed,
                     const double mass_factor, const double laplace_factor,
                     Timed_solver& solver)
    : m_graph(graph)
    , m_prescribed(prescribed)
    , m_unknown(graph.size(), none)
    , m_number_of_unknowns(number_unknowns())
    , m_system(2 * m_number_of_unknowns, solver)
    , m_boundary_terms(2 * m_number_of_unknowns, 0)
  {
    for(std::size_t i = 0; i < graph.size(); ++i)
      add_block(i, i, mass_factor * graph.mass[i]);
    for(std::size_t i = 0; i < graph.size(); ++i)
      for(const Cross_graph::Arc& arc : graph.arcs[i]) {
        const double weight = laplace_factor * graph.weight(i, arc);
        add_block(i, i, weight);
        add_block(std::size_t(arc.target), i, -weight * arc.rotation);
      }
    m_system.factor();
  }

  Prescribed_field solve(const Prescribed_field& right_hand_side)
  {
    std::vector<double> b = m_boundary_terms;
    for(std::size_t f = 0; f < m_unknown.size(); ++f) {
      if(m_unknown[f] == none)
        continue;
      b[2 * m_unknown[f]] += m_graph.mass[f] * right_hand_side[f].real();
      b[2 * m_unknown[f] + 1] += m_graph.mass[f] * right_hand_side[f].imag();
    }
    const std::vector<double> x = m_system.solve(b);
    Prescribed_field field = m_prescribed;
    for(std::size_t f = 0; f < m_unknown.size(); ++f)
      if(m_unknown[f] != none)
        field[f] = Complex(x[2 * m_unknown[f]], x[2 * m_unknown[f] + 1]);
    return field;
  }

private:
  std::size_t number_unknowns()
  {
    std::size_t count = 0;
    for(std::size_t f = 0; f < m_unknown.size(); ++f)
      if(m_prescribed[f] == Complex(0))
        m_unknown[f] = count++;
    return count;
  }

  // Multiplication by a complex number is a block of 2 by 2 real ones.
  void add_block(const std::size_t row, const std::size_t column, const Complex& value)
  {
    const std::size_t i = m_unknown[row], j = m_unknown[column];
    if(i == none)
      return;
    if(j == none) {
      const Complex known = value * m_prescribed[column];
      m_boundary_terms[2 * i] -= known.real();
      m_boundary_terms[2 * i + 1] -= known.imag();
      return;
    }
    m_system.add(2 * i, 2 * j, value.real());
    m_system.add(2 * i + 1, 2 * j + 1, value.real());
    if(value.imag() != 0) {
      m_system.add(2 * i, 2 * j + 1, -value.imag());
      m_system.add(2 * i + 1, 2 * j, value.imag());
    }
  }

  const Cross_graph& m_graph;
  const Prescribed_field& m_prescribed;
  std::vector<std::size_t> m_unknown;
  std::size_t m_number_of_unknowns;
  Sparse_system m_system;
  std::vector<double> m_boundary_terms;
};

inline void normalize_each(Prescribed_field& field)
{
  for(Complex& z : field)
    z = unit_cross(z);
}

// Gives each component the norm 1: the eigenvectors of different components grow at different
// rates, and must not push each other out of range.
inline void normalize_components(const Cross_graph& graph, Prescribed_field& field)
{
  std::vector<double> norm(graph.number_of_components, 0);
  for(std::size_t f = 0; f < graph.size(); ++f)
    norm[graph.component[f]] += graph.area[f] * std::norm(field[f]);
  for(std::size_t f = 0; f < graph.size(); ++f) {
    const double n = std::sqrt(norm[graph.component[f]]);
    field[f] = (n > 0) ? field[f] / n : Complex(1);
  }
}

// The eigenvector of the smallest eigenvalue by inverse iteration, in components without any
// prescribed node; the harmonic field in the others, slightly disturbed: if the free part of a
// surface is symmetric around an axis, such as the cap of a capsule, all of its cones would meet in
// one zero of the field. Random right-hand sides give a smooth disturbance, mostly of the fields of
// the smallest eigenvalues. It is about a hundredth as long as the field, whatever the size.
inline Prescribed_field harmonic_field(const Cross_graph& graph, const Prescribed_field& prescribed,
                                       const unsigned int seed, Timed_solver& solver)
{
  constexpr double disturbance = 0.3; // divided by the root of the size
  const double size = static_cast<double>(graph.size());
  const double shift = 1e-3 / size / graph.mean_mass;
  std::vector<char> has_prescribed(graph.number_of_components, false);
  for(std::size_t f = 0; f < graph.size(); ++f)
    if(prescribed[f] != Complex(0))
      has_prescribed[graph.component[f]] = true;
  const bool has_eigenvector =
    std::find(has_prescribed.begin(), has_prescribed.end(), false) != has_prescribed.end();
  const int number_of_iterations = has_eigenvector ? 20 : 1;

  CGAL::Random random(seed);
  Prescribed_field field(graph.size());
  for(Complex& z : field)
    z = std::polar(1., random.get_double(-pi, pi));

  Cross_field_system system(graph, prescribed, shift, 1., solver);
  for(int i = 0; i < number_of_iterations; ++i) {
    for(std::size_t f = 0; f < graph.size(); ++f)
      if(has_prescribed[graph.component[f]])
        field[f] = std::polar(disturbance / std::sqrt(size), random.get_double(-pi, pi));
    field = system.solve(field);
    std::vector<Complex> free_part = field;
    normalize_components(graph, free_part);
    for(std::size_t f = 0; f < graph.size(); ++f)
      if(!has_prescribed[graph.component[f]])
        field[f] = free_part[f];
  }
  return field;
}

// Alternates short diffusion with normalization: the harmonic field is smooth where it is long, and
// noisy where it is short; this moves it towards the smoothest field of unit crosses. Diffusion
// over a few edge lengths removes pairs of cones that cancel out.
inline void smoothen_unit_field(const Cross_graph& graph, const Prescribed_field& prescribed,
                                Prescribed_field& field, Timed_solver& solver)
{
  constexpr int number_of_rounds = 8; // of diffusion for each time step
  normalize_each(field);
  for(const double time : {100., 10.}) {
    Cross_field_system system(graph, prescribed, 1 / graph.mean_mass, time, solver);
    for(int i = 0; i < number_of_rounds; ++i) {
      field = system.solve(field);
      normalize_each(field);
    }
  }
}

inline Prescribed_field smoothest_field(const Cross_graph& graph,
                                        const Prescribed_field& prescribed, const unsigned int seed,
                                        Timed_solver& solver)
{
  Prescribed_field field = harmonic_field(graph, prescribed, seed, solver);
  smoothen_unit_field(graph, prescribed, field, solver);
  return field;
}

// The cross along the principal directions of each face, as long as its anisotropy (the difference
// of the principal curvatures) times the mean edge length, at most 1; or 0 where the surface curves
// alike in all directions, as on spheres: there it would tell of the mesh, not of the surface. A
// face is bent across its edges: as a line field each edge counts with its angle and length
// [Knoeppel et al. 2013, Sec. 4].
inline Prescribed_field principal_crosses(const Triangle_surface& surface)
{
  constexpr double alike = 0.15; // the part of all bending that has one direction
  const std::vector<double> mean_length = component_means(surface, surface.length);
  std::vector<Complex> bending(surface.number_of_faces(), 0);
  std::vector<double> all_bending(surface.number_of_faces(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const double size = surface.bending[h] * surface.length[h];
    bending[surface.face(h)] += size * std::polar(1., 2 * surface.direction[h]);
    all_bending[surface.face(h)] += std::abs(size);
  }

  Prescribed_field crosses(surface.number_of_faces());
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    // A single face is a noisy estimate: its neighbors are taken into account.
    Complex sum = bending[f];
    double area = surface.area[f], all = all_bending[f];
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h) {
      if(surface.is_border_edge(h))
        continue;
      const Corner_index o = surface.opposite(h), g = surface.face(o);
      sum += bending[g] * std::polar(1., 2 * surface.transport(o));
      area += surface.area[g];
      all += all_bending[g];
    }
    if(std::abs(sum) < alike * all)
      sum = 0;
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

inline double root_mean_square(const Cross_graph& graph, const Prescribed_field& field)
{
  double sum = 0, area = 0;
  for(std::size_t f = 0; f < graph.size(); ++f) {
    sum += graph.area[f] * std::norm(field[f]);
    area += graph.area[f];
  }
  return std::sqrt(sum / area);
}

// On faces without wanted crosses, the smoothest field that continues the wanted crosses.
inline Prescribed_field solve_directly(const Cross_graph& graph, const Wanted_field& wanted,
                                       const unsigned int seed, Timed_solver& solver)
{
  Prescribed_field prescribed = wanted.prescribed;
  if(wanted.strength > 0) {
    Prescribed_field crosses = wanted.crosses;
    for(Complex& z : crosses)
      z *= wanted.strength;
    Cross_field_system system(graph, wanted.prescribed, wanted.strength, 1., solver);
    const Prescribed_field field = system.solve(crosses);
    // A short field is near a zero, and has no direction of its own. If faces at the pole of a
    // round end kept it, all cones of the end would stay there.
    constexpr double least_length = 0.4; // as a part of the mean length
    const double least = least_length * root_mean_square(graph, field);
    for(std::size_t f = 0; f < graph.size(); ++f)
      if(crosses[f] != Complex(0) && std::abs(field[f]) >= least)
        prescribed[f] = unit_cross(field[f]);
    if(std::find(prescribed.begin(), prescribed.end(), Complex(0)) == prescribed.end())
      return field;
  }
  return smoothest_field(graph, prescribed, seed, solver);
}

// Gives each node the best cross for its neighbors, in turn: what is smooth over a few
// nodes changes little, what is not becomes smooth. Unit crosses are made such now and then only:
// between, long ones outweigh short ones, which removes pairs of cones that cancel out.
inline void relax(const Cross_graph& graph, const Wanted_field& wanted, Prescribed_field& field)
{
  constexpr int number_of_rounds = 30, rounds_of_linear_field = 10; // of Gauss-Seidel relaxation
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
  constexpr std::size_t largest_direct_size = 50000; // faces; larger surfaces are solved by levels
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
