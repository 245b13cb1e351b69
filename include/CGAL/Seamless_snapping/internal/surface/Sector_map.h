// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_MAP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_MAP_H

#include <CGAL/license/Seamless_snapping.h>

// The sectors at the ends of open and aligned edges (Sec. 5.3), which of them lie beside which edge, and
// which vertices are nodes. Found in one walk around each of these vertices.

#include <CGAL/Seamless_snapping/internal/surface/Align_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/Open_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/surface/singular_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Sector_index = std::int32_t;

// A cut edge with a direction: 2 i for the halfedge that represents cut edge i, 2 i + 1 for its opposite.
using Directed_cut = std::int32_t;

inline Directed_cut opposite_cut(const Directed_cut d) { return d ^ 1; }

struct Sector
{
  Uv uv;                    // of its first corner
  std::size_t first_corner; // the others follow up to the first corner of the next sector
  bool is_uniform;          // whether all corners agree to the bit
  double weight;            // in the least-squares target
};

// Invariant: complete after construction. Sectors of one vertex are consecutive, and in clockwise order.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Sector_map
{
public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  template <typename VertexIndexMap>
  Sector_map(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
             const Transition_data<TriangleMesh>& transitions,
             const Align_edges<TriangleMesh>& align_edges, const VertexIndexMap& vertex_indices)
    : Sector_map(tmesh, uv_map, transitions, align_edges, vertex_indices,
                 numbers(tmesh, transitions, align_edges, vertex_indices))
  { }

  std::size_t number_of_vertices() const { return m_is_node.size(); }
  const std::vector<Edge_ends>& cut_ends() const { return m_cut_ends; }
  const std::vector<Edge_ends>& align_ends() const { return m_align_ends; }
  const Vertex_incidences& cuts() const { return m_cuts; }
  const Vertex_incidences& aligned() const { return m_aligned; }
  bool is_node(const Vertex_index v) const { return m_is_node[std::size_t(v)]; }

  std::size_t number_of_sectors() const { return m_sectors.size(); }
  const Sector& sector(const Sector_index s) const { return m_sectors[std::size_t(s)]; }
  Sector_index first_sector(const Vertex_index v) const { return m_first_sector[std::size_t(v)]; }

  const Halfedge* corners_begin(const Sector_index s) const
  { return m_corners.data() + sector(s).first_corner; }
  const Halfedge* corners_end(const Sector_index s) const
  {
    return std::size_t(s) + 1 < m_sectors.size() ? corners_begin(s + 1)
                                                 : m_corners.data() + m_corners.size();
  }

  // The sectors at the ends of a cut, on the side of its halfedge's face.
  Sector_index target_sector(const Directed_cut d) const { return m_target_sector[std::size_t(d)]; }
  Sector_index source_sector(const Directed_cut d) const { return m_source_sector[std::size_t(d)]; }

  // The same for an aligned edge.
  Sector_index align_target_sector(const Edge_index a) const
  { return m_align_target_sector[std::size_t(a)]; }
  Sector_index align_source_sector(const Edge_index a) const
  { return m_align_source_sector[std::size_t(a)]; }

  // The largest absolute value of a coordinate of a sector.
  double largest_coordinate() const { return m_largest_coordinate; }

private:
  template <typename VertexIndexMap>
  static Vertex_numbers<TriangleMesh, VertexIndexMap>
  numbers(const TriangleMesh& tmesh, const Transition_data<TriangleMesh>& transitions,
          const Align_edges<TriangleMesh>& align_edges, const VertexIndexMap& vertex_indices)
  {
    Vertex_numbers<TriangleMesh, VertexIndexMap> result(tmesh, vertex_indices);
    result.number_ends({&transitions.cut_halfedges, &align_edges.halfedges(),
                        &transitions.merged_halfedges});
    return result;
  }

  template <typename VertexIndexMap>
  Sector_map(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
             const Transition_data<TriangleMesh>& transitions,
             const Align_edges<TriangleMesh>& align_edges, const VertexIndexMap& vertex_indices,
             const Vertex_numbers<TriangleMesh, VertexIndexMap>& vertices)
    : m_tmesh(tmesh), m_uv_map(uv_map), m_transitions(transitions), m_align_edges(align_edges),
      m_cut_ends(vertices.ends(transitions.cut_halfedges)),
      m_align_ends(vertices.ends(align_edges.halfedges())),
      m_cuts(vertices.size(), m_cut_ends), m_aligned(vertices.size(), m_align_ends),
      m_target_sector(2 * transitions.cut_halfedges.size(), -1),
      m_source_sector(2 * transitions.cut_halfedges.size(), -1),
      m_align_target_sector(align_edges.halfedges().size(), -1),
      m_align_source_sector(align_edges.halfedges().size(), -1), m_is_node(vertices.size(), false)
  {
    m_first_sector.reserve(vertices.size() + 1);
    m_corners.reserve(6 * vertices.size());
    m_sectors.reserve(2 * vertices.size());
    for(std::size_t v = 0; v < vertices.size(); ++v) {
      m_first_sector.push_back(Sector_index(m_sectors.size()));
      collect_cuts_towards(Vertex_index(v));
      const Halfedge first = m_cuts_here.empty() ? start(vertices.vertex(Vertex_index(v)), vertex_indices)
                                                 : m_cuts_here.front().halfedge;
      const bool border = walk_around(Vertex_index(v), first);
      m_is_node[v] = needs_node(Vertex_index(v), border);
    }
    m_first_sector.push_back(Sector_index(m_sectors.size()));
  }

  // The cut edges at a vertex, each by its halfedge towards it.
  void collect_cuts_towards(const Vertex_index v)
  {
    m_cuts_here.clear();
    for(const Incidence* i = m_cuts.begin(v); i != m_cuts.end(v); ++i) {
      const Halfedge h = m_transitions.cut_halfedges[std::size_t(i->edge)];
      m_cuts_here.push_back(i->points_to_vertex ? Cut_here{h, 2 * i->edge}
                                                : Cut_here{opposite(h, m_tmesh), 2 * i->edge + 1});
    }
  }

  // -1 if the edge of `h`, which points to the vertex under way, is no cut
  Directed_cut cut_towards(const Halfedge h) const
  {
    for(const Cut_here& cut : m_cuts_here)
      if(cut.halfedge == h)
        return cut.directed;
    return -1;
  }

  // Where a walk begins at a vertex without cuts: behind the border or, at an inner vertex, at the halfedge
  // from the neighbor of least index.
  template <typename Vertex, typename VertexIndexMap>
  Halfedge start(const Vertex v, const VertexIndexMap& vertex_indices) const
  {
    Halfedge best = halfedge(v, m_tmesh);
    for(const Halfedge h : CGAL::halfedges_around_target(v, m_tmesh)) {
      if(is_border(h, m_tmesh))
        return h;
      if(get(vertex_indices, source(h, m_tmesh)) < get(vertex_indices, source(best, m_tmesh)))
        best = h;
    }
    return best;
  }

  // Returns whether the vertex lies on the border.
  bool walk_around(const Vertex_index v, const Halfedge first)
  {
    bool on_border = false;
    bool begins = true;
    Halfedge h = first;
    Directed_cut cut = cut_towards(h);
    do {
      const Halfedge out = next(h, m_tmesh); // the other edge of the corner
      const Halfedge following = opposite(out, m_tmesh);
      const Directed_cut following_cut = cut_towards(following);
      if(is_border(h, m_tmesh)) {
        on_border = true;
        begins = true;
      } else {
        const Uv uv = get_uv(m_uv_map, h);
        if(begins || cut >= 0)
          m_sectors.push_back({uv, m_corners.size(), true, 1.});
        begins = false;
        add_corner(h, uv, cut, following_cut);
        if(m_aligned.degree(v) > 0)
          add_to_aligned(v, h, out);
      }
      h = following;
      cut = following_cut;
    } while(h != first);
    return on_border;
  }

  void add_corner(const Halfedge h, const Uv& uv, const Directed_cut cut,
                  const Directed_cut following_cut)
  {
    const Sector_index s = Sector_index(m_sectors.size()) - 1;
    Sector& sector = m_sectors.back();
    sector.is_uniform = sector.is_uniform && uv == sector.uv;
    m_largest_coordinate = (std::max)({m_largest_coordinate, std::abs(uv[0]), std::abs(uv[1])});
    m_corners.push_back(h);
    if(cut >= 0)
      m_target_sector[std::size_t(cut)] = s;
    if(following_cut >= 0)
      m_source_sector[std::size_t(opposite_cut(following_cut))] = s;
  }

  void add_to_aligned(const Vertex_index v, const Halfedge h, const Halfedge out)
  {
    const Sector_index s = Sector_index(m_sectors.size()) - 1;
    for(const Incidence* i = m_aligned.begin(v); i != m_aligned.end(v); ++i) {
      const std::size_t a = std::size_t(i->edge);
      if(i->points_to_vertex && m_align_edges.halfedges()[a] == h)
        m_align_target_sector[a] = s;
      else if(!i->points_to_vertex && m_align_edges.halfedges()[a] == out)
        m_align_source_sector[a] = s;
    }
  }

  // Sec. 5.3, plus: ends of cuts, at singular vertices or the border, and ends of aligned chains. (A
  // vertex on a closed branch becomes a node later.)
  bool needs_node(const Vertex_index v, const bool on_border) const
  {
    const std::size_t cuts = m_cuts.degree(v);
    const std::size_t aligned = m_aligned.degree(v);
    if(cuts > 0)
      return cuts != 2 || aligned > 0 || on_border || holonomy(m_cuts, m_transitions.edges, v) != 0;
    if(aligned == 0)
      return false;
    const Incidence* ends = m_aligned.begin(v);
    return aligned != 2 ||
           m_align_edges.component(ends[0].edge) != m_align_edges.component(ends[1].edge);
  }

  const TriangleMesh& m_tmesh;
  const HalfedgeUVMap& m_uv_map;
  const Transition_data<TriangleMesh>& m_transitions;
  const Align_edges<TriangleMesh>& m_align_edges;
  struct Cut_here { Halfedge halfedge; Directed_cut directed; };
  std::vector<Cut_here> m_cuts_here; // of the vertex under way
  std::vector<Edge_ends> m_cut_ends, m_align_ends;
  Vertex_incidences m_cuts, m_aligned;
  std::vector<Sector_index> m_target_sector, m_source_sector;
  std::vector<Sector_index> m_align_target_sector, m_align_source_sector;
  std::vector<Sector> m_sectors;
  std::vector<Sector_index> m_first_sector;
  std::vector<Halfedge> m_corners;
  std::vector<bool> m_is_node;
  double m_largest_coordinate = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_MAP_H
