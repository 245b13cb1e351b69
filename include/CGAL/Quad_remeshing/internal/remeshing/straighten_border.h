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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_STRAIGHTEN_BORDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_STRAIGHTEN_BORDER_H

#include <CGAL/license/Quad_remeshing.h>

// Borders in steps that are smaller than quads, as of height fields that end along the cells of a
// grid. Each corner of a step would be the corner of a quad. So a map is made of other points:
// border points move to straight lines near by, and points inside follow.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the points of the surface stay.
class Border_straightener
  : private Remeshing_types
{
public:
  using Point_map = Mesh::Property_map<Vertex, Point>;

  // \param tolerance how far lines may be from the border
  // \param points the points of the map, at first the points of the surface
  Border_straightener(Marked_surface& surface, const double tolerance, const Point_map& points)
    : m_surface(surface), m_mesh(surface.mesh), m_tolerance(tolerance), m_points(points)
  { }

  // Loops are straightened where they have corners and no face turns over. Returns how many corners
  // are left out.
  template <typename Predicate>
  std::size_t run(const Predicate& is_fixed)
  {
    find_lines(is_fixed);
    if(m_lines.empty())
      return 0;
    divide_chords();
    find_vertices_near_by();
    constexpr int most_rounds = 8; // rounds of dropping lines at flips
    for(int round = 0; move(), drop_lines_at_flips(); ++round)
      if(round == most_rounds)
        for(Line& line : m_lines)
          line.is_dropped = true;
    std::size_t result = 0;
    for(const Line& line : m_lines)
      result += line.is_dropped ? 0 : line.number_of_corners;
    return result;
  }

private:
  // A straight line between two vertices of the border, with the vertices in between, and the
  // points to which these move.
  struct Line
  {
    std::vector<Vertex> vertices;
    std::vector<Point> points;
    std::size_t number_of_corners; // in between
    bool is_dropped;
  };

  template <typename Predicate>
  void find_lines(const Predicate& is_fixed)
  {
    std::vector<char> is_known(m_mesh.num_halfedges(), false);
    for(const Halfedge h : m_mesh.halfedges()) {
      if(!m_mesh.is_border(h) || is_known[std::size_t(h)])
        continue;
      m_loop.clear();
      for(const Halfedge g : CGAL::halfedges_around_face(h, m_mesh)) {
        is_known[std::size_t(g)] = true;
        m_loop.push_back(m_mesh.target(g));
      }
      const std::vector<std::size_t> ends = simplify(is_fixed);
      if(ends.size() < 3)
        continue;
      const std::size_t lines_before = m_lines.size();
      for(std::size_t i = 0; i < ends.size(); ++i)
        add_line(ends[i], i + 1 < ends.size() ? ends[i + 1] : ends[0] + m_loop.size());
      if(m_lines.size() > lines_before)
        find_isocurves();
    }
  }

  Vertex vertex(const std::size_t i) const { return m_loop[i % m_loop.size()]; }
  const Point& point(const std::size_t i) const { return m_mesh.point(vertex(i)); }

  // From one vertex of the loop to before another one.
  std::size_t number_of_corners(const std::size_t first, const std::size_t last) const
  {
    std::size_t result = 0;
    for(std::size_t i = first; i < last; ++i) {
      double angle = 0;
      for(const Halfedge h : CGAL::halfedges_around_target(vertex(i), m_mesh))
        if(!m_mesh.is_border(h))
          angle += angle_to_next(m_mesh, h);
      result += angle < flat_corner || angle > 360 - flat_corner ? 1 : 0;
    }
    return result;
  }

  // The vertices of the loop between which it is near to straight lines [Douglas and Peucker 1973].
  // Takes n log n steps for n vertices as a rule, and n^2 at most. Small loops stay loops.
  template <typename Predicate>
  std::vector<std::size_t> simplify(const Predicate& is_fixed)
  {
    const std::size_t n = m_loop.size();
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < n; ++i)
      if(is_fixed(m_loop[i]))
        result.push_back(i);
    const std::size_t first_of_loop = result.empty() ? farthest_from(0) : result[0];
    const std::size_t opposite = farthest_from(first_of_loop);
    if(result.empty())
      result.push_back(first_of_loop);
    if(result.size() == 1)
      result.push_back(opposite);
    const double tolerance =
      (std::min)(m_tolerance,
                 std::sqrt(CGAL::squared_distance(point(first_of_loop), point(opposite))) / 4);
    std::sort(result.begin(), result.end());
    std::vector<std::pair<std::size_t, std::size_t> > parts;
    for(std::size_t i = 0; i < result.size(); ++i)
      parts.push_back({result[i], i + 1 < result.size() ? result[i + 1] : result[0] + n});
    while(!parts.empty()) {
      const auto [first, last] = parts.back();
      parts.pop_back();
      const Kernel::Segment_3 s(point(first), point(last));
      std::size_t farthest = first;
      double square = tolerance * tolerance;
      for(std::size_t i = first + 1; i < last; ++i)
        if(const double d = CGAL::squared_distance(point(i), s); d > square) {
          square = d;
          farthest = i;
        }
      if(farthest == first)
        continue;
      result.push_back(farthest % n);
      parts.push_back({first, farthest});
      parts.push_back({farthest, last});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::size_t farthest_from(const std::size_t i) const
  {
    std::size_t result = i;
    for(std::size_t j = 0; j < m_loop.size(); ++j)
      if(CGAL::has_larger_distance_to_point(point(i), point(j), point(result)))
        result = j;
    return result;
  }

  // If there is a corner in between. Lengths have the same ratios on the line.
  void add_line(const std::size_t first, const std::size_t last)
  {
    Line line{{vertex(first)}, {point(first)}, number_of_corners(first + 1, last), false};
    std::vector<double> length{0};
    for(std::size_t i = first; i < last; ++i)
      length.push_back(length.back() + std::sqrt(CGAL::squared_distance(point(i), point(i + 1))));
    if(line.number_of_corners == 0 || length.back() == 0)
      return;
    for(std::size_t i = first + 1; i <= last; ++i) {
      m_lines_at[vertex(i - 1)].insert(m_lines.size());
      line.vertices.push_back(vertex(i));
      line.points.push_back(point(first) +
                            length[i - first] / length.back() * (point(last) - point(first)));
    }
    line.points.back() = point(last);
    m_lines_at[vertex(last)].insert(m_lines.size());
    move_border(line);
    m_lines.push_back(line);
  }

  // The parts of the loop between corners that are left, or longer ones where these are in doubt.
  void find_isocurves()
  {
    constexpr double surely_corner = 110; // degrees
    const std::size_t n = m_loop.size();
    const auto is_corner = [&](const std::size_t i) {
      return CGAL::approximate_angle(m_points[vertex(i + n - 1)], m_points[vertex(i)],
                                     m_points[vertex(i + 1)]) < surely_corner;
    };
    std::size_t first = 0;
    while(first < n && !is_corner(first))
      ++first;
    for(std::size_t i = first; i <= first + n; ++i) {
      m_isocurves_at[vertex(i)].insert(m_number_of_isocurves);
      if(is_corner(i) || i == first + n)
        m_isocurves_at[vertex(i)].insert(++m_number_of_isocurves);
    }
    ++m_number_of_isocurves;
  }

  void move_border(const Line& line)
  {
    for(std::size_t i = 0; i < line.vertices.size(); ++i)
      m_points[line.vertices[i]] = line.points[i];
  }

  // Edges inside between vertices of one isocurve, with which triangles would have no area: they
  // get a vertex in the middle.
  void divide_chords()
  {
    std::vector<Halfedge> chords;
    for(const Edge e : m_mesh.edges()) {
      const Halfedge h = m_mesh.halfedge(e);
      if(!m_surface.is_wall(h) && is_chord(h))
        chords.push_back(h);
    }
    for(const Halfedge h : chords)
      divide(h);
  }

  bool is_chord(const Halfedge h) const
  {
    const auto v = m_isocurves_at.find(m_mesh.source(h)),
               w = m_isocurves_at.find(m_mesh.target(h));
    return v != m_isocurves_at.end() && w != m_isocurves_at.end() &&
           std::any_of(v->second.begin(), v->second.end(), [&](const std::size_t isocurve)
                       { return w->second.count(isocurve) > 0; });
  }

  // The edge, and the two faces at it.
  void divide(const Halfedge h)
  {
    const Vertex v = m_mesh.source(h), w = m_mesh.target(h);
    const Halfedge to_middle =
      m_surface.split_edge(h, CGAL::midpoint(m_mesh.point(v), m_mesh.point(w)),
                           (m_surface.sizes[v] + m_surface.sizes[w]) / 2);
    for(const Halfedge g : {to_middle, m_mesh.opposite(h)}) {
      const Face f = m_mesh.face(g);
      CGAL::Euler::split_face(g, m_mesh.next(m_mesh.next(g)), m_mesh);
      m_surface.mark_part_of(f);
    }
  }

  // Finds the vertices inside, the nearest to lines first, each with its nearest lines.
  void find_vertices_near_by()
  {
    constexpr double farthest = 4; // tolerances
    using Entry = std::pair<double, std::pair<Vertex, Vertex> >; // of the border, and inside
    std::priority_queue<Entry, std::vector<Entry>, std::greater<> > queue;
    for(const auto& [v, lines] : m_lines_at)
      queue.push({0, {v, v}});
    std::set<Vertex> is_known;
    while(!queue.empty()) {
      const double distance = queue.top().first;
      const auto [origin, v] = queue.top().second;
      queue.pop();
      if(!is_known.insert(v).second)
        continue;
      if(v != origin)
        m_lines_at[v] = m_lines_at[origin];
      if(v != origin && !has_wall(v)) {
        m_inside.push_back(v);
        m_weights.push_back(mean_value_weights(v));
      }
      for(const Vertex w : CGAL::vertices_around_target(v, m_mesh)) {
        const double sum =
          distance + std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(w)));
        if(sum < farthest * m_tolerance)
          queue.push({sum, {origin, w}});
      }
    }
  }

  bool has_wall(const Vertex v) const
  {
    const auto edges = m_mesh.halfedges_around_target(m_mesh.halfedge(v));
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Halfedge h) { return m_surface.is_wall(h); });
  }

  // Weights of the neighbors of a vertex, whose sum is 1 [Floater 2003].
  std::vector<std::pair<Vertex, double> > mean_value_weights(const Vertex v) const
  {
    constexpr double widest = 179; // degrees, the widest angle at a vertex
    const auto tangent = [&](const Halfedge h) // of half of the angle to the next edge
    { return std::tan((std::min)(angle_to_next(m_mesh, h), widest) * CGAL_PI / 360); };
    std::vector<std::pair<Vertex, double> > result;
    double sum = 0;
    for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh)) {
      const Vertex w = m_mesh.source(h);
      const double length = std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(w)));
      if(!(length > 0))
        return {{w, 1.}};
      result.push_back({w, (tangent(h) + tangent(m_mesh.prev(m_mesh.opposite(h)))) / length});
      sum += result.back().second;
    }
    if(!(sum > 0))
      return {};
    for(auto& [w, weight] : result)
      weight /= sum;
    return result;
  }

  // The border to its lines, and what is inside by a mean of what its neighbors do, so that what is
  // flat stays so, and inside; features and what is farther stay.
  void move()
  {
    constexpr int number_of_rounds = 50; // rounds of moving the vertices inside
    for(const auto& [v, lines] : m_lines_at)
      m_points[v] = m_mesh.point(v);
    for(const Line& line : m_lines)
      if(!line.is_dropped)
        move_border(line);
    for(int round = 0; round < number_of_rounds; ++round)
      for(std::size_t i = 0; i < m_inside.size(); ++i) {
        Vector sum(0, 0, 0);
        for(const auto& [w, weight] : m_weights[i])
          sum = sum + weight * (m_points[w] - m_mesh.point(w));
        m_points[m_inside[i]] = m_mesh.point(m_inside[i]) + sum;
      }
  }

  // Drops the lines that are nearest to flipped faces. Returns whether there are any.
  bool drop_lines_at_flips()
  {
    bool result = false;
    for(const Face f : m_mesh.faces()) {
      const Halfedge h = m_mesh.halfedge(f);
      const Vector before = normal(h, m_mesh.points());
      if(before == CGAL::NULL_VECTOR || before * normal(h, m_points) > 0)
        continue;
      for(const Vertex v : CGAL::vertices_around_face(h, m_mesh))
        if(const auto found = m_lines_at.find(v); found != m_lines_at.end())
          for(const std::size_t i : found->second) {
            result = result || !m_lines[i].is_dropped;
            m_lines[i].is_dropped = true;
          }
    }
    return result;
  }

  Vector normal(const Halfedge h, const Point_map& points) const
  {
    return CGAL::normal(points[m_mesh.source(h)], points[m_mesh.target(h)],
                        points[m_mesh.target(m_mesh.next(h))]);
  }

  Marked_surface& m_surface;
  Mesh& m_mesh;
  double m_tolerance;
  Point_map m_points;
  std::vector<Vertex> m_loop; // of the border, in the order of its halfedges
  std::vector<Line> m_lines;
  std::map<Vertex, std::set<std::size_t> > m_lines_at; // of the border, or nearest to it
  std::map<Vertex, std::set<std::size_t> > m_isocurves_at; // of the border
  std::size_t m_number_of_isocurves = 0;
  std::vector<Vertex> m_inside;                        // vertices that may move
  std::vector<std::vector<std::pair<Vertex, double> > > m_weights; // of their neighbors
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_STRAIGHTEN_BORDER_H
