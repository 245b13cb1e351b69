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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MEND_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MEND_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// The last resort for quads that are inverted: their vertices leave the features, and where that is
// not enough the surface, by as little as helps. Exact signs decide whether it does.

#include <CGAL/Linear_snapping/internal/exact/rounded_to.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: no quad becomes inverted, or turns to the other side of the surface.
class Quad_mender
{
  using Mesh = Surface_to_remesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;
  using Feature_map = Surface_to_remesh::Feature_map;
  using Quad = Quad_smoother::Quad;

  enum class Freedom
  {
    SURFACE_INSIDE, // vertices that are on no feature or border move along the surface
    SURFACE,        // all do
    SPACE           // all move in all directions
  };

public:
  // \param has_single_precision whether points are to be of single precision
  Quad_mender(Mesh& quads, const Feature_map& is_feature, Quad_smoother& smoother,
              const bool has_single_precision)
    : m_quads(quads), m_is_feature(is_feature), m_smoother(smoother),
      m_has_single_precision(has_single_precision)
  { }

  // At most 18 attempts for each quad, of at most 40 rounds over its vertices.
  void run()
  {
    for(const Face f : faces(m_quads))
      if(is_inverted(m_smoother.quad(f)))
        mend(f);
  }

  // Vertices that have left features, borders, or the surface, and the largest distance by which
  // they have moved.
  std::size_t number_of_displaced_vertices() const { return m_displaced.size(); }
  double largest_displacement() const
  {
    double result = 0;
    for(const auto& [v, place] : m_displaced)
      result = (std::max)(result, norm(vector_to(place, m_smoother.point(v))));
    return result;
  }

private:
  void mend(const Face f)
  {
    collect(f);
    double longest = 0;
    const Quad q = m_smoother.quad(f);
    for(std::size_t k = 0; k < 4; ++k)
      longest = (std::max)(longest, norm(vector_to(q[k], q[(k + 1) % 4])));
    for(const double part : {1e-4, 1e-3, 1e-2, 0.05, 0.2, 0.5})
      for(const Freedom freedom : {Freedom::SURFACE_INSIDE, Freedom::SURFACE, Freedom::SPACE})
        if(improve(part * longest, freedom))
          return;
  }

  // The vertices of the face, and all faces around them.
  void collect(const Face f)
  {
    m_vertices.clear();
    m_places.clear();
    m_star.clear();
    m_upper_side.clear();
    m_was_inverted.clear();
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads)) {
      m_vertices.push_back(v);
      m_places.push_back(m_smoother.point(v));
      for(const Face g : CGAL::faces_around_target(halfedge(v, m_quads), m_quads))
        if(g != Mesh::null_face() && std::find(m_star.begin(), m_star.end(), g) == m_star.end())
          m_star.push_back(g);
    }
    for(const Face g : m_star) {
      const Quad q = m_smoother.quad(g);
      m_upper_side.push_back(upper_side_or_own(q, m_smoother.normal_of_surface(q)));
      m_was_inverted.push_back(is_inverted(q));
    }
    m_was_inverted[std::size_t(std::find(m_star.begin(), m_star.end(), f) - m_star.begin())] =
      false; // is not to be any more
  }

  // Returns whether the face is no longer inverted, and all around it as good as before; else the
  // vertices stay where they were.
  bool improve(const double radius, const Freedom freedom)
  {
    double least = badness();
    for(int round = 0; round < most_rounds && least > 0; ++round) {
      const double before = least;
      for(std::size_t i = 0; i < m_vertices.size(); ++i)
        move(i, radius, freedom, least);
      if(!(least < 0.999 * before))
        break;
    }
    if(is_mended()) {
      note_displacements(freedom);
      return true;
    }
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_smoother.set_point(m_vertices[i], m_places[i]);
    return false;
  }

  // The best of some steps, which lowers `least`.
  void move(const std::size_t i, const double radius, const Freedom freedom, double& least)
  {
    const Vertex v = m_vertices[i];
    if(freedom == Freedom::SURFACE_INSIDE && is_on_line(v))
      return;
    const Space_vector from = m_smoother.point(v);
    Space_vector best = from;
    for(double step = radius; step > radius / 100; step /= 4)
      for(const Space_vector& d : directions()) {
        Space_vector p = from;
        for(std::size_t c = 0; c < 3; ++c)
          p[c] += step * d[c];
        if(freedom != Freedom::SPACE)
          p = m_smoother.nearest(p, from);
        if(norm(vector_to(m_places[i], p)) > radius)
          continue;
        set_point(v, p);
        const double now = badness();
        if(now < least) {
          least = now;
          best = m_smoother.point(v);
        }
      }
    m_smoother.set_point(v, best);
  }

  void set_point(const Vertex v, Space_vector p)
  {
    if(m_has_single_precision)
      for(double& x : p)
        x = rounded_to<float>(x);
    m_smoother.set_point(v, p);
  }

  // To the faces, edges and corners of a cube.
  static const std::vector<Space_vector>& directions()
  {
    static const std::vector<Space_vector> result = [] {
      std::vector<Space_vector> all;
      for(int x = -1; x <= 1; ++x)
        for(int y = -1; y <= 1; ++y)
          for(int z = -1; z <= 1; ++z)
            if(x != 0 || y != 0 || z != 0) {
              const double length = std::hypot(x, y, z);
              all.push_back({x / length, y / length, z / length});
            }
      return all;
    }();
    return result;
  }

  // 0 where all have a shape that is good enough. Quads that turn over are worst of all.
  double badness() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_star.size(); ++i) {
      const Quad q = m_smoother.quad(m_star[i]);
      const Space_vector normal = quad_normal(q);
      const double missing = good_enough - scaled_jacobian(q, normal);
      sum += missing > 0 ? missing * missing : 0;
      sum += inner_product(normal, m_upper_side[i]) > 0 ? 0 : 4;
    }
    return sum;
  }

  bool is_mended() const
  {
    for(std::size_t i = 0; i < m_star.size(); ++i) {
      const Quad q = m_smoother.quad(m_star[i]);
      if((!m_was_inverted[i] && is_inverted(q)) ||
         !(inner_product(quad_normal(q), m_upper_side[i]) > 0))
        return false;
    }
    return true;
  }

  bool is_on_line(const Vertex v) const
  {
    for(const auto h : CGAL::halfedges_around_target(v, m_quads))
      if(m_is_feature[m_quads.edge(h)])
        return true;
    return false;
  }

  void note_displacements(const Freedom freedom)
  {
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      if(m_smoother.point(m_vertices[i]) != m_places[i] &&
         (freedom == Freedom::SPACE || is_on_line(m_vertices[i])))
        m_displaced.emplace(m_vertices[i], m_places[i]);
  }

  static constexpr double good_enough = 0.02; // as a scaled Jacobian
  static constexpr int most_rounds = 40;

  Mesh& m_quads;
  Feature_map m_is_feature;
  Quad_smoother& m_smoother;
  bool m_has_single_precision;
  std::map<Vertex, Space_vector> m_displaced; // and where they were
  // scratch: of the face that is mended
  std::vector<Vertex> m_vertices;
  std::vector<Space_vector> m_places; // of the vertices, before
  std::vector<Face> m_star;
  std::vector<Space_vector> m_upper_side; // of these faces
  std::vector<char> m_was_inverted;       // of these faces
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MEND_QUADS_H
