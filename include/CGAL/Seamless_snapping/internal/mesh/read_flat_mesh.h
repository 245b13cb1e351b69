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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// Reads a mesh of any type into a flat one, and finds what is not a triangulated manifold.

#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// What keeps a mesh from being a triangulated manifold; faces are counted in the order of
// faces(tmesh).
struct Mesh_defect
{
  enum Kind { NOT_TRIANGULAR, SEVERAL_FANS };

  Kind kind;
  std::string message; // the place and the remedy
};

// How the indices of a flat mesh correspond to the descriptors of the mesh. Invariant: faces and
// vertices are numbered in the order of the mesh, vertices without a face and border halfedges have
// no_index.
template <typename FaceGraph>
class Flat_numbering
{
  using Graph_traits = boost::graph_traits<FaceGraph>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;
  template <typename Tag>
  using Property_map = typename boost::property_map<FaceGraph, Tag>::const_type;

public:
  explicit Flat_numbering(const FaceGraph& tmesh)
    : m_corner(get(CGAL::dynamic_halfedge_property_t<Corner_index>(), tmesh)),
      m_vertex(get(CGAL::dynamic_vertex_property_t<Flat_vertex_index>(), tmesh))
  {
    constexpr Flat_vertex_index has_face = 0;
    for(const Vertex v : vertices(tmesh))
      put(m_vertex, v, no_index);
    for(const auto h : halfedges(tmesh))
      put(m_corner, h, no_index);
    for(const auto f : faces(tmesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
        if(m_halfedges.size() == std::size_t((std::numeric_limits<Corner_index>::max)()))
          throw std::length_error("Seamless_snapping: a mesh may have up to 715,827,882 triangles");
        put(m_corner, h, Corner_index(m_halfedges.size()));
        m_halfedges.push_back(h);
        put(m_vertex, target(h, tmesh), has_face);
      }
    for(const Vertex v : vertices(tmesh))
      if(get(m_vertex, v) == has_face) {
        put(m_vertex, v, Flat_vertex_index(m_vertices.size()));
        m_vertices.push_back(v);
      }
  }

  Corner_index corner(const Halfedge h) const { return get(m_corner, h); }
  Flat_vertex_index vertex(const Vertex v) const { return get(m_vertex, v); }
  const std::vector<Halfedge>& halfedges_of_corners() const { return m_halfedges; }
  const std::vector<Vertex>& vertices_in_order() const { return m_vertices; }

private:
  Property_map<CGAL::dynamic_halfedge_property_t<Corner_index> > m_corner;
  Property_map<CGAL::dynamic_vertex_property_t<Flat_vertex_index> > m_vertex;
  std::vector<Halfedge> m_halfedges;
  std::vector<Vertex> m_vertices;
};

template <typename FaceGraph>
std::optional<Mesh_defect> find_face_that_is_not_a_triangle(const FaceGraph& tmesh)
{
  std::size_t index = 0;
  for(const auto f : faces(tmesh)) {
    std::size_t degree = 0;
    for([[maybe_unused]] const auto h :
        CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh))
      ++degree;
    if(degree != 3)
      return Mesh_defect{Mesh_defect::NOT_TRIANGULAR,
                         "face " + std::to_string(index) + " has " + std::to_string(degree) +
                           " edges: triangulate the faces of the mesh first"};
    ++index;
  }
  return std::nullopt;
}

// Sets a corner of each vertex, and checks that all its others follow from it.
template <typename Corner>
std::optional<Mesh_defect> find_fans(const std::size_t number_of_vertices, Flat_mesh<Corner>& mesh)
{
  mesh.corner_at_vertex.assign(number_of_vertices, no_index);
  mesh.is_border.assign(number_of_vertices, false);
  std::vector<int> degree(number_of_vertices, 0);
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const std::size_t v = mesh.vertex(h);
    ++degree[v];
    const bool starts_fan = mesh.clockwise(h) == no_index;
    if(mesh.corner_at_vertex[v] == no_index || (starts_fan && !mesh.is_border[v]))
      mesh.corner_at_vertex[v] = h;
    mesh.is_border[v] = mesh.is_border[v] || starts_fan;
  }
  for(std::size_t v = 0; v < number_of_vertices; ++v) {
    for_each_corner(mesh, v, [&](Corner_index) { --degree[v]; });
    if(degree[v] != 0)
      return Mesh_defect{Mesh_defect::SEVERAL_FANS,
                         "the faces around a vertex of face " +
                           std::to_string(mesh.face(mesh.corner_at_vertex[v])) +
                           " form more than one fan: see "
                           "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()"};
  }
  return std::nullopt;
}

// Fills the connectivity of `mesh`. If a face is not a triangle, it stays empty; where a vertex has
// several fans of faces, it is complete, but `corner_at_vertex` leads to one of them only.
template <typename FaceGraph, typename Corner>
std::optional<Mesh_defect> read_flat_mesh(const FaceGraph& tmesh,
                                          const Flat_numbering<FaceGraph>& numbering,
                                          Flat_mesh<Corner>& mesh)
{
  if(const auto defect = find_face_that_is_not_a_triangle(tmesh))
    return defect;
  const auto& halfedges = numbering.halfedges_of_corners();
  mesh.corners.resize(halfedges.size());
  for(std::size_t i = 0; i < halfedges.size(); ++i) {
    mesh.corners[i].opposite = numbering.corner(opposite(halfedges[i], tmesh));
    mesh.corners[i].vertex = numbering.vertex(target(halfedges[i], tmesh));
  }
  return find_fans(numbering.vertices_in_order().size(), mesh);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H
