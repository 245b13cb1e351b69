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

// The points of a parametrized surface with integer coordinates. Each is kept with one face, in
// whose chart its coordinates are; those of a face are sorted, so that a point is found again by
// its coordinates.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>
#include <CGAL/Quad_remeshing/internal/cells/points_in_triangle.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

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
