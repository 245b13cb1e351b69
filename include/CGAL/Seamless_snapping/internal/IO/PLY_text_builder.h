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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_TEXT_BUILDER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_TEXT_BUILDER_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh with its property maps to the text of a binary PLY file: the steps of `write_PLY()`.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_values.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The body grows value by value.
class PLY_text
{
public:
  // Throws unless `x` is finite.
  void add_number(const double x)
  {
    if(!std::isfinite(x))
      throw File_refusal(0, "a coordinate is not finite; nothing is written");
    append_bytes(x, PLY_format::LITTLE_ENDIAN_BYTES, m_text);
  }

  void add_index(const std::size_t i)
  {
    append_bytes(static_cast<std::int32_t>(i), PLY_format::LITTLE_ENDIAN_BYTES, m_text);
  }

  void add_length(const int length) { m_text += static_cast<char>(length); }

  std::string take() { return std::move(m_text); }

private:
  std::string m_text;
};

inline std::string PLY_head(const std::string& comments, const std::size_t vertices,
                            const std::size_t faces, const std::size_t edges)
{
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for(std::size_t begin = 0; begin < comments.size(); ) {
    const std::size_t end = (std::min)(comments.find_first_of("\r\n", begin), comments.size());
    text += "comment " + comments.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  text += "element vertex " + std::to_string(vertices)
          + "\nproperty double x\nproperty double y\nproperty double z\nelement face "
          + std::to_string(faces)
          + "\nproperty list uchar int vertex_indices\nproperty list uchar double texcoord\n";
  if(edges > 0)
    text += "element edge " + std::to_string(edges)
            + "\nproperty int vertex1\nproperty int vertex2\n";
  return text + "end_header\n";
}

// Throws `File_refusal` if a coordinate is not finite, or the mesh is too large for the format.
template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
std::string build_PLY_text(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                           const std::string& comments, const NamedParameters& np)
{
  CGAL_precondition(CGAL::is_triangle_mesh(tmesh));
  auto vpm = CGAL::parameters::choose_parameter(
               CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
               CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);

  PLY_text body;
  std::size_t number_of_vertices = 0, number_of_edges = 0;
  for(const auto v : vertices(tmesh)) {
    put(index, v, number_of_vertices++);
    const auto& p = get(vpm, v);
    for(const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())})
      body.add_number(x);
  }
  if(number_of_vertices > std::size_t((std::numeric_limits<std::int32_t>::max)()))
    throw File_refusal(0, "the mesh has too many vertices for the PLY format; nothing is written");
  for(const auto f : faces(tmesh)) {
    const auto around = CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh);
    body.add_length(3);
    for(const auto h : around)
      body.add_index(get(index, target(h, tmesh)));
    body.add_length(6);
    for(const auto h : around) {
      const auto& uv = get(uv_map, h);
      body.add_number(CGAL::to_double(uv.x()));
      body.add_number(CGAL::to_double(uv.y()));
    }
  }
  if constexpr(is_given<NamedParameters, CGAL::internal_np::edge_is_constrained_t>) {
    auto eicm = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(const auto e : edges(tmesh))
      if(get(eicm, e)) {
        ++number_of_edges;
        body.add_index(get(index, source(e, tmesh)));
        body.add_index(get(index, target(e, tmesh)));
      }
  }
  return PLY_head(comments, number_of_vertices, faces(tmesh).size(), number_of_edges) + body.take();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_TEXT_BUILDER_H
