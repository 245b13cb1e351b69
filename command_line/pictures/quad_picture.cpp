#include "quad_picture.h"

#include "surface_picture.h"

#include <algorithm>
#include <string>
#include <vector>

namespace {

// Vertices on features are left alone: which valence is regular there depends on their angles.
bool is_irregular(const Mesh& quads, const Edge_bool_map& is_feature, const Mesh::Vertex_index v)
{
  for(const Halfedge h : quads.halfedges_around_target(quads.halfedge(v)))
    if(is_feature[quads.edge(h)])
      return false;
  return quads.degree(v) != (quads.is_border(v) ? 3 : 4);
}

} // namespace

std::string quad_picture(const Mesh& quads, const Edge_bool_map& is_feature)
{
  constexpr Surface_picture::Color color = {{214, 228, 240}};
  const auto is_bold = [&](const Edge e) { return is_feature[e] || quads.is_border(e); };
  double width = 0;
  const auto lines = [&](const double scale) {
    width = (std::min)(0.8, 0.08 * scale * edge_length(quads));
    return std::vector<Line_style>{
      {[&](const Edge e) { return !is_bold(e); }, width, "#456"}, {is_bold, 2.5 * width, "#000"}};
  };
  Surface_picture picture(quads, [&](Mesh::Face_index) { return color; }, lines);
  picture.add_vertices([&](const auto v) { return is_irregular(quads, is_feature, v); },
                       4 * width, "#d55e00");
  return picture.svg();
}
