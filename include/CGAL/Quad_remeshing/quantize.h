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

#ifndef CGAL_QUAD_REMESHING_QUANTIZE_H
#define CGAL_QUAD_REMESHING_QUANTIZE_H

#include <CGAL/license/Quad_remeshing.h>

// From an exactly seamless map of any scale to quads: integers for the edges of a coarse
// triangulation, and the quads that they describe.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/internal/cells/extract_cells.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/Straight_walk.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface.h>
#include <CGAL/Quad_remeshing/types/Quantization.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

constexpr auto parameters_of_quantization =
  named<CGAL::internal_np::maximum_feature_loss, CGAL::internal_np::maximum_number,
        CGAL::internal_np::minimize_number_of_quads, CGAL::internal_np::needs_face_graph,
        CGAL::internal_np::target_edge_length, CGAL::internal_np::target_number_of_quads,
        CGAL::internal_np::verbose, CGAL::internal_np::vertex_point,
        CGAL::internal_np::vertex_sizing, CGAL::internal_np::visitor>;

// The parameters of the extraction from a quantization.
constexpr auto quantized_parameters =
  named<CGAL::internal_np::maximum_number, CGAL::internal_np::vertex_point>;
template <typename TriangleMesh, typename NamedParameters>
double area_in_squares(const TriangleMesh& tmesh, const double length, const NamedParameters& np)
{
  const int exponent = std::ilogb(length); // no square is too large then
  const auto size_of = [&]([[maybe_unused]] const auto f) {
    double size = 1;
    if constexpr(is_given<NamedParameters, internal_np::vertex_sizing_t>)
      for(const auto v : CGAL::vertices_around_face(halfedge(f, tmesh), tmesh)) {
        const double at_vertex = CGAL::to_double(
          get(CGAL::parameters::get_parameter(np, internal_np::vertex_sizing), v));
        size *= at_vertex > 0 ? std::cbrt(at_vertex) : std::numeric_limits<double>::quiet_NaN();
      }
    return size;
  };
  const auto point_map = chosen(np, CGAL::internal_np::vertex_point,
                                CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  double area = 0;
  for(const auto f : faces(tmesh)) {
    const auto h = halfedge(f, tmesh);
    std::array<std::array<double, 3>, 3> p;
    auto g = h;
    for(std::array<double, 3>& q : p) {
      q = place_of(get(point_map, target(g, tmesh)));
      for(double& x : q)
        x = std::ldexp(x, -exponent);
      g = next(g, tmesh);
    }
    const auto normal = vector_product(vector_to(p[0], p[1]), vector_to(p[0], p[2]));
    const double size = size_of(f);
    area += std::hypot(normal[0], normal[1], normal[2]) / 2 / (size * size);
  }
  const double scaled = std::ldexp(length, -exponent);
  return area / (scaled * scaled);
}

// Whether lengths tell the number of quads.
template <typename NamedParameters>
constexpr bool has_wanted_length =
  is_given<NamedParameters, internal_np::target_edge_length_t> ||
  (is_given<NamedParameters, internal_np::vertex_sizing_t> &&
   !is_given<NamedParameters, internal_np::target_number_of_quads_t>);

template <typename TriangleMesh, typename NamedParameters>
Quantization_options quantization_options(const TriangleMesh& tmesh, const NamedParameters& np)
{
  Quantization_options options;
  options.is_coarsest = chosen(np, internal_np::minimize_number_of_quads, false);
  options.needs_face_graph = chosen(np, internal_np::needs_face_graph, false);
  if constexpr(has_wanted_length<NamedParameters>) {
    const double length = chosen(np, internal_np::target_edge_length, 1.);
    options.number_of_quads = length > 0 && std::isfinite(length)
                                ? area_in_squares(tmesh, length, np)
                                : std::numeric_limits<double>::quiet_NaN();
  } else {
    options.number_of_quads = chosen(np, internal_np::target_number_of_quads, 10000.);
  }
  constexpr double least_maximum = 100000; // so many take no time
  options.maximum_number = chosen(np, CGAL::internal_np::maximum_number,
                                  (std::max)(100 * options.number_of_quads, least_maximum));
  options.maximum_feature_loss = chosen(np, internal_np::maximum_feature_loss, 0.);
  return options;
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Quantization quantize_map(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                          const NamedParameters& np, const Quantization_options& options)
{
  const Protect_exact_arithmetic protect;
  const Flat_numbering<TriangleMesh> numbering(tmesh);
  const std::vector<char> is_feature = feature_corners(tmesh, numbering, np);
  const auto vertex_indices = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto vertex_name = [&](const std::size_t v)
    { return name_of_vertex(std::size_t(get(vertex_indices, numbering.vertices_in_order()[v]))); };
  Chart_mesh mesh;
  if(const auto refusal = read_exact_map(tmesh, numbering, uv_map, np, mesh))
    return refused<Quantization>(*refusal);
  return quantize_surface(mesh, is_feature, options, vertex_name);
}

template <typename Report>
Report refused_without_quantization(const Quantization& quantization)
{
  return refused<Report>(Outcome::INVALID_ARGUMENT,
                         "there is no quantization" + (quantization.message.empty()
                           ? remedy("quantize() makes one") : ": " + quantization.message));
}

// \param leave_out_folded_cells whether cells that are folded around a point of one edge are left
//        out; the two sides of each hole are to become one edge
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters, typename Output>
Extraction_report extract_cells_of(const Quantization& quantization, const TriangleMesh& tmesh,
                                   const NamedParameters& np, const bool leave_out_folded_cells,
                                   Output&& output)
{
  if(!quantization)
    return refused_without_quantization<Extraction_report>(quantization);
  const Protect_exact_arithmetic protect;
  const Quantized_surface& surface = quantization.surface();
  if(faces(tmesh).size() != surface.coarse->steps.number_of_faces_inside())
    return refused<Extraction_report>(Outcome::INVALID_ARGUMENT,
                                             "the mesh is not the one that has been quantized");
  std::vector<char> is_feature;
  for(const Intrinsic_corner& corner : surface.complex.corners)
    is_feature.push_back(corner.is_wall);
  Extraction_options options = extraction_options(np);
  options.scale = 1;
  options.leave_out_folded_cells = leave_out_folded_cells;
  options.how_to_refine = "quantize to more quads, or with needs_face_graph(true)";
  options.how_to_coarsen = "ask for fewer quads";
  Quad_extractor extractor(
    make_chart_mesh(surface.complex), std::move(is_feature), options,
    [&](const Corner_index h) {
      return name_of_element("vertex", surface.complex.vertex(h)) + " of the coarse triangulation";
    });
  const Point_locator locator(surface.coarse->input, surface.complex, extractor.mesh());
  const auto locate_point = [&](const Lattice_point& p)
    { return surface.coarse->steps.inside(locator.locate(p)); };
  return run_and_write<ConcurrencyTag>(extractor, tmesh, np, locate_point, output);
}

// A quad around a vertex of one edge leaves such a hole.
template <typename QuadMesh>
auto holes_of_two_edges(const QuadMesh& quads)
{
  std::set<typename boost::graph_traits<QuadMesh>::halfedge_descriptor> result;
  for(const auto h : halfedges(quads))
    if(CGAL::is_border(h, quads) && next(next(h, quads), quads) == h &&
       target(h, quads) < source(h, quads))
      result.insert(h);
  return result;
}

// Makes one edge of the two around each hole, except for holes that were there before. Returns the
// number of holes.
template <typename QuadMesh, typename Holes>
std::size_t close_folds(QuadMesh& quads, const Holes& holes_before)
{
  std::size_t number = 0;
  for(const auto h : holes_of_two_edges(quads))
    if(holes_before.find(h) == holes_before.end()) {
      CGAL::Euler::fill_hole(h, quads);
      CGAL::Euler::join_face(opposite(h, quads), quads);
      ++number;
    }
  return number;
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuantization

quantizes an exactly seamless map: finds an all-quad mesh of the surface whose edges follow the map,
at any scale. It needs neither a solver for integer programs nor a tolerance.

The function removes all vertices from the triangulation except cones, corners of the border, and
ends of features. The edges of the coarse triangulation that remains are vectors between cones. The
function rounds them to integers such that all triangles close, match across edges, and stay
positive. `extract_quad_mesh()` of the result makes the quads.

\par Guarantee
The function finds integers for each exactly seamless map of positive faces, except if numbers
exceed 64 bits, if the number of quads exceeds `maximum_number`, or if a border edge is nearly, but
not exactly, on an isocurve. If coordinates near the origin are too fine for 64 bits, it moves a
copy of the map, which rounds it, and snaps the copy; it refuses the map only if faces are too thin
for that.

\par Border
Two sides of quads run along a border edge that lies on no isocurve. Their common vertex lies on the
edge. The report counts such edges.

\par Number of quads
If no integers exist at the wanted scale, the search starts at a finer scale and comes back as far
as it can. So the number of quads can exceed the wanted one, by far if cones lie close together. If
it exceeds `maximum_number`, the status is `TOO_LARGE`, and the message has the number that would
work.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_number_of_quads}
    \cgalParamDescription{the wanted number of quads, from 1 to \f$ 2^{28} \f$}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{10000}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the wanted length of edges of quads, instead of a number}
    \cgalParamType{`double`}
    \cgalParamDefault{not used; `1` with `vertex_sizing_map` and without a number}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_sizing_map}
    \cgalParamDescription{the wanted edge lengths at the vertices of `tmesh`, in multiples of
                          `target_edge_length`, for which the map was made. They determine the
                          number of quads.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number
                   as value type}
    \cgalParamDefault{`1` everywhere}
  \cgalParamNEnd
  \cgalParamNBegin{minimize_number_of_quads}
    \cgalParamDescription{whether to make as few quads as the search finds. Then the other targets
                          are not used.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{needs_face_graph}
    \cgalParamDescription{whether the quads have to form a face graph. Coarse quads can meet
                          themselves, or each other twice, which no face graph can hold. If
                          `true`, the function increases the number of quads until they form
                          one.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the largest number of quads. If cones and features force more, the
                          function fails, and the message says so.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{a hundred times the number wanted, and at least 100,000}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_feature_loss}
    \cgalParamDescription{the part of the length of all features, measured in the map, that may be
                          released if features force more quads than wanted. The features that
                          force most quads for their length go first, until there are about as many
                          quads as wanted. The report lists them.}
    \cgalParamType{`double`, from 0 to 1}
    \cgalParamDefault{`0`: all are kept}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges. Feature edges on isocurves become chains of edges of
                          quads.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`, for `target_edge_length`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is called with the progress of the search, as by `quad_remesh()`, and may
                          end it}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the quantization; converts to `true` if and only if there is one. Otherwise
        `Quantization::status` is a status of `Seam_transitions::failure()`, or
        - `INVALID_ARGUMENT`: the mesh has no face, the number of quads is less than 1 or more than
          \f$ 2^{28} \f$ or `maximum_number`, the length is not positive, or
          `maximum_feature_loss` is not from 0 to 1;
        - `NOT_SEAMLESS`: the map is not exactly seamless;
        - `NOT_POSITIVE`: faces are flipped or degenerate in the domain;
        - `NOT_ALIGNED`: border edges lie on isocurves nearly, but not exactly;
        - `TOO_LARGE`: there would be more quads than `maximum_number`, or integers of 64 bits do
          not hold the coordinates;
        - `INTERNAL_ERROR`: the integers failed the check at the end.
        .
        The message names the place and the remedy. After success, it reports quads that features
        force, released features, and border edges off isocurves.

\par Complexity
Linear in the number of faces, except for a logarithmic factor, until the coarse triangulation is
found. Then a shortest path on the coarse triangulation for each move; its size depends on the
numbers of cones, corners, features, and border edges off isocurves only. All moves together have a
bound on their work. If it is spent, the function returns the first quads that it finds, and the
message says so.

\sa `snap_to_seamless()`
\sa `quad_remesh()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Quantization quantize(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr auto read = internal::parameters_of_quantization +
                        internal::named<CGAL::internal_np::edge_is_constrained>;
  const auto& parameters = internal::strip(np, read);
  const internal::Progress progress(parameters);
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::quantize_map(tmesh, uv_map, parameters,
                                  internal::quantization_options(tmesh, parameters));
}

/*!
\ingroup PkgQuadRemeshingQuantization

finds another number of quads for a map that has been quantized. The coarse triangulation of
`quantize()` is used again, so only the search for integers is left. The result is the same as from
`quantize()`, to the bit.

\tparam TriangleMesh as for `quantize()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param quantization a successful result of `quantize()`
\param tmesh the mesh that has been quantized, not changed since
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the parameters of
       `quantize()` for the number of quads, which are `target_number_of_quads`,
       `target_edge_length`, `minimize_number_of_quads`, `needs_face_graph`, `maximum_number`, and
       `maximum_feature_loss`, which releases further features; `vertex_sizing_map` and
       `vertex_point_map`, which `target_edge_length` needs; and `verbose` and `visitor`

\return as `quantize()`; `INVALID_ARGUMENT` also if `quantization` has failed

\par Complexity
As for `quantize()`, without the computation of the coarse triangulation.

\sa `quantize()`
*/
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Quantization quantize_again(const Quantization& quantization, const TriangleMesh& tmesh,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  if(!quantization)
    return internal::refused_without_quantization<Quantization>(quantization);
  const internal::Protect_exact_arithmetic protect;
  const auto& parameters = internal::strip(np, internal::parameters_of_quantization);
  const internal::Progress progress(parameters);
  return internal::quantize_again(quantization,
                                  internal::quantization_options(tmesh, parameters));
}

/*!
\ingroup PkgQuadRemeshingQuantization

extracts the quads of a quantization. All faces are quads, and they form a mesh that is homeomorphic
to the surface. The function has the checks of `extract_quad_mesh()` of a map. The vertices lie on
the input.

If the quads form no face graph, nothing is written. After a quantization with `needs_face_graph`,
they form one: the quad around a vertex of one edge is left out, and its two other sides become one
edge. If `quads` is a `CGAL::Surface_mesh`, call its `%collect_garbage()` before you use its
indices.

\tparam TriangleMesh as for the extraction from a map
\tparam QuadMesh as for the extraction from a map
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param quantization a successful result of `quantize()`
\param tmesh the mesh that has been quantized, not changed since
\param quads the mesh that the quads are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
       for the points of `tmesh`, and `maximum_number`, as for the extraction from a map
\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" for the output, as
       for the extraction from a map

\return the outcome and counts, as for the extraction from a map; `INVALID_ARGUMENT` if
        `quantization` has failed, or belongs to a mesh with another number of faces

\par Complexity
Linear in the number of quads, and of faces on the straight ways that lead to each of their vertices
from the nearest vertex of the coarse triangulation.

\sa `quantize()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_mesh(const Quantization& quantization, const TriangleMesh& tmesh,
                                    QuadMesh& quads,
                                    const NamedParameters1& np1 =
                                      CGAL::parameters::default_values(),
                                    const NamedParameters2& np2 =
                                      CGAL::parameters::default_values())
{
  const bool leave_out_folds = quantization && quantization.surface().is_for_face_graph;
  decltype(internal::holes_of_two_edges(quads)) holes_before;
  if(leave_out_folds)
    holes_before = internal::holes_of_two_edges(quads);
  const Extraction_report report = internal::extract_cells_of<ConcurrencyTag>(
    quantization, tmesh, internal::strip(np1, internal::quantized_parameters), leave_out_folds,
    internal::cell_mesh_output(tmesh, quads, internal::strip(np2, internal::cell_mesh_parameters)));
  if(report && leave_out_folds)
    internal::close_folds(quads, holes_before);
  return report;
}

/*!
\ingroup PkgQuadRemeshingQuantization

extracts the same quads as points and lists of indices. Loops and double edges are allowed here.
Template parameters are the same as for the extraction from a map.

\param quantization a successful result of `quantize()`
\param tmesh the mesh that has been quantized, not changed since
\param points the points of the quads are added to it
\param polygons the quads are added to it
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
       for the points of `tmesh`, and `maximum_number`, as for the extraction from a map

\return as `extract_quad_mesh()` of a quantization, but never `NO_FACE_GRAPH`

\par Complexity
The complexity of `extract_quad_mesh()` of a quantization.

\sa `quantize()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename PointRange, typename PolygonRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_soup(const Quantization& quantization, const TriangleMesh& tmesh,
                                    PointRange& points, PolygonRange& polygons,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::extract_cells_of<ConcurrencyTag>(
    quantization, tmesh, internal::strip(np, internal::quantized_parameters), false,
    internal::Cell_soup_output<PointRange, PolygonRange>(points, polygons));
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_QUANTIZE_H
