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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// Five quads in place of one that is inverted or flat: a small one inside, and four around it. So
// two quads share each of its corners. This helps if no move of vertices can, because two features
// that the quad turns around are a straight line in space, or more than that.

#include <CGAL/Quad_remeshing/internal/remeshing/Quad_star.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: vertices and edges that are there stay, and what they are. New vertices are on the
// surface, new edges are no features.
class Quad_divider
  : private Remeshing_types
{
public:
  Quad_divider(Mesh& quads, const Feature_map& is_feature, Quad_smoother& smoother)
    : m_quads(quads), m_is_feature(is_feature), m_smoother(smoother)
  { }

  // Returns the number of quads that were divided.
  std::size_t run()
  {
    std::vector<Face> bad;
    for(const Face f : faces(m_quads))
      if(scaled_jacobian(m_smoother.quad(f)) < flat_quad)
        bad.push_back(f);
    std::size_t result = 0;
    for(const Face f : bad) {
      Quad inner;
      if(find_inner_quad(m_smoother.quad(f), inner)) {
        divide(f, inner);
        ++result;
      }
    }
    return result;
  }

private:
  // The best of some: on rays from a point of a diagonal, longer towards one of its ends; or else
  // where these come to by moves. Returns false if none has quads that face as the surface.
  bool find_inner_quad(const Quad& q, Quad& inner) const
  {
    const double before = (std::max)(0., scaled_jacobian(q));
    double best = before;
    std::vector<std::pair<double, Quad> > starts;
    for(std::size_t i = 0; i < 4; ++i)
      for(const double along : {0.35, 0.5, 0.65})
        for(const double towards_end : {0.4, 0.6, 0.8})
          for(const double towards_others : {0.25, 0.5}) {
            const Space_vector middle = between(q[i], q[(i + 2) % 4], along);
            Quad p;
            for(std::size_t k = 0; k < 4; ++k)
              p[k] = m_smoother.surface().nearest(
                between(middle, q[k], k == i ? towards_end : towards_others), q[k]);
            consider(q, p, best, inner);
            if(best < flat_quad)
              starts.emplace_back(energy(q, p), p);
          }
    std::sort(starts.begin(), starts.end());
    for(std::size_t i = 0; i < starts.size() && i < most_starts && best < flat_quad; ++i) {
      move_inner_quad(q, starts[i].second);
      consider(q, starts[i].second, best, inner);
    }
    return best > before;
  }

  void consider(const Quad& q, const Quad& p, double& best, Quad& inner) const
  {
    const std::array<Quad, 5> five = five_quads(q, p);
    const double least = least_scaled_jacobian(five);
    if(least > best && face_upwards(five)) {
      best = least;
      inner = p;
    }
  }

  // Moves the corners of the inner quad along the surface, each by smaller steps as none helps.
  void move_inner_quad(const Quad& q, Quad& p) const
  {
    double least = energy(q, p);
    for(double step = norm(vector_to(q[0], q[2])) / 4, end = step / 100; step > end;) {
      bool has_changed = false;
      for(Space_vector& corner : p)
        for(std::size_t c = 0; c < 3; ++c)
          for(const double sign : {1., -1.}) {
            const Space_vector old = corner;
            corner[c] += sign * step;
            corner = m_smoother.surface().nearest(corner, old);
            const double now = energy(q, p);
            if(now < 0.99 * least) {
              least = now;
              has_changed = true;
            } else {
              corner = old;
            }
          }
      step = has_changed ? step : step / 2;
    }
  }

  static double energy(const Quad& q, const Quad& p)
  {
    double sum = 0;
    for(const Quad& r : five_quads(q, p))
      sum += energy_of_corner(scaled_jacobian(r));
    return sum;
  }

  static std::array<Quad, 5> five_quads(const Quad& outer, const Quad& inner)
  {
    std::array<Quad, 5> result{inner};
    for(std::size_t k = 0; k < 4; ++k) {
      const std::size_t l = (k + 1) % 4;
      result[k + 1] = {outer[k], outer[l], inner[l], inner[k]};
    }
    return result;
  }

  static double least_scaled_jacobian(const std::array<Quad, 5>& all)
  {
    double result = 1;
    for(const Quad& q : all)
      result = (std::min)(result, scaled_jacobian(q));
    return result;
  }

  bool face_upwards(const std::array<Quad, 5>& all) const
  {
    return std::all_of(all.begin(), all.end(), [&](const Quad& q) {
      return inner_product(quad_normal(q), m_smoother.surface().normal(q)) > 0;
    });
  }

  // A vertex in the middle, one on each edge to it, edges between these; and that in the middle is
  // taken out again.
  void divide(const Face f, const Quad& inner)
  {
    std::array<Halfedge, 4> sides;
    std::size_t k = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_quads), m_quads))
      sides[k++] = h;
    CGAL::Euler::add_center_vertex(sides[0], m_quads);
    const Vertex center = target(next(sides[0], m_quads), m_quads);
    for(k = 0; k < 4; ++k) {
      const Halfedge h = CGAL::Euler::split_edge(next(sides[k], m_quads), m_quads);
      m_smoother.set_point(target(h, m_quads), inner[k]);
    }
    for(const Halfedge h : sides)
      CGAL::Euler::split_face(next(h, m_quads), prev(prev(h, m_quads), m_quads), m_quads);
    CGAL::Euler::remove_center_vertex(halfedge(center, m_quads), m_quads);
    for(const Halfedge h : sides) {
      const Halfedge inwards = next(h, m_quads);
      put(m_is_feature, edge(inwards, m_quads), false);
      put(m_is_feature, edge(next(inwards, m_quads), m_quads), false);
    }
  }

    static constexpr std::size_t most_starts = 6; // places of the inner quad

  Mesh& m_quads;
  Feature_map m_is_feature;
  Quad_smoother& m_smoother;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_DIVIDE_QUADS_H
