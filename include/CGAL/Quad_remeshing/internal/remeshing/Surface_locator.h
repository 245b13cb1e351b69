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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_LOCATOR_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_LOCATOR_H

#include <CGAL/license/Quad_remeshing.h>

// Finds the points and faces of a surface that are nearest to places in space.

#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Shape_counter.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the surface does not change.
class Surface_locator
  : private Remeshing_types
{
  using Tree = Nearest_place_tree<Space_triangle>;

public:
  using Largest_distance = Tree::Largest_distance;

  explicit Surface_locator(const Mesh& surface) : m_surface(surface)
  {
    std::vector<Space_triangle> triangles;
    const auto add_if = [&](const auto& is_wanted) {
      for(const Face f : surface.faces())
        if(const Space_triangle t = triangle_of(surface, f); is_wanted(t)) {
          triangles.push_back(t);
          m_searched.push_back(f);
        }
    };
    add_if([](const Space_triangle& t) // the points of others lie on these, too
           { return !CGAL::collinear(to_point(t[0]), to_point(t[1]), to_point(t[2])); });
    if(triangles.empty())
      add_if([](const Space_triangle&) { return true; });
    m_tree = Tree(triangles);
  }

  std::size_t number_of_searches() const { return m_tree.number_of_searches(); }

  // From the surface, of the points that are added to it.
  Largest_distance largest_distance() const { return Largest_distance(m_tree); }

  // The nearest point of the surface.
  Space_vector nearest(const Space_vector& p) const { return m_tree.nearest(p).point; }

  // A faster search for it, which begins at another point of the surface.
  Space_vector nearest(const Space_vector& p, const Space_vector& near_by) const
  { return m_tree.nearest(p, near_by); }

  Face nearest_face(const Space_vector& p) const
  { return m_searched[m_tree.nearest(p).element]; }

  // The nearest face. If two faces lie on each other and face to opposite sides, because bodies
  // touch, the one that faces to `side`.
  Face nearest_face(const Space_vector& p, const Space_vector& side) const
  { return nearest_face(p, side, distance_of_same_place, cosine_of_opposite_sides); }

  // Also of two farther from each other, such as the sides of a plate that is thin against quads.
  Face nearest_face(const Space_vector& p, const Space_vector& side, const double distance) const
  { return nearest_face(p, side, distance, cosine_of_plate); }

  // The area vector, times two, of the triangle that is nearest to the middle of a quad.
  Space_vector normal(const Quad& q) const
  {
    std::array<double, 3> middle{};
    for(const Space_vector& p : q)
      for(std::size_t c = 0; c < 3; ++c)
        middle[c] += p[c] / 4;
    return normal(nearest_face(middle, quad_normal(q)));
  }

  Space_vector normal(const Face f) const
  { return area_vector(triangle_of(m_surface, f)); }

  // The normal of a surface that is a plane, or parallel planes that face to one side; else 0.
  Space_vector unit_normal_of_plane() const
  {
    constexpr double rounding = 1e-9; // the error of a unit normal
    Space_vector sum{};
    double size = 0;
    for(const Face f : faces(m_surface)) {
      const Space_vector n = normal(f);
      size += norm(n);
      for(std::size_t c = 0; c < 3; ++c)
        sum[c] += n[c];
    }
    return norm(sum) > (1 - rounding) * size ? scaled_to_one(sum) : Space_vector{};
  }

private:
  // \param largest_cosine of the angle between the normals of the two
  Face nearest_face(const Space_vector& p, const Space_vector& side, const double distance,
                    const double largest_cosine) const
  {
    const auto place = m_tree.nearest(p);
    const Face nearest = m_searched[place.element];
    const Space_vector upward = scaled_to_one(normal(nearest));
    if(inner_product(upward, side) >= 0)
      return nearest;
    Space_segment s;
    for(std::size_t c = 0; c < 3; ++c) {
      s[0][c] = place.point[c] - distance * upward[c];
      s[1][c] = place.point[c] + distance * upward[c];
    }
    const Kernel::Segment_3 segment(to_point(s[0]), to_point(s[1]));
    if(segment.is_degenerate()) // far from the origin
      return nearest;
    Face result = nearest;
    double least = std::numeric_limits<double>::infinity();
    m_tree.visit_near(s, [&](const std::size_t i) {
      const Space_triangle t = triangle_of(m_surface, m_searched[i]);
      const Space_vector other = scaled_to_one(area_vector(t));
      const double cosine = inner_product(other, upward);
      const Kernel::Triangle_3 triangle(to_point(t[0]), to_point(t[1]), to_point(t[2]));
      if(!(cosine < largest_cosine && inner_product(other, side) > 0) || triangle.is_degenerate() ||
         !CGAL::do_intersect(segment, triangle))
        return;
      const double along_normal =
        std::abs(inner_product(vector_to(place.point, t[0]), other) / cosine);
      if(along_normal < least) {
        least = along_normal;
        result = m_searched[i];
      }
    });
    return result;
  }

  static constexpr double distance_of_same_place = 1e-3; // on a surface of a size near 1
  static constexpr double cosine_of_opposite_sides = -0.999, cosine_of_plate = -0.1; // of normals

  const Mesh& m_surface;
  Tree m_tree;
  std::vector<Face> m_searched; // of its triangles
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_LOCATOR_H
