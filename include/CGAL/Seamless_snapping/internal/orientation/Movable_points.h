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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H

#include <CGAL/license/Seamless_snapping.h>

// The points of the domain whose coordinates repairs of orientations may change, and the faces
// around them: sectors, and vertices that belong to none, under one kind of index. Reads from the
// mesh what is asked for, and nothing else; to the steps that repair, faces are triples of indices.

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/Sector_links.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>
#include <CGAL/Seamless_snapping/internal/exact/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// First the sectors, then the other vertices in the order in which they are met.
using Point_index = Sector_index;
using Face_index = std::int32_t; // in the order in which they are met

// Coordinates of points under way. Points that were met later have those of the input.
using Uv_state = std::vector<Uv>;

// A face as it was in the input.
struct Domain_face
{
  std::array<Point_index, 3> points; // counterclockwise
  Uv_triangle input;
  bool was_positive;
};

// A face, and which of its corners is meant.
struct Face_corner
{
  Face_index face;
  std::size_t position;
};

template <typename Group_, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Movable_points
{
public:
  using Group = Group_;
  using Cuts = Surface_cuts<Group, TriangleMesh>;
  using Halfedge = typename Cuts::Halfedge;

  Movable_points(const TriangleMesh& tmesh, const Cuts& cuts, const HalfedgeUVMap& uv_map,
                 const VertexIndexMap& vertex_indices, const Complex_solver<Group>& solver)
    : m_tmesh(tmesh), m_cuts(cuts), m_uv_map(uv_map), m_vertex_indices(vertex_indices),
      m_solver(solver)
  { }

  const TriangleMesh& mesh() const { return m_tmesh; }
  const Cuts& cuts() const { return m_cuts; }
  std::size_t number_of_sectors() const { return m_cuts.complex.number_of_sectors(); }
  bool is_sector(const Point_index p) const { return std::size_t(p) < number_of_sectors(); }
  std::size_t size() const { return number_of_sectors() + m_free_corners.size(); }

  // The links between sectors; made when they are first asked for: most runs repair nothing.
  const Sector_links<Group>& links() const
  {
    if(!m_links)
      m_links.emplace(m_cuts.complex);
    return *m_links;
  }

  const Domain_face& domain_face(const Face_index f) const { return m_faces[std::size_t(f)]; }

  // The face of a corner, met if it wasn't.
  Face_corner corner(const Halfedge h)
  {
    const Halfedge first = halfedge(face(h, m_tmesh), m_tmesh);
    return {face_index(first), h == first ? 0u : h == next(first, m_tmesh) ? 1u : 2u};
  }

  // Calls f(Face_corner) for all corners of a point.
  template <typename F>
  void for_each_face(const Point_index p, const F& f)
  {
    std::vector<Halfedge> corners; // meeting faces changes the lists that are walked
    for_each_corner(p, [&](const Halfedge h) { corners.push_back(h); });
    for(const Halfedge h : corners)
      f(corner(h));
  }

  Uv uv(const Uv_state& state, const Point_index p) const
  {
    return std::size_t(p) < state.size() ? state[std::size_t(p)] : input(free_corner(p));
  }

  Uv_triangle triangle(const Uv_state& state, const Domain_face& f) const
  {
    return {{uv(state, f.points[0]), uv(state, f.points[1]), uv(state, f.points[2])}};
  }

  bool is_positive(const Uv_state& state, const Face_index f) const
  {
    return orientation(triangle(state, domain_face(f))) == CGAL::POSITIVE;
  }

  void set_uv(Uv_state& state, const Point_index p, const Uv& u) const
  {
    while(state.size() <= std::size_t(p))
      state.push_back(uv(state, Point_index(state.size())));
    state[std::size_t(p)] = u;
  }

  // A multiple of the distance of neighboring numbers that the point can take: those of the coarser
  // of its grids or, where no constraint concerns it, of its coordinates' type, anywhere in the
  // ring around it.
  double spacing(const Point_index p) const
  {
    double result = is_sector(p) ? grid_step(p) : 0;
    if(result > 0)
      return result;
    double largest = 0;
    for_each_corner(p, [&](const Halfedge corner) {
      for(const Halfedge h : {corner, next(corner, m_tmesh), prev(corner, m_tmesh)})
        largest = (std::max)({largest, std::abs(input(h)[0]), std::abs(input(h)[1])});
    });
    return Grid::finest(m_solver.format(), largest).step();
  }

  // The numbers of some faces in the order of iteration over all faces of the mesh.
  std::vector<std::size_t> numbers_in_mesh(const std::vector<Face_index>& some) const
  {
    std::vector<std::size_t> result;
    if(some.empty())
      return result;
    std::vector<bool> is_wanted(m_faces.size(), false);
    for(const Face_index f : some)
      is_wanted[std::size_t(f)] = true;
    std::size_t number = 0;
    for(const auto f : faces(m_tmesh)) {
      const auto found = m_face_of_halfedge.find(halfedge(f, m_tmesh));
      if(found != m_face_of_halfedge.end() && is_wanted[std::size_t(found->second)])
        result.push_back(number);
      ++number;
    }
    return result;
  }

  Uv input(const Halfedge corner) const { return get_uv(m_uv_map, corner); }

  template <typename F>
  void for_each_corner(const Point_index p, const F& f) const
  {
    if(is_sector(p)) {
      for(auto h = m_cuts.corners_begin(p); h != m_cuts.corners_end(p); ++h)
        f(*h);
      return;
    }
    // all around, or up to the border on either side: beyond, there may be more corners of the
    // vertex
    const Halfedge first = free_corner(p);
    Halfedge h = first;
    do {
      f(h);
      h = opposite(next(h, m_tmesh), m_tmesh);
    } while(h != first && !is_border(h, m_tmesh));
    if(h == first)
      return;
    for(h = opposite(first, m_tmesh); !is_border(h, m_tmesh); h = opposite(h, m_tmesh)) {
      h = prev(h, m_tmesh);
      f(h);
    }
  }

private:
  Halfedge free_corner(const Point_index p) const
  {
    return m_free_corners[std::size_t(p) - number_of_sectors()];
  }

  Face_index face_index(const Halfedge first)
  {
    const auto found = m_face_of_halfedge.find(first);
    if(found != m_face_of_halfedge.end())
      return found->second;
    const Face_index f = Face_index(m_faces.size());
    m_face_of_halfedge.emplace(first, f);
    Domain_face result{};
    Halfedge h = first;
    for(std::size_t i = 0; i < 3; ++i, h = next(h, m_tmesh)) {
      result.points[i] = point(h);
      result.input[i] = input(h);
    }
    result.was_positive = orientation(result.input) == CGAL::POSITIVE;
    m_faces.push_back(result);
    return f;
  }

  Point_index point(const Halfedge corner)
  {
    const Sector_index s = sector(corner);
    if(s >= 0)
      return s;
    const auto found = m_free_points.find(corner);
    if(found != m_free_points.end())
      return found->second;
    const Point_index p = Point_index(size());
    m_free_corners.push_back(corner);
    for_each_corner(p, [&](const Halfedge h) { m_free_points.emplace(h, p); });
    return p;
  }

  // The sectors' vertices are in the order of the mesh's indices, so that no table is needed.
  Sector_index sector(const Halfedge corner) const
  {
    const auto& first_sector = m_cuts.complex.first_sector;
    if(number_of_sectors() == 0)
      return -1;
    const std::size_t index = vertex_index(corner);
    std::size_t low = 0, high = m_cuts.complex.number_of_vertices();
    while(high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (vertex_index(*m_cuts.corners_begin(first_sector[middle])) <= index ? low : high) = middle;
    }
    for(Sector_index s = first_sector[low]; s != first_sector[low + 1]; ++s)
      if(std::find(m_cuts.corners_begin(s), m_cuts.corners_end(s), corner) != m_cuts.corners_end(s))
        return s;
    return -1;
  }

  std::size_t vertex_index(const Halfedge corner) const
  {
    return std::size_t(get(m_vertex_indices, target(corner, m_tmesh)));
  }

  // 0 for sectors of merged corners only.
  double grid_step(const Sector_index s) const
  {
    if(m_grid_steps.empty()) {
      m_grid_steps.assign(number_of_sectors(), 0);
      m_solver.components().for_each_sector([&](const Sector_index t, const auto& components) {
        double& step = m_grid_steps[std::size_t(t)];
        for(const Component_index k : components)
          if(k >= 0)
            step = (std::max)(step, m_solver.grids()[std::size_t(k)].step());
      });
    }
    return m_grid_steps[std::size_t(s)];
  }

  const TriangleMesh& m_tmesh;
  const Cuts& m_cuts;
  const HalfedgeUVMap& m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  const Complex_solver<Group>& m_solver;
  std::vector<Domain_face> m_faces;
  std::unordered_map<Halfedge, Face_index> m_face_of_halfedge; // by the face's own
  std::unordered_map<Halfedge, Point_index> m_free_points;     // by corner
  std::vector<Halfedge> m_free_corners;
  mutable std::optional<Sector_links<Group> > m_links; // made when needed, as the steps
  mutable std::vector<double> m_grid_steps;            // per sector
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_MOVABLE_POINTS_H
