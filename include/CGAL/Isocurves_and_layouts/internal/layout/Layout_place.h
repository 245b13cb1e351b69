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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_PLACE_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_PLACE_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Places on the surface, exactly: their elements, and their coordinates there. Points of arcs
// inside of edges, in their order along each.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

using Exact_uv = std::array<Exact_level, 2>;

// Invariant: at a vertex, `halfedge` points to it; inside of an edge, it lies on it; inside of a
// face, it is one of the face. Coordinates belong to the chart of its face.
struct Layout_place
{
  Isocurve_place place = Isocurve_place::FACE;
  Corner_index halfedge = no_index;
  Exact_uv uv;
};

// The sign of the area of a, b, x.
inline int side_of_line(const Uv& a, const Uv& b, const Exact_uv& x)
{
  if(x[0].is_double() && x[1].is_double())
    return int(orientation({a, b, {x[0].approximation(), x[1].approximation()}}));
  const Exact_rational ax(a[0]), ay(a[1]);
  const Exact_rational first((Exact_rational(b[0]) - ax) * (x[1].exact() - ay));
  const Exact_rational second((Exact_rational(b[1]) - ay) * (x[0].exact() - ax));
  return int(CGAL::compare(first, second));
}

// Whether a closed face, which is positive, contains the point `place.uv` of its chart. If so, sets
// what the point lies on.
// \pre `place.halfedge` is one of the face
inline bool locate_in_face(const Chart_mesh& mesh, Layout_place& place)
{
  Corner_index on[3];
  std::size_t number = 0;
  Corner_index h = place.halfedge;
  for(int i = 0; i < 3; ++i, h = Chart_mesh::next(h)) {
    const int side = side_of_line(mesh.uv(Chart_mesh::prev(h)), mesh.uv(h), place.uv);
    if(side < 0)
      return false;
    if(side == 0)
      on[number++] = h;
  }
  place.place = number == 0 ? Isocurve_place::FACE
                            : number == 1 ? Isocurve_place::EDGE : Isocurve_place::VERTEX;
  if(number > 0)
    place.halfedge = on[0];
  if(number == 2 && on[1] != Chart_mesh::next(on[0])) // the vertex lies between both
    place.halfedge = on[1];
  return true;
}

// A point of the edge of `h`, in the chart of the opposite face.
inline Exact_uv carried_over_edge(const Chart_mesh& mesh, const Corner_index h, const Exact_uv& uv)
{
  Exact_uv result;
  for(std::size_t c = 0; c < 2; ++c) {
    Exact_level value = uv[c];
    const std::size_t i = carry_over_edge(mesh, h, c, value);
    result[i] = value;
  }
  return result;
}

// The one description of a place that has several: on edges, by their first halfedge; in faces, by
// theirs; at vertices, by the first corner. Returns by how much directions turn that way; at
// vertices they are not of any chart, and stay.
inline Quarter_turns::Element make_unique(const Chart_mesh& mesh, Layout_place& place)
{
  const Corner_index h = place.halfedge;
  switch(place.place) {
  case Isocurve_place::VERTEX:
    place.halfedge = mesh.corner_at_vertex[mesh.vertex(h)];
    place.uv = {Exact_level(mesh.uv(place.halfedge)[0]), Exact_level(mesh.uv(place.halfedge)[1])};
    break;
  case Isocurve_place::FACE:
    place.halfedge = 3 * mesh.face(h);
    break;
  case Isocurve_place::EDGE:
    if(mesh.represents_edge(h))
      break;
    place.halfedge = mesh.opposite(h);
    place.uv = carried_over_edge(mesh, h, place.uv);
    return mesh.rotation(h);
  }
  return Quarter_turns::identity();
}

// An order of places whose description is unique.
inline int compare(const Layout_place& a, const Layout_place& b)
{
  const auto key = [](const Layout_place& p) { return std::make_tuple(p.place, p.halfedge); };
  if(key(a) != key(b))
    return key(a) < key(b) ? -1 : 1;
  const int u = compare(a.uv[0], b.uv[0]);
  return u != 0 ? u : compare(a.uv[1], b.uv[1]);
}

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
  Points_on_edges(const Chart_mesh& mesh, const std::vector<Edge_point>& points,
                  const std::size_t number_of_points)
    : m_mesh(mesh), m_points(mesh.corners.size(), [&](const auto& add) {
        for(const Edge_point& p : points)
          add(p.key, p);
      }),
      m_ranks(number_of_points, 0)
  {
    m_points.sort_each([&](const Edge_point& a, const Edge_point& b)
                       { return comes_before(m_mesh, a, b); });
    for(std::size_t h = 0; h < m_points.size(); ++h)
      for(std::size_t i = 0; i < m_points[h].size(); ++i)
        m_ranks[std::size_t(m_points[h][i].point)] = std::int32_t(i);
  }

  std::int32_t number_on(const Corner_index h) const
  { return std::int32_t(m_points[m_mesh.edge_key(h)].size()); }

  // A point on a halfedge, counted from 1; 0 is the source.
  const Edge_point& at(const Corner_index h, const std::int32_t i) const
  {
    const Corner_index key = m_mesh.edge_key(h);
    return m_points[key][h == key ? i - 1 : number_on(h) - i];
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
  Lists<Edge_point> m_points;        // per first halfedge
  std::vector<std::int32_t> m_ranks; // per point: on its edge, from 0, if it lies on one
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_PLACE_H
