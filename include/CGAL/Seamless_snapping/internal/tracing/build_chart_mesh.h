// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh, its uv map, and its transitions to plain arrays.

#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/tracing/Chart_mesh.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The quadrant that contains the vector from a to b, which is not null, each with the axis at its
// clockwise end.
inline int quadrant(const Uv& a, const Uv& b)
{
  const int x = compare(b[0], a[0]), y = compare(b[1], a[1]);
  if(x > 0 && y >= 0)
    return 0;
  if(x <= 0 && y > 0)
    return 1;
  return (x < 0 && y <= 0) ? 2 : 3;
}

// By how many axes a vector passes that turns from the first to the second edge of a corner;
// negative where the face is flipped. These add up to the angle around a vertex, in quarter turns,
// since the seams map axes to axes.
inline int axes_passed(const Uv& p, const Uv& q, const Uv& r)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  switch(turned(quadrant(p, r), -quadrant(p, q))) {
  case 0: return 0;
  case 1: return 1;
  case 3: return -1;
  }
  const Kernel::Point_2 a(p[0], p[1]), b(q[0], q[1]), c(r[0], r[1]);
  return Kernel().orientation_2_object()(a, b, c) == CGAL::NEGATIVE ? -2 : 2;
}

// The same angle where the seams are not exact; the sum is then near to an integer only.
inline double quarter_turns_between(const Uv& p, const Uv& q, const Uv& r)
{
  const Uv a{q[0] - p[0], q[1] - p[1]}, b{r[0] - p[0], r[1] - p[1]};
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / std::acos(0.);
}

// Vertices whose angle is not 360 degrees. Other than by rotations alone, this finds those of 720,
// too. An edge of no length has no angle with others: at its ends, rotations have to do.
inline void mark_singular_vertices(Chart_mesh& mesh)
{
  const std::size_t n = mesh.corner_at_vertex.size();
  std::vector<double> angles(n, 0); // in quarter turns
  std::vector<int> rotations(n, 0);
  std::vector<char> has_angle(n, true);
  for(std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Corner_index h = Corner_index(i);
    const std::size_t v = mesh.vertex(h);
    const Uv &p = mesh.uv(h), &q = mesh.uv(Chart_mesh::next(h)), &r = mesh.uv(Chart_mesh::prev(h));
    rotations[v] += mesh.rotation(h);
    if(p == q || p == r)
      has_angle[v] = false;
    else
      angles[v] += mesh.is_exact ? axes_passed(p, q, r) : quarter_turns_between(p, q, r);
  }
  mesh.is_singular.assign(n, false);
  for(std::size_t v = 0; v < n; ++v) {
    const bool is_regular = has_angle[v] ? std::lround(angles[v]) == number_of_rotations
                                         : rotations[v] % number_of_rotations == 0;
    mesh.is_singular[v] = !mesh.is_border[v] && mesh.corner_at_vertex[v] != no_index && !is_regular;
  }
}

// The arrays, and how they correspond to the mesh.
template <typename TriangleMesh>
class Chart_mesh_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;
  template <typename Tag>
  using Property_map = typename boost::property_map<TriangleMesh, Tag>::const_type;

public:
  explicit Chart_mesh_builder(const TriangleMesh& tmesh)
    : m_tmesh(&tmesh), m_corner(get(CGAL::dynamic_halfedge_property_t<Corner_index>(), tmesh)),
      m_vertex(get(CGAL::dynamic_vertex_property_t<Chart_vertex_index>(), tmesh))
  {
    for(const auto h : halfedges(tmesh))
      put(m_corner, h, no_index);
    for(const auto f : faces(tmesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
        put(m_corner, h, Corner_index(m_halfedges.size()));
        m_halfedges.push_back(h);
      }
    for(const Vertex v : vertices(tmesh)) {
      put(m_vertex, v, Chart_vertex_index(m_vertices.size()));
      m_vertices.push_back(v);
    }
  }

  Corner_index corner(const Halfedge h) const { return get(m_corner, h); }
  std::size_t vertex(const Vertex v) const { return std::size_t(get(m_vertex, v)); }
  const std::vector<Halfedge>& halfedges_of_corners() const { return m_halfedges; }
  const std::vector<Vertex>& vertices_in_order() const { return m_vertices; }

  template <typename HalfedgeUVMap>
  Chart_mesh build(const HalfedgeUVMap& uv_map, const Seam_transitions<TriangleMesh>& seams) const
  {
    Chart_mesh mesh;
    mesh.extent = seams.extent();
    mesh.violation = seams.violation();
    mesh.is_exact = seams.is_exact();
    mesh.corners.resize(m_halfedges.size());
    mesh.corner_at_vertex.assign(m_vertices.size(), no_index);
    mesh.is_border.assign(m_vertices.size(), false);
    for(std::size_t i = 0; i < m_halfedges.size(); ++i) {
      Chart_corner& c = mesh.corners[i];
      c.uv = get_uv(uv_map, m_halfedges[i]);
      c.opposite = corner(opposite(m_halfedges[i], *m_tmesh));
      c.vertex = get(m_vertex, target(m_halfedges[i], *m_tmesh));
      if(mesh.corner_at_vertex[std::size_t(c.vertex)] == no_index)
        mesh.corner_at_vertex[std::size_t(c.vertex)] = Corner_index(i);
    }
    for(std::size_t i = 0; i < m_halfedges.size(); ++i)
      add_transition(mesh, Corner_index(i), seams.rotation(m_halfedges[i]));
    mark_singular_vertices(mesh);
    return mesh;
  }

private:
  static void add_transition(Chart_mesh& mesh, const Corner_index h, const int rotation)
  {
    const Corner_index p = Chart_mesh::prev(h);
    const Corner_index g = mesh.opposite(h);
    if(g == no_index) {
      mesh.is_border[mesh.vertex(h)] = mesh.is_border[mesh.vertex(p)] = true;
      return;
    }
    if(rotation == 0 && mesh.uv(h) == mesh.uv(Chart_mesh::prev(g)) && mesh.uv(p) == mesh.uv(g))
      return;
    const Uv turned_source = rotation_matrix(rotation)(mesh.uv(p));
    mesh.corners[std::size_t(h)].transition = std::int32_t(mesh.transitions.size());
    mesh.transitions.push_back({rotation, {{Exact_difference(mesh.uv(g)[0], turned_source[0]),
                                            Exact_difference(mesh.uv(g)[1], turned_source[1])}}});
  }

  const TriangleMesh* m_tmesh;
  Property_map<CGAL::dynamic_halfedge_property_t<Corner_index> > m_corner;
  Property_map<CGAL::dynamic_vertex_property_t<Chart_vertex_index> > m_vertex;
  std::vector<Halfedge> m_halfedges;
  std::vector<Vertex> m_vertices;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRACING_BUILD_CHART_MESH_H
