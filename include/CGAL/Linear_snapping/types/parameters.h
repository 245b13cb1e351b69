// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_TYPES_PARAMETERS_H
#define CGAL_LINEAR_SNAPPING_TYPES_PARAMETERS_H

#include <CGAL/license/Linear_snapping.h>

// The named parameters of the package.

// { outside of CGAL
// CGAL's list of names can't be extended from outside of CGAL, so that this header wraps a plain
// chain of CGAL's named parameters in a class that has member functions for the names which the
// package adds, and for those of CGAL's that are of use here. The chain inside stays a plain one:
// public functions call `internal::strip(np)` first and hand nothing but CGAL's own type on.
// Within CGAL the first list below moves to <CGAL/STL_Extension/internal/parameters_interface.h>:
// scripts/into_cgal leaves out all that stands in such braces, but for lines that tell what stands
// there within CGAL.
// } outside of CGAL

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

// { outside of CGAL
// The names that the package adds, one per line: tag type, tag, name of the function.
#define CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS(F)                                                   \
  F(align_border_t, align_border, align_border)                                                    \
  F(align_boundary_t, align_boundary, align_boundary)                                              \
  F(allow_holes_t, allow_holes, allow_holes)                                                       \
  F(border_tolerance_t, border_tolerance, border_tolerance)                                        \
  F(cell_neighbors_t, cell_neighbors, cell_neighbors)                                              \
  F(cone_index_t, cone_index, cone_index_map)                                                      \
  F(connection_constraints_t, connection_constraints, connection_constraints)                      \
  F(connection_tolerance_t, connection_tolerance, connection_tolerance)                            \
  F(corner_constraints_t, corner_constraints, corner_constraints)                                  \
  F(curvature_adaptivity_t, curvature_adaptivity, curvature_adaptivity)                            \
  F(curvature_alignment_t, curvature_alignment, curvature_alignment)                               \
  F(cycle_constraints_t, cycle_constraints, cycle_constraints)                                     \
  F(curve_stop_policy_t, curve_stop_policy, curve_stop_policy)                                     \
  F(decide_exactly_t, decide_exactly, decide_exactly)                                              \
  F(edge_is_cut_t, edge_is_cut, edge_is_cut_map)                                                   \
  F(face_direction_t, face_direction, face_direction_map)                                          \
  F(face_location_t, face_location, face_location_map)                                             \
  F(feature_edges_t, feature_edges, feature_edges)                                                 \
  F(feature_facets_t, feature_facets, feature_facets)                                              \
  F(grid_scale_t, grid_scale, grid_scale)                                                          \
  F(halfedge_rotation_t, halfedge_rotation, halfedge_rotation_map)                                 \
  F(halfedge_uv_t, halfedge_uv, halfedge_uv_map)                                                   \
  F(integer_grid_t, integer_grid, integer_grid)                                                    \
  F(known_fields_t, known_fields, known_fields) /* of callers within the packages */               \
  F(largest_cone_index_t, largest_cone_index, largest_cone_index)                                  \
  F(least_cone_distance_t, least_cone_distance, least_cone_distance)                               \
  F(maximum_feature_loss_t, maximum_feature_loss, maximum_feature_loss)                            \
  F(maximum_length_t, maximum_length, maximum_length)                                              \
  F(untangling_iterations_t, untangling_iterations, number_of_untangling_iterations)               \
  F(minimize_number_of_quads_t, minimize_number_of_quads, minimize_number_of_quads)                \
  F(near_distance_t, near_distance, near_distance)                                                 \
  F(needs_face_graph_t, needs_face_graph, needs_face_graph)                                        \
  F(release_alignment_t, release_alignment, release_alignment)                                     \
  F(repair_flips_t, repair_flips, repair_flips)                                                    \
  F(rotational_symmetry_t, rotational_symmetry, rotational_symmetry)                               \
  F(rounding_tolerance_t, rounding_tolerance, rounding_tolerance)                                  \
  F(symmetry_plane_t, symmetry_plane, symmetry_plane)                                              \
  F(target_edge_length_t, target_edge_length, target_edge_length)                                  \
  F(target_number_of_hexahedra_t, target_number_of_hexahedra, target_number_of_hexahedra)          \
  F(target_number_of_quads_t, target_number_of_quads, target_number_of_quads)                      \
  F(target_vertex_t, target_vertex, target_vertex)                                                 \
  F(tolerance_t, tolerance, tolerance)                                                             \
  F(value_weights_t, value_weights, value_weights)                                                 \
  F(vertex_location_t, vertex_location, vertex_location_map)                                       \
  F(vertex_sizing_t, vertex_sizing, vertex_sizing_map)                                             \
  F(weld_borders_t, weld_borders, weld_borders)

// The names of CGAL's that can be chained with them; the tags are CGAL's.
#define CGAL_SEAMLESS_SNAPPING_CGAL_PARAMETERS(F)                                                  \
  F(area_threshold_t, area_threshold, area_threshold)                                              \
  F(edge_is_constrained_t, edge_is_constrained, edge_is_constrained_map)                           \
  F(face_patch_t, face_patch, face_patch_map)                                                      \
  F(maximum_number_t, maximum_number, maximum_number)                                              \
  F(number_of_iterations_t, number_of_iterations, number_of_iterations)                            \
  F(number_of_relaxation_steps_t, number_of_relaxation_steps, number_of_relaxation_steps)          \
  F(random_seed_t, random_seed, random_seed)                                                       \
  F(sparse_linear_solver_t, sparse_linear_solver, sparse_linear_solver)                            \
  F(verbose_t, verbose, verbose)                                                                   \
  F(vertex_index_t, vertex_index, vertex_index_map)                                                \
  F(vertex_is_constrained_t, vertex_is_constrained, vertex_is_constrained_map)                     \
  F(vertex_point_t, vertex_point, vertex_point_map)                                                \
  F(visitor_t, visitor, visitor)

#define CGAL_SEAMLESS_SNAPPING_PARAMETERS(F)                                                       \
  CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS(F)                                                         \
  CGAL_SEAMLESS_SNAPPING_CGAL_PARAMETERS(F)

// } outside of CGAL
namespace CGAL {
// { outside of CGAL

// The tags stand beside CGAL's, where they will be within CGAL. Should CGAL come to use one of them
// for itself, the compiler says so.
namespace internal_np {

#define CGAL_SEAMLESS_SNAPPING_DEFINE(Tag_type, tag, function) enum Tag_type { tag };
CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS(CGAL_SEAMLESS_SNAPPING_DEFINE)
#undef CGAL_SEAMLESS_SNAPPING_DEFINE

} // namespace internal_np

// } outside of CGAL
namespace Linear_snapping {
namespace internal {

// { outside of CGAL
// A plain chain `NP` of CGAL's named parameters, with a member function for each name of the lists
// above: each returns the chain that is longer by that parameter, wrapped again.
template <typename NP>
struct Named_parameters
  : public NP
{
  Named_parameters(const NP& np)
    : NP(np)
  { }

  const NP& cgal_named_parameters() const { return *this; }

#define CGAL_SEAMLESS_SNAPPING_DEFINE(Tag_type, tag, function)                                     \
  template <typename K>                                                                            \
  Named_parameters<CGAL::Named_function_parameters<K, CGAL::internal_np::Tag_type, NP> >           \
  function(const K& k) const                                                                       \
  {                                                                                                \
    return CGAL::Named_function_parameters<K, CGAL::internal_np::Tag_type, NP>(                    \
             k, cgal_named_parameters());                                                          \
  }
  CGAL_SEAMLESS_SNAPPING_PARAMETERS(CGAL_SEAMLESS_SNAPPING_DEFINE)
#undef CGAL_SEAMLESS_SNAPPING_DEFINE
};
// within CGAL: // All names are member functions of a plain chain `NP`.
// within CGAL: template <typename NP>
// within CGAL: using Named_parameters = NP;
// within CGAL:

// Returns the plain chain. To be called by each public function before anything else: CGAL's
// overloads that tell a range from a chain by its type take the wrapper for a range.
template <typename NP>
const NP& strip(const Named_parameters<NP>& np)
{
  return np.cgal_named_parameters();
}

// } outside of CGAL
template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
strip(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}

// A set of named parameters by their tags, as `named<internal_np::verbose, internal_np::visitor>`.
template <auto... Tag>
struct Named
{ };

template <auto... Tag>
constexpr Named<Tag...> named{};

template <auto... A, auto... B>
constexpr Named<A..., B...> operator+(Named<A...>, Named<B...>)
{
  return {};
}

constexpr auto map_parameters =
  named<CGAL::internal_np::cone_index, CGAL::internal_np::edge_is_constrained,
        CGAL::internal_np::edge_is_cut, CGAL::internal_np::face_direction,
        CGAL::internal_np::face_location, CGAL::internal_np::face_patch,
        CGAL::internal_np::halfedge_rotation, CGAL::internal_np::halfedge_uv,
        CGAL::internal_np::vertex_index, CGAL::internal_np::vertex_is_constrained,
        CGAL::internal_np::vertex_location, CGAL::internal_np::vertex_point,
        CGAL::internal_np::vertex_sizing>;

template <typename Tag, auto... Tags>
constexpr bool is_among(Named<Tags...>)
{
  return (std::is_same_v<Tag, std::remove_const_t<decltype(Tags)> > || ...);
}

template <typename T, typename = void>
constexpr bool is_range = false;

template <typename T>
constexpr bool is_range<T, std::void_t<decltype(std::declval<const T&>().begin())> > = true;

// Property maps of a mesh are ranges, too.
template <typename T, typename = void>
constexpr bool is_container = is_range<T>;

template <typename T>
constexpr bool is_container<T, std::void_t<typename T::category> > = false;

// Fails to compile if a container is passed in place of a property map.
template <typename Parameter, typename Tag>
struct Map_of_the_parameter
{
  static constexpr bool is_valid = !is_container<Parameter> || !is_among<Tag>(map_parameters);
  static_assert(is_valid,
                "this named parameter takes a property map, not a container: use a property map of "
                "the mesh, or wrap a vector by boost::make_function_property_map");
};

// Fails to compile if a function does not read the parameter of a tag. The compiler names the tag.
template <typename Tag, auto... Read>
struct Parameter_of_the_function
{
  static_assert(is_among<Tag>(named<Read...>),
                "the function does not read this named parameter, which is the first template "
                "argument of Parameter_of_the_function: leave it out, or pass it to the function "
                "that it is for");
};

// The end of a chain.
template <typename Chain, auto... Read>
struct Check_parameters
{
  static constexpr bool have_maps = true;
};

template <typename T, auto... Read>
struct Check_parameters<CGAL::Named_function_parameters<T, CGAL::internal_np::all_default_t>,
                        Read...>
{
  static constexpr bool have_maps = true;
};

template <typename T, typename Tag, typename Base, auto... Read>
struct Check_parameters<CGAL::Named_function_parameters<T, Tag, Base>, Read...>
  : Parameter_of_the_function<Tag, Read...>
{
  static constexpr bool have_maps =
    Map_of_the_parameter<T, Tag>::is_valid && Check_parameters<Base, Read...>::have_maps;
};

// The plain chain, for a function that reads these parameters and no others. Without maps it would
// compile with many more errors, so it is replaced by an empty chain then.
template <typename NP, auto... Read>
decltype(auto) strip(const NP& np, Named<Read...>)
{
  const auto& plain_np = strip(np);
  if constexpr(Check_parameters<std::decay_t<decltype(plain_np)>, Read...>::have_maps)
    return (plain_np);
  else
    return CGAL::parameters::Default_named_parameters(true);
}

// Whether a parameter is in a chain; or, of the type of what `get_parameter()` returned, whether it
// was.
template <typename NP, typename Tag = void>
constexpr bool is_given = !CGAL::parameters::is_default_parameter<NP, Tag>::value;

template <typename Parameter>
constexpr bool is_given<Parameter, void> =
  !std::is_same_v<std::decay_t<Parameter>, CGAL::internal_np::Param_not_found>;

// The parameter, or what it is by default; numbers are of the type of the default.
template <typename NP, typename Tag, typename Default>
auto chosen(const NP& np, const Tag tag, const Default& by_default)
{
  using namespace CGAL::parameters;
  if constexpr(std::is_arithmetic_v<Default>)
    return static_cast<Default>(choose_parameter(get_parameter(np, tag), by_default));
  else
    return choose_parameter(get_parameter(np, tag), by_default);
}

// Whether `T` is a chain of named parameters, plain or wrapped: for functions whose last positional
// argument is optional, so that `f(a, np)` is not taken for `f(a, b)`.
template <typename T>
struct Is_named_parameters
  : public std::false_type
{ };

template <typename T, typename Tag, typename Base>
struct Is_named_parameters<CGAL::Named_function_parameters<T, Tag, Base> >
  : public std::true_type
{ };

// { outside of CGAL
template <typename NP>
struct Is_named_parameters<Named_parameters<NP> >
  : public std::true_type
{ };

// } outside of CGAL
template <typename T>
using is_named_parameters = Is_named_parameters<std::remove_cv_t<std::remove_reference_t<T> > >;

} // namespace internal

// { outside of CGAL
/*!
 * \ingroup PkgLinearSnappingParameters
 *
 * \brief Functions that start a sequence of named parameters.
 *
 * All functions take their optional arguments as \ref bgl_namedparameters "Named Parameters". Some
 * names are \cgal's, others belong to these packages. A sequence that uses a name of these packages
 * starts here, and continues with any of the names below, in any order:
 *
 * \code{.cpp}
 * namespace parameters = CGAL::Linear_snapping::parameters;
 * CGAL::Seamless_snapping::snap_to_seamless(tmesh, uv_map,
 *                                           parameters::edge_is_constrained_map(eicm)
 *                                                      .align_border(true)
 *                                                      .verbose(true));
 * \endcode
 *
 * All packages have these functions, for example `CGAL::Quad_remeshing::parameters`. A sequence can
 * also start in `CGAL::parameters`; it then contains \cgal's names only. If a name occurs twice,
 * the last one counts.
 *
 * Names of the packages:
 * - `align_border`: whether border edges are to lie on isocurves (`bool`)
 * - `align_boundary`: whether boundary facets of a volume are to lie in planes of constant
 *   coordinates (`bool`)
 * - `allow_holes`: whether cells around faces that are not positive are left out (`bool`)
 * - `border_tolerance`: how far the border of the quads may be from the border of the surface, so
 *   that it has fewer corners (`double`)
 * - `cell_neighbors`: the known neighbors of the cells of a volume
 * - `cone_index_map`: the index of each vertex in quarter turns, for given cones
 * - `connection_constraints`, `cycle_constraints`, `corner_constraints`: further constraints on a
 *   parametrization
 * - `connection_tolerance`: the largest distance by which connections and cycles may miss before
 *   snapping, relative to the extent of the coordinates (`double`)
 * - `curvature_adaptivity`: how many times larger quads may be on flat parts (`double`)
 * - `curvature_alignment`: how strongly a field follows the principal directions (`double`)
 * - `curve_stop_policy`: which curves of a layout end at a crossing
 * - `decide_exactly`: whether isocurves are traced by exact decisions (`bool`)
 * - `edge_is_cut_map`: the known cut edges
 * - `face_direction_map`: the direction of the cross field in each face, if you prescribe it
 * - `face_location_map`: the place on the input of the middle of each face of a quad mesh
 * - `feature_facets`, `feature_edges`: facets and edges of a volume, or edges of a soup, that are
 *   to be aligned
 * - `grid_scale`: the factor of all coordinates, applied first (`double`)
 * - `halfedge_rotation_map`: the rotation across each halfedge, if you know it: a number of quarter
 *   turns or, with `rotational_symmetry`, of turns by 360 / N degrees
 * - `halfedge_uv_map`: the coordinates of each corner, if you have a parametrization
 * - `integer_grid`: whether translations, cones, and aligned edges or facets become integers
 *   (`bool`)
 * - `largest_cone_index`: the largest index that a cone may have, in quarter turns (`int`)
 * - `least_cone_distance`: the distance up to which opposite cones of a field cancel (`double`)
 * - `maximum_feature_loss`: the part of the length of the features that may be released if
 *   features force quads (`double`)
 * - `maximum_length`: the length in the domain at which an isocurve ends (`double`)
 * - `minimize_number_of_quads`: whether a quantization has as few quads as the search finds
 *   (`bool`)
 * - `near_distance`: for isocurves in floating point, the distance at which a curve counts as
 *   having missed a vertex, relative to the extent of the coordinates (`double`)
 * - `needs_face_graph`: whether the quads of a quantization have to form a face graph (`bool`)
 * - `number_of_untangling_iterations`: about the largest number of iterations over all faces that
 *   repairs of flipped triangles take (`unsigned int`)
 * - `release_alignment`: whether a feature need not be aligned if it would flip triangles (`bool`)
 * - `repair_flips`: whether faces or cells that are flipped or degenerate in the input are
 *   repaired (`bool` or `Flip_repair`)
 * - `rotational_symmetry`: by which angles charts are turned across cuts (`Rotational_symmetry`)
 * - `rounding_tolerance`: the largest allowed distance of a coordinate from its integer (`double`)
 * - `symmetry_plane`: the plane by which a quad mesh is to be its own mirror image
 * - `target_edge_length`: the wanted length of edges of quads (`double`)
 * - `target_number_of_hexahedra`: about how many hexahedra a mesh has (`std::size_t`)
 * - `target_number_of_quads`: about how many quads a quantization has (`std::size_t`)
 * - `target_vertex`: the vertex at which an isocurve ends
 * - `tolerance`: the largest violation that counts as noise, relative to the extent of the
 *   coordinates (`double`)
 * - `value_weights`: one positive weight for each value in the sum of squared changes
 * - `vertex_location_map`: the place on the input of each vertex of a quad mesh
 * - `vertex_sizing_map`: the wanted length of edges of quads at each vertex of the input
 * - `weld_borders`: whether a reader joins border edges that coincide in space
 *
 * Names of \cgal: `area_threshold`, `edge_is_constrained_map`, `face_patch_map`, `maximum_number`,
 * `number_of_iterations`, `number_of_relaxation_steps`, `random_seed`, `sparse_linear_solver`,
 * `verbose`, `vertex_index_map`, `vertex_is_constrained_map`, `vertex_point_map`, `visitor`.
 * `maximum_number` is the number of things made or visited above which a function gives up.
 *
 * The reference of each function lists the names that it reads. A call with another name does not
 * compile. A few names require another name; the reference of the function says which.
 *
 * \note With both `using namespace CGAL` and `using namespace CGAL::Seamless_snapping`, the name
 *       `parameters` alone is ambiguous: write an alias as above.
 */
namespace parameters {

/// returns an empty sequence of named parameters, to which parameters can be added.
inline internal::Named_parameters<CGAL::parameters::Default_named_parameters> default_values()
{
  return CGAL::parameters::default_values();
}

/// \cond SKIP_IN_MANUAL
#define CGAL_SEAMLESS_SNAPPING_DEFINE(Tag_type, tag, function)                                     \
  template <typename K>                                                                            \
  internal::Named_parameters<CGAL::Named_function_parameters<K, CGAL::internal_np::Tag_type> >     \
  function(const K& k)                                                                             \
  {                                                                                                \
    return CGAL::Named_function_parameters<K, CGAL::internal_np::Tag_type>(k);                     \
  }
CGAL_SEAMLESS_SNAPPING_PARAMETERS(CGAL_SEAMLESS_SNAPPING_DEFINE)
#undef CGAL_SEAMLESS_SNAPPING_DEFINE
/// \endcond

} // namespace parameters
// within CGAL: namespace parameters = CGAL::parameters;
// within CGAL:
// } outside of CGAL
} // namespace Linear_snapping
} // namespace CGAL

// { outside of CGAL
// CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS and CGAL_SEAMLESS_SNAPPING_CGAL_PARAMETERS stay defined:
// the test of this header runs through the same lists.

// } outside of CGAL
#endif // CGAL_LINEAR_SNAPPING_TYPES_PARAMETERS_H
