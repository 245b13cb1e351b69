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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_WRITE_QUADS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_WRITE_QUADS_H

#include <CGAL/license/Seamless_snapping.h>

// Writes the cells: into a halfedge data structure, or as points and lists of their indices.

#include <CGAL/Seamless_snapping/internal/quads/place_on_surface.h>
#include <CGAL/Seamless_snapping/internal/quads/Quad_extractor.h>
#include <CGAL/Seamless_snapping/internal/tracing/build_chart_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The points of the grid in space, and on the input mesh. locate(point) gives a Surface_location.
template <typename TriangleMesh, typename VertexPointMap, typename Locate>
class Grid_embedding
{
public:
  using Location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                             std::array<double, 3> >;

  Grid_embedding(const TriangleMesh& tmesh, const VertexPointMap& point_map,
                 const Flat_numbering<TriangleMesh>& numbering, const Locate& locate)
    : m_tmesh(tmesh), m_point_map(point_map), m_numbering(numbering), m_locate(locate)
  { }

  // In the order of CGAL's locations: source and target of the face's halfedge, then the third.
  Location location(const Lattice_point& p) const
  {
    const Surface_location at = m_locate(p);
    const Weights& w = at.weights;
    return {face(corner(at, 0), m_tmesh), {w[2], w[0], w[1]}};
  }

  template <typename Point>
  Point point(const Lattice_point& p) const
  {
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    const Surface_location at = m_locate(p);
    const Weights& w = at.weights;
    std::array<double, 3> sum{};
    for(std::size_t k = 0; k < 3; ++k) {
      if(w[k] == 0)
        continue;
      const auto& q = get(m_point_map, target(corner(at, k), m_tmesh));
      sum[0] += w[k] * CGAL::to_double(q.x());
      sum[1] += w[k] * CGAL::to_double(q.y());
      sum[2] += w[k] * CGAL::to_double(q.z());
    }
    return Point(FT(sum[0]), FT(sum[1]), FT(sum[2]));
  }

private:
  auto corner(const Surface_location& at, const std::size_t k) const
  { return m_numbering.halfedges_of_corners()[3 * at.face + k]; }

  const TriangleMesh& m_tmesh;
  const VertexPointMap& m_point_map;
  const Flat_numbering<TriangleMesh>& m_numbering;
  const Locate& m_locate;
};

template <typename TriangleMesh, typename VertexPointMap, typename Locate>
auto make_embedding(const TriangleMesh& tmesh, const VertexPointMap& point_map,
                    const Flat_numbering<TriangleMesh>& numbering, const Locate& locate)
{
  return Grid_embedding<TriangleMesh, VertexPointMap, Locate>(tmesh, point_map, numbering, locate);
}

// The index of the cone at a point, in quarter turns; 0 where there is none.
inline int cone_index(const Chart_mesh& mesh, const Quad_complex& complex, const std::size_t p)
{
  const Lattice_point& point = complex.points[p];
  return point.place == Lattice_place::VERTEX && mesh.is_singular[mesh.vertex(point.corner)]
           ? 4 - int(complex.darts.degree(p)) : 0;
}

// Adds the cells to a graph.
template <typename Graph>
class Quad_writer
{
  using Graph_traits = boost::graph_traits<Graph>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Face = typename Graph_traits::face_descriptor;

public:
  Quad_writer(const Quad_complex& complex, const Cell_vertices& vertices, Graph& graph)
    : m_complex(complex), m_vertices(vertices), m_graph(graph)
  { }

  // Calls at_vertex(descriptor, index) for each vertex and at_edge(descriptor, dart) for each edge.
  template <typename At_vertex, typename At_edge>
  void run(const At_vertex& at_vertex, const At_edge& at_edge)
  {
    using size_type = typename Graph_traits::vertices_size_type;
    reserve(m_graph, size_type(num_vertices(m_graph) + m_vertices.size()),
            size_type(num_edges(m_graph) + number_of_edges()),
            size_type(num_faces(m_graph) + m_complex.cells.size()));
    for(std::size_t v = 0; v < m_vertices.size(); ++v) {
      m_new_vertices.push_back(add_vertex(m_graph));
      at_vertex(m_new_vertices.back(), v);
    }
    add_edges(at_edge);
    for(std::size_t c = 0; c < m_complex.cells.size(); ++c)
      add_cell(c);
    link_border();
  }

private:
  std::size_t number_of_edges() const
  {
    std::size_t n = 0;
    for(std::size_t d = 0; d < m_complex.darts.size(); ++d)
      n += m_complex.is_edge(d) && d < m_complex.twin(d) ? 1 : 0;
    return n;
  }

  template <typename At_edge>
  void add_edges(const At_edge& at_edge)
  {
    m_halfedges.resize(m_complex.darts.size());
    for(std::size_t d = 0; d < m_complex.darts.size(); ++d) {
      if(!m_complex.is_edge(d) || m_complex.twin(d) < d)
        continue;
      const auto e = add_edge(m_graph);
      m_halfedges[d] = halfedge(e, m_graph);
      m_halfedges[m_complex.twin(d)] = opposite(m_halfedges[d], m_graph);
      at_edge(e, d);
    }
  }

  void add_cell(const std::size_t cell)
  {
    const Face f = add_face(m_graph);
    set_halfedge(f, m_halfedges[m_complex.cells.first_dart(cell)], m_graph);
    m_complex.cells.for_darts(cell, [&](const std::size_t d) {
      const std::size_t next = m_complex.next(d);
      const Vertex v = m_new_vertices[m_vertices.vertex(next)];
      set_face(m_halfedges[d], f, m_graph);
      set_next(m_halfedges[d], m_halfedges[next], m_graph);
      set_target(m_halfedges[d], v, m_graph);
      set_halfedge(v, m_halfedges[d], m_graph);
    });
  }

  // A border halfedge d is followed by the one at the other end of the fan around its target.
  void link_border()
  {
    for(std::size_t d = 0; d < m_complex.darts.size(); ++d) {
      if(!m_complex.is_edge(d) || m_complex.has_cell(d))
        continue;
      std::size_t last = m_complex.twin(d);
      const Vertex v = m_new_vertices[m_vertices.vertex(last)];
      while(m_complex.has_cell(last))
        last = m_complex.darts.counterclockwise(last);
      set_face(m_halfedges[d], Graph_traits::null_face(), m_graph);
      set_next(m_halfedges[d], m_halfedges[last], m_graph);
      set_target(m_halfedges[d], v, m_graph);
      set_halfedge(v, m_halfedges[d], m_graph);
    }
  }

  const Quad_complex& m_complex;
  const Cell_vertices& m_vertices;
  Graph& m_graph;
  std::vector<Vertex> m_new_vertices;
  std::vector<Halfedge> m_halfedges; // per dart
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_WRITE_QUADS_H
