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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// A triangle soup as a face graph, and the coordinates of its corners as coordinates of halfedges.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/Used_vertices.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The vertices of a soup. Messages name them by the caller's indices.
struct Soup_vertex_map
{
  using key_type = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>::Vertex_index;
  using value_type = std::size_t;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const std::vector<std::size_t>* names; // per vertex

  friend value_type get(const Soup_vertex_map&, const key_type v) { return std::size_t(v); }
  friend const std::vector<std::size_t>* vertex_names(const Soup_vertex_map& map)
  { return map.names; }
};

// Invariant after `read()`: face i is triangle i. Vertices are in the order of the caller's
// indices. If the faces around a vertex form several fans, the further ones have vertices of their
// own, after all others. The points only make all vertices differ.
class Soup_surface
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Halfedge = Mesh::Halfedge_index;
  using Corner_map = Mesh::Property_map<Halfedge, std::size_t>;
  using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

  // \param feature_edges a range of pairs of vertices, or none
  template <typename TriangleRange, typename EdgeRange>
  std::optional<Refusal> read(const TriangleRange& triangles, const EdgeRange& feature_edges)
  {
    std::vector<std::size_t> corners;
    if(auto refusal = read_triangles(triangles, corners))
      return refusal;
    const Used_vertices used(std::move(corners));
    number_vertices(used);
    std::optional<Soup_edges<Soup::Triangle> > edges;
    Vertex_changes changes;
    try {
      edges = connect_soup(false, m_soup, changes);
    } catch(const File_refusal& refusal) {
      return Refusal(Outcome::NOT_MANIFOLD, refusal.message());
    }
    const auto vertices = add_vertices(m_soup.points, changes, m_mesh, m_mesh.points());
    for(const std::size_t v : changes.file_vertices)
      m_names.push_back(m_soup.vertex_names[v]);
    const auto uv = m_mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
    const std::vector<Halfedge> halfedges = add_triangles(m_soup, vertices, m_mesh, uv);
    for(std::size_t c = 0; c < halfedges.size(); ++c) // from corner c to the next
      m_corner[m_mesh.prev(halfedges[c])] = c;
    return read_features(feature_edges, used, *edges, halfedges);
  }

  const Mesh& mesh() const { return m_mesh; }
  const Corner_map& corner() const { return m_corner; } // per halfedge, except on the border
  const Edge_map& is_feature() const { return m_is_feature; }
  Soup_vertex_map vertex_index() const { return {&m_names}; }

private:
  using Soup = Corner_soup<double, double>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

  static Refusal invalid(const Message& message)
  {
    return {Outcome::INVALID_ARGUMENT, message};
  }

  // \param corners receives the caller's index of each corner
  template <typename TriangleRange>
  std::optional<Refusal> read_triangles(const TriangleRange& triangles,
                                        std::vector<std::size_t>& corners)
  {
    constexpr std::int64_t largest = (std::int64_t(1) << 31) - 2;
    for(const auto& triangle : triangles) {
      const Message face = name_of_face(m_soup.triangles.size());
      Soup::Triangle t{};
      std::size_t size = 0;
      for(const auto index : triangle) {
        const std::int64_t v = static_cast<std::int64_t>(index);
        if(v < 0 || v > largest)
          return invalid(face + " has the vertex " + std::to_string(v) +
                         remedy("vertices are integers from 0 to 2^31 - 2"));
        if(size < 3)
          t.vertices[size] = Soup_index(v);
        ++size;
        corners.push_back(std::size_t(v));
      }
      if(size != 3)
        return Refusal(Outcome::NOT_TRIANGULAR, face + " has " + std::to_string(size) +
                       " corners" + remedy("triangulate the surface first"));
      const auto& v = t.vertices;
      if(v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
        return invalid(face + " has a vertex twice" + remedy("remove it first"));
      m_soup.triangles.push_back(t);
    }
    return std::nullopt;
  }

  void number_vertices(const Used_vertices& used)
  {
    for(Soup::Triangle& triangle : m_soup.triangles)
      for(Soup_index& v : triangle.vertices)
        v = used.number(v);
    m_soup.vertex_names = used.names();
    for(std::size_t v = 0; v < used.names().size(); ++v)
      m_soup.points.push_back({double(v), 0, 0});
    m_soup.uvs.resize(1); // the caller's map has the coordinates
  }

  template <typename EdgeRange>
  std::optional<Refusal> read_features(const EdgeRange& feature_edges, const Used_vertices& used,
                                       const Soup_edges<Soup::Triangle>& edges,
                                       const std::vector<Halfedge>& halfedges)
  {
    if constexpr(is_given<EdgeRange>)
      for(const auto& edge : feature_edges) {
        if(std::distance(std::begin(edge), std::end(edge)) != 2)
          return invalid(term("feature_edges") + ": an edge has not 2 vertices");
        const auto u = static_cast<std::int64_t>(*std::begin(edge));
        const auto v = static_cast<std::int64_t>(*std::next(std::begin(edge)));
        const Side_index side = edges.find(used.number(std::size_t(u)),
                                           used.number(std::size_t(v)));
        if(side == Soup_edges<Soup::Triangle>::no_side)
          return invalid(term("feature_edges") + ": there is no edge between the " +
                         name_of_vertex(std::size_t(u), "vertices") + " and " +
                         name_of_vertex(std::size_t(v), ""));
        m_is_feature[m_mesh.edge(halfedges[side])] = true;
      }
    return std::nullopt;
  }

  Soup m_soup;
  std::vector<std::size_t> m_names; // per vertex: the caller's index
  Mesh m_mesh;
  Corner_map m_corner = m_mesh.add_property_map<Halfedge, std::size_t>("h:corner").first;
  Edge_map m_is_feature = m_mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
};

// The coordinates of the corner at the target of a halfedge, in the caller's map.
template <typename CornerUVMap>
struct Soup_uv_map
{
  using key_type = Soup_surface::Halfedge;
  using value_type = typename boost::property_traits<CornerUVMap>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Soup_surface::Corner_map corner;
  mutable CornerUVMap map;

  friend value_type get(const Soup_uv_map& uv, const key_type h)
  {
    using boost::get;
    return get(uv.map, uv.corner[h]);
  }

  friend void put(const Soup_uv_map& uv, const key_type h, const value_type& value)
  {
    using boost::put;
    put(uv.map, uv.corner[h], value);
  }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_SOUP_SURFACE_H
