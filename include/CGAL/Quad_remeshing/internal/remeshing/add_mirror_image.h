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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_ADD_MIRROR_IMAGE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_ADD_MIRROR_IMAGE_H

#include <CGAL/license/Quad_remeshing.h>

// From the quads of one half of a surface to the quads of both halves.

#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: `m_image` tells for each vertex the number of its image, its own on the seam.
class Mirror_image
  : private Remeshing_types
{
public:
  // \pre the surface has a mirror, and nothing that was removed from the quads is left in memory
  Mirror_image(const Surface_to_remesh& surface, Mesh& quads, Feature_map is_feature)
    : m_surface(surface), m_mirror(*surface.mirror()), m_quads(quads), m_is_feature(is_feature)
  { }

  // Returns whether the two halves are a mesh, of the surface's topology; if not, nothing is left.
  bool add()
  {
    const Seam of_quads = seam(m_quads);
    find_images(of_quads);
    const Seam of_surface = seam(m_surface.mesh());
    if(!is_mesh_with_image(of_quads, of_surface)) {
      m_quads.clear_without_removing_property_maps();
      return false;
    }
    std::vector<std::vector<Vertex> > polygons(2 * m_quads.number_of_faces());
    std::vector<std::array<Vertex, 2> > features;
    for(const auto f : m_quads.faces())
      for(const Vertex v : CGAL::vertices_around_face(m_quads.halfedge(f), m_quads)) {
        polygons[f].push_back(v);
        polygons[m_quads.number_of_faces() + f].push_back(m_image[v]);
      }
    for(std::size_t i = m_quads.number_of_faces(); i < polygons.size(); ++i)
      std::reverse(polygons[i].begin(), polygons[i].end());
    for(const Edge e : m_quads.edges())
      if(is_on_seam(e) ? is_along_feature(e, of_surface) : m_is_feature[e])
        add_feature(e, features);
    m_quads.clear_without_removing_property_maps();
    for(const Point& p : m_points)
      m_quads.add_vertex(p);
    for(const auto& polygon : polygons)
      if(m_quads.add_face(polygon) == Mesh::null_face()) {
        m_quads.clear_without_removing_property_maps();
        return false;
      }
    for(const auto& [v, w] : features)
      m_is_feature[m_quads.edge(m_quads.halfedge(v, w))] = true;
    return true;
  }

private:
  // Edges of the border that lie on the plane, and their vertices.
  struct Seam
  {
    std::vector<Edge> edges;
    std::set<Vertex> vertices;
  };

  Seam seam(const Mesh& mesh) const
  {
    constexpr double rounding = 1e-9; // the mesh is about as large as 1
    const auto is_on_plane = [&](const Vertex v)
      { return std::abs(m_mirror.distance(mesh.point(v))) <= rounding; };
    Seam result;
    for(const Edge e : mesh.edges()) {
      const Vertex v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
      if(!mesh.is_border(e) || !is_on_plane(v) || !is_on_plane(w))
        continue;
      result.edges.push_back(e);
      result.vertices.insert({v, w});
    }
    return result;
  }

  // A point is the image of its image, also where that is rounded.
  void find_images(const Seam& seam)
  {
    for(const Vertex v : m_quads.vertices())
      m_points.push_back(m_quads.point(v));
    for(const Vertex v : m_quads.vertices()) {
      Point& p = m_points[v];
      if(seam.vertices.count(v) == 1) {
        p = m_mirror.on_plane(p);
        m_image.push_back(v);
      } else {
        m_image.push_back(Vertex(Mesh::size_type(m_points.size())));
        const Point image = m_mirror.image(p);
        p = m_mirror.image(image);
        m_points.push_back(image);
      }
    }
  }

  // No edge may lead from the seam to the seam besides: its image would do so, too. And where a
  // hole is cut, its border may not come to lie on the seam: it would be closed.
  bool is_mesh_with_image(const Seam& of_quads, const Seam& of_surface) const
  {
    std::set<std::set<Vertex> > ends;
    for(const Edge e : of_quads.edges)
      ends.insert({m_quads.vertex(e, 0), m_quads.vertex(e, 1)});
    const auto number = std::count_if(
      m_quads.edges_begin(), m_quads.edges_end(), [&](const Edge e) { return is_on_seam(e); });
    return ends.size() == of_quads.edges.size() && std::size_t(number) == ends.size() &&
           of_quads.vertices.size() + of_surface.edges.size() ==
             of_surface.vertices.size() + of_quads.edges.size();
  }

  bool is_on_seam(const Edge e) const
  {
    const Vertex v = m_quads.vertex(e, 0), w = m_quads.vertex(e, 1);
    return m_image[v] == v && m_image[w] == w;
  }

  // Whether the surface has a feature where it is nearest to the middle of an edge of the seam.
  bool is_along_feature(const Edge e, const Seam& of_surface) const
  {
    const Mesh& mesh = m_surface.mesh();
    const Point p = CGAL::midpoint(m_quads.point(m_quads.vertex(e, 0)),
                                   m_quads.point(m_quads.vertex(e, 1)));
    const auto distance = [&](const Edge f) {
      return CGAL::squared_distance(
        p, Kernel::Segment_3(mesh.point(mesh.vertex(f, 0)), mesh.point(mesh.vertex(f, 1))));
    };
    const auto nearest =
      std::min_element(of_surface.edges.begin(), of_surface.edges.end(),
                       [&](const Edge f, const Edge g) { return distance(f) < distance(g); });
    return m_surface.is_feature()[*nearest];
  }

  void add_feature(const Edge e, std::vector<std::array<Vertex, 2> >& features) const
  {
    const Vertex v = m_quads.vertex(e, 0), w = m_quads.vertex(e, 1);
    features.push_back({v, w});
    features.push_back({m_image[v], m_image[w]});
  }

  const Surface_to_remesh& m_surface;
  const Mirror& m_mirror;
  Mesh& m_quads;
  Feature_map m_is_feature;
  std::vector<Vertex> m_image;
  std::vector<Point> m_points; // of both halves
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_ADD_MIRROR_IMAGE_H
