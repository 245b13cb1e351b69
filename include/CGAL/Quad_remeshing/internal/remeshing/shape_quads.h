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

// Moves the vertices of a quad mesh along its surface, or along their feature or border, such that
// an energy falls: that of the shape of the quads, of their distance from the surface, and of the
// distance of edges from their lines.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Quad_star.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
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

// Invariant: vertices stay on the surface, and on the features and borders where they are; they do
// not move at all where these turn or meet.
class Quad_shaper
  : private Remeshing_types
{
public:
  // \param is_feature whether an edge is a feature or border
  Quad_shaper(const Mesh& quads, const Feature_map& is_feature, const Mesh& surface,
              const Feature_lines& lines, Quad_smoother& smoother)
    : m_quads(quads), m_is_feature(is_feature), m_lines(lines), m_smoother(smoother),
      m_star(quads, smoother), m_are_few(quads.number_of_faces() <= most_few),
      m_samples(surface, number_of_samples(quads.number_of_faces()))
  { }

  // All vertices, until little is gained, and at most about 50,000 quads in all, or one round. One
  // vertex after the other, the worst corners alone would soon not get better: so all corners count
  // at first.
  void shape_all(const std::size_t most_rounds)
  {
    const std::size_t affordable = 1 + most_quads / (1 + m_quads.number_of_faces());
    std::size_t rounds = (std::min)(most_rounds, affordable);
    const std::size_t last_rounds = rounds - rounds / 2;
    m_corners = Corners::ALL;
    while(rounds > last_rounds && move_all())
      --rounds;
    m_corners = Corners::WORST;
    while(rounds > 0 && move_all())
      --rounds;
  }

  // The vertices of thin quads, and those next to them, as long as this helps.
  void shape_thin_quads()
  {
    m_corners = Corners::THIN;
    m_last_move.assign(m_quads.num_vertices(), 0);
    m_last_try = m_last_move;
    for(std::size_t round = 0; round < most_rounds_of_thin; ++round) {
      const std::vector<Vertex> vertices = vertices_near_thin_quads();
      if(vertices.empty())
        return;
      m_forms = m_samples.distance_forms(m_quads, m_are_few);
      bool has_changed = false;
      for(const Vertex v : vertices) {
        m_star.collect({v});
        if(!is_worth_a_try(v))
          continue;
        m_last_try[v] = ++m_time;
        const double before = m_star.energy_around(0, m_corners);
        if(move(v, true) > part_of_gain * before) {
          m_last_move[v] = m_time;
          has_changed = true;
        }
      }
      if(!has_changed)
        return;
    }
  }

private:
  using Corners = Quad_star::Corners;

  static constexpr std::size_t most_samples = 20000; // samples of the distance
  static constexpr std::size_t most_quads = 50000; // quads, counted over all rounds
  static constexpr std::size_t most_few = 1000; // quads are few up to here
  static constexpr std::size_t most_rounds_of_thin = 10; // rounds over all thin quads
  static constexpr double weight_of_distance = 3, weight_of_lines = 4; // shape has the weight 1
  static constexpr double part_of_gain = 0.01; // less of the energy is little
  static constexpr double far_worse = 2; // as a ratio of energies

  // None where they would be few for each quad.
  static std::size_t number_of_samples(const std::size_t number_of_quads)
  {
    return number_of_quads <= most_samples / 3 ? (std::min)(20 * number_of_quads, most_samples) : 0;
  }

  // Returns whether more than a little was gained.
  bool move_all()
  {
    Progress::tell_each_second([&] { return "shaping " +
                                            counted(m_quads.number_of_faces(), "quad"); });
    m_forms = m_samples.distance_forms(m_quads, m_are_few);
    double gain = 0;
    for(const Vertex v : vertices(m_quads)) {
      m_star.collect({v});
      gain += (std::min)(1., move(v, false));
    }
    return gain >= 1e-3 * double(m_quads.number_of_faces());
  }

  // The vertices of thin quads, and their neighbors. The worst come first; otherwise their
  // neighbors adapt to them.
  std::vector<Vertex> vertices_near_thin_quads()
  {
    std::set<Vertex> vertices;
    for(const Face f : faces(m_quads)) {
      if(scaled_jacobian(m_smoother.quad(f)) >= thin_quad)
        continue;
      for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads)) {
        vertices.insert(v);
        for(const Vertex w : CGAL::vertices_around_target(v, m_quads))
          vertices.insert(w);
      }
    }
    std::vector<std::pair<double, Vertex> > order;
    for(const Vertex v : vertices) {
      m_star.collect({v});
      order.emplace_back(-m_star.energy_around(0, m_corners), v);
    }
    std::sort(order.begin(), order.end());
    std::vector<Vertex> result;
    for(const auto& [energy, v] : order)
      result.push_back(v);
    return result;
  }

  // Whether something around has changed since the vertex was tried last.
  bool is_worth_a_try(const Vertex v) const
  {
    for(const Face f : m_star.faces())
      for(const Vertex w : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
        if(m_last_move[w] >= m_last_try[v])
          return true;
    return false;
  }

  // To the best of places towards the rectangles of the quads around, and towards the surface; and
  // of places all around, if quads are few or thin, and the others gain little. Returns the gain.
  // \pre the star is that of the vertex
  double move(const Vertex v, const bool is_thin)
  {
    m_lines_at_vertex = lines_at_vertex(m_quads, m_is_feature, v);
    if(!m_lines_at_vertex.empty() && !goes_straight(m_quads, m_lines_at_vertex) &&
       !is_flat_and_straight_in_space(v))
      return 0;
    const Space_vector old = m_smoother.point(v);
    const Space_vector to_rectangles = vector_to(old, collect_rectangles(v));
    const Space_vector to_surface = m_forms[v].descent();
    const auto energy = [&](const Space_vector& p) {
      return m_star.energy_around(0, m_corners) + energy_of_lines(p) +
             weight_of_distance * m_forms[v].value(vector_to(old, p));
    };
    const double before = energy(old);
    double least = before;
    Space_vector best = old;
    const auto attempt = [&](const Space_vector& d) {
      Space_vector p{old[0] + d[0], old[1] + d[1], old[2] + d[2]};
      if(m_lines_at_vertex.empty()) {
        m_smoother.set_point(v, p);
        if(energy(p) > far_worse * before)
          return;
      }
      p = place(old, d);
      m_smoother.set_point(v, p);
      if(const double now = energy(p); now < least) {
        least = now;
        best = p;
      }
    };
    const auto attempt_both = [&](const double x, const double y) {
      attempt({x * to_rectangles[0] + y * to_surface[0], x * to_rectangles[1] + y * to_surface[1],
               x * to_rectangles[2] + y * to_surface[2]});
    };
    for(double step = 1.5; step > 0.3 && best == old; step /= 2) {
      attempt_both(step, 0);
      if(to_surface != Space_vector{}) {
        attempt_both(step, step);
        attempt_both(0, step);
      }
    }
    const double little = part_of_gain * (1 + before);
    if((is_thin || m_are_few) && before - least < little)
      for(double step = is_thin ? 0.8 : 0.4, goal = least - little / 10;
          step > 0.04 && least > goal; step /= 2) {
        const Space_vector from = vector_to(old, best);
        for(const Space_vector& d : directions(old, step))
          attempt({from[0] + d[0], from[1] + d[1], from[2] + d[2]});
      }
    m_smoother.set_point(v, best);
    return before - least;
  }

  // Eight, or along the line; as long as a part of an edge.
  std::vector<Space_vector> directions(const Space_vector& from, const double part) const
  {
    std::vector<Space_vector> result;
    if(m_lines_at_vertex.empty()) {
      const auto all = m_plane.directions(part * m_plane.longest_edge);
      result.assign(all.begin(), all.end());
    }
    for(const Halfedge h : m_lines_at_vertex)
      result.push_back(between({}, vector_to(from, m_smoother.point(m_quads.source(h))), part));
    return result;
  }

  // The place of the vertex on the surface, or on its feature line, between its two neighbors.
  Space_vector place(const Space_vector& from, const Space_vector& displacement) const
  {
    if(m_lines_at_vertex.empty())
      return m_smoother.surface().nearest(
        {from[0] + displacement[0], from[1] + displacement[1], from[2] + displacement[2]}, from);
    for(const Halfedge h : m_lines_at_vertex) {
      const Space_vector d = vector_to(from, m_smoother.point(m_quads.source(h)));
      const double length = norm(d), along = inner_product(d, displacement) / length;
      if(!(along > 0))
        continue;
      if(const auto p = m_lines.slide(to_point(from), m_quads.point(m_quads.source(h)),
                                      (std::min)(along, length / 2)))
        return to_vector(*p);
    }
    return from;
  }

  // Whether the line goes on up to 20 degrees, though it turns in the grid, at a flat quad.
  bool is_flat_and_straight_in_space(const Vertex v) const
  {
    if(m_lines_at_vertex.size() != 2 || m_star.energy_around(0, Corners::FLAT) == 0)
      return false;
    const Space_vector p = m_smoother.point(v);
    const auto direction = [&](const Halfedge h)
    { return scaled_to_one(vector_to(p, m_smoother.point(source(h, m_quads)))); };
    return inner_product(direction(m_lines_at_vertex[0]), direction(m_lines_at_vertex[1])) < -0.94;
  }

  // How far the edges along the line at `p` are from it, in units of their lengths, squared.
  double energy_of_lines(const Space_vector& p) const
  {
    double sum = 0;
    for(const Halfedge h : m_lines_at_vertex) {
      const Point a = to_point(p), &b = m_quads.point(m_quads.source(h));
      const double length = CGAL::squared_distance(a, b);
      if(length > 0)
        sum += m_lines.squared_distance(CGAL::midpoint(a, b)) / length;
    }
    return weight_of_lines * sum;
  }

  // Finds the plane of the star. Returns where the rectangles of its quads have the vertex, on the
  // average.
  Space_vector collect_rectangles(const Vertex v)
  {
    Space_vector result{};
    m_plane = m_smoother.visit_star(v, [&](const Face, const Quad& q, const Space_vector&) {
      const auto corner = std::find(q.begin(), q.end(), m_smoother.point(v)) - q.begin();
      const Quad rectangle = fitted_rectangle(q);
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += rectangle[std::size_t(corner)][c];
    });
    for(double& x : result)
      x /= double(m_star.faces().size());
    return result;
  }

  const Mesh& m_quads;
  Feature_map m_is_feature;
  const Feature_lines& m_lines;
  Quad_smoother& m_smoother;
  Quad_star m_star;
  Corners m_corners = Corners::ALL;
  bool m_are_few;
  Surface_samples m_samples;
  std::vector<Distance_form> m_forms; // per vertex
  std::vector<std::size_t> m_last_move, m_last_try; // per vertex: when
  std::size_t m_time = 0;
  // scratch: of the vertex that moves
  std::vector<Halfedge> m_lines_at_vertex;
  Star_plane m_plane;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_QUADS_H
