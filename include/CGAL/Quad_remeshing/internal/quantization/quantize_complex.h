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

// The units of a complex: integers near the wanted vectors, such that all triangles are positive
// and the angles around vertices stay the same.

#include <CGAL/Quad_remeshing/internal/quantization/Polygon_filler.h>
#include <CGAL/Quad_remeshing/internal/quantization/Strip_moves.h>
#include <CGAL/Quad_remeshing/internal/quantization/round_units.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
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

// So many that a search over all of them takes long.
inline bool has_many_faces(const Intrinsic_complex& complex)
{ return complex.number_of_faces() >= 500; }

// Half the sum of all determinants.
inline double number_of_quads(const Intrinsic_complex& complex)
{
  double twice_area = 0;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3)
    twice_area += approximate_cross(complex.corner(h).units, complex.corner(h + 1).units);
  return twice_area / 2;
}

// The wanted number of quads, from the wanted units per step of the input's grid, for each part.
inline double number_of_quads_wanted(const Intrinsic_complex& complex,
                                     const std::vector<double>& scales)
{
  double twice_area = 0;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3) {
    const double scale = scales[std::size_t(complex.part[std::size_t(h / 3)])];
    twice_area += scale * scale *
                  approximate_cross(complex.corner(h).vector, complex.corner(h + 1).vector);
  }
  return twice_area / 2;
}

// Invariant: once the units are feasible, they stay so.
class Complex_quantizer
{
public:
  // \param work where none is left, as little is spent as leads to feasible units
  // \pre the complex is compact
  Complex_quantizer(const Integer_mesh& input, Intrinsic_complex& complex,
                    const std::vector<double>& scales, Work& work)
    : m_input(input), m_complex(complex), m_scales(scales), m_work(work),
      m_angles(angles_around_vertices(complex))
  { }

  // Rounds what is wanted to units, and repairs them. Returns whether they are feasible.
  bool round()
  {
    return has_room() && Unit_rounder(m_complex, m_scales).round() &&
           is_repairable() && repair();
  }

  // Whether the vectors of the input, times integers, can be the units.
  bool is_as_fine_as_input() const
  {
    return std::all_of(m_scales.begin(), m_scales.end(), [](const double s) { return s >= 1; });
  }

  void take_multiples_of_vectors()
  {
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h) {
      Intrinsic_corner& corner = m_complex.corners[std::size_t(h)];
      const double scale = m_scales[std::size_t(m_complex.part[std::size_t(h / 3)])];
      for(std::size_t c = 0; c < 2; ++c)
        corner.units[c] = checked_product(std::llround(scale), corner.vector[c]);
    }
  }

  // Brings the units nearer to the wanted ones, in one round: enough before the scale changes
  // again. Returns the number of moves.
  std::size_t approach()
  {
    const std::size_t moves = Strip_moves(m_complex, m_scales, m_work).improve(1);
    flip_edges();
    return moves;
  }

  // Makes rounds until few moves are left: searches over many faces take long. Flat triangles stop
  // strips: after two searches, edges are flipped such that triangles get less flat, and after each
  // such that they get rounder.
  std::size_t improve(const Cost_of_units cost = Cost_of_units::LENGTHS)
  {
    const std::size_t most_rounds =
      (std::max)(std::size_t(3), (std::min)(std::size_t(20), 80000 / m_complex.corners.size()));
    std::size_t sum = 0;
    for(int i = 0; i < 5 && (i == 0 || m_work.is_left()); ++i) {
      const bool is_after_two = i == 2 || i == 4;
      if(is_after_two && make_less_flat(m_input, m_complex) == 0)
        break;
      const std::size_t moves = Strip_moves(m_complex, m_scales, m_work, cost)
                                  .improve(m_work.is_left() ? most_rounds : 1);
      sum += moves;
      flip_edges();
      if(moves <= few_moves(m_complex) && (is_after_two || has_many_faces(m_complex)))
        break;
    }
    return sum;
  }

  // Changes all scales so that there are about so many quads, as long as they come nearer to that.
  // Returns the number of moves.
  std::size_t adjust(const double number)
  {
    std::size_t sum = 0;
    double distance = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4 && m_work.is_left(); ++i) {
      const double ratio = number / number_of_quads(m_complex), before = distance;
      distance = std::abs(std::log(ratio));
      if((ratio > 0.95 && ratio < 1.05) || distance > 0.98 * before)
        break;
      for(double& s : m_scales)
        s *= std::sqrt(ratio);
      sum += improve();
    }
    return sum;
  }

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

private:
  // Each triangle has at least half a quad.
  bool has_room() const
  {
    return 2 * number_of_quads_wanted(m_complex, m_scales) >=
           static_cast<double>(m_complex.number_of_faces());
  }

  // Whether a repair is worth trying: if triangles are many, at most an eighth may be bad.
  bool is_repairable() const
  {
    Flat_face_index number = 0;
    for(Flat_face_index f = 0; f < m_complex.number_of_faces(); ++f)
      number += orientation(m_complex, f, &Intrinsic_corner::units) <= 0;
    return number <= 8 + m_complex.number_of_faces() / 8;
  }

  // A few triangles that can't be repaired may become repairable after others; many are hopeless.
  bool repair()
  {
    constexpr std::size_t most_failures = 4; // triangles that no strip repairs end a scale
    Strip_moves moves(m_complex, m_scales, m_work);
    std::size_t before = m_complex.corners.size(), number = before - 1; // of triangles left
    while(number > 0 && number < before) {
      before = number;
      number = 0;
      for(Flat_face_index f = 0; f < m_complex.number_of_faces() && number < most_failures; ++f)
        number += orientation(m_complex, f, &Intrinsic_corner::units) <= 0 && !moves.repair(f);
    }
    return number == 0 && is_feasible();
  }

  void flip_edges()
  {
    make_rounder(m_input, m_complex, {&Intrinsic_corner::vector, &Intrinsic_corner::units});
  }

  const Integer_mesh& m_input;
  Intrinsic_complex& m_complex;
  std::vector<double> m_scales; // wanted units per step of the input's grid, per part
  Work& m_work;
  std::vector<int> m_angles;    // around vertices, in quarter turns
};

// Feasible units at scales that are powers of the square root of 2, or of the fourth root where
// there are few faces, each found once: rounded ones where that succeeds; elsewhere those of the
// next rung are brought nearer, so that no part of the surface stays behind. At the scale of the
// input's grid, the vectors themselves are such units. Where most quads are forced, lower rungs
// have hardly fewer, and are left out. Ladders differ in an offset of all rungs, and so in their
// units; what is found does not depend on what was looked for before.
class Unit_ladders
{
public:
  struct Rung
  {
    Intrinsic_complex complex;
    double first_scale = 1; // where there were units first
    std::size_t number_of_moves = 0;
    bool is_lowest = false;
  };

  // \param scales units per step of the input's grid, per part, at the scale 1
  // \pre the complex is compact
  Unit_ladders(const Integer_mesh& input, const Intrinsic_complex& complex,
               const std::vector<double>& scales, const int number, Work& work)
    : m_input(input), m_complex(complex), m_scales(scales), m_work(work), m_number(number),
      m_rungs_per_doubling(has_many_faces(complex) ? 2 : 4)
  { }

  int size() const { return m_number; }

  std::vector<double> scales(const double scale) const
  {
    std::vector<double> result(m_scales);
    for(double& s : result)
      s *= scale;
    return result;
  }

  // The units rounded at this very scale, or else the units of the next rung of a ladder.
  Rung find(const int ladder, const double scale)
  {
    const double height = m_rungs_per_doubling * std::log2(scale);
    Rung result{m_complex, scale, 0};
    return round(height, result) ? result : at(ladder, int(std::ceil(height - offset(ladder))));
  }

private:
  // Most quads are forced if there are so many times as many as wanted.
  static constexpr double most_times_as_many = 3; // quads, of the wanted number

  double offset(const int ladder) const { return double(ladder) / m_number; }

  double scale_at(const double height) const { return std::exp2(height / m_rungs_per_doubling); }

  // If rounding fails on the next rung without an offset, the search does not try it: else each
  // ladder would take as long to find that.
  bool round(const double height, Rung& rung)
  {
    const int first = int(std::ceil(height));
    const auto [found, is_new] = m_can_round.try_emplace(first, false);
    if(is_new) {
      Intrinsic_complex complex = m_complex;
      found->second = Complex_quantizer(m_input, complex, scales(scale_at(first)), m_work).round();
    }
    return found->second &&
           Complex_quantizer(m_input, rung.complex, scales(scale_at(height)), m_work).round();
  }

  const Rung& at(const int ladder, const int i)
  {
    const auto found = m_rungs.find({ladder, i});
    if(found != m_rungs.end())
      return found->second;
    const double height = i + offset(ladder), scale = scale_at(height);
    Rung rung{m_complex, scale, 0};
    Complex_quantizer quantizer(m_input, rung.complex, scales(scale), m_work);
    if(quantizer.is_as_fine_as_input()) {
      quantizer.take_multiples_of_vectors();
    } else if(!round(height, rung)) {
      const Rung& next = at(ladder, i + 1);
      if(next.is_lowest)
        return next;
      rung = next;
      rung.number_of_moves += quantizer.approach();
      rung.is_lowest =
        number_of_quads(rung.complex) >
        most_times_as_many * number_of_quads_wanted(m_complex, scales(scale));
    }
    return m_rungs.emplace(std::make_pair(ladder, i), std::move(rung)).first->second;
  }

  const Integer_mesh& m_input;
  const Intrinsic_complex& m_complex;
  std::vector<double> m_scales;
  Work& m_work;
  int m_number, m_rungs_per_doubling;
  std::map<int, bool> m_can_round;             // by rung, without an offset
  std::map<std::pair<int, int>, Rung> m_rungs; // by ladder and rung
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_COMPLEX_H
