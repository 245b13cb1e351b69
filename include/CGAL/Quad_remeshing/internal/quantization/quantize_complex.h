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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_COMPLEX_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_COMPLEX_H

#include <CGAL/license/Quad_remeshing.h>

// The units of a complex: integers near the vectors wanted, such that all triangles are positive
// and the angles around vertices are what they were.

#include <CGAL/Quad_remeshing/internal/quantization/Strip_moves.h>
#include <CGAL/Quad_remeshing/internal/quantization/flip.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline std::vector<int> angles_around_vertices(const Intrinsic_complex& complex)
{
  std::vector<int> result;
  for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    result.push_back(axes_around_vertex(complex, v, &Intrinsic_corner::vector));
  return result;
}

// Half the sum of all determinants.
inline double number_of_quads(const Intrinsic_complex& complex)
{
  double twice_area = 0;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3)
    twice_area += approximate_cross(complex.corner(h).units, complex.corner(h + 1).units);
  return twice_area / 2;
}

// Invariant: once `start` has succeeded, the units are feasible.
class Complex_quantizer
{
public:
  // \pre the complex is compact
  Complex_quantizer(const Integer_mesh& input, Intrinsic_complex& complex,
                    const std::vector<double>& scales)
    : m_input(input), m_complex(complex), m_scales(scales),
      m_angles(angles_around_vertices(complex))
  { }

  // Feasible units, at a larger scale where there are none at the wanted one. At the scale of the
  // input's grid, the vectors themselves are such units.
  void start()
  {
    const Unit_rounder rounder(m_complex, m_scales);
    for(growth = least_growth();; growth *= std::sqrt(2.)) {
      if(rounder.round(m_scales, growth, m_complex) && is_repairable() && repair())
        return;
      if(is_as_fine_as_input()) {
        take_multiples_of_vectors();
        return;
      }
    }
  }

  // Brings the units nearer to the wanted ones; from a larger scale in steps, so that no part of
  // the surface stays behind. One round is enough before the scale changes again.
  void improve()
  {
    for(; growth > 1; growth = (std::max)(1., growth * std::sqrt(std::sqrt(0.5)))) {
      number_of_moves += Strip_moves(m_complex, grown_scales()).improve(1);
      flip_edges();
    }
    move_and_flip();
  }

  // Changes all scales so that there are about so many quads.
  void adjust(const double number)
  {
    for(int i = 0; i < 4; ++i) {
      const double ratio = number / number_of_quads(m_complex);
      if(ratio > 0.95 && ratio < 1.05)
        return;
      for(double& s : m_scales)
        s *= std::sqrt(ratio);
      move_and_flip();
    }
  }

  const std::vector<int>& angles() const { return m_angles; }
  bool is_feasible() const
  { return defect(m_complex, m_angles, &Intrinsic_corner::units).empty(); }

  // Edges of more than twice the length wanted, plus one unit.
  std::size_t number_of_long_edges() const
  {
    std::size_t number = 0;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h) {
      const auto wanted = wanted_units(m_complex, h, m_scales);
      number += m_complex.represents_edge(h) &&
                length(m_complex.corner(h).units) > 2 * std::hypot(wanted[0], wanted[1]) + 1;
    }
    return number;
  }

  double growth = 1;               // of the scale, until there were feasible units
  std::size_t number_of_moves = 0; // along strips

private:
  // Each triangle has at least half a quad.
  double least_growth() const
  {
    double wanted = 0;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); h += 3) {
      const double scale = m_scales[std::size_t(m_complex.part[std::size_t(h / 3)])];
      wanted += scale * scale *
                approximate_cross(m_complex.corner(h).vector, m_complex.corner(h + 1).vector);
    }
    return (std::max)(1., std::sqrt(static_cast<double>(m_complex.number_of_faces()) / wanted));
  }

  bool is_as_fine_as_input() const
  {
    return std::all_of(m_scales.begin(), m_scales.end(),
                       [&](const double s) { return s * growth >= 1; });
  }

  void take_multiples_of_vectors()
  {
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h) {
      Intrinsic_corner& corner = m_complex.corners[std::size_t(h)];
      const double scale = m_scales[std::size_t(m_complex.part[std::size_t(h / 3)])] * growth;
      for(std::size_t c = 0; c < 2; ++c)
        corner.units[c] = checked_product(std::llround(scale), corner.vector[c]);
    }
  }

  std::vector<double> grown_scales() const
  {
    std::vector<double> scales(m_scales);
    for(double& s : scales)
      s *= growth;
    return scales;
  }

  void move_and_flip()
  {
    constexpr std::size_t most_rounds = 20;
    for(int i = 0; i < 3; ++i) {
      const std::size_t moves = Strip_moves(m_complex, grown_scales()).improve(most_rounds);
      number_of_moves += moves;
      if((moves <= few_moves(m_complex) && i > 0) || flip_edges() == 0)
        break;
    }
  }

  // Of many triangles, an eighth is the most that is worth trying.
  bool is_repairable() const
  {
    Flat_face_index number = 0;
    for(Flat_face_index f = 0; f < m_complex.number_of_faces(); ++f)
      number += orientation(m_complex, f, &Intrinsic_corner::units) <= 0;
    return number <= 8 + m_complex.number_of_faces() / 8;
  }

  // Of few triangles that can't be repaired, some can be when others are; many are hopeless.
  bool repair()
  {
    constexpr std::size_t most_failures = 4;
    Strip_moves moves(m_complex, grown_scales());
    std::size_t before = m_complex.corners.size(), number = before - 1; // of triangles left
    while(number > 0 && number < before) {
      before = number;
      number = 0;
      for(Flat_face_index f = 0; f < m_complex.number_of_faces() && number < most_failures; ++f)
        number += orientation(m_complex, f, &Intrinsic_corner::units) <= 0 && !moves.repair(f);
    }
    return number == 0 && is_feasible();
  }

  // Edges whose flip makes the triangles rounder in both sizes together.
  std::size_t flip_edges()
  {
    return flip_all(m_input, m_complex, [&](const Corner_index h) {
      if(!is_flippable(m_complex, h, &Intrinsic_corner::vector) ||
         !is_flippable(m_complex, h, &Intrinsic_corner::units))
        return false;
      const Edge_diamond a(m_complex, h, &Intrinsic_corner::vector);
      const Edge_diamond b(m_complex, h, &Intrinsic_corner::units);
      return a.index_after() + b.index_after() <
             (1 - least_gain_of_flip) * (a.index_before() + b.index_before());
    });
  }

  const Integer_mesh& m_input;
  Intrinsic_complex& m_complex;
  std::vector<double> m_scales; // wanted units per step of the input's grid, per part
  std::vector<int> m_angles;    // around vertices, in quarter turns
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_COMPLEX_H
