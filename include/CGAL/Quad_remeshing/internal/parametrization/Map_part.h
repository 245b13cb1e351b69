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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MAP_PART_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MAP_PART_H

#include <CGAL/license/Quad_remeshing.h>

// Some faces of a map, to be untangled by themselves: each as it would be laid out without
// distortion.

#include <CGAL/Quad_remeshing/internal/parametrization/Surface_complex.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/poisson.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/untangling/Constrained_triangles.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The faces up to so many edges around faces that are not positive.
inline std::vector<std::size_t> faces_near_flips(const Triangle_surface& surface,
                                                 const Surface_complex& complex,
                                                 const Coordinates& uv,
                                                 const std::size_t number_of_edges)
{
  std::vector<char> is_near(surface.number_of_vertices(), false);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(!is_positive(complex, uv, surface.face(h)))
      is_near[surface.vertex(h)] = true;
  for(std::size_t i = 0; i < number_of_edges; ++i) {
    const std::vector<char> before = is_near;
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
      if(before[surface.vertex(h)] || before[surface.source(h)])
        is_near[surface.vertex(h)] = is_near[surface.source(h)] = true;
  }
  std::vector<std::size_t> result;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); h += 3)
    if(is_near[surface.vertex(h)] || is_near[surface.vertex(h + 1)] ||
       is_near[surface.vertex(h + 2)])
      result.push_back(std::size_t(surface.face(h)));
  return result;
}

// Invariant: an unknown belongs to the part if only vertices with all faces in the part depend on
// it. The unknowns of the part keep their order; all others keep their values.
class Map_part
{
public:
  // \param index of the field, per vertex
  Map_part(const Triangle_surface& surface, const std::vector<int>& index,
           const Surface_complex& complex, const Coordinate_table& table,
           const std::size_t number_of_unknowns, const Coordinates& uv,
           const std::vector<std::size_t>& faces)
    : m_surface(surface), m_complex(complex), m_table(table),
      m_is_inner(surface.number_of_vertices(), true), m_number(number_of_unknowns, none),
      m_point(complex.number_of_sectors(), none)
  {
    find_inner_vertices(faces);
    number_unknowns();
    for(const std::size_t f : faces)
      add_face(3 * Corner_index(f), uv);
    for(std::size_t v = 0; v < m_is_inner.size(); ++v) // the field leaves the border out
      m_map.angle.push_back(surface.is_border[v] || !m_is_inner[v]
                              ? std::numeric_limits<double>::quiet_NaN()
                              : full_turn - index[v] * quarter_turn);
  }

  const Constrained_triangles& map() const { return m_map; }

  // The changes of its unknowns that minimize the energy of `parametrization::solve_poisson()` in
  // the faces of the part.
  // \param weights per face of the surface
  // \param system with the coefficients 0
  template <typename Difference>
  std::vector<double> solve_poisson(const std::vector<std::size_t>& faces,
                                    const Difference& wanted_difference,
                                    const std::vector<double>& weights,
                                    Sparse_system& system) const
  {
    std::vector<double> right_hand_side(system.dimension(), 0);
    for(std::size_t t = 0; t < faces.size(); ++t)
      for(std::size_t k = 0; k < 3; ++k) {
        const Corner_index h = Corner_index(3 * faces[t] + k);
        const std::size_t p = m_map.triangles[t].points[(k + 2) % 3];
        const std::size_t q = m_map.triangles[t].points[k];
        const double weight = cotangent_weight(m_surface, weights, h);
        const std::array<double, 2> wanted = wanted_difference(h);
        for(std::size_t c = 0; c < 2; ++c) {
          const double left = wanted[c] - (m_map.start[q][c] - m_map.start[p][c]);
          Sparse_row row = m_map.rows[q][c];
          for(const auto& [i, a] : m_map.rows[p][c])
            row.emplace_back(i, -a);
          for(const auto& [i, a] : row) {
            right_hand_side[i] += weight * a * left;
            for(const auto& [j, b] : row)
              system.add(i, j, weight * a * b);
          }
        }
      }
    system.factor();
    return system.solve(right_hand_side);
  }

  // Adds the changes of the unknowns of the part to the unknowns of the whole.
  void add(const std::vector<double>& changes, std::vector<double>& unknowns) const
  {
    for(std::size_t i = 0; i < changes.size(); ++i)
      unknowns[m_unknowns[i]] += changes[i];
  }

private:
  static constexpr std::size_t held = none - 1; // in place of a number

  void find_inner_vertices(const std::vector<std::size_t>& faces)
  {
    std::vector<char> is_chosen(m_surface.number_of_faces(), false);
    for(const std::size_t f : faces)
      is_chosen[f] = true;
    for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
      if(!is_chosen[m_surface.face(h)])
        m_is_inner[m_surface.vertex(h)] = false;
  }

  void number_unknowns()
  {
    for(Corner_index h = 0; h < m_surface.number_of_halfedges(); ++h)
      if(!m_is_inner[m_surface.vertex(h)])
        for(std::size_t c = 0; c < 2; ++c)
          m_table.for_each_term(m_complex.sector(h), c,
                                [&](const std::size_t i, double) { m_number[i] = held; });
    for(std::size_t i = 0; i < m_number.size(); ++i)
      if(m_number[i] != held) {
        m_number[i] = m_unknowns.size();
        m_unknowns.push_back(i);
      }
    m_map.number_of_unknowns = m_unknowns.size();
  }

  void add_face(const Corner_index first, const Coordinates& uv)
  {
    const double angle = m_surface.direction[first + 1], length = m_surface.length[first + 1];
    m_map.triangles.push_back(
      {{{point(first, uv), point(first + 1, uv), point(first + 2, uv)}},
       Reference_shape({{length * std::cos(angle), length * std::sin(angle)}},
                       {{-m_surface.length[first], 0}})});
  }

  // The number of the point at a corner.
  std::size_t point(const Corner_index h, const Coordinates& uv)
  {
    const std::size_t s = m_complex.sector(h);
    if(m_point[s] != none)
      return m_point[s];
    m_map.start.push_back(uv[s]);
    m_map.vertex.push_back(m_surface.vertex(h));
    auto& rows = m_map.rows.emplace_back();
    for(std::size_t c = 0; c < 2; ++c)
      m_table.for_each_term(s, c, [&](const std::size_t i, const double factor) {
        if(m_number[i] != held)
          rows[c].emplace_back(m_number[i], factor);
      });
    return m_point[s] = m_map.start.size() - 1;
  }

  const Triangle_surface& m_surface;
  const Surface_complex& m_complex;
  const Coordinate_table& m_table;
  std::vector<char> m_is_inner;      // per vertex: all of its faces are in the part
  std::vector<std::size_t> m_number; // per unknown of the whole
  std::vector<std::size_t> m_point;  // per sector
  std::vector<std::size_t> m_unknowns;
  Constrained_triangles m_map;
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MAP_PART_H
