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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_COPY_TO_FACE_GRAPH_H
#define CGAL_ISOCURVES_AND_LAYOUTS_COPY_TO_FACE_GRAPH_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Layouts as meshes, a polygon for each patch, or the input refined along the arcs; and as OBJ
// files, with the patches as groups of faces, and the arcs as lines.

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Refined_faces.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/write_cells.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <ios>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {

namespace internal {

constexpr auto parameters_of_points = named<CGAL::internal_np::vertex_point>;

// The parameters of the mesh of patches.
constexpr auto parameters_of_patches =
  named<CGAL::internal_np::edge_is_constrained, CGAL::internal_np::face_patch,
        CGAL::internal_np::vertex_location, CGAL::internal_np::vertex_point>;

// The point in space at a location; rounded.
template <typename Point, typename TriangleMesh, typename VertexPointMap, typename Location>
Point point_in_face(const TriangleMesh& tmesh, const VertexPointMap& points,
                    const Location& location)
{
  return point_at<Point>(
    place_in_face(tmesh, points, prev(halfedge(location.first, tmesh), tmesh), location.second));
}

inline bool are_patches_discs(const Layout& layout)
{
  return std::all_of(layout.patches.begin(), layout.patches.end(), [](const Layout_patch& patch)
                     { return patch.cycles.size() == 1 && patch.euler_characteristic == 1; });
}

template <typename TriangleMesh>
Polygon_complex cells_of_patches(const Motorcycle_graph<TriangleMesh>& graph)
{
  const Layout& layout = graph.data().layout;
  Polygon_complex result;
  result.n_vertices = layout.points.size();
  result.n_cells = layout.patches.size();
  for(std::size_t h = 0; h < layout.half_arcs.size(); ++h) {
    result.targets.push_back(layout.target(Half_arc_index(h)));
    result.nexts.push_back(layout.half_arcs[h].next);
    result.cells.push_back(layout.half_arcs[h].patch);
  }
  return result;
}

// Puts the points, and the maps that are given; `location(v)` is where vertex v lies, `is_arc(e)`
// and `patch(c)` are what edges and faces are.
template <typename TriangleMesh, typename PolygonMesh, typename NamedParameters1,
          typename NamedParameters2, typename LocationOf, typename IsArc, typename PatchOf>
void write_layout(const TriangleMesh& tmesh, const Polygon_complex& cells, PolygonMesh& output,
                  const NamedParameters1& np1, const NamedParameters2& np2,
                  const LocationOf& location, const IsArc& is_arc, const PatchOf& patch)
{
  using CGAL::parameters::get_parameter;
  namespace np_tags = CGAL::internal_np;
  const auto points = chosen(np1, np_tags::vertex_point,
                             CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  auto new_points = chosen(np2, np_tags::vertex_point,
                           CGAL::get_property_map(CGAL::vertex_point, output));
  using Point = typename boost::property_traits<decltype(new_points)>::value_type;
  const auto locations = get_parameter(np2, np_tags::vertex_location);
  const auto arcs = get_parameter(np2, np_tags::edge_is_constrained);
  const auto patches = get_parameter(np2, np_tags::face_patch);
  Cell_writer<PolygonMesh, Polygon_complex> writer(cells, output);
  for(std::size_t i = 0; i < cells.number_of_vertices(); ++i) {
    const auto v = writer.new_vertex();
    put(new_points, v, point_in_face<Point>(tmesh, points, location(i)));
    if constexpr(is_given<decltype(locations)>)
      put(locations, v, location(i));
  }
  writer.add_edges_and_faces(
    [&](const auto e, const std::size_t dart) {
      if constexpr(is_given<decltype(arcs)>)
        put(arcs, e, is_arc(dart / 2));
    },
    [&](const auto f, const std::size_t i) {
      if constexpr(is_given<decltype(patches)>)
        put(patches, f, patch(i));
    });
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

adds the patches of a layout to a mesh, as polygons: their corners are vertices of 90 degrees in the
domain, and nodes at which curves end beside them are vertices of 180 degrees. Vertices, edges, and
faces are added in the order of nodes, arcs, and patches.

\tparam TriangleMesh the type of the mesh of the layout
\tparam PolygonMesh a model of `MutableFaceGraph`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param graph the layout
\param patches the mesh that the patches are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of the mesh of the layout}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the new vertices}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, patches)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_location_map}
    \cgalParamDescription{receives for each new vertex its place on the mesh of the layout}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and
                   `Motorcycle_graph<TriangleMesh>::Location` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it lies on the border or on features}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{receives for each new face its patch}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%face_descriptor` as key type and
                   `std::size_t` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `true` if the patches were added. `false`, and nothing is added, if
        - there is no layout,
        - there are loops, several arcs between the same two nodes, or a patch on both sides of an
          arc: no valid polygon mesh has these. More nodes, by `vertex_is_constrained_map` of
          `motorcycle_graph()`, may help;
        - a patch is not a disk, because a border that does not lie on isocurves cuts it.

\par Complexity
Linear in the number of nodes, arcs, and patches, except for a logarithmic factor.
*/
template <typename TriangleMesh, typename PolygonMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
bool copy_to_face_graph(const Motorcycle_graph<TriangleMesh>& graph, PolygonMesh& patches,
                        const NamedParameters1& np1 = CGAL::parameters::default_values(),
                        const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  const internal::Polygon_complex cells = internal::cells_of_patches(graph);
  if(!graph || !internal::are_patches_discs(graph.data().layout) || !internal::is_simple(cells))
    return false;
  internal::write_layout(graph.mesh(), cells, patches,
                         internal::strip(np1, internal::parameters_of_points),
                         internal::strip(np2, internal::parameters_of_patches),
                         [&](const std::size_t n) { return graph.node_location(n); },
                         [&](const std::size_t a) { return graph.arc_is_constrained(a); },
                         [](const std::size_t p) { return p; });
  return true;
}

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

adds the mesh of a layout to another mesh, refined along the arcs: each of its faces is cut into
convex polygons by the arcs that cross it, so that each new face belongs to one patch. Exact
arithmetic decides how faces are cut; the new points are rounded.

The parameters are the same as for `copy_to_face_graph()`, except for these:
- `edge_is_constrained_map` among `np2` receives for each new edge whether it lies on an arc.
- `face_patch_map` among `np2` receives for each new face the patch that it belongs to.
- The first vertices that are added are the vertices of the mesh of the layout, in the order of
  `vertices(tmesh)`, without vertices that have no face.

\return `false` if there is no layout; then nothing is added.

\par Complexity
Linear in the size of the mesh and of the result, except for sorting points of arcs along edges
and in faces.

\sa `CGAL::Polygon_mesh_processing::triangulate_faces()`
*/
template <typename TriangleMesh, typename PolygonMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
bool refine_along_arcs(const Motorcycle_graph<TriangleMesh>& graph, PolygonMesh& refined,
                       const NamedParameters1& np1 = CGAL::parameters::default_values(),
                       const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  if(!graph)
    return false;
  const internal::Protect_exact_arithmetic protect;
  const internal::Layout_data& data = graph.data();
  const internal::Refined_faces faces(data.domain.mesh, data.race->curves(), data.layout);
  if(!faces.is_covered() || !faces.joined_patches().empty())
    return false;
  internal::write_layout(graph.mesh(), faces.cells(), refined,
                         internal::strip(np1, internal::parameters_of_points),
                         internal::strip(np2, internal::parameters_of_patches),
                         [&](const std::size_t v) { return graph.location(faces.point(v)); },
                         [&](const std::size_t e) { return faces.is_on_arc(e); },
                         [&](const std::size_t c) { return faces.patch_of_cell(c); });
  return true;
}

namespace internal {

// Cells by patches, counted from 1.
template <typename IsCut>
void append_groups(const Refined_faces& faces, const IsCut& is_cut, std::string& text)
{
  const Polygon_complex& cells = faces.cells();
  std::vector<std::size_t> darts(cells.number_of_cells());
  for(std::size_t d = 0; d < cells.number_of_darts(); ++d)
    if(cells.cells[d] != no_index)
      darts[std::size_t(cells.cells[d])] = d;
  std::vector<std::size_t> order(cells.number_of_cells());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b)
                   { return faces.patch_of_cell(a) < faces.patch_of_cell(b); });
  for(std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t patch = faces.patch_of_cell(order[i]);
    if(i == 0 || faces.patch_of_cell(order[i - 1]) != patch)
      text += "g patch_" + std::to_string(patch + 1) + (is_cut(patch) ? " cut\n" : "\n");
    text += 'f';
    std::size_t d = darts[order[i]];
    do {
      text += ' ' + std::to_string(cells.targets[d] + 1);
      d = std::size_t(cells.nexts[d]);
    } while(d != darts[order[i]]);
    text += '\n';
  }
}

inline void append_lines(const Refined_faces& faces, std::string& text)
{
  text += "g arcs";
  Half_arc_index half = no_index;
  for(const Arc_step& step : faces.steps()) {
    if(step.half != half)
      text += "\nl " + std::to_string(step.source + 1);
    half = step.half;
    text += ' ' + std::to_string(step.target + 1);
  }
  text += '\n';
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

writes a layout in the format OBJ: the mesh refined along the arcs, as `refine_along_arcs()` makes
it, with a group of faces for each patch, named `patch_1` and so on, and an element `l` for each
arc, with all its points, in the group `arcs`. Patches that are no rectangles are also in the group
`cut`.

\tparam TriangleMesh the type of the mesh of the layout
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param os the stream
\param graph the layout
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
       among `np1` of `copy_to_face_graph()`

\return `false` if there is no layout, or if writing fails

\par Complexity
As for `refine_along_arcs()`, and linear in the size of the file.
*/
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_layout(std::ostream& os, const Motorcycle_graph<TriangleMesh>& graph,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  if(!graph)
    return false;
  const internal::Protect_exact_arithmetic protect;
  const auto points =
    internal::chosen(internal::strip(np), CGAL::internal_np::vertex_point,
                     CGAL::get_const_property_map(CGAL::vertex_point, graph.mesh()));
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  const internal::Layout_data& data = graph.data();
  const internal::Refined_faces faces(data.domain.mesh, data.race->curves(), data.layout);
  std::string text;
  for(std::size_t v = 0; v < faces.cells().number_of_vertices(); ++v) {
    const Point p =
      internal::point_in_face<Point>(graph.mesh(), points, graph.location(faces.point(v)));
    text += 'v';
    for(const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}) {
      text += ' ';
      internal::append_decimal(text, x);
    }
    text += '\n';
  }
  internal::append_groups(faces, [&](const std::size_t p) { return graph.patch_is_cut(p); }, text);
  internal::append_lines(faces, text);
  return bool(os.write(text.data(), static_cast<std::streamsize>(text.size())));
}

} // namespace IO

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_COPY_TO_FACE_GRAPH_H
