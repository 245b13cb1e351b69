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

#ifndef CGAL_QUAD_REMESHING_APPROXIMATE_SEAMLESS_PARAMETRIZATION_H
#define CGAL_QUAD_REMESHING_APPROXIMATE_SEAMLESS_PARAMETRIZATION_H

#include <CGAL/license/Quad_remeshing.h>

// A producer of approximately seamless parametrizations: from any triangle mesh to per-corner
// coordinates that `snap_to_seamless()` makes exact.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Seamless_parametrizer.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/read_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/sizes.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingParametrizing

The status and the measurements of `approximate_seamless_parametrization()`, without lists of
vertices.
Converts to `bool`: `true` if and only if the coordinates were written.
*/
struct Parametrization_figures
  : public Report
{
  /// \name Topology
  /// @{
  std::size_t number_of_faces = 0;        ///< faces of the mesh
  std::size_t number_of_components = 0;   ///< connected components
  std::size_t number_of_border_loops = 0; ///< closed sequences of border edges
  /*!
  The Euler characteristic \f$ \chi \f$ of the whole mesh, without isolated vertices: the sum of
  \f$ 2 - 2 g - b \f$ over its components, of genus \f$ g \f$ and with \f$ b \f$ border loops.
  */
  std::ptrdiff_t euler_characteristic = 0;
  std::ptrdiff_t genus = 0; ///< the sum of the genera of the components
  /// @}

  /// \name Field
  /// @{
  /*!
  The number of quarter turns of the borders, relative to the field. This number and the indices of
  the cones add up to \f$ 4 \chi \f$, which the function has verified in integers.
  */
  std::ptrdiff_t border_turning = 0;
  /// @}

  /// \name Parametrization
  /// @{
  std::size_t number_of_cut_edges = 0;        ///< interior edges that were cut open
  std::size_t number_of_cut_branches = 0;     ///< sequences of cut edges that share one transition
  std::size_t number_of_aligned_edges = 0;    ///< edges that are constrained to isocurves
  /// triangles whose area in the plane is not positive, including degenerate triangles, which
  /// `Seamlessness` counts separately
  std::size_t number_of_flipped_faces = 0;
  std::size_t number_of_stiffening_rounds = 0; ///< solves to decrease the number of flips
  std::size_t number_of_flips_before_untangling = 0; ///< flips before untangling
  /// the work of untangling, in iterations over all faces, rounded up
  std::size_t number_of_untangling_iterations = 0;
  double extent = 0;    ///< the larger side of the bounding box of the coordinates
  double violation = 0; ///< largest difference of the sides of a cut edge after rotation
  /// @}

  /// \name Time
  /// @{
  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
  double seconds_in_solvers = 0; ///< the time in sparse factorizations and solves
  /// @}
};

/*!
\ingroup PkgQuadRemeshingParametrizing

The result of `approximate_seamless_parametrization()`.

\tparam VertexDescriptor the vertex descriptor of the mesh
*/
template <typename VertexDescriptor>
struct Parametrization_report
  : public Parametrization_figures
{
  /*!
  The singular vertices in the interior, each with its index: in quarter turns, +1 for a corner of a
  cube (valence 3 of a quadrangulation), -1 for valence 5.
  */
  std::vector<std::pair<VertexDescriptor, int> > cones;
  /// with `release_alignment`, the edges whose alignment was released, each by its two vertices
  std::vector<std::pair<VertexDescriptor, VertexDescriptor> > released_edges;
};

namespace internal {
namespace parametrization {

constexpr auto read_parameters =
  named<CGAL::internal_np::align_border, CGAL::internal_np::cone_index,
        CGAL::internal_np::curvature_adaptivity, CGAL::internal_np::curvature_alignment,
        CGAL::internal_np::edge_is_constrained, CGAL::internal_np::edge_is_cut,
        CGAL::internal_np::face_direction, CGAL::internal_np::halfedge_rotation,
        CGAL::internal_np::known_fields, CGAL::internal_np::largest_cone_index,
        CGAL::internal_np::least_cone_distance, CGAL::internal_np::number_of_iterations,
        CGAL::internal_np::random_seed, CGAL::internal_np::release_alignment,
        CGAL::internal_np::sparse_linear_solver, CGAL::internal_np::target_edge_length,
        CGAL::internal_np::untangling_iterations, CGAL::internal_np::verbose,
        CGAL::internal_np::vertex_point, CGAL::internal_np::vertex_sizing,
        CGAL::internal_np::visitor>;

// The indices that the caller prescribes; border vertices have none.
template <typename TriangleMesh, typename ConeIndexMap>
std::vector<int> read_cones(const Flat_numbering<TriangleMesh>& numbering,
                            const Triangle_surface& surface, const ConeIndexMap cone_index)
{
  std::vector<int> index(surface.number_of_vertices(), 0);
  for(std::size_t v = 0; v < index.size(); ++v)
    if(!surface.is_border[v])
      index[v] = static_cast<int>(get(cone_index, numbering.vertices_in_order()[v]));
  return index;
}

// \param points of the vertices
template <typename TriangleMesh, typename NamedParameters>
Parametrization_options read_options(const TriangleMesh& tmesh,
                                     const Flat_numbering<TriangleMesh>& numbering,
                                     const std::vector<Point>& points,
                                     const Triangle_surface& surface, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  Parametrization_options options;
  options.target_edge_length = chosen(np, internal_np::target_edge_length, 1.);
  options.curvature_alignment = chosen(np, internal_np::curvature_alignment, 0.);
  options.curvature_adaptivity = chosen(np, internal_np::curvature_adaptivity, 1.);
  options.number_of_stiffening_rounds = chosen(np, internal_np::number_of_iterations, 5L);
  const auto most_iterations =
    std::size_t(std::ceil(Work::most_work / double(surface.number_of_faces())));
  options.number_of_untangling_iterations =
    chosen(np, internal_np::untangling_iterations,
           (std::min)(options.number_of_untangling_iterations, most_iterations));
  options.largest_cone_index =
    chosen(np, internal_np::largest_cone_index, options.largest_cone_index);
  options.least_cone_distance = chosen(np, internal_np::least_cone_distance, 0.);
  options.known_fields = chosen(np, internal_np::known_fields, options.known_fields);
  options.may_release = chosen(np, internal_np::release_alignment, false);
  options.random_seed = chosen(np, internal_np::random_seed, 0u);
  if constexpr(is_given<NamedParameters, internal_np::cone_index_t>)
    options.cone_index = read_cones(numbering, surface, get_parameter(np, internal_np::cone_index));
  if constexpr(is_given<NamedParameters, internal_np::face_direction_t>) {
    const auto direction = get_parameter(np, internal_np::face_direction);
    options.directions = read_directions(surface, points, places_of(faces(tmesh), direction));
  }
  if constexpr(is_given<NamedParameters, internal_np::vertex_sizing_t>) {
    const auto size = get_parameter(np, internal_np::vertex_sizing);
    std::vector<double> sizes;
    for(const auto v : numbering.vertices_in_order())
      sizes.push_back(CGAL::to_double(get(size, v)));
    read_sizes(sizes, surface, options);
  }
  check_options(options, surface);
  return options;
}

template <typename TriangleMesh>
void read_connectivity(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                       Triangle_surface& surface)
{
  if(numbering.refusal())
    throw *numbering.refusal();
  read_flat_mesh<CGAL::Sequential_tag>(tmesh, numbering, surface, [](Flat_corner&, const auto) { });
  check_connectivity(surface);
  find_components(surface);
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename Report>
void write_result(const Flat_numbering<TriangleMesh>& numbering, const Triangle_surface& surface,
                  const Parametrization_result& result, HalfedgeUVMap uv_map, Report& report)
{
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using FT = typename Map_number<HalfedgeUVMap>::type;
  for(std::size_t v = 0; v < result.cone_index.size(); ++v)
    if(result.cone_index[v] != 0)
      report.cones.emplace_back(numbering.vertices_in_order()[v], result.cone_index[v]);
  for(const Corner_index h : result.released)
    report.released_edges.emplace_back(numbering.vertices_in_order()[surface.source(h)],
                                       numbering.vertices_in_order()[surface.vertex(h)]);
  for(std::size_t h = 0; h < numbering.halfedges_of_corners().size(); ++h) {
    const std::array<double, 2>& uv = result.uv[result.sector[h]];
    put(uv_map, numbering.halfedges_of_corners()[h], Point_2(FT(uv[0]), FT(uv[1])));
  }
}

// Writes the transitions for callers that give maps for them.
template <typename TriangleMesh, typename NamedParameters>
void write_transitions(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                       const Triangle_surface& surface, const Parametrization_result& result,
                       const NamedParameters& np)
{
  const auto edge_is_cut = CGAL::parameters::get_parameter(np, internal_np::edge_is_cut);
  const auto rotation = CGAL::parameters::get_parameter(np, internal_np::halfedge_rotation);
  for(Corner_index c = 0; c < surface.number_of_halfedges(); ++c) {
    const auto h = numbering.halfedges_of_corners()[std::size_t(c)];
    if constexpr(is_given<decltype(edge_is_cut)>)
      put(edge_is_cut, edge(h, tmesh), result.is_cut[c] && !surface.is_border_edge(c));
    if constexpr(is_given<decltype(rotation)>)
      put(rotation, h, Quarter_turns::turns(result.rotation[c]));
  }
}

// The edges that are to lie on isocurves.
template <typename TriangleMesh, typename NamedParameters>
void read_alignment(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                    const NamedParameters& np, Triangle_surface& surface)
{
  surface.is_aligned = feature_corners(tmesh, numbering, np);
  surface.is_aligned.resize(surface.number_of_halfedges(), false);
  if(chosen(np, internal_np::align_border, false))
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
      surface.is_aligned[h] = surface.is_aligned[h] || surface.is_border_edge(h);
}

// Reads, computes, and writes when nothing can fail any more.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters, typename Report>
void run(const TriangleMesh& tmesh, HalfedgeUVMap uv_map, const NamedParameters& np, Report& report)
{
  using Solver = typename internal_np::Lookup_named_param_def<
    internal_np::sparse_linear_solver_t, NamedParameters, Default_solver>::type;

  const Flat_numbering<TriangleMesh> numbering(tmesh);
  Triangle_surface surface;
  read_connectivity(tmesh, numbering, surface);
  const auto point_map = chosen(np, internal_np::vertex_point,
                                get_const_property_map(CGAL::vertex_point, tmesh));
  const std::vector<Point> points = places_of(numbering.vertices_in_order(), point_map);
  read_geometry(points, surface);
  read_alignment(tmesh, numbering, np, surface);
  const Parametrization_options options = read_options(tmesh, numbering, points, surface, np);
  const Parametrization_result result = parametrize(
    surface, options, Number_format::of<typename Map_number<HalfedgeUVMap>::type>(),
    make_solver<Solver>, static_cast<Parametrization_figures&>(report));
  write_result(numbering, surface, result, uv_map, report);
  write_transitions(tmesh, numbering, surface, result, np);
}

#define CGAL_QUAD_REMESHING_PARAMETRIZE(PREFIX)                                                    \
  PREFIX template Parametrization_result parametrize(                                              \
    Triangle_surface&, const Parametrization_options&, const Number_format&, Make_solver,          \
    Parametrization_figures&);                                                                     \
  PREFIX template std::unique_ptr<Sparse_solver> make_solver<Default_solver>();

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_QUAD_REMESHING_PARAMETRIZE(extern)
#endif

} // namespace parametrization
} // namespace internal

/*!
\ingroup PkgQuadRemeshingParametrizing

\brief computes an approximately seamless, field-aligned parametrization of a triangle mesh.

The mesh may have any genus, any number of components, and borders. The function computes a smooth
cross field, whose singularities become the cones; it cuts the surface open along a graph through
all cones, and computes the coordinates whose gradients are closest to the field in the sense of
least squares. The transition across each cut edge is a rotation by a multiple of 90 degrees and a
translation, up to rounding. `snap_to_seamless()` makes the transitions exact. Other methods have
less distortion; `snap_to_seamless()` takes their output as well.

If triangles are flipped in the least-squares solution, the function stiffens the map around them,
and then untangles it \cgalCite{cgal:gkkprs-ffm-21}, without any change of cuts, cones, and
alignment. There is no guarantee that no triangle stays flipped; the report has their number.
Alignment can make flips unavoidable, for example if the features around a region ask for a
rectangle without width. With `release_alignment`, the function gives up the alignment of some
features there.

All corners of a sector (the corners around a vertex between two cuts) receive the same coordinates,
to the bit. The result depends on the arguments only.

Degenerate faces are allowed: the function enlarges all edge lengths of their component by one small
amount. Vertices without a face are ignored. No topology is refused; the report has the numbers of
border loops and components, and the genus.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `WritablePropertyMap`;
        it is not read
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh
\param uv_map receives the coordinates of each corner; halfedge `h` stands for the corner of
       `face(h)` at `target(h)`. Border halfedges are not touched.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map that tells which edges are features: they are to lie on
                          isocurves of one of the coordinates, and the field is aligned to them}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is a feature}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether border edges are features as well}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how strongly the field follows the principal directions of curvature: 0 is
                          the smoothest field; with 1, they weigh as much as the smoothness if the
                          principal radii are as short as an edge. On spheres and planes, which
                          have no principal directions, the field is the smoothest one that
                          continues the field around them.}
    \cgalParamType{`double`, 0 or at least 1e-9}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_adaptivity}
    \cgalParamDescription{by how much lengths may vary with curvature: see `quad_remesh()`}
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
    \cgalParamExtra{A direction that is not finite is refused. Can't be combined with
                    `cone_index_map`.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_sizing_map}
    \cgalParamDescription{a property map that associates to each vertex the length on the surface
                          that corresponds to one unit in the plane there, in multiples of
                          `target_edge_length`. The field is the smoothest one of the metric that
                          is scaled by these lengths, so it has cones if they vary.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number
                   as value type}
    \cgalParamDefault{`1` everywhere}
    \cgalParamExtra{A size that is not positive and finite, or less than a billionth of the largest
                    one, is refused.}
  \cgalParamNEnd
  \cgalParamNBegin{cone_index_map}
    \cgalParamDescription{a property map that associates to each vertex its wanted index, in
                          quarter turns: 0 for regular vertices, 1 for the corner of a
                          cube, -1 for a vertex of valence 5 in a quadrangulation. The indices of
                          border vertices are ignored.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `int` as
                   value type}
    \cgalParamDefault{the field decides}
    \cgalParamExtra{On each closed component, the indices have to add up to \f$ 4 \chi \f$. Can't be
                    combined with features, `align_border`, `curvature_alignment`, or
                    `face_direction_map`, because given cones leave the field only one free angle
                    and the turns around handles.
                    Indices of 4 or more are refused: the angle of a cone is 4 minus its index.}
  \cgalParamNEnd
  \cgalParamNBegin{largest_cone_index}
    \cgalParamDescription{the largest index that a cone of the field may have, 1, 2, or 3. Larger
                          indices are shared with neighboring vertices. A cone of index 3 is a
                          vertex of valence 1 of a quadrangulation, which no face graph can hold.}
    \cgalParamType{`int`}
    \cgalParamDefault{`3`}
  \cgalParamNEnd
  \cgalParamNBegin{least_cone_distance}
    \cgalParamDescription{a length on the surface. Two cones of opposite indices that are not
                          farther apart, along edges, cancel, the closest pair first. Large quads
                          have room for few cones only. Cones on features and borders stay. If
                          sizes vary, the length is in the metric of the mean size.}
    \cgalParamType{`double`}
    \cgalParamDefault{`0`}
    \cgalParamExtra{Can't be combined with `cone_index_map`.}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length on the surface that corresponds to one unit in the plane}
    \cgalParamType{`double`}
    \cgalParamDefault{`1`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of stiffening rounds, which decrease the number of
                          flipped triangles, each at the cost of one sparse solve}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`5`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_untangling_iterations}
    \cgalParamDescription{a bound on the work of untangling, in iterations over all faces. An
                          iteration costs about as much as a stiffening round; more expensive
                          steps count as several iterations. 0 means no untangling.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`500`, and less for large meshes, such that the bound is about a minute}
  \cgalParamNEnd
  \cgalParamNBegin{release_alignment}
    \cgalParamDescription{whether the function may give up the alignment of feature edges next to
                          flipped triangles, the shortest edge first. The report lists them.
                          Border edges stay aligned.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Do not pass released edges as features to the functions that follow, such as
                    `snap_to_seamless()`.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_cut_map}
    \cgalParamDescription{receives which edges are cuts, for `snap_to_seamless()` and the functions
                          that follow, which then need not find them in the coordinates}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{not used}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_rotation_map}
    \cgalParamDescription{receives the number of counterclockwise quarter turns, from 0 to 3, of the
                          transition across each halfedge that has a face; for the same functions}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int`
                   as value type}
    \cgalParamDefault{not used}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the field from which the search for the smoothest field
                          starts}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{an object whose type the function uses, default constructed, for all
                          sparse systems, which are symmetric and positive definite}
    \cgalParamType{a class model of `SparseLinearAlgebraWithFactorTraits_d`}
    \cgalParamDefault{`CGAL::Eigen_solver_traits` of `Eigen::SimplicialLDLT`, which needs
                      \ref thirdpartyEigen "Eigen". If the macro
                      `CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE` is defined, of
                      `Eigen::CholmodDecomposition`, which needs SuiteSparse as well.}
    \cgalParamExtra{The CMake target `Seamless_snapping::SuiteSparse_support` defines the macro and
                    links SuiteSparse. With it and OpenBLAS, meshes of 100,000 faces take a third of
                    the time; with the reference BLAS, nothing is gained.}
    \cgalParamExtra{Untangling always uses the solver of \ref thirdpartyEigen "Eigen".}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress as lines of text, in the calling thread. If it
                          throws, the exception propagates, and no map has changed.}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and measurements of the result; converts to `true` if and only if the coordinates
        were written. Otherwise no map was touched, and `Parametrization_report::status` is
        - `INVALID_ARGUMENT`: the mesh has no face, all its points coincide, a parameter is out of
          its range, a size is not positive and finite, or the coordinates leave the range of their
          number type;
        - `NOT_TRIANGULAR`: a face has more or less than three corners;
        - `NOT_MANIFOLD`: the faces around a vertex form more than one fan;
        - `NOT_FINITE`: a coordinate of a point or of a direction is NaN or infinite;
        - `INVALID_CONES`: given indices do not add up to \f$ 4 \chi \f$, or one is 4 or more;
        - `INVALID_ALIGNMENT`: all three edges of a face are to be aligned;
        - `TOO_LARGE`: features and borders link so many coordinates that sums of these would have
          more than 67 million terms;
        - `SOLVER_FAILED`: a sparse linear system could not be solved;
        - `INTERNAL_ERROR`: indices or rotations failed the check in integers.
        .
        The message names the place; it counts faces in the order of `faces(tmesh)`, from 0.

For each component, the function verifies in integers that the indices of the cones and the quarter
turns of the borders add up to \f$ 4 \chi \f$. If no face is flipped, the indices in the report are
the indices of the map. Otherwise, untangling can change an index by 4. It does not change given
indices.

\par Complexity
Sparse Cholesky factorizations: three with twice as many rows as faces for the field, and one with
twice as many rows as vertices for the coordinates and for each stiffening round. The field of a
large mesh is computed by levels in linear time. Untangling adds at most
`number_of_untangling_iterations` iterations over all faces.

\sa `snap_to_seamless()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Parametrization_report<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
approximate_seamless_parametrization(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                      const NamedParameters& np
                                        = CGAL::parameters::default_values())
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const internal::Protect_exact_arithmetic protect;
  const auto& plain_np = internal::strip(np, internal::parametrization::read_parameters);
  const internal::Progress progress(plain_np);
  Parametrization_report<Vertex> report;
  try {
    if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
      internal::parametrization::run(tmesh, uv_map, plain_np, report);
  } catch(const internal::Refusal& refusal) {
    internal::refuse(report, refusal);
  }
  return report;
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_APPROXIMATE_SEAMLESS_PARAMETRIZATION_H
