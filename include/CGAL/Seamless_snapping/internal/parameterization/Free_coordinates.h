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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FREE_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FREE_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// The unknowns of the parametrization after all constraints have been eliminated: transitions at
// the nodes of the cut graph, alignment, and the position of each component in the plane.

#include <CGAL/Seamless_snapping/internal/parameterization/Constraint_elimination.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Matching.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Triangle_surface.h>
#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

// Coordinate `c` of a Rotated_sum, over the unknowns `2 i + coordinate`.
inline Sparse_row coordinate_row(const Rotated_sum& sum, const std::size_t c,
                                 const double factor = 1)
{
  Sparse_row row;
  for(const auto& [vector, k] : sum)
    for(std::size_t i = 0; i < 2; ++i)
      if(const int sign = rotation_matrix(k).m[c][i]; sign != 0)
        row.emplace_back(2 * vector + i, factor * sign);
  return row;
}

inline void append(Sparse_row& row, const Sparse_row& other)
{
  row.insert(row.end(), other.begin(), other.end());
}

// The rows of a full turn around a vertex. Around a cone they determine its position x, as
// (I - R^k)^-1 = (I + R) / 2, I / 2, (I - R) / 2 for k = 1, 2, 3.
inline void add_closing_rows(const Cut_complex::Closing& closing, std::vector<Sparse_row>& rows)
{
  const Rotated_sum& t = closing.translation;
  for(std::size_t c = 0; c < 2; ++c) {
    if(closing.rotation == 0) {
      rows.push_back(coordinate_row(t, c));
      continue;
    }
    Sparse_row row = coordinate_row({{closing.vertex, 0}}, c);
    append(row, coordinate_row(t, c, -0.5));
    if(closing.rotation != 2)
      append(row, coordinate_row(rotated(t, closing.rotation), c, -0.5));
    rows.push_back(row);
  }
}

// The kind of isocurve that an edge lies on: 0 for constant u, 1 for constant v; whichever is
// closer to its direction in the field.
inline std::size_t constant_coordinate(const Triangle_surface& surface,
                                       const std::vector<double>& angles, const Corner_index h)
{
  const double turns = (surface.direction[h] - angles[surface.face(h)]) / quarter_turn;
  return std::lround(turns) % 2 == 0 ? 1 : 0;
}

inline std::vector<Sparse_row> alignment_rows(const Triangle_surface& surface,
                                              const std::vector<double>& angles,
                                              const Cut_complex& complex)
{
  std::vector<Sparse_row> rows;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(!surface.is_aligned[h] || !surface.represents_edge(h))
      continue;
    const std::size_t c = constant_coordinate(surface, angles, h);
    Sparse_row row = coordinate_row(complex.position(complex.sector(h)), c);
    append(row, coordinate_row(complex.position(complex.sector(surface.prev(h))), c, -1));
    rows.push_back(row);
  }
  return rows;
}

// The transitions and constraints allow to move a component as a whole: one vertex of each is put
// at the origin.
inline std::vector<Sparse_row> anchor_rows(const Triangle_surface& surface)
{
  std::vector<Sparse_row> rows;
  std::vector<char> has_anchor(surface.number_of_components, false);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    if(has_anchor[surface.component[f]])
      continue;
    has_anchor[surface.component[f]] = true;
    for(std::size_t c = 0; c < 2; ++c)
      rows.push_back(coordinate_row({{surface.vertex(3 * f), 0}}, c));
  }
  return rows;
}

// Invariant: whatever values the free unknowns have, the coordinates of the sectors meet all
// constraints.
class Free_coordinates
{
public:
  Free_coordinates(const Triangle_surface& surface, const std::vector<double>& angles,
                   const Cut_complex& complex)
    : m_complex(complex)
    , m_elimination(2 * complex.number_of_vectors())
    , m_index(2 * complex.number_of_vectors(), none)
  {
    std::vector<Sparse_row> rows;
    for(const Cut_complex::Closing& closing : complex.closings())
      add_closing_rows(closing, rows);
    for(const auto& more : {alignment_rows(surface, angles, complex), anchor_rows(surface)})
      rows.insert(rows.end(), more.begin(), more.end());
    m_elimination.add(rows);
    m_elimination.finish();
    for(std::size_t i = 0; i < m_index.size(); ++i)
      if(!m_elimination.is_eliminated(i))
        m_index[i] = m_number_of_unknowns++;
  }

  std::size_t number_of_unknowns() const { return m_number_of_unknowns; }

  // Coordinate `c` of a sector, over the free unknowns.
  Sparse_row coordinate(const std::size_t sector, const std::size_t c) const
  {
    Sparse_row row;
    for(const auto& [unknown, factor] : coordinate_row(m_complex.position(sector), c)) {
      if(!m_elimination.is_eliminated(unknown)) {
        row.emplace_back(m_index[unknown], factor);
        continue;
      }
      for(const auto& term : m_elimination.substitution(unknown))
        row.emplace_back(m_index[term.first], factor * term.second);
    }
    normalize(row);
    return row;
  }

  // The coordinates of all sectors. Those of one vertex are computed from each other, so that the
  // transitions hold up to the rounding of a single sum.
  std::vector<std::array<double, 2> > evaluate(const std::vector<double>& free_values) const
  {
    std::vector<double> values(m_index.size(), 0);
    for(std::size_t i = 0; i < values.size(); ++i) {
      if(!m_elimination.is_eliminated(i))
        values[i] = free_values[m_index[i]];
      else
        for(const auto& [other, factor] : m_elimination.substitution(i))
          values[i] += factor * free_values[m_index[other]];
    }
    std::vector<std::array<double, 2> > uv(m_complex.number_of_sectors());
    for(std::size_t s = 0; s < uv.size(); ++s)
      for(std::size_t c = 0; c < 2; ++c) {
        double sum = 0;
        for(const auto& [unknown, factor] : coordinate_row(m_complex.position(s), c))
          sum += factor * values[unknown];
        uv[s][c] = sum;
      }
    return uv;
  }

private:
  const Cut_complex& m_complex;
  Constraint_elimination m_elimination;
  std::vector<std::size_t> m_index; // of the free unknowns
  std::size_t m_number_of_unknowns = 0;
};

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_FREE_COORDINATES_H
