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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_IO_LAYOUT_H
#define CGAL_ISOCURVES_AND_LAYOUTS_IO_LAYOUT_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Layouts as OBJ files: the patches as groups of faces, the arcs as lines.

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Refined_faces.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/types/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ios>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

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
it, with a group of faces for each patch, named `patch_1` and so on, of which those that are no
rectangles are also in the group `cut`; and an element `l` for each arc, with all its points, in the
group `arcs`.

\param os the stream
\param graph the layout
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
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

\return `false` if there is no layout, or if writing fails

\par Complexity
That of `refine_along_arcs()`, and linear in what is written.
*/
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_layout(std::ostream& os, const Motorcycle_graph<TriangleMesh>& graph,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  if(!graph)
    return false;
  const internal::Protect_exact_arithmetic protect;
  const auto points = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(internal::strip(np), CGAL::internal_np::vertex_point),
    CGAL::get_const_property_map(CGAL::vertex_point, graph.mesh()));
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  const internal::Layout_data& data = graph.data();
  const internal::Refined_faces faces(data.domain.mesh, data.race->curves(), data.layout);
  std::string text;
  for(std::size_t v = 0; v < faces.cells().number_of_vertices(); ++v) {
    const Point p =
      internal::point_at<Point>(graph.mesh(), points, graph.location(faces.point(v)));
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

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_IO_LAYOUT_H
