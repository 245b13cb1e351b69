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
#include <set>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// The places to which a vertex may move.
struct Freedom
{
  enum Kind { INSIDE, ON_PATCH, ON_CURVE, FIXED };

  Kind kind = INSIDE;
  std::int32_t number = 0; // of the patch or curve
};

using Lists_by_vertex = Lists<std::int32_t>;

// The numbers of the elements at each vertex.
template <typename Elements>
Lists_by_vertex elements_of_vertices(const Hexahedral_mesh& mesh, const Elements& elements)
{
  return Lists_by_vertex(mesh.points.size(), [&](const auto& add) {
    for(std::size_t i = 0; i < elements.size(); ++i)
      for(const std::int32_t v : elements[i])
        add(v, std::int32_t(i));
  });
}

// Whether two edges at a vertex go on straight in the domain: no hexahedron has both.
inline bool are_straight(const Hexahedral_mesh& mesh, const Lists_by_vertex& hexahedra_of,
                         const std::int32_t v, const std::size_t e, const std::size_t f)
{
  const auto other_end = [&](const std::size_t edge)
  { return mesh.edges[edge][std::size_t(mesh.edges[edge][0] == v)]; };
  const auto hexahedra = hexahedra_of[v];
  return std::none_of(hexahedra.begin(), hexahedra.end(), [&](const std::int32_t i) {
    const auto& h = mesh.hexahedra[std::size_t(i)];
    return std::count(h.begin(), h.end(), other_end(e)) > 0 &&
           std::count(h.begin(), h.end(), other_end(f)) > 0;
  });
}

// Vertices at which curves or patches end, a curve bends in the domain, or goes through a patch are
// fixed.
inline std::vector<Freedom> find_freedoms(const Hexahedral_mesh& mesh,
                                          const Lists_by_vertex& hexahedra_of)
{
  std::vector<Freedom> result(mesh.points.size());
  const std::set<std::array<std::int32_t, 2> > edges(mesh.edges.begin(), mesh.edges.end());
  std::vector<char> bounds_patch(result.size(), 0); // a quadrilateral has an edge of a curve there
  for(std::size_t i = 0; i < mesh.quadrilaterals.size(); ++i)
    for(std::size_t k = 0; k < 4; ++k) {
      const std::int32_t v = mesh.quadrilaterals[i][k], w = mesh.quadrilaterals[i][(k + 1) % 4];
      Freedom& freedom = result[std::size_t(v)];
      if(freedom.kind == Freedom::INSIDE)
        freedom = {Freedom::ON_PATCH, mesh.patches[i]};
      else if(freedom.number != mesh.patches[i])
        freedom.kind = Freedom::FIXED;
      if(edges.count({(std::min)(v, w), (std::max)(v, w)}) > 0)
        bounds_patch[std::size_t(v)] = bounds_patch[std::size_t(w)] = 1;
    }
  const Lists_by_vertex edges_of = elements_of_vertices(mesh, mesh.edges);
  for(std::size_t v = 0; v < result.size(); ++v)
    if(const auto at_vertex = edges_of[v]; !at_vertex.empty()) {
      const auto first = std::size_t(at_vertex.front()), last = std::size_t(at_vertex.back());
      const bool is_pierced = result[v].kind != Freedom::INSIDE && bounds_patch[v] == 0;
      result[v].kind = Freedom::FIXED;
      if(at_vertex.size() == 2 && !is_pierced && mesh.curves[first] == mesh.curves[last] &&
         are_straight(mesh, hexahedra_of, std::int32_t(v), first, last))
        result[v] = {Freedom::ON_CURVE, mesh.curves[first]};
    }
  return result;
}

// Invariant: a corner of a hexahedron that is positive stays so.
class Vertex_moves
{
public:
  explicit Vertex_moves(Extraction& extraction)
    : m_mesh(extraction.mesh),
      m_hexahedra_of(elements_of_vertices(extraction.mesh, extraction.mesh.hexahedra)),
      m_freedoms(find_freedoms(extraction.mesh, m_hexahedra_of))
  {
    const auto point = [&](const Corner_index i) {
      const Uvw& p = extraction.points[std::size_t(extraction.volume.vertex(i))];
      return Space_kernel::Point_3(p[0], p[1], p[2]);
    };
    const Feature_complex& complex = extraction.complex;
    for(std::size_t i = 0; i < complex.patches.size(); ++i) {
      const auto c = corners_of_facet(extraction.volume.aligned_facets[i]);
      m_patches.add(std::size_t(complex.patches[i]), {point(c[0]), point(c[1]), point(c[2])});
    }
    for(std::size_t i = 0; i < complex.lines.size(); ++i)
      m_curves.add(std::size_t(complex.curves[i]),
                   {point(complex.lines[i].a), point(complex.lines[i].b)});
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
  { return points_of(m_mesh.points, m_mesh.hexahedra[std::size_t(i)]); }

  std::vector<std::int32_t> vertices_to_move() const
  {
    std::vector<char> is_near(m_mesh.points.size(), 0);
    for(int ring = 0; ring < number_of_rings; ++ring) {
      const std::vector<char> was_near(is_near);
      for(std::size_t i = 0; i < m_mesh.hexahedra.size(); ++i) {
        const auto& h = m_mesh.hexahedra[i];
        if(ring == 0 ? !is_positive(points(std::int32_t(i)))
                     : std::any_of(h.begin(), h.end(), [&](const std::int32_t v)
                                   { return was_near[std::size_t(v)] != 0; }))
          for(const std::int32_t v : h)
            is_near[std::size_t(v)] = 1;
      }
    }
    std::vector<std::int32_t> result;
    for(std::size_t v = 0; v < is_near.size(); ++v)
      if(is_near[v] != 0 && m_freedoms[v].kind != Freedom::FIXED)
        result.push_back(std::int32_t(v));
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

  // The new place of v on the way to a target. It is the old place if the nearest point of its
  // patch or curve is so far away that another part of the patch or curve may be as near.
  Uvw place(const std::int32_t v, const Uvw& target)
  {
    const Freedom& freedom = m_freedoms[std::size_t(v)];
    const Uvw& point = m_mesh.points[std::size_t(v)];
    if(freedom.kind == Freedom::INSIDE)
      return target;
    const auto number = std::size_t(freedom.number);
    const Uvw result = freedom.kind == Freedom::ON_PATCH ? m_patches.nearest(number, target, point)
                                                         : m_curves.nearest(number, target, point);
    const Uvw step = vector_to(point, target), miss = vector_to(target, result);
    return inner_product(miss, miss) <= inner_product(step, step) ? result : point;
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
      for(std::size_t k = 0; k < 8; ++k) {
        const auto t = tetrahedron_of_corner(m_mesh.hexahedra[std::size_t(i)], k);
        if(std::count(t.begin(), t.end(), v) == 0)
          continue;
        const auto edge_to = [&](const std::size_t end)
        { return vector_to(m_mesh.points[std::size_t(t[0])], m_mesh.points[std::size_t(t[end])]); };
        f(std::array<Uvw, 3>{{edge_to(1), edge_to(2), edge_to(3)}});
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
  const Lists_by_vertex m_hexahedra_of;
  const std::vector<Freedom> m_freedoms; // per vertex
  Nearest_on_sets<Space_kernel::Triangle_3, Triangle_primitive> m_patches; // by their numbers
  Nearest_on_sets<Space_kernel::Segment_3, Segment_primitive> m_curves;
  double m_size = 1, m_regularization = least_regularization; // of the vertex that moves
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void move_vertices(Extraction& extraction, const std::size_t number_of_rounds)
{
  Vertex_moves(extraction).run(number_of_rounds);
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_MOVE_VERTICES_IMPL_H
