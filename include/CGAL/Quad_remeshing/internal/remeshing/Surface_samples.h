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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_SAMPLES_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_SAMPLES_H

#include <CGAL/license/Quad_remeshing.h>

// Places on the surface that quads should come close to: large quads cut off sharp or thin parts if
// their vertices lie elsewhere. The squared distances of a quad from the tangent planes of its
// places are a quadratic form of the displacement of each vertex.

#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The quadratic form d A d - 2 b d of a displacement d.
struct Distance_form
{
  std::array<Space_vector, 3> matrix{}; // A
  Space_vector vector{};                // b

  // Adds a place that moves by `share` of the displacement, and lies `distance` below a plane.
  void add(const Space_vector& normal, const double share, const double distance)
  {
    for(std::size_t c = 0; c < 3; ++c) {
      for(std::size_t d = 0; d < 3; ++d)
        matrix[c][d] += share * share * normal[c] * normal[d];
      vector[c] += share * distance * normal[c];
    }
  }

  double value(const Space_vector& d) const
  {
    double result = -2 * inner_product(vector, d);
    for(std::size_t c = 0; c < 3; ++c)
      result += d[c] * inner_product(matrix[c], d);
    return result;
  }

  // A displacement that lowers the value, not too long.
  Space_vector descent() const
  {
    const double trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    Space_vector result{};
    for(std::size_t c = 0; c < 3 && trace > 0; ++c)
      result[c] = vector[c] / trace;
    return result;
  }
};

class Surface_samples
  : private Remeshing_types
{
  using Tree = Nearest_place_tree<Space_triangle>;

public:
  // Spread evenly over the area.
  Surface_samples(const Mesh& surface, const std::size_t number) : m_surface(surface)
  {
    std::vector<Space_triangle> triangles;
    for(const auto f : faces(surface)) {
      triangles.push_back(triangle_of(surface, f));
      m_area += norm(area_vector(triangles.back())) / 2;
    }
    std::size_t f = 0;
    double area_so_far = 0; // of the faces before f
    for(std::size_t k = 0; k < number; ++k) {
      const double goal = (double(k) + 0.5) / double(number) * m_area;
      for(double area; f + 1 < triangles.size() &&
                       area_so_far + (area = norm(area_vector(triangles[f])) / 2) < goal; ++f)
        area_so_far += area;
      add(triangles[f], k);
    }
  }

  // Per vertex of the quads: of the places whose nearest triangle of a quad has it as a corner. The
  // sum of all squares is the sum for distances in units of an edge, as a mean over each quad.
  // \param far_ones_count_more by 1 plus their squared distance, in the same units
  std::vector<Distance_form> distance_forms(const Mesh& quads, const bool far_ones_count_more) const
  {
    std::vector<Distance_form> forms(quads.num_vertices()); // also of removed ones
    std::vector<Space_triangle> triangles;
    std::vector<std::array<Vertex, 3> > corners;
    add_triangles(quads, triangles, corners);
    if(triangles.empty() || m_places.empty())
      return forms;
    const Tree tree(triangles);
    const double quads_of_each = double(quads.number_of_faces()) / double(m_places.size());
    const double scale = quads_of_each * double(quads.number_of_faces()) / m_area;
    for(const Place& place : m_places) {
      const auto nearest = tree.nearest(place.point);
      const Space_vector& p = nearest.point;
      const Space_triangle& t = triangles[nearest.element];
      const Space_vector area = area_vector(t);
      if(inner_product(area, place.normal) <= 0) // the other side of a thin part
        continue;
      const double distance = scale / quads_of_each * nearest.squared_distance;
      const double weight = scale * (far_ones_count_more ? 1 + distance : 1);
      const Space_vector n = between({}, place.normal, std::sqrt(weight));
      for(std::size_t i = 0; i < 3; ++i) {
        const Space_vector across = area_vector({p, t[(i + 1) % 3], t[(i + 2) % 3]});
        const double share = inner_product(across, area) / inner_product(area, area);
        forms[corners[nearest.element][i]].add(n, share,
                                               inner_product(n, vector_to(p, place.point)));
      }
    }
    return forms;
  }

  // The largest distance of a place, or of a vertex of the surface, from the quads.
  double largest_distance(const Mesh& quads) const
  {
    std::vector<Space_triangle> triangles;
    std::vector<std::array<Vertex, 3> > corners;
    add_triangles(quads, triangles, corners);
    if(triangles.empty())
      return std::numeric_limits<double>::infinity();
    const Tree tree(triangles);
    std::vector<Point> points;
    for(const Place& place : m_places)
      points.push_back(to_point(place.point));
    for(const Vertex v : vertices(m_surface))
      if(!m_surface.is_isolated(v))
        points.push_back(m_surface.point(v));
    CGAL::hilbert_sort(points.begin(), points.end(), CGAL::Hilbert_sort_middle_policy());
    Tree::Largest_distance result(tree);
    for(const Point& point : points)
      result.add(to_vector(point));
    return result.value();
  }

private:
  // The k-th place, in the triangle where it falls. Successive ones lie far apart in triangles.
  void add(const Space_triangle& t, const std::size_t k)
  {
    double x = std::fmod(0.7548776662466927 * double(k), 1);
    double y = std::fmod(0.5698402909980532 * double(k), 1);
    if(x + y > 1) {
      x = 1 - x;
      y = 1 - y;
    }
    const Space_vector normal = scaled_to_one(area_vector(t));
    if(normal == Space_vector{})
      return;
    Space_vector p = t[0];
    for(std::size_t c = 0; c < 3; ++c)
      p[c] += x * (t[1][c] - t[0][c]) + y * (t[2][c] - t[0][c]);
    m_places.push_back({p, normal});
  }

  static void add_triangles(const Mesh& quads, std::vector<Space_triangle>& triangles,
                            std::vector<std::array<Vertex, 3> >& corners)
  {
    for(const auto f : faces(quads))
      for(const auto h : {halfedge(f, quads), next(next(halfedge(f, quads), quads), quads)}) {
        const std::array<Vertex, 3> v{source(h, quads), target(h, quads),
                                      target(next(h, quads), quads)};
        const Space_triangle t{to_vector(quads.point(v[0])), to_vector(quads.point(v[1])),
                               to_vector(quads.point(v[2]))};
        if(area_vector(t) != Space_vector{}) {
          triangles.push_back(t);
          corners.push_back(v);
        }
      }
  }

  struct Place
  {
    Space_vector point;
    Space_vector normal; // of length 1
  };

  const Mesh& m_surface;
  std::vector<Place> m_places;
  double m_area = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_SAMPLES_H
