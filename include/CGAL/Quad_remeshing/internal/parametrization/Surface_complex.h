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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SURFACE_COMPLEX_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SURFACE_COMPLEX_H

#include <CGAL/license/Quad_remeshing.h>

// The complex of a surface that has been cut open, with a field that has been combed: sectors,
// branches of cuts, and chains of aligned edges. It has no coordinates yet.

#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// The coordinate that is constant along an aligned edge: that whose isocurves are closer to it in
// the field.
inline int constant_functional(const Triangle_surface& surface, const std::vector<double>& angles,
                               const Corner_index h)
{
  const double turns = (surface.direction[h] - angles[surface.face(h)]) / quarter_turn;
  const int v = 1; // constant along +u
  return Quarter_turns::act(Quarter_turns::element(int(std::lround(turns))), v).index;
}

// Invariant: all vertices of the surface are in the complex, also those without constraints; the
// corners of a sector have the same coordinates whatever the translations are.
class Surface_complex
{
public:
  using Complex = Cut_complex<Quarter_turns>;

  // \param rotation per halfedge; the identity across edges that are not cut
  Surface_complex(const Triangle_surface& surface, const std::vector<char>& is_cut,
                  const std::vector<Quarter_turns::Element>& rotation,
                  const std::vector<double>& angles)
    : m_surface(surface), m_is_cut(is_cut), m_rotation(rotation), m_angles(angles),
      m_sector(surface.number_of_halfedges())
  {
    add_sectors();
    const Edge_list cuts(surface, [&](const Corner_index h)
                         { return is_cut[h] && !surface.is_border_edge(h); });
    const Edge_list aligned(surface, [&](const Corner_index h)
                            { return surface.is_aligned[h] != 0; });
    find_nodes(cuts, aligned);
    anchor_components();
    add_branches_and_chains(cuts, aligned);
  }

  const Complex& complex() const { return m_complex; }
  std::size_t number_of_sectors() const { return m_complex.number_of_sectors(); }
  std::size_t sector(const Corner_index h) const { return std::size_t(m_sector[h]); }

private:
  // One halfedge of each edge of a set, and which of them meet at each vertex.
  struct Edge_list
  {
    template <typename Predicate>
    Edge_list(const Triangle_surface& surface, const Predicate& contains)
    {
      for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
        if(surface.represents_edge(h) && contains(h)) {
          halfedges.push_back(h);
          ends.push_back({Vertex_index(surface.source(h)), Vertex_index(surface.vertex(h))});
        }
      incidences = vertex_incidences(surface.number_of_vertices(), ends);
    }

    std::vector<Corner_index> halfedges;
    std::vector<Edge_ends> ends;
    Vertex_incidences incidences;
  };

  void add_sectors()
  {
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      m_complex.first_sector.push_back(Sector_index(m_complex.coordinates.size()));
      const Corner_index start = first_corner_of_sector(v);
      Corner_index h = start;
      bool is_first = true; // of its sector
      do {
        if(is_first)
          m_complex.coordinates.push_back({{0, 0}});
        m_sector[h] = Sector_index(m_complex.coordinates.size()) - 1;
        is_first = m_is_cut[h];
        h = m_surface.counterclockwise(h);
      } while(h != no_index && h != start);
    }
    m_complex.first_sector.push_back(Sector_index(m_complex.coordinates.size()));
  }

  Corner_index first_corner_of_sector(const std::size_t v) const
  {
    Corner_index start = m_surface.corner_at_vertex[v];
    if(!m_surface.is_border[v])
      for_each_corner(m_surface, v, [&](const Corner_index h) {
        if(m_is_cut[h])
          start = m_surface.counterclockwise(h);
      });
    return start;
  }

  // Branches end at the border, at cones, where not two cut edges meet, and where a cut meets an
  // aligned edge; chains where not two aligned edges meet, or two of different isocurves.
  void find_nodes(const Edge_list& cuts, const Edge_list& aligned)
  {
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      const std::size_t cut_degree = cuts.incidences[v].size();
      const std::size_t degree = aligned.incidences[v].size();
      Quarter_turns::Element holonomy = Quarter_turns::identity();
      for_each_corner(m_surface, v, [&](const Corner_index h) {
        if(!m_surface.is_border_edge(h))
          holonomy = Quarter_turns::compose(m_rotation[h], holonomy);
      });
      const bool ends_branch = cut_degree > 0 && (m_surface.is_border[v] || cut_degree != 2 ||
                                                  holonomy != Quarter_turns::identity());
      const bool ends_chain = degree > 0 && (cut_degree > 0 || degree != 2 ||
                                             !is_straight(aligned, Vertex_index(v)));
      m_complex.is_node.push_back(ends_branch || ends_chain);
    }
  }

  bool is_straight(const Edge_list& aligned, const Vertex_index v) const
  {
    const auto functional = [&](const Incidence& incidence) {
      return constant_functional(m_surface, m_angles,
                                 aligned.halfedges[std::size_t(incidence.edge)]);
    };
    const auto edges = aligned.incidences[v];
    return functional(edges[0]) == functional(edges[1]);
  }

  // A component can be moved as a whole: one vertex of each is put at the origin.
  void anchor_components()
  {
    std::vector<char> has_anchor(m_surface.number_of_components, false);
    for(Flat_face_index f = 0; f < m_surface.number_of_faces(); ++f) {
      if(has_anchor[m_surface.component[f]])
        continue;
      has_anchor[m_surface.component[f]] = true;
      const Corner_index corner = 3 * f;
      m_complex.is_node[m_surface.vertex(corner)] = true;
      for(int c = 0; c < int(Quarter_turns::dimension); ++c)
        m_complex.equations.push_back({{{m_sector[corner], c, Exact_rational(1)}},
                                       Exact_rational(0)});
    }
  }

  void add_branches_and_chains(const Edge_list& cuts, const Edge_list& aligned)
  {
    const auto halfedge = [&](const Directed_edge d) {
      const Corner_index h = cuts.halfedges[std::size_t(d / 2)];
      return d % 2 == 0 ? h : m_surface.opposite(h);
    };
    add_branches(cuts.incidences, cuts.ends,
                 [&](const Directed_edge d) { return m_rotation[halfedge(d)]; },
                 [&](const Directed_edge d, const bool at_target) {
                   return m_sector[at_target ? halfedge(d) : m_surface.prev(halfedge(d))];
                 },
                 m_complex);
    add_chains(aligned.incidences, aligned.ends,
               [&](const Edge_index e) {
                 return constant_functional(m_surface, m_angles, aligned.halfedges[std::size_t(e)]);
               },
               [&](const Directed_edge d, const bool at_target) {
                 const Corner_index h = aligned.halfedges[std::size_t(d / 2)];
                 return m_sector[at_target == (d % 2 == 0) ? h : m_surface.prev(h)];
               },
               m_complex);
  }

  const Triangle_surface& m_surface;
  const std::vector<char>& m_is_cut;
  const std::vector<Quarter_turns::Element>& m_rotation;
  const std::vector<double>& m_angles;
  std::vector<Sector_index> m_sector; // per corner
  Complex m_complex;
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SURFACE_COMPLEX_H
