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

// The smoothest field of crosses, one per face, with and without alignment.

#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parametrization {

// Weight of the edge in the energy of a field: its length over that of the dual edge.
inline double dual_weight(const Triangle_surface& surface, const Corner_index h)
{
  const double areas = surface.area[surface.face(h)]
                       + surface.area[surface.face(surface.opposite(h))];
  return 1.5 * surface.length[h] * surface.length[h] / areas;
}

// The linear systems of field design: with the connection Laplacian L of crosses and the diagonal
// matrix M of the areas, relative to the mean of the component, they read (a M + b L) z = M r,
// where z is kept on the prescribed faces.
template <typename Solver>
class Cross_field_system
{
public:
  Cross_field_system(const Triangle_surface& surface, const Prescribed_field& prescribed,
                     const double mass_factor, const double laplace_factor,
                     Timed_solver<Solver>& solver)
    : m_prescribed(prescribed)
    , m_mass(surface.area)
    , m_unknown(surface.number_of_faces(), none)
    , m_number_of_unknowns(number_unknowns())
    , m_system(2 * m_number_of_unknowns, solver)
    , m_boundary_terms(2 * m_number_of_unknowns, 0)
  {
    const std::vector<double> mean_area = component_means(surface, surface.area);
    for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
      m_mass[f] /= mean_area[surface.component[f]];
      add_block(f, f, mass_factor * m_mass[f]);
    }
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
      if(surface.is_border_edge(h))
        continue;
      const double weight = laplace_factor * dual_weight(surface, h);
      const Flat_face_index f = surface.face(h), g = surface.face(surface.opposite(h));
      add_block(f, f, weight);
      add_block(g, f, -weight * cross_of_angle(surface.transport(h)));
    }
    m_system.factor();
  }

  Prescribed_field solve(const Prescribed_field& right_hand_side)
  {
    std::vector<double> b = m_boundary_terms;
    for(std::size_t f = 0; f < m_unknown.size(); ++f) {
      if(m_unknown[f] == none)
        continue;
      b[2 * m_unknown[f]] += m_mass[f] * right_hand_side[f].real();
      b[2 * m_unknown[f] + 1] += m_mass[f] * right_hand_side[f].imag();
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

  const Prescribed_field& m_prescribed;
  std::vector<double> m_mass; // per face
  std::vector<std::size_t> m_unknown;
  std::size_t m_number_of_unknowns;
  Sparse_system<Solver> m_system;
  std::vector<double> m_boundary_terms;
};

inline void normalize_each(Prescribed_field& field)
{
  for(Complex& z : field)
    z = (std::abs(z) > 0) ? z / std::abs(z) : Complex(1);
}

// Gives each component the norm 1: the eigenvectors of different components grow at different
// rates, and must not push each other out of range.
inline void normalize_components(const Triangle_surface& surface, Prescribed_field& field)
{
  std::vector<double> norm(surface.number_of_components, 0);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    norm[surface.component[f]] += surface.area[f] * std::norm(field[f]);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    const double n = std::sqrt(norm[surface.component[f]]);
    field[f] = (n > 0) ? field[f] / n : Complex(1);
  }
}

// The eigenvector of the smallest eigenvalue by inverse iteration, in components without any
// prescribed face; the harmonic field in the others.
template <typename Solver>
Prescribed_field harmonic_field(const Triangle_surface& surface, const Prescribed_field& prescribed,
                                const unsigned int seed, Timed_solver<Solver>& solver)
{
  const double shift = 1e-3 / static_cast<double>(surface.number_of_faces());
  std::vector<char> has_prescribed(surface.number_of_components, false);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    if(prescribed[f] != Complex(0))
      has_prescribed[surface.component[f]] = true;
  const bool has_eigenvector =
    std::find(has_prescribed.begin(), has_prescribed.end(), false) != has_prescribed.end();
  const int number_of_iterations = has_eigenvector ? 20 : 1;

  CGAL::Random random(seed);
  Prescribed_field field(surface.number_of_faces());
  for(Complex& z : field)
    z = std::polar(1., random.get_double(-pi, pi));

  Cross_field_system<Solver> system(surface, prescribed, shift, 1., solver);
  for(int i = 0; i < number_of_iterations; ++i) {
    for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
      if(has_prescribed[surface.component[f]])
        field[f] = 0;
    field = system.solve(field);
    std::vector<Complex> free_part = field;
    normalize_components(surface, free_part);
    for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
      if(!has_prescribed[surface.component[f]])
        field[f] = free_part[f];
  }
  return field;
}

// Alternates short diffusion with normalization: the harmonic field is smooth where it is long, and
// noisy where it is short; this moves it towards the smoothest field of unit crosses. Diffusion
// over a few edge lengths removes pairs of cones that cancel out.
template <typename Solver>
void smoothen_unit_field(const Triangle_surface& surface, const Prescribed_field& prescribed,
                         Prescribed_field& field, Timed_solver<Solver>& solver)
{
  constexpr int number_of_rounds = 8;
  normalize_each(field);
  for(const double time : {100., 10.}) {
    Cross_field_system<Solver> system(surface, prescribed, 1., time, solver);
    for(int i = 0; i < number_of_rounds; ++i) {
      field = system.solve(field);
      normalize_each(field);
    }
  }
}

// Returns the angle of one direction of the cross of each face, in the layout of the face.
inline std::vector<double> angles_of_field(const Prescribed_field& field)
{
  std::vector<double> angles;
  angles.reserve(field.size());
  for(const Complex& z : field)
    angles.push_back(std::arg(z) / Quarter_turns::order);
  return angles;
}

template <typename Solver>
std::vector<double> smoothest_field(const Triangle_surface& surface,
                                    const Prescribed_field& prescribed,
                                    const unsigned int seed, Timed_solver<Solver>& solver)
{
  Prescribed_field field = harmonic_field(surface, prescribed, seed, solver);
  smoothen_unit_field(surface, prescribed, field, solver);
  return angles_of_field(field);
}

} // namespace parametrization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SMOOTHEST_FIELD_H
