// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_EXTRACT_QUAD_MESH_H
#define CGAL_SEAMLESS_SNAPPING_EXTRACT_QUAD_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// Quad meshes out of exactly seamless integer-grid maps.

#include <CGAL/Seamless_snapping/Extraction_report.h>
#include <CGAL/Seamless_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/quads/quad_outputs.h>
#include <CGAL/Seamless_snapping/internal/read_exact_map.h>
#include <CGAL/Seamless_snapping/internal/repair_integer_grid.h>
#include <CGAL/Seamless_snapping/parameters.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename NamedParameters>
Extraction_options extraction_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Extraction_options options;
  options.scale = choose_parameter(get_parameter(np, CGAL::internal_np::grid_scale), options.scale);
  options.maximum_number = static_cast<std::size_t>(choose_parameter(
    get_parameter(np, CGAL::internal_np::maximum_number), options.maximum_number));
  options.allow_holes = choose_parameter(get_parameter(np, CGAL::internal_np::allow_holes), false);
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

// Reads the map, makes the cells, and has them written: by output.locate(extractor, embedding) and
// output.write(extractor), which may refuse that in the extractor's report.
template <typename ConcurrencyTag, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters, typename Output>
Extraction_report extract_quads(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                const NamedParameters& np, const Extraction_options& options,
                                Output& output)
{
  const Protect_exact_arithmetic protect;
  Chart_mesh mesh;
  std::vector<char> is_feature;
  {
    const Flat_numbering<TriangleMesh> numbering(tmesh, ConcurrencyTag());
    if(const auto refusal =
         read_exact_map<ConcurrencyTag>(tmesh, numbering, uv_map, np, mesh)) {
      Extraction_report report;
      report.status = input_status<Extraction_status>(refusal->status);
      report.message = refusal->message;
      return report;
    }
    is_feature = feature_corners(tmesh, numbering, np);
  }
  Quad_extractor extractor(std::move(mesh), std::move(is_feature), options,
                           [&](const Corner_index h) { return vertex_name(tmesh, np, h); });
  const auto locate = [&] {
    const auto point_map = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
      CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
    const auto locate_point = [&](const Lattice_point& p)
      { return Surface_location{extractor.original_face(face_of(p.corner)),
                                weights(extractor.mesh(), p)}; };
    output.template locate<ConcurrencyTag>(extractor,
                                           make_embedding(tmesh, point_map, locate_point));
  };
  if(extractor.template run<ConcurrencyTag>(locate))
    output.template write<ConcurrencyTag>(extractor);
  return extractor.report();
}

// The same, once faces are repaired in a copy of the map.
template <typename ConcurrencyTag, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters, typename Output>
Extraction_report extract_repaired_quads(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                         const NamedParameters& np, Extraction_options options,
                                         Output& output)
{
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  const auto repaired = get(CGAL::dynamic_halfedge_property_t<Point_2>(), tmesh);
  const Snapping_report repair = repair_integer_grid(tmesh, uv_map, repaired, np);
  if(!repair) {
    Extraction_report report;
    report.status = repair.status == Snapping_status::NOT_INTEGER
                      ? Extraction_status::NOT_INTEGER
                      : input_status<Extraction_status>(repair.status);
    report.message = repair.message;
    return report;
  }
  options.scale = 1;
  Extraction_report report =
    extract_quads<ConcurrencyTag>(tmesh, repaired, np, options, output);
  report.number_of_repaired_faces = repair.run.number_of_repaired_flips;
  return report;
}

template <typename ConcurrencyTag, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters, typename Output>
Extraction_report extract_quads(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                const NamedParameters& np, Output&& output)
{
  Extraction_options options = extraction_options(np);
  const auto flip_repair = CGAL::parameters::get_parameter(np, CGAL::internal_np::repair_flips);
  if constexpr(is_given_parameter(flip_repair)) // snapping is compiled then only
    if(chosen_flip_repair(np) != Flip_repair::NONE) {
      const bool allow_holes = std::exchange(options.allow_holes, false);
      const Extraction_report report =
        extract_quads<ConcurrencyTag>(tmesh, uv_map, np, options, output);
      if(report.status != Extraction_status::NOT_POSITIVE)
        return report;
      options.allow_holes = allow_holes;
      return extract_repaired_quads<ConcurrencyTag>(tmesh, uv_map, np, options, output);
    }
  return extract_quads<ConcurrencyTag>(tmesh, uv_map, np, options, output);
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingQuads

extracts the quad mesh that an exactly seamless integer-grid map describes: its vertices are the
points of the surface with integer coordinates, its edges the pieces of isocurves between them.

If the map is exactly seamless with integer translations, all cones have integer coordinates, border
edges lie on isocurves of integer coordinates, and all faces are positive in the domain, then the
result is a mesh of quads only, homeomorphic to the surface, whose number of quads is the area of
the map, and in which a vertex has valence \f$ 4 - i \f$ at a cone of index \f$ i \f$ and 4
elsewhere inside. All these conditions are checked before, and all these results are checked after
the extraction, exactly; on success they hold. All decisions in between are comparisons and
orientation tests that are exact. There is no tolerance, and nothing is repaired unless
`repair_flips` asks for it.

Beyond that:
- Cones between the lines of the grid are allowed (those of index 1 and -1 with half-integer
  coordinates, for instance): around a cone of index \f$ i \f$ the cell of the grid has
  \f$ 4 - i \f$ corners. `Extraction_report::number_of_other_polygons` counts such cells.
- Where the border does not lie on the grid, the result consists of the cells that the border leaves
  whole; the others are counted.
- Connected parts of the surface do not concern each other.
- A result with loops or double edges, as coarse grids have them, is no face graph, and refused;
  `extract_quad_soup()` gives it.

The result is added to what is in `quads`. It is the same, to the bit, for any number of threads.
Nothing is written unless the extraction succeeds.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_if_available_tag`, or
        `CGAL::Parallel_tag`, which does not compile unless TBB is linked. Unless it is
        `CGAL::Sequential_tag`, several threads read the mesh and its property maps at the same
        time; `quads` is written by one.
\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional
        point with coordinates `x()` and `y()` of type `double` or `float` as value type
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: that of halfedge `h` is the corner of `face(h)` at
       `target(h)`. Values of border halfedges are not read.
\param quads the mesh that the quads are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below, and those of `seam_transitions()`

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive number that the coordinates are multiplied by first. The
                          products must be exact, as those with powers of two are; see
                          `snap_to_seamless()` for others.}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of quads above which the extraction is refused}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{100 million}
    \cgalParamExtra{More than \f$ 2^{28} \f$ quads are always refused.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges. Those on lines of the grid become edges of quads.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is}
  \cgalParamNEnd
  \cgalParamNBegin{repair_flips}
    \cgalParamDescription{whether faces that are flipped or degenerate in the domain are repaired
                          first where that is possible near by, as by `snap_to_seamless()`: on a
                          copy of the map. Integers, and features and borders on lines of the grid,
                          stay where they are.}
    \cgalParamType{Boolean, or `Flip_repair`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_holes}
    \cgalParamDescription{whether faces that are flipped or degenerate in the domain, or that are
                          left so by repairs, are taken for holes, so that the cells that touch or
                          contain them are left out. Otherwise, they are refused.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the new vertices}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, quads)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_location_map}
    \cgalParamDescription{receives for each new vertex where it lies on the input: a face, and its
                          barycentric coordinates there, in the order of
                          `CGAL::Polygon_mesh_processing::Face_location`}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and
                   `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor,
                   std::array<double, 3> >` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{cone_index_map}
    \cgalParamDescription{receives for each new vertex the index of the cone there, in quarter
                          turns; 0 if there is none}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `int` as
                   value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it runs along a feature edge, or is on
                          the border of the result}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome: why nothing was written, where that is, or how much was

\par Complexity
Linear in the number of faces, of quads, and of intersections of edges of the mesh with lines of the
grid; with a logarithmic factor where a face contains many vertices of quads.

\sa `extract_quad_soup()`
\sa `is_integer_grid_map()`
\sa `snap_to_seamless()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_mesh(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                    QuadMesh& quads,
                                    const NamedParameters1& np1 =
                                      CGAL::parameters::default_values(),
                                    const NamedParameters2& np2 =
                                      CGAL::parameters::default_values())
{
  return internal::extract_quads<ConcurrencyTag>(
    tmesh, uv_map, internal::strip(np1),
    internal::quad_mesh_output(tmesh, quads, internal::strip(np2)));
}

/*!
\ingroup PkgSeamlessSnappingQuads

extracts the same quads as `extract_quad_mesh()`, as points and lists of indices. Loops and double
edges are no obstacle here.

\tparam PointRange a model of `BackInsertionSequence` of three-dimensional points
\tparam PolygonRange a model of `BackInsertionSequence` whose value type is constructed from a pair
        of iterators over the indices of a polygon, in counterclockwise order, as
        `std::vector<std::size_t>` is; or is `std::array<Index, 4>`: then maps with cones between
        the lines of the grid are refused

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `extract_quad_mesh()`
\param points the points of the quads are added to it
\param polygons the quads, and the other cells, are added to it
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
       `extract_quad_mesh()` for `np1`

\return the outcome

\sa `extract_quad_mesh()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename PointRange, typename PolygonRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_soup(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                    PointRange& points, PolygonRange& polygons,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::extract_quads<ConcurrencyTag>(
    tmesh, uv_map, internal::strip(np),
    internal::Quad_soup_output<PointRange, PolygonRange>(points, polygons));
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_EXTRACT_QUAD_MESH_H
