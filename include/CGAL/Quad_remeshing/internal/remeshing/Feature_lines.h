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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_LINES_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_LINES_H

#include <CGAL/license/Quad_remeshing.h>

// The features and borders of a surface as lines that points can slide along.

#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The halfedges of quads to a vertex along features and borders.
inline std::vector<Surface_to_remesh::Halfedge>
lines_at_vertex(const Surface_to_remesh::Mesh& quads,
                const Surface_to_remesh::Feature_map& is_feature,
                const Surface_to_remesh::Mesh::Vertex_index v)
{
  std::vector<Surface_to_remesh::Halfedge> result;
  for(const auto h : CGAL::halfedges_around_target(v, quads))
    if(is_feature[quads.edge(h)])
      result.push_back(h);
  return result;
}

// Whether these are of one line, which does not turn in the grid.
inline bool goes_straight(const Surface_to_remesh::Mesh& quads,
                          const std::vector<Surface_to_remesh::Halfedge>& lines)
{
  if(lines.size() != 2)
    return false;
  const auto v = quads.target(lines[0]);
  if(quads.is_border(v))
    return quads.degree(v) == 3;
  const auto second_next = quads.next(quads.opposite(quads.next(lines[0])));
  return quads.degree(v) == 4 && quads.opposite(second_next) == lines[1];
}

class Feature_lines
  : private Remeshing_types
{
public:
  explicit Feature_lines(const Surface_to_remesh& surface) : m_surface(surface)
  {
    std::vector<Space_segment> segments;
    for(const Edge e : mesh().edges())
      if(is_on_line(e)) {
        const Halfedge h = mesh().halfedge(e);
        segments.push_back({to_vector(source(h)), to_vector(target(h))});
        m_halfedges.push_back(h);
      }
    m_tree = Nearest_place_tree<Space_segment>(segments);
  }

  // The place of a point of a line after it moves by a length; nothing if the line ends before, or
  // meets others.
  // \param towards where it starts to, roughly
  std::optional<Point> slide(const Point& p, const Point& towards, double length) const
  {
    if(m_tree.empty())
      return std::nullopt;
    Halfedge h = m_halfedges[m_tree.nearest(to_vector(p)).element];
    if((towards - p) * (target(h) - source(h)) < 0)
      h = mesh().opposite(h);
    Point at = p;
    for(;;) {
      const double rest = std::sqrt(CGAL::squared_distance(at, target(h)));
      if(length < rest)
        return at + (length / rest) * (target(h) - at);
      length -= rest;
      at = target(h);
      const std::optional<Halfedge> next = next_on_line(h);
      if(!next)
        return std::nullopt;
      h = *next;
    }
  }

  // \pre there are lines
  double squared_distance(const Point& p) const
  { return m_tree.nearest(to_vector(p)).squared_distance; }

private:
  const Mesh& mesh() const { return m_surface.mesh(); }
  const Point& source(const Halfedge h) const { return mesh().point(mesh().source(h)); }
  const Point& target(const Halfedge h) const { return mesh().point(mesh().target(h)); }

  bool is_on_line(const Edge e) const
  { return m_surface.is_feature()[e] || mesh().is_border(e); }

  std::optional<Halfedge> next_on_line(const Halfedge h) const
  {
    std::optional<Halfedge> result;
    for(const Halfedge g : CGAL::halfedges_around_target(h, mesh()))
      if(g != h && is_on_line(mesh().edge(g))) {
        if(result)
          return std::nullopt;
        result = mesh().opposite(g);
      }
    return result;
  }

  const Surface_to_remesh& m_surface;
  Nearest_place_tree<Space_segment> m_tree;
  std::vector<Halfedge> m_halfedges; // of its segments
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_LINES_H
