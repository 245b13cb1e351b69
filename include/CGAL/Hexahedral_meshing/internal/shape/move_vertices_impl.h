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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_IMPL_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_IMPL_H

#include <CGAL/license/Hexahedral_meshing.h>

// Each vertex moves to where the energy of the corners around it is less, by steps along the axes,
// and from there to the nearest point of its patch or curve.

#include <CGAL/Hexahedral_meshing/internal/shape/Nearest_on_features.h>
#include <CGAL/Hexahedral_meshing/internal/shape/hexahedron_shape.h>
#include <CGAL/Hexahedral_meshing/internal/shape/move_vertices.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// Where a vertex may move. Vertices at which curves or patches end, a curve bends in the domain, or
// goes through a patch are fixed.
struct Freedom
{
  enum Kind { INSIDE, ON_PATCH, ON_CURVE, FIXED };

  Kind kind = INSIDE;
  std::size_t number = 0; // of the patch or curve, less one
};

using Lists_of_hexahedra = Lists<std::int32_t>; // per vertex

inline Lists_of_hexahedra hexahedra_of_vertices(const Hexahedral_mesh& mesh)
{
  return Lists_of_hexahedra(mesh.points.size(), [&](const auto& add) {
    for(std::size_t i = 0; i < mesh.hexahedra.size(); ++i)
      for(const std::int32_t v : mesh.hexahedra[i])
        add(v, std::int32_t(i));
  });
}

// Finds where vertices may move.
class Freedom_finder
{
public:
  Freedom_finder(const Hexahedral_mesh& mesh, const Lists_of_hexahedra& hexahedra_of)
    : m_mesh(mesh), m_hexahedra_of(hexahedra_of), m_freedoms(mesh.points.size()),
      m_edges_of(mesh.points.size(), [&](const auto& add) {
        for(std::size_t i = 0; i < mesh.edges.size(); ++i)
          for(const std::int32_t v : mesh.edges[i])
            add(v, std::int32_t(i));
      })
  { }

  std::vector<Freedom> find()
  {
    std::vector<char> is_pierced(m_freedoms.size(), 0); // a curve goes through a patch, so far
    for(std::size_t i = 0; i < m_mesh.quadrilaterals.size(); ++i)
      for(std::size_t k = 0; k < 4; ++k) {
        const auto& q = m_mesh.quadrilaterals[i];
        Freedom& freedom = m_freedoms[std::size_t(q[k])];
        const Freedom now{Freedom::ON_PATCH, std::size_t(m_mesh.patches[i] - 1)};
        char& is_pierced_here = is_pierced[std::size_t(q[k])];
        if(freedom.kind == Freedom::INSIDE) {
          freedom = now;
          is_pierced_here = 1;
        } else if(freedom.number != now.number) {
          freedom.kind = Freedom::FIXED;
        }
        for(const std::int32_t edge : m_edges_of[q[k]])
          if(const std::int32_t w = other_end(edge, q[k]);
             w == q[(k + 1) % 4] || w == q[(k + 3) % 4])
            is_pierced_here = 0;
      }
    for(std::size_t v = 0; v < m_freedoms.size(); ++v)
      if(!m_edges_of[v].empty()) {
        m_freedoms[v].kind = Freedom::FIXED;
        if(is_pierced[v] == 0 && is_on_straight_curve(std::int32_t(v)))
          m_freedoms[v] = {Freedom::ON_CURVE,
                           std::size_t(m_mesh.curves[std::size_t(m_edges_of[v].front())] - 1)};
      }
    return std::move(m_freedoms);
  }

private:
  std::int32_t other_end(const std::int32_t edge, const std::int32_t v) const
  {
    const auto& ends = m_mesh.edges[std::size_t(edge)];
    return ends[std::size_t(ends[0] == v)];
  }

  // In the domain: no hexahedron has both edges.
  bool is_on_straight_curve(const std::int32_t v) const
  {
    const auto edges = m_edges_of[v];
    if(edges.size() != 2 || m_mesh.curves[std::size_t(edges.front())] !=
                              m_mesh.curves[std::size_t(edges.back())])
      return false;
    const auto hexahedra = m_hexahedra_of[v];
    return std::none_of(hexahedra.begin(), hexahedra.end(), [&](const std::int32_t i) {
      const auto& h = m_mesh.hexahedra[std::size_t(i)];
      return std::count(h.begin(), h.end(), other_end(edges.front(), v)) > 0 &&
             std::count(h.begin(), h.end(), other_end(edges.back(), v)) > 0;
    });
  }

  const Hexahedral_mesh& m_mesh;
  const Lists_of_hexahedra& m_hexahedra_of;
  std::vector<Freedom> m_freedoms; // per vertex
  Lists<std::int32_t> m_edges_of;  // per vertex
};

// Invariant: a corner of a hexahedron that is positive stays so.
class Vertex_moves
{
public:
  Vertex_moves(Hexahedral_mesh& mesh, const Feature_geometry& geometry)
    : m_mesh(mesh), m_hexahedra_of(hexahedra_of_vertices(mesh)),
      m_freedoms(Freedom_finder(mesh, m_hexahedra_of).find()),
      m_patches(sets<Triangle_trees>(geometry.patches)),
      m_curves(sets<Segment_trees>(geometry.curves))
  { }

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
    const auto is_fixed = [&](const std::int32_t v)
    { return m_freedoms[std::size_t(v)].kind == Freedom::FIXED; };
    result.erase(std::remove_if(result.begin(), result.end(), is_fixed), result.end());
    return result;
  }

  // Steps become shorter where none is of use.
  bool move(const std::int32_t v)
  {
    Uvw& point = m_mesh.points[std::size_t(v)];
    m_size = mean_edge(v);
    set_regularization(v);
    std::vector<unsigned int> were_positive = positive_corners_at(v);
    double energy = energy_at(v);
    bool has_moved = false;
    for(double step = first_step * m_size; step > last_step * m_size; ) {
      bool is_better = false;
      for(std::size_t direction = 0; direction < 6 && !is_better; ++direction) {
        const Uvw before = point;
        Uvw target = point;
        target[direction / 2] += direction % 2 == 0 ? step : -step;
        point = place(v, target);
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

  // Where v comes to lie on the way to a target: where it is if the nearest point of its patch or
  // curve is as far away as that of another part of it may be.
  Uvw place(const std::int32_t v, const Uvw& target)
  {
    const Freedom& freedom = m_freedoms[std::size_t(v)];
    const Uvw& point = m_mesh.points[std::size_t(v)];
    if(freedom.kind == Freedom::INSIDE)
      return target;
    const Uvw result = freedom.kind == Freedom::ON_PATCH
                         ? m_patches.nearest(freedom.number, target, point)
                         : m_curves.nearest(freedom.number, target, point);
    const Uvw step = vector_to(point, target), miss = vector_to(target, result);
    return inner_product(miss, miss) <= inner_product(step, step) ? result : point;
  }

  // Elements without an extent are left out.
  template <typename Trees, typename Elements>
  static std::vector<std::vector<typename Trees::Element> > sets(const Elements& elements)
  {
    std::vector<std::vector<typename Trees::Element> > result(elements.size());
    const auto point = [](const Uvw& p)
    { return typename Trees::Kernel::Point_3(p[0], p[1], p[2]); };
    for(std::size_t i = 0; i < elements.size(); ++i)
      for(const auto& e : elements[i]) {
        const auto element = std::apply([&](const auto&... p)
                                        { return typename Trees::Element(point(p)...); }, e);
        if(!element.is_degenerate())
          result[i].push_back(element);
      }
    return result;
  }

  // The positive corners of each hexahedron around v.
  std::vector<unsigned int> positive_corners_at(const std::int32_t v) const
  {
    std::vector<unsigned int> result;
    for(const std::int32_t i : m_hexahedra_of[v])
      result.push_back(positive_corners(points(i)));
    return result;
  }

  // Whether all corners that were positive still are; then notes which are.
  bool keeps_positive(const std::int32_t v, std::vector<unsigned int>& were_positive) const
  {
    const std::vector<unsigned int> are_positive = positive_corners_at(v);
    for(std::size_t i = 0; i < are_positive.size(); ++i)
      if((were_positive[i] & ~are_positive[i]) != 0)
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
  const Lists_of_hexahedra m_hexahedra_of;
  const std::vector<Freedom> m_freedoms; // per vertex
  Nearest_on_sets<Triangle_trees> m_patches;
  Nearest_on_sets<Segment_trees> m_curves;
  double m_size = 1, m_regularization = least_regularization; // of the vertex that moves
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void move_vertices(Hexahedral_mesh& mesh, const Feature_geometry& geometry,
                   const std::size_t number_of_rounds)
{
  Vertex_moves(mesh, geometry).run(number_of_rounds);
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_IMPL_H
