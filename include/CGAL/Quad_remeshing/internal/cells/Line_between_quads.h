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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_LINE_BETWEEN_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_LINE_BETWEEN_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// The isocurve between two lines of the grid, through the middle of a strip of quads. If all
// vertices lie on the grid, it meets none of them.

#include <CGAL/Isocurves_and_layouts/internal/tracing/Isocurve_walk.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/decisions.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/start_walk.h>
#include <CGAL/Quad_remeshing/internal/cells/Grid_darts.h>
#include <CGAL/Quad_remeshing/internal/cells/Integer_decisions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// A face of the map on the line, with the halfedges over which the line leaves and enters it, and
// the direction to its left, in the face's chart.
struct Face_on_line
{
  Corner_index exit, entry;
  Direction left;
};

class Line_between_quads
{
  using Group = Quarter_turns;
  using State = Exact_decisions::State;

public:
  explicit Line_between_quads(const Chart_mesh& mesh) : m_mesh(mesh) { }

  // The faces along that through the midpoint of dart k of a point; none if the dart leaves the
  // surface.
  std::vector<Face_on_line> faces(const Lattice_point& point, const int k) const
  {
    Place place = start_of_dart(point, k);
    const Uv end = unit_step<Group>(place.point, place.direction);
    Uv middle{(place.point[0] + end[0]) / 2, (place.point[1] + end[1]) / 2};
    Corner_index entry = no_index;
    for(Corner_index h; (h = exit_towards(place, middle, entry)) != no_index;) {
      entry = m_mesh.opposite(h);
      if(entry == no_index)
        return {};
      middle = across(h, middle);
      place = {entry, across(h, place.point), turned(place.direction, m_mesh.rotation(h))};
    }
    return faces_of_line({place.corner, middle, turned(place.direction, 1)});
  }

private:
  // On the surface, in the chart of the corner's face.
  struct Place
  {
    Corner_index corner;
    Uv point;
    Direction direction;
  };

  Place start_of_dart(const Lattice_point& p, const int k) const
  {
    switch(p.place) {
    case Lattice_place::VERTEX: {
      const Vertex_ray ray = rays_from_vertex(m_mesh, m_mesh.vertex(p.corner))[std::size_t(k)];
      return {ray.corner, m_mesh.uv(ray.corner), ray.direction};
    }
    case Lattice_place::EDGE:
      return {p.corner, p.uv, turned(Edge_directions(m_mesh, p.corner).first, k)};
    case Lattice_place::FACE:
      break;
    }
    return {p.corner, p.uv, k};
  }

  // The halfedge over which the way to `end` leaves the face, or no index if it ends there.
  Corner_index exit_towards(const Place& place, const Uv& end, const Corner_index entry) const
  {
    const Corner_index first = 3 * (place.corner / 3);
    for(Corner_index h = first; h < first + 3; ++h) {
      const Uv& source = m_mesh.uv(Chart_mesh::prev(h));
      const Uv& target = m_mesh.uv(h);
      if(h != entry && orientation({source, target, end}) == CGAL::NEGATIVE &&
         orientation({place.point, end, source}) != CGAL::POSITIVE &&
         orientation({place.point, end, target}) != CGAL::NEGATIVE)
        return h;
    }
    return no_index;
  }

  // In the chart behind the halfedge.
  Uv across(const Corner_index h, const Uv& u) const
  {
    return carried<Group>(u, m_mesh.rotation(h), m_mesh.uv(h),
                          m_mesh.uv(Chart_mesh::prev(m_mesh.opposite(h))));
  }

  // The faces from the face of the place on: around, or to the border and then back from there to
  // the other border.
  std::vector<Face_on_line> faces_of_line(const Place& place) const
  {
    std::vector<State> ahead, behind;
    std::vector<Face_on_line> result;
    if(walk(place, ahead) == Isocurve_status::CLOSED) {
      ahead.pop_back(); // the first one, again
      add_faces(m_mesh.opposite(ahead.back().halfedge), ahead, result);
      return result;
    }
    walk({place.corner, place.point, reversed(place.direction)}, behind);
    add_faces(behind.front().halfedge, ahead, result);
    const Corner_index entry = m_mesh.opposite(behind.front().halfedge);
    behind.erase(behind.begin()); // of the first face, too
    add_faces(entry, behind, result);
    return result;
  }

  // Appends the states where the line leaves faces.
  Isocurve_status walk(const Place& place, std::vector<State>& states) const
  {
    State state;
    state.halfedge = place.corner;
    state.direction = place.direction;
    state.level =
      make_level<Exact_decisions::Level>(place.point[constant_component(place.direction)]);
    leave_face_point<Exact_decisions>(m_mesh, state);
    Isocurve_walk<Exact_decisions> walk(m_mesh, no_limits(), Exact_decisions(m_mesh));
    walk.begin(state);
    return run(walk, [&](const State& s) { states.push_back(s); });
  }

  // \param entry of the first one
  void add_faces(Corner_index entry, const std::vector<State>& exits,
                 std::vector<Face_on_line>& faces) const
  {
    for(const State& s : exits) {
      faces.push_back({s.halfedge, entry, turned(s.direction, 1)});
      entry = m_mesh.opposite(s.halfedge);
    }
  }

  const Chart_mesh& m_mesh;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_LINE_BETWEEN_QUADS_H
