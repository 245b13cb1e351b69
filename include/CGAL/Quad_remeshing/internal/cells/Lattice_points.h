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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_LATTICE_POINTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_LATTICE_POINTS_H

#include <CGAL/license/Quad_remeshing.h>

// The points of a parametrized surface with integer coordinates. Points inside of edges and
// triangles are found in floating point, with a bound of the error; in doubt, the exact orientation
// decides. Each point is kept with one face, in whose chart its coordinates are. The points of a
// face are sorted, so that a point is found again by its coordinates.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline bool is_integer(const double x) { return static_cast<double>(std::int64_t(x)) == x; }
inline bool is_integer(const Exact_difference& x)
{
  return x.error == 0 && x.rounded == std::round(x.rounded);
}
inline bool is_lattice_point(const Uv& u) { return is_integer(u[0]) && is_integer(u[1]); }

inline std::int64_t floor_integer(const double x)
{
  const std::int64_t i = std::int64_t(x);
  return i - std::int64_t(static_cast<double>(i) > x);
}
inline std::int64_t floor_integer(const Exact_difference& x)
{
  const std::int64_t i = floor_integer(x.rounded);
  return i - std::int64_t(x.error < 0 && static_cast<double>(i) == x.rounded);
}
inline std::int64_t ceil_integer(const double x) { return -floor_integer(-x); }

// Where the line through a and b, which differ in the component 1 - c, takes the value `level` in
// that component, between both: its component c up to `error`, which is at most 1/4.
struct Crossing
{
  double value, error;

  Crossing(const Uv& a, const Uv& b, const std::size_t c, const double level)
  {
    const double t = (level - a[1 - c]) / (b[1 - c] - a[1 - c]);
    value = a[c] + t * (b[c] - a[c]);
    error = std::ldexp(std::abs(a[c]) + std::abs(b[c]), -49);
  }

  bool may_be(const double integer) const { return std::abs(value - integer) <= error; }
};

// Calls f(p) for the lattice points inside of the edge ab.
template <typename Function>
void for_lattice_points_on_edge(const Uv& a, const Uv& b, const Function& f)
{
  // The lines of the grid that cross the edge, of the kind of which there are fewer.
  std::array<std::int64_t, 2> first, last;
  for(std::size_t c = 0; c < 2; ++c) {
    first[c] = floor_integer((std::min)(a[c], b[c])) + 1;
    last[c] = ceil_integer((std::max)(a[c], b[c])) - 1;
  }
  const bool is_on_line_0 = a[0] == b[0], is_on_line_1 = a[1] == b[1];
  if((is_on_line_0 && !is_integer(a[0])) || (is_on_line_1 && !is_integer(a[1])))
    return;
  const std::size_t c = (is_on_line_1 || (!is_on_line_0 && last[0] - first[0] < last[1] - first[1]))
                        ? 0 : 1;
  for(std::int64_t i = first[c]; i <= last[c]; ++i) {
    Uv p;
    p[c] = static_cast<double>(i);
    const Crossing crossing(a, b, 1 - c, p[c]);
    p[1 - c] = static_cast<double>(floor_integer(crossing.value + 0.5));
    if(crossing.may_be(p[1 - c]) &&
       (is_on_line_0 || is_on_line_1 || orientation({a, b, p}) == CGAL::COLLINEAR))
      f(p);
  }
}

// The first integer x with (x, y) at the left of the edge ab, which runs down (or, for mirrored
// coordinates, up), strictly. The edge meets the row y.
inline std::int64_t first_inside(const Uv& a, const Uv& b, const double y, const bool is_mirrored)
{
  const Crossing crossing(a, b, 0, y);
  const double value = is_mirrored ? -crossing.value : crossing.value;
  const std::int64_t nearest = floor_integer(value + 0.5);
  if(!crossing.may_be(static_cast<double>(is_mirrored ? -nearest : nearest)))
    return floor_integer(value) + 1;
  const Uv p{static_cast<double>(is_mirrored ? -nearest : nearest), y};
  return orientation({a, b, p}) == CGAL::LEFT_TURN ? nearest : nearest + 1;
}

// Calls f(p) for the lattice points inside of a triangle of positive orientation, row by row.
template <typename Function>
void for_lattice_points_inside(const Uv_triangle& t, const Function& f)
{
  const auto& [a, b, c] = t;
  const std::int64_t last = ceil_integer((std::max)({a[1], b[1], c[1]})) - 1;
  for(std::int64_t i = floor_integer((std::min)({a[1], b[1], c[1]})) + 1; i <= last; ++i) {
    const double y = static_cast<double>(i);
    std::int64_t begin = std::int64_t(-largest_grid_coordinate), end = -begin; // end: the last one
    for(std::size_t k = 0; k < 3; ++k) {
      const Uv &p = t[k], &q = t[(k + 1) % 3];
      if(p[1] > q[1] && p[1] >= y && y >= q[1])
        begin = (std::max)(begin, first_inside(p, q, y, false));
      else if(p[1] < q[1] && p[1] <= y && y <= q[1])
        end = (std::min)(end, -first_inside(p, q, y, true));
    }
    for(std::int64_t x = begin; x <= end; ++x)
      f(Uv{static_cast<double>(x), y});
  }
}

using Point_index = std::int32_t;

enum class Lattice_place : std::int32_t { VERTEX, EDGE, FACE };

struct Lattice_point
{
  Uv uv;
  Corner_index corner; // points to the vertex; or lies on the edge; or in the face
  Lattice_place place;
};

inline std::size_t face_of(const Corner_index h) { return std::size_t(h) / 3; }

// Rows of the grid first, as the points inside of a face come.
inline bool is_before(const Uv& a, const Uv& b)
{
  return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

class Lattice_points
{
public:
  // The coordinates must be at most `largest_grid_coordinate`, and all faces positive. Memory is
  // reserved for the expected number of points.
  template <typename ConcurrencyTag, typename Group>
  static Lattice_points make(const Basic_chart_mesh<Group>& mesh, const std::size_t expected_number)
  {
    Lattice_points result;
    const std::size_t number_of_faces = mesh.corners.size() / 3;
    constexpr std::size_t block = std::size_t(1) << 18; // of faces whose points are kept twice
    result.m_points.reserve(expected_number);
    result.m_first.assign(number_of_faces + 1, 0);
    for(std::size_t begin = 0; begin < number_of_faces; begin += block)
      result.add_points_of_faces<ConcurrencyTag>(mesh, begin,
                                                 (std::min)(begin + block, number_of_faces));
    return result;
  }

  std::size_t size() const { return m_points.size(); }
  const Lattice_point& operator[](const std::size_t i) const { return m_points[i]; }

  // The point with these coordinates that is kept with the face.
  std::size_t find(const std::size_t face, const Uv& uv) const
  {
    const auto begin = m_points.begin() + m_first[face], end = m_points.begin() + m_first[face + 1];
    const auto p = std::lower_bound(begin, end, uv, [](const Lattice_point& q, const Uv& u)
                                    { return is_before(q.uv, u); });
    return p != end && p->uv == uv ? std::size_t(p - m_points.begin()) : m_points.size();
  }

private:
  template <typename ConcurrencyTag, typename Group>
  void add_points_of_faces(const Basic_chart_mesh<Group>& mesh, const std::size_t begin,
                           const std::size_t end)
  {
    const auto points = results_of_chunks<std::vector<Lattice_point>, ConcurrencyTag>(
      end - begin, [&](const Chunk& chunk) {
        std::vector<Lattice_point> result;
        for(std::size_t face = begin + chunk.begin; face < begin + chunk.end; ++face) {
          const std::size_t before = result.size();
          add_points_of_face(mesh, face, result);
          m_first[face + 1] = Point_index(result.size() - before);
        }
        return result;
      });
    for(std::size_t face = begin; face < end; ++face)
      m_first[face + 1] += m_first[face];
    append<ConcurrencyTag>(points, m_points);
  }

  template <typename Group>
  static void add_points_of_face(const Basic_chart_mesh<Group>& mesh, const std::size_t face,
                                 std::vector<Lattice_point>& points)
  {
    const Uv_triangle t = triangle(mesh, face);
    if(!meets_lattice(t))
      return;
    const std::size_t before = points.size();
    const Corner_index first = Corner_index(3 * face);
    for(Corner_index h = first; h < first + 3; ++h) {
      if(mesh.corner_at_vertex[mesh.vertex(h)] == h && is_lattice_point(mesh.uv(h)))
        points.push_back({mesh.uv(h), h, Lattice_place::VERTEX});
      if(mesh.edge_key(h) == h)
        for_lattice_points_on_edge(mesh.uv(mesh.prev(h)), mesh.uv(h), [&](const Uv& p)
                                   { points.push_back({p, h, Lattice_place::EDGE}); });
    }
    for_lattice_points_inside(t, [&](const Uv& p)
                              { points.push_back({p, first, Lattice_place::FACE}); });
    std::sort(points.begin() + std::ptrdiff_t(before), points.end(),
              [](const Lattice_point& p, const Lattice_point& q) { return is_before(p.uv, q.uv); });
  }

  // Whether its bounding box does.
  static bool meets_lattice(const Uv_triangle& t)
  {
    for(std::size_t c = 0; c < 2; ++c)
      if(ceil_integer((std::min)({t[0][c], t[1][c], t[2][c]})) >
         floor_integer((std::max)({t[0][c], t[1][c], t[2][c]})))
        return false;
    return true;
  }

  boost::container::vector<Lattice_point> m_points;
  std::vector<Point_index> m_first; // per face, and one more
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_LATTICE_POINTS_H
