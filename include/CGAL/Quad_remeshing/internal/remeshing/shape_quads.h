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
// quads come close to rectangles and to the surface. Smoothing looks at neighbors only, which is
// enough for small quads. If there are few quads, places all around are tried, too, and parts of
// the surface that are cut off count more.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
// not move at all where these turn or meet. No quad turns over.
class Quad_shaper
  : private Remeshing_types
{
public:
  // \param is_feature whether an edge is a feature or border
  Quad_shaper(const Mesh& quads, const Feature_map& is_feature, const Mesh& surface,
              const Feature_lines& lines, Quad_smoother& smoother)
    : m_quads(quads), m_is_feature(is_feature), m_lines(lines), m_smoother(smoother),
      m_are_few(quads.number_of_faces() <= most_few),
      m_samples(surface, number_of_samples(quads.number_of_faces()))
  { }

  // Until little is gained, and at most about 50,000 quads in all, or one round. One vertex after
  // the other, the worst corners alone would soon not get better: so all corners count at first.
  void run(const std::size_t most_rounds)
  {
    const std::size_t affordable = 1 + most_quads / (1 + m_quads.number_of_faces());
    std::size_t rounds = (std::min)(most_rounds, affordable);
    const std::size_t last_rounds = rounds - rounds / 2;
    m_all_corners_count = true;
    while(rounds > last_rounds && move_all())
      --rounds;
    m_all_corners_count = false;
    while(rounds > 0 && move_all())
      --rounds;
  }

private:
  static constexpr std::size_t most_samples = 20000; // samples of the distance
  static constexpr std::size_t most_quads = 50000; // quads, counted over all rounds
  static constexpr std::size_t most_few = 1000; // quads are few up to here
  static constexpr double weight_of_distance = 2, weight_of_lines = 4; // shape has the weight 1
  static constexpr double turned_over = 1e100; // the badness of an inverted quad
  static constexpr double little = 0.01, enough = 0.001; // badness

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
    for(const Vertex v : vertices(m_quads))
      gain += move(v);
    return gain >= 1e-3 * double(m_quads.number_of_faces());
  }

  // Returns by how much the quads around have become better.
  double move(const Vertex v)
  {
    m_lines_at_vertex = lines_at_vertex(m_quads, m_is_feature, v);
    if(!m_lines_at_vertex.empty() && !goes_straight(m_quads, m_lines_at_vertex))
      return 0;
    const Space_vector old = m_smoother.point(v);
    const Space_vector to_rectangles = vector_to(old, collect_star(v));
    const Space_vector to_surface = m_forms[v].descent();
    const double before = badness() + badness_of_lines(old);
    double least = before;
    Space_vector best = old;
    const auto attempt = [&](const Space_vector& d) {
      const Space_vector p = place(old, d);
      m_smoother.set_point(v, p);
      const double now = badness() + badness_of_lines(p) +
                         weight_of_distance * m_forms[v].value(vector_to(old, p));
      if(now < least) {
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
    if(m_are_few && m_lines_at_vertex.empty() && before - least < little)
      for(double step = 0.4, goal = least - enough; step > 0.04 && least > goal; step /= 2)
        for(const Space_vector& d : m_plane.directions(step * m_plane.longest_edge))
          attempt({best[0] - old[0] + d[0], best[1] - old[1] + d[1], best[2] - old[2] + d[2]});
    m_smoother.set_point(v, best);
    return before - least;
  }

  // The place of the vertex on the surface, or on its feature line, between its two neighbors.
  Space_vector place(const Space_vector& from, const Space_vector& displacement) const
  {
    if(m_lines_at_vertex.empty())
      return m_smoother.nearest({from[0] + displacement[0], from[1] + displacement[1],
                                 from[2] + displacement[2]}, from);
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

  // How far the edges along the line at `p` are from it, in units of their lengths, squared.
  double badness_of_lines(const Space_vector& p) const
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

  // Collects the quads around a vertex. Returns where their rectangles have it, on the average.
  Space_vector collect_star(const Vertex v)
  {
    Space_vector result{};
    m_faces.clear();
    m_normals.clear();
    m_plane = m_smoother.visit_star(v, [&](const Face f, const Quad& q, const Space_vector& n) {
      m_faces.push_back(f);
      m_normals.push_back(n);
      const auto corner = std::find(q.begin(), q.end(), m_smoother.point(v)) - q.begin();
      const Quad rectangle = fitted_rectangle(q);
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += rectangle[std::size_t(corner)][c];
    });
    for(double& x : result)
      x /= double(m_faces.size());
    return result;
  }

  // The badness of long sides. Angles don't see them: for angles alone, a vertex on a line would
  // halve the edge to its end in each round.
  static double badness_of_sides(const Quad& q)
  {
    constexpr double long_side = 20, weight = 0.05, least_square = 1e-100; // sides over others
    double shortest = std::numeric_limits<double>::infinity(), longest = least_square;
    for(std::size_t i = 0; i < 4; ++i) {
      const double squared = squared_distance(q[i], q[(i + 1) % 4]);
      shortest = (std::min)(shortest, squared);
      longest = (std::max)(longest, squared);
    }
    const double ratio = longest / (std::max)(shortest, least_square) / (long_side * long_side);
    return ratio > 1 ? weight * std::log(ratio) / 2 : 0;
  }

  // By their worst corners, or by all: but where one is inverted, it counts alone, as others could
  // make up for it. Thin quads count more than twice as much.
  double badness() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      const Quad q = m_smoother.quad(m_faces[i]);
      const Space_vector normal = quad_normal(q);
      if(inner_product(normal, m_normals[i]) <= 0)
        return turned_over;
      const std::array<double, 4> sines = sines_of_angles(q, normal);
      const double least = *std::min_element(sines.begin(), sines.end());
      const double x = 1 - (m_all_corners_count && least > 0
                              ? (sines[0] + sines[1] + sines[2] + sines[3]) / 4 : least);
      sum += x + x * x + badness_of_sides(q);
    }
    return sum;
  }

  const Mesh& m_quads;
  Feature_map m_is_feature;
  const Feature_lines& m_lines;
  Quad_smoother& m_smoother;
  bool m_all_corners_count = false;
  bool m_are_few;
  Surface_samples m_samples;
  std::vector<Distance_form> m_forms; // per vertex
  // scratch: of the vertex that moves
  std::vector<Halfedge> m_lines_at_vertex;
  std::vector<Face> m_faces;
  std::vector<Space_vector> m_normals;
  Star_plane m_plane;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SHAPE_QUADS_H
