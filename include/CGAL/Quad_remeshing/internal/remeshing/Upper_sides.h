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

// Which quads are folded: they, or a corner of them, lie upside down on the surface, or they turn
// back on a neighbor although the surface does not. The nearest part of the surface in space may be
// another part, so walks over the surface find the places below a quad, from the places of its
// corners at the extraction.

#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
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

  // Each takes about as long as a search for the nearest place.
  std::size_t number_of_walks() const { return m_number_of_walks; }

  bool is_folded(const Face f) const
  {
    return is_upside_down(f) || is_bow_tie(f, clearly_against) ||
           side_that_it_turns_from(f) != Space_vector{};
  }

  // Tells the smoother where the quads are to face that are inverted or folded: as the surface does
  // on the average, or as the quad does on which they turn back. Returns their number.
  std::size_t update()
  {
    std::size_t number = 0;
    for(const Face f : faces(m_quads)) {
      const Quad q = m_smoother.quad(f);
      const bool is_bad =
        is_upside_down(f) || is_bow_tie(f, slightly_against) || is_inverted(q);
      const Space_vector side = is_bad ? upper_side(f, q) : side_that_it_turns_from(f);
      m_smoother.upper_sides()[f] = side;
      number += is_bad || side != Space_vector{};
    }
    return number;
  }

private:
  // Unit normals of the surface below a quad.
  struct Normals
  {
    std::vector<Quad> around; // the quads around its corners when the normals were found
    std::vector<Space_vector> by_walks;
    std::vector<Space_vector> others; // at the corners, and where the surface is nearest
  };

  const Mesh& mesh() const { return m_surface.mesh(); }

  // Whether a quad faces against the surface below it, on the average and clearly: one that is as
  // large as a thin part has all sides of that below it. And against what is nearest, or the quads
  // beside it.
  bool is_upside_down(const Face f) const
  {
    constexpr double clearly = -0.5; // a cosine where the surface below is flat
    const Quad q = m_smoother.quad(f);
    return is_suspicious(f, q) &&
           inner_product(scaled_to_one(quad_normal(q)), upper_side(f, q)) < clearly;
  }

  // Whether a corner faces against all of the surface below the quad.
  bool is_bow_tie(const Face f, const double bound) const
  {
    constexpr double bent = 0.5; // a scaled Jacobian; those of bow ties are near 0
    const Quad q = m_smoother.quad(f);
    if(scaled_jacobian(q) >= bent)
      return false;
    const Normals& below = normals_below(f, q);
    const auto is_against = [&](const Space_vector& n) { return has_corner_against(q, n, bound); };
    return std::all_of(below.by_walks.begin(), below.by_walks.end(), is_against) &&
           std::all_of(below.others.begin(), below.others.end(), is_against);
  }

  // If a quad and one beside it turn back on each other, and this one faces at least as far from
  // the surface: the normal of the other one; else 0. Quads turn about as far as the surface does.
  // A turn inward is compared with the mean normals below the two quads. The rim of a part that is
  // thin against quads turns outward, and farther than these, so there any two normals excuse it.
  Space_vector side_that_it_turns_from(const Face f) const
  {
    constexpr double farther = 1.25; // a difference of cosines: 105 degrees on a flat surface
    constexpr double clear = 0.1; // the length of a mean of unit normals that tells a direction
    const Quad q = m_smoother.quad(f);
    const Space_vector own = scaled_to_one(quad_normal(q));
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_quads), m_quads)) {
      const Face g = face(opposite(h, m_quads), m_quads);
      if(g == Mesh::null_face())
        continue;
      const Quad other = m_smoother.quad(g);
      const Space_vector normal = scaled_to_one(quad_normal(other));
      const double least = inner_product(own, normal) + farther; // cosine of the surface
      if(least >= 1)
        continue;
      const Space_vector side = upper_side(f, q), side_of_other = upper_side(g, other);
      const Space_vector mean = mean_of({side, side_of_other});
      if(inner_product(own, mean) > inner_product(normal, mean))
        continue;
      const bool is_clear = (std::min)(norm(side), norm(side_of_other)) > clear;
      const double turn_of_surface = is_clear && turns_inward(q, own, other, normal)
        ? inner_product(scaled_to_one(side), scaled_to_one(side_of_other))
        : least_cosine(normals_below(f, q), normals_below(g, other));
      if(least < turn_of_surface)
        return normal;
    }
    return {};
  }

  // Whether two quads face each other, as in a valley.
  static bool turns_inward(const Quad& q, const Space_vector& normal, const Quad& other,
                           const Space_vector& normal_of_other)
  {
    const Space_vector d = vector_to(places(q)[0], places(other)[0]);
    return inner_product(normal, d) > inner_product(normal_of_other, d);
  }

  // Whether it faces against what is nearest, or against most of the quads beside it. Walks alone
  // may be wrong where a vertex has come to a feature, and over it.
  bool is_suspicious(const Face f, const Quad& q) const
  {
    const Space_vector own = quad_normal(q);
    int against = 0, along = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_quads), m_quads))
      if(const Face other = face(opposite(h, m_quads), m_quads); other != Mesh::null_face())
        ++(inner_product(own, quad_normal(m_smoother.quad(other))) < 0 ? against : along);
    return against > along || inner_product(own, m_smoother.surface().normal(q)) < 0;
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
    return m_smoother.surface().nearest_face(m_smoother.point(v),
                                             m_smoother.visit_star(v, ignore).normal);
  }

  // The faces below the corners that lie on no feature: those of the others are on either side.
  std::vector<Face> faces_of_corners(const Face f) const
  {
    std::vector<Face> result;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      if(lines_at_vertex(m_quads, m_is_feature, v).empty())
        result.push_back(face_of_surface(v));
    return result;
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

  // Where the surface faces below a quad: the mean of the unit normals that walks find.
  Space_vector upper_side(const Face f, const Quad& q) const
  { return mean_of(normals_below(f, q).by_walks); }

  // The normals stay as they are until a vertex near by moves.
  const Normals& normals_below(const Face f, const Quad& q) const
  {
    std::vector<Quad> around;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      for(const Face g : CGAL::faces_around_target(halfedge(v, m_quads), m_quads))
        if(g != Mesh::null_face())
          around.push_back(m_smoother.quad(g));
    Normals& result = m_normals[f];
    if(around != result.around)
      result = {std::move(around), normals_by_walks(f, q), normals_at_corners_and_nearest(f, q)};
    return result;
  }

  // The normals below the middle of a quad, and half way from there to each corner; the nearest one
  // if no corner tells where to begin.
  std::vector<Space_vector> normals_by_walks(const Face f, const Quad& q) const
  {
    std::vector<Space_vector> result;
    for(const Face start : faces_of_corners(f))
      for(const Space_vector& p : places(q))
        result.push_back(unit_normal(walk(start, p)));
    if(result.empty())
      result.push_back(scaled_to_one(m_smoother.surface().normal(q)));
    return result;
  }

  std::vector<Space_vector> normals_at_corners_and_nearest(const Face f, const Quad& q) const
  {
    std::vector<Space_vector> result;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, m_quads), m_quads))
      result.push_back(unit_normal(face_of_surface(v)));
    for(const Space_vector& p : places(q))
      result.push_back(unit_normal(m_smoother.surface().nearest_face(p, quad_normal(q))));
    return result;
  }

  Space_vector unit_normal(const Face f) const
  { return scaled_to_one(m_smoother.surface().normal(f)); }

  static Space_vector mean_of(const std::vector<Space_vector>& vectors)
  {
    Space_vector mean{};
    for(const Space_vector& v : vectors)
      for(std::size_t c = 0; c < 3; ++c)
        mean[c] += v[c] / double(vectors.size());
    return mean;
  }

  // The least cosine of all normals below two quads: each may be wrong, and any excuses a turn.
  static double least_cosine(const Normals& a, const Normals& b)
  {
    std::vector<Space_vector> all;
    for(const Normals* const n : {&a, &b})
      for(const std::vector<Space_vector>* const normals : {&n->by_walks, &n->others})
        all.insert(all.end(), normals->begin(), normals->end());
    double result = 1;
    for(std::size_t i = 0; i < all.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        result = (std::min)(result, inner_product(all[i], all[j]));
    return result;
  }

  // To where no face around is nearer to a point; not over features.
  Face walk(const Face start, const Space_vector& p) const
  {
    ++m_number_of_walks;
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

  // Around the corners of a face, up to features.
  template <typename Visit>
  void for_neighbors(const Face f, const Visit& visit) const
  {
    for(const Halfedge h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
      if(!visit_around(h, false, visit))
        visit_around(h, true, visit);
  }

  // Visits the faces around the target of a halfedge in one direction, up to a feature. Returns
  // whether these are all faces there.
  template <typename Visit>
  bool visit_around(const Halfedge h, const bool is_clockwise, const Visit& visit) const
  {
    for(Halfedge g = h;;) {
      const Halfedge side = is_clockwise ? mesh().next(g) : g;
      if(m_surface.is_feature()[mesh().edge(side)] || mesh().is_border(mesh().edge(side)))
        return false;
      g = is_clockwise ? mesh().opposite(side) : mesh().prev(mesh().opposite(side));
      if(g == h)
        return true;
      visit(mesh().face(g));
    }
  }

  const Mesh& m_quads;
  Feature_map m_is_feature;
  const Surface_to_remesh& m_surface;
  const Quad_smoother& m_smoother;
  Mesh::Property_map<Vertex, Face> m_starts; // of the surface
  mutable std::size_t m_number_of_walks = 0;
  mutable std::map<Face, Normals> m_normals; // below quads
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_UPPER_SIDES_H
