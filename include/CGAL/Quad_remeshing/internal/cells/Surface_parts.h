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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_SURFACE_PARTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_SURFACE_PARTS_H

#include <CGAL/license/Quad_remeshing.h>

// The connected parts of a parametrized surface, and what the theorem needs to know of each: its
// Euler characteristic, its area in the domain, and whether its border lies on the grid.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Surface_part
{
  std::size_t first_face = 0;
  std::ptrdiff_t euler_characteristic = 0;
  std::size_t number_of_unaligned_edges = 0; // of the border, that don't lie on a line of the grid
  Exact_rational twice_area{0};
};

// Whether the edge runs along a line of the grid.
template <typename Group>
bool is_on_grid_line(const Basic_chart_mesh<Group>& mesh, const Corner_index h)
{ return is_on_isocurve(mesh, h, [](const auto& level) { return is_integer(level); }); }

// Whether the border turns back at the end of the edge, on a line of the grid but between its
// points: the angle is 180 degrees, with a ray along each side, or a larger multiple of it.
template <typename Group>
bool ends_slit(const Basic_chart_mesh<Group>& mesh, const Corner_index h)
{
  if(is_lattice_point(mesh.uv(h)))
    return false;
  const std::size_t v = mesh.vertex(h);
  const Corner_index next_edge = mesh.next(mesh.corner_at_vertex[v]);
  return mesh.opposite(next_edge) == no_index && is_on_grid_line(mesh, next_edge) &&
         rays_from_vertex(mesh, v).size() != std::size_t(Group::order / 2 + 1);
}

// Whether no cell is cut at a border edge.
// \pre all corners at a vertex on the border are in one fan
template <typename Group>
bool is_border_on_grid(const Basic_chart_mesh<Group>& mesh, const Corner_index h)
{ return is_on_grid_line(mesh, h) && !ends_slit(mesh, h); }

// a x b
inline Exact_rational cross_product(const std::array<Exact_rational, 2>& a,
                                    const std::array<Exact_rational, 2>& b)
{
  return Exact_rational(a[0] * b[1] - a[1] * b[0]);
}

inline std::array<Exact_rational, 2> exact(const Uv& u)
{
  return {Exact_rational(u[0]), Exact_rational(u[1])};
}

class Surface_parts
{
public:
  template <typename Group, typename ConcurrencyTag = CGAL::Sequential_tag>
  explicit Surface_parts(const Basic_chart_mesh<Group>& mesh, ConcurrencyTag = ConcurrencyTag())
  {
    number_parts(mesh);
    const auto runs = results_of_chunks<std::vector<Run>, ConcurrencyTag>(
      mesh.corners.size() / 3, [&](const Chunk& faces) { return measure(mesh, faces); });
    for(const std::vector<Run>& of_chunk : runs)
      for(const Run& run : of_chunk)
        add(run.data, m_data[run.part]);
  }

  std::size_t size() const { return m_data.size(); }
  const Surface_part& operator[](const std::size_t i) const { return m_data[i]; }
  std::size_t part_of_face(const std::size_t f) const
  { return m_parts.empty() ? 0 : std::size_t(m_parts[f]); }

private:
  // What successive faces of a part add to it.
  struct Run
  {
    std::size_t part;
    Surface_part data;
  };

  template <typename Group>
  void number_parts(const Basic_chart_mesh<Group>& mesh)
  {
    m_parts = connected_parts(mesh.corners.size() / 3,
                              [&](const Corner_index h) { return mesh.opposite(h); });
    for(std::size_t f = 0; f < m_parts.size(); ++f)
      if(std::size_t(m_parts[f]) == m_data.size())
        m_data.push_back({f});
    if(m_data.size() == 1)
      std::vector<std::int32_t>().swap(m_parts);
  }

  template <typename Group>
  std::vector<Run> measure(const Basic_chart_mesh<Group>& mesh, const Chunk& faces) const
  {
    std::vector<Run> runs;
    for(std::size_t f = faces.begin; f < faces.end; ++f) {
      const std::size_t part = part_of_face(f);
      if(runs.empty() || runs.back().part != part)
        runs.push_back({part, {}});
      for(std::size_t i = 3 * f; i < 3 * f + 3; ++i)
        add_corner(mesh, Corner_index(i), runs.back().data);
    }
    return runs;
  }

  static void add(const Surface_part& more, Surface_part& part)
  {
    part.euler_characteristic += more.euler_characteristic;
    part.number_of_unaligned_edges += more.number_of_unaligned_edges;
    part.twice_area += more.twice_area;
  }

  template <typename Group>
  static void add_corner(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                         Surface_part& part)
  {
    part.euler_characteristic += (h % 3 == 0 ? 1 : 0) - (mesh.edge_key(h) == h ? 1 : 0) +
                                 (mesh.corner_at_vertex[mesh.vertex(h)] == h ? 1 : 0);
    const Corner_index p = mesh.prev(h), g = mesh.opposite(h);
    if(g == no_index) {
      part.number_of_unaligned_edges += is_border_on_grid(mesh, h) ? 0 : 1;
      part.twice_area += cross_product(exact(mesh.uv(p)), exact(mesh.uv(h)));
    } else if(mesh.corner(h).transition != no_index && h < g) {
      add_cut(mesh, h, part);
    }
  }

  // The area is the sum of the cross products of the ends of all halfedges. The two of an edge add
  // up to 0 if both charts are the same, and to the cross product of t and a' - b' if not.
  template <typename Group>
  static void add_cut(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                      Surface_part& part)
  {
    const Corner_index g = mesh.opposite(h);
    const auto& t = mesh.transitions[std::size_t(mesh.corner(h).transition)].translation;
    const Uv translation{nearest_double(t[0]), nearest_double(t[1])};
    if(translation[0] == 0 && translation[1] == 0)
      return;
    const auto a = exact(mesh.uv(g)), b = exact(mesh.uv(mesh.prev(g)));
    part.twice_area += cross_product(exact(translation),
                                     {Exact_rational(a[0] - b[0]), Exact_rational(a[1] - b[1])});
  }

  std::vector<std::int32_t> m_parts; // per face; empty if there is one part only
  std::vector<Surface_part> m_data;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_SURFACE_PARTS_H
