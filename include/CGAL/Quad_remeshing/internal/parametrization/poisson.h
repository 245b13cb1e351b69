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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POISSON_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POISSON_H

#include <CGAL/license/Quad_remeshing.h>

// The Poisson system: the coordinates whose gradients come closest to the field, and the rounds of
// local stiffening that lower the number of flipped triangles.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Surface_complex.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

using Coordinates = std::vector<std::array<double, 2> >; // per sector

// The uv difference along halfedge `h` that the field asks for.
inline std::array<double, 2> wanted_difference(const Triangle_surface& surface,
                                               const std::vector<double>& angles,
                                               const Corner_index h)
{
  const double angle = surface.direction[h] - angles[surface.face(h)];
  return {surface.length[h] * std::cos(angle), surface.length[h] * std::sin(angle)};
}

using Columns = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Adds the lower triangle of a.transpose() * b, a column at a time.
inline void add_lower_triangle_of_product(const Columns& a, const Rows& b, Sparse_system& system)
{
  std::vector<double> column(system.dimension(), 0);
  std::vector<char> has_entry(system.dimension(), false);
  std::vector<std::size_t> entries;
  for(int j = 0; j < a.outerSize(); ++j) {
    for(Columns::InnerIterator row(a, j); row; ++row)
      for(Rows::ReverseInnerIterator entry(b, row.row()); entry && entry.col() >= j; --entry) {
        const std::size_t i = std::size_t(entry.col());
        column[i] += row.value() * entry.value();
        if(!has_entry[i])
          entries.push_back(i);
        has_entry[i] = true;
      }
    for(const std::size_t i : entries) {
      system.add(i, std::size_t(j), column[i]);
      column[i] = 0;
      has_entry[i] = false;
    }
    entries.clear();
  }
}

// Adds the coefficients of the sum over the halfedges of weight * |uv difference|^2, by a product
// of matrices: this takes less time where coordinates are long sums.
template <typename Weight>
void add_product(const Triangle_surface& surface, const Surface_complex& complex,
                 const Coordinate_table& table, const Weight& weight, Sparse_system& system)
{
  using Term = Eigen::Triplet<double>;
  const Eigen::Index number = Eigen::Index(2 * complex.number_of_sectors());
  std::vector<Term> terms;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    for(int c = 0; c < 2; ++c) {
      const int p = 2 * int(complex.sector(surface.prev(h))) + c;
      const int q = 2 * int(complex.sector(h)) + c;
      for(const Term& t : {Term(p, p, 1), Term(q, q, 1), Term(p, q, -1), Term(q, p, -1)})
        terms.emplace_back(t.row(), t.col(), t.value() * weight(h));
    }
  Rows squares(number, number);
  squares.setFromTriplets(terms.begin(), terms.end());
  terms.clear();
  for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
    for(std::size_t c = 0; c < 2; ++c)
      table.for_each_term(s, c, [&](const std::size_t i, const double factor)
                          { terms.emplace_back(int(2 * s + c), int(i), factor); });
  Columns rows(number, Eigen::Index(system.dimension()));
  rows.setFromTriplets(terms.begin(), terms.end());
  const Rows images = squares * Rows(rows);
  add_lower_triangle_of_product(rows, images, system);
}

inline double cotangent_weight(const Triangle_surface& surface, const std::vector<double>& weights,
                               const Corner_index h)
{ return weights[surface.face(h)] / std::tan(surface.angle[surface.next(h)]); }

// Both coordinates of a sector, where these are unknowns, are a block.
inline std::vector<int> blocks_of_unknowns(const Surface_complex& complex,
                                           const Coordinate_table& table,
                                           const std::size_t number_of_unknowns)
{
  std::vector<int> result(number_of_unknowns, -1);
  int number = 0;
  for(std::size_t s = 0; s < complex.number_of_sectors(); ++s) {
    bool is_used = false;
    for(std::size_t c = 0; c < 2; ++c)
      table.for_each_term(s, c, [&](const std::size_t i, double) {
        if(result[i] < 0) {
          result[i] = number;
          is_used = true;
        }
      });
    number += is_used;
  }
  for(int& block : result)
    if(block < 0) // of no sector
      block = number++;
  return result;
}

// The matrix of `solve_poisson()`, factorized. Where it is very large, METIS orders it, which takes
// half the time of blocks.
// \param system with the coefficients 0
inline void factor_poisson(const Triangle_surface& surface, const Surface_complex& complex,
                           const Coordinate_table& table, const std::vector<double>& weights,
                           Sparse_system& system)
{
  const auto weight_of = [&](const Corner_index h)
  { return cotangent_weight(surface, weights, h); };
  Sparse_row row;
  if(system.dimension() > std::size_t(very_large_system))
    system.set_blocks(blocks_of_unknowns(complex, table, system.dimension()));
  if(table.has_long_sums()) {
    add_product(surface, complex, table, weight_of, system);
  } else {
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
      const double weight = weight_of(h);
      for(std::size_t c = 0; c < 2; ++c) {
        table.difference(complex.sector(h), complex.sector(surface.prev(h)), c, row);
        for(const auto& [i, a] : row)
          for(const auto& [j, b] : row)
            system.add(i, j, weight * a * b);
      }
    }
  }
  system.factor();
}

// Minimizes the sum over the faces of weight * area * |grad uv - wanted|^2, written with cotangents
// as a sum over the edges of each face. Returns the values of the free unknowns.
// \param wanted_difference along a halfedge, in its face
// \param system factorized for these weights
template <typename Difference>
std::vector<double> solve_poisson(const Triangle_surface& surface,
                                  const Difference& wanted_difference,
                                  const Surface_complex& complex,
                                  const Coordinate_table& table,
                                  const std::vector<double>& weights,
                                  Sparse_system& system)
{
  std::vector<std::array<double, 2> > at_sectors(complex.number_of_sectors(), {{0, 0}});
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const double weight = cotangent_weight(surface, weights, h);
    const std::array<double, 2> wanted = wanted_difference(h);
    for(std::size_t c = 0; c < 2; ++c) {
      at_sectors[complex.sector(h)][c] += weight * wanted[c];
      at_sectors[complex.sector(surface.prev(h))][c] -= weight * wanted[c];
    }
  }
  std::vector<double> right_hand_side(system.dimension(), 0);
  for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
    for(std::size_t c = 0; c < 2; ++c)
      table.for_each_term(s, c, [&](const std::size_t i, const double factor)
                          { right_hand_side[i] += factor * at_sectors[s][c]; });
  return system.solve(right_hand_side);
}

// Twice the area of face `f` in the plane.
inline double doubled_uv_area(const Surface_complex& complex, const Coordinates& uv,
                              const Flat_face_index f)
{
  const auto& p = uv[complex.sector(3 * f)];
  const auto& q = uv[complex.sector(3 * f + 1)];
  const auto& r = uv[complex.sector(3 * f + 2)];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// Exact.
inline bool is_positive(const Surface_complex& complex, const Coordinates& uv,
                        const Flat_face_index f)
{
  return orientation({{uv[complex.sector(3 * f)], uv[complex.sector(3 * f + 1)],
                       uv[complex.sector(3 * f + 2)]}}) == CGAL::POSITIVE;
}

inline std::size_t number_of_flips(const Triangle_surface& surface, const Surface_complex& complex,
                                   const Coordinates& uv)
{
  std::size_t count = 0;
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    count += is_positive(complex, uv, f) ? 0 : 1;
  return count;
}

// How far the singular values of the map of each face are from 1; negative determinants count as
// negative singular values. See [Bommes, Zimmer, Kobbelt 2009], Sec. 5.
inline std::vector<double> distortion(const Triangle_surface& surface,
                                      const Surface_complex& complex, const Coordinates& uv)
{
  std::vector<double> result(surface.number_of_faces());
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    const Corner_index h = 3 * f;
    const auto& p = uv[complex.sector(h)];
    const auto& q = uv[complex.sector(h + 1)];
    const auto& s = uv[complex.sector(h + 2)];
    // The layout has source(h) at the origin and h along the x-axis.
    const double l = surface.length[h], m = surface.length[h + 2];
    const double x = -m * std::cos(surface.direction[h + 2]);
    const double y = -m * std::sin(surface.direction[h + 2]);
    const double a = (p[0] - s[0]) / l, c = (p[1] - s[1]) / l;
    const double b = (q[0] - s[0] - a * x) / y, d = (q[1] - s[1] - c * x) / y;
    const double sum = std::hypot(a + d, c - b), difference = std::hypot(a - d, c + b);
    result[f] = std::abs((sum + difference) / 2 - 1) + std::abs((sum - difference) / 2 - 1);
  }
  return result;
}

// Raises the weights of faces whose distortion differs from the distortion of their neighbors, and
// multiplies them at flipped faces and around, where raising alone takes many rounds.
inline void stiffen(const Triangle_surface& surface, const Surface_complex& complex,
                    const Coordinates& uv, std::vector<double>& weights)
{
  constexpr double largest_increase = 5, factor_of_flips = 2; // of weights, in one round
  const std::vector<double> lambda = distortion(surface, complex, uv);
  std::vector<char> is_near_flip(surface.number_of_faces(), false);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    const bool is_flipped = !(doubled_uv_area(complex, uv, f) > 0);
    is_near_flip[f] = is_near_flip[f] || is_flipped;
    double laplacian = 0;
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h) {
      if(surface.is_border_edge(h))
        continue;
      const Flat_face_index g = surface.face(surface.opposite(h));
      laplacian += lambda[g] - lambda[f];
      is_near_flip[g] = is_near_flip[g] || is_flipped;
    }
    weights[f] += (std::min)(std::abs(laplacian), largest_increase);
  }
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    if(is_near_flip[f])
      weights[f] *= factor_of_flips;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POISSON_H
