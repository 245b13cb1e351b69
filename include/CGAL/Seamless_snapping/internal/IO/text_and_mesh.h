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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// From the text of a file to a mesh, and from the mesh to a text with its coordinates, in any
// format.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/Mesh_builder.h>
#include <CGAL/Seamless_snapping/internal/IO/Soup_edges.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/internal/IO/weld_soup.h>
#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Whether the faces of the soup are those of the mesh, in the same order: vertex i of a triangle is
// the target of a halfedge h with `is_same(triangle, i, h)`.
template <typename Soup, typename TriangleMesh, typename IsSame>
bool has_faces_of(const Soup& soup, const TriangleMesh& tmesh, const IsSame& is_same)
{
  if(faces(tmesh).size() != soup.triangles.size())
    return false;
  auto triangle = soup.triangles.begin();
  for(const auto face : faces(tmesh)) {
    auto h = halfedge(face, tmesh);
    for(std::size_t i = 0; i < 3; ++i, h = next(h, tmesh))
      if(!is_same(*triangle, i, h))
        return false;
    if(h != halfedge(face, tmesh))
      return false;
    ++triangle;
  }
  return true;
}

// Calls `f()` with the coordinates of each corner. Throws unless the faces have the same points in
// the file and in the mesh: else coordinates would go to corners that they do not belong to.
template <typename Soup, typename TriangleMesh, typename HalfedgeUVMap, typename VertexPointMap,
          typename Function>
void for_each_uv_of_mesh(const Soup& soup, const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                         const VertexPointMap& vpm, const Function& f)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  if(!has_faces_of(soup, tmesh, [&](const auto& triangle, const std::size_t i, const auto h) {
       const auto& p = soup.points[triangle.vertices[i]];
       const Point& q = get(vpm, target(h, tmesh));
       const auto& uv = get(uv_map, h);
       f(std::array<double, 2>{CGAL::to_double(uv.x()), CGAL::to_double(uv.y())});
       return q.x() == FT(p[0]) && q.y() == FT(p[1]) && q.z() == FT(p[2]);
     }))
    throw File_refusal(0, "the faces of the mesh are not those of the file");
}

// Throws `File_refusal`.
template <template <typename, typename> class Parser, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters>
Vertex_changes read_text(const std::string_view text, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                         const NamedParameters& np)
{
  using VPM = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::type;
  auto soup = Parser<File_number<VPM>, File_number<HalfedgeUVMap> >(text).parse();
  return build_mesh(soup, tmesh, uv_map, np);
}

// The text of a file with the coordinates of the mesh that was read from it. Throws `File_refusal`.
template <template <typename> class Rewriter, typename Soup, typename TriangleMesh,
          typename HalfedgeUVMap, typename VertexPointMap>
std::string rewritten_text(const std::string_view text, const Soup& soup, const TriangleMesh& tmesh,
                           const HalfedgeUVMap& uv_map, const VertexPointMap& vpm)
{
  return Rewriter<Soup>(text, soup, [&](const auto& f) {
    for_each_uv_of_mesh(soup, tmesh, uv_map, vpm, f);
  }).rewrite();
}

// The same where only the text is known.
template <template <typename, typename> class Parser, template <typename> class Rewriter,
          typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
std::string rewritten_text(const std::string_view text, const TriangleMesh& tmesh,
                           const HalfedgeUVMap& uv_map, const NamedParameters& np)
{
  using VPM = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  const VPM vpm = chosen(np, CGAL::internal_np::vertex_point,
                         CGAL::get_const_property_map(CGAL::vertex_point, tmesh));

  auto soup = Parser<File_number<VPM>, double>(text).parse();
  if(chosen(np, CGAL::internal_np::weld_borders, false)) {
    const Soup_edges edges(soup.triangles);
    const Coinciding_sides coinciding = find_coinciding_sides(soup, edges.border_sides());
    replace_vertices(welded_vertices(soup, coinciding.seams), soup);
  }
  return rewritten_text<Rewriter>(text, soup, tmesh, uv_map, vpm);
}

// From a stream, or the file of a name.
template <template <typename, typename> class Parser, typename Source, typename TriangleMesh,
          typename HalfedgeUVMap, typename NamedParameters>
IO::File_status read_mesh(Source& source, TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                          const NamedParameters& np)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return status_of_reading([&] { return read_text<Parser>(text_of(source), tmesh, uv_map,
                                                            strip(np)); });
}

// To a stream, or the file of a name; that is emptied when `text()` has returned the whole text.
template <typename Target, typename Text>
IO::File_status write_mesh(Target& target, const Text& text)
{
  return status_of_writing([&] { write_text(target, text()); });
}

// From the one to the other.
template <template <typename, typename> class Parser, template <typename> class Rewriter,
          typename Source, typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters>
IO::File_status rewrite_mesh(Source& source, Target& target, const TriangleMesh& tmesh,
                             const HalfedgeUVMap& uv_map, const NamedParameters& np)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return write_mesh(target, [&] { return rewritten_text<Parser, Rewriter>(text_of(source), tmesh,
                                                                            uv_map, strip(np)); });
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_TEXT_AND_MESH_H
