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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SMOOTH_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SMOOTH_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Moves the vertices of a quad mesh along the surface that it was made from, toward the middle of
// their neighbors; and measures the result. All of this is floating point.

#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Shape_counter.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The plane of a vertex star: the sum of the normals, one edge, and the length of the longest one.
struct Star_plane
{
  Space_vector normal{}, side{};
  double longest_edge = 0;

  // Eight vectors perpendicular to the normal, the first one to the side, too.
  std::array<Space_vector, 8> directions(const double length) const
  {
    const Space_vector u = scaled_to_one(vector_product(normal, side));
    const Space_vector v = scaled_to_one(vector_product(normal, u));
    std::array<Space_vector, 8> result;
    for(std::size_t i = 0; i < 8; ++i) {
      const double angle = double(i) * std::acos(0.) / 2;
      for(std::size_t c = 0; c < 3; ++c)
        result[i][c] = length * (std::cos(angle) * u[c] + std::sin(angle) * v[c]);
    }
    return result;
  }
};

// Where a quad is to face: where the surface does beside it. One that does not face there, as on
// sharp edges, is not to turn from where it does; one without area faces nowhere.
inline Space_vector upper_side_or_own(const Quad_in_space& q,
                                      const Space_vector& normal_of_surface)
{
  const Space_vector own = quad_normal(q);
  return own == Space_vector{} || inner_product(own, normal_of_surface) > 0 ? normal_of_surface
                                                                            : own;
}

// Invariant: vertices that are held stay where they are, all others on the surface.
class Quad_smoother
  : public Remeshing_types
{
public:
  Quad_smoother(Mesh& quads, const Mesh& surface)
    : m_quads(quads), m_surface(surface),
      m_upper_sides(quads.add_property_map<Face, Space_vector>("f:upper_side").first)
  {
    std::vector<Space_triangle> triangles;
    const auto add_if = [&](const auto& is_wanted) {
      for(const Face f : surface.faces())
        if(const Space_triangle t = triangle_of(surface, f); is_wanted(t)) {
          triangles.push_back(t);
          m_searched.push_back(f);
        }
    };
    add_if([](const Space_triangle& t) // the points of others lie on these, too
           { return !CGAL::collinear(to_point(t[0]), to_point(t[1]), to_point(t[2])); });
    if(triangles.empty())
      add_if([](const Space_triangle&) { return true; });
    m_tree = Tree(triangles);
  }

  // For the nearest places on the surface, which take most of the time.
  std::size_t number_of_searches() const { return m_tree.number_of_searches(); }

  // If more than a tenth of the quads are inverted, as in a map that is much distorted:
  // vertices move to the middle of their neighbors, whatever becomes of quads on the way, as long
  // as some are inverted, the mean shape gets better, and quads don't shrink to half of their area,
  // as few can, to a point in the end; at most 100 rounds.
  template <typename Is_held>
  void unfold(const Is_held& is_held)
  {
    constexpr int most_blocks = 10, rounds = 10; // blocks of rounds of unfolding
    std::size_t number = number_of_inverted_quads();
    if(10 * number <= m_quads.number_of_faces())
      return;
    double jacobian = shapes().mean_scaled_jacobian;
    const double least_area = area() / 2;
    for(int block = 0; block < most_blocks && number > 0; ++block) {
      const std::vector<Point> points(m_quads.points().begin(), m_quads.points().end());
      for(int round = 0; round < rounds; ++round)
        for(const Vertex v : vertices(m_quads))
          if(!is_held(v))
            set_point(v, nearest(middle_of_neighbors(v), point(v)));
      const double new_jacobian = shapes().mean_scaled_jacobian;
      if(new_jacobian <= jacobian || area() < least_area) {
        std::copy(points.begin(), points.end(), m_quads.points().begin());
        return;
      }
      jacobian = new_jacobian;
      number = number_of_inverted_quads();
    }
  }

  // Makes no quad worse than it is, unless it stays well shaped. is_held(vertex) tells which
  // vertices stay.
  template <typename Is_held>
  void smooth(const std::size_t number_of_rounds, const Is_held& is_held)
  {
    for(std::size_t round = 0; round < number_of_rounds; ++round)
      for(const Vertex v : vertices(m_quads))
        if(!is_held(v))
          move(v);
  }

  Quad_shapes shapes() const
  {
    Shape_counter counter;
    std::size_t i = 0;
    for(const Face f : faces(m_quads))
      counter.add(i++, quad(f));
    return counter.shapes();
  }

  double area() const
  {
    double result = 0;
    for(const Face f : faces(m_quads))
      result += norm(quad_normal(quad(f))) / 2;
    return result;
  }

  std::size_t number_of_inverted_quads() const
  {
    const auto all = faces(m_quads);
    return std::size_t(std::count_if(all.begin(), all.end(),
                                     [&](const Face f) { return is_inverted(quad(f)); }));
  }

  // The largest distance from the surface of the vertices and of a grid of points in each quad: its
  // middle and the middles of its edges, and more points if quads are few.
  double measure_distance() const
  {
    constexpr std::size_t enough_points = 100000; // samples in all
    constexpr std::size_t most_parts = 64; // parts of the side of a quad
    std::size_t n = 2;
    while(n < most_parts && m_quads.number_of_faces() * (2 * n) * (2 * n) <= enough_points)
      n *= 2;
    const auto part = [&](const std::size_t i) { return double(i) / double(n); };
    Tree::Largest_distance result(m_tree);
    for(const Vertex v : vertices(m_quads))
      result.add(point(v));
    for(const Face f : faces(m_quads)) {
      const Quad q = quad(f);
      for(std::size_t i = 1; i < n; ++i)
        for(std::size_t j = 1; j < n; ++j)
          result.add(between(between(q[0], q[1], part(i)), between(q[3], q[2], part(i)), part(j)));
    }
    for(const auto e : edges(m_quads))
      for(std::size_t i = 1; i < n; ++i)
        result.add(between(point(source(e, m_quads)), point(target(e, m_quads)), part(i)));
    return result.value();
  }

  Space_vector point(const Vertex v) const { return to_vector(m_quads.point(v)); }
  void set_point(const Vertex v, const Space_vector& p) { m_quads.point(v) = to_point(p); }

  Quad quad(const Face f) const
  {
    Quad result;
    std::size_t i = 0;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      result[i++] = point(v);
    return result;
  }

  Space_vector middle_of_neighbors(const Vertex v) const
  {
    Space_vector result{};
    for(const Vertex w : CGAL::vertices_around_target(v, m_quads)) {
      const Space_vector p = point(w);
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += p[c];
    }
    for(double& x : result)
      x /= double(m_quads.degree(v));
    return result;
  }

  // Calls visit(face, quad, normal) for the quads around a vertex.
  template <typename Visit>
  Star_plane visit_star(const Vertex v, const Visit& visit) const
  {
    Star_plane result;
    for(const auto h : CGAL::halfedges_around_target(v, m_quads)) {
      result.side = vector_to(point(v), point(source(h, m_quads)));
      result.longest_edge = (std::max)(result.longest_edge, norm(result.side));
      if(m_quads.is_border(h))
        continue;
      const Quad q = quad(face(h, m_quads));
      const Space_vector normal = quad_normal(q);
      for(std::size_t c = 0; c < 3; ++c)
        result.normal[c] += normal[c];
      visit(face(h, m_quads), q, normal);
    }
    return result;
  }

  // Where quads are to face that are inverted or upside down; 0 elsewhere.
  Mesh::Property_map<Face, Space_vector> upper_sides() const { return m_upper_sides; }

  bool is_bad(const Face f) const
  {
    const Quad q = quad(f);
    return is_inverted(q) || inner_product(quad_normal(q), m_upper_sides[f]) < 0;
  }

  // The nearest point of the surface.
  Space_vector nearest(const Space_vector& p) const { return m_tree.nearest(p).point; }

  // A faster search for it, which begins at another point of the surface.
  Space_vector nearest(const Space_vector& p, const Space_vector& near_by) const
  { return m_tree.nearest(p, near_by); }

  Face nearest_face(const Space_vector& p) const
  { return m_searched[m_tree.nearest(p).element]; }

  // The nearest face. If two faces lie on each other and face to opposite sides, because bodies
  // touch, the one that faces to `side`.
  Face nearest_face(const Space_vector& p, const Space_vector& side) const
  { return nearest_face(p, side, distance_of_same_place, cosine_of_opposite_sides); }

  // Also of two farther from each other, such as the sides of a plate that is thin against quads.
  Face nearest_face(const Space_vector& p, const Space_vector& side, const double distance) const
  { return nearest_face(p, side, distance, cosine_of_plate); }

  // The area vector, times two, of the triangle that is nearest to the middle of a quad.
  Space_vector normal_of_surface(const Quad& q) const
  {
    std::array<double, 3> middle{};
    for(const Space_vector& p : q)
      for(std::size_t c = 0; c < 3; ++c)
        middle[c] += p[c] / 4;
    return normal_of_surface(nearest_face(middle, quad_normal(q)));
  }

  Space_vector normal_of_surface(const Face f) const
  { return area_vector(triangle_of(m_surface, f)); }

  // The normal of a surface that is a plane, or parallel planes that face to one side; else 0.
  Space_vector unit_normal_of_plane() const
  {
    constexpr double rounding = 1e-9; // the error of a unit normal
    Space_vector sum{};
    double size = 0;
    for(const Face f : faces(m_surface)) {
      const Space_vector normal = normal_of_surface(f);
      size += norm(normal);
      for(std::size_t c = 0; c < 3; ++c)
        sum[c] += normal[c];
    }
    return norm(sum) > (1 - rounding) * size ? scaled_to_one(sum) : Space_vector{};
  }

private:
  using Tree = Nearest_place_tree<Space_triangle>;

  // \param largest_cosine of the angle between the normals of the two
  Face nearest_face(const Space_vector& p, const Space_vector& side, const double distance,
                    const double largest_cosine) const
  {
    const auto place = m_tree.nearest(p);
    const Face nearest = m_searched[place.element];
    const Space_vector normal = scaled_to_one(normal_of_surface(nearest));
    if(inner_product(normal, side) >= 0)
      return nearest;
    Space_segment s;
    for(std::size_t c = 0; c < 3; ++c) {
      s[0][c] = place.point[c] - distance * normal[c];
      s[1][c] = place.point[c] + distance * normal[c];
    }
    const Kernel::Segment_3 segment(to_point(s[0]), to_point(s[1]));
    if(segment.is_degenerate()) // far from the origin
      return nearest;
    Face result = nearest;
    double least = std::numeric_limits<double>::infinity();
    m_tree.visit_near(s, [&](const std::size_t i) {
      const Space_triangle t = triangle_of(m_surface, m_searched[i]);
      const Space_vector other = scaled_to_one(area_vector(t));
      const double cosine = inner_product(other, normal);
      const Kernel::Triangle_3 triangle(to_point(t[0]), to_point(t[1]), to_point(t[2]));
      if(!(cosine < largest_cosine && inner_product(other, side) > 0) || triangle.is_degenerate() ||
         !CGAL::do_intersect(segment, triangle))
        return;
      const double along_normal =
        std::abs(inner_product(vector_to(place.point, t[0]), other) / cosine);
      if(along_normal < least) {
        least = along_normal;
        result = m_searched[i];
      }
    });
    return result;
  }

  static constexpr double well_shaped = 0.3; // as a scaled Jacobian
  static constexpr double distance_of_same_place = 1e-3; // on a surface of a size near 1
  static constexpr double cosine_of_opposite_sides = -0.999, cosine_of_plate = -0.1; // of normals

  void move(const Vertex v)
  {
    m_faces.clear();
    m_normals.clear();
    double before = well_shaped;
    for(const auto h : CGAL::halfedges_around_target(v, m_quads)) {
      m_faces.push_back(face(h, m_quads));
      const Quad q = quad(m_faces.back());
      m_normals.push_back(quad_normal(q));
      before = (std::min)(before, scaled_jacobian(q, m_normals.back()));
    }
    const Space_vector old = point(v);
    Space_vector middle = middle_of_neighbors(v);
    for(std::size_t c = 0; c < 3; ++c)
      middle[c] = (old[c] + middle[c]) / 2;
    set_point(v, nearest(middle, old));
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      const Quad q = quad(m_faces[i]);
      const Space_vector normal = quad_normal(q);
      if(scaled_jacobian(q, normal) < before || inner_product(normal, m_normals[i]) <= 0) {
        set_point(v, old);
        return;
      }
    }
  }

  Mesh& m_quads;
  const Mesh& m_surface;
  Mesh::Property_map<Face, Space_vector> m_upper_sides;
  Tree m_tree;
  std::vector<Face> m_searched; // of its triangles
  std::vector<Face> m_faces;           // scratch
  std::vector<Space_vector> m_normals; // scratch: of these faces
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SMOOTH_QUADS_H
