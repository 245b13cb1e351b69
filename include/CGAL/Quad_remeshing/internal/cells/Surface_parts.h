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

// The connected parts of a parametrized surface, with the data that the theorem needs: the Euler
// characteristic, the area in the domain, and whether the border lies on the grid.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>
#include <CGAL/Quad_remeshing/internal/cells/Lattice_points.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
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

  Surface_part& operator+=(const Surface_part& more)
  {
    euler_characteristic += more.euler_characteristic;
    number_of_unaligned_edges += more.number_of_unaligned_edges;
    twice_area += more.twice_area;
    return *this;
  }
};

// The contributions of elements to the parts of a surface that they lie in. They are summed up in
// chunks of elements, in which parts change rarely.
// \param part_of(i) the part of element i
// \param add(i, sum) adds the element
template <typename Sum, typename ConcurrencyTag, typename Part_of, typename Add>
std::vector<Sum> sums_of_parts(const std::size_t number_of_elements,
                               const std::size_t number_of_parts, const Part_of& part_of,
                               const Add& add)
{
  using Run = std::pair<std::size_t, Sum>; // successive elements of a part
  const auto runs = results_of_chunks<std::vector<Run>, ConcurrencyTag>(
    number_of_elements, [&](const Chunk& chunk) {
      std::vector<Run> result;
      for(std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const std::size_t part = part_of(i);
        if(result.empty() || result.back().first != part)
          result.push_back({part, {}});
        add(i, result.back().second);
      }
      return result;
    });
  std::vector<Sum> sums(number_of_parts);
  for(const std::vector<Run>& of_chunk : runs)
    for(const Run& run : of_chunk)
      sums[run.first] += run.second;
  return sums;
}

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
    const auto sums = sums_of_parts<Surface_part, ConcurrencyTag>(
      mesh.corners.size() / 3, size(), [&](const std::size_t f) { return part_of_face(f); },
      [&](const std::size_t f, Surface_part& sum) {
        for(std::size_t i = 3 * f; i < 3 * f + 3; ++i)
          add_corner(mesh, Corner_index(i), sum);
      });
    for(std::size_t i = 0; i < size(); ++i)
      m_data[i] += sums[i];
  }

  std::size_t size() const { return m_data.size(); }
  const Surface_part& operator[](const std::size_t i) const { return m_data[i]; }
  std::size_t part_of_face(const std::size_t f) const
  { return m_parts.empty() ? 0 : std::size_t(m_parts[f]); }

private:
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

using Linear_snapping::internal::distance_to_integer; // and for more types:

inline double distance_to_integer(const Uv& u)
{
  return (std::max)(distance_to_integer(u[0]), distance_to_integer(u[1]));
}

inline bool is_integer(const Exact_level& x)
{
  return x.is_double() && x.approximation() == std::round(x.approximation());
}

inline double distance_to_integer(const Exact_level& x)
{
  return std::abs(x.minus(Exact_level(std::round(x.approximation()))).approximation());
}

// The area of some faces, and about how often lines of the grid cross their edges; in units and in
// floating point.
struct Grid_size
{
  double area = 0, crossings = 0;
};

template <typename Group>
Grid_size grid_size(const Basic_chart_mesh<Group>& mesh, const std::size_t begin,
                    const std::size_t end)
{
  Grid_size result;
  for(std::size_t f = begin; f < end; ++f) {
    const Uv_triangle t = triangle(mesh, f);
    result.area += ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) -
                    (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])) / 2;
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t c = 0; c < 2; ++c)
        result.crossings += std::abs(t[k][c] - t[(k + 1) % 3][c]);
  }
  return result;
}

// Twice the area of a positive triangle, with a small relative error.
inline double area_near(const Uv& a, const Uv& b, const Uv& c)
{
  const double first = (b[0] - a[0]) * (c[1] - a[1]), second = (b[1] - a[1]) * (c[0] - a[0]);
  const double area = first - second;
  if(area > 1e-6 * (std::abs(first) + std::abs(second)))
    return area;
  const auto u = exact(a), v = exact(b), w = exact(c);
  return CGAL::to_double(cross_product({Exact_rational(v[0] - u[0]), Exact_rational(v[1] - u[1])},
                                       {Exact_rational(w[0] - u[0]), Exact_rational(w[1] - u[1])}));
}

// The place of a point of the grid in its face, as in `Face_point`.
template <typename Group>
std::array<double, 3> weights(const Basic_chart_mesh<Group>& mesh, const Lattice_point& p)
{
  std::array<double, 3> result{};
  const std::size_t corner = std::size_t(p.corner % 3);
  switch(p.place) {
  case Lattice_place::VERTEX:
    result[corner] = 1;
    return result;
  case Lattice_place::EDGE: {
    const Uv &a = mesh.uv(mesh.prev(p.corner)), &b = mesh.uv(p.corner);
    const std::size_t c = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
    result[corner] = (p.uv[c] - a[c]) / (b[c] - a[c]);
    result[(corner + 2) % 3] = (b[c] - p.uv[c]) / (b[c] - a[c]);
    return result;
  }
  case Lattice_place::FACE:
    break;
  }
  const Uv_triangle t = triangle(mesh, face_of(p.corner));
  double sum = 0;
  for(std::size_t k = 0; k < 3; ++k)
    sum += result[k] = area_near(p.uv, t[(k + 1) % 3], t[(k + 2) % 3]);
  for(double& w : result)
    w /= sum;
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_SURFACE_PARTS_H
