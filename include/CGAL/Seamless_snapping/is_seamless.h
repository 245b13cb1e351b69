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

#ifndef CGAL_SEAMLESS_SNAPPING_IS_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_IS_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// Exact verification of a parametrization, and measurement of what it lacks. The decision is exact,
// at about the price of a floating point pass: see Exact_difference.h.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/mesh/Aligned_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_cut_complex.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingVerifying

The result of `measure_seamlessness()`. The counts are exact. The violations are computed in
floating point, with an error in their last digits.
*/
struct Seamlessness
{
  std::size_t number_of_interior_edges = 0; ///< edges with a face on both sides
  /// interior edges whose sides have different coordinates, and given cuts
  std::size_t number_of_mismatched_edges = 0;
  /// interior edges for which no transition holds exactly
  std::size_t number_of_inexact_edges = 0;
  std::size_t number_of_aligned_edges = 0;  ///< edges that were asked to be aligned
  /// aligned edges along which neither coordinate is constant
  std::size_t number_of_misaligned_edges = 0;
  std::size_t number_of_flipped_faces = 0;    ///< faces of negative orientation
  std::size_t number_of_degenerate_faces = 0; ///< faces of no area
  double extent = 0;    ///< the larger side of the bounding box of the coordinates
  double violation = 0; ///< the largest violation of a transition
  /// the largest change of the coordinate that changes less along an aligned edge
  double misalignment = 0;

  /// returns `true` if and only if all transitions and alignments hold exactly. Connection, cycle,
  /// and corner constraints are ignored.
  bool is_exact() const
  {
    return number_of_inexact_edges == 0 && number_of_misaligned_edges == 0;
  }
};

namespace internal {

// Whether the transition across an interior edge is exact: the given one, or any.
template <typename Group, typename Surface>
bool is_exact_edge(const Surface& surface,
                   const Given_transitions<Group, typename Surface::Halfedge>& given,
                   const typename Surface::Halfedge h)
{
  const Edge_sides sides = edge_sides(surface, h);
  for(const Uv& u : {sides.a, sides.b, sides.a_opposite, sides.b_opposite})
    if(!is_finite(u))
      return false;
  if(!given.is_consistent(h, surface.opposite(h)))
    return false;
  if(given.has_cuts() && !given.is_cut(h))
    return sides.are_identical();
  return given.has_rotations() ? satisfies_transition<Group>(sides, given.rotation(h))
                               : satisfies_some_transition<Group>(sides, given.order());
}

// [MC19] Eq. (5) for one edge: by how much the functional differs that differs least along it. 0
// only if it is constant, exactly.
template <typename Group, typename Surface>
double misalignment(const Surface& surface, typename Surface::Halfedge h)
{
  if(surface.is_border(h))
    h = surface.opposite(h);
  const Uv a = surface.uv(surface.prev(h)), b = surface.uv(h);
  double least = (std::min)(std::abs(b[0] - a[0]), std::abs(b[1] - a[1])); // 0 only if equal
  if constexpr(!Group::is_signed_permutation)
    if(is_finite(a) && is_finite(b))
      least = (std::min)(least, change_of_sum(a, b));
  return least;
}

// Edges of no length don't tell the rotation of a path that crosses them: as where they are
// snapped, the branch does.
// \pre all transitions and alignments hold exactly
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
bool further_constraints_hold(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                              const NamedParameters& np)
{
  const auto constraints = read_constraints<Group>(tmesh, np);
  if(constraints.refusal)
    return false;
  if(constraints.empty())
    return true;
  for(const auto corner : constraints.corners()) // perhaps on no interior edge
    if(!is_finite(get_uv(uv_map, corner)))
      return false;
  const auto transitions = read_transitions<Group>(tmesh, uv_map, np);
  if(transitions.refusal)
    return false;
  const auto surface = uv_surface(tmesh, uv_map, np);
  const Aligned_edges<Group, typename decltype(surface)::Halfedge> no_edges;
  const auto cuts = read_cut_complex(surface, transitions, no_edges, constraints);
  return is_exact(cuts.complex, cuts.complex.coordinates);
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
bool is_seamless(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const NamedParameters& np)
{
  using Group = Symmetry_group<NamedParameters>;
  const auto given = given_transitions<Group>(tmesh, np);
  const Uv_surface surface(tmesh, uv_map, No_indices());
  for(const auto h : surface.one_per_edge())
    if(!lies_on_border(surface, h) && !is_exact_edge<Group>(surface, given, h))
      return false;
  for(const auto h : edges_to_align(tmesh, np))
    if(misalignment<Group>(surface, h) != 0)
      return false;
  return further_constraints_hold<Group>(tmesh, uv_map, np);
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Seamlessness measure_seamlessness(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                  const NamedParameters& np)
{
  Seamlessness result;
  using Group = Symmetry_group<NamedParameters>;
  const auto given = given_transitions<Group>(tmesh, np);
  const Uv_surface surface(tmesh, uv_map, No_indices());
  CGAL::Bbox_2 box;
  for(const auto h : surface.one_per_face()) {
    const Uv_triangle triangle{{surface.uv(surface.prev(h)), surface.uv(h),
                                surface.uv(surface.next(h))}};
    for(const Uv& u : triangle)
      box += box_of(u);
    const CGAL::Orientation sign = orientation(triangle);
    result.number_of_flipped_faces += (sign == CGAL::NEGATIVE) ? 1 : 0;
    result.number_of_degenerate_faces += (sign == CGAL::ZERO) ? 1 : 0;
  }
  result.extent = extent_of(box);
  const double scale = unit_scale(result.extent);
  for(const auto h : surface.one_per_edge()) {
    if(lies_on_border(surface, h))
      continue;
    ++result.number_of_interior_edges;
    const Edge_sides sides = edge_sides(surface, h);
    if(sides.are_identical() && !given.is_cut_anyway(h, surface.opposite(h)))
      continue;
    ++result.number_of_mismatched_edges;
    if(is_exact_edge<Group>(surface, given, h))
      continue;
    ++result.number_of_inexact_edges;
    result.violation = (std::max)(result.violation,
                                  transition_violation<Group>(sides, given, h, scale) / scale);
  }
  for(const auto h : edges_to_align(tmesh, np)) {
    const double m = misalignment<Group>(surface, h);
    ++result.number_of_aligned_edges;
    result.number_of_misaligned_edges += (m == 0) ? 0 : 1;
    result.misalignment = (std::max)(result.misalignment, m);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingVerifying

returns whether a parametrization is exactly seamless, by exact arithmetic.

This is the case if for each interior edge there is a rotation \f$ R \f$ by a multiple of 90 degrees
such that
\f$ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f$. Here
\f$ \mathbf{u} \f$ and \f$ \mathbf{u}' \f$ are the coordinates of the ends \f$ a, b \f$ in the
charts of the two faces. In addition, one coordinate must be constant along each edge that is to be
aligned, and given constraints must hold. Faces can have any orientation.

If constraints have contracted a cut edge to a point, any rotation satisfies the equation. For
connections and cycles that cross such an edge, the function takes the rotation from the other edges
of the branch. If all of them are contracted, the coordinates do not determine the rotation: pass
`halfedge_rotation_map` as well.

\tparam TriangleMesh a model of `FaceGraph` and `EdgeListGraph`; with connection or cycle
        constraints, also of `FaceListGraph` and `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Values of border halfedges are not read.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the constraints of
       `snap_to_seamless()`, which are `edge_is_constrained_map`, `align_border`, `edge_is_cut_map`,
       `halfedge_rotation_map`, `rotational_symmetry`, `connection_constraints`,
       `cycle_constraints`, and `corner_constraints`. Without `edge_is_cut_map`, every edge may be a
       cut. With it, both sides of all other edges must have the same coordinates. Without
       `halfedge_rotation_map`, any rotation is accepted. The other parameters of
       `snap_to_seamless()` have no effect here: you can pass the same sequence to both.

\return `true` if and only if the parametrization is exactly seamless and satisfies the given
        constraints. The result is also `false` if a coordinate is NaN or infinite (with connections
        or cycles, also beyond 1e300), or if given rotations of opposite halfedges are not inverse
        to each other.

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of edges; about as fast as comparing the coordinates on both sides of each
edge.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool is_seamless(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::is_seamless(tmesh, uv_map,
                                 internal::strip(np, internal::surface_parameters));
}

/*!
\ingroup PkgSeamlessSnappingVerifying

measures how far a parametrization is from being exactly seamless and aligned, and counts the faces
that are flipped or degenerate in the domain.

\tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `is_seamless()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for
       `is_seamless()`. `connection_constraints`, `cycle_constraints`, and `corner_constraints` have
       no effect.

\return the largest violation of a seam and of an alignment, the extent of the coordinates, and
        counts of inexact edges and of flipped and degenerate faces

\pre all coordinates are finite

\throws std::runtime_error if the program was compiled with options like `-ffast-math`

\par Complexity
Linear in the number of faces.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Seamlessness measure_seamlessness(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Require_exact_arithmetic protect;
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::measure_seamlessness(tmesh, uv_map,
                                          internal::strip(np, internal::surface_parameters));
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IS_SEAMLESS_H
