// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_TRACER_H
#define CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_TRACER_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Isocurves, with their starts and points; and the tracer, a parametrized mesh prepared for tracing
// any number of them.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/decisions.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/start_walk.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A point of the surface at which an isocurve starts, together with the chart that its direction
refers to.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
struct Isocurve_start
{
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  Isocurve_place place = Isocurve_place::VERTEX; ///< the element on which the point lies
  halfedge_descriptor halfedge{};   ///< of the face with the chart of the direction
  Exact_rational parameter{0};      ///< on an edge: 0 at its source, 1 at its target
  std::array<double, 2> uv{{0, 0}}; ///< in a face: the coordinates of the point

  /*!
  the target of `h`. The direction refers to the chart of `face(h)`. The curve need not leave
  through this face. Carried around the vertex, the direction can fit several rays, and the curve
  takes the nearest one; around a regular vertex, there is only one such ray.
  \pre `h` has a face
  */
  static Isocurve_start at_vertex(const halfedge_descriptor h)
  { return {Isocurve_place::VERTEX, h, Exact_rational(0), {{0, 0}}}; }

  /*!
  the point \f$ (1-t) a + t b \f$ of the edge from \f$ a \f$ to \f$ b \f$.
  \pre `h` has a face, and `t` is larger than 0 and smaller than 1
  */
  static Isocurve_start on_edge(const halfedge_descriptor h, const Exact_rational& t)
  { return {Isocurve_place::EDGE, h, t, {{0, 0}}}; }

  /*!
  the point of `face(h)` with these coordinates in its chart.
  \pre the point lies in the face, not at one of its vertices
  */
  static Isocurve_start in_face(const halfedge_descriptor h, const double u, const double v)
  { return {Isocurve_place::FACE, h, Exact_rational(0), {{u, v}}}; }
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A point of a traced isocurve: an edge that is crossed, a vertex that is met, or the point of a face
at which the curve starts. If two consecutive points are vertices, the curve runs along the edge
between them.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
class Isocurve_point
{
public:
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// \cond SKIP_IN_MANUAL
  Isocurve_point() = default;
  Isocurve_point(const Isocurve_place place, const halfedge_descriptor h,
                 const Isocurve_direction direction, const internal::Exact_level& level,
                 const double running = 0)
    : m_halfedge(h), m_place(place), m_direction(static_cast<unsigned char>(direction)),
      m_level(level), m_running(running)
  { }
  const internal::Exact_level& level() const { return m_level; }
  double running_coordinate() const { return m_running; }
  /// \endcond

  /// returns the element on which the point lies.
  Isocurve_place place() const { return m_place; }

  /// returns a halfedge at the point. On an edge, it belongs to the face that the curve leaves. At
  /// a vertex, it points to the vertex and belongs to a face through or along which the curve has
  /// come; at the start of the curve, through or along which it goes. In a face, it is one of the
  /// halfedges of the face.
  halfedge_descriptor halfedge() const { return m_halfedge; }

  /// returns the direction of the curve in the chart of `face(halfedge())`.
  Isocurve_direction direction() const { return Isocurve_direction(m_direction); }

  /// returns the constant coordinate of the curve in this chart, exactly: \f$ u \f$, \f$ v \f$, or
  /// in lattice coordinates \f$ u + v \f$.
  Exact_rational constant_coordinate() const { return m_level.exact(); }

  /// returns the same, rounded.
  double approximate_constant_coordinate() const { return m_level.approximation(); }

private:
  halfedge_descriptor m_halfedge{};
  Isocurve_place m_place = Isocurve_place::VERTEX;
  unsigned char m_direction = 0;
  internal::Exact_level m_level;
  double m_running = 0;
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

A traced isocurve.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <typename TriangleMesh>
struct Isocurve
{
  Isocurve_status status = Isocurve_status::MAXIMUM_NUMBER; ///< how it ends
  Isocurve_start<TriangleMesh> start;                      ///< its start
  Isocurve_direction direction = Isocurve_direction::PLUS_U; ///< its direction at the start
  std::size_t number_of_crossings = 0; ///< edges crossed and vertices passed
  double length = 0;                   ///< from the start to the end; 0 unless it was bounded
  std::vector<Isocurve_point<TriangleMesh> > points; ///< from the start to the end
};

namespace internal {

// The parameters of `trace_isocurve()`; the tracer has read the symmetry before.
constexpr auto tracing_parameters =
  named<CGAL::internal_np::decide_exactly, CGAL::internal_np::maximum_length,
        CGAL::internal_np::maximum_number, CGAL::internal_np::near_distance,
        CGAL::internal_np::rotational_symmetry, CGAL::internal_np::target_vertex,
        CGAL::internal_np::vertex_is_constrained>;

// The number of directions of isocurves, for the rotational symmetry of the named parameters.
template <typename NamedParameters>
constexpr int number_of_directions =
  Symmetry_group<Plain_parameters<NamedParameters> >::order;

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

traces isocurves on a parametrized mesh. The constructor reads the mesh and the parametrization
once, into arrays of its own; use it instead of `trace_isocurve()` if many curves are
traced. Tracing does not modify the object: several threads can use it at a time. It stays valid as
long as the mesh is neither modified nor destroyed; the parametrization is not read again.

On an exactly seamless parametrization, all decisions are exact comparisons: which edge a curve
crosses next, whether it meets a vertex, how it leaves it, and whether it closes. Nothing can go
fail then.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam D the number of directions: 4 for parametrizations of rotational symmetry 1, 2, or 4, and 6
        for symmetry 3 or 6. The compiler finds it if the class is named without arguments:
        `Isocurve_tracer tracer(tmesh, uv_map,
        parameters::rotational_symmetry(Rotational_symmetry<6>()))`.
*/
template <typename TriangleMesh, int D = 4>
class Isocurve_tracer
{
  static_assert(D == 4 || D == 6, "isocurves have four directions or, where N = 3 or 6, six");
  using Group = internal::Rotation_group<D>;

public:
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Start = Isocurve_start<TriangleMesh>; ///< the start of a curve
  using Curve = Isocurve<TriangleMesh>;       ///< a traced curve

  /*!
  reads a mesh and its parametrization, whose corners are as for `trace_isocurve()`. The named
  parameters are the parameters of `seam_transitions()`, with a `rotational_symmetry` that fits `D`.
  Check `operator bool()` if the parametrization may not be seamless at all.

  \throws std::runtime_error if the program was compiled with options like `-ffast-math`

  \par Complexity
  The complexity of `seam_transitions()`, and linear in the number of faces.
  */
  template <typename HalfedgeUVMap,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Isocurve_tracer(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                  const NamedParameters& np = CGAL::parameters::default_values())
    : m_tmesh(&tmesh), m_numbering(tmesh)
  {
    const internal::Require_exact_arithmetic protect;
    if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
      const auto& plain_np = internal::strip(np, internal::surface_parameters);
      static_assert(internal::number_of_directions<NamedParameters> == D,
                    "isocurves have six directions where rotational_symmetry is 3 or 6, else "
                    "four: use Isocurve_tracer<TriangleMesh, 6>, or leave the template arguments "
                    "out");
      const auto seams = internal::read_transitions<Group>(tmesh, uv_map, plain_np);
      m_is_valid = !seams.refusal;
      if(m_is_valid)
        m_mesh = internal::build_chart_mesh<Group>(tmesh, m_numbering, uv_map, seams);
    }
  }

  /// returns `true` if the mesh is triangular and its parametrization seamless up to the tolerance.
  explicit operator bool() const { return m_is_valid; }

  /// returns `true` if the parametrization is exactly seamless, as is needed for tracing exactly.
  bool is_exact() const { return m_is_valid && m_mesh.is_exact; }

  /*!
  returns `true` if `v` is an interior vertex whose angle in the domain is not 360 degrees. Among
  faces that are positive, these are `Seam_transitions::singular_vertices()`. If an edge at `v` has
  no length in the domain, the angle is not known, and `v` counts as singular if the product of the
  rotations around it is not the identity. Takes constant time.
  \pre `operator bool()`
  */
  bool is_singular(const vertex_descriptor v) const
  {
    check_validity();
    const internal::Flat_vertex_index i = m_numbering.vertex(v);
    return i != internal::no_index && m_mesh.is_singular[std::size_t(i)] != 0;
  }

  /*!
  returns the starts and directions of all isocurves that leave a vertex, in counterclockwise order:
  `D` at a regular vertex, \f$ D - i \f$ at a singular vertex of index \f$ i \f$ (in turns by
  \f$ 360 / D \f$ degrees), more if faces around the vertex are flipped, and at the border all
  that lead into the surface or along the border. Takes time linear in the degree of the vertex.
  \pre `operator bool()`
  */
  std::vector<std::pair<Start, Isocurve_direction> > outgoing(const vertex_descriptor v) const
  {
    check_validity();
    const internal::Protect_exact_arithmetic protect;
    std::vector<std::pair<Start, Isocurve_direction> > result;
    const internal::Flat_vertex_index i = m_numbering.vertex(v);
    if(i == internal::no_index)
      return result;
    for(const internal::Vertex_ray& ray : internal::rays_from_vertex(m_mesh, std::size_t(i)))
      result.emplace_back(Start::at_vertex(halfedge(ray.corner)),
                          internal::isocurve_direction<Group>(ray.direction));
    return result;
  }

  /*!
  traces one isocurve. The named parameters are the same as for `trace_isocurve()`. The status of
  the curve is `Isocurve_status::NOT_EXACT`, and it has no points, if `is_exact()` is `false` and it
  is not to be traced in floating point, and also if `operator bool()` returns `false`.
  \param start the start of the curve
  \param direction the direction in which it starts, in the chart of `face(start.halfedge)`
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
  \pre `start` is as `Isocurve_start` asks for

  \par Complexity
  Constant time for each edge crossed, and linear in the degree of each vertex met.
  */
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Curve trace(const Start& start, const Isocurve_direction direction,
              const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    return trace(start, direction, options(internal::strip(np, internal::tracing_parameters)));
  }

  /*!
  traces all isocurves that leave singular vertices, in the order of `vertices(tmesh)` and
  counterclockwise around each; the order does not depend on the number of threads. The named
  parameters are the same as for `trace_isocurve()`. With several threads, all of them read the
  property map `vertex_is_constrained_map`. If `trace()` would return `Isocurve_status::NOT_EXACT`,
  a single curve with this status is returned. The time is the sum for all curves, divided by the
  number of idle threads.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_if_available_tag`, or
         `CGAL::Parallel_tag`, which does not compile unless TBB is linked
  */
  template <typename ConcurrencyTag = CGAL::Sequential_tag,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<Curve> separatrices(
    const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    const Options all = options(internal::strip(np, internal::tracing_parameters));
    if(!can_trace(all))
      return std::vector<Curve>(1, refused(Start(), Isocurve_direction::PLUS_U));
    std::vector<Curve> curves;
    for(const vertex_descriptor v : m_numbering.vertices_in_order())
      if(is_singular(v))
        for(const auto& [start, direction] : outgoing(v)) {
          curves.emplace_back();
          curves.back().start = start;
          curves.back().direction = direction;
        }
    CGAL::for_each<ConcurrencyTag>(curves, [&](Curve& curve) {
      curve = trace(curve.start, curve.direction, all);
      return true;
    });
    return curves;
  }

  /// \cond SKIP_IN_MANUAL
  const TriangleMesh& mesh() const { return *m_tmesh; }
  const internal::Basic_chart_mesh<Group>& chart_mesh() const { return m_mesh; }
  const internal::Flat_numbering<TriangleMesh>& correspondence() const { return m_numbering; }
  internal::Chart_start chart_start(const Start& start) const
  {
    return {start.place, m_numbering.corner(start.halfedge), start.parameter,
            {{start.uv[0], start.uv[1]}}};
  }
  /// \endcond

private:
  void check_validity() const
  {
    CGAL_precondition_msg(m_is_valid, "the mesh is not triangular, or its map not seamless at all");
  }

  struct Options
  {
    internal::Walk_limits limits;
    bool decide_exactly = true;
    double near_distance = 0;
  };

  bool can_trace(const Options& options) const
  {
    return m_is_valid && (m_mesh.is_exact || !options.decide_exactly);
  }

  static Curve refused(const Start& start, const Isocurve_direction direction)
  {
    Curve curve;
    curve.status = Isocurve_status::NOT_EXACT;
    curve.start = start;
    curve.direction = direction;
    return curve;
  }

  template <typename NamedParameters>
  Options options(const NamedParameters& np) const
  {
    using CGAL::parameters::get_parameter;
    namespace np_tags = CGAL::internal_np;
    Options result;
    result.limits.maximum_number =
      internal::chosen(np, np_tags::maximum_number, m_mesh.corners.size());
    result.limits.maximum_length =
      internal::chosen(np, np_tags::maximum_length, result.limits.maximum_length);
    result.decide_exactly = internal::chosen(np, np_tags::decide_exactly, true);
    result.near_distance = near_distance(np);
    const auto target = get_parameter(np, np_tags::target_vertex);
    if constexpr(internal::is_given<decltype(target)>)
      result.limits.target = std::size_t(m_numbering.vertex(target));
    const auto is_stop = get_parameter(np, np_tags::vertex_is_constrained);
    if constexpr(internal::is_given<decltype(is_stop)>)
      result.limits.is_stop = [this, is_stop](const std::size_t v) -> bool
      { return get(is_stop, m_numbering.vertices_in_order()[v]); };
    return result;
  }

  // Errors of many transitions add up along a curve.
  template <typename NamedParameters>
  double near_distance(const NamedParameters& np) const
  {
    const double relative = m_mesh.extent > 0 ? 100 * m_mesh.violation / m_mesh.extent : 0;
    return m_mesh.extent *
           internal::chosen(np, CGAL::internal_np::near_distance, (std::max)(relative, 1e-12));
  }

  Curve trace(const Start& start, const Isocurve_direction direction, const Options& options) const
  {
    if(!can_trace(options))
      return refused(start, direction);
    const internal::Require_exact_arithmetic protect;
    if(options.decide_exactly) {
      internal::Basic_exact_decisions<Group> decisions(m_mesh);
      return trace_with(decisions, start, direction, options);
    }
    const bool at_vertex = start.place == Isocurve_place::VERTEX;
    internal::Basic_floating_point_decisions<Group> decisions(
      m_mesh, options.limits, at_vertex ? m_numbering.corner(start.halfedge) : internal::no_index,
      internal::chart_direction<Group>(direction), options.near_distance);
    return trace_with(decisions, start, direction, options);
  }

  template <typename Decisions>
  Curve trace_with(Decisions& decisions, const Start& start, const Isocurve_direction direction,
                   const Options& options) const
  {
    Curve curve;
    curve.start = start;
    curve.direction = direction;
    const auto add = [&](const Isocurve_place place, const auto& state, const double running) {
      curve.points.emplace_back(place, halfedge(state.halfedge),
                                internal::isocurve_direction<Group>(state.direction),
                                internal::Exact_level(state.level), running);
    };
    internal::Isocurve_walk<Decisions, Group> walk(m_mesh, options.limits, decisions);
    const auto beginning = internal::begin_walk(m_mesh, chart_start(start),
                                                internal::chart_direction<Group>(direction),
                                                decisions, walk);
    if(!beginning.is_first_state)
      add(start.place, beginning.start, other_coordinate(beginning));
    curve.status = beginning.status;
    if(curve.status == Isocurve_status::CONTINUES)
      curve.status = internal::run(walk, [&](const auto& state) {
        add(state.is_at_vertex ? Isocurve_place::VERTEX : Isocurve_place::EDGE, state, 0);
      });
    if(curve.status == Isocurve_status::CLOSED && start.place != Isocurve_place::VERTEX)
      curve.points.back() = curve.points.front();
    curve.number_of_crossings = walk.number_of_crossings();
    curve.length = walk.length();
    return curve;
  }

  // As points tell it; where u + v is the running component, that is v.
  template <typename Beginning>
  static double other_coordinate(const Beginning& beginning)
  {
    if(internal::running_component<Group>(beginning.start.direction) < 2)
      return CGAL::to_double(beginning.running);
    const Exact_rational level = internal::Exact_level(beginning.start.level).exact();
    return CGAL::to_double(Exact_rational(beginning.running - level));
  }

  halfedge_descriptor halfedge(const internal::Corner_index h) const
  { return m_numbering.halfedges_of_corners()[std::size_t(h)]; }

  const TriangleMesh* m_tmesh;
  internal::Flat_numbering<TriangleMesh> m_numbering;
  internal::Basic_chart_mesh<Group> m_mesh;
  bool m_is_valid = false;
};

/// \cond SKIP_IN_MANUAL
template <typename TriangleMesh, typename HalfedgeUVMap>
Isocurve_tracer(const TriangleMesh&, HalfedgeUVMap) -> Isocurve_tracer<TriangleMesh>;

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Isocurve_tracer(const TriangleMesh&, HalfedgeUVMap, const NamedParameters&)
  -> Isocurve_tracer<TriangleMesh, internal::number_of_directions<NamedParameters> >;
/// \endcond

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_ISOCURVE_TRACER_H
