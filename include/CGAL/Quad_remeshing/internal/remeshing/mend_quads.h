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

// The last resort for quads that are inverted or upside down: their vertices leave the features,
// and then the surface, by as little as helps. Exact signs decide whether it does.

#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Quad_star.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: no quad becomes inverted, or turns to the other side of the surface.
class Quad_mender
  : private Remeshing_types
{
  using Corners = Quad_star::Corners;

  enum class Freedom
  {
    SURFACE_INSIDE, // vertices that are on no feature or border move along the surface
    SURFACE,        // all do
    SPACE           // all move in all directions, but stay in a plane
  };

public:
  // \param is_feature whether an edge is a feature or border
  Quad_mender(Mesh& quads, const Feature_map& is_feature, Quad_smoother& smoother,
              const bool has_single_precision)
    : m_quads(quads), m_is_feature(is_feature), m_smoother(smoother),
      m_star(quads, smoother, has_single_precision),
      m_normal_of_plane(smoother.surface().unit_normal_of_plane())
  { }

  // At most 36 attempts for each quad, of at most 40 rounds over its vertices; and `most_moves` of
  // a vertex in all. Each looks at about a hundred places in space, or at a third as many on the
  // surface.
  // \param with_neighbors whether the vertices of the quads around move, too
  void run(const bool with_neighbors)
  {
    for(auto it = m_displaced.begin(); it != m_displaced.end();)
      it = m_quads.is_removed(it->first) ? m_displaced.erase(it) : std::next(it);
    m_edge_length = mean_edge_length();
    for(const Face f : faces(m_quads))
      if(m_smoother.is_bad(f))
        mend(f, with_neighbors);
  }

  // If at most ten quads are bad even then: around each, up to eight quads away, all vertices but
  // those on the border move to the middle of their neighbors, along the surface, and what is bad
  // there is mended, if fewer are bad then.
  // \param number_of_bad_quads counts them, and tells the smoother of each
  template <typename Count>
  void relax(const Count& number_of_bad_quads)
  {
    std::size_t least = number_of_bad_quads();
    if(least > most_to_relax)
      return;
    const auto is_bad = [&](const Face f) { return m_smoother.is_bad(f); };
    std::vector<Face> bad;
    std::copy_if(faces(m_quads).begin(), faces(m_quads).end(), std::back_inserter(bad), is_bad);
    for(const Face f : bad)
      for(std::size_t rings = 1; rings <= most_rings && is_bad(f); rings *= 2) {
        const std::vector<Mesh::Point> points(m_quads.points().begin(), m_quads.points().end());
        const auto displaced = m_displaced;
        relax_around(f, rings);
        if(number_of_bad_quads() > 0)
          run(true);
        if(const std::size_t number = number_of_bad_quads(); number < least)
          least = number;
        else {
          std::copy(points.begin(), points.end(), m_quads.points().begin());
          m_displaced = displaced;
          number_of_bad_quads();
        }
      }
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
  double mean_edge_length() const
  {
    double sum = 0;
    for(const auto e : edges(m_quads))
      sum += norm(vector_to(m_smoother.point(source(e, m_quads)),
                            m_smoother.point(target(e, m_quads))));
    return sum / double(m_quads.number_of_edges());
  }

  void mend(const Face f, const bool with_neighbors)
  {
    collect(f, with_neighbors ? 1 : 0);
    double longest = 0;
    const Quad q = m_smoother.quad(f);
    for(std::size_t k = 0; k < 4; ++k)
      longest = (std::max)(longest, norm(vector_to(q[k], q[(k + 1) % 4])));
    m_star.has_to_be_mended(f);
    // as far as a long edge reaches only where less does not help
    if(!improve_within((std::min)(longest, m_edge_length)) && longest > m_edge_length)
      improve_within(longest);
  }

  // The vertices of a quad, and of the quads around it up to a number of rings.
  void collect(const Face f, const std::size_t rings)
  {
    m_vertices.clear();
    m_places.clear();
    add_vertices(f);
    m_star.collect(m_vertices);
    for(std::size_t i = 0; i < rings; ++i) {
      for(const Face g : m_star.faces())
        add_vertices(g);
      m_star.collect(m_vertices);
    }
  }

  // Vertices may be off the surface, so that no search for the nearest place can begin at them.
  void relax_around(const Face f, const std::size_t rings)
  {
    collect(f, rings);
    for(int round = 0; round < most_rounds; ++round)
      for(const Vertex v : m_vertices)
        if(!m_quads.is_border(v))
          m_star.set_point(v, m_smoother.surface().nearest(m_smoother.middle_of_neighbors(v)));
    note_displacements(Freedom::SURFACE);
  }

  bool improve_within(const double size)
  {
    for(const double part : {1e-4, 1e-3, 1e-2, 0.05, 0.2, 0.5})
      for(const Freedom freedom : {Freedom::SURFACE_INSIDE, Freedom::SURFACE, Freedom::SPACE})
        if(improve(part * size, freedom))
          return true;
    return false;
  }

  void add_vertices(const Face f)
  {
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      if(std::find(m_vertices.begin(), m_vertices.end(), v) == m_vertices.end()) {
        m_vertices.push_back(v);
        m_places.push_back(m_smoother.point(v));
      }
  }

  // Returns whether the face is no longer bad, and all around it as good as before; else the
  // vertices stay where they were.
  bool improve(const double radius, const Freedom freedom)
  {
    double least = m_star.energy(Corners::FLAT);
    for(int round = 0; round < most_rounds && least > 0; ++round) {
      const double before = least;
      for(std::size_t i = 0; i < m_vertices.size() && m_moves_left > 0; ++i)
        move(i, radius, freedom);
      least = m_star.energy(Corners::FLAT);
      if(!(least < 0.999 * before))
        break;
    }
    if(m_star.is_mended()) {
      note_displacements(freedom);
      return true;
    }
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_smoother.set_point(m_vertices[i], m_places[i]);
    return false;
  }

  // To the best of places in eight directions along the surface, or in all directions of space.
  void move(const std::size_t i, const double radius, const Freedom freedom)
  {
    const Vertex v = m_vertices[i];
    double least = m_star.energy_around(i, Corners::FLAT);
    if(least == 0 || (freedom == Freedom::SURFACE_INSIDE && is_on_line(v)))
      return;
    --m_moves_left;
    const Space_vector from = m_smoother.point(v);
    const auto plane = m_smoother.visit_star(v, [](Face, const Quad&, const Space_vector&) { });
    Space_vector best = from;
    const auto try_place = [&](const Space_vector& p) {
      if(norm(vector_to(m_places[i], p)) > radius)
        return;
      m_star.set_point(v, p);
      const double now = m_star.energy_around(i, Corners::FLAT);
      if(now < least) {
        least = now;
        best = m_smoother.point(v);
      }
    };
    for(double step = radius; step > radius / 100; step /= 4)
      if(freedom == Freedom::SPACE)
        for(const Space_vector& d : directions())
          try_place(moved(from, d, step));
      else
        for(const Space_vector& d : plane.directions(step))
          try_place(m_smoother.surface().nearest(moved(from, d, 1)));
    m_smoother.set_point(v, best);
  }

  // The point moves by a multiple of a vector, within the plane of the surface if it has one.
  Space_vector moved(Space_vector p, const Space_vector& d, const double step) const
  {
    const double across = inner_product(d, m_normal_of_plane);
    for(std::size_t c = 0; c < 3; ++c)
      p[c] += step * (d[c] - across * m_normal_of_plane[c]);
    return p;
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

  bool is_on_line(const Vertex v) const
  { return !lines_at_vertex(m_quads, m_is_feature, v).empty(); }

  void note_displacements(const Freedom freedom)
  {
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      if(m_smoother.point(m_vertices[i]) != m_places[i] &&
         (freedom == Freedom::SPACE || is_on_line(m_vertices[i])))
        m_displaced.emplace(m_vertices[i], m_places[i]);
  }

  static constexpr int most_rounds = 40; // rounds of relaxing around a quad
  static constexpr int most_moves = 20000; // moves of vertices, in all
  static constexpr std::size_t most_to_relax = 10; // inverted or folded quads
  static constexpr std::size_t most_rings = 8; // rings of quads around an inverted one

  Mesh& m_quads;
  Feature_map m_is_feature;
  Quad_smoother& m_smoother;
  Quad_star m_star; // of the vertices that move
  Space_vector m_normal_of_plane; // 0 where the surface is none
  int m_moves_left = most_moves;
  double m_edge_length = 0;                   // the mean one
  std::map<Vertex, Space_vector> m_displaced; // and where they were
  std::vector<Vertex> m_vertices;             // that move
  std::vector<Space_vector> m_places;         // of these, before
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MEND_QUADS_H
