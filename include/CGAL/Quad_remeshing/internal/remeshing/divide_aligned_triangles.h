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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_ALIGNED_TRIANGLES_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_ALIGNED_TRIANGLES_H

#include <CGAL/license/Quad_remeshing.h>

// Divides triangles between features and border that no map aligns without flips.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>
#include <CGAL/Quad_remeshing/internal/remeshing/refine_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: triangles that are not divided at their center are triangles of the input.
class Aligned_triangle_divider
  : private Remeshing_types
{
public:
  explicit Aligned_triangle_divider(Marked_surface& surface)
    : m_surface(surface), m_mesh(surface.mesh)
  { }

  // Divides all sides of the triangles with three aligned sides, and the edges of tips, into three
  // parts, and leads edges from the centers of all faces around to their corners.
  void run()
  {
    const std::vector<Face> faces(m_mesh.faces().begin(), m_mesh.faces().end());
    double square = 0;
    for(const Face f : faces)
      square += area(f) / Surface_refiner::number_of_squares;
    const double least_length = 3 * std::sqrt(square); // thirds would be small against quads
    std::set<Edge> sides;
    for(const Face f : faces) {
      if(!has_area(f) || (m_surface.is_half_of_quad(f) &&
                          area(f) < Surface_refiner::squares_of_half * square))
        continue;
      const bool has_walls_only = this->has_walls_only(f);
      for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
        if(has_walls_only || is_side_opposite_to_flat_corner(h))
          sides.insert(m_mesh.edge(h));
        else if(m_surface.is_wall(h) &&
                CGAL::squared_distance(source(h), target(h)) > least_length * least_length)
          insert_edges_of_tip(h, sides);
      }
    }
    for(const Edge e : sides)
      divide_side(e);
    for(const Face f : faces)
      if(m_mesh.degree(f) > 3)
        divide_at_center(f);
  }

private:
  const Point& source(const Halfedge h) const { return m_mesh.point(m_mesh.source(h)); }
  const Point& target(const Halfedge h) const { return m_mesh.point(m_mesh.target(h)); }

  double area(const Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return std::sqrt(CGAL::squared_area(source(h), target(h), target(m_mesh.next(h))));
  }

  bool has_area(const Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return !CGAL::collinear(source(h), target(h), target(m_mesh.next(h)));
  }

  bool has_walls_only(const Face f) const
  {
    const auto sides = m_mesh.halfedges_around_face(m_mesh.halfedge(f));
    return std::all_of(sides.begin(), sides.end(),
                       [&](const Halfedge h) { return m_surface.is_wall(h); });
  }

  // Whether the two other sides are walls, and nearly one straight line: they can't be on the same
  // isocurve where they are sides of one face.
  bool is_side_opposite_to_flat_corner(const Halfedge h) const
  {
    return m_surface.is_wall(m_mesh.next(h)) && m_surface.is_wall(m_mesh.prev(h)) &&
           angle_to_next(m_mesh, m_mesh.next(h)) > flat_corner;
  }

  // A narrow sector of faces begins at `h`, whose target is between walls: the field opens there,
  // which should be far from the other ends of the edges.
  void insert_edges_of_tip(Halfedge h, std::set<Edge>& sides) const
  {
    std::vector<Edge> edges{m_mesh.edge(h)};
    double angle = 0;
    do {
      angle += angle_to_next(m_mesh, h);
      edges.push_back(m_mesh.edge(m_mesh.next(h)));
      h = m_mesh.opposite(m_mesh.next(h));
    } while(!m_surface.is_wall(h) && angle < narrow_tip);
    if(angle < narrow_tip)
      sides.insert(edges.begin(), edges.end());
  }

  void divide_side(const Edge e)
  {
    const Halfedge h = m_mesh.halfedge(e);
    const Point first = source(h);
    const Vector third = (target(h) - first) / 3;
    const double size = m_surface.sizes[m_mesh.source(h)];
    const double third_of_size = (m_surface.sizes[m_mesh.target(h)] - size) / 3;
    for(const int i : {1, 2})
      m_surface.split_edge(h, first + i * third, size + i * third_of_size);
  }

  void divide_at_center(const Face f)
  {
    const double n = static_cast<double>(m_mesh.degree(f));
    std::array<double, 3> center{};
    double size = 0, count = 0; // the mean of equal sizes is exact: they are not to vary
    for(const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f))) {
      for(int c = 0; c < 3; ++c)
        center[std::size_t(c)] += m_mesh.point(v)[c] / n;
      size += (m_surface.sizes[v] - size) / ++count;
    }
    const Halfedge h = CGAL::Euler::add_center_vertex(m_mesh.halfedge(f), m_mesh);
    m_mesh.point(m_mesh.target(h)) = Point(center[0], center[1], center[2]);
    m_surface.sizes[m_mesh.target(h)] = size;
    for(const Halfedge g : m_mesh.halfedges_around_target(h))
      if(m_mesh.face(g) != f)
        m_surface.mark_part_of(f);
  }

  static constexpr double narrow_tip = 50; // degrees, as `parametrization::narrow_sector`

  Marked_surface& m_surface;
  Mesh& m_mesh;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_ALIGNED_TRIANGLES_H
