// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// Reads a mesh of any type into a flat one, and finds elements that are not triangulated manifolds.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// How the indices of a flat mesh correspond to the descriptors of the mesh. Invariant: faces and
// vertices are numbered in the order of the mesh; vertices without a face and border halfedges have
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
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  explicit Flat_numbering(const FaceGraph& tmesh, ConcurrencyTag = ConcurrencyTag())
    : m_corner(get(CGAL::dynamic_halfedge_property_t<Corner_index>(), tmesh)),
      m_vertex(get(CGAL::dynamic_vertex_property_t<Flat_vertex_index>(), tmesh))
  {
    call_both<ConcurrencyTag>([&] { number_corners(tmesh); }, [&] { number_vertices(tmesh); });
  }

  Corner_index corner(const Halfedge h) const { return get(m_corner, h); }
  Flat_vertex_index vertex(const Vertex v) const { return get(m_vertex, v); }
  const std::vector<Halfedge>& halfedges_of_corners() const { return m_halfedges; }
  const std::vector<Vertex>& vertices_in_order() const { return m_vertices; }

  // The first face that is not a triangle, if there is one; counted in the order of faces(tmesh).
  const std::optional<Refusal>& refusal() const { return m_refusal; }

private:
  void number_corners(const FaceGraph& tmesh)
  {
    for(const Halfedge h : halfedges(tmesh))
      put(m_corner, h, no_index);
    m_halfedges.reserve(3 * faces(tmesh).size());
    std::size_t index = 0;
    for(const auto f : faces(tmesh)) {
      std::size_t degree = 0;
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
        if(m_halfedges.size() == std::size_t((std::numeric_limits<Corner_index>::max)()))
          throw std::length_error("Seamless_snapping: a mesh may have up to 715,827,882 triangles");
        put(m_corner, h, Corner_index(m_halfedges.size()));
        m_halfedges.push_back(h);
        ++degree;
      }
      if(degree != 3 && !m_refusal)
        m_refusal = Refusal(Outcome::NOT_TRIANGULAR,
                            name_of_face(index) + " has " + std::to_string(degree) +
                              " edges: triangulate the faces of the mesh first");
      ++index;
    }
  }

  void number_vertices(const FaceGraph& tmesh)
  {
    for(const Vertex v : vertices(tmesh)) {
      put(m_vertex, v, has_face(v, tmesh) ? Flat_vertex_index(m_vertices.size()) : no_index);
      if(get(m_vertex, v) != no_index)
        m_vertices.push_back(v);
    }
  }

  static bool has_face(const Vertex v, const FaceGraph& tmesh)
  {
    if(halfedge(v, tmesh) == Graph_traits::null_halfedge())
      return false;
    for(const Halfedge h : CGAL::halfedges_around_target(v, tmesh))
      if(!is_border(h, tmesh))
        return true;
    return false;
  }

  Property_map<CGAL::dynamic_halfedge_property_t<Corner_index> > m_corner;
  Property_map<CGAL::dynamic_vertex_property_t<Flat_vertex_index> > m_vertex;
  std::vector<Halfedge> m_halfedges;
  std::vector<Vertex> m_vertices;
  std::optional<Refusal> m_refusal;
};

// Fills the connectivity of `mesh`, and calls add(corner, halfedge) for what else is to be known of
// each corner. At a vertex whose faces form several fans, `corner_at_vertex` leads to one of them.
// \pre `numbering` has no defect
template <typename ConcurrencyTag, typename FaceGraph, typename Corner, typename Add>
void read_flat_mesh(const FaceGraph& tmesh, const Flat_numbering<FaceGraph>& numbering,
                    Flat_mesh<Corner>& mesh, const Add& add)
{
  const auto& halfedges = numbering.halfedges_of_corners();
  mesh.corners.resize(halfedges.size(), boost::container::default_init);
  for_each_chunk<ConcurrencyTag>(chunks_of(halfedges.size()), [&](const Chunk& chunk) {
    for(std::size_t i = chunk.begin; i < chunk.end; ++i) {
      mesh.corners[i].opposite = numbering.corner(opposite(halfedges[i], tmesh));
      mesh.corners[i].vertex = numbering.vertex(target(halfedges[i], tmesh));
      add(mesh.corners[i], halfedges[i]);
    }
  });
  mesh.corner_at_vertex.assign(numbering.vertices_in_order().size(), no_index);
  mesh.is_border.assign(numbering.vertices_in_order().size(), false);
  for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const std::size_t v = mesh.vertex(h);
    const bool starts_fan = mesh.clockwise(h) == no_index;
    if(mesh.corner_at_vertex[v] == no_index || (starts_fan && !mesh.is_border[v]))
      mesh.corner_at_vertex[v] = h;
    if(starts_fan)
      mesh.is_border[v] = true;
  }
}

// The first vertex whose faces form several fans, if there is one.
template <typename Corner>
std::optional<Refusal> find_several_fans(const Flat_mesh<Corner>& mesh)
{
  std::vector<int> degree(mesh.number_of_vertices(), 0);
  for(const Corner& c : mesh.corners)
    ++degree[std::size_t(c.vertex)];
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    for_each_corner(mesh, v, [&](Corner_index) { --degree[v]; });
    if(degree[v] != 0)
      return Refusal(Outcome::NOT_MANIFOLD,
                     "the faces around a vertex of " +
                       name_of_face(std::size_t(mesh.face(mesh.corner_at_vertex[v]))) +
                       " form more than one fan: " + term(duplicate_vertices));
  }
  return std::nullopt;
}

// A point or vector, rounded.
template <typename Point>
Place place_of(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// The values of a map for each of some elements.
template <typename Elements, typename Map>
std::vector<Place> places_of(const Elements& elements, const Map& map)
{
  std::vector<Place> result;
  for(const auto e : elements)
    result.push_back(place_of(get(map, e)));
  return result;
}

// The weighted sum of the corners of a face, in floating point: of the one that `h` points to, and
// those that follow.
template <typename TriangleMesh, typename VertexPointMap, typename Halfedge>
Place place_in_face(const TriangleMesh& tmesh, const VertexPointMap& points, Halfedge h,
                    const std::array<double, 3>& weights)
{
  Place sum{};
  for(const double w : weights) {
    if(w != 0) {
      const Place p = place_of(get(points, target(h, tmesh)));
      for(std::size_t c = 0; c < 3; ++c)
        sum[c] += w * p[c];
    }
    h = next(h, tmesh);
  }
  return sum;
}

// Marks, per corner, the edges that are features; empty if none are given.
template <typename TriangleMesh, typename NamedParameters>
std::vector<char> feature_corners(const TriangleMesh& tmesh,
                                  const Flat_numbering<TriangleMesh>& numbering,
                                  const NamedParameters& np)
{
  std::vector<char> is_feature;
  const auto map = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
  if constexpr(is_given<decltype(map)>)
    for(const auto h : numbering.halfedges_of_corners())
      is_feature.push_back(get(map, edge(h, tmesh)) ? 1 : 0);
  return is_feature;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_FLAT_MESH_H
