// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_WRITER_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_WRITER_H

#include <CGAL/license/Quad_remeshing.h>

// From the caller's mesh and maps to the surface that is remeshed, and from the quads to the
// caller's mesh and maps.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Barycentric coordinates of the projection to the plane of the triangle, cut off at 0. In a
// triangle without area, the coordinates on its longest side.
inline std::array<double, 3> barycentric_coordinates(
  std::array<std::array<double, 3>, 3> triangle, std::array<double, 3> point)
{
  std::array<double, 3> result{};
  double size = 0;
  for(const auto& p : triangle)
    for(const double x : p)
      size = (std::max)(size, std::abs(x));
  // so that products neither overflow nor vanish
  const int exponent = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
  for(auto* const p : {&triangle[0], &triangle[1], &triangle[2], &point})
    for(double& x : *p)
      x = std::ldexp(x, -exponent);
  const auto dot = [&](const std::size_t i, const std::size_t j, const std::array<double, 3>& p) {
    double sum = 0; // side from i to j, and from i to p
    for(std::size_t c = 0; c < 3; ++c)
      sum += (triangle[j][c] - triangle[i][c]) * (p[c] - triangle[i][c]);
    return sum;
  };
  const double a = dot(0, 1, triangle[1]), b = dot(0, 1, triangle[2]), c = dot(0, 2, triangle[2]);
  const double d = dot(0, 1, point), e = dot(0, 2, point);
  const double det = a * c - b * b;
  if(det > 1e-14 * a * c) {
    result[1] = (std::max)(0., (c * d - b * e) / det);
    result[2] = (std::max)(0., (a * e - b * d) / det);
    result[0] = (std::max)(0., 1 - result[1] - result[2]);
  } else {
    std::size_t i = 0, j = 1;
    for(const auto& [k, l] : {std::pair<std::size_t, std::size_t>(1, 2), {2, 0}})
      if(dot(k, l, triangle[l]) > dot(i, j, triangle[j])) {
        i = k;
        j = l;
      }
    const double length = dot(i, j, triangle[j]);
    result[j] = length > 0 ? (std::min)((std::max)(dot(i, j, point) / length, 0.), 1.) : 0;
    result[i] = 1 - result[j];
  }
  const double sum = result[0] + result[1] + result[2];
  for(double& x : result)
    x /= sum;
  return result;
}

// In the order of `CGAL::Polygon_mesh_processing::Face_location`.
template <typename TriangleMesh, typename VertexPointMap, typename Point>
std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3> >
locate_in_face(const Point& point,
               const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
               const TriangleMesh& tmesh, const VertexPointMap& point_map)
{
  const auto h = halfedge(f, tmesh);
  return {f, barycentric_coordinates({place_of(get(point_map, source(h, tmesh))),
                                      place_of(get(point_map, target(h, tmesh))),
                                      place_of(get(point_map, target(next(h, tmesh), tmesh)))},
                                     place_of(point))};
}

// Copies a mesh, with what the named parameters tell of its elements.
template <typename TriangleMesh, typename NamedParameters>
Marked_surface read_surface(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  Marked_surface surface;
  Marked_surface::Mesh& copy = surface.mesh;
  std::vector<std::pair<Halfedge, Marked_surface::Halfedge> > copies;
  CGAL::copy_face_graph(
    tmesh, copy,
    CGAL::parameters::vertex_point_map(
      chosen(np, CGAL::internal_np::vertex_point,
             CGAL::get_const_property_map(CGAL::vertex_point, tmesh)))
      .halfedge_to_halfedge_output_iterator(std::back_inserter(copies)));
  const auto feature_map =
    CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
  const auto direction_map = CGAL::parameters::get_parameter(np, internal_np::face_direction);
  const auto size_map = CGAL::parameters::get_parameter(np, internal_np::vertex_sizing);
  std::shared_ptr<std::vector<Marked_surface::Vector> > directions;
  for(const auto& [original, h] : copies) {
    if constexpr(is_given<decltype(feature_map)>)
      surface.is_feature[copy.edge(h)] = bool(get(feature_map, edge(original, tmesh)));
    if constexpr(is_given<decltype(direction_map)>)
      if(!copy.is_border(h) && copy.halfedge(copy.face(h)) == h) {
        const Place d = place_of(get(direction_map, face(original, tmesh)));
        if(!directions && d != Place{0, 0, 0})
          directions = std::make_shared<std::vector<Marked_surface::Vector> >(
            copy.number_of_faces(), Marked_surface::Vector(0, 0, 0));
        if(directions)
          (*directions)[std::size_t(copy.face(h))] = {d[0], d[1], d[2]};
      }
    if constexpr(is_given<decltype(size_map)>)
      surface.sizes[copy.target(h)] = CGAL::to_double(get(size_map, target(original, tmesh)));
  }
  surface.directions = std::move(directions);
  return surface;
}

// Which elements of quads are to be located on the input.
struct Located_elements
{
  bool vertices, faces;
};

// Per element of quads, the number of the nearest face of the input; for faces, to their middles.
// None where they are not to be located.
struct Nearest_faces
{
  std::vector<std::size_t> of_vertices, of_faces;
};

inline Remeshing_types::Point middle(const Remeshing_types::Mesh& quads,
                                       const Remeshing_types::Face f)
{
  Remeshing_types::Kernel::Vector_3 sum(0, 0, 0);
  for(const auto v : quads.vertices_around_face(quads.halfedge(f)))
    sum = sum + (quads.point(v) - CGAL::ORIGIN) / 4;
  return CGAL::ORIGIN + sum;
}

template <typename QuadMesh, typename NamedParameters>
auto point_map_of_quads(QuadMesh& quads, const NamedParameters& np)
{
  return chosen(np, CGAL::internal_np::vertex_point,
                CGAL::get_property_map(CGAL::vertex_point, quads));
}

// Writes the result to the caller's mesh and maps.
template <typename TriangleMesh, typename QuadMesh, typename NamedParameters1,
          typename NamedParameters2>
class Quad_writer
{
  using Mesh = Remeshing_types::Mesh;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  Quad_writer(const TriangleMesh& tmesh, const NamedParameters1& np1, const NamedParameters2& np2)
    : m_tmesh(tmesh), m_np1(np1), m_np2(np2)
  { }

  Located_elements located() const
  {
    return {is_given<decltype(parameter(internal_np::vertex_location))>,
            is_given<decltype(parameter(internal_np::face_location))>};
  }

  void write(const Mesh& result, const Remeshing_types::Feature_map& is_feature,
             const Nearest_faces& nearest, QuadMesh& quads) const
  {
    const auto vertex_map = parameter(internal_np::vertex_location);
    const auto face_map = parameter(internal_np::face_location);
    const auto feature_map = parameter(CGAL::internal_np::edge_is_constrained);
    using Traits = boost::graph_traits<QuadMesh>;
    std::vector<Face> faces_of_input; // which the quads may join, in any place
    if constexpr(is_given<decltype(vertex_map)> || is_given<decltype(face_map)>)
      faces_of_input.assign(CGAL::faces(m_tmesh).begin(), CGAL::faces(m_tmesh).end());
    std::vector<std::pair<Mesh::Vertex_index, typename Traits::vertex_descriptor> > vertices;
    std::vector<std::pair<Mesh::Halfedge_index, typename Traits::halfedge_descriptor> > halfedges;
    std::vector<std::pair<Mesh::Face_index, typename Traits::face_descriptor> > faces;
    CGAL::copy_face_graph(
      result, quads,
      CGAL::parameters::halfedge_to_halfedge_output_iterator(std::back_inserter(halfedges))
                       .vertex_to_vertex_output_iterator(std::back_inserter(vertices))
                       .face_to_face_output_iterator(std::back_inserter(faces)),
      CGAL::parameters::vertex_point_map(point_map_of_quads(quads, m_np2)));
    if constexpr(is_given<decltype(vertex_map)> || is_given<decltype(face_map)>) {
      const auto locate = [&](const auto& point, const std::size_t number)
        { return locate_in_face(point, faces_of_input[number], m_tmesh, point_map_of_input()); };
      if constexpr(is_given<decltype(vertex_map)>)
        for(const auto& [v, copy] : vertices)
          put(vertex_map, copy, locate(result.point(v), nearest.of_vertices[v]));
      if constexpr(is_given<decltype(face_map)>)
        for(const auto& [f, copy] : faces)
          put(face_map, copy, locate(middle(result, f), nearest.of_faces[f]));
    }
    if constexpr(is_given<decltype(feature_map)>)
      for(const auto& [h, copy] : halfedges)
        put(feature_map, edge(copy, quads), bool(is_feature[result.edge(h)]));
  }

private:
  template <typename Tag_type>
  auto parameter(const Tag_type tag) const
  { return CGAL::parameters::get_parameter(m_np2, tag); }

  auto point_map_of_input() const
  {
    return chosen(m_np1, CGAL::internal_np::vertex_point,
                  CGAL::get_const_property_map(CGAL::vertex_point, m_tmesh));
  }

  const TriangleMesh& m_tmesh;
  const NamedParameters1& m_np1;
  const NamedParameters2& m_np2;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_WRITER_H
