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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_POLYGON_FILLER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_POLYGON_FILLER_H

#include <CGAL/license/Quad_remeshing.h>

// A polygon of a triangulated surface, laid out in the plane, and its triangulation anew. Flips and
// the removal of vertices are this same step.

#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// A side of the polygon: a halfedge with the polygon at its left, in the chart of the polygon.
struct Polygon_side
{
  Intrinsic_corner corner;
  Corner_index old_halfedge = no_index; // no_index: a diagonal, whose opposite is in place already
  Quarter_turns::Element turn = Quarter_turns::identity(); // from the chart of its old face
};

// Invariant: the sides are in counterclockwise order and form a simple polygon.
class Polygon_filler
{
public:
  Polygon_filler(const Integer_mesh& input, Intrinsic_complex& complex)
    : m_input(input), m_complex(complex)
  { }

  void clear()
  {
    m_sides.clear();
    m_placed.clear();
  }

  const Polygon_side& side(const std::size_t i) const { return m_sides[i]; }

  // The next side. `turn` leads from the chart of its face to the chart of the polygon.
  void add_side(const Corner_index h, const Quarter_turns::Element turn)
  {
    m_sides.push_back({m_complex.corner(h), h, turn});
    Intrinsic_corner& corner = m_sides.back().corner;
    const Quarter_turns::Element back = Quarter_turns::inverse(turn);
    corner.vector = rotated(turn, corner.vector);
    corner.units = rotated(turn, corner.units);
    corner.rotation = Quarter_turns::compose(corner.rotation, back);
    corner.departure.turns = Quarter_turns::compose(corner.departure.turns, back);
  }

  // Two collinear walls become one side. Its opposite side is the opposite of `linked`, which is
  // one of both. The face of the second wall has the chart of the polygon.
  void add_merged_side(const Corner_index first, const Quarter_turns::Element turn,
                       const Corner_index second, const Corner_index linked)
  {
    add_side(first, turn);
    Polygon_side& side = m_sides.back();
    const Intrinsic_corner& end = m_complex.corner(second);
    side.corner.vertex = end.vertex;
    side.corner.vector = sum(side.corner.vector, end.vector);
    side.corner.units = sum(side.corner.units, end.units);
    if(linked == second) {
      side.corner.opposite = end.opposite;
      side.corner.rotation = end.rotation;
      side.old_halfedge = second;
      side.turn = Quarter_turns::identity();
    }
  }

  // Whether sides i and i + 1 can be cut off by a diagonal.
  bool is_ear(const std::size_t i) const
  {
    const std::size_t j = next(i);
    const Grid_vector &ab = m_sides[i].corner.vector, &bc = m_sides[j].corner.vector;
    if(cross_sign(ab, bc) <= 0)
      return false;
    const Grid_vector ca = negated(sum(ab, bc));
    Grid_vector p = negated(ca); // a polygon's vertex, from a on
    for(std::size_t k = next(j); next(k) != i; k = next(k)) {
      p = sum(p, m_sides[k].corner.vector);
      if(cross_sign(ab, p) >= 0 && cross_sign(bc, difference(p, ab)) >= 0 && cross_sign(ca, p) >= 0)
        return false;
    }
    return true;
  }

  // Triangulates by ears, the roundest first. `faces` are to be filled, two fewer than there are
  // sides. Throws, before anything has changed, if a number doesn't fit.
  void fill(const std::vector<Flat_face_index>& faces)
  {
    check_sums();
    for(std::size_t f = 0; m_sides.size() > 3; ++f)
      cut_ear(roundest_ear(), faces[f]);
    finish(faces.back());
  }

  // Triangulates four sides by the diagonal that cuts off the sides i and i + 1.
  void fill(const std::size_t i, const Flat_face_index first, const Flat_face_index second)
  {
    cut_ear(i, first);
    finish(second);
  }

private:
  struct Placed
  {
    Corner_index old_halfedge, new_halfedge;
    Quarter_turns::Element turn;
  };

  std::size_t next(const std::size_t i) const { return i + 1 == m_sides.size() ? 0 : i + 1; }

  // All diagonals are sums of sides.
  void check_sums() const
  {
    Grid_vector size{};
    for(const Polygon_side& s : m_sides)
      size = sum(size, {absolute_value(s.corner.vector[0]), absolute_value(s.corner.vector[1])});
  }

  // The area, relative to the square of the longest side.
  double roundness(const std::size_t i) const
  {
    const Grid_vector &ab = m_sides[i].corner.vector, &bc = m_sides[next(i)].corner.vector;
    const Grid_vector ac = sum(ab, bc);
    return approximate_cross(ab, bc) / (std::max)({dot(ab, ab), dot(bc, bc), dot(ac, ac)});
  }

  std::size_t roundest_ear() const
  {
    std::size_t best = m_sides.size();
    double best_value = 0;
    for(std::size_t i = 0; i < m_sides.size(); ++i) {
      const double value = roundness(i);
      if((best == m_sides.size() || value > best_value) && is_ear(i)) {
        best = i;
        best_value = value;
      }
    }
    return best;
  }

  void cut_ear(const std::size_t i, const Flat_face_index face)
  {
    const std::size_t j = next(i), before = i == 0 ? m_sides.size() - 1 : i - 1;
    const Corner_index h = 3 * face;
    const Intrinsic_corner a = m_sides[i].corner, b = m_sides[j].corner;
    Polygon_side diagonal;
    diagonal.corner.vertex = b.vertex;
    diagonal.corner.vector = sum(a.vector, b.vector);
    diagonal.corner.units = sum(a.units, b.units);
    diagonal.corner.opposite = h + 2;
    diagonal.corner.departure = find_direction(m_input, a.departure, a.vector,
                                               diagonal.corner.vector);
    Intrinsic_corner back;
    back.vertex = m_sides[before].corner.vertex;
    back.vector = negated(diagonal.corner.vector);
    back.units = negated(diagonal.corner.units);
    const Intrinsic_corner& c = m_sides[next(j)].corner;
    back.departure = find_direction(m_input, c.departure, c.vector, back.vector);
    place(m_sides[i], h);
    place(m_sides[j], h + 1);
    m_complex.corners[std::size_t(h + 2)] = back;
    m_placed.push_back({no_index, h + 2, Quarter_turns::identity()});
    m_sides[i] = diagonal;
    m_sides.erase(m_sides.begin() + std::ptrdiff_t(j));
  }

  void place(const Polygon_side& side, const Corner_index h)
  {
    m_complex.corners[std::size_t(h)] = side.corner;
    m_placed.push_back({side.old_halfedge, h, side.turn});
    if(side.old_halfedge == no_index)
      m_complex.corners[std::size_t(side.corner.opposite)].opposite = h;
  }

  void finish(const Flat_face_index face)
  {
    for(Corner_index k = 0; k < 3; ++k)
      place(m_sides[std::size_t(k)], 3 * face + k);
    for(const Placed& p : m_placed)
      if(p.old_halfedge != no_index)
        link(p);
    for(const Placed& p : m_placed)
      set_corner_at_vertex(p.new_halfedge);
    clear();
  }

  // With the opposite halfedge, which may be a side of the polygon itself.
  void link(const Placed& p)
  {
    Intrinsic_corner& corner = m_complex.corners[std::size_t(p.new_halfedge)];
    const Corner_index opposite = corner.opposite;
    if(opposite == no_index)
      return;
    const auto moved = std::find_if(m_placed.begin(), m_placed.end(), [&](const Placed& q)
                                    { return q.old_halfedge == opposite; });
    if(moved == m_placed.end()) {
      Intrinsic_corner& other = m_complex.corners[std::size_t(opposite)];
      other.opposite = p.new_halfedge;
      other.rotation = Quarter_turns::inverse(corner.rotation);
    } else {
      corner.opposite = moved->new_halfedge;
      corner.rotation = Quarter_turns::compose(moved->turn, corner.rotation);
    }
  }

  // Along the border, the first corner counterclockwise.
  void set_corner_at_vertex(const Corner_index h)
  {
    const std::size_t v = m_complex.vertex(h);
    if(!m_complex.is_border[v] || m_complex.clockwise(h) == no_index)
      m_complex.corner_at_vertex[v] = h;
  }

  const Integer_mesh& m_input;
  Intrinsic_complex& m_complex;
  std::vector<Polygon_side> m_sides;
  std::vector<Placed> m_placed;
};

// Flips of edges, and which of them make a complex rounder.

// The vectors of the four sides around an edge ab with the apexes c and d, in the chart of the face
// abc: bc, ca, ad, db.
struct Edge_diamond
{
  Grid_vector bc, ca, ad, db;

  Edge_diamond(const Intrinsic_complex& complex, const Corner_index h, const Edge_vector vector)
  {
    const Corner_index n = Intrinsic_complex::next(h), p = Intrinsic_complex::prev(h);
    const Corner_index g = complex.opposite(h);
    const Quarter_turns::Element turn = complex.corner(g).rotation;
    bc = complex.corner(n).*vector;
    ca = complex.corner(p).*vector;
    ad = rotated(turn, complex.corner(Intrinsic_complex::next(g)).*vector);
    db = rotated(turn, complex.corner(Intrinsic_complex::prev(g)).*vector);
  }

  // Whether both triangles of the other diagonal are positive.
  bool is_convex() const { return cross_sign(db, bc) > 0 && cross_sign(ca, ad) > 0; }

  // The sum over both triangles of the squared lengths of their sides over their area. The sum over
  // a whole triangulation is least if it is Delaunay.
  double index_before() const { return index(bc, ca) + index(ad, db); }
  double index_after() const { return index(db, bc) + index(ca, ad); }

  // The height of the flatter triangle.
  double height_before() const { return (std::min)(height(bc, ca), height(ad, db)); }
  double height_after() const { return (std::min)(height(db, bc), height(ca, ad)); }

private:
  // The index of a triangle, from two of its sides.
  static double index(const Grid_vector& a, const Grid_vector& b)
  {
    return 2 * (dot(a, a) + dot(a, b) + dot(b, b)) / approximate_cross(a, b);
  }

  // Over the longest side.
  static double height(const Grid_vector& a, const Grid_vector& b)
  {
    const Grid_vector c = sum(a, b);
    return approximate_cross(a, b) / std::sqrt((std::max)({dot(a, a), dot(b, b), dot(c, c)}));
  }
};

constexpr double least_gain_of_flip = 1e-6; // above rounding errors

// Whether the edge is in two faces, no wall, and its quadrangle convex in this size.
inline bool is_flippable(const Intrinsic_complex& complex, const Corner_index h,
                         const Edge_vector vector)
{
  const Corner_index g = complex.opposite(h);
  return g != no_index && !complex.corner(h).is_wall && h / 3 != g / 3 &&
         Edge_diamond(complex, h, vector).is_convex();
}

// \pre is_flippable(); for the units as well, where these are known
inline void flip(const Corner_index h, const Intrinsic_complex& complex, Polygon_filler& filler)
{
  const Corner_index g = complex.opposite(h);
  const Quarter_turns::Element turn = complex.corner(g).rotation;
  filler.clear();
  filler.add_side(Intrinsic_complex::next(h), Quarter_turns::identity());
  filler.add_side(Intrinsic_complex::prev(h), Quarter_turns::identity());
  filler.add_side(Intrinsic_complex::next(g), turn);
  filler.add_side(Intrinsic_complex::prev(g), turn);
  filler.fill(3, h / 3, g / 3);
}

using Edge_vectors = std::initializer_list<Edge_vector>;

// Flips edges that are flippable in these sizes as long as is_better(halfedge) says so. Each flip
// must make something of the whole complex better, so that none comes again.
template <typename Is_better>
std::size_t flip_all(const Integer_mesh& input, Intrinsic_complex& complex,
                     const Edge_vectors sizes, const Is_better& is_better)
{
  const auto can_flip = [&](const Corner_index h) {
    return std::all_of(sizes.begin(), sizes.end(), [&](const Edge_vector size)
                       { return is_flippable(complex, h, size); });
  };
  Polygon_filler filler(input, complex);
  std::vector<Corner_index> to_visit;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.has_face(h / 3) && complex.opposite(h) > h)
      to_visit.push_back(h);
  std::size_t number = 0;
  while(!to_visit.empty()) {
    const Corner_index h = to_visit.back();
    to_visit.pop_back();
    if(!can_flip(h) || !is_better(h))
      continue;
    const Flat_face_index faces[] = {h / 3, complex.opposite(h) / 3};
    flip(h, complex, filler);
    ++number;
    for(const Flat_face_index f : faces)
      for(Corner_index k = 0; k < 3; ++k)
        to_visit.push_back(3 * f + k);
  }
  return number;
}

// Flips edges whose flip makes the triangles rounder in these sizes together.
inline std::size_t make_rounder(const Integer_mesh& input, Intrinsic_complex& complex,
                                const Edge_vectors sizes)
{
  return flip_all(input, complex, sizes, [&](const Corner_index h) {
    double before = 0, after = 0;
    for(const Edge_vector size : sizes) {
      const Edge_diamond diamond(complex, h, size);
      before += diamond.index_before();
      after += diamond.index_after();
    }
    return after < (1 - least_gain_of_flip) * before;
  });
}

// Flips edges whose flip makes the flatter triangle higher, in units: the heights of all triangles,
// the least one first, grow in lexicographic order.
inline std::size_t make_less_flat(const Integer_mesh& input, Intrinsic_complex& complex)
{
  const Edge_vectors sizes{&Intrinsic_corner::vector, &Intrinsic_corner::units};
  return flip_all(input, complex, sizes, [&](const Corner_index h) {
    const Edge_diamond diamond(complex, h, &Intrinsic_corner::units);
    return diamond.height_after() > (1 + least_gain_of_flip) * diamond.height_before();
  });
}

// Makes the complex intrinsically Delaunay, up to rounding and to what walls allow.
inline std::size_t make_delaunay(const Integer_mesh& input, Intrinsic_complex& complex)
{ return make_rounder(input, complex, {&Intrinsic_corner::vector}); }

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_POLYGON_FILLER_H
