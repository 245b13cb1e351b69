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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H

#include <CGAL/license/Quad_remeshing.h>

// A plane by which a surface is its own mirror image, and the half on one side of it.

#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the normal has the length 1. Where it is an axis, all is computed in its coordinate
// alone: images by the coordinate planes are exact.
class Mirror
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;

public:
  // The points with a x + b y + c z + d = 0. Points with a positive sum are on the upper side.
  Mirror(const double a, const double b, const double c, const double d) : m_normal{a, b, c}
  {
    const double length = std::hypot(a, b, c);
    for(double& x : m_normal)
      x /= length;
    m_offset = -d / length;
  }

  bool is_valid() const { return std::isfinite(m_normal[0]) && std::isfinite(m_offset); }

  // In the same space, scaled by a power of two.
  Mirror scaled(const int exponent) const
  {
    Mirror result(*this);
    result.m_offset = std::ldexp(m_offset, exponent);
    return result;
  }

  // Positive on the upper side.
  double distance(const Point& p) const
  {
    const int axis = this->axis();
    if(axis >= 0)
      return m_normal[std::size_t(axis)] * p[axis] - m_offset;
    return m_normal[0] * p.x() + m_normal[1] * p.y() + m_normal[2] * p.z() - m_offset;
  }

  Point image(const Point& p) const { return moved(p, 2); }
  Point on_plane(const Point& p) const { return moved(p, 1); }

private:
  // Or a negative number.
  int axis() const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_normal[(i + 1) % 3] == 0 && m_normal[(i + 2) % 3] == 0)
        return int(i);
    return -1;
  }

  Point moved(const Point& p, const double times) const
  {
    std::array<double, 3> q{p.x(), p.y(), p.z()};
    const int axis = this->axis();
    if(axis >= 0) {
      const double at = m_normal[std::size_t(axis)] * m_offset;
      q[std::size_t(axis)] = times == 1 ? at : 2 * at - q[std::size_t(axis)];
    } else {
      const double distance = this->distance(p);
      for(std::size_t i = 0; i < 3; ++i)
        q[i] -= times * distance * m_normal[i];
    }
    return Point(q[0], q[1], q[2]);
  }

  std::array<double, 3> m_normal;
  double m_offset;
};

// The triangles of a surface on the upper side of a mirror. Triangles that cross it are cut.

// Invariant: cut vertices lie on the plane as `Mirror::on_plane()` computes it, and so do vertices
// that are nearer to it than a thousandth of their shortest edge, so that no sliver is cut off.
class Half_surface
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;
  using Halfedge = Mesh::Halfedge_index;

  struct Place // on an edge of the surface, or at a vertex
  {
    Vertex source, target;
    double t; // 0 at the source
  };

  struct Triangle
  {
    std::array<std::size_t, 3> vertices;
    std::array<char, 3> is_feature; // the side from each vertex to the next
    Face face;                      // that it is part of
  };

  // \pre triangles only
  template <typename FeatureMap>
  Half_surface(const Mesh& mesh, const FeatureMap& is_feature, const Mirror& mirror)
    : m_mesh(mesh), m_mirror(mirror)
  {
    find_sides();
    for(const Face f : mesh.faces())
      add(f, is_feature);
    split_fans();
  }

  // Places of the vertices, and where they are.
  const std::vector<Place>& places() const { return m_places; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  Mesh::Point point(const Place& place) const
  {
    const Mesh::Point& p = m_mesh.point(place.source);
    if(place.source == place.target)
      return m_side[place.source] == 0 ? m_mirror.on_plane(p) : p;
    return m_mirror.on_plane(p + place.t * (m_mesh.point(place.target) - p));
  }

private:
  void find_sides()
  {
    constexpr double nearness = 1e-3; // as a part of the shortest edge at a vertex
    for(const Vertex v : m_mesh.vertices()) {
      m_distance.push_back(m_mirror.distance(m_mesh.point(v)));
      double shortest = (std::numeric_limits<double>::max)();
      if(m_mesh.is_isolated(v)) {
        m_side.push_back(-1);
        continue;
      }
      for(const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        shortest = (std::min)(shortest, std::sqrt(CGAL::squared_distance(
                                          m_mesh.point(v), m_mesh.point(m_mesh.source(h)))));
      m_side.push_back(std::abs(m_distance.back()) <= nearness * shortest
                         ? 0 : m_distance.back() > 0 ? 1 : -1);
    }
  }

  template <typename FeatureMap>
  void add(const Face f, const FeatureMap& is_feature)
  {
    std::vector<std::size_t> corners;
    std::vector<char> are_features; // the sides that begin there
    bool is_above = false;
    for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
      const Vertex v = m_mesh.source(h), w = m_mesh.target(h);
      const bool feature = is_feature[m_mesh.edge(h)];
      is_above = is_above || m_side[v] > 0;
      if(m_side[v] >= 0) {
        corners.push_back(vertex({v, v, 0}));
        are_features.push_back(feature && m_side[w] >= 0 ? 1 : feature && m_side[v] > 0);
      }
      if(m_side[v] * m_side[w] < 0) {
        const double t = m_distance[v] / (m_distance[v] - m_distance[w]);
        corners.push_back(v < w ? vertex({v, w, t}) : vertex({w, v, 1 - t}));
        are_features.push_back(feature && m_side[w] > 0);
      }
    }
    if(!is_above)
      return;
    if(corners.size() == 4 && length(corners[1], corners[3]) < length(corners[0], corners[2])) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::rotate(are_features.begin(), are_features.begin() + 1, are_features.end());
    }
    for(std::size_t i = 1; i + 1 < corners.size(); ++i)
      m_triangles.push_back({{corners[0], corners[i], corners[i + 1]},
                             {i == 1 ? are_features[0] : char(false), are_features[i],
                              i + 2 == corners.size() ? are_features[i + 1] : char(false)}, f});
  }

  std::size_t vertex(const Place& place)
  {
    const auto [it, is_new] =
      m_numbers.try_emplace(std::make_pair(place.source, place.target), m_places.size());
    if(is_new)
      m_places.push_back(place);
    return it->second;
  }

  double length(const std::size_t i, const std::size_t j) const
  { return CGAL::squared_distance(point(m_places[i]), point(m_places[j])); }

  // If the surface touches the plane in one point, the two sides of it come apart.
  void split_fans()
  {
    boost::disjoint_sets_with_storage<> fans(3 * m_triangles.size());
    for(std::size_t c = 0; c < 3 * m_triangles.size(); ++c)
      fans.make_set(c);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> corner_before; // per directed side
    const auto vertex_at = [&](const std::size_t c) -> std::size_t&
      { return m_triangles[c / 3].vertices[c % 3]; };
    const auto next = [](const std::size_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
    for(std::size_t c = 0; c < 3 * m_triangles.size(); ++c) {
      corner_before[{vertex_at(c), vertex_at(next(c))}] = c;
      const auto it = corner_before.find({vertex_at(next(c)), vertex_at(c)});
      if(it != corner_before.end()) {
        fans.union_set(c, next(it->second));
        fans.union_set(next(c), it->second);
      }
    }
    std::vector<std::size_t> fan_of_vertex(m_places.size(), 3 * m_triangles.size());
    std::map<std::size_t, std::size_t> vertex_of_fan;
    std::vector<std::size_t> vertices;
    for(std::size_t c = 0; c < 3 * m_triangles.size(); ++c) {
      const std::size_t v = vertex_at(c), fan = fans.find_set(c);
      if(fan_of_vertex[v] == 3 * m_triangles.size())
        fan_of_vertex[v] = fan;
      const auto [it, is_new] =
        vertex_of_fan.try_emplace(fan, fan_of_vertex[v] == fan ? v : m_places.size());
      if(is_new && it->second == m_places.size())
        m_places.push_back(Place(m_places[v]));
      vertices.push_back(it->second);
    }
    for(std::size_t c = 0; c < vertices.size(); ++c)
      vertex_at(c) = vertices[c];
  }

  const Mesh& m_mesh;
  const Mirror& m_mirror;
  std::vector<double> m_distance; // per vertex of the mesh
  std::vector<int> m_side;        // the same: 0 on the plane
  std::map<std::pair<Vertex, Vertex>, std::size_t> m_numbers;
  std::vector<Place> m_places;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MIRROR_H
