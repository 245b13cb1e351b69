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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_CUT_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_CUT_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh and the transitions of its uv map to a complex: divides the corners around each
// vertex of a cut or aligned edge into sectors, finds the nodes, and follows the branches (Sec.
// 5.3). One linear pass over these vertices.

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>
#include <CGAL/Seamless_snapping/internal/mesh/Aligned_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The numbers of the vertices that the complex has, and which edges end at them.
template <typename Halfedge>
struct Constrained_vertices
{
  template <typename Aligned>
  Constrained_vertices(const std::size_t number_of_vertices,
                       const Transition_data<Halfedge>& transitions, const Aligned& aligned_edges,
                       const std::vector<Indexed_edge<Halfedge> >& node_corners)
  {
    const Vertex_numbers numbers(number_of_vertices, transitions.edges, aligned_edges.edges(),
                                 node_corners);
    size = numbers.size();
    mismatched_ends = numbers.ends(transitions.edges);
    aligned_ends = numbers.ends(aligned_edges.edges());
    node_corner_ends = numbers.ends(node_corners);
    cut_ends.assign(mismatched_ends.begin(),
                    mismatched_ends.begin() + std::ptrdiff_t(transitions.number_of_cuts));
    cuts = vertex_incidences(size, cut_ends);
    aligned = vertex_incidences(size, aligned_ends);
  }

  std::size_t size;
  std::vector<Edge_ends> mismatched_ends, cut_ends, aligned_ends, node_corner_ends;
  Vertex_incidences cuts, aligned;
};

// One run. The sectors at the ends of directed edges are on the side of the halfedge's face.
template <typename Group, typename Surface>
class Cut_complex_reader
{
  using Halfedge = typename Surface::Halfedge;
  using Complex = Cut_complex<Group>;
  using Cuts = Surface_cuts<Group, Halfedge>;
  using Aligned = Aligned_edges<Group, Halfedge>;

public:
  Cut_complex_reader(const Surface& surface, const Transition_data<Halfedge>& transitions,
                     const Aligned& aligned_edges, const Constraint_list<Halfedge>& constraints)
    : m_surface(surface)
    , m_transitions(transitions)
    , m_aligned_edges(aligned_edges)
    , m_constraints(constraints)
    , m_node_corners(indexed_corners(constraints.corners()))
    , m_vertices(surface.number_of_vertices(), transitions, aligned_edges, m_node_corners)
    , m_target_sector(2 * transitions.number_of_cuts, -1)
    , m_source_sector(2 * transitions.number_of_cuts, -1)
    , m_aligned_target_sector(aligned_edges.size(), -1)
    , m_aligned_source_sector(aligned_edges.size(), -1)
  { }

  Cuts run();

private:
  static constexpr std::size_t number_of_walks = 64; // at a time

  // A corner's vertex, as both ends of an edge.
  std::vector<Indexed_edge<Halfedge> > indexed_corners(const std::vector<Halfedge>& corners) const
  {
    std::vector<Indexed_edge<Halfedge> > result;
    for(const Halfedge h : corners) {
      const std::size_t v = m_surface.vertex(h);
      result.push_back({h, v, v});
    }
    return result;
  }

  // For each vertex a halfedge towards it where a sector begins: a cut edge or, where there is
  // none, one behind the border or, at an inner vertex, that from the neighbor of least index.
  std::vector<Halfedge> start_halfedges() const
  {
    std::vector<Halfedge> starts(m_vertices.size);
    std::vector<char> has_start(m_vertices.size, false);
    const auto set = [&](const Vertex_index v, const Halfedge h, const bool is_cut) {
      if(!has_start[std::size_t(v)])
        starts[std::size_t(v)] = is_cut ? h : uncut_start(h);
      has_start[std::size_t(v)] = true;
    };
    for(std::size_t i = 0; i < m_transitions.edges.size(); ++i) {
      const auto& edge = m_transitions.edges[i];
      set(m_vertices.mismatched_ends[i].target, edge.halfedge, edge.is_cut);
      set(m_vertices.mismatched_ends[i].source, m_surface.opposite(edge.halfedge), edge.is_cut);
    }
    for(std::size_t a = 0; a < m_aligned_edges.size(); ++a) {
      const Halfedge h = m_aligned_edges.halfedge(Edge_index(a));
      set(m_vertices.aligned_ends[a].target, h, false);
      set(m_vertices.aligned_ends[a].source, m_surface.opposite(h), false);
    }
    for(std::size_t i = 0; i < m_node_corners.size(); ++i)
      set(m_vertices.node_corner_ends[i].target, m_node_corners[i].halfedge, false);
    return starts;
  }

  Halfedge uncut_start(const Halfedge any) const
  {
    Halfedge best = any;
    Halfedge h = any;
    do {
      if(m_surface.is_border(h))
        return h;
      if(m_surface.source(h) < m_surface.source(best))
        best = h;
      h = m_surface.opposite(m_surface.next(h));
    } while(h != any);
    return best;
  }

  // All halfedges towards each of some vertices, clockwise. The walks take turns, so that their
  // accesses to the memory overlap: in a single walk each waits for the one before.
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
        const Halfedge h = m_surface.opposite(m_surface.next(walk.back()));
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
    Complex& complex = m_result.complex;
    mark_merged_vertices();
    m_result.corners.reserve(2 * starts.size(), 7 * starts.size());
    complex.coordinates.reserve(2 * starts.size());
    complex.first_sector.reserve(starts.size() + 1);
    complex.is_node.reserve(starts.size());
    std::vector<std::vector<Halfedge> > walks(number_of_walks);
    for(std::size_t v = 0; v < starts.size(); ++v) {
      if(v % number_of_walks == 0)
        walk_around_vertices(starts.data() + v, (std::min)(starts.size() - v, number_of_walks),
                             walks);
      complex.first_sector.push_back(Sector_index(complex.number_of_sectors()));
      const std::size_t gaps = form_sectors_at(Vertex_index(v), walks[v % number_of_walks]);
      const bool is_singular =
        gaps == 0 && holonomy<Group>(m_vertices.cuts, m_transitions.edges, Vertex_index(v)) !=
                       Group::identity();
      m_result.number_of_singular_vertices += is_singular ? 1 : 0;
      if(is_singular)
        m_result.grid_points.push_back(complex.first_sector.back());
      complex.is_node.push_back(needs_node(Vertex_index(v), gaps, is_singular));
    }
    complex.first_sector.push_back(Sector_index(complex.number_of_sectors()));
    end_sector();
    for(std::size_t i = 0; i < m_node_corners.size(); ++i)
      make_node(m_node_corners[i].halfedge, m_vertices.node_corner_ends[i].target);
  }

  void mark_merged_vertices()
  {
    m_has_merged_edge.resize(m_vertices.size, false);
    for(std::size_t i = m_transitions.number_of_cuts; i < m_vertices.mismatched_ends.size(); ++i)
      for(const Vertex_index v : {m_vertices.mismatched_ends[i].source,
                                  m_vertices.mismatched_ends[i].target})
        m_has_merged_edge[std::size_t(v)] = true;
  }

  // Returns how often the border passes the vertex.
  std::size_t form_sectors_at(const Vertex_index v, const std::vector<Halfedge>& walk)
  {
    collect_cuts_towards(v);
    std::size_t gaps = 0;
    bool begins = true;
    const Directed_edge first_cut = cut_towards(walk.front());
    Directed_edge cut = first_cut;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const Halfedge h = walk[i];
      const Directed_edge following_cut =
          i + 1 < walk.size() ? cut_towards(walk[i + 1]) : first_cut;
      if(m_surface.is_border(h)) {
        ++gaps;
        begins = true;
      } else {
        if(begins || cut >= 0)
          begin_sector(h, cut);
        else if(m_has_merged_edge[std::size_t(v)])
          compare_with_first(h);
        add_corner(h, cut, following_cut);
        if(!m_vertices.aligned[v].empty())
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
    for(const Incidence& i : m_vertices.cuts[v])
      m_cuts_here.push_back({halfedge_towards(m_surface, m_transitions.edges, i),
                             2 * i.edge + (i.points_to_vertex ? 0 : 1)});
  }

  // -1 if the edge of `h`, which points to the vertex under way, is not a cut
  Directed_edge cut_towards(const Halfedge h) const
  {
    for(const Cut_here& cut : m_cuts_here)
      if(cut.halfedge == h)
        return cut.directed;
    return -1;
  }

  // If no edge is merged, all further corners have the coordinates of the first.
  void begin_sector(const Halfedge h, const Directed_edge cut)
  {
    end_sector();
    m_result.complex.coordinates.push_back(cut >= 0 ? uv_behind(cut) : m_surface.uv(h));
  }

  void end_sector()
  {
    if(m_result.corners.size() < m_result.complex.number_of_sectors())
      m_result.corners.end_list();
  }

  void compare_with_first(const Halfedge h)
  {
    auto& mixed = m_result.complex.mixed_sectors;
    const Sector_index s = last_sector();
    if((mixed.empty() || mixed.back().sector != s) &&
       m_surface.uv(h) != m_result.complex.coordinates.back())
      mixed.push_back({s, {}, 0, 0});
  }

  Sector_index last_sector() const
  {
    return Sector_index(m_result.complex.number_of_sectors()) - 1;
  }

  // At the target of a cut.
  const Uv& uv_behind(const Directed_edge d) const
  {
    const Edge_sides& sides = m_transitions.edges[std::size_t(d / 2)].sides;
    return d % 2 == 0 ? sides.b : sides.a_opposite;
  }

  void add_corner(const Halfedge h, const Directed_edge cut, const Directed_edge following_cut)
  {
    m_result.corners.push_back(h);
    if(cut >= 0)
      m_target_sector[std::size_t(cut)] = last_sector();
    if(following_cut >= 0)
      m_source_sector[std::size_t(opposite_edge(following_cut))] = last_sector();
  }

  void add_to_aligned(const Vertex_index v, const Halfedge h)
  {
    const Halfedge out = m_surface.next(h);
    for(const Incidence& i : m_vertices.aligned[v]) {
      const std::size_t a = std::size_t(i.edge);
      if(i.points_to_vertex && m_aligned_edges.edges()[a].halfedge == h)
        m_aligned_target_sector[a] = last_sector();
      else if(!i.points_to_vertex && m_aligned_edges.edges()[a].halfedge == out)
        m_aligned_source_sector[a] = last_sector();
    }
  }

  // [MC19] Sec. 5.3, plus: ends of cuts, at singular vertices or the border, and ends of aligned
  // chains. (A vertex on a closed branch becomes a node later.) Chains don't pass vertices where
  // only corners of the mesh touch.
  bool needs_node(const Vertex_index v, const std::size_t gaps, const bool is_singular) const
  {
    const std::size_t cuts = m_vertices.cuts[v].size();
    const auto aligned = m_vertices.aligned[v];
    if(cuts > 0)
      return cuts != 2 || !aligned.empty() || gaps > 0 || is_singular;
    if(aligned.empty())
      return false;
    return aligned.size() != 2 || gaps > 1 ||
           m_aligned_edges.functional(aligned[0].edge) !=
             m_aligned_edges.functional(aligned[1].edge);
  }

  void make_node(const Halfedge corner, const Vertex_index v)
  {
    const Complex& complex = m_result.complex;
    m_result.complex.is_node[std::size_t(v)] = true;
    // the last corner of each sector is followed by the first of the next one
    const Sector_index last = complex.first_sector[std::size_t(v) + 1];
    for(Sector_index s = complex.first_sector[std::size_t(v)]; s != last; ++s)
      if(const auto corners = m_result.corners[s];
         std::find(corners.begin(), corners.end(), corner) != corners.end())
        m_node_corner_sectors.push_back(s);
  }

  // The corners are so close together that their differences are exact, or nearly so.
  void measure_mixed_sectors()
  {
    for(auto& mixed : m_result.complex.mixed_sectors) {
      const Uv first = m_result.complex.coordinates[std::size_t(mixed.sector)];
      std::vector<Uv> differences;
      double unit = 0;
      for(const Halfedge h : m_result.corners[mixed.sector]) {
        const Uv u = m_surface.uv(h);
        differences.push_back({u[0] - first[0], u[1] - first[1]});
        unit = (std::max)({unit, std::abs(differences.back()[0]), std::abs(differences.back()[1])});
        mixed.largest = (std::max)({mixed.largest, std::abs(u[0]), std::abs(u[1])});
      }
      const double count = static_cast<double>(differences.size());
      for(std::size_t c = 0; c < 2; ++c) {
        double sum = 0;
        for(const Uv& d : differences)
          sum += d[c];
        mixed.deviation[c] = sum / count;
      }
      double squares = 0; // in units, so that they neither overflow nor vanish
      for(const Uv& d : differences)
        for(const double x : Group::to_cartesian({d[0] - mixed.deviation[0],
                                                  d[1] - mixed.deviation[1]}))
          squares += (x / unit) * (x / unit);
      mixed.distance = unit * std::sqrt(squares / count);
    }
  }

  void add_branches_and_chains()
  {
    m_branches = add_branches(
      m_vertices.cuts, m_vertices.cut_ends,
      [&](const Directed_edge d) {
        const auto g = m_transitions.edges[std::size_t(d / 2)].rotation;
        return d % 2 == 0 ? g : Group::inverse(g);
      },
      [&](const Directed_edge d, const bool at_target) {
        return (at_target ? m_target_sector : m_source_sector)[std::size_t(d)];
      },
      m_result.complex);
    const Branch_list chains = add_chains(
      m_vertices.aligned, m_vertices.aligned_ends,
      [&](const Edge_index a) { return m_aligned_edges.functional(a); },
      [&](const Directed_edge d, const bool at_target) {
        return (at_target == (d % 2 == 0) ? m_aligned_target_sector
                                          : m_aligned_source_sector)[std::size_t(d / 2)];
      },
      m_result.complex);
    const auto ends = [](const Branch_list& list, const std::size_t b, const auto& halfedge) {
      return std::array<Halfedge, 2>{{halfedge(list[b].front() / 2),
                                      halfedge(list[b].back() / 2)}};
    };
    for(std::size_t b = 0; b < m_branches.size(); ++b)
      m_result.branch_ends.push_back(ends(m_branches, b, [&](const Edge_index i) {
        return m_transitions.edges[std::size_t(i)].halfedge;
      }));
    for(std::size_t c = 0; c < chains.size(); ++c)
      m_result.chain_ends.push_back(ends(chains, c, [&](const Edge_index a) {
        return m_aligned_edges.halfedge(a);
      }));
  }

  void add_further_constraints()
  {
    Complex& complex = m_result.complex;
    std::unordered_map<Halfedge, typename Complex::Crossing> crossings;
    if(!m_constraints.paths.empty())
      for(std::size_t b = 0; b < m_branches.size(); ++b)
        for(const Directed_edge d : m_branches[b]) {
          const Halfedge h = m_transitions.edges[std::size_t(d / 2)].halfedge;
          crossings[h] = {Branch_index(b), d % 2 == 0};
          crossings[m_surface.opposite(h)] = {Branch_index(b), d % 2 != 0};
        }
    auto sector = m_node_corner_sectors.begin();
    for(const auto& constraint : m_constraints.paths) {
      const Sector_index a = *sector++, b = *sector++;
      complex.paths.push_back({a, b, constraint.component, {}});
      for(const Halfedge h : constraint.path) {
        const auto found = crossings.find(h);
        if(found != crossings.end())
          complex.paths.back().crossings.push_back(found->second);
      }
    }
    for(const auto& constraint : m_constraints.equations) {
      complex.equations.push_back({{}, constraint.right_hand_side});
      for(const auto& term : constraint.terms) {
        const auto f = Group::functional(term.component);
        for(int c = 0; c < int(Group::dimension); ++c)
          if(f[std::size_t(c)] != 0)
            complex.equations.back().terms.push_back({*sector, c, term.coefficient});
        ++sector;
      }
    }
    add_grid_points(sector);
  }

  // Inner vertices by their first sectors: cuts may tell of them, too. On the border, there may be
  // several fans at a vertex.
  template <typename Iterator>
  void add_grid_points(Iterator sector)
  {
    std::vector<Sector_index>& points = m_result.grid_points;
    for(std::size_t i = std::size_t(sector - m_node_corner_sectors.begin());
        i < m_node_corners.size(); ++i, ++sector) {
      const Halfedge h = m_node_corners[i].halfedge;
      const auto v = std::size_t(m_vertices.node_corner_ends[i].target);
      points.push_back(has_border_at_target(m_surface, h)
                         ? *sector : m_result.complex.first_sector[v]);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  const Surface& m_surface;
  const Transition_data<Halfedge>& m_transitions;
  const Aligned& m_aligned_edges;
  const Constraint_list<Halfedge>& m_constraints;
  std::vector<Indexed_edge<Halfedge> > m_node_corners;
  Constrained_vertices<Halfedge> m_vertices;
  struct Cut_here { Halfedge halfedge; Directed_edge directed; };
  std::vector<Cut_here> m_cuts_here; // at the vertex under way
  std::vector<Sector_index> m_target_sector, m_source_sector; // per directed cut
  std::vector<Sector_index> m_aligned_target_sector, m_aligned_source_sector;
  std::vector<Sector_index> m_node_corner_sectors;
  std::vector<char> m_has_merged_edge; // per vertex
  Branch_list m_branches;
  Cuts m_result;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group, typename Surface>
Surface_cuts<Group, typename Surface::Halfedge> Cut_complex_reader<Group, Surface>::run()
{
  form_sectors(start_halfedges());
  measure_mixed_sectors();
  add_branches_and_chains();
  add_further_constraints();
  return std::move(m_result);
}

// \pre nothing was refused
template <typename Group, typename Surface>
Surface_cuts<Group, typename Surface::Halfedge>
read_cut_complex(const Surface& surface,
                 const Transition_data<typename Surface::Halfedge>& transitions,
                 const Aligned_edges<Group, typename Surface::Halfedge>& aligned_edges,
                 const Constraint_list<typename Surface::Halfedge>& constraints)
{
  return Cut_complex_reader<Group, Surface>(surface, transitions, aligned_edges, constraints).run();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_READ_CUT_COMPLEX_H
