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

#ifndef CGAL_QUAD_REMESHING_IS_INTEGER_GRID_MAP_H
#define CGAL_QUAD_REMESHING_IS_INTEGER_GRID_MAP_H

#include <CGAL/license/Quad_remeshing.h>

// Checking and measuring integer-grid maps.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/remove_faces.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/is_seamless.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingQuads

The result of `measure_integer_grid()`. The counts are exact; distances and the area are computed in
floating point.
*/
struct Integer_grid_measure
{
  /// whether the function has found transitions; otherwise, it measures nothing
  bool is_seamless_up_to_tolerance = false;
  bool is_exactly_seamless = false; ///< whether all transitions hold exactly
  std::size_t number_of_noninteger_cuts = 0; ///< cut edges whose translation is no integer
  std::size_t number_of_cones = 0; ///< interior vertices whose angle is not 360 degrees
  std::size_t number_of_half_integer_cones = 0; ///< cones at half-integers
  std::size_t number_of_noninteger_cones = 0;   ///< cones that are no point of the grid
  std::size_t number_of_aligned_edges = 0; ///< edges that were asked to be aligned
  std::size_t number_of_unaligned_edges = 0; ///< aligned edges off the lines of the grid
  /// border edges that cut cells of the grid: they lie on no line of the grid, or lead to the end
  /// of a slit that is no point of the grid
  std::size_t number_of_border_edges_off_grid = 0;
  /// faces that are flipped or degenerate in the domain
  std::size_t number_of_nonpositive_faces = 0;
  double translation_distance = 0; ///< the largest distance of a translation from an integer
  double cone_distance = 0; ///< the largest distance of a coordinate of a cone from an integer
  /// the largest distance of an aligned edge from a line of the grid
  double alignment_distance = 0;
  /// the area of the map, in units of one quad; in lattice coordinates, of two triangles
  double area = 0;

  /// returns `true` if and only if the map is an integer-grid map, exactly, so that whole cells of
  /// the grid cover the surface. Orientations are not checked, but flipped faces change the
  /// angles around their vertices, which can then count as cones off the grid.
  explicit operator bool() const
  {
    return is_exactly_seamless && number_of_noninteger_cuts == 0 &&
           number_of_noninteger_cones == 0 && number_of_unaligned_edges == 0 &&
           number_of_border_edges_off_grid == 0;
  }
};

namespace internal {

template <typename Group>
void measure_cuts_and_cones(const Basic_chart_mesh<Group>& mesh, Integer_grid_measure& measure)
{
  for(std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const std::int32_t t = mesh.corners[i].transition;
    if(t == no_index || mesh.edge_key(Corner_index(i)) != Corner_index(i))
      continue;
    const auto& translation = mesh.transitions[std::size_t(t)].translation;
    measure.number_of_noninteger_cuts +=
      is_integer(translation[0]) && is_integer(translation[1]) ? 0 : 1;
    measure.translation_distance =
      (std::max)({measure.translation_distance, distance_to_integer(translation[0]),
                  distance_to_integer(translation[1])});
  }
  for(std::size_t v = 0; v < mesh.is_singular.size(); ++v) {
    if(!mesh.is_singular[v])
      continue;
    const Uv& u = mesh.uv(mesh.corner_at_vertex[v]);
    ++measure.number_of_cones;
    measure.number_of_half_integer_cones +=
      std::abs(u[0] - std::floor(u[0])) == 0.5 && std::abs(u[1] - std::floor(u[1])) == 0.5 ? 1 : 0;
    measure.number_of_noninteger_cones += distance_to_integer(u) != 0 ? 1 : 0;
    measure.cone_distance = (std::max)(measure.cone_distance, distance_to_integer(u));
  }
}

template <typename Group>
std::size_t number_of_border_edges_off_grid(Basic_chart_mesh<Group> mesh)
{
  Fan_splitter<Group>(mesh).run();
  std::size_t result = 0;
  for(std::size_t i = 0; i < mesh.corners.size(); ++i)
    result += mesh.opposite(Corner_index(i)) == no_index &&
              !is_border_on_grid(mesh, Corner_index(i)) ? 1 : 0;
  return result;
}

// The distance of the component that changes less.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
double distance_to_grid_line(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, Halfedge h)
{
  if(is_border(h, tmesh))
    h = opposite(h, tmesh);
  const Uv a = get_uv(uv_map, prev(h, tmesh)), b = get_uv(uv_map, h);
  const auto distance = [](const auto& component, const double change)
  { return (std::max)(distance_to_integer(component), std::abs(change)); };
  const double result = (std::min)(distance(a[0], b[0] - a[0]), distance(a[1], b[1] - a[1]));
  if constexpr(Group::is_signed_permutation)
    return result;
  else
    return (std::min)(result, distance(component<Group>(a, 2), change_of_sum(a, b)));
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Integer_grid_measure measure_integer_grid(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                          const NamedParameters& np)
{
  Integer_grid_measure measure;
  using Group = Symmetry_group<NamedParameters>;
  const auto seams = read_transitions<Group>(tmesh, uv_map, np);
  if(seams.refusal)
    return measure;
  measure.is_seamless_up_to_tolerance = true;
  measure.is_exactly_seamless = seams.is_exact;
  const Basic_chart_mesh<Group> mesh =
    build_chart_mesh<Group>(tmesh, Flat_numbering<TriangleMesh>(tmesh), uv_map, seams);
  measure_cuts_and_cones(mesh, measure);
  measure.number_of_nonpositive_faces = nonpositive_faces(mesh).size();
  measure.area = grid_size(mesh, 0, mesh.corners.size() / 3).area;
  if(std::find(mesh.is_border.begin(), mesh.is_border.end(), true) != mesh.is_border.end())
    measure.number_of_border_edges_off_grid = number_of_border_edges_off_grid(mesh);
  for(const auto h : edges_to_align(tmesh, np)) {
    const double distance = distance_to_grid_line<Group>(tmesh, uv_map, h);
    ++measure.number_of_aligned_edges;
    measure.number_of_unaligned_edges += distance != 0 ? 1 : 0;
    measure.alignment_distance = (std::max)(measure.alignment_distance, distance);
  }
  return measure;
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuads

measures how far a parametrization is from an integer-grid map.

An integer-grid map is exactly seamless. Its translations are integers, its cones have integer
coordinates, and its border and aligned edges lie on isocurves of integer coordinates. If such an
isocurve ends at a border vertex with an angle of 360 degrees or more, this vertex has integer
coordinates, too. With `rotational_symmetry` of order 3 or 6, coordinates are lattice coordinates;
with order 6, isocurves of \f$ u + v \f$ count as well.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below, and `tolerance`, `edge_is_cut_map`, `halfedge_rotation_map`, `rotational_symmetry`,
       and `vertex_index_map` of `seam_transitions()`

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must lie on lines of the grid}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{align_border}
    \cgalParamDescription{whether all border edges must lie on lines of the grid}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return counts and distances; converts to `true` if and only if the map is an integer-grid map,
        exactly. If the map is not seamless up to the tolerance, all other members are zero.

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
The complexity of `seam_transitions()`, and linear in the number of faces.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Integer_grid_measure measure_integer_grid(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                          const NamedParameters& np =
                                            CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::measure_integer_grid(tmesh, uv_map,
                                          internal::strip(np, internal::surface_parameters));
}

/*!
\ingroup PkgQuadRemeshingQuads

returns whether a parametrization is an integer-grid map, exactly. Then whole cells of the grid
cover the surface, and the extraction leaves out no cell. Orientations are not checked, but
flipped faces change the angles around their vertices.

\tparam TriangleMesh as for `measure_integer_grid()`
\tparam HalfedgeUVMap as for `measure_integer_grid()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for
       `measure_integer_grid()`

\return `true` if and only if the map is an integer-grid map

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
The complexity of `measure_integer_grid()`.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_integer_grid_map(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  return bool(measure_integer_grid(tmesh, uv_map, np));
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_IS_INTEGER_GRID_MAP_H
