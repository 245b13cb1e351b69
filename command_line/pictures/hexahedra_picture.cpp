#include "hexahedra_picture.h"

#include "surface_picture.h"

#include <CGAL/Hexahedral_meshing/measure_hexahedra.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace Meshing = CGAL::Hexahedral_meshing;
using Color = Surface_picture::Color;

// Red for a scaled Jacobian of 0 or less, yellow in the middle, blue for 1.
Color color_of_shape(const double shape)
{
  constexpr std::array<Color, 3> colors = {{{{204, 51, 17}}, {{238, 221, 136}}, {{68, 119, 170}}}};
  const double x = 2 * (std::min)((std::max)(shape, 0.), 1.);
  const std::size_t i = x < 1 ? 0 : 1;
  Color result;
  for(std::size_t k = 0; k < 3; ++k)
    result[k] = int(colors[i][k] + (x - double(i)) * (colors[i + 1][k] - colors[i][k]));
  return result;
}

// Each quadrilateral is a face by itself; points of the part that is cut away are vertices, too, so
// that the picture has the view and the frame of the whole.
class Cut_mesh
{
public:
  explicit Cut_mesh(const Meshing::Hexahedral_mesh& hexahedra)
    : m_hexahedra(hexahedra)
  {
    for(const auto& q : hexahedra.quadrilaterals)
      for(const auto v : q)
        m_mesh.add_vertex(point(v));
    const Natural_view view(m_mesh);
    double nearest = -1e300, farthest = 1e300;
    for(const auto v : m_mesh.vertices()) {
      nearest = (std::max)(nearest, view.depth(m_mesh.point(v)));
      farthest = (std::min)(farthest, view.depth(m_mesh.point(v)));
    }
    for(std::size_t i = 0; i < hexahedra.hexahedra.size(); ++i) {
      double depth = 0;
      for(const auto v : hexahedra.hexahedra[i])
        depth += view.depth(point(v)) / 8;
      if(depth <= (nearest + farthest) / 2)
        add_hexahedron(i);
    }
    for(Quadrilateral q : hexahedra.quadrilaterals) {
      std::sort(q.begin(), q.end());
      m_boundary.push_back(q);
    }
    std::sort(m_boundary.begin(), m_boundary.end());
    for(const auto& [key, side] : m_sides)
      add_face(key, side.first, side.second);
  }

  const Mesh& mesh() const { return m_mesh; }
  Color color(const Mesh::Face_index f) const { return m_colors[std::size_t(f)]; }

private:
  using Quadrilateral = std::array<std::int32_t, 4>;

  Kernel::Point_3 point(const std::int32_t v) const
  {
    const auto& p = m_hexahedra.points[std::size_t(v)];
    return Kernel::Point_3(p[0], p[1], p[2]);
  }

  // Sides that two hexahedra have are inside.
  void add_hexahedron(const std::size_t i)
  {
    // counterclockwise as seen from outside
    constexpr std::size_t corners[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                           {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    for(const auto& side : corners) {
      Quadrilateral q;
      for(std::size_t k = 0; k < 4; ++k)
        q[k] = m_hexahedra.hexahedra[i][side[k]];
      Quadrilateral key = q;
      std::sort(key.begin(), key.end());
      if(const auto [place, is_new] = m_sides.emplace(key, std::make_pair(i, q)); !is_new)
        m_sides.erase(place);
    }
  }

  void add_face(const Quadrilateral& key, const std::size_t i, const Quadrilateral& q)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const auto v : q)
      vertices.push_back(m_mesh.add_vertex(point(v)));
    m_mesh.add_face(vertices);
    constexpr Color of_boundary = {{226, 230, 234}};
    const std::vector<std::array<std::int32_t, 8> > one{m_hexahedra.hexahedra[i]};
    m_colors.push_back(
      std::binary_search(m_boundary.begin(), m_boundary.end(), key)
        ? of_boundary
        : color_of_shape(Meshing::measure_hexahedra(m_hexahedra.points, one).least_scaled_jacobian));
  }

  const Meshing::Hexahedral_mesh& m_hexahedra;
  std::map<Quadrilateral, std::pair<std::size_t, Quadrilateral> > m_sides; // by sorted vertices
  std::vector<Quadrilateral> m_boundary; // sorted
  Mesh m_mesh;
  std::vector<Color> m_colors;
};

} // namespace

std::string hexahedra_picture(const Meshing::Hexahedral_mesh& hexahedra)
{
  const Cut_mesh cut(hexahedra);
  const auto lines = [&](const double scale) {
    const double width = (std::min)(0.8, 0.08 * scale * edge_length(cut.mesh()));
    return std::vector<Line_style>{{[](Edge) { return true; }, width, "#456"}};
  };
  return Surface_picture(cut.mesh(), [&](const Mesh::Face_index f) { return cut.color(f); },
                         lines).svg();
}
