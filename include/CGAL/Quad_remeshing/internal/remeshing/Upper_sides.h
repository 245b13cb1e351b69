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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_UPPER_SIDES_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_UPPER_SIDES_H

#include <CGAL/license/Quad_remeshing.h>

// Which quads lie upside down on the surface. The nearest part of the surface in space may be
// another part, so walks over the surface find the places below a quad, from the places of its
// corners at the extraction.

#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Upper_sides
  : private Remeshing_types
{
public:
  // \pre the vertices of the quads lie on the surface, and have not moved since
  // \param is_feature whether an edge of the quads is a feature or border
  Upper_sides(Mesh& quads, const Feature_map& is_feature, const Surface_to_remesh& surface,
              const Quad_smoother& smoother)
    : m_quads(quads), m_is_feature(is_feature), m_surface(surface), m_smoother(smoother),
      m_starts(quads.add_property_map<Vertex, Face>("v:face_of_surface").first)
  {
    for(const Vertex v : vertices(quads))
      m_starts[v] = nearest_face(v);
  }

  // Whether a quad faces against the surface below it, on the average and clearly: one that is as
  // large as a thin part has all sides of that below it. And against what is nearest, or the quads
  // beside it.
  bool is_folded(const Face f) const
  {
    constexpr double clearly = -0.5; // a cosine where the surface below is flat
    const Quad q = m_smoother.quad(f);
    return is_suspicious(f, q) &&
           inner_product(scaled_to_one(quad_normal(q)), upper_side(f, q)) < clearly;
  }

  // Tells the smoother where the quads are to face that are inverted or upside down: as the surface
  // does on the average. Returns their number.
  std::size_t update()
  {
    std::size_t number = 0;
    for(const Face f : faces(m_quads)) {
      const Quad q = m_smoother.quad(f);
      m_smoother.upper_sides()[f] = Space_vector{};
      if(is_folded(f) || is_inverted(q)) {
        m_smoother.upper_sides()[f] = upper_side(f, q);
        ++number;
      }
    }
    return number;
  }

private:
  const Mesh& mesh() const { return m_surface.mesh(); }

  // Whether it faces against what is nearest, or against most of the quads beside it. Walks alone
  // may be wrong where a vertex has come to a feature, and over it.
  bool is_suspicious(const Face f, const Quad& q) const
  {
    const Space_vector own = quad_normal(q);
    int against = 0, along = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_quads), m_quads))
      if(const Face other = face(opposite(h, m_quads), m_quads); other != Mesh::null_face())
        ++(inner_product(own, quad_normal(m_smoother.quad(other))) < 0 ? against : along);
    return against > along || inner_product(own, m_smoother.normal_of_surface(q)) < 0;
  }

  // Where a vertex lies, up to single precision, on the part of the surface that it comes from; the
  // nearest face if it has left that part, or came later.
  Face face_of_surface(const Vertex v) const
  {
    const Space_vector p = m_smoother.point(v);
    if(m_starts[v] != Mesh::null_face()) {
      const Face f = walk(m_starts[v], p);
      if(squared_distance_to(p, f) < 1e-12)
        return f;
    }
    return nearest_face(v);
  }

  Face nearest_face(const Vertex v) const
  {
    const auto ignore = [](Face, const Quad&, const Space_vector&) { };
    return m_smoother.nearest_face(m_smoother.point(v), m_smoother.visit_star(v, ignore).normal);
  }

  std::vector<Face> faces_of_corners(const Face f) const
  {
    std::vector<Face> starts, starts_on_lines;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      (lines_at_vertex(m_quads, m_is_feature, v).empty() ? starts : starts_on_lines)
        .push_back(face_of_surface(v));
    return starts.empty() ? starts_on_lines : starts;
  }

  // The middle, and half way from there to each corner.
  static std::array<Space_vector, 5> places(const Quad& q)
  {
    std::array<Space_vector, 5> result;
    for(std::size_t c = 0; c < 3; ++c)
      result[0][c] = (q[0][c] + q[1][c] + q[2][c] + q[3][c]) / 4;
    for(std::size_t i = 0; i < 4; ++i)
      result[i + 1] = between(result[0], q[i], 0.5);
    return result;
  }

  // Where the surface faces below a quad: at its middle, and half way from there to each corner, as
  // walks from all corners find it, or from those that are on no feature; the mean of the unit
  // normals.
  Space_vector upper_side(const Face f, const Quad& q) const
  {
    Space_vector mean{};
    const std::vector<Face> starts = faces_of_corners(f);
    const std::array<Space_vector, 5> below = places(q);
    for(const Face start : starts)
      for(const Space_vector& p : below) {
        const Space_vector n = scaled_to_one(m_smoother.normal_of_surface(walk(start, p)));
        for(std::size_t c = 0; c < 3; ++c)
          mean[c] += n[c] / double(starts.size() * below.size());
      }
    return mean;
  }

  // To where no face around is nearer to a point; not over features.
  Face walk(const Face start, const Space_vector& p) const
  {
    Face best = start;
    double least = squared_distance_to(p, best);
    for(Face last = Mesh::null_face(); last != best;) {
      last = best;
      for_neighbors(last, [&](const Face f) {
        if(const double d = squared_distance_to(p, f); d < least) {
          least = d;
          best = f;
        }
      });
    }
    return best;
  }

  double squared_distance_to(const Space_vector& p, const Face f) const
  { return squared_distance(p, nearest_place(p, triangle_of(mesh(), f))); }

  // Around the corners of a face, in both directions.
  template <typename Visit>
  void for_neighbors(const Face f, const Visit& visit) const
  {
    for(const Halfedge h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
      for(const bool goes_on : {false, true})
        for(Halfedge g = h;;) {
          const Halfedge side = goes_on ? mesh().next(g) : g;
          if(m_surface.is_feature()[mesh().edge(side)] || mesh().is_border(mesh().edge(side)))
            break;
          g = goes_on ? mesh().opposite(side) : mesh().prev(mesh().opposite(side));
          if(g == h)
            break;
          visit(mesh().face(g));
        }
  }

  const Mesh& m_quads;
  Feature_map m_is_feature;
  const Surface_to_remesh& m_surface;
  const Quad_smoother& m_smoother;
  Mesh::Property_map<Vertex, Face> m_starts; // of the surface
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_UPPER_SIDES_H
