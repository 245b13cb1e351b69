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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_TEXT_BUILDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_TEXT_BUILDER_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh with its property maps to the text of an OBJ file: the steps of `write_OBJ()`.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/Distinct_uvs.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The text grows statement by statement.
class OBJ_text
{
public:
  void add_comment(const std::string& comment)
  {
    if(comment.empty())
      return;
    m_text += "# ";
    for(const char c : comment) {
      m_text += (c == '\r') ? ' ' : c;
      if(c == '\n')
        m_text += "# ";
    }
    m_text += '\n';
  }

  void begin(const char* keyword) { m_text += keyword; }
  void end() { m_text += '\n'; }

  // Throws unless `x` is finite.
  void add_number(double x)
  {
    m_text += ' ';
    append_number(x, m_text);
  }

  // `i` counts from 0
  void add_index(std::size_t i) { m_text += ' ' + std::to_string(i + 1); }
  void add_corner(std::size_t v, std::size_t vt)
  {
    add_index(v);
    m_text += '/' + std::to_string(vt + 1);
  }

  std::string take() { return std::move(m_text); }

private:
  std::string m_text;
};

// Numbers the vertices in their order.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
void add_points(const TriangleMesh& tmesh, VertexPointMap vpm, VertexIndexMap index, OBJ_text& text)
{
  std::size_t number_of_vertices = 0;
  for(const auto v : vertices(tmesh)) {
    put(index, v, number_of_vertices++);
    const auto& p = get(vpm, v);
    text.begin("v");
    text.add_number(CGAL::to_double(p.x()));
    text.add_number(CGAL::to_double(p.y()));
    text.add_number(CGAL::to_double(p.z()));
    text.end();
  }
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
void add_faces(const TriangleMesh& tmesh, HalfedgeUVMap uv_map, VertexIndexMap index,
               OBJ_text& text)
{
  Distinct_uvs distinct(vertices(tmesh).size());
  std::vector<std::size_t> vts;
  vts.reserve(3 * faces(tmesh).size());
  for(const auto f : faces(tmesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      const auto& uv = get(uv_map, h);
      vts.push_back(distinct.insert(get(index, target(h, tmesh)),
                                    { CGAL::to_double(uv.x()), CGAL::to_double(uv.y()) }));
    }

  for(const Distinct_uvs::UV& uv : distinct.uvs()) {
    text.begin("vt");
    text.add_number(uv[0]);
    text.add_number(uv[1]);
    text.end();
  }
  auto vt = vts.begin();
  for(const auto f : faces(tmesh)) {
    text.begin("f");
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh))
      text.add_corner(get(index, target(h, tmesh)), *vt++);
    text.end();
  }
}

// Throws `File_refusal` if a coordinate is not finite.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
std::string build_OBJ_text(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                           const std::string& comments, const NamedParameters& np)
{
  CGAL_precondition(CGAL::is_triangle_mesh(tmesh));

  auto vpm = CGAL::parameters::choose_parameter(
               CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
               CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);

  OBJ_text text;
  text.add_comment(comments);
  add_points(tmesh, vpm, index, text);
  add_faces(tmesh, uv_map, index, text);
  if constexpr(is_given<NamedParameters, CGAL::internal_np::edge_is_constrained_t>) {
    auto eicm = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(const auto e : edges(tmesh))
      if(get(eicm, e)) {
        text.begin("l");
        text.add_index(get(index, source(e, tmesh)));
        text.add_index(get(index, target(e, tmesh)));
        text.end();
      }
  }
  return text.take();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_OBJ_TEXT_BUILDER_H
