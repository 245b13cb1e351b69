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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_EMBEDDING_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_EMBEDDING_H

#include <CGAL/license/Quad_remeshing.h>

// Where the points of the grid lie in space, and the cells as they are written.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Seamless_snapping/internal/mesh/write_cells.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/container/vector.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Places = boost::container::vector<Place>;

// The points of the grid in space, and on the input mesh. locate(point) gives a Face_point.
template <typename TriangleMesh, typename VertexPointMap, typename Locate>
class Grid_embedding
{
public:
  using Location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                             std::array<double, 3> >;

  Grid_embedding(const TriangleMesh& tmesh, const VertexPointMap& point_map, const Locate& locate)
    : m_tmesh(tmesh), m_faces(faces(tmesh).begin(), faces(tmesh).end()), m_point_map(point_map),
      m_locate(locate)
  { }

  // In the order of CGAL's locations: source and target of the face's halfedge, then the third.
  Location location(const Lattice_point& p) const
  {
    const Face_point at = m_locate(p);
    return {m_faces[std::size_t(at.face)], {at.weights[2], at.weights[0], at.weights[1]}};
  }

  // Of all points in space. They are computed concurrently only if coordinates are no objects that
  // threads may share.
  template <typename ConcurrencyTag>
  Places places(const Lattice_points& points) const
  {
    using Point = typename boost::property_traits<VertexPointMap>::value_type;
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    using Tag =
      std::conditional_t<std::is_floating_point_v<FT>, ConcurrencyTag, CGAL::Sequential_tag>;
    Places result(points.size(), boost::container::default_init);
    for_each_chunk<Tag>(chunks_of(points.size()), [&](const Chunk& chunk) {
      for(std::size_t i = chunk.begin; i < chunk.end; ++i)
        result[i] = place(m_locate(points[i]));
    });
    return result;
  }

private:
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  Place place(const Face_point& at) const
  {
    return place_in_face(m_tmesh, m_point_map, halfedge(m_faces[std::size_t(at.face)], m_tmesh),
                         at.weights);
  }

  const TriangleMesh& m_tmesh;
  std::vector<Face> m_faces; // in their order
  const VertexPointMap& m_point_map;
  const Locate& m_locate;
};

// The index of the cone at a point, in turns of the group; 0 where there is none.
template <typename Group>
int cone_index(const Basic_chart_mesh<Group>& mesh, const Cell_complex& complex,
               const std::size_t p)
{
  const Lattice_point& point = complex.points[p];
  return point.place == Lattice_place::VERTEX && mesh.is_singular[mesh.vertex(point.corner)]
           ? Group::order - int(complex.darts.degree(p)) : 0;
}

// The cells for `Cell_writer`.
class Cells_to_write
{
public:
  Cells_to_write(const Cell_complex& complex, const Cell_vertices& vertices)
    : m_complex(complex), m_vertices(vertices)
  { }

  std::size_t number_of_vertices() const { return m_vertices.size(); }
  std::size_t number_of_cells() const { return m_complex.cells.size(); }
  std::size_t number_of_darts() const { return m_complex.darts.size(); }
  bool is_edge(const std::size_t d) const { return m_complex.is_edge(d); }
  std::size_t twin(const std::size_t d) const { return m_complex.twin(d); }
  Cell_index cell(const std::size_t d) const { return m_complex.cells.cell(d); }

  // Around cells, and the holes that folded cells leave; a dart of the border is followed by the
  // one at the other end of the fan around its target.
  std::size_t next(const std::size_t d) const
  {
    if(m_complex.has_cell(d))
      return m_complex.next(d);
    if(m_complex.is_folded(d)) {
      std::size_t following = m_complex.next(d);
      while(!is_edge(following))
        following = m_complex.next(following);
      return following;
    }
    std::size_t last = twin(d);
    while(!m_complex.is_gap(last))
      last = m_complex.darts.counterclockwise(last);
    return last;
  }

  std::size_t target(const std::size_t d) const
  { return m_vertices.vertex(m_complex.has_cell(d) ? m_complex.next(d) : twin(d)); }

private:
  const Cell_complex& m_complex;
  const Cell_vertices& m_vertices;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_GRID_EMBEDDING_H
