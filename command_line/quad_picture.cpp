#include "quad_picture.h"

#include "surface_picture.h"

#include <algorithm>
#include <string>

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
  Surface_picture picture(quads, [&](Mesh::Face_index) { return color; });
  const double width = (std::min)(0.8, 0.08 * picture.edge_length());
  const auto is_bold = [&](const Edge e) { return is_feature[e] || quads.is_border(e); };
  picture.add_edges([&](const Edge e) { return !is_bold(e); }, width, "#456");
  picture.add_edges(is_bold, 2.5 * width, "#000");
  picture.add_vertices([&](const auto v) { return is_irregular(quads, is_feature, v); },
                       4 * width, "#d55e00");
  return picture.svg();
}
