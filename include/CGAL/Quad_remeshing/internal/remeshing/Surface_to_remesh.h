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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H

#include <CGAL/license/Quad_remeshing.h>

// The surface that quads are to cover, with its features and its map: a copy of the input, as some
// faces have to be divided first.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Mirror.h>
#include <CGAL/Quad_remeshing/internal/remeshing/divide_aligned_triangles.h>
#include <CGAL/Quad_remeshing/internal/remeshing/refine_surface.h>
#include <CGAL/Quad_remeshing/internal/remeshing/straighten_border.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: no triangle with an area has three sides that are features or border, which no map
// without flips aligns. Such ones are divided into nine, and their neighbors so that there are
// triangles only. The copy is the input times a power of two, of a size near 1, so that squares of
// lengths are neither too large nor too small. With a mirror, it is the half above.
class Surface_to_remesh
  : public Remeshing_types
{
public:
  using Uv_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
  using Rotation_map = Mesh::Property_map<Halfedge, int>;
  using Sizing_map = Marked_surface::Sizing_map;

  // \param input without originals, these are the faces themselves
  // \param mirror on whose upper side the surface is to be
  Surface_to_remesh(const Marked_surface& input, const std::optional<Mirror>& mirror)
    : m_surface(input)
  {
    scale();
    scale_sizes();
    if(m_surface.originals.empty())
      for(const Face f : m_mesh.faces())
        m_surface.originals.push_back(std::size_t(f));
    if(!CGAL::is_triangle_mesh(m_mesh))
      return;
    if(mirror)
      keep_half(m_mirror.emplace(mirror->scaled(-m_exponent)));
    Aligned_triangle_divider(m_surface).run();
  }

  Surface_to_remesh(const Surface_to_remesh&) = delete; // the maps belong to the mesh
  Surface_to_remesh& operator=(const Surface_to_remesh&) = delete;

  // Divides long triangles, and large ones unless these are to stay; returns whether there are any.
  bool refine(const bool has_large_faces)
  { return CGAL::is_triangle_mesh(m_mesh) && Surface_refiner(m_surface, has_large_faces).run(); }

  // Leaves out what is less than a tolerance of the border, in the size of the input, in the points
  // of which a map is to be made, as far as that spares corners. Is called once.
  void straighten_border(const double tolerance)
  {
    if(!(tolerance > 0) || !CGAL::is_triangle_mesh(m_mesh) ||
       !has_finite_points(m_mesh)) // refused later
      return;
    const auto points = m_mesh.add_property_map<Vertex, Point>("v:point_of_map").first;
    for(const Vertex v : m_mesh.vertices())
      points[v] = m_mesh.point(v);
    m_number_of_corners_left_out =
      Border_straightener(m_surface, scaled(tolerance), points)
        .run([&](const Vertex v) { return has_inner_feature(v) || is_on_mirror(v); });
    m_points_of_map = points;
  }

  std::size_t number_of_corners_left_out() const { return m_number_of_corners_left_out; }

  const Mesh& mesh() const { return m_mesh; }
  Border_straightener::Point_map points_of_map() const { return m_points_of_map; }
  Feature_map is_feature() const { return m_surface.is_feature; }
  Uv_map uv_map() const { return m_uv_map; }
  auto directions() const
  {
    return boost::make_function_property_map<Face>(
      [this](const Face f) { return m_surface.direction(f); });
  }
  Feature_map is_cut() const { return m_is_cut; }
  Rotation_map rotations() const { return m_rotations; }
  Sizing_map sizes() const { return m_surface.sizes; }

  bool has_sizes_that_vary() const
  {
    const Sizing_map sizes = m_surface.sizes;
    return std::adjacent_find(sizes.begin(), sizes.end(), std::not_equal_to<>()) != sizes.end();
  }

  // In the scale of the mesh, which is on its upper side.
  const std::optional<Mirror>& mirror() const { return m_mirror; }

  // A length in the size of the input.
  double unscaled(const double x) const { return std::ldexp(x, m_exponent); }

  double scaled(const double x) const { return std::ldexp(x, -m_exponent); }

  // In the scale of the mesh, without over- and underflow.
  double length(const Halfedge h) const
  {
    const auto edge = m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h));
    return std::hypot(edge.x(), edge.y(), edge.z());
  }

  double length_of_features() const
  {
    double sum = 0;
    for(const Edge e : m_mesh.edges())
      if(m_surface.is_feature[e])
        sum += length(m_mesh.halfedge(e));
    return unscaled(sum);
  }

  // The number of a face in the input.
  std::size_t original(const std::size_t face) const { return m_surface.originals[face]; }

private:
  bool has_inner_feature(const Vertex v) const
  {
    const auto edges = m_mesh.halfedges_around_target(m_mesh.halfedge(v));
    return std::any_of(edges.begin(), edges.end(), [&](const Halfedge h) {
      return m_surface.is_feature[m_mesh.edge(h)] && !m_mesh.is_border(m_mesh.edge(h));
    });
  }

  bool is_on_mirror(const Vertex v) const
  { return m_mirror && std::abs(m_mirror->distance(m_mesh.point(v))) < 1e-9; }

  void scale()
  {
    double size = 0;
    for(const auto v : m_mesh.vertices())
      for(int c = 0; c < 3; ++c)
        size = (std::max)(size, std::abs(m_mesh.point(v)[c]));
    if(!(size > 0 && std::isfinite(size)))
      return;
    m_exponent = std::ilogb(size);
    const auto scaled = [&](const double x) { return std::ldexp(x, -m_exponent); };
    for(const auto v : m_mesh.vertices()) {
      Point& p = m_mesh.point(v);
      p = Point(scaled(p.x()), scaled(p.y()), scaled(p.z()));
    }
  }

  // Only their ratios count, because the number of quads is known: the largest becomes near 1, so
  // that squares are neither 0 nor infinite. Sizes that are refused later stay as they are.
  void scale_sizes()
  {
    const Sizing_map sizes = m_surface.sizes;
    const auto [least, largest] = std::minmax_element(sizes.begin(), sizes.end());
    if(least == sizes.end() || !(*least > 0 && std::isfinite(*largest / *least)))
      return;
    const int exponent = std::ilogb(*largest);
    for(const Vertex v : m_mesh.vertices())
      sizes[v] = std::ldexp(sizes[v], -exponent);
  }

  // Keeps nothing of a surface that meets itself along the plane.
  void keep_half(const Mirror& mirror)
  {
    const Half_surface half(m_mesh, m_surface.is_feature, mirror);
    const Sizing_map sizes = m_surface.sizes;
    std::vector<std::pair<Point, double> > vertices;
    for(const Half_surface::Place& p : half.places())
      vertices.emplace_back(half.point(p),
                            (1 - p.t) * sizes[p.source] + p.t * sizes[p.target]);
    m_mesh.clear_without_removing_property_maps();
    const std::vector<std::size_t> originals = std::exchange(m_surface.originals, {});
    for(const auto& [point, size] : vertices)
      m_surface.sizes[m_mesh.add_vertex(point)] = size;
    for(const Half_surface::Triangle& t : half.triangles()) {
      std::array<Vertex, 3> v;
      for(std::size_t i = 0; i < 3; ++i)
        v[i] = Vertex(Mesh::size_type(t.vertices[i]));
      const Face f = m_mesh.add_face(v[0], v[1], v[2]);
      if(f == Mesh::null_face()) {
        m_mesh.clear_without_removing_property_maps();
        return;
      }
      m_surface.originals.push_back(originals[std::size_t(t.face)]);
      for(std::size_t i = 0; i < 3; ++i)
        if(t.is_feature[i])
          m_surface.is_feature[m_mesh.edge(m_mesh.halfedge(v[i], v[(i + 1) % 3]))] = true;
    }
  }

  Marked_surface m_surface;
  Mesh& m_mesh = m_surface.mesh;
  Uv_map m_uv_map = m_mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  // these two are known once there are coordinates
  Feature_map m_is_cut = m_mesh.add_property_map<Edge, bool>("e:is_cut", false).first;
  Rotation_map m_rotations = m_mesh.add_property_map<Halfedge, int>("h:rotation", 0).first;
  std::optional<Mirror> m_mirror;
  Border_straightener::Point_map m_points_of_map = m_mesh.points();
  std::size_t m_number_of_corners_left_out = 0;
  int m_exponent = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H
