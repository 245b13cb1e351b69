// The text of a file with coordinates per corner: read once, and written again with other
// coordinates and all else as it is, byte for byte.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_MESH_TEXT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_MESH_TEXT_H

#include "OBJ_rewriter.h"
#include "PLY_rewriter.h"
#include "Text_copy.h"
#include "parsers_of_library.h"
#include "maps/surface_types.h"

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace formats {

// The number of each vertex in a text, from 0. If the list is empty, it is the vertex's index.
using Vertex_numbers = std::vector<std::size_t>;

class Mesh_text
{
public:
  Mesh_text() = default;

  // Takes a text in the format "obj" or "ply"; by default, the text tells its format.
  explicit Mesh_text(std::string text, const std::string& format = std::string())
    : m_text(std::move(text)),
      m_is_ply(format == "ply" || (format != "obj" && m_text.compare(0, 3, "ply") == 0))
  { }

  const std::string& text() const & { return m_text; }
  std::string text() && { return std::move(m_text); } // without a copy
  std::string format() const { return m_is_ply ? "ply" : "obj"; }

  // Reads the mesh as `read_OBJ()` and `read_PLY()` do.
  // \tparam UVNumber the type that coordinates are rounded to: `double`, or `float` to read the
  //         numbers of programs that store `float`s
  // \param mesh an empty mesh
  template <typename UVNumber = double>
  File_status read(Mesh& mesh, const Uv_map& uv_map, const Edge_bool_map& is_feature,
                   const bool weld)
  {
    const auto np =
      CGAL::Seamless_snapping::parameters::edge_is_constrained_map(is_feature).weld_borders(weld);
    return status_of_reading([&] {
      const auto& plain_np = strip(np, file_parameters);
      const Vertex_changes changes = m_is_ply
                                       ? build<PLY_parser, UVNumber>(mesh, uv_map, plain_np)
                                       : build<OBJ_parser, UVNumber>(mesh, uv_map, plain_np);
      m_is_welded = changes.number_of_welded_edges > 0;
      m_vertex_numbers = changes.file_vertices;
      return changes;
    });
  }

  // For each vertex that `read()` added.
  const Vertex_numbers& vertex_numbers() const { return m_vertex_numbers; }

  // Writes the text with other coordinates to `result`. If `read()` joined vertices, the faces share
  // them. Refuses a mesh with other faces than `read()` made, because coordinates would go to corners
  // that they do not belong to.
  File_status rewrite(std::string& result, const Mesh& mesh, const Uv_map& uv_map) const
  {
    return status_of_writing([&] {
      std::vector<UV> uvs;
      uvs.reserve(3 * m_soup.triangles.size());
      if(!has_faces_of(m_soup, mesh, [&](const Soup::Triangle& triangle, const std::size_t i,
                                         const Halfedge h) {
           const auto& p = m_soup.points[triangle.vertices[i]];
           uvs.push_back({uv_map[h].x(), uv_map[h].y()});
           return mesh.point(mesh.target(h)) == Kernel::Point_3(p[0], p[1], p[2]);
         }))
        throw File_refusal(0, "the mesh has other faces than the file");
      result = m_is_ply ? PLY_rewriter(m_text, m_soup, uvs).rewrite()
                        : OBJ_rewriter(m_text, m_soup, uvs).rewrite(m_is_welded);
    });
  }

  // Calls `function(words)` for each statement of a text in the format OBJ, also for statements that
  // `read()` skips, such as groups and materials. `words` are strings; the first is the keyword.
  template <typename Function>
  void for_each_statement(const Function& function) const
  {
    OBJ_scanner scanner(m_text);
    for(auto word = scanner.next_statement(); !word.empty(); word = scanner.next_statement()) {
      std::vector<std::string> words;
      for(; !word.empty(); word = scanner.next_token())
        words.emplace_back(word);
      function(words);
    }
  }

  // Whether the text has exactly the faces of a mesh, in its order, with the same vertices, points,
  // coordinates, and features, bit for bit.
  // \tparam UVNumber as for `read()`
  template <typename UVNumber = double>
  bool holds(const Mesh& mesh, const Uv_map& uv_map, const Edge_bool_map& is_feature,
             const Vertex_numbers& numbers) const
  {
    try {
      return m_is_ply ? is_same(PLY_parser<double, UVNumber>(m_text).parse(), mesh, uv_map,
                                is_feature, numbers)
                      : is_same(OBJ_parser<double, UVNumber>(m_text).parse(), mesh, uv_map,
                                is_feature, numbers);
    } catch(const File_refusal&) {
      return false;
    }
  }

private:
  // Keeps what was parsed, with vertices as in the file but for those that were welded.
  template <template <typename, typename> class Parser, typename UVNumber,
            typename NamedParameters>
  Vertex_changes build(Mesh& mesh, const Uv_map& uv_map, const NamedParameters& np)
  {
    m_soup = Soup();
    m_vertex_numbers.clear();
    auto soup = Parser<double, UVNumber>(m_text).parse();
    const std::size_t n = soup.points.size();
    const Vertex_changes changes = build_mesh(soup, mesh, uv_map, np);
    const auto first_copy = changes.file_vertices.end() - std::ptrdiff_t(soup.points.size() - n);
    for(auto& triangle : soup.triangles)
      for(Soup_index& v : triangle.vertices)
        if(v >= n)
          v = Soup_index(first_copy[std::ptrdiff_t(v - n)]);
    if constexpr(std::is_same_v<UVNumber, double>) {
      m_soup = std::move(soup);
    } else {
      m_soup = Parser<double, double>(m_text).parse();
      for(std::size_t i = 0; i < soup.triangles.size(); ++i)
        m_soup.triangles[i].vertices = soup.triangles[i].vertices;
      m_soup.segments = soup.segments;
    }
    return changes;
  }

  // Whether the faces of the soup are those of the mesh, in the same order: vertex i of a triangle is
  // the target of a halfedge h with `is_same(triangle, i, h)`.
  template <typename AnySoup, typename IsSame>
  static bool has_faces_of(const AnySoup& soup, const Mesh& mesh, const IsSame& is_same)
  {
    if(mesh.number_of_faces() != soup.triangles.size())
      return false;
    auto triangle = soup.triangles.begin();
    for(const auto face : mesh.faces()) {
      Halfedge h = mesh.halfedge(face);
      for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
        if(!is_same(*triangle, i, h))
          return false;
      if(h != mesh.halfedge(face))
        return false;
      ++triangle;
    }
    return true;
  }

  template <typename AnySoup>
  static bool is_same(const AnySoup& soup, const Mesh& mesh, const Uv_map& uv_map,
                      const Edge_bool_map& is_feature, const Vertex_numbers& numbers)
  {
    const auto number = [&](const Mesh::Vertex_index v)
    { return numbers.empty() ? std::size_t(v) : numbers[std::size_t(v)]; };
    if(!has_faces_of(soup, mesh, [&](const auto& triangle, const std::size_t i, const Halfedge h) {
         const auto& p = soup.points[triangle.vertices[i]];
         const auto& uv = soup.uvs[triangle.uvs[i]];
         return triangle.vertices[i] == number(mesh.target(h)) &&
                mesh.point(mesh.target(h)) == Kernel::Point_3(p[0], p[1], p[2]) &&
                is_same_number(uv[0], uv_map[h].x()) && is_same_number(uv[1], uv_map[h].y());
       }))
      return false;
    std::set<std::pair<std::size_t, std::size_t> > features, segments;
    for(const Edge e : mesh.edges())
      if(is_feature[e])
        features.insert(std::minmax({number(mesh.vertex(e, 0)), number(mesh.vertex(e, 1))}));
    for(const auto& segment : soup.segments)
      segments.insert(std::minmax({segment.vertices[0], segment.vertices[1]}));
    return features == segments;
  }

  std::string m_text;
  bool m_is_ply = false;
  bool m_is_welded = false;
  Soup m_soup; // of the last `read()`
  Vertex_numbers m_vertex_numbers;
};

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_MESH_TEXT_H
