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
#include <array>
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

inline double largest_component(const Uv& u)
{
  return (std::max)(std::abs(u[0]), std::abs(u[1]));
}

struct Sector
{
  Uv uv;                    // of its first corner
  std::size_t first_corner; // the others follow up to the first corner of the next sector
  double weight;            // in the least-squares target
  std::int32_t mixed;       // the number of the sector among those whose corners differ, or -1
  std::int32_t magnification; // the sector's grid is 2^magnification times as fine as that of the largest coordinates

  bool is_uniform() const { return mixed < 0; }
};

// Invariant: complete after construction. Sectors of one vertex are consecutive, and in clockwise order.
template <typename TriangleMesh, typename HalfedgeUVMap>
class Sector_map
{
public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  // The vertices of `node_corners` become nodes.
  template <typename VertexIndexMap>
  Sector_map(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
             const Transition_data<TriangleMesh>& transitions,
             const Align_edges<TriangleMesh>& align_edges, const std::vector<Halfedge>& node_corners,
             const VertexIndexMap& vertex_indices)
    : Sector_map(tmesh, uv_map, transitions, align_edges,
                 indexed_ends(tmesh, node_corners, vertex_indices), vertex_indices)
  { }

  // Of all sectors of a vertex.
  void magnify(const Vertex_index v, const int magnification)
  {
    for(Sector_index s = first_sector(v); s != first_sector(v + 1); ++s)
      m_sectors[std::size_t(s)].magnification = magnification;
  }

  // The same sectors with other weights.
  Sector_map with_weights(const std::vector<double>& weights) const
  {
    Sector_map result(*this);
    for(std::size_t s = 0; s < weights.size(); ++s)
      result.m_sectors[s].weight = weights[s];
    return result;
  }

  // The sectors of the corners that the constructor was given.
  const std::vector<Sector_index>& node_corner_sectors() const { return m_node_corner_sectors; }

  const TriangleMesh& mesh() const { return m_tmesh; }
  std::size_t number_of_vertices() const { return m_is_node.size(); }
  const std::vector<Edge_ends>& cut_ends() const { return m_cut_ends; }
  const std::vector<Edge_ends>& align_ends() const { return m_align_ends; }
  const Vertex_incidences& cuts() const { return m_cuts; }
  const Vertex_incidences& aligned() const { return m_aligned; }
  bool is_node(const Vertex_index v) const { return m_is_node[std::size_t(v)]; }
  // Else there are only corners to merge.
  bool is_constrained(const Vertex_index v) const
  { return is_node(v) || m_cuts.degree(v) > 0 || m_aligned.degree(v) > 0; }

  std::size_t number_of_singular_vertices() const { return m_number_of_singular_vertices; }

  std::size_t number_of_sectors() const { return m_sectors.size(); }
  const std::vector<Sector_index>& mixed_sectors() const { return m_mixed_sectors; }
  const Sector& sector(const Sector_index s) const { return m_sectors[std::size_t(s)]; }
  Sector_index first_sector(const Vertex_index v) const { return m_first_sector[std::size_t(v)]; }

  const Halfedge* corners_begin(const Sector_index s) const
  { return m_corners.data() + sector(s).first_corner; }
  const Halfedge* corners_end(const Sector_index s) const
  {
    return std::size_t(s) + 1 < m_sectors.size() ? corners_begin(s + 1) : corners_end();
  }
  const Halfedge* corners_end() const { return m_corners.data() + m_corners.size(); } // of all sectors

  // The sectors at the ends of a cut, on the side of its halfedge's face.
  Sector_index target_sector(const Directed_cut d) const { return m_target_sector[std::size_t(d)]; }
  Sector_index source_sector(const Directed_cut d) const { return m_source_sector[std::size_t(d)]; }

  // The sectors at the ends of an aligned edge, likewise.
  Sector_index align_target_sector(const Edge_index a) const
  { return m_align_target_sector[std::size_t(a)]; }
  Sector_index align_source_sector(const Edge_index a) const
  { return m_align_source_sector[std::size_t(a)]; }

  // The largest absolute value of a coordinate of any corner in a sector.
  double largest_coordinate() const { return m_largest_coordinate; }

private:
  using Ends = std::vector<Indexed_edge<Halfedge> >;
  static constexpr std::size_t number_of_walks = 64; // at a time

  // A corner's vertex, as both ends of an edge.
  template <typename VertexIndexMap>
  static Ends indexed_ends(const TriangleMesh& tmesh, const std::vector<Halfedge>& corners,
                           const VertexIndexMap& vertex_indices)
  {
    Ends result;
    for(const Halfedge h : corners) {
      const std::size_t v = std::size_t(get(vertex_indices, target(h, tmesh)));
      result.push_back({h, v, v});
    }
    return result;
  }

  static Vertex_numbers vertex_numbers(const TriangleMesh& tmesh,
                                       const Transition_data<TriangleMesh>& transitions,
                                       const Align_edges<TriangleMesh>& align_edges,
                                       const Ends& node_corners)
  {
    Vertex_numbers numbers(num_vertices(tmesh));
    numbers.mark_ends(transitions.edges);
    numbers.mark_ends(align_edges.edges());
    numbers.mark_ends(node_corners);
    numbers.assign_numbers();
    return numbers;
  }

  template <typename VertexIndexMap>
  Sector_map(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
             const Transition_data<TriangleMesh>& transitions,
             const Align_edges<TriangleMesh>& align_edges, const Ends& node_corners,
             const VertexIndexMap& vertex_indices)
    : m_tmesh(tmesh), m_uv_map(uv_map), m_transitions(transitions), m_align_edges(align_edges),
      m_target_sector(2 * transitions.number_of_cuts, -1),
      m_source_sector(2 * transitions.number_of_cuts, -1),
      m_align_target_sector(align_edges.size(), -1), m_align_source_sector(align_edges.size(), -1)
  {
    const Vertex_numbers numbers = vertex_numbers(tmesh, transitions, align_edges, node_corners);
    m_is_node.resize(numbers.size(), false);
    m_cut_ends = numbers.ends(transitions.edges);
    m_align_ends = numbers.ends(align_edges.edges());
    const std::vector<Edge_ends> node_ends = numbers.ends(node_corners);
    const std::vector<Halfedge> starts = start_halfedges(node_corners, node_ends, vertex_indices);
    m_has_merged_edge.resize(numbers.size(), false);
    for(std::size_t i = transitions.number_of_cuts; i < m_cut_ends.size(); ++i)
      m_has_merged_edge[std::size_t(m_cut_ends[i].source)] =
        m_has_merged_edge[std::size_t(m_cut_ends[i].target)] = true;
    m_cut_ends.resize(transitions.number_of_cuts); // from here on without the merged edges
    m_cuts = Vertex_incidences(numbers.size(), m_cut_ends);
    m_aligned = Vertex_incidences(numbers.size(), m_align_ends);
    form_sectors(starts);
    for(std::size_t i = 0; i < node_corners.size(); ++i)
      make_node(node_corners[i].halfedge, node_ends[i].target);
  }

  void make_node(const Halfedge corner, const Vertex_index v)
  {
    m_is_node[std::size_t(v)] = true;
    for(Sector_index s = first_sector(v); s != first_sector(v + 1); ++s)
      if(std::find(corners_begin(s), corners_end(s), corner) != corners_end(s))
        m_node_corner_sectors.push_back(s);
  }

  // For each vertex a halfedge towards it where a sector begins: a cut edge or, where there is none, one
  // behind the border or, at an inner vertex, that from the neighbor of least index.
  template <typename VertexIndexMap>
  std::vector<Halfedge> start_halfedges(const Ends& node_corners, const std::vector<Edge_ends>& node_ends,
                                        const VertexIndexMap& vertex_indices) const
  {
    std::vector<Halfedge> starts(m_is_node.size());
    std::vector<char> has_start(m_is_node.size(), false);
    const auto set = [&](const Vertex_index v, const Halfedge h, const bool is_cut) {
      if(!has_start[std::size_t(v)])
        starts[std::size_t(v)] = is_cut ? h : uncut_start(h, vertex_indices);
      has_start[std::size_t(v)] = true;
    };
    for(std::size_t i = 0; i < m_transitions.edges.size(); ++i) {
      const auto& edge = m_transitions.edges[i];
      set(m_cut_ends[i].target, edge.halfedge, edge.is_cut);
      set(m_cut_ends[i].source, opposite(edge.halfedge, m_tmesh), edge.is_cut);
    }
    for(std::size_t a = 0; a < m_align_edges.size(); ++a) {
      const Halfedge h = m_align_edges.halfedge(Edge_index(a));
      set(m_align_ends[a].target, h, false);
      set(m_align_ends[a].source, opposite(h, m_tmesh), false);
    }
    for(std::size_t i = 0; i < node_corners.size(); ++i)
      set(node_ends[i].target, node_corners[i].halfedge, false);
    return starts;
  }

  template <typename VertexIndexMap>
  Halfedge uncut_start(const Halfedge any, const VertexIndexMap& vertex_indices) const
  {
    Halfedge best = any;
    Halfedge h = any;
    do {
      if(is_border(h, m_tmesh))
        return h;
      if(get(vertex_indices, source(h, m_tmesh)) < get(vertex_indices, source(best, m_tmesh)))
        best = h;
      h = opposite(next(h, m_tmesh), m_tmesh);
    } while(h != any);
    return best;
  }

  // All halfedges towards each of some vertices, clockwise. The walks take turns, so that their accesses to
  // the memory overlap: in a single walk each waits for the one before.
  void walk_around_vertices(const Halfedge* starts, const std::size_t number,
                            std::vector<std::vector<Halfedge> >& walks) const
  {
    std::array<std::size_t, number_of_walks> under_way;
    for(std::size_t i = 0; i < number; ++i) {
      walks[i].assign(1, starts[i]);
      under_way[i] = i;
    }
    for(std::size_t left = number; left > 0;) {
      std::size_t still = 0;
      for(std::size_t j = 0; j < left; ++j) {
        std::vector<Halfedge>& walk = walks[under_way[j]];
        const Halfedge h = opposite(next(walk.back(), m_tmesh), m_tmesh);
        if(h == walk.front())
          continue;
        walk.push_back(h);
        under_way[still++] = under_way[j];
      }
      left = still;
    }
  }

  // Divides the corners around each vertex into sectors.
  void form_sectors(const std::vector<Halfedge>& starts)
  {
    m_corners.reserve(7 * starts.size());
    m_sectors.reserve(2 * starts.size());
    m_first_sector.reserve(starts.size() + 1);
    std::vector<std::vector<Halfedge> > walks(number_of_walks);
    for(std::size_t v = 0; v < starts.size(); ++v) {
      if(v % number_of_walks == 0)
        walk_around_vertices(starts.data() + v, (std::min)(starts.size() - v, number_of_walks), walks);
      m_first_sector.push_back(Sector_index(m_sectors.size()));
      const std::size_t gaps = form_sectors_at(Vertex_index(v), walks[v % number_of_walks]);
      const bool is_singular =
        gaps == 0 && holonomy(m_cuts, m_transitions.edges, Vertex_index(v)) != 0;
      m_number_of_singular_vertices += is_singular ? 1 : 0;
      m_is_node[v] = needs_node(Vertex_index(v), gaps, is_singular);
    }
    m_first_sector.push_back(Sector_index(m_sectors.size()));
  }

  // Returns how often the border passes the vertex.
  std::size_t form_sectors_at(const Vertex_index v, const std::vector<Halfedge>& walk)
  {
    collect_cuts_towards(v);
    std::size_t gaps = 0;
    bool begins = true;
    const Directed_cut first_cut = cut_towards(walk.front());
    Directed_cut cut = first_cut;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const Halfedge h = walk[i];
      const Directed_cut following_cut = i + 1 < walk.size() ? cut_towards(walk[i + 1]) : first_cut;
      if(is_border(h, m_tmesh)) {
        ++gaps;
        begins = true;
      } else {
        if(begins || cut >= 0)
          begin_sector(h, cut);
        else if(m_has_merged_edge[std::size_t(v)])
          compare_with_first(h);
        add_corner(h, cut, following_cut);
        if(m_aligned.degree(v) > 0)
          add_to_aligned(v, h);
        begins = false;
      }
      cut = following_cut;
    }
    return gaps;
  }

  // The cut edges at a vertex, each by its halfedge towards it.
  void collect_cuts_towards(const Vertex_index v)
  {
    m_cuts_here.clear();
    for(const Incidence* i = m_cuts.begin(v); i != m_cuts.end(v); ++i) {
      const Halfedge h = m_transitions.edges[std::size_t(i->edge)].halfedge;
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

  // Without a merged edge all further corners have the coordinates of the first: no edge between them is open.
  void begin_sector(const Halfedge h, const Directed_cut cut)
  {
    const Uv uv = cut >= 0 ? uv_behind(cut) : get_uv(m_uv_map, h);
    m_largest_coordinate = (std::max)(m_largest_coordinate, largest_component(uv));
    m_sectors.push_back({uv, m_corners.size(), 1., -1, 0});
  }

  void compare_with_first(const Halfedge h)
  {
    Sector& sector = m_sectors.back();
    const Uv uv = get_uv(m_uv_map, h);
    if(uv == sector.uv)
      return;
    m_largest_coordinate = (std::max)(m_largest_coordinate, largest_component(uv));
    if(!sector.is_uniform())
      return;
    sector.mixed = std::int32_t(m_mixed_sectors.size());
    m_mixed_sectors.push_back(Sector_index(m_sectors.size()) - 1);
  }

  // At the target of a cut.
  const Uv& uv_behind(const Directed_cut d) const
  {
    const Edge_sides& sides = m_transitions.edges[std::size_t(d / 2)].sides;
    return d % 2 == 0 ? sides.b : sides.a_opposite;
  }

  void add_corner(const Halfedge h, const Directed_cut cut, const Directed_cut following_cut)
  {
    const Sector_index s = Sector_index(m_sectors.size()) - 1;
    m_corners.push_back(h);
    if(cut >= 0)
      m_target_sector[std::size_t(cut)] = s;
    if(following_cut >= 0)
      m_source_sector[std::size_t(opposite_cut(following_cut))] = s;
  }

  void add_to_aligned(const Vertex_index v, const Halfedge h)
  {
    const Halfedge out = next(h, m_tmesh);
    const Sector_index s = Sector_index(m_sectors.size()) - 1;
    for(const Incidence* i = m_aligned.begin(v); i != m_aligned.end(v); ++i) {
      const std::size_t a = std::size_t(i->edge);
      if(i->points_to_vertex && m_align_edges.edges()[a].halfedge == h)
        m_align_target_sector[a] = s;
      else if(!i->points_to_vertex && m_align_edges.edges()[a].halfedge == out)
        m_align_source_sector[a] = s;
    }
  }

  // Sec. 5.3, plus: ends of cuts, at singular vertices or the border, and ends of aligned chains. (A
  // vertex on a closed branch becomes a node later.) Chains don't pass vertices where only corners of
  // the mesh touch.
  bool needs_node(const Vertex_index v, const std::size_t gaps, const bool is_singular) const
  {
    const std::size_t cuts = m_cuts.degree(v);
    const std::size_t aligned = m_aligned.degree(v);
    if(cuts > 0)
      return cuts != 2 || aligned > 0 || gaps > 0 || is_singular;
    if(aligned == 0)
      return false;
    const Incidence* ends = m_aligned.begin(v);
    return aligned != 2 || gaps > 1 ||
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
  std::vector<Sector_index> m_first_sector, m_mixed_sectors;
  std::vector<Sector_index> m_node_corner_sectors;
  std::vector<Halfedge> m_corners;
  std::vector<bool> m_is_node, m_has_merged_edge;
  std::size_t m_number_of_singular_vertices = 0;
  double m_largest_coordinate = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SECTOR_MAP_H
