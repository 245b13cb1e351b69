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
#include <CGAL/Quad_remeshing/internal/remeshing/Shape_counter.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_locator.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  Quad_smoother(Mesh& quads, const Surface_locator& surface)
    : m_quads(quads), m_surface(surface),
      m_upper_sides(quads.add_property_map<Face, Space_vector>("f:upper_side").first),
      m_number_of_searches_before(surface.number_of_searches())
  { }

  const Surface_locator& surface() const { return m_surface; }

  // For the nearest places on the surface, which take most of the time.
  std::size_t number_of_searches() const
  { return m_surface.number_of_searches() - m_number_of_searches_before; }

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
            set_point(v, m_surface.nearest(middle_of_neighbors(v), point(v)));
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
    Surface_locator::Largest_distance result = m_surface.largest_distance();
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
    return is_inverted(q) || inner_product(quad_normal(q), m_upper_sides[f]) < 0 ||
           has_corner_against(q, m_upper_sides[f], slightly_against);
  }

private:
  static constexpr double well_shaped = 0.3; // as a scaled Jacobian

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
    set_point(v, m_surface.nearest(middle, old));
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
  const Surface_locator& m_surface;
  Mesh::Property_map<Face, Space_vector> m_upper_sides;
  std::size_t m_number_of_searches_before;
  std::vector<Face> m_faces;           // scratch
  std::vector<Space_vector> m_normals; // scratch: of these faces
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SMOOTH_QUADS_H
