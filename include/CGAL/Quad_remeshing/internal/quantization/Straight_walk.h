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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRAIGHT_WALK_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRAIGHT_WALK_H

#include <CGAL/license/Quad_remeshing.h>

// From a vertex of the input straight to a point of a coarse triangle, through the faces of the
// input. The way lies in one flat triangle, so that nothing but the surface's own geometry decides
// where it leads; all decisions are exact signs.

#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The end of the way, as seen from its start: (weight[0] side[0] + weight[1] side[1]) / total.
struct Straight_target
{
  std::array<Grid_vector, 2> side{};
  std::array<std::int64_t, 2> weight{}; // not negative
  std::int64_t total = 1;               // positive
};

// Invariant: the target is in the chart of the face where the walk is.
class Straight_walk
{
public:
  Straight_walk(const Integer_mesh& mesh, const Straight_target& target)
    : m_mesh(mesh), m_target(target)
  { }

  // `corner` is one at the start, less than 180 degrees clockwise of the target; the sides are in
  // the chart of its face.
  Face_point run(Corner_index corner)
  {
    if(m_target.weight[0] == 0 && m_target.weight[1] == 0)
      return point_at_vertex(corner);
    Grid_vector position{0, 0};
    for(;;) {
      turn(corner, position);
      if(leave_vertex(corner, position))
        return m_location;
    }
  }

private:
  // Signs of a x (target - b) and of component c of target - b, times the total.
  int cross_with_target(const Grid_vector& a, const Grid_vector& b) const
  {
    const double size = size_estimate(a) + total() * (std::abs(double(a[0]) * double(b[1])) +
                                                      std::abs(double(a[1]) * double(b[0])));
    return sign(dot_estimate(a), total() * approximate_cross(a, b), size, [&] {
      return difference(
        exact_sum(exact_cross(a, m_target.side[0]), exact_cross(a, m_target.side[1])),
        product(from_64_bits<Exact_integer>(m_target.total), exact_cross(a, b)));
    });
  }

  int component_beyond(const std::size_t c, const Grid_vector& b) const
  {
    const double x = weight(0) * static_cast<double>(m_target.side[0][c]);
    const double y = weight(1) * static_cast<double>(m_target.side[1][c]);
    const double z = total() * static_cast<double>(b[c]);
    return sign(x + y, z, std::abs(x) + std::abs(y) + std::abs(z), [&] {
      return difference(
        exact_sum(from_64_bits<Exact_integer>(m_target.side[0][c]),
                  from_64_bits<Exact_integer>(m_target.side[1][c])),
        product(from_64_bits<Exact_integer>(m_target.total), from_64_bits<Exact_integer>(b[c])));
    });
  }

  // The sign of left - right. `size` is the sum of the magnitudes of the products of two or three
  // numbers that these are sums of: none of them is rounded to 0.
  template <typename Difference>
  static int sign(const double left, const double right, const double size,
                  const Difference& exact_difference)
  {
    if(size == 0)
      return 0;
    if(std::abs(left - right) > 1e-14 * size)
      return left > right ? 1 : -1;
    return int(CGAL::sign(exact_difference()));
  }

  double total() const { return static_cast<double>(m_target.total); }
  double weight(const std::size_t i) const { return static_cast<double>(m_target.weight[i]); }

  double dot_estimate(const Grid_vector& a) const
  {
    return weight(0) * approximate_cross(a, m_target.side[0]) +
           weight(1) * approximate_cross(a, m_target.side[1]);
  }

  double size_estimate(const Grid_vector& a) const
  {
    double size = 0;
    for(std::size_t i = 0; i < 2; ++i)
      size += weight(i) * (std::abs(double(a[0]) * double(m_target.side[i][1])) +
                           std::abs(double(a[1]) * double(m_target.side[i][0])));
    return size;
  }

  Exact_integer exact_sum(const Exact_integer& a, const Exact_integer& b) const
  {
    const Exact_integer p = product(from_64_bits<Exact_integer>(m_target.weight[0]), a);
    const Exact_integer q = product(from_64_bits<Exact_integer>(-m_target.weight[1]), b);
    return difference(p, q);
  }

  int side_of_way(const Grid_vector& a) const // 1 if a lies at the right of the way
  { return cross_with_target(a, {0, 0}); }

  void rotate(const Quarter_turns::Element rotation, Grid_vector& position)
  {
    for(Grid_vector& side : m_target.side)
      side = rotated(rotation, side);
    position = rotated(rotation, position);
  }

  // To the corner of the vertex that the way leads into.
  void turn(Corner_index& corner, Grid_vector& position)
  {
    while(side_of_way(negated(m_mesh.corner(corner).vector)) >= 0 &&
          m_mesh.opposite(corner) != no_index) {
      rotate(m_mesh.corner(corner).rotation, position);
      corner = m_mesh.counterclockwise(corner);
    }
  }

  // From a vertex at `position`. Returns whether the target is reached; otherwise, the way has met
  // another vertex, and `corner` is one from which to turn on.
  bool leave_vertex(Corner_index& corner, Grid_vector& position)
  {
    const Corner_index first = Integer_mesh::next(corner);
    const Grid_vector right = sum(position, m_mesh.corner(first).vector);
    if(side_of_way(m_mesh.corner(first).vector) == 0)
      return follow_edge(first, right, corner, position);
    const Grid_vector left = difference(position, m_mesh.corner(corner).vector);
    return cross_faces(Integer_mesh::prev(corner), right, left, corner, position);
  }

  bool follow_edge(const Corner_index h, const Grid_vector& end, Corner_index& corner,
                   Grid_vector& position)
  {
    const Grid_vector& v = m_mesh.corner(h).vector;
    const std::size_t c = v[0] != 0 ? 0 : 1;
    const int beyond = component_beyond(c, end) * (v[c] > 0 ? 1 : -1);
    if(beyond <= 0) {
      locate_on_edge(h, end, c);
      return true;
    }
    position = end;
    if(m_mesh.opposite(h) != no_index) { // counterclockwise of the edge that the way came along
      rotate(m_mesh.corner(h).rotation, position);
      corner = m_mesh.counterclockwise(h);
      return false;
    }
    corner = h; // along the border, the way goes on at the clockwise end of the star
    while(m_mesh.clockwise(corner) != no_index) {
      const Corner_index next = Integer_mesh::next(corner);
      rotate(m_mesh.corner(next).rotation, position);
      corner = m_mesh.opposite(next);
    }
    return false;
  }

  // Out of a face over the edge of h, whose ends are at the right and left of the way.
  bool cross_faces(Corner_index h, Grid_vector right, Grid_vector left, Corner_index& corner,
                   Grid_vector& position)
  {
    for(;;) {
      if(cross_with_target(m_mesh.corner(h).vector, right) >= 0 || m_mesh.opposite(h) == no_index) {
        locate_in_face(h, right, left);
        return true;
      }
      const Corner_index g = m_mesh.opposite(h), next = Integer_mesh::next(g);
      rotate(m_mesh.corner(h).rotation, right);
      left = rotated(m_mesh.corner(h).rotation, left);
      const Grid_vector apex = sum(right, m_mesh.corner(next).vector);
      const int side = side_of_way(apex);
      if(side == 0) {
        if(is_before(apex) || m_mesh.opposite(next) == no_index) {
          locate_in_face(g, left, right);
          return true;
        }
        position = apex;
        rotate(m_mesh.corner(next).rotation, position); // the way came through this corner
        corner = m_mesh.counterclockwise(next);
        return false;
      }
      if(side < 0) { // the apex is at the left
        h = next;
        left = apex;
      } else {
        h = Integer_mesh::next(next);
        right = apex;
      }
    }
  }

  // Whether the target comes before a point of the way, or is that point.
  bool is_before(const Grid_vector& p) const
  {
    const std::size_t c = p[0] != 0 ? 0 : 1;
    return component_beyond(c, p) * (p[c] > 0 ? 1 : -1) <= 0;
  }

  std::array<double, 2> approximate_target() const
  {
    std::array<double, 2> t;
    for(std::size_t c = 0; c < 2; ++c)
      t[c] = (weight(0) * static_cast<double>(m_target.side[0][c]) +
              weight(1) * static_cast<double>(m_target.side[1][c])) / total();
    return t;
  }

  void locate_on_edge(const Corner_index h, const Grid_vector& end, const std::size_t c)
  {
    const double rest = (static_cast<double>(end[c]) - approximate_target()[c]) /
                        static_cast<double>(m_mesh.corner(h).vector[c]);
    const double t = (std::min)((std::max)(rest, 0.), 1.);
    m_location = {h / 3, {}};
    m_location.weights[std::size_t(Integer_mesh::prev(h) % 3)] = t;
    m_location.weights[std::size_t(h % 3)] = 1 - t;
  }

  // In the face of h, whose source and target are given.
  void locate_in_face(const Corner_index h, const Grid_vector& source, const Grid_vector& target)
  {
    const Corner_index n = Integer_mesh::next(h), p = Integer_mesh::prev(h);
    const std::array<double, 2> t = approximate_target();
    const auto from = [&](const Grid_vector& q) {
      return std::array<double, 2>{static_cast<double>(q[0]) - t[0],
                                   static_cast<double>(q[1]) - t[1]};
    };
    const std::array<double, 2> a = from(source), b = from(target),
                                c = from(sum(target, m_mesh.corner(n).vector));
    const auto area = [](const std::array<double, 2>& x, const std::array<double, 2>& y)
      { return (std::max)(x[0] * y[1] - x[1] * y[0], 0.); };
    const double u = area(b, c), v = area(c, a), w = area(a, b), sum = u + v + w;
    m_location = {h / 3, {}};
    m_location.weights[std::size_t(p % 3)] = sum > 0 ? u / sum : 1. / 3;
    m_location.weights[std::size_t(h % 3)] = sum > 0 ? v / sum : 1. / 3;
    m_location.weights[std::size_t(n % 3)] = sum > 0 ? w / sum : 1. / 3;
  }

  const Integer_mesh& m_mesh;
  Straight_target m_target;
  Face_point m_location;
};

// The places on the input of the grid points on a coarse complex: at the point of the coarse
// triangle with the same barycentric coordinates; its vectors in the input's size lead there.
class Point_locator
{
public:
  Point_locator(const Integer_mesh& input, const Intrinsic_complex& complex,
                const Chart_mesh& charts)
    : m_input(input), m_complex(complex), m_charts(charts)
  { }

  Face_point locate(const Lattice_point& p) const
  {
    const Corner_index h = p.corner;
    switch(p.place) {
    case Lattice_place::VERTEX:
      return walk(Intrinsic_complex::next(h), Straight_target{});
    case Lattice_place::EDGE:
      return walk(h, on_edge(h, to_integers(p.uv)));
    case Lattice_place::FACE:
      break;
    }
    return locate_in_face(h / 3, to_integers(p.uv));
  }

private:
  static Grid_vector to_integers(const Uv& u)
  { return {std::int64_t(u[0]), std::int64_t(u[1])}; }

  // A fraction of the halfedge.
  Straight_target on_edge(const Corner_index h, const Grid_vector& p) const
  {
    const Grid_vector& units = m_complex.corner(h).units;
    const std::size_t c = units[0] != 0 ? 0 : 1;
    const std::int64_t part =
      p[c] - to_integers(m_charts.uv(Intrinsic_complex::prev(h)))[c];
    return {{{m_complex.corner(h).vector, Grid_vector{}}}, {{absolute_value(part), 0}},
            absolute_value(units[c])};
  }

  // From the vertex of the face that is nearest, by barycentric coordinates.
  Face_point locate_in_face(const Flat_face_index f, const Grid_vector& p) const
  {
    std::array<std::int64_t, 3> weight; // of the corners
    for(Corner_index k = 0; k < 3; ++k) {
      const Corner_index opposite = Intrinsic_complex::prev(3 * f + k); // its edge
      const Grid_vector source = to_integers(m_charts.uv(Intrinsic_complex::prev(opposite)));
      weight[std::size_t(k)] =
        cross_product(m_complex.corner(opposite).units, difference(p, source));
    }
    const Corner_index nearest = 3 * f + Corner_index(
      std::max_element(weight.begin(), weight.end()) - weight.begin());
    const Corner_index out = Intrinsic_complex::next(nearest);
    const Corner_index before = Intrinsic_complex::prev(nearest);
    return walk(out, Straight_target{
      {{m_complex.corner(out).vector, negated(m_complex.corner(nearest).vector)}},
      {{weight[std::size_t(out % 3)], weight[std::size_t(before % 3)]}},
      weight[0] + weight[1] + weight[2]});
  }

  // From the source of a halfedge of the complex, in whose chart the target is given.
  Face_point walk(const Corner_index h, Straight_target target) const
  {
    const Direction_at_corner& departure = m_complex.corner(h).departure;
    for(Grid_vector& side : target.side)
      side = rotated(departure.turns, side);
    return Straight_walk(m_input, target).run(departure.corner);
  }

  const Integer_mesh& m_input;
  const Intrinsic_complex& m_complex;
  const Chart_mesh& m_charts;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRAIGHT_WALK_H
