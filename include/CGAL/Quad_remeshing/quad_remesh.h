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

#ifndef CGAL_QUAD_REMESHING_QUAD_REMESH_H
#define CGAL_QUAD_REMESHING_QUAD_REMESH_H

#include <CGAL/license/Quad_remeshing.h>

// From any triangle mesh to a quad mesh of about the number of quads wanted; and which plane a mesh
// is symmetric by.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_options.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Mirror.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Quad_writer.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Quad_remeshing/types/Remeshing_report.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

constexpr auto remeshing_parameters =
  named<CGAL::internal_np::area_threshold, CGAL::internal_np::border_tolerance,
        CGAL::internal_np::curvature_adaptivity, CGAL::internal_np::curvature_alignment,
        CGAL::internal_np::edge_is_constrained, CGAL::internal_np::face_direction,
        CGAL::internal_np::maximum_feature_loss, CGAL::internal_np::maximum_number,
        CGAL::internal_np::minimize_number_of_quads, CGAL::internal_np::number_of_relaxation_steps,
        CGAL::internal_np::symmetry_plane, CGAL::internal_np::target_edge_length,
        CGAL::internal_np::target_number_of_quads, CGAL::internal_np::verbose,
        CGAL::internal_np::vertex_point, CGAL::internal_np::vertex_sizing,
        CGAL::internal_np::visitor>;

// The parameters of the quads that are written.
constexpr auto quad_mesh_parameters =
  named<CGAL::internal_np::edge_is_constrained, CGAL::internal_np::face_location,
        CGAL::internal_np::vertex_location, CGAL::internal_np::vertex_point>;

template <typename TriangleMesh, typename NamedParameters>
Remeshing_options remeshing_options(const TriangleMesh& tmesh, const NamedParameters& np,
                                    const bool has_single_precision)
{
  constexpr std::size_t most_smoothing_rounds = 1000;
  Quantization_options quantization = quantization_options(tmesh, np);
  quantization.needs_face_graph = true;
  *quantization.work = Work::of_size(double(num_faces(tmesh)) + quantization.number_of_quads);
  return {quantization, chosen(np, internal_np::curvature_alignment, std::optional<double>()),
          chosen(np, internal_np::curvature_adaptivity, 1.),
          chosen(np, internal_np::border_tolerance, std::optional<double>()),
          chosen(np, CGAL::internal_np::area_threshold, std::optional<double>()),
          (std::min)(chosen(np, internal_np::number_of_relaxation_steps, std::size_t(5)),
                     most_smoothing_rounds),
          has_single_precision};
}

template <typename Plane>
std::optional<Mirror> to_mirror(const Plane& plane)
{
  return Mirror(CGAL::to_double(plane.a()), CGAL::to_double(plane.b()),
                CGAL::to_double(plane.c()), CGAL::to_double(plane.d()));
}

template <typename Plane>
std::optional<Mirror> to_mirror(const std::optional<Plane>& plane)
{ return plane ? to_mirror(*plane) : std::nullopt; }

template <typename NamedParameters>
std::optional<Mirror> mirror_of([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::symmetry_plane_t>)
    return to_mirror(CGAL::parameters::get_parameter(np, internal_np::symmetry_plane));
  else
    return std::nullopt;
}

// By how much the area grows, in units of its sizes: a mirror replaces what is below by the image
// of what is above.
double growth_by(const Mirror& mirror, const Marked_surface& input);

// Makes the quads of a surface, as large as the input, in all attempts.
// \param input loses the closed parts that the options leave out
// \param is_feature of the edges of `quads`
Remeshing_report remesh(Marked_surface& input, const std::optional<Mirror>& mirror,
                        const Remeshing_options& options, Remeshing_types::Mesh& quads,
                        const Remeshing_types::Feature_map& is_feature);

// Gives the quads of a quantization a better shape.
Remeshing_report smooth(const Marked_surface& input, const Quantization& quantization,
                        const Remeshing_options& options, Remeshing_types::Mesh& quads,
                        const Remeshing_types::Feature_map& is_feature);

// The largest distances of quads, as large as the input, from all of it, and of it from them; the
// lengths of their edges. Returns the faces of the input that are nearest to elements of `located`.
// \param number_wanted of quads for the input, which tells the unit of sizes; 0 where these are not
// known
Nearest_faces measure_quads(const Marked_surface& input, double number_wanted,
                            Remeshing_types::Mesh quads, Located_elements located,
                            Remeshing_report& report);

// The edges on features of a quantization and on the border.
template <typename TriangleMesh>
auto walls(const Quantization& quantization, const TriangleMesh& tmesh)
{
  const auto result = get(CGAL::dynamic_edge_property_t<bool>(), tmesh);
  for(const auto e : edges(tmesh))
    put(result, e, false);
  const Integer_mesh& mesh = quantization.surface().coarse->input;
  const Flat_numbering<TriangleMesh> numbering(tmesh);
  for(const auto h : numbering.halfedges_of_corners())
    if(mesh.corner(numbering.corner(h)).is_wall)
      put(result, edge(h, tmesh), true);
  return result;
}

// Writes the quads that `make_quads(input, mirror, options, quads, is_feature)` makes.
// \param has_wanted_number whether the options tell how many quads are wanted
template <typename TriangleMesh, typename QuadMesh, typename NamedParameters1,
          typename NamedParameters2, typename MakeQuads>
Remeshing_report write_quads(const TriangleMesh& tmesh, QuadMesh& quads,
                             const NamedParameters1& np1, const NamedParameters2& np2,
                             const bool has_wanted_number, const MakeQuads& make_quads)
{
  using Mesh = Remeshing_types::Mesh;
  using Point =
    typename boost::property_traits<decltype(point_map_of_quads(quads, np2))>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const Protect_exact_arithmetic protect;
  const Progress progress(np1);
  Mesh result;
  const auto is_feature = result.add_property_map<Mesh::Edge_index, bool>("e:is_feature").first;
  Remeshing_options options = remeshing_options(tmesh, np1, std::is_same<FT, float>::value);
  Marked_surface input = read_surface(tmesh, np1);
  const std::optional<Mirror> mirror = mirror_of(np1);
  const double growth = mirror ? growth_by(*mirror, input) : 1;
  if(has_wanted_length<NamedParameters1>)
    options.quantization.number_of_quads *= growth;
  Remeshing_report report = make_quads(input, mirror, options, result, is_feature);
  if(!report)
    return report;
  const double number_wanted = has_wanted_number ? options.number_wanted() / growth : 0;
  const Quad_writer<TriangleMesh, QuadMesh, NamedParameters1, NamedParameters2>
    writer(tmesh, np1, np2);
  const Nearest_faces nearest =
    measure_quads(input, number_wanted, result, writer.located(), report);
  writer.write(result, is_feature, nearest, quads);
  return report;
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingRemeshing

remeshes a triangle mesh with quads only.

The function computes a parametrization along a smooth cross field, makes it exactly seamless,
quantizes it, extracts its quads, and moves their vertices along the surface. Feature edges and
borders become chains of edges of quads.

\par Guarantee
If the function succeeds, the result is a valid face graph of quads. It is homeomorphic to the
input, except that small closed components are left out (`area_threshold`), and that
`symmetry_plane` replaces one half. The report counts inverted and folded quads, released feature
edges, and displaced vertices. If features or cones are close together, there may be no valid mesh
with so few quads. The function then returns the smallest larger mesh that it finds, and the message
says so. If faces stay flipped in each parametrization, the function fails, and `quads` is as
before.

\par Search
If the first result has flaws, the function tries further settings, which \ref QRemeshingSearch
lists, and returns the best result. Results without inverted or folded quads, whose number is near
the wanted one, are better than all others; then results with fewer inverted and folded quads are.
If these are equally many, the function compares the mean scaled Jacobian, less penalties for the
distance from the surface, for more quads than wanted, for released features, and for edges whose
length is not the wanted one. Vertices leave features, and then the surface, only if quads stay bad
otherwise.

\par Bound
All searches together have one bound on their work, which grows with the sizes of input and result.
The work is counted, not timed, so the result does not depend on the speed of the machine. If the
work is spent, the function returns the best result so far, and the message says so.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh
\param quads the mesh that the quads are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
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
  \cgalParamNBegin{minimize_number_of_quads}
    \cgalParamDescription{whether to make as few quads as the search finds}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the largest number of quads. If features and cones force more, the
                          function fails, and the message says so.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{a hundred times the number wanted, and at least 100,000}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_feature_loss}
    \cgalParamDescription{the part of the length of all features that may be released if features
                          force more quads than wanted; see `quantize()`. The report lists them.}
    \cgalParamType{`double`, from 0 to 1}
    \cgalParamDefault{`0`: all are kept}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges; `remove_feature_noise()` unmarks feature edges that are
                          noise}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is a feature}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how strongly the quads follow the principal directions of curvature: see
                          `approximate_seamless_parametrization()`. The default is small: quads run
                          along sharp edges that are no features, and around round parts.}
    \cgalParamType{`double`, 0 or at least 1e-9, or a `std::optional` of it}
    \cgalParamDefault{`0.002`, and less for large meshes; `0` if sizes vary, which direct the field
                      then}
  \cgalParamNEnd
  \cgalParamNBegin{border_tolerance}
    \cgalParamDescription{the largest size of steps of the border that the quads ignore, for example
                          of the cells along which a height field ends. The parametrization sees
                          straight lines within this distance of the border, if they have far
                          fewer corners; the vertices of the quads still lie on the border. Narrow
                          and deep slots are kept. The report counts the corners that are left
                          out.}
    \cgalParamType{`double`, not negative, or a `std::optional` of it}
    \cgalParamDefault{half of the wanted edge length; `0`, which ignores no step, if sizes vary
                      or with `minimize_number_of_quads`}
  \cgalParamNEnd
  \cgalParamNBegin{area_threshold}
    \cgalParamDescription{the function leaves out closed connected components of less area, except
                          the largest one. Marching cubes and scans leave such specks. The report
                          counts them. By default, the function also keeps components that are
                          larger than a hundredth of the largest component.}
    \cgalParamType{`double`, not negative, or a `std::optional` of it}
    \cgalParamDefault{the area of a quad of the wanted mean size; with
                      `minimize_number_of_quads`, `0`, which leaves out no component}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_adaptivity}
    \cgalParamDescription{by how much sizes may vary with curvature, as the ratio of the largest to
                          the smallest size. Sizes are proportional to the inverse square root
                          of the curvature, within this ratio. They are multiplied by
                          `vertex_sizing_map`.}
    \cgalParamType{`double`, at least 1}
    \cgalParamDefault{`1`}
  \cgalParamNEnd
  \cgalParamNBegin{face_direction_map}
    \cgalParamDescription{a property map that associates to each face a direction of its cross, in
                          space. The function projects it to the face. A face with the direction 0,
                          or with a direction perpendicular to the face, is free: the field is
                          smooth there. A few directions guide the field; a direction for each
                          face prescribes the field and its cones. Features take precedence.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `%Vector_3`
                   as value type}
    \cgalParamDefault{all faces are free}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_sizing_map}
    \cgalParamDescription{a property map that associates to each vertex the wanted length of edges
                          of quads there. With `target_number_of_quads`, only the ratios of the
                          sizes count; with `target_edge_length`, they are multiples of this
                          length. The field is the smoothest one of the metric that is scaled by
                          the sizes, so varying sizes add cones. If `face_direction_map` gives
                          the field, quads have these sizes as far as the field allows.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number
                   as value type}
    \cgalParamDefault{all quads are of one size}
    \cgalParamExtra{A size that is not positive and finite, or less than a billionth of the largest
                    one, is refused.}
  \cgalParamNEnd
  \cgalParamNBegin{symmetry_plane}
    \cgalParamDescription{a plane by which the result is its own mirror image. The part of the
                          surface on the positive side is remeshed, aligned to the cut, and
                          mirrored; the other part is replaced. See `find_symmetry_plane()`.}
    \cgalParamType{`%Plane_3` or `std::optional<%Plane_3>`}
    \cgalParamDefault{none}
    \cgalParamExtra{Coordinate planes mirror points exactly. By other planes, mirrored points are
                    rounded to `double`.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_relaxation_steps}
    \cgalParamDescription{the number of rounds of smoothing, at most 1,000; 0 for none}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`5`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress as lines of text, in the calling thread. If it
                          throws, the exception propagates, and `quads` is as before.}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
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
    \cgalParamDescription{receives for each new vertex its place on the input, to interpolate
                          attributes: a face and barycentric coordinates, in the order of
                          `CGAL::Polygon_mesh_processing::Face_location`. At an edge, the face can
                          be any of the nearest faces. On thin plates, the face is on the same side
                          as the quads, even if a face of the other side is nearer.}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and
                   `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor,
                   std::array<double, 3> >` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_location_map}
    \cgalParamDescription{receives for each new face the place on the input that is nearest to its
                          middle, in the same way}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%face_descriptor` as key type and
                   `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor,
                   std::array<double, 3> >` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it runs along a feature edge that is
                          kept, or is on the border}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome, and measurements of the result; converts to `true` if and only if the quads
        were written. Otherwise `Remeshing_report::status` is the status of the step that failed:
        - `INVALID_ARGUMENT`, `NOT_TRIANGULAR`, `NOT_MANIFOLD`, `NOT_FINITE`, `SOLVER_FAILED`, and,
          at degenerate faces, `INVALID_ALIGNMENT`: as for
          `approximate_seamless_parametrization()` and, for numbers of quads, `quantize()`;
          `INVALID_ARGUMENT` also if `symmetry_plane` has no normal, or no face is on its positive
          side;
        - `NOT_POSITIVE`: faces stay flipped in the parametrization;
        - `TOO_LARGE`: there would be more quads than `maximum_number`, or features link too many
          coordinates, see `approximate_seamless_parametrization()`;
        - `NO_FACE_GRAPH`: with `symmetry_plane`, the function found no number of quads for which
          the quads and their mirror image form a face graph;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`;
        - `INTERNAL_ERROR`: a result failed its verification.
        .
        The message names the place and the remedy.

\par Complexity
The parametrization solves sparse linear systems of the size of the input, which take most of the
time. The other steps take nearly linear time in the sizes of input and result. Searches add at most
their bound.

\sa `approximate_seamless_parametrization()`
\sa `snap_to_seamless()`
\sa `quantize()`
\sa `extract_quad_mesh()`
*/
template <typename TriangleMesh, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!std::is_same<TriangleMesh, Quantization>::value>* = nullptr
#endif
          >
Remeshing_report quad_remesh(const TriangleMesh& tmesh, QuadMesh& quads,
                             const NamedParameters1& np1 = CGAL::parameters::default_values(),
                             const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  using namespace internal;
  const auto& parameters = strip(np1, remeshing_parameters);
  return write_quads(tmesh, quads, parameters, strip(np2, quad_mesh_parameters), true, remesh);
}

/*!
\ingroup PkgQuadRemeshingRemeshing

makes the quads of a quantization, and moves their vertices as the other overload does.

If border edges lie on no isocurve, two sides of quads follow each of them. The function then
changes edges next to the border until the number of quads at each border vertex fits its angle.

\tparam TriangleMesh as for the other overload
\tparam QuadMesh as for the other overload
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param quantization a successful result of `quantize()`, with `needs_face_graph`
\param tmesh the mesh that has been quantized, not changed since
\param quads the mesh that the quads are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" of the
       other overload that concern the shape and the mesh: `number_of_relaxation_steps`,
       `vertex_point_map`, `verbose`, and `visitor`. Features are the features of the quantization.
\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" of the other
       overload

\return as the other overload, without the measurements of parametrization and features. If no quads
        were written, `Remeshing_report::status` is a status of `extract_quad_mesh()` of a
        quantization.

\par Complexity
As for the extraction, and a bounded number of searches for the nearest place on `tmesh` for each
quad.

\sa `quantize()`
*/
template <typename TriangleMesh, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Remeshing_report quad_remesh(const Quantization& quantization, const TriangleMesh& tmesh,
                             QuadMesh& quads,
                             const NamedParameters1& np1 = CGAL::parameters::default_values(),
                             const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  using namespace internal;
  constexpr auto read =
    named<CGAL::internal_np::number_of_relaxation_steps, CGAL::internal_np::verbose,
          CGAL::internal_np::vertex_point, CGAL::internal_np::visitor>;
  const auto& parameters = strip(np1, read);
  const auto make_quads = [&](const Marked_surface&, const auto&, const auto& options, auto& result,
                              const auto& is_feature) {
    const Extraction_report extracted =
      extract_quad_mesh(quantization, tmesh, result,
                        CGAL::parameters::vertex_point_map(
                          chosen(parameters, CGAL::internal_np::vertex_point,
                                 CGAL::get_const_property_map(CGAL::vertex_point, tmesh))),
                        CGAL::parameters::edge_is_constrained_map(is_feature));
    if(!extracted)
      return refused<Remeshing_report>(extracted.status, extracted.message);
    const auto features = walls(quantization, tmesh);
    return smooth(read_surface(tmesh, parameters.edge_is_constrained_map(features)), quantization,
                  options, result, is_feature);
  };
  return write_quads(tmesh, quads, parameters, strip(np2, quad_mesh_parameters), false, make_quads);
}

} // namespace Quad_remeshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Quad_remeshing/internal/quad_remesh_impl.h>
#endif

#endif // CGAL_QUAD_REMESHING_QUAD_REMESH_H
