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

#ifndef CGAL_QUAD_REMESHING_QUAD_PATCHES_H
#define CGAL_QUAD_REMESHING_QUAD_PATCHES_H

#include <CGAL/license/Quad_remeshing.h>

// Divides a quad mesh into rectangular patches.

#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/Patch_finder.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/types/Quad_patches.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The reason for which a mesh can't be divided, if there is one.
template <typename QuadMesh, typename NamedParameters>
std::optional<Refusal> defect_of_quads(const QuadMesh& mesh, const NamedParameters& np)
{
  if(num_faces(mesh) == 0)
    return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face");
  std::size_t i = 0;
  for(const auto f : faces(mesh)) {
    if(const std::size_t n = degree(f, mesh); n != 4)
      return Refusal(Outcome::INVALID_ARGUMENT,
                     name_of_face(i) + " has " + std::to_string(n) + " sides" +
                       remedy("quad_remesh() makes meshes of quads only"));
    ++i;
  }
  std::vector<typename boost::graph_traits<QuadMesh>::halfedge_descriptor> fans;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(fans));
  if(fans.empty())
    return std::nullopt;
  const auto indices = CGAL::get_initialized_vertex_index_map(mesh, np);
  return Refusal(Outcome::NOT_MANIFOLD,
                 "the faces around " +
                   name_of_vertex(std::size_t(get(indices, target(fans.front(), mesh)))) +
                   " form several fans" + remedy(duplicate_vertices));
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingPatches

divides a quad mesh into rectangles of quads, for example to fit splines.

The patches are the patches of `motorcycle_graph()` for the map in which each quad is a unit square.
Curves start at irregular vertices, and at vertices at which borders and features end, meet, or
turn. They run along edges, all at the same speed, and end at such vertices, at borders and
features, and at a point that another curve has passed before. A T-junction is a vertex of one patch
in the interior of a side of another patch. With `curve_stop_policy(Run_to_nodes())`, curves cross
each other; then there are more patches, and T-junctions at features only. If a part of the surface
between borders and features has no start of a curve, the function chooses a vertex there.

The computation is combinatorial. At the end, the function checks that each patch is a rectangle of
quads, and that each quad is in one patch.

\tparam QuadMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the mesh, such as one that `quad_remesh()` has made
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges, which lie between patches in the result}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{curve_stop_policy}
    \cgalParamDescription{whether curves end at curves that they meet}
    \cgalParamType{`Stop_at_curves` or `Run_to_nodes`}
    \cgalParamDefault{`Stop_at_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{receives for each quad the number of its patch, from 0}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%face_descriptor` as key type and
                   `std::size_t` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{names vertices in messages}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and an integer
                   type as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the patches; converts to `true` if and only if there are patches. Otherwise, nothing is
        written, and `Quad_patches::status` is
        - `INVALID_ARGUMENT`: there is no face, or a face is no quad;
        - `NOT_MANIFOLD`: the faces around a vertex form several fans;
        - `INTERNAL_ERROR`: the patches failed the check at the end.
        .
        The message names the face or vertex, in the order of iteration.

\par Complexity
Linear in the size of the mesh.

\sa `vertices_of_patch()`
*/
template <typename QuadMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Quad_patches<QuadMesh> quad_patches(const QuadMesh& mesh,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::get_parameter;
  using Edge = typename boost::graph_traits<QuadMesh>::edge_descriptor;
  using Face = typename boost::graph_traits<QuadMesh>::face_descriptor;
  constexpr auto read =
    internal::named<CGAL::internal_np::curve_stop_policy, CGAL::internal_np::edge_is_constrained,
                    CGAL::internal_np::face_patch, CGAL::internal_np::vertex_index>;
  const auto& plain_np = internal::strip(np, read);
  const auto features = internal::chosen(plain_np, CGAL::internal_np::edge_is_constrained,
                                         CGAL::Constant_property_map<Edge, bool>(false));
  const auto patches = get_parameter(plain_np, CGAL::internal_np::face_patch);
  const auto policy = internal::chosen(plain_np, CGAL::internal_np::curve_stop_policy,
                                       Stop_at_curves());
  using Policy = std::decay_t<decltype(policy)>;
  constexpr bool may_cross = std::is_same_v<Policy, Run_to_nodes>;
  static_assert(may_cross || std::is_same_v<Policy, Stop_at_curves>,
                "curve_stop_policy must be Stop_at_curves or Run_to_nodes");
  Quad_patches<QuadMesh> result;
  std::optional<internal::Refusal> refusal = internal::defect_of_quads(mesh, plain_np);
  std::vector<std::pair<Face, std::size_t> > patch_of_face; // written after all checks
  if(!refusal)
    refusal = internal::Patch_finder(mesh, features, may_cross).run(
      result, [&](const Face f, const std::size_t patch) {
        if constexpr(internal::is_given<decltype(patches)>)
          patch_of_face.emplace_back(f, patch);
      });
  if(refusal) {
    result.patches.clear();
    internal::refuse(result, *refusal);
    return result;
  }
  if constexpr(internal::is_given<decltype(patches)>)
    for(const auto& [f, patch] : patch_of_face)
      put(patches, f, patch);
  return result;
}

/*!
\ingroup PkgQuadRemeshingPatches

writes the vertices of a patch, row by row: `height + 1` rows of `width + 1` vertices, the first of
which begins at the corner. At the points of these vertices, a surface of splines can be fitted to
the patch.

\tparam QuadMesh the type of the mesh
\tparam OutputIterator a model of `OutputIterator` that takes
        `boost::graph_traits<QuadMesh>::%vertex_descriptor`

\param patch a patch that `quad_patches()` has returned for the mesh
\param mesh the mesh
\param out receives the vertices

\return the past-the-end output iterator

\par Complexity
Linear in the number of vertices.
*/
template <typename QuadMesh, typename OutputIterator>
OutputIterator vertices_of_patch(const Quad_patch<QuadMesh>& patch, const QuadMesh& mesh,
                                 OutputIterator out)
{
  // The lower vertices of each row of quads, and the upper ones of the last row.
  auto row = patch.corner;
  for(std::size_t j = 0; j <= patch.height; ++j) {
    const bool is_last = j == patch.height;
    auto h = row;
    for(std::size_t i = 0; i < patch.width; ++i) {
      if(i > 0)
        h = next(opposite(next(h, mesh), mesh), mesh);
      *out++ = is_last ? target(next(next(h, mesh), mesh), mesh) : source(h, mesh);
    }
    *out++ = is_last ? target(next(h, mesh), mesh) : target(h, mesh);
    if(j + 1 < patch.height)
      row = opposite(next(next(row, mesh), mesh), mesh);
  }
  return out;
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_QUAD_PATCHES_H
