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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_ANGLES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_ANGLES_H

#include <CGAL/license/Seamless_snapping.h>

// Whether repairs of flips leave vertices the angles that they seem to have in the input.

#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/untangling/Constrained_triangles.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
class Vertex_angles
{
public:
  explicit Vertex_angles(const Movable_points<Group>& points) : m_points(points) { }

  // Sectors have the numbers of their vertices, other points follow.
  std::size_t vertex(const Point_index p) const
  {
    const auto& first = m_points.complex().first_sector;
    if(!m_points.is_sector(p))
      return m_points.complex().number_of_vertices() +
             (std::size_t(p) - m_points.stars().number_of_sectors());
    return std::size_t(std::upper_bound(first.begin(), first.end(), p) - first.begin()) - 1;
  }

  // The sum of the angles of a vertex in the input without its folds. On the border, any sum is
  // possible: not a number.
  struct Input_sum
  {
    Angle_sum angles;
    std::ptrdiff_t ends = 0; // what the numbers of the first and the last neighbor differ by

    double value() const
    { return ends == 0 ? angles.without_folds() : std::numeric_limits<double>::quiet_NaN(); }
  };

  void add(const Domain_face& face, const std::size_t corner, Input_sum& sum) const
  {
    sum.angles.add(cartesian(face.input), corner);
    sum.ends += std::ptrdiff_t(vertex(face.points[(corner + 1) % 3])) -
                std::ptrdiff_t(vertex(face.points[(corner + 2) % 3]));
  }

  // Whether all vertices of a face have them, or folds are left there.
  bool are_kept(const Uv_state& state, const Face_index f) const
  {
    const auto points = m_points.domain_face(f).points; // a copy: stars meet more faces
    return std::all_of(points.begin(), points.end(),
                       [&](const Point_index p) { return is_kept(state, p); });
  }

  // Whether the vertices of its sectors have them: all cones but some of 720 degrees are there.
  bool are_kept_by_sectors(const Uv_state& state, const Face_index f) const
  {
    const auto points = m_points.domain_face(f).points;
    return std::all_of(points.begin(), points.end(), [&](const Point_index p)
                       { return !m_points.is_sector(p) || is_kept(state, p); });
  }

  // Vertices of these faces where they are not.
  std::size_t number_of_changed_vertices(const Uv_state& state,
                                         const std::vector<Face_index>& faces) const
  {
    std::vector<std::pair<std::size_t, Point_index> > vertices;
    for(const Face_index f : faces)
      for(const Point_index p : Domain_face(m_points.domain_face(f)).points)
        vertices.emplace_back(vertex(p), p);
    std::sort(vertices.begin(), vertices.end());
    std::size_t result = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(i == 0 || vertices[i].first != vertices[i - 1].first)
        result += is_kept(state, vertices[i].second) ? 0 : 1;
    return result;
  }

private:
  static Uv_triangle cartesian(const Uv_triangle& t)
  { return {{Group::to_cartesian(t[0]), Group::to_cartesian(t[1]), Group::to_cartesian(t[2])}}; }

  bool is_kept(const Uv_state& state, const Point_index p) const
  {
    Input_sum before;
    Angle_sum now;
    const auto add_star = [&](const Point_index q) {
      for(const Face_corner& corner : m_points.stars().star(q)) {
        const Domain_face& face = m_points.domain_face(corner.face);
        add(face, corner.position, before);
        now.add(cartesian(m_points.triangle(state, face)), corner.position);
      }
    };
    if(m_points.is_sector(p)) {
      const auto& first = m_points.complex().first_sector;
      const std::size_t v = vertex(p);
      for(Sector_index s = first[v]; s != first[v + 1]; ++s)
        add_star(s);
    } else {
      add_star(p);
    }
    return !now.is_wrong(before.value());
  }

  const Movable_points<Group>& m_points;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_VERTEX_ANGLES_H
