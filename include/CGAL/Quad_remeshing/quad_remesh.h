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

// From any triangle mesh to a quad mesh of about the number of quads wanted.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/property_map.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgQuadRemeshingQuads

What `quad_remesh()` returns. Converts to `bool`: `true` if and only if the quads were written.
*/
struct Remeshing_report
  : public Report
{
  /// \name Result
  /// @{
  std::size_t number_of_quads = 0;    ///< faces that were written
  std::size_t number_of_vertices = 0; ///< vertices that were written
  std::size_t number_of_cones = 0;    ///< irregular vertices inside
  /// where there are more than 1.1 times as many quads as wanted: how many of them the features
  /// force; the message tells of it, too
  std::size_t number_of_forced_quads = 0;
  double least_scaled_jacobian = 0;   ///< the least sine of an angle of a quad; 1 is best
  double mean_scaled_jacobian = 0;    ///< the mean over the quads of their least sines
  /// quads that are inverted: at a corner, their sides turn the other way than the quad as a whole
  /// does, or the quad has no area. Decided exactly, for the points as doubles.
  std::size_t number_of_inverted_quads = 0;
  /// the first of them, at most ten, counted from 0 in the order in which the faces were written
  std::vector<std::size_t> first_inverted_quads;
  /// the largest distance from the input that was found, at the middles of faces and edges. The
  /// vertices lie on the input, up to rounding.
  double largest_distance = 0;
  /// @}

  /// \name Steps
  /// @{
  /// faces that were flipped in the approximate parametrization
  std::size_t number_of_flipped_faces = 0;
  /// feature edges, or parts of them, that are not kept, as faces would be flipped at them
  std::size_t number_of_released_edges = 0;
  /// the faces that stayed flipped, in the order of iteration over all faces, from 0
  std::vector<std::size_t> remaining_flips;
  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
  /// @}
};

namespace internal {

struct Remeshing_options
{
  Quantization_options quantization;
  double curvature_alignment;
  std::size_t number_of_smoothing_rounds;
  bool verbose;
  bool has_single_precision; // the points of the quads
};

template <typename TriangleMesh, typename NamedParameters>
Remeshing_options remeshing_options(const TriangleMesh& tmesh, const NamedParameters& np,
                                    const bool has_single_precision)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Quantization_options quantization = quantization_options(tmesh, np);
  quantization.needs_face_graph = true;
  return {quantization,
          static_cast<double>(
            choose_parameter(get_parameter(np, internal_np::curvature_alignment), 0.)),
          static_cast<std::size_t>(
            choose_parameter(get_parameter(np, internal_np::number_of_iterations), 5)),
          choose_parameter(get_parameter(np, internal_np::verbose), false),
          has_single_precision};
}

template <typename TriangleMesh, typename NamedParameters>
Surface_to_remesh surface_to_remesh(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  const auto read_direction = [&]([[maybe_unused]] const auto f) {
    if constexpr(is_given<NamedParameters, internal_np::face_direction_t>) {
      const auto& d = get(get_parameter(np, internal_np::face_direction), f);
      return Surface_to_remesh::Kernel::Vector_3(CGAL::to_double(d.x()), CGAL::to_double(d.y()),
                                                 CGAL::to_double(d.z()));
    }
    return Surface_to_remesh::Kernel::Vector_3(0, 0, 0);
  };
  return Surface_to_remesh(
    tmesh,
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                     CGAL::get_const_property_map(CGAL::vertex_point, tmesh)),
    choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                     CGAL::Static_boolean_property_map<Edge, false>()),
    read_direction);
}

// Makes the quads, as large as the input. The surface gets its map, and loses features that are
// released.
// \param is_feature of the edges of `quads`
Remeshing_report remesh(Surface_to_remesh& surface, const Remeshing_options& options,
                        Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature);

template <typename QuadMesh, typename NamedParameters>
auto point_map_of_quads(QuadMesh& quads, const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    CGAL::get_property_map(CGAL::vertex_point, quads));
}

template <typename QuadMesh, typename PointMap, typename NamedParameters>
void add_copy(const Surface_to_remesh::Mesh& result,
              const Surface_to_remesh::Feature_map& is_feature, QuadMesh& quads,
              const PointMap& point_map, const NamedParameters& np)
{
  const auto feature_map =
    CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
  const auto write_feature = [&](const auto& halfedges) {
    if constexpr(is_given<decltype(feature_map)>)
      put(feature_map, edge(halfedges.second, quads),
          bool(is_feature[result.edge(halfedges.first)]));
  };
  CGAL::copy_face_graph(result, quads,
                        CGAL::parameters::halfedge_to_halfedge_output_iterator(
                          boost::make_function_output_iterator(write_feature)),
                        CGAL::parameters::vertex_point_map(point_map));
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuads

remeshes a triangle mesh with quads only, about as many as wanted.

The steps are `approximate_seamless_parametrization()`, `snap_to_seamless()`, `quantize()`,
`extract_quad_mesh()`, and a smoothing of the vertices along the surface. Borders are aligned, and
so are feature edges: they become chains of edges of quads, whose vertices lie on them and are not
smoothed. What this leaves inverted or thin is improved: vertices near by move along the surface or
along their feature, unless it turns or ends there, and two quads around a vertex of two edges
become one. What is inverted or flat even then, as between two features that are a straight line in
space, becomes five quads, one of them inside, if those have a better shape. Quads that stay
inverted are counted in the report. Triangles with three sides that are features or border are
divided before, in a copy.

From an exact map without flipped faces on, nothing fails but for the number of bits, so that the
result is a mesh of quads, homeomorphic to the surface. Whether there is such a map depends on the
input: feature edges that can't be followed without flips are not kept, and where flips remain, the
function says so.

Where cones and features lie close together, so few quads may not exist, or meet themselves, or each
other twice, which no mesh can hold. Then the least larger number for which there is a mesh is
searched for, in steps of 2.5 % from the number wanted, or from the least one without this
condition: quads are made, or a quarter as many and divided into four each, or a sixteenth and into
sixteen, which always helps. There are at most 226 quantizations, and 121 with `coarsest`; as
many again where there are far more quads than wanted, to tell how many the features force. The
result has about as many quads as wanted, or as few as were found, which the message tells; and at
least 95 % of those that are made where fewer are wanted. The quad around a vertex of one edge is
left out.

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
    \cgalParamDescription{about how many quads there are to be, from 1 to \f$ 2^{28} \f$}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{10000}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{instead of their number, the length of the quads' edges}
    \cgalParamType{`double`}
    \cgalParamDefault{not used}
  \cgalParamNEnd
  \cgalParamNBegin{coarsest}
    \cgalParamDescription{whether there are to be as few quads as are found}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the largest number of quads: where features and cones force more than so
                          many, this is said, and nothing is made}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{a hundred times the number wanted, and at least 100,000}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is a feature}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how strongly the quads follow the principal directions of curvature: see
                          `approximate_seamless_parametrization()`}
    \cgalParamType{`double`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{face_direction_map}
    \cgalParamDescription{a property map that associates to each face a direction of its cross, in
                          space: what is perpendicular to the face does not count. A face with the
                          direction 0 is free: the field is smooth there. So a few directions are
                          guides, and one for each face is a field of one's own, from which the
                          cones follow. Features go first.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `%Vector_3`
                   as value type}
    \cgalParamDefault{all faces are free}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of rounds of smoothing; 0 for none}
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
    \cgalParamDescription{whether the times of the steps are written to `std::cerr`}
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
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it runs along a feature edge that is
                          kept, or is on the border}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome, and figures of the result

\par Complexity
That of the steps. The parametrization takes most of the time, unless many numbers of quads are
tried.

\sa `quantize()`
*/
template <typename TriangleMesh, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Remeshing_report quad_remesh(const TriangleMesh& tmesh, QuadMesh& quads,
                             const NamedParameters1& np1 = CGAL::parameters::default_values(),
                             const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  using namespace internal;
  using Mesh = Surface_to_remesh::Mesh;
  const Protect_exact_arithmetic protect;
  const auto point_map = point_map_of_quads(quads, strip(np2));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)> >::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  Surface_to_remesh surface = surface_to_remesh(tmesh, strip(np1));
  Mesh result;
  const auto is_feature = result.add_property_map<Mesh::Edge_index, bool>("e:is_feature").first;
  const Remeshing_report report =
    remesh(surface, remeshing_options(tmesh, strip(np1), std::is_same<FT, float>::value), result,
           is_feature);
  if(report)
    add_copy(result, is_feature, quads, point_map, strip(np2));
  return report;
}

} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Quad_remeshing/internal/quad_remesh_impl.h>
#endif

#endif // CGAL_QUAD_REMESHING_QUAD_REMESH_H
