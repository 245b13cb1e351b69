// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_READ_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_READ_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// Reads a mesh of any type into a Triangle_surface, and refuses what is no triangulated 2-manifold.

#include <CGAL/Seamless_snapping/Parameterization_report.h>
#include <CGAL/Seamless_snapping/internal/parameterization/Triangle_surface.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

// Which halfedge and which vertex of the mesh an index of the Triangle_surface stands for.
template <typename TriangleMesh>
struct Mesh_indexing
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
};

// Vertices without a face get no index: they have no corner, and so no part in a parametrization.
template <typename TriangleMesh>
Triangle_surface read_connectivity(const TriangleMesh& tmesh, Mesh_indexing<TriangleMesh>& indexing)
{
  using Halfedge_index = CGAL::dynamic_halfedge_property_t<std::size_t>;
  using Vertex_index = CGAL::dynamic_vertex_property_t<std::size_t>;
  const auto halfedge_index = get(Halfedge_index(), tmesh);
  const auto vertex_index = get(Vertex_index(), tmesh);
  for(const auto v : vertices(tmesh))
    put(vertex_index, v, no_index);

  for(const auto f : faces(tmesh)) {
    std::size_t degree = 0;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      put(halfedge_index, h, indexing.halfedges.size());
      indexing.halfedges.push_back(h);
      ++degree;
    }
    if(degree != 3)
      throw Failure{Parameterization_status::NOT_TRIANGULAR,
                    "face " + std::to_string((indexing.halfedges.size() - degree) / 3) + " has "
                    + std::to_string(degree) + " edges: triangulate the faces of the mesh first"};
  }

  if(indexing.halfedges.empty())
    throw Failure{Parameterization_status::INVALID_ARGUMENT, "the mesh has no face"};

  Triangle_surface surface;
  for(const auto h : indexing.halfedges) {
    const auto v = target(h, tmesh);
    if(get(vertex_index, v) == no_index) {
      put(vertex_index, v, indexing.vertices.size());
      indexing.vertices.push_back(v);
    }
    const auto o = opposite(h, tmesh);
    surface.target.push_back(get(vertex_index, v));
    surface.opposite.push_back(CGAL::is_border(o, tmesh) ? no_index : get(halfedge_index, o));
  }
  surface.number_of_faces = indexing.halfedges.size() / 3;
  surface.number_of_vertices = indexing.vertices.size();
  return surface;
}

// Finds the first corner of each vertex, and checks that all others follow from it.
inline void find_fans(Triangle_surface& surface)
{
  surface.first_corner.assign(surface.number_of_vertices, no_index);
  surface.is_border.assign(surface.number_of_vertices, false);
  std::vector<std::size_t> degree(surface.number_of_vertices, 0);
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t v = surface.target[h];
    ++degree[v];
    const bool starts_fan = surface.previous_corner(h) == no_index;
    if(surface.first_corner[v] == no_index || starts_fan)
      surface.first_corner[v] = h;
    if(starts_fan)
      surface.is_border[v] = true;
  }
  for(std::size_t v = 0; v < surface.number_of_vertices; ++v) {
    std::size_t count = 0;
    for_each_corner(surface, v, [&](std::size_t) { ++count; });
    if(count != degree[v])
      throw Failure{Parameterization_status::NOT_MANIFOLD,
                    "the faces around " + surface.describe_vertex(v)
                    + " form more than one fan: see "
                    "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()"};
  }
}

inline void find_components(Triangle_surface& surface)
{
  surface.component.assign(surface.number_of_faces, no_index);
  std::vector<std::size_t> stack;
  for(std::size_t seed = 0; seed < surface.number_of_faces; ++seed) {
    if(surface.component[seed] != no_index)
      continue;
    surface.component[seed] = surface.number_of_components;
    stack.push_back(seed);
    while(!stack.empty()) {
      const std::size_t f = stack.back();
      stack.pop_back();
      for(std::size_t h = 3 * f; h < 3 * f + 3; ++h) {
        if(surface.is_border_edge(h))
          continue;
        const std::size_t g = surface.face(surface.opposite[h]);
        if(surface.component[g] == no_index) {
          surface.component[g] = surface.number_of_components;
          stack.push_back(g);
        }
      }
    }
    ++surface.number_of_components;
  }
}

using Point = std::array<double, 3>;

inline Point operator-(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline double dot(const Point& p, const Point& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Point cross(const Point& p, const Point& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// Signed dihedral angles: what the intrinsic layout does not know, for alignment to curvature.
inline void measure_bending(Triangle_surface& surface, const std::vector<Point>& points)
{
  using S = Triangle_surface;
  const auto normal = [&](const std::size_t h)
  {
    const Point& p = points[surface.source(h)];
    return cross(points[surface.target[h]] - p, points[surface.target[S::next(h)]] - p);
  };
  surface.bending.assign(surface.number_of_halfedges(), 0);
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    const Point n = normal(h), m = normal(surface.opposite[h]);
    const Point e = points[surface.target[h]] - points[surface.source(h)];
    const double length = std::sqrt(dot(e, e));
    if(length > 0)
      surface.bending[h] = std::atan2(dot(cross(n, m), e) / length, dot(n, m));
  }
}

template <typename TriangleMesh, typename VertexPointMap>
void read_geometry(const Mesh_indexing<TriangleMesh>& indexing,
                   const VertexPointMap vertex_points,
                   Triangle_surface& surface)
{
  std::vector<Point> points;
  double size = 0;
  for(std::size_t v = 0; v < indexing.vertices.size(); ++v) {
    const auto& p = get(vertex_points, indexing.vertices[v]);
    points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    for(const double x : points.back()) {
      if(!std::isfinite(x))
        throw Failure{Parameterization_status::NOT_FINITE,
                      surface.describe_vertex(v) + " has a NaN or infinite coordinate"};
      size = (std::max)(size, std::abs(x));
    }
  }
  surface.exponent = (size > 0) ? std::ilogb(size) : 0;
  for(Point& p : points)
    for(double& x : p)
      x = std::ldexp(x, -surface.exponent);

  surface.length.resize(surface.number_of_halfedges());
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h) {
    const Point e = points[surface.target[h]] - points[surface.source(h)];
    surface.length[h] = std::sqrt(dot(e, e));
  }
  measure_bending(surface, points);
  mollify_lengths(surface);
  lay_out_faces(surface);
}

template <typename TriangleMesh, typename EdgeIsConstrainedMap>
void read_alignment(const TriangleMesh& tmesh,
                    const Mesh_indexing<TriangleMesh>& indexing,
                    const EdgeIsConstrainedMap edge_is_constrained,
                    const bool align_border,
                    Triangle_surface& surface)
{
  surface.is_aligned.resize(surface.number_of_halfedges());
  for(std::size_t h = 0; h < surface.number_of_halfedges(); ++h)
    surface.is_aligned[h] = get(edge_is_constrained, edge(indexing.halfedges[h], tmesh))
                            || (align_border && surface.is_border_edge(h));
}

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_READ_SURFACE_H
