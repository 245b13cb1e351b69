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

// The quads around some vertices that move: how bad they are, and whether the moves may stay.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Feature_lines.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: `m_faces` are the faces around the vertices that were collected last.
class Quad_star
  : private Remeshing_types
{
public:
  // \param is_feature whether an edge is a feature or border
  // \param has_single_precision whether points are to be of single precision
  Quad_star(Mesh& quads, const Feature_map& is_feature, Quad_smoother& smoother,
            const bool has_single_precision)
    : m_quads(quads), m_is_feature(is_feature), m_smoother(smoother),
      m_has_single_precision(has_single_precision)
  { }

  void collect(const std::vector<Vertex>& vertices)
  {
    m_faces.clear();
    m_upper_side.clear();
    m_was_bad.clear();
    m_faces_around.assign(vertices.size(), {});
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(const Face f : CGAL::faces_around_target(halfedge(vertices[i], m_quads), m_quads)) {
        if(f == Mesh::null_face())
          continue;
        m_faces_around[i].push_back(index(f));
        if(index(f) == m_faces.size())
          m_faces.push_back(f);
      }
    for(const Face f : m_faces) {
      const Quad q = m_smoother.quad(f);
      m_was_bad.push_back(m_smoother.is_bad(f));
      m_upper_side.push_back(m_was_bad.back()
                               ? Space_vector{}
                               : upper_side_or_own(q, m_smoother.normal_of_surface(q)));
    }
  }

  const std::vector<Face>& faces() const { return m_faces; }

  // A face that is to be neither inverted nor upside down any more.
  void has_to_be_mended(const Face f)
  {
    m_was_bad[index(f)] = false;
    m_upper_side[index(f)] = m_smoother.upper_sides()[f];
  }

  double badness() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      sum += badness_of_face(i);
    return sum;
  }

  // The badness of the faces around one of the vertices.
  double badness_around(const std::size_t vertex) const
  {
    double sum = 0;
    for(const std::size_t i : m_faces_around[vertex])
      sum += badness_of_face(i);
    return sum;
  }

  // Whether no face is inverted that was not bad, or turns to the other side of the surface.
  bool is_mended() const
  {
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      const Quad q = m_smoother.quad(m_faces[i]);
      if((!m_was_bad[i] && is_inverted(q)) || is_turned_over(i, quad_normal(q)))
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

  // Features and borders at a vertex.
  std::size_t number_of_lines(const Vertex v) const
  { return lines_at_vertex(m_quads, m_is_feature, v).size(); }

private:
  std::size_t index(const Face f) const
  { return std::size_t(std::find(m_faces.begin(), m_faces.end(), f) - m_faces.begin()); }

  bool is_turned_over(const std::size_t i, const Space_vector& normal) const
  { return m_upper_side[i] != Space_vector{} && !(inner_product(normal, m_upper_side[i]) > 0); }

  // 0 where the shape is good enough, seen from the upper side. All corners count, so that it helps
  // to mend one of two. Quads that turn over are worst of all.
  double badness_of_face(const std::size_t i) const
  {
    const Quad q = m_smoother.quad(m_faces[i]);
    Space_vector normal = quad_normal(q);
    double sum = 0;
    if(is_turned_over(i, normal)) {
      sum = 4;
      for(double& x : normal)
        x = -x;
    }
    for(const double sine : sines_of_angles(q, normal)) {
      const double missing = good_enough - sine;
      sum += missing > 0 ? missing * missing : 0;
    }
    return sum;
  }

  static constexpr double good_enough = 0.02; // as a scaled Jacobian

  Mesh& m_quads;
  Feature_map m_is_feature;
  Quad_smoother& m_smoother;
  bool m_has_single_precision;
  std::vector<Face> m_faces;
  std::vector<char> m_was_bad;                           // of these faces
  std::vector<Space_vector> m_upper_side;                // of these; 0: any side will do
  std::vector<std::vector<std::size_t> > m_faces_around; // each vertex
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_QUAD_STAR_H
