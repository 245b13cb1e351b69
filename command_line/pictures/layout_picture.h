// A picture of a layout on the surface: each patch in a color unlike that of its neighbors, and the
// arcs.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H

#include "../Model.h"
#include "surface_picture.h"

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

using Layout_graph = CGAL::Isocurves_and_layouts::Motorcycle_graph<Mesh>;

// For each patch one of `n` colors: the first one that no neighbor has, as long as there is one.
inline std::vector<std::size_t> patch_colors(const Layout_graph& graph, const std::size_t n)
{
  std::vector<std::size_t> result(graph.number_of_patches(), n);
  for(std::size_t p = 0; p < result.size(); ++p) {
    std::set<std::size_t> taken;
    for(const auto& cycle : graph.patch_cycles(p))
      for(const std::size_t h : cycle) {
        const std::size_t q = graph.patch(graph.opposite(h));
        if(q != graph.null_patch)
          taken.insert(result[q]);
      }
    std::size_t color = 0;
    while(taken.count(color) != 0 && color + 1 < n)
      ++color;
    result[p] = color;
  }
  return result;
}

// As SVG.
inline std::string layout_picture(const Layout_graph& graph)
{
  namespace IL = CGAL::Isocurves_and_layouts;
  static constexpr std::array<Surface_picture::Color, 6> colors = {{
    {{158, 202, 225}}, {{253, 208, 162}}, {{161, 217, 155}}, {{252, 187, 161}},
    {{202, 189, 220}}, {{225, 222, 150}}}};
  Mesh mesh; // refined along the arcs
  const auto patches = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  const auto is_arc = mesh.add_property_map<Edge, bool>("e:arc").first;
  IL::refine_along_arcs(graph, mesh, IL::parameters::default_values(),
                        IL::parameters::face_patch_map(patches).edge_is_constrained_map(is_arc));
  const std::vector<std::size_t> color = patch_colors(graph, colors.size());
  const Surface_picture picture(
    mesh, [&](const auto f) { return colors[color[patches[f]]]; },
    [&](double) {
      return std::vector<Line_style>{{[&](const Edge e) { return is_arc[e]; }, 1.6, "#222"}};
    });
  return picture.svg();
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H
