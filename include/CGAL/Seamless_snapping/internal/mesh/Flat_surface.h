// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// A copy of a triangulated surface and its coordinates, in plain arrays that can be changed before
// anything is known to succeed.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A `Surface` as Uv_surface is. Invariant: the halfedges 3 f, 3 f + 1, 3 f + 2 are those of face f;
// halfedges of the border follow. Borders run through vertices as in the input, also where several
// meet.
class Flat_surface
{
public:
  using Halfedge = Corner_index;

  // \param index receives the index of each halfedge of the input
  // \param originals receives the halfedge of the input for each index
  // \pre all faces of the input have three corners
  template <typename Surface, typename IndexMap>
  Flat_surface(const Surface& input, const IndexMap& index,
               std::vector<typename Surface::Halfedge>& originals)
    : m_number_of_vertices(input.number_of_vertices()), m_format(input.format()),
      m_epsilon(input.epsilon()), m_names(input.names())
  {
    using Original = typename Surface::Halfedge;
    const auto add = [&](const Original h) {
      put(index, h, Halfedge(originals.size()));
      originals.push_back(h);
    };
    for(const Original first : input.one_per_face()) {
      add(first);
      add(input.next(first));
      add(input.prev(first));
    }
    m_uv.reserve(originals.size());
    for(const Original h : originals)
      m_uv.push_back(input.uv(h));
    for(const Original e : input.one_per_edge())
      for(const Original h : {e, input.opposite(e)})
        if(input.is_border(h))
          add(h);
    for(const Original h : originals) {
      m_opposite.push_back(get(index, input.opposite(h)));
      m_vertex.push_back(input.vertex(h));
      if(input.is_border(h)) {
        m_next_of_border.push_back(get(index, input.next(h)));
        m_prev_of_border.push_back(get(index, input.prev(h)));
      }
    }
    for(const Original e : input.one_per_edge())
      m_edges.push_back(get(index, e));
    for(const Original h : input.one_per_vertex())
      m_vertices.push_back(h == input.null_halfedge() ? no_index : get(index, h));
    for(Halfedge h = 0; h < number_of_corners(); h += 3)
      m_faces.push_back(h);
  }

  // Copies a mesh in arrays. A border that comes to a vertex leads to another fan of its faces, if
  // there are several, so that a walk around the vertex passes all.
  // \param uv of each corner
  template <typename Corner, typename Uv_of>
  Flat_surface(const Flat_mesh<Corner>& mesh, const Uv_of& uv)
    : m_number_of_vertices(mesh.number_of_vertices()), m_format(Number_format::of<double>()),
      m_epsilon(std::numeric_limits<double>::epsilon()), m_names(nullptr),
      m_vertices(mesh.corner_at_vertex)
  {
    std::vector<Halfedge> border; // the corners on the other sides
    for(Halfedge h = 0; h < mesh.number_of_halfedges(); ++h) {
      const bool is_border = mesh.is_border_edge(h);
      m_uv.push_back(uv(h));
      m_vertex.push_back(mesh.vertex(h));
      m_opposite.push_back(is_border ? mesh.number_of_halfedges() + Halfedge(border.size())
                                     : mesh.opposite(h));
      if(is_border)
        border.push_back(h);
      if(mesh.represents_edge(h))
        m_edges.push_back(h);
      if(h % 3 == 0)
        m_faces.push_back(h);
    }
    // per vertex: where its first fan begins, and its last one ends
    std::vector<std::array<Halfedge, 2> > ends(m_number_of_vertices, {no_index, no_index});
    m_next_of_border.resize(border.size());
    m_prev_of_border.resize(border.size());
    const auto set_next = [&](const Halfedge h, const Halfedge next) {
      m_next_of_border[std::size_t(h) - m_uv.size()] = next;
      m_prev_of_border[std::size_t(next) - m_uv.size()] = h;
    };
    for(const Halfedge h : border) {
      m_vertex.push_back(mesh.source(h));
      m_opposite.push_back(h);
      Halfedge first = mesh.prev(h);
      while(!mesh.is_border_edge(first))
        first = mesh.prev(mesh.opposite(first));
      auto& [begin, end] = ends[mesh.source(h)];
      if(begin == no_index)
        begin = opposite(first);
      else
        set_next(end, opposite(first));
      end = opposite(h);
      set_next(end, begin);
    }
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  std::size_t number_of_edges() const { return m_edges.size(); }
  std::size_t number_of_faces() const { return m_faces.size(); }
  Halfedge number_of_corners() const { return Halfedge(m_uv.size()); }

  const std::vector<Halfedge>& one_per_face() const { return m_faces; }
  const std::vector<Halfedge>& one_per_edge() const { return m_edges; }
  const std::vector<Halfedge>& one_per_vertex() const { return m_vertices; }
  static Halfedge null_halfedge() { return no_index; }

  Halfedge opposite(const Halfedge h) const { return m_opposite[std::size_t(h)]; }
  bool is_border(const Halfedge h) const { return h >= number_of_corners(); }
  static Halfedge first_in_face(const Halfedge h) { return h - h % 3; }
  Halfedge next(const Halfedge h) const
  {
    return is_border(h) ? m_next_of_border[std::size_t(h) - m_uv.size()]
                        : h % 3 == 2 ? h - 2 : h + 1;
  }
  Halfedge prev(const Halfedge h) const
  {
    return is_border(h) ? m_prev_of_border[std::size_t(h) - m_uv.size()]
                        : h % 3 == 0 ? h + 2 : h - 1;
  }

  std::size_t vertex(const Halfedge h) const { return m_vertex[std::size_t(h)]; }
  std::size_t source(const Halfedge h) const { return vertex(opposite(h)); }
  const std::vector<std::size_t>* names() const { return m_names; }

  const Uv& uv(const Halfedge h) const { return m_uv[std::size_t(h)]; }
  const std::vector<Uv>& all_uv() const { return m_uv; }
  void set_all_uv(const std::vector<Uv>& all) { m_uv = all; }

  // Rounds to the number type of the input.
  void set_uv(const Halfedge h, const Uv& uv)
  { m_uv[std::size_t(h)] = {rounded_to(m_format, uv[0]), rounded_to(m_format, uv[1])}; }

  bool have_same_uv(const Halfedge g, const Halfedge h) const { return uv(g) == uv(h); }
  void prefetch(Halfedge) const { }

  Number_format format() const { return m_format; }
  double epsilon() const { return m_epsilon; }
  bool has_valid_indices() const { return true; }

private:
  std::size_t m_number_of_vertices;
  Number_format m_format;
  double m_epsilon;
  const std::vector<std::size_t>* m_names; // of the input
  std::vector<Uv> m_uv;               // per corner
  std::vector<Halfedge> m_opposite;   // per halfedge
  std::vector<std::size_t> m_vertex;  // per halfedge: the index in the input
  std::vector<Halfedge> m_next_of_border, m_prev_of_border; // per halfedge of the border
  std::vector<Halfedge> m_faces, m_edges, m_vertices;       // a halfedge of each
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_SURFACE_H
