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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_REFINE_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_REFINE_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// Divides long and large triangles, for example in a flat face without vertices inside: no cones
// could lie there, and few vertices leave a map no room between features. Longest edges are halved
// (Rivara's longest-edge propagation), and edges between triangles of a plane are flipped to
// Delaunay ones.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: all vertices stay, and so do features and border, of which new edges are parts. No
// flip makes a triangle with two sides that are features or border, which both would direct it.
// Lengths do not depend on the number of quads, so that all numbers have the same surface.
class Surface_refiner
  : private Remeshing_types
{
public:
  // Triangles are divided if they are longer than the side of one of so many squares, and than so
  // many times their height; large ones, if they are longer than so many sides. Where these cover
  // less than such a share of the area, nothing is changed. Halves of quads between walls stay if
  // they are not larger than so many squares: for few quads, a rectangle is better than cones.
  static constexpr double number_of_squares = 5000; // the side of one is the unit of lengths
  static constexpr double squares_of_half = 15; // the largest half of a quad that stays
  static constexpr double longness = 4; // length over height of a long triangle
  static constexpr double largest_length = 4; // units; the side of a large triangle
  static constexpr double least_share = 0.2; // the part of the area that such triangles cover

  // So that a triangle that is nearly a segment becomes no more faces than a large surface has.
  static std::size_t most_new_faces(const std::size_t number_of_faces)
  { return std::clamp<std::size_t>(20 * number_of_faces, 10000, 40000); }

  // \param has_large_faces whether large triangles stay
  Surface_refiner(Marked_surface& surface, const bool has_large_faces)
    : m_surface(surface), m_mesh(surface.mesh), m_has_large_faces(has_large_faces),
      m_most_faces(m_mesh.number_of_faces() + most_new_faces(m_mesh.number_of_faces())),
      m_most_flips(10 * (m_mesh.number_of_edges() +
                         2 * most_new_faces(m_mesh.number_of_faces())))
  { }

  // Returns false if the surface is left as it is, as most are.
  // \pre triangles only
  bool run()
  {
    if(!choose_lengths())
      return false;
    double area_to_divide = 0;
    for(const Face f : m_mesh.faces())
      if(push_if_to_divide(f)) {
        area_to_divide += area(f);
        for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
          m_unchecked.push_back(m_mesh.edge(h));
      }
    if(!(area_to_divide > least_share * m_area))
      return false;
    flip();
    while(!m_faces_to_divide.empty() && m_mesh.number_of_faces() + 2 <= m_most_faces) {
      const auto [area, f] = m_faces_to_divide.top();
      m_faces_to_divide.pop();
      if(area != this->area(f) || !is_to_divide(f))
        continue; // it has changed since
      halve(longest_near(f));
      flip();
      push_if_to_divide(f);
    }
    return true;
  }

private:
  Vector vector(const Halfedge h) const
  { return m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h)); }

  Vector normal(const Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return CGAL::cross_product(vector(h), vector(m_mesh.next(h)));
  }

  double size(const Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return (m_surface.sizes[m_mesh.source(h)] + m_surface.sizes[m_mesh.target(h)] +
            m_surface.sizes[m_mesh.target(m_mesh.next(h))]) / 3;
  }

  // In units of the size.
  double area(const Face f) const
  { return std::sqrt(normal(f).squared_length()) / (2 * size(f) * size(f)); }

  // Returns false where there are none: numbers that others will refuse.
  bool choose_lengths()
  {
    CGAL::Bbox_3 box;
    for(const Vertex v : m_mesh.vertices()) {
      const Point& p = m_mesh.point(v);
      if(!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()) &&
           std::isfinite(m_surface.sizes[v]) && m_surface.sizes[v] > 0))
        return false;
      box += p.bbox();
    }
    m_area = 0;
    for(const Face f : m_mesh.faces())
      m_area += area(f);
    constexpr double flatness = 1e-6; // enough for points in single precision
    m_height_of_flat = flatness * std::hypot(box.x_span(), box.y_span(), box.z_span());
    m_length = std::sqrt(m_area / number_of_squares);
    return m_length > 0 && std::isfinite(m_length);
  }

  Halfedge longest_side(const Face f) const
  {
    Halfedge result = m_mesh.halfedge(f);
    for(const Halfedge h : {m_mesh.next(result), m_mesh.prev(result)})
      if(vector(h).squared_length() > vector(result).squared_length())
        result = h;
    return result;
  }

  bool is_to_divide(const Face f) const
  {
    if(m_surface.is_half_of_quad(f) && area(f) < squares_of_half * m_length * m_length)
      return false;
    const double length = std::sqrt(vector(longest_side(f)).squared_length());
    const double sides = length / (m_length * size(f));
    return (!m_has_large_faces && sides > largest_length) ||
           (sides > 1 && longness * std::sqrt(normal(f).squared_length()) < length * length);
  }

  bool push_if_to_divide(const Face f)
  {
    const bool result = is_to_divide(f);
    if(result)
      m_faces_to_divide.emplace(area(f), f);
    return result;
  }

  // The first edge that is the longest one on both sides, from the longest one of a face on.
  Halfedge longest_near(Face f) const
  {
    for(;;) {
      const Halfedge h = longest_side(f), o = m_mesh.opposite(h);
      if(m_mesh.is_border(o))
        return h;
      f = m_mesh.face(o);
      if(vector(longest_side(f)).squared_length() <= vector(h).squared_length())
        return h;
    }
  }

  void halve(const Halfedge h)
  {
    const Point middle = m_mesh.point(m_mesh.source(h)) + vector(h) / 2;
    const double size = (m_surface.sizes[m_mesh.source(h)] + m_surface.sizes[m_mesh.target(h)]) / 2;
    const Halfedge to_middle = m_surface.split_edge(h, middle, size);
    for(const Halfedge g : {to_middle, m_mesh.opposite(h)})
      if(!m_mesh.is_border(g))
        divide_face(g);
    for(const Halfedge g : CGAL::halfedges_around_target(to_middle, m_mesh))
      if(!m_mesh.is_border(g)) {
        push_if_to_divide(m_mesh.face(g));
        m_unchecked.push_back(m_mesh.edge(m_mesh.prev(g)));
      }
  }

  // One of four vertices, by an edge from the target of `h`.
  void divide_face(const Halfedge h)
  {
    const Face f = m_mesh.face(h);
    CGAL::Euler::split_face(h, m_mesh.next(m_mesh.next(h)), m_mesh);
    m_surface.mark_part_of(f);
  }

  // Between slivers, rounding could let flips go on; so they are counted.
  void flip()
  {
    while(!m_unchecked.empty()) {
      const Halfedge h = m_mesh.halfedge(m_unchecked.back()), o = m_mesh.opposite(h);
      m_unchecked.pop_back();
      if(m_number_of_flips >= m_most_flips || m_surface.is_wall(h) || !is_to_flip(h))
        continue;
      CGAL::Euler::flip_edge(h, m_mesh);
      ++m_number_of_flips;
      for(const Halfedge g : {h, o}) {
        push_if_to_divide(m_mesh.face(g));
        m_unchecked.push_back(m_mesh.edge(m_mesh.next(g)));
        m_unchecked.push_back(m_mesh.edge(m_mesh.prev(g)));
      }
    }
  }

  // Whether it is no Delaunay edge, in a plane. One that exists already is not made again.
  bool is_to_flip(const Halfedge h) const
  {
    const Halfedge o = m_mesh.opposite(h);
    if(m_surface.direction(m_mesh.face(h)) != m_surface.direction(m_mesh.face(o)) ||
       (m_surface.is_wall(m_mesh.next(h)) && m_surface.is_wall(m_mesh.prev(o))) ||
       (m_surface.is_wall(m_mesh.prev(h)) && m_surface.is_wall(m_mesh.next(o))))
      return false;
    const Vertex v = m_mesh.target(m_mesh.next(h)), w = m_mesh.target(m_mesh.next(o));
    const Point &a = m_mesh.point(m_mesh.source(h)), &b = m_mesh.point(m_mesh.target(h));
    return is_flat_and_not_Delaunay(a, b, m_mesh.point(v), m_mesh.point(w)) && v != w &&
           !CGAL::halfedge(v, w, m_mesh).second;
  }

  // Whether the triangles abp and baq face alike, as abp and baq and as pqb and qpa, the
  // lines ab and pq are near to each other, and the angles at p and q add up to more than 180
  // degrees.
  bool is_flat_and_not_Delaunay(const Point& a, const Point& b, const Point& p,
                                const Point& q) const
  {
    constexpr double rounding = 1e-9; // the error of a sine
    const Vector n = CGAL::cross_product(a - p, b - p), m = CGAL::cross_product(b - q, a - q);
    const double sine_p = std::sqrt(n.squared_length()), cosine_p = (a - p) * (b - p);
    const double sine_q = std::sqrt(m.squared_length()), cosine_q = (b - q) * (a - q);
    if(!(sine_p * cosine_q + sine_q * cosine_p <
         -rounding * std::hypot(sine_p, cosine_p) * std::hypot(sine_q, cosine_q)))
      return false;
    const Vector across = CGAL::cross_product(b - a, q - p), normal = n + m;
    return std::abs(across * (p - a)) <= m_height_of_flat * std::sqrt(across.squared_length()) &&
           n * m >= 0 && CGAL::cross_product(q - a, p - a) * normal > 0 &&
           CGAL::cross_product(p - b, q - b) * normal > 0;
  }

  Marked_surface& m_surface;
  Mesh& m_mesh;
  bool m_has_large_faces;
  std::size_t m_most_faces, m_most_flips, m_number_of_flips = 0;
  double m_area = 0, m_length = 0, m_height_of_flat = 0;
  std::priority_queue<std::pair<double, Face> > m_faces_to_divide; // the largest first
  std::vector<Edge> m_unchecked; // which may have to be flipped
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_REFINE_SURFACE_H
