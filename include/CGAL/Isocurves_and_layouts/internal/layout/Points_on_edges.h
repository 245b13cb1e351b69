// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POINTS_ON_EDGES_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POINTS_ON_EDGES_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Points of arcs inside of edges, in their exact order along each.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_place.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// A point inside of an edge: where its first halfedge has this coordinate, seen from `halfedge`.
struct Edge_point
{
  std::int32_t point;
  Corner_index key;      // the first halfedge
  Corner_index halfedge; // that or the other one
  std::size_t component;
  Exact_level level;
  double approximate;    // the parameter along the first halfedge, with a small relative error, if
                         // the level is a double

  Exact_rational parameter(const Chart_mesh& mesh) const
  {
    const Exact_rational a(mesh.uv(Chart_mesh::prev(halfedge))[component]);
    const Exact_rational b(mesh.uv(halfedge)[component]);
    const Exact_rational t((level.exact() - a) / (b - a));
    return halfedge == key ? t : Exact_rational(1 - t);
  }
};

inline Edge_point edge_point(const Chart_mesh& mesh, const std::int32_t point, const Corner_index h,
                             const std::size_t component, const Exact_level& level)
{
  Edge_point result{point, mesh.edge_key(h), h, component, level, 0};
  const double a = mesh.uv(Chart_mesh::prev(h))[component], b = mesh.uv(h)[component];
  const double from = result.key == h ? a : b, to = result.key == h ? b : a;
  result.approximate = (level.approximation() - from) / (to - from);
  return result;
}

inline bool comes_before(const Chart_mesh& mesh, const Edge_point& a, const Edge_point& b)
{
  if(a.key != b.key)
    return a.key < b.key;
  const double s = a.approximate, t = b.approximate;
  if(a.level.is_double() && b.level.is_double() && std::abs(s - t) > 1e-14 * (s + t))
    return s < t;
  return a.parameter(mesh) < b.parameter(mesh);
}

// Invariant: the points of an edge follow each other, as its first halfedge meets them.
class Points_on_edges
{
public:
  // \param number_of_points the indices of points are below
  Points_on_edges(const Chart_mesh& mesh, std::vector<Edge_point> points,
                  const std::size_t number_of_points)
    : m_mesh(mesh), m_points(std::move(points)), m_ranks(number_of_points, 0),
      m_first_on_edge(mesh.corners.size() + 1, 0)
  {
    std::sort(m_points.begin(), m_points.end(),
              [&](const Edge_point& a, const Edge_point& b) { return comes_before(m_mesh, a, b); });
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      const bool is_first = i == 0 || m_points[i - 1].key != m_points[i].key;
      m_ranks[std::size_t(m_points[i].point)] =
        is_first ? 0 : m_ranks[std::size_t(m_points[i - 1].point)] + 1;
      ++m_first_on_edge[std::size_t(m_points[i].key) + 1];
    }
    for(std::size_t h = 0; h < m_mesh.corners.size(); ++h)
      m_first_on_edge[h + 1] += m_first_on_edge[h];
  }

  std::int32_t number_on(const Corner_index h) const
  {
    const std::size_t key = std::size_t(m_mesh.edge_key(h));
    return m_first_on_edge[key + 1] - m_first_on_edge[key];
  }

  // Those of a halfedge are counted from 1, as 0 is its source.
  const Edge_point& at(const Corner_index h, const std::int32_t i) const
  {
    const Corner_index key = m_mesh.edge_key(h);
    const std::int32_t rank = h == key ? i - 1 : number_on(h) - i;
    return m_points[std::size_t(m_first_on_edge[std::size_t(key)] + rank)];
  }

  std::int32_t number_of(const std::int32_t point, const Corner_index h) const
  {
    const std::int32_t rank = m_ranks[std::size_t(point)];
    return h == m_mesh.edge_key(h) ? rank + 1 : number_on(h) - rank;
  }

  // Also of the source and of the target, that comes after all others.
  Exact_uv uv(const Corner_index h, const std::int32_t i) const
  {
    const Uv &a = m_mesh.uv(Chart_mesh::prev(h)), &b = m_mesh.uv(h);
    if(i == 0 || i > number_on(h))
      return {Exact_level((i == 0 ? a : b)[0]), Exact_level((i == 0 ? a : b)[1])};
    const Edge_point& point = at(h, i);
    const Exact_rational t(point.parameter(m_mesh));
    const Exact_rational s(h == point.key ? t : Exact_rational(1 - t));
    const auto coordinate = [&](const std::size_t c) {
      const Exact_rational from(a[c]);
      return Exact_level(Exact_rational(from + s * (Exact_rational(b[c]) - from)));
    };
    return {coordinate(0), coordinate(1)};
  }

private:
  const Chart_mesh& m_mesh;
  std::vector<Edge_point> m_points;
  std::vector<std::int32_t> m_ranks;         // per point: on its edge, from 0, if it lies on one
  std::vector<std::int32_t> m_first_on_edge; // of the points, per first halfedge
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_POINTS_ON_EDGES_H
