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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FLIP_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FLIP_H

#include <CGAL/license/Quad_remeshing.h>

// Flips of edges, and which of them make a complex rounder.

#include <CGAL/Quad_remeshing/internal/quantization/Polygon_filler.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

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

private:
  // Of a triangle, from two of its sides.
  static double index(const Grid_vector& a, const Grid_vector& b)
  {
    return 2 * (dot(a, a) + dot(a, b) + dot(b, b)) / approximate_cross(a, b);
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

// Flips edges as long as is_better(halfedge) says so. Each flip must make something of the whole
// complex better, so that none comes again.
template <typename Is_better>
std::size_t flip_all(const Integer_mesh& input, Intrinsic_complex& complex,
                     const Is_better& is_better)
{
  Polygon_filler filler(input, complex);
  std::vector<Corner_index> to_visit;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.has_face(h / 3) && complex.opposite(h) > h)
      to_visit.push_back(h);
  std::size_t number = 0;
  while(!to_visit.empty()) {
    const Corner_index h = to_visit.back();
    to_visit.pop_back();
    if(!is_better(h))
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
                                const std::initializer_list<Edge_vector> sizes)
{
  return flip_all(input, complex, [&](const Corner_index h) {
    double before = 0, after = 0;
    for(const Edge_vector size : sizes) {
      if(!is_flippable(complex, h, size))
        return false;
      const Edge_diamond diamond(complex, h, size);
      before += diamond.index_before();
      after += diamond.index_after();
    }
    return after < (1 - least_gain_of_flip) * before;
  });
}

// Makes the complex intrinsically Delaunay, up to rounding and to what walls allow.
inline std::size_t make_delaunay(const Integer_mesh& input, Intrinsic_complex& complex)
{ return make_rounder(input, complex, {&Intrinsic_corner::vector}); }

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FLIP_H
