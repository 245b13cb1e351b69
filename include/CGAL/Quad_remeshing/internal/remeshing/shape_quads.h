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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Moves the vertices of a quad mesh along the surface that it was made from, toward where their
// quads are rectangles and near the surface. Smoothing looks at neighbors only, which does for
// small quads.

#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// With the same middle, and sides as long as the lines between the middles of the quad's sides;
// both are turned by the same angle until they are perpendicular.
inline std::array<Space_vector, 4> fitted_rectangle(const std::array<Space_vector, 4>& q)
{
  Space_vector u{}, v{}, middle{};
  for(std::size_t c = 0; c < 3; ++c) {
    u[c] = (q[1][c] + q[2][c] - q[0][c] - q[3][c]) / 4;
    v[c] = (q[2][c] + q[3][c] - q[0][c] - q[1][c]) / 4;
    middle[c] = (q[0][c] + q[1][c] + q[2][c] + q[3][c]) / 4;
  }
  const double a = norm(u), b = norm(v);
  if(a == 0 || b == 0)
    return q;
  Space_vector sum{}, difference{};
  for(std::size_t c = 0; c < 3; ++c) {
    sum[c] = u[c] / a + v[c] / b;
    difference[c] = u[c] / a - v[c] / b;
  }
  const double s = norm(sum) * std::sqrt(2.), d = norm(difference) * std::sqrt(2.);
  if(s == 0 || d == 0)
    return q;
  std::array<Space_vector, 4> result;
  for(std::size_t c = 0; c < 3; ++c) {
    const double x = a * (sum[c] / s + difference[c] / d);
    const double y = b * (sum[c] / s - difference[c] / d);
    result[0][c] = middle[c] - x - y;
    result[1][c] = middle[c] + x - y;
    result[2][c] = middle[c] + x + y;
    result[3][c] = middle[c] - x + y;
  }
  return result;
}

// Invariant: vertices that are held stay where they are, all others on the surface. No quad turns
// over.
class Quad_shaper
{
  using Mesh = Surface_to_remesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;
  using Quad = Quad_smoother::Quad;

public:
  Quad_shaper(const Mesh& quads, const Mesh& surface, Quad_smoother& smoother)
    : m_quads(quads), m_smoother(smoother),
      m_samples(surface, number_of_samples(quads.number_of_faces()))
  { }

  // Until little is gained, and at most about 100,000 quads in all, or one round.
  // is_held(vertex) tells which vertices stay.
  template <typename Is_held>
  void run(const std::size_t most_rounds, const Is_held& is_held)
  {
    const std::size_t affordable = 1 + most_quads / (1 + m_quads.number_of_faces());
    for(std::size_t round = 0; round < (std::min)(most_rounds, affordable); ++round) {
      m_forms = m_samples.distance_forms(m_quads);
      double gain = 0;
      for(const Vertex v : vertices(m_quads))
        if(!is_held(v))
          gain += move(v);
      if(gain < 1e-3 * double(m_quads.number_of_faces()))
        return;
    }
  }

private:
  static constexpr std::size_t most_samples = 20000, most_quads = 100000;
  static constexpr double weight_of_distance = 2, turned_over = 1e100;

  // None where they would be few for each quad.
  static std::size_t number_of_samples(const std::size_t number_of_quads)
  {
    return number_of_quads <= most_samples / 3 ? (std::min)(20 * number_of_quads, most_samples) : 0;
  }

  // Returns by how much the quads around have become better.
  double move(const Vertex v)
  {
    const Space_vector old = m_smoother.point(v);
    const Space_vector to_rectangles = vector_to(old, collect_star(v));
    const Space_vector to_surface = m_forms[v].descent();
    const double before = badness();
    double least = before;
    Space_vector best = old;
    const auto attempt = [&](const double x, const double y) {
      Space_vector p = old;
      for(std::size_t c = 0; c < 3; ++c)
        p[c] += x * to_rectangles[c] + y * to_surface[c];
      p = m_smoother.nearest(p, old);
      m_smoother.set_point(v, p);
      const double now = badness() + weight_of_distance * m_forms[v].value(vector_to(old, p));
      if(now < least) {
        least = now;
        best = p;
      }
    };
    for(double step = 1.5; step > 0.3 && best == old; step /= 2) {
      attempt(step, 0);
      if(to_surface != Space_vector{}) {
        attempt(step, step);
        attempt(0, step);
      }
    }
    m_smoother.set_point(v, best);
    return before - least;
  }

  // Collects the quads around a vertex. Returns where their rectangles have it, on the average.
  Space_vector collect_star(const Vertex v)
  {
    Space_vector result{};
    m_faces.clear();
    m_normals.clear();
    for(const auto h : CGAL::halfedges_around_target(v, m_quads)) {
      m_faces.push_back(face(h, m_quads));
      const Quad q = m_smoother.quad(m_faces.back());
      m_normals.push_back(quad_normal(q));
      const auto corner = std::find(q.begin(), q.end(), m_smoother.point(v)) - q.begin();
      const Quad rectangle = fitted_rectangle(q);
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += rectangle[std::size_t(corner)][c];
    }
    for(double& x : result)
      x /= double(m_faces.size());
    return result;
  }

  // Thin quads count more than twice as much as their scaled Jacobians tell.
  double badness() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      const Quad q = m_smoother.quad(m_faces[i]);
      const Space_vector normal = quad_normal(q);
      if(inner_product(normal, m_normals[i]) <= 0)
        return turned_over;
      const double x = 1 - scaled_jacobian(q, normal);
      sum += x + x * x;
    }
    return sum;
  }

  const Mesh& m_quads;
  Quad_smoother& m_smoother;
  Surface_samples m_samples;
  std::vector<Distance_form> m_forms; // per vertex
  // scratch: of the vertex that moves
  std::vector<Face> m_faces;
  std::vector<Space_vector> m_normals;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_QUADS_H
