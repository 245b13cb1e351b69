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

// A triangle soup as a face graph, and the coordinates of its corners as those of halfedges.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant after `read()`: face i is triangle i, and vertex v is that of index v; where the faces
// around it form several fans, the further ones have vertices of their own, after all others. Where
// a vertex lies in space means nothing, but that it is elsewhere than the others.
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
    if(auto refusal = read_triangles(triangles))
      return refusal;
    std::optional<Soup_edges<Soup::Triangle> > edges;
    Vertex_changes changes;
    try {
      edges = connect_soup(false, m_soup, changes);
    } catch(const File_refusal& refusal) {
      return Refusal(Outcome::NOT_MANIFOLD, refusal.message());
    }
    const auto vertices = add_vertices(m_soup.points, changes, m_mesh, m_mesh.points());
    const auto uv = m_mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
    const std::vector<Halfedge> halfedges = add_triangles(m_soup, vertices, m_mesh, uv);
    for(std::size_t c = 0; c < halfedges.size(); ++c) // from corner c to the next
      m_corner[m_mesh.prev(halfedges[c])] = c;
    return read_features(feature_edges, *edges, halfedges);
  }

  const Mesh& mesh() const { return m_mesh; }
  const Corner_map& corner() const { return m_corner; } // per halfedge, except on the border
  const Edge_map& is_feature() const { return m_is_feature; }

private:
  using Soup = Corner_soup<double, double>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

  static Refusal invalid(const std::string& message)
  {
    return {Outcome::INVALID_ARGUMENT, message};
  }

  template <typename TriangleRange>
  std::optional<Refusal> read_triangles(const TriangleRange& triangles)
  {
    constexpr std::int64_t largest = (std::int64_t(1) << 31) - 2;
    std::size_t number_of_vertices = 0;
    for(const auto& triangle : triangles) {
      const std::string face = "face " + std::to_string(m_soup.triangles.size());
      Soup::Triangle t{};
      std::size_t size = 0;
      for(const auto index : triangle) {
        const std::int64_t v = static_cast<std::int64_t>(index);
        if(v < 0 || v > largest)
          return invalid(face + " has the vertex " + std::to_string(v) +
                         "; vertices are integers from 0 to 2^31 - 2");
        if(size < 3)
          t.vertices[size] = Soup_index(v);
        ++size;
        number_of_vertices = (std::max)(number_of_vertices, std::size_t(v) + 1);
      }
      if(size != 3)
        return Refusal(Outcome::NOT_TRIANGULAR, face + " has " + std::to_string(size) +
                       " corners; triangulate the surface first");
      const auto& v = t.vertices;
      if(v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
        return invalid(face + " has a vertex twice; remove it first");
      m_soup.triangles.push_back(t);
    }
    m_soup.uvs.resize(1); // the caller's map has those that count
    m_soup.points.resize(number_of_vertices);
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      m_soup.points[v] = {double(v), 0, 0};
    return std::nullopt;
  }

  template <typename EdgeRange>
  std::optional<Refusal> read_features(const EdgeRange& feature_edges,
                                       const Soup_edges<Soup::Triangle>& edges,
                                       const std::vector<Halfedge>& halfedges)
  {
    if constexpr(is_given<EdgeRange>)
      for(const auto& edge : feature_edges) {
        if(std::distance(std::begin(edge), std::end(edge)) != 2)
          return invalid("feature_edges: an edge has not 2 vertices");
        const auto u = static_cast<std::int64_t>(*std::begin(edge));
        const auto v = static_cast<std::int64_t>(*std::next(std::begin(edge)));
        const Side_index side = edges.find(std::size_t(u), std::size_t(v));
        if(side == Soup_edges<Soup::Triangle>::no_side)
          return invalid("feature_edges: there is no edge between the vertices " +
                         std::to_string(u) + " and " + std::to_string(v));
        m_is_feature[m_mesh.edge(halfedges[side])] = true;
      }
    return std::nullopt;
  }

  Soup m_soup;
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
