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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SMOOTHEST_FIELD_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SMOOTHEST_FIELD_H

#include <CGAL/license/Quad_remeshing.h>

// The smoothest field of crosses, one per node of a graph, with and without alignment.

#include <CGAL/Quad_remeshing/internal/parametrization/Cross_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

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
// prescribed node; the harmonic field in the others.
inline Prescribed_field harmonic_field(const Cross_graph& graph, const Prescribed_field& prescribed,
                                       const unsigned int seed, Timed_solver& solver)
{
  const double shift = 1e-3 / static_cast<double>(graph.size()) / graph.mean_mass;
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
        field[f] = 0;
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
  constexpr int number_of_rounds = 8;
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

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SMOOTHEST_FIELD_H
