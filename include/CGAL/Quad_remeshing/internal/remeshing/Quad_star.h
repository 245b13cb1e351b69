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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_STAR_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_STAR_H

#include <CGAL/license/Quad_remeshing.h>

// The quads around some vertices that move: their energy, and whether the moves may stay.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The energy of a thin corner by the sine of its angle, seen from where the quad is to face: about
// 1 / sine, and large but finite where the quad is inverted. The denominator is that of regularized
// energies for untangling.
inline double energy_of_corner(const double sine)
{
  constexpr double width = 0.02; // of the sines that are regularized
  return 2 / (sine + std::sqrt(sine * sine + width * width)) - 1;
}

constexpr double thin_quad = 0.2, flat_quad = 0.02; // scaled Jacobians of quads to improve

// Invariant: `m_faces` are the faces around the vertices that were collected last.
class Quad_star
  : private Remeshing_types
{
public:
  // The corners of a quad that count. For `THIN` and `FLAT`, a thin one outweighs all others:
  // vertices move for its sake, which would distort many quads if all moved so from the beginning.
  enum class Corners
  {
    ALL,   // on the average
    WORST, // the worst one
    THIN,  // the worst one, by the energy of a thin corner
    FLAT   // each, by the same energy as far as it is flatter than a flat corner
  };

  // \param has_single_precision whether points are to be of single precision
  Quad_star(const Mesh& quads, Quad_smoother& smoother, const bool has_single_precision = false)
    : m_quads(quads), m_smoother(smoother), m_has_single_precision(has_single_precision)
  { }

  void collect(const std::vector<Vertex>& vertices)
  {
    m_faces.clear();
    m_around.clear();
    m_ends.clear();
    for(const Vertex v : vertices) {
      for(const Face f : CGAL::faces_around_target(halfedge(v, m_quads), m_quads)) {
        if(f == Mesh::null_face())
          continue;
        m_around.push_back(index(f));
        if(m_around.back() == m_faces.size())
          m_faces.push_back(f);
      }
      m_ends.push_back(m_around.size());
    }
    m_sides.clear();
    m_was_bad.clear();
    for(const Face f : m_faces) {
      const Quad q = m_smoother.quad(f);
      m_sides.push_back(upper_side(f, q));
      m_was_bad.push_back(m_smoother.is_bad(f));
    }
  }

  const std::vector<Face>& faces() const { return m_faces; }

  // The face is to be neither inverted nor upside down any more.
  void has_to_be_mended(const Face f) { m_was_bad[index(f)] = false; }

  double energy(const Corners corners) const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      sum += energy_of_face(i, corners);
    return sum;
  }

  // The energy of the faces around one of the vertices.
  double energy_around(const std::size_t vertex, const Corners corners) const
  {
    double sum = 0;
    for(std::size_t k = vertex == 0 ? 0 : m_ends[vertex - 1]; k < m_ends[vertex]; ++k)
      sum += energy_of_face(m_around[k], corners);
    return sum;
  }

  // Whether no face is inverted that was not bad, or turns to the other side of the surface.
  bool is_mended() const
  {
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      const Quad q = m_smoother.quad(m_faces[i]);
      if(!m_was_bad[i] && (is_inverted(q) || !(inner_product(quad_normal(q), m_sides[i]) > 0) ||
                           has_corner_against(q, m_sides[i], clearly_against)))
        return false;
    }
    return true;
  }

  void set_point(const Vertex v, Space_vector p)
  {
    if(m_has_single_precision)
      for(double& x : p)
        x = rounded_to<float>(x);
    m_smoother.set_point(v, p);
  }

private:
  std::size_t index(const Face f) const
  { return std::size_t(std::find(m_faces.begin(), m_faces.end(), f) - m_faces.begin()); }

  // Where a quad is to face: as it does if it is well shaped; else as the surface did beside it
  // before its vertices moved.
  Space_vector upper_side(const Face f, const Quad& q)
  {
    if(const Space_vector& side = m_smoother.upper_sides()[f]; side != Space_vector{})
      return side;
    const Space_vector normal = quad_normal(q);
    if(scaled_jacobian(q, normal) >= thin_quad)
      return normal;
    const auto [it, is_new] = m_normals_of_surface.try_emplace(f);
    if(is_new)
      it->second = m_smoother.surface().normal(q);
    return upper_side_or_own(q, it->second);
  }

  // Where one corner is inverted, it counts alone, as others could make up for it.
  double energy_of_face(const std::size_t i, const Corners corners) const
  {
    constexpr double turned_over = 1e100; // the energy of a quad that faces to the other side
    const Quad q = m_smoother.quad(m_faces[i]);
    Space_vector normal = quad_normal(q);
    const double along = inner_product(normal, m_sides[i]);
    if(corners == Corners::FLAT && has_corner_against(q, m_sides[i], slightly_against))
      normal = m_sides[i];
    else if(along < 0)
      for(double& x : normal)
        x = -x;
    const std::array<double, 4> sines = sines_of_angles(q, normal);
    const double worst = *std::min_element(sines.begin(), sines.end());
    if(corners == Corners::FLAT) {
      double sum = 0;
      for(const double sine : sines)
        sum += (std::max)(energy_of_corner(sine) - energy_of_corner(flat_quad), 0.);
      return sum;
    }
    if(corners == Corners::THIN)
      return energy_of_corner(worst) + energy_of_sides(q);
    if(!(along > 0))
      return turned_over;
    const double mean = (sines[0] + sines[1] + sines[2] + sines[3]) / 4;
    const double missing = 1 - (corners == Corners::ALL && worst > 0 ? mean : worst);
    return missing + missing * missing + energy_of_sides(q);
  }

  // The energy of long sides. Angles don't see them: for angles alone, a vertex on a line would
  // halve the edge to its end in each round.
  static double energy_of_sides(const Quad& q)
  {
    constexpr double long_side = 20, weight = 0.05, least_square = 1e-100; // sides over others
    double shortest = std::numeric_limits<double>::infinity(), longest = least_square;
    for(std::size_t i = 0; i < 4; ++i) {
      const double squared = squared_distance(q[i], q[(i + 1) % 4]);
      shortest = (std::min)(shortest, squared);
      longest = (std::max)(longest, squared);
    }
    const double ratio = longest / (std::max)(shortest, least_square) / (long_side * long_side);
    return ratio > 1 ? weight * std::log(ratio) / 2 : 0;
  }

  const Mesh& m_quads;
  Quad_smoother& m_smoother;
  bool m_has_single_precision;
  std::vector<Face> m_faces;
  std::vector<Space_vector> m_sides; // where these are to face
  std::vector<char> m_was_bad;       // of these
  std::vector<std::size_t> m_around, m_ends; // the numbers of the faces around each vertex
  std::map<Face, Space_vector> m_normals_of_surface;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_STAR_H
