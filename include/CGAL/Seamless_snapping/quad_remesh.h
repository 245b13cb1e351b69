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

#ifndef CGAL_SEAMLESS_SNAPPING_QUAD_REMESH_H
#define CGAL_SEAMLESS_SNAPPING_QUAD_REMESH_H

#include <CGAL/license/Seamless_snapping.h>

// From any triangle mesh to a quad mesh of about the number of quads wanted.

#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/quads/Surface_to_remesh.h>
#include <CGAL/Seamless_snapping/internal/quads/divide_quads.h>
#include <CGAL/Seamless_snapping/internal/quads/improve_quads.h>
#include <CGAL/Seamless_snapping/internal/quads/inverted_quads.h>
#include <CGAL/Seamless_snapping/internal/quads/smooth_quads.h>
#include <CGAL/Seamless_snapping/internal/tracing/nonpositive_faces.h>
#include <CGAL/Seamless_snapping/quantize.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingQuads

The outcome of `quad_remesh()`. After any other than `REMESHED` the output is untouched.
*/
enum class Remeshing_status
{
  REMESHED,         ///< the quads were written
  NOT_PARAMETRIZED, ///< the input has no parametrization: it is no triangle mesh, for instance
  NOT_SNAPPED,      ///< the parametrization could not be made exact
  NOT_POSITIVE,     ///< faces of the parametrization stayed flipped
  NOT_QUANTIZED,    ///< the parametrization could not be quantized
  NOT_EXTRACTED     ///< the quads form no face graph, or are too many
};

/*!
\ingroup PkgSeamlessSnappingQuads
returns the status in words.
*/
inline const char* to_string(const Remeshing_status status)
{
  switch(status) {
  case Remeshing_status::REMESHED:         return "remeshed";
  case Remeshing_status::NOT_PARAMETRIZED: return "not parametrized";
  case Remeshing_status::NOT_SNAPPED:      return "not snapped";
  case Remeshing_status::NOT_POSITIVE:     return "not positive";
  case Remeshing_status::NOT_QUANTIZED:    return "not quantized";
  case Remeshing_status::NOT_EXTRACTED:    break;
  }
  return "not extracted";
}

/*!
\ingroup PkgSeamlessSnappingQuads

What `quad_remesh()` returns. Converts to `bool`: `true` if and only if the quads were written.
*/
struct Remeshing_report
{
  Remeshing_status status = Remeshing_status::REMESHED; ///< the outcome
  /// on failure: the reason and, as far as known, the place and the remedy; else, if there are more
  /// than 1.1 times as many quads as wanted, that no fewer were found
  std::string message;

  /// \name Result
  /// @{
  std::size_t number_of_quads = 0;    ///< faces that were written
  std::size_t number_of_vertices = 0; ///< vertices that were written
  std::size_t number_of_cones = 0;    ///< irregular vertices inside
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

  /// returns `true` if and only if the quads were written.
  explicit operator bool() const { return status == Remeshing_status::REMESHED; }
};

/*!
\ingroup PkgSeamlessSnappingQuads
writes the status and, if there is one, the message.
*/
inline std::ostream& operator<<(std::ostream& os, const Remeshing_report& report)
{
  os << to_string(report.status);
  if(!report.message.empty())
    os << ": " << report.message;
  return os;
}

namespace internal {

struct Remeshing_options
{
  Quantization_options quantization;
  double curvature_alignment;
  std::size_t number_of_smoothing_rounds;
  bool verbose;
};

template <typename TriangleMesh, typename NamedParameters>
Remeshing_options remeshing_options(const TriangleMesh& tmesh, const NamedParameters& np)
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
          choose_parameter(get_parameter(np, internal_np::verbose), false)};
}

template <typename TriangleMesh, typename NamedParameters>
Surface_to_remesh surface_to_remesh(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  return Surface_to_remesh(
    tmesh,
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                     CGAL::get_const_property_map(CGAL::vertex_point, tmesh)),
    choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                     CGAL::Static_boolean_property_map<Edge, false>()));
}

// Invariant: `m_report` tells why the last step failed, if it did.
class Quad_remesher
{
  using Mesh = Surface_to_remesh::Mesh;

public:
  template <typename TriangleMesh, typename NamedParameters>
  Quad_remesher(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_surface(surface_to_remesh(tmesh, np)), m_options(remeshing_options(tmesh, np)),
      m_timer(m_report, m_options.verbose)
  { }

  // Adds the quads to the mesh, if all steps succeed.
  template <typename QuadMesh, typename NamedParameters>
  Remeshing_report run(QuadMesh& quads, const NamedParameters& np)
  {
    QuadMesh result;
    const auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), result);
    if(parametrize(m_surface) && extract(result, is_feature)) {
      smooth(result, is_feature);
      restore_size(result);
      write(result, is_feature, quads, np);
    }
    return m_report;
  }

private:
  bool fail(const Remeshing_status status, const std::string& message)
  {
    m_report.status = status;
    m_report.message = message;
    return false;
  }

  const Mesh& mesh() const { return m_surface.mesh(); }

  auto features() const { return parameters::edge_is_constrained_map(m_surface.is_feature()); }

  // From here on, edges that no field can follow without flips are not features.
  template <typename Edges>
  void release(const Edges& released)
  {
    for(const auto& [v, w] : released)
      m_surface.is_feature()[mesh().edge(mesh().halfedge(v, w))] = false;
    m_report.number_of_released_edges = released.size();
  }

  // An exactly seamless map without flips. A template: only programs that call it compile it.
  template <typename Surface>
  bool parametrize(Surface& surface);

  template <typename QuadMesh, typename FeatureMap>
  bool extract(QuadMesh& quads, const FeatureMap& is_feature)
  {
    const Quantization quantization =
      quantize_map(mesh(), m_surface.uv_map(), strip(features()), m_options.quantization);
    m_timer.finish("quantization");
    if(!quantization)
      return fail(Remeshing_status::NOT_QUANTIZED, quantization.message);
    const Extraction_report extracted = extract_quad_mesh(
      quantization, mesh(), quads, CGAL::parameters::default_values(),
      parameters::edge_is_constrained_map(is_feature));
    m_timer.finish("extraction");
    if(!extracted)
      return fail(Remeshing_status::NOT_EXTRACTED, extracted.message);
    m_report.message = quantization.message;
    return true;
  }

  // Vertices on features and borders are held.
  template <typename QuadMesh, typename FeatureMap>
  void smooth(QuadMesh& quads, const FeatureMap& is_feature)
  {
    using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;
    const auto point_map = CGAL::get_property_map(CGAL::vertex_point, quads);
    const auto is_held = [&](const Vertex v) {
      for(const auto h : CGAL::halfedges_around_target(v, quads))
        if(get(is_feature, edge(h, quads)))
          return true;
      return false;
    };
    using Smoother = Quad_smoother<QuadMesh, std::decay_t<decltype(point_map)> >;
    Smoother smoother(quads, point_map, mesh());
    smoother.smooth(m_options.number_of_smoothing_rounds, is_held);
    if(m_options.number_of_smoothing_rounds > 0) {
      const Feature_lines lines(m_surface);
      Quad_improver<QuadMesh, FeatureMap, Smoother> improver(quads, is_feature, lines, smoother);
      improver.move_vertices();
      if(improver.remove_vertices_of_two_edges() > 0)
        improver.move_vertices();
      if(Quad_divider<QuadMesh, FeatureMap, Smoother>(quads, is_feature, smoother).run() > 0)
        improver.move_vertices();
    }
    m_timer.finish("smoothing");
    count(quads);
    std::size_t i = 0;
    for(const auto f : faces(quads))
      count_if_inverted(smoother.quad(f), i++, m_report);
    const std::array<double, 2> shape = smoother.measure_shape();
    m_report.least_scaled_jacobian = shape[0];
    m_report.mean_scaled_jacobian = shape[1];
    m_report.largest_distance = m_surface.unscaled(smoother.measure_distance());
    m_timer.finish("measurement");
  }

  template <typename QuadMesh>
  void restore_size(QuadMesh& quads) const
  {
    const auto point_map = CGAL::get_property_map(CGAL::vertex_point, quads);
    using Point = typename boost::property_traits<std::decay_t<decltype(point_map)> >::value_type;
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    const auto unscaled = [&](const auto& x)
                          { return FT(m_surface.unscaled(CGAL::to_double(x))); };
    for(const auto v : vertices(quads)) {
      const Point p = get(point_map, v);
      put(point_map, v, Point(unscaled(p.x()), unscaled(p.y()), unscaled(p.z())));
    }
  }

  template <typename QuadMesh, typename FeatureMap, typename NamedParameters>
  static void write(const QuadMesh& result, const FeatureMap& is_feature, QuadMesh& quads,
                    const NamedParameters& np)
  {
    using CGAL::parameters::get_parameter;
    const auto feature_map = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    const auto write_feature = [&](const auto& halfedges) {
      if constexpr(is_given_parameter(feature_map))
        put(feature_map, edge(halfedges.second, quads),
            get(is_feature, edge(halfedges.first, result)));
    };
    CGAL::copy_face_graph(
      result, quads,
      CGAL::parameters::halfedge_to_halfedge_output_iterator(
        boost::make_function_output_iterator(write_feature)),
      CGAL::parameters::vertex_point_map(CGAL::parameters::choose_parameter(
        get_parameter(np, CGAL::internal_np::vertex_point),
        CGAL::get_property_map(CGAL::vertex_point, quads))));
  }

  template <typename QuadMesh>
  void count(const QuadMesh& quads)
  {
    m_report.number_of_quads = faces(quads).size(); // num_faces() counts removed ones, too
    m_report.number_of_vertices = vertices(quads).size();
    for(const auto v : vertices(quads))
      if(!CGAL::is_border(v, quads) && degree(v, quads) != 4)
        ++m_report.number_of_cones;
  }

  static constexpr int largest_cone_index = 2; // no face graph has a vertex of one edge

  Surface_to_remesh m_surface;
  Remeshing_options m_options;
  Remeshing_report m_report;
  Step_timer m_timer;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Surface>
bool Quad_remesher::parametrize(Surface& surface)
{
  const auto made = approximate_seamless_parameterization(
    surface.mesh(), surface.uv_map(),
    features().align_border(true).curvature_alignment(m_options.curvature_alignment)
              .release_alignment(true).largest_cone_index(largest_cone_index));
  m_timer.finish("parametrization");
  if(!made)
    return fail(Remeshing_status::NOT_PARAMETRIZED, made.message);
  release(made.released_edges);
  m_report.number_of_flipped_faces = made.number_of_flipped_faces;
  const auto snapped =
    snap_to_seamless(surface.mesh(), surface.uv_map(),
                     features().align_border(true).repair_flips(Flip_repair::UNTANGLE));
  m_timer.finish("snapping");
  if(!snapped)
    return fail(Remeshing_status::NOT_SNAPPED, snapped.message);
  m_report.remaining_flips = snapped.remaining_flips;
  m_report.remaining_flips.insert(m_report.remaining_flips.end(), snapped.lost_faces.begin(),
                                  snapped.lost_faces.end());
  for(std::size_t& face : m_report.remaining_flips)
    face = surface.original(face);
  if(!m_report.remaining_flips.empty())
    return fail(Remeshing_status::NOT_POSITIVE,
                name_of_faces(m_report.remaining_flips, "flipped in the parametrization") +
                  "; mark fewer features, or remesh the input there");
  return true;
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingQuads

remeshes a triangle mesh with quads only, about as many as wanted.

The steps are `approximate_seamless_parameterization()`, `snap_to_seamless()`, `quantize()`,
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
sixteen, which always helps. There are at most 122 quantizations. The result has about as many quads
as wanted, or as few as were found, and not more, but for 8 %, than if more were wanted. The quad
around a vertex of one edge is left out.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam QuadMesh a model of `MutableFaceGraph` that is default constructible and has an internal
        property map for `CGAL::vertex_point_t`
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
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is a feature}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how strongly the quads follow the principal directions of curvature: see
                          `approximate_seamless_parameterization()`}
    \cgalParamType{`double`}
    \cgalParamDefault{`0`}
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

\sa `quantize()`
*/
template <typename TriangleMesh, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Remeshing_report quad_remesh(const TriangleMesh& tmesh, QuadMesh& quads,
                             const NamedParameters1& np1 = CGAL::parameters::default_values(),
                             const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  return internal::Quad_remesher(tmesh, internal::strip(np1)).run(quads, internal::strip(np2));
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_QUAD_REMESH_H
