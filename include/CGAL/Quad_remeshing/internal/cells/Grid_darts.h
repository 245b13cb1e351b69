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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_DARTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_DARTS_H

#include <CGAL/license/Quad_remeshing.h>

// Darts: the unit steps along lines of the grid. The darts at a point are numbered
// counterclockwise; around a point on the border, from the first one that leads into the surface to
// the last one.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Dart_index = std::int32_t;
constexpr Dart_index open_dart = -1;     // it meets the border first: there is no twin
constexpr Dart_index untraced_dart = -2;

// The directions of the darts at a point inside of an edge, in the chart of its face.
struct Edge_directions
{
  int first, number;

  template <typename Group>
  Edge_directions(const Basic_chart_mesh<Group>& mesh, const Corner_index h)
    : first(Group::identity()), number(Group::order)
  {
    if(mesh.opposite(h) != no_index)
      return;
    const Direction along = sector<Group>(mesh.uv(mesh.prev(h)), mesh.uv(h));
    // then the edge is a dart itself, both ways
    const bool is_aligned = side_of_ray(mesh, mesh.prev(h), along, h) == 0;
    first = turned<Group>(along, is_aligned ? 0 : 1);
    number = Group::order / 2 + (is_aligned ? 1 : 0);
  }
};

// The darts of point p are first(p), ..., first(p + 1) - 1, counterclockwise.
class Grid_darts
{
public:
  template <typename ConcurrencyTag, typename Group>
  static Grid_darts make(const Basic_chart_mesh<Group>& mesh, const Lattice_points& points)
  {
    Grid_darts result;
    result.m_first.assign(points.size() + 1, 0);
    const std::vector<Chunk> chunks = chunks_of(points.size());
    for_each_chunk<ConcurrencyTag>(chunks, [&](const Chunk& chunk) {
      for(std::size_t p = chunk.begin; p < chunk.end; ++p)
        result.m_first[p + 1] = number_at(mesh, points[p]);
    });
    for(std::size_t p = 0; p < points.size(); ++p)
      result.m_first[p + 1] += result.m_first[p];
    result.twins.resize(std::size_t(result.m_first.back()), boost::container::default_init);
    result.m_marks.resize(result.twins.size(), boost::container::default_init);
    for_each_chunk<ConcurrencyTag>(chunks, [&](const Chunk& chunk) {
      for(std::size_t p = chunk.begin; p < chunk.end; ++p)
        result.initialize(p, is_surrounded(mesh, points[p]));
    });
    return result;
  }

  std::size_t size() const { return twins.size(); }
  std::size_t first(const std::size_t point) const { return std::size_t(m_first[point]); }
  std::size_t degree(const std::size_t point) const { return first(point + 1) - first(point); }

  // The next darts around the same point, as if there were no border.
  std::size_t counterclockwise(std::size_t d) const
  {
    if(!has(d, LAST))
      return d + 1;
    while(!has(d, FIRST))
      --d;
    return d;
  }
  std::size_t clockwise(std::size_t d) const
  {
    if(!has(d, FIRST))
      return d - 1;
    while(!has(d, LAST))
      ++d;
    return d;
  }

  // Whether the dart and the next one counterclockwise enclose a corner: not at the border's end.
  bool has_corner(const std::size_t d) const { return !has(d, BEFORE_BORDER); }

  // Whether the dart runs along a feature edge.
  bool is_feature(const std::size_t d) const { return has(d, FEATURE); }
  void mark_feature(const std::size_t d) { m_marks[d] = static_cast<char>(m_marks[d] | FEATURE); }

  boost::container::vector<Dart_index> twins;

private:
  enum Mark { FIRST = 1, LAST = 2, BEFORE_BORDER = 4, FEATURE = 8 };

  template <typename Group>
  static Dart_index number_at(const Basic_chart_mesh<Group>& mesh, const Lattice_point& p)
  {
    switch(p.place) {
    case Lattice_place::VERTEX:
      return Dart_index(rays_from_vertex(mesh, mesh.vertex(p.corner)).size());
    case Lattice_place::EDGE:
      return Edge_directions(mesh, p.corner).number;
    case Lattice_place::FACE:
      break;
    }
    return Group::order;
  }

  // Whether the point lies inside of the surface.
  template <typename Group>
  static bool is_surrounded(const Basic_chart_mesh<Group>& mesh, const Lattice_point& p)
  {
    switch(p.place) {
    case Lattice_place::VERTEX: return !mesh.is_border[mesh.vertex(p.corner)];
    case Lattice_place::EDGE:   return mesh.opposite(p.corner) != no_index;
    case Lattice_place::FACE:   break;
    }
    return true;
  }

  bool has(const std::size_t d, const Mark mark) const { return (m_marks[d] & mark) != 0; }

  void initialize(const std::size_t p, const bool is_inside)
  {
    if(degree(p) == 0)
      return;
    for(std::size_t d = first(p); d < first(p + 1); ++d) {
      twins[d] = untraced_dart;
      m_marks[d] = 0;
    }
    const std::size_t last = first(p + 1) - 1;
    m_marks[first(p)] = FIRST;
    m_marks[last] = static_cast<char>(m_marks[last] | LAST | (is_inside ? 0 : BEFORE_BORDER));
  }

  std::vector<Dart_index> m_first;        // per point, and one more
  boost::container::vector<char> m_marks; // per dart
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_DARTS_H
