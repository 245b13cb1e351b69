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

// From an integer-grid map and named parameters to the cells of the grid: what the extractions of
// quads and of triangles have in common.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/cell_outputs.h>
#include <CGAL/Quad_remeshing/types/Extraction_report.h>
#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

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
std::string vertex_name(const TriangleMesh& tmesh, const NamedParameters& np, const Corner_index h)
{
  auto corner = halfedge(*std::next(faces(tmesh).begin(), h / 3), tmesh);
  for(int k = h % 3; k > 0; --k)
    corner = next(corner, tmesh);
  return std::to_string(
    get(CGAL::get_initialized_vertex_index_map(tmesh, np), target(corner, tmesh)));
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
  const auto locate = [&] {
    const auto point_map = chosen(np, CGAL::internal_np::vertex_point,
                                  CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
    output.template locate<ConcurrencyTag>(extractor,
                                           Grid_embedding(tmesh, point_map, locate_point));
  };
  if(extractor.template run<ConcurrencyTag>(locate))
    output.template write<ConcurrencyTag>(extractor);
  return extractor.report();
}

// Reads the map first.
// \tparam Group that of the directions of the grid's lines
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
