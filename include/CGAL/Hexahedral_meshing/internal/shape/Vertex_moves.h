// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_VERTEX_MOVES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_VERTEX_MOVES_H

#include <CGAL/license/Hexahedral_meshing.h>

// Moves of vertices inside that make hexahedra positive: each to where the energy of the corners
// around it is less, by steps along the axes.

#include <CGAL/Hexahedral_meshing/internal/shape/hexahedron_shape.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Invariants: points of the boundary do not move; a hexahedron that is positive stays so.
class Vertex_moves
{
public:
  explicit Vertex_moves(Hexahedral_mesh& mesh)
    : m_mesh(mesh), m_is_fixed(mesh.points.size(), 0),
      m_hexahedra_of(mesh.points.size(), [&](const auto& add) {
        for(std::size_t i = 0; i < mesh.hexahedra.size(); ++i)
          for(const std::int32_t v : mesh.hexahedra[i])
            add(v, std::int32_t(i));
      })
  {
    for(const auto& q : mesh.quadrilaterals)
      for(const std::int32_t v : q)
        m_is_fixed[std::size_t(v)] = 1;
  }

  // At most so many rounds over the vertices near hexahedra that are not positive.
  void run(const std::size_t number_of_rounds)
  {
    for(std::size_t round = 0; round < number_of_rounds; ++round) {
      const std::vector<std::int32_t> vertices = vertices_to_move();
      bool has_moved = false;
      for(const std::int32_t v : vertices)
        has_moved = move(v) || has_moved;
      if(!has_moved)
        return;
    }
  }

private:
  static constexpr int number_of_rings = 2; // of hexahedra around the ones that are not positive
  static constexpr double first_step = 0.25;  // in mean lengths of edges
  static constexpr double last_step = 0.01;
  // relative to the least determinant, how far below zero a determinant has a finite energy
  static constexpr double regularization = 0.5, least_regularization = 1e-3;

  Hexahedron_points points(const std::int32_t i) const
  {
    Hexahedron_points result;
    for(std::size_t k = 0; k < 8; ++k)
      result[k] = m_mesh.points[std::size_t(m_mesh.hexahedra[std::size_t(i)][k])];
    return result;
  }

  std::vector<std::int32_t> vertices_to_move() const
  {
    std::vector<char> is_near(m_mesh.points.size(), 0);
    std::vector<std::int32_t> result, ring;
    const auto add_vertices_of = [&](const std::int32_t i) {
      for(const std::int32_t v : m_mesh.hexahedra[std::size_t(i)])
        if(is_near[std::size_t(v)] == 0) {
          is_near[std::size_t(v)] = 1;
          result.push_back(v);
        }
    };
    for(std::size_t i = 0; i < m_mesh.hexahedra.size(); ++i)
      if(!is_positive(points(std::int32_t(i))))
        add_vertices_of(std::int32_t(i));
    for(int k = 1; k < number_of_rings; ++k) {
      ring = result;
      for(const std::int32_t v : ring)
        for(const std::int32_t i : m_hexahedra_of[v])
          add_vertices_of(i);
    }
    result.erase(std::remove_if(result.begin(), result.end(), [&](const std::int32_t v)
                                { return m_is_fixed[std::size_t(v)] != 0; }), result.end());
    return result;
  }

  // Steps become shorter where none is of use.
  bool move(const std::int32_t v)
  {
    Uvw& point = m_mesh.points[std::size_t(v)];
    m_size = mean_edge(v);
    set_regularization(v);
    std::vector<char> were_positive = which_are_positive(v);
    double energy = energy_at(v);
    bool has_moved = false;
    for(double step = first_step * m_size; step > last_step * m_size; ) {
      bool is_better = false;
      for(std::size_t direction = 0; direction < 6 && !is_better; ++direction) {
        const Uvw before = point;
        point[direction / 2] += direction % 2 == 0 ? step : -step;
        const double now = energy_at(v);
        is_better = now < energy * (1 - 1e-6) && keeps_positive(v, were_positive);
        if(is_better)
          energy = now;
        else
          point = before;
      }
      has_moved = has_moved || is_better;
      if(!is_better)
        step /= 2;
    }
    return has_moved;
  }

  // Per hexahedron around v.
  std::vector<char> which_are_positive(const std::int32_t v) const
  {
    std::vector<char> result;
    for(const std::int32_t i : m_hexahedra_of[v])
      result.push_back(is_positive(points(i)));
    return result;
  }

  // Whether all hexahedra that were positive still are; then notes which are.
  bool keeps_positive(const std::int32_t v, std::vector<char>& were_positive) const
  {
    const std::vector<char> are_positive = which_are_positive(v);
    for(std::size_t i = 0; i < are_positive.size(); ++i)
      if(were_positive[i] != 0 && are_positive[i] == 0)
        return false;
    were_positive = are_positive;
    return true;
  }

  double mean_edge(const std::int32_t v) const
  {
    double sum = 0;
    std::size_t number = 0;
    for_each_corner(v, [&](const std::array<Uvw, 3>& e) {
      for(const Uvw& edge : e)
        sum += std::sqrt(inner_product(edge, edge));
      number += 3;
    });
    return sum / double(number);
  }

  // The edges of the corners whose tetrahedra contain a vertex.
  template <typename F>
  void for_each_corner(const std::int32_t v, const F& f) const
  {
    for(const std::int32_t i : m_hexahedra_of[v]) {
      const auto& h = m_mesh.hexahedra[std::size_t(i)];
      for(const auto& t : tetrahedron_of_corner) {
        bool has_vertex = false;
        for(const int k : t)
          has_vertex = has_vertex || h[std::size_t(k)] == v;
        if(!has_vertex)
          continue;
        const auto point = [&](const int k) -> const Uvw&
        { return m_mesh.points[std::size_t(h[std::size_t(t[k])])]; };
        f(std::array<Uvw, 3>{{vector_to(point(0), point(1)), vector_to(point(0), point(2)),
                              vector_to(point(0), point(3))}});
      }
    }
  }

  double determinant(const std::array<Uvw, 3>& e) const
  { return inner_product(e[0], vector_product(e[1], e[2])) / (m_size * m_size * m_size); }

  void set_regularization(const std::int32_t v)
  {
    double least = 0;
    for_each_corner(v, [&](const std::array<Uvw, 3>& e)
                    { least = (std::min)(least, determinant(e)); });
    m_regularization = (std::max)(least_regularization, -regularization * least);
  }

  // |J|^2 / chi(det J)^(2/3) + (1 + det^2 J) / chi(det J), summed over corners, with the J of edges
  // in units of their mean length: finite, but large, where a corner is not positive
  // [Garanzha et al. 2021].
  double energy_at(const std::int32_t v) const
  {
    double result = 0;
    for_each_corner(v, [&](const std::array<Uvw, 3>& e) {
      const double d = determinant(e);
      const double root = std::sqrt(m_regularization * m_regularization + d * d);
      const double chi = d > 0 ? (d + root) / 2
                               : m_regularization * m_regularization / (2 * (root - d));
      double squares = 0;
      for(const Uvw& edge : e)
        squares += inner_product(edge, edge);
      result += squares / (m_size * m_size) / std::cbrt(chi * chi) + (1 + d * d) / chi;
    });
    return result;
  }

  Hexahedral_mesh& m_mesh;
  std::vector<char> m_is_fixed; // per vertex
  Lists<std::int32_t> m_hexahedra_of; // per vertex
  double m_size = 1, m_regularization = least_regularization; // of the vertex that moves
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_VERTEX_MOVES_H
