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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_MESH_TEXT_H
#define CGAL_SEAMLESS_SNAPPING_IO_MESH_TEXT_H

#include <CGAL/license/Seamless_snapping.h>

// The text of a file with coordinates per corner: read once, and written again with other
// coordinates and all else as it is.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_rewriter.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_rewriter.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

template <typename Soup, typename TriangleMesh, typename EdgeMap, typename NumberOf>
bool has_features_of(const Soup& soup, const TriangleMesh& tmesh, const EdgeMap& is_feature,
                     const NumberOf& number)
{
  std::set<std::pair<std::size_t, std::size_t> > features, segments;
  for(const auto e : edges(tmesh))
    if(get(is_feature, e))
      features.insert(std::minmax({number(source(e, tmesh)), number(target(e, tmesh))}));
  for(const auto& segment : soup.segments)
    segments.insert(std::minmax({segment.vertices[0], segment.vertices[1]}));
  return features == segments;
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

The text of a file with coordinates per corner, in the format OBJ or PLY, for programs that read a
mesh, change its coordinates, and write the file again. The text is parsed once, while `read_OBJ()`
and `rewrite_OBJ()` parse the file twice. The class also knows the number of each vertex in the
file, and can compare a text with a mesh.
*/
class Mesh_text
{
  using Soup = internal::Corner_soup<double, double>;

public:
  Mesh_text() = default; ///< creates an empty text

  /// takes a text in the format `"obj"` or `"ply"`; by default, the text tells its format.
  explicit Mesh_text(std::string text, const std::string& format = std::string())
    : m_text(std::move(text)),
      m_is_ply(format == "ply" || (format != "obj" && m_text.compare(0, 3, "ply") == 0))
  { }

  /// returns the text as it was given.
  const std::string& text() const & { return m_text; }
  std::string text() && { return std::move(m_text); } ///< returns the text without a copy.

  /// returns the format: `"obj"` or `"ply"`.
  std::string format() const { return m_is_ply ? "ply" : "obj"; }

  /*!
  reads the mesh and adds it to `tmesh`, as `read_OBJ()` and `read_PLY()` do. Parameters, named
  parameters, and return value are as for `read_OBJ()`.

  \tparam UVNumber the type that coordinates are rounded to: `double`, or `float` to read the
          numbers of programs that store `float`s

  \par Complexity
  The complexity of `read_OBJ()`.
  */
  template <typename UVNumber = double, typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  File_status read(TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                   const NamedParameters& np = CGAL::parameters::default_values())
  {
    const auto& plain_np = internal::strip(np, internal::file_parameters);
    m_is_welded = internal::chosen(plain_np, CGAL::internal_np::weld_borders, false);
    return internal::status_of_reading([&] {
      const internal::Vertex_changes changes =
        m_is_ply ? build<internal::PLY_parser<double, UVNumber> >(tmesh, uv_map, plain_np)
                 : build<internal::OBJ_parser<double, UVNumber> >(tmesh, uv_map, plain_np);
      m_vertex_numbers = changes.file_vertices;
      return changes;
    });
  }

  /// returns for each vertex that `read()` added the number of its point in the text, from 0.
  const std::vector<std::size_t>& vertex_numbers() const { return m_vertex_numbers; }

  /*!
  writes the text with other coordinates to `result`, as `rewrite_OBJ()` and `rewrite_PLY()` do. If
  `read()` joined vertices, the faces share them.

  \param result receives the new text
  \param tmesh the mesh that `read()` made from an empty mesh
  \param uv_map the coordinates of each corner
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
         of `rewrite_OBJ()`

  \return the status, as for `rewrite_OBJ()`

  \par Complexity
  Linear in the size of the text, as long as each vertex has few different coordinates.
  */
  template <typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  File_status rewrite(std::string& result, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    const auto points = internal::chosen(internal::strip(np, internal::file_parameters),
                                         CGAL::internal_np::vertex_point,
                                         CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
    return internal::status_of_writing([&] {
      result = m_is_ply
        ? rewritten<internal::PLY_parser, internal::PLY_rewriter>(tmesh, uv_map, points)
        : rewritten<internal::OBJ_parser, internal::OBJ_rewriter>(tmesh, uv_map, points);
    });
  }

  /*!
  calls `function(words)` for each statement of a text in the format OBJ, in order. It gives access
  to statements that `read()` skips, such as groups and materials. `words` is a
  `std::vector<std::string>` that starts with the keyword.

  \par Complexity
  Linear in the size of the text.
  */
  template <typename Function>
  void for_each_statement(const Function& function) const
  {
    internal::OBJ_scanner scanner(m_text);
    for(auto word = scanner.next_statement(); !word.empty(); word = scanner.next_statement()) {
      std::vector<std::string> words;
      for(; !word.empty(); word = scanner.next_token())
        words.emplace_back(word);
      function(words);
    }
  }

  /*!
  returns whether the text has exactly the faces of a mesh, in its order, with the same vertices,
  points, and coordinates, bit for bit. If `edge_is_constrained_map` is given, the features must be
  the same, too.

  \tparam UVNumber as for `read()`

  \param tmesh the mesh
  \param uv_map the coordinates of each corner
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
         and `edge_is_constrained_map` of `write_OBJ()`, and `vertex_index_map`, which tells the
         number of each vertex in the text, from 0

  \par Complexity
  Linear in the size of the text, and \f$ O(n \log n) \f$ in the number of features.
  */
  template <typename UVNumber = double, typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool holds(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
             const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    const auto& plain_np = internal::strip(np, internal::file_parameters);
    try {
      return m_is_ply ? is_same(internal::PLY_parser<double, UVNumber>(m_text).parse(), tmesh,
                                uv_map, plain_np)
                      : is_same(internal::OBJ_parser<double, UVNumber>(m_text).parse(), tmesh,
                                uv_map, plain_np);
    } catch(const internal::File_refusal&) {
      return false;
    }
  }

private:
  // Keeps what was parsed, with vertices as in the file but for those that were welded.
  template <typename Parser, typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters>
  internal::Vertex_changes build(TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                 const NamedParameters& np)
  {
    m_soup.reset();
    m_vertex_numbers.clear();
    auto soup = Parser(m_text).parse();
    const std::size_t n = soup.points.size();
    const internal::Vertex_changes changes = internal::build_mesh(soup, tmesh, uv_map, np);
    if constexpr(std::is_same_v<decltype(soup), Soup>) {
      const auto first_copy = changes.file_vertices.end() - std::ptrdiff_t(soup.points.size() - n);
      for(auto& triangle : soup.triangles)
        for(internal::Soup_index& v : triangle.vertices)
          if(v >= n)
            v = internal::Soup_index(first_copy[std::ptrdiff_t(v - n)]);
      m_soup = std::move(soup);
    }
    return changes;
  }

  template <template <typename, typename> class Parser, template <typename> class Rewriter,
            typename TriangleMesh, typename HalfedgeUVMap, typename VertexPointMap>
  std::string rewritten(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                        const VertexPointMap& points) const
  {
    if(!m_soup)
      return internal::rewritten_text<Parser, Rewriter>(
        m_text, tmesh, uv_map,
        internal::strip(parameters::weld_borders(m_is_welded).vertex_point_map(points)));
    return internal::rewritten_text<Rewriter>(m_text, *m_soup, tmesh, uv_map, points);
  }

  template <typename ParsedSoup, typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters>
  static bool is_same(const ParsedSoup& soup, const TriangleMesh& tmesh,
                      const HalfedgeUVMap& uv_map, const NamedParameters& np)
  {
    using CGAL::parameters::get_parameter;
    const auto points = internal::chosen(np, CGAL::internal_np::vertex_point,
                                         CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
    const auto numbers = CGAL::get_initialized_vertex_index_map(tmesh, np);
    const auto number = [&](const auto v) { return static_cast<std::size_t>(get(numbers, v)); };
    using Point = typename boost::property_traits<std::decay_t<decltype(points)> >::value_type;
    if(!internal::has_faces_of(soup, tmesh, [&](const auto& triangle, const auto i, const auto h) {
         const auto& p = soup.points[triangle.vertices[i]];
         const auto& uv = soup.uvs[triangle.uvs[i]];
         const auto& of_mesh = get(uv_map, h);
         return triangle.vertices[i] == number(target(h, tmesh)) &&
                get(points, target(h, tmesh)) == Point(p[0], p[1], p[2]) &&
                internal::is_same_number(uv[0], of_mesh.x()) &&
                internal::is_same_number(uv[1], of_mesh.y());
       }))
      return false;
    const auto features = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    if constexpr(internal::is_given<decltype(features)>)
      return internal::has_features_of(soup, tmesh, features, number);
    return true;
  }

  std::string m_text;
  bool m_is_ply = false;
  bool m_is_welded = false;
  std::optional<Soup> m_soup; // the soup of the last `read()`, unless it read floats
  std::vector<std::size_t> m_vertex_numbers;
};

} // namespace IO

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_MESH_TEXT_H
