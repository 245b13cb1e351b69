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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_EXTRACT_CELLS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_EXTRACT_CELLS_H

#include <CGAL/license/Quad_remeshing.h>

// From an integer-grid map and named parameters to the cells of the grid: the common part of the
// extractions of quads and of triangles.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/cell_outputs.h>
#include <CGAL/Quad_remeshing/types/Extraction_report.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/container/vector.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The parameters of the extraction of quads from a map.
constexpr auto extraction_parameters =
  named<CGAL::internal_np::allow_holes, CGAL::internal_np::edge_is_constrained,
        CGAL::internal_np::grid_scale, CGAL::internal_np::maximum_number,
        CGAL::internal_np::vertex_point>;

// In the order of CGAL's locations: source and target of the face's halfedge, then the third.
template <typename TriangleMesh>
using Location_in_face =
  std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3> >;

// The points of the grid in space, and on the input mesh. locate(point) gives a Face_point.
template <typename TriangleMesh, typename VertexPointMap, typename Locate>
class Grid_embedding
{
public:
  Grid_embedding(const TriangleMesh& tmesh, const VertexPointMap& point_map, const Locate& locate)
    : m_tmesh(tmesh), m_faces(faces(tmesh).begin(), faces(tmesh).end()), m_point_map(point_map),
      m_locate(locate)
  { }

  Location_in_face<TriangleMesh> location(const Lattice_point& p) const
  {
    const Face_point at = m_locate(p);
    return {m_faces[std::size_t(at.face)], {at.weights[2], at.weights[0], at.weights[1]}};
  }

  // The places of all points in space, computed concurrently unless coordinates are objects that
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

template <typename TriangleMesh, typename QuadMesh, typename NamedParameters>
Cell_mesh_output<Location_in_face<TriangleMesh>, QuadMesh, NamedParameters>
cell_mesh_output(const TriangleMesh&, QuadMesh& quads, const NamedParameters& np)
{
  return {quads, np};
}

template <typename NamedParameters>
Extraction_options extraction_options(const NamedParameters& np)
{
  Extraction_options options;
  options.scale = chosen(np, CGAL::internal_np::grid_scale, options.scale);
  options.maximum_number = chosen(np, CGAL::internal_np::maximum_number, options.maximum_number);
  options.allow_holes = chosen(np, CGAL::internal_np::allow_holes, false);
  return options;
}

// For messages. A corner is given by its face, in the order of faces(tmesh), and its place there.
template <typename TriangleMesh, typename NamedParameters>
Message vertex_name(const TriangleMesh& tmesh, const NamedParameters& np, const Corner_index h)
{
  auto corner = halfedge(*std::next(faces(tmesh).begin(), h / 3), tmesh);
  for(int k = h % 3; k > 0; --k)
    corner = next(corner, tmesh);
  return name_of_vertex(std::size_t(
    get(CGAL::get_initialized_vertex_index_map(tmesh, np), target(corner, tmesh))));
}

// Makes the cells, and has them written: by output.locate(extractor, embedding) and
// output.write(extractor), which may refuse that in the extractor's report.
// \param locate_point gives the Face_point of a point, once the points are known
template <typename ConcurrencyTag, typename Group, typename TriangleMesh, typename NamedParameters,
          typename LocatePoint, typename Output>
Extraction_report run_and_write(Cell_extractor<Group>& extractor, const TriangleMesh& tmesh,
                                const NamedParameters& np, const LocatePoint& locate_point,
                                Output& output)
{
  const auto point_map = chosen(np, CGAL::internal_np::vertex_point,
                                CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  for(const auto v : vertices(tmesh))
    if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
      for(const double x : place_of(get(point_map, v)))
        if(!std::isfinite(x))
          return refused<Extraction_report>(
            Outcome::NOT_FINITE,
            name_of_vertex(std::size_t(
              get(CGAL::get_initialized_vertex_index_map(tmesh, np), v))) +
              " has a NaN or infinite coordinate");
  const auto locate = [&] {
    output.template locate<ConcurrencyTag>(extractor,
                                           Grid_embedding(tmesh, point_map, locate_point));
  };
  if(extractor.template run<ConcurrencyTag>(locate))
    output.template write<ConcurrencyTag>(extractor);
  return extractor.report();
}

// Reads the map first.
// \tparam Group the group of the directions of the grid's lines
template <typename ConcurrencyTag, typename Group, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters, typename Output>
Extraction_report extract_cells(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                const NamedParameters& np, Output&& output)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    const Protect_exact_arithmetic protect;
    Basic_chart_mesh<Group> mesh;
    std::vector<char> is_feature;
    {
      const Flat_numbering<TriangleMesh> numbering(tmesh, ConcurrencyTag());
      if(const auto refusal = read_exact_map<ConcurrencyTag>(tmesh, numbering, uv_map, np, mesh))
        return refused<Extraction_report>(*refusal);
      is_feature = feature_corners(tmesh, numbering, np);
    }
    Cell_extractor<Group> extractor(
      std::move(mesh), std::move(is_feature), extraction_options(np),
      [&](const Corner_index h) { return vertex_name(tmesh, np, h); });
    const auto locate_point = [&](const Lattice_point& p)
      { return Face_point{Flat_face_index(extractor.original_face(face_of(p.corner))),
                          weights(extractor.mesh(), p)}; };
    return run_and_write<ConcurrencyTag>(extractor, tmesh, np, locate_point, output);
  }
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_EXTRACT_CELLS_H
