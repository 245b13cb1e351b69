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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_REDUCED_SYSTEM_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_REDUCED_SYSTEM_H

#include <CGAL/license/Seamless_snapping.h>

// The reduced constraint system of Sec. 5.3, with a twist: the translation of each cut branch and the
// constant coordinate of each align branch are unknowns too, and stand for the vertices between the nodes
// in the least-squares target. So the small system has the optimum of the full one. Once it stands, the
// mesh is not needed until values are written back.

#include <CGAL/Seamless_snapping/internal/algebra/Grid_solver.h>
#include <CGAL/Seamless_snapping/internal/algebra/System_builder.h>
#include <CGAL/Seamless_snapping/internal/surface/Branches.h>
#include <CGAL/Seamless_snapping/internal/surface/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_coordinates.h>
#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap>
class Reduced_system
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Coordinates = Sector_coordinates<TriangleMesh, HalfedgeUVMap>;
  using Row = std::vector<Entry<std::int64_t> >;

public:
  Reduced_system(const Sectors& sectors, const Branches& branches,
                 const Transition_data<TriangleMesh>& transitions,
                 const Align_edges<TriangleMesh>& align_edges,
                 const Constraint_list<TriangleMesh>& constraints,
                 const Coordinates& coordinates, const Grid& grid)
    : m_sectors(sectors), m_branches(branches), m_transitions(transitions), m_align_edges(align_edges),
      m_coordinates(coordinates), m_point{grid, {}, {}, 0, false},
      m_unknown_of_sector(sectors.number_of_sectors(), -1)
  {
    add_node_unknowns(branches.is_node);
    m_point.number_of_representable_columns = m_point.values.size();
    for(std::size_t b = 0; b < branches.cut.size(); ++b)
      m_translation_of_branch.push_back(
        has_inner_vertices(branches.cut, b)
          ? add_translation(branches.cut.begin(b), branches.cut.end(b)) : -1);
    for(std::size_t b = 0; b < branches.aligned.size(); ++b)
      m_coordinate_of_branch.push_back(
        has_inner_vertices(branches.aligned, b)
          ? add_coordinate(branches.aligned.begin(b), branches.aligned.end(b)) : -1);

    System_builder builder(m_point.values.size());
    for(std::size_t b = 0; b < branches.cut.size(); ++b)
      add_cut_rows(branches.cut.begin(b), branches.cut.end(b), translation(b), builder);
    for(std::size_t b = 0; b < branches.aligned.size(); ++b)
      add_align_rows(branches.aligned.begin(b), branches.aligned.end(b), coordinate(b), builder);
    if(!constraints.empty())
      add_constraints(constraints, builder);
    m_system = builder.take().system;
    std::visit([&](const auto& system) { mark_unknowns_in_rows(system); }, m_system);
  }

  const Any_system& system() const { return m_system; }
  const Grid_point& point() const { return m_point; }

  // What a row stands for, in the words of the caller.
  template <typename TriangleMesh_, typename VertexIndexMap>
  std::string name_of_row(const std::size_t row, const Constraint_list<TriangleMesh>& constraints,
                          const TriangleMesh_& tmesh, const VertexIndexMap& vertex_indices) const
  {
    if(row < m_origins.size())
      return m_origins[row].is_cut
        ? "the transition across " + edge_name(tmesh, vertex_indices,
                                               m_transitions.edges[m_origins[row].edge].halfedge)
        : "the alignment of " + edge_name(tmesh, vertex_indices,
                                          m_align_edges.halfedge(Edge_index(m_origins[row].edge)));
    const std::size_t i = row - m_origins.size();
    return i < constraints.paths().size()
      ? constraints.paths()[i].name
      : constraints.corner_constraint_name(i - constraints.paths().size());
  }

  // The unknown that is component 0 of a node sector, or -1; component 1 is the next.
  Column_index unknown(const Sector_index s) const { return m_unknown_of_sector[std::size_t(s)]; }
  // The unknown that is component 0 of a cut branch's translation, or -1 for branches of one edge.
  Column_index translation(const std::size_t b) const { return m_translation_of_branch[b]; }
  // The unknown that is the constant coordinate of an align branch, or -1 for branches of one edge.
  Column_index coordinate(const std::size_t b) const { return m_coordinate_of_branch[b]; }
  // Which components of a node sector some row fixes.
  bool is_constrained(const Sector_index s, const std::size_t c) const
  { return unknown(s) >= 0 && m_is_in_row[std::size_t(unknown(s)) + c]; }

  int directed_rotation(const Directed_cut d) const
  {
    const int k = m_transitions.edges[std::size_t(d / 2)].rotation;
    return d % 2 == 0 ? k : inverse_rotation(k);
  }

  // The sector at one end of an aligned edge that is walked along in one direction.
  Sector_index align_sector(const std::int32_t d, const bool at_target) const
  {
    return at_target == (d % 2 == 0) ? m_sectors.align_target_sector(d / 2)
                                     : m_sectors.align_source_sector(d / 2);
  }

  // The component that is constant along an aligned edge.
  std::size_t align_component(const std::int32_t d) const
  { return std::size_t(m_align_edges.component(d / 2)); }

private:
  Column_index add_unknown(const Grid_value& value, const double weight)
  {
    m_point.values.push_back(value);
    m_point.weights.push_back(weight);
    return Column_index(m_point.values.size()) - 1;
  }

  void add_node_unknowns(const std::vector<bool>& is_node)
  {
    for(std::size_t v = 0; v < is_node.size(); ++v) {
      if(!is_node[v])
        continue;
      const Vertex_index vi = Vertex_index(v);
      for(Sector_index s = m_sectors.first_sector(vi); s != m_sectors.first_sector(vi + 1); ++s) {
        const Grid_uv u = m_coordinates[s];
        const double weight = m_sectors.sector(s).weight;
        m_unknown_of_sector[std::size_t(s)] = add_unknown({u.base[0], u.offset[0]}, weight);
        add_unknown({u.base[1], u.offset[1]}, weight);
      }
    }
  }

  static bool has_inner_vertices(const Branch_list& branches, const std::size_t b)
  { return branches.end(b) - branches.begin(b) > 1; }

  // u- = R u+ + t at both ends. Without t: the difference of both.
  void add_cut_rows(const Directed_cut* first, const Directed_cut* last, const Column_index t,
                    System_builder& builder)
  {
    const Rotation& r = rotation_matrix(directed_rotation(*first));
    const Directed_cut back = *(last - 1);
    const Sector_index plus[2] = {m_sectors.source_sector(*first), m_sectors.target_sector(back)};
    const Sector_index minus[2] = {m_sectors.target_sector(opposite_cut(*first)),
                                   m_sectors.source_sector(opposite_cut(back))};
    for(std::size_t c = 0; c < 2; ++c) {
      m_row.clear();
      for(std::size_t end = 0; end < 2; ++end) {
        const std::int64_t sign = t < 0 && end == 1 ? -1 : 1;
        append(m_row, minus[end], c, sign);
        for(std::size_t d = 0; d < 2; ++d)
          if(r.m[c][d] != 0)
            append(m_row, plus[end], d, -sign * r.m[c][d]);
        if(t < 0 && end == 0)
          continue;
        if(t >= 0)
          m_row.push_back({t + Column_index(c), -1});
        add_row(true, std::size_t((t >= 0 && end == 1 ? back : *first) / 2), builder);
      }
    }
  }

  // The pairs of sectors between the ends contribute 1/2 w |R u+ + t - u-|^2 each: together the branch
  // wants the weighted mean of their translations.
  Column_index add_translation(const Directed_cut* first, const Directed_cut* last)
  {
    const Rotation& r = rotation_matrix(directed_rotation(*first));
    Grid_vector base{{0, 0}};
    Uv sum{{0, 0}};
    double weights = 0;
    for(const Directed_cut* d = first; d != last - 1; ++d) {
      const Sector_index plus = m_sectors.target_sector(*d);
      const Sector_index minus = m_sectors.source_sector(opposite_cut(*d));
      const Grid_uv a = m_coordinates[plus];
      const Grid_uv b = m_coordinates[minus];
      if(d == first) { // the sum is relative to the first pair
        const Grid_vector rotated = r(a.base);
        base = {{b.base[0] - rotated[0], b.base[1] - rotated[1]}};
      }
      const double w = shared_weight(m_sectors.sector(plus).weight, m_sectors.sector(minus).weight);
      const Uv gap = transition_gap(a, b, r, base);
      sum = {{sum[0] + w * gap[0], sum[1] + w * gap[1]}};
      weights += w;
    }
    const Column_index t = add_unknown({base[0], sum[0] / weights}, weights);
    add_unknown({base[1], sum[1] / weights}, weights);
    return t;
  }

  // u|k = a at both ends, Eq. (5). Without a: the difference of both.
  void add_align_rows(const std::int32_t* first, const std::int32_t* last, const Column_index a,
                      System_builder& builder)
  {
    const std::size_t c = align_component(*first);
    m_row.clear();
    append(m_row, align_sector(*first, false), c, 1);
    if(a >= 0) {
      m_row.push_back({a, -1});
      add_row(false, std::size_t(*first / 2), builder);
      m_row.assign(1, {a, -1});
    }
    append(m_row, align_sector(*(last - 1), true), c, a < 0 ? -1 : 1);
    add_row(false, std::size_t((a < 0 ? *first : *(last - 1)) / 2), builder);
  }

  Column_index add_coordinate(const std::int32_t* first, const std::int32_t* last)
  {
    const std::size_t c = align_component(*first);
    const std::int64_t base = m_coordinates[align_sector(*first, true)].base[c];
    double sum = 0, weights = 0;
    for(const std::int32_t* d = first; d != last - 1; ++d) {
      const Sector_index s = align_sector(*d, true);
      const Grid_uv u = m_coordinates[s];
      const double w = m_sectors.sector(s).weight;
      sum += w * (static_cast<double>(u.base[c] - base) + u.offset[c]);
      weights += w;
    }
    return add_unknown({base, sum / weights}, weights);
  }

  void append(Row& row, const Sector_index s, const std::size_t c,
              const std::int64_t coefficient) const
  {
    row.push_back({m_unknown_of_sector[std::size_t(s)] + Column_index(c), coefficient});
  }

  // Coefficients may have cancelled: the corner of a cycle need not be in its row.
  void mark_unknowns_in_rows(const Integer_system& system)
  {
    m_is_in_row.assign(m_point.values.size(), false);
    for(std::size_t i = 0; i < system.number_of_rows(); ++i)
      for(const auto* e = system.begin(i); e != system.end(i); ++e)
        m_is_in_row[std::size_t(e->column)] = true;
    for(std::size_t j = 0; j < m_is_in_row.size(); ++j)
      if(!m_is_in_row[j])
        m_point.values[j] = Grid_value(); // must not keep others from a fine grid
  }

  void add_row(const bool is_cut, const std::size_t edge, System_builder& builder)
  {
    builder.add_row(m_row);
    m_row.clear();
    m_origins.push_back({is_cut, edge});
  }

  void add_constraints(const Constraint_list<TriangleMesh>& constraints, System_builder& builder)
  {
    const Branch_finder finder(m_branches.cut, m_transitions);
    auto sector = m_sectors.node_corner_sectors().begin();
    for(const Path_constraint<TriangleMesh>& p : constraints.paths()) {
      const Sector_index a = *sector++, b = *sector++;
      Row row = path_row(p.connection, a, b, finder);
      builder.add_row(row);
    }
    for(const Corner_constraint<TriangleMesh>& c : constraints.corner_constraints()) {
      std::vector<Entry<Exact_rational> > row;
      for(const auto& term : c.terms) {
        const Sector_index s = *sector++;
        row.push_back({m_unknown_of_sector[std::size_t(s)] + Column_index(term.component),
                       term.coefficient});
      }
      builder.add_row(row, c.right_hand_side);
    }
  }

  // Which branch crosses which edge, and in which direction.
  class Branch_finder
  {
  public:
    Branch_finder(const Branch_list& branches, const Transition_data<TriangleMesh>& transitions)
    {
      for(std::size_t b = 0; b < branches.size(); ++b)
        for(const Directed_cut* d = branches.begin(b); d != branches.end(b); ++d) {
          const auto h = transitions.edges[std::size_t(*d / 2)].halfedge;
          m_branch_of_halfedge[h] = {b, *d % 2 == 0};
        }
    }

    struct Crossing { std::size_t branch; bool along; };

    // A null pointer for edges that are no cut. `along`: from the plus side of the branch to the minus side.
    template <typename Halfedge>
    const Crossing* find(const Halfedge h) const
    {
      const auto found = m_branch_of_halfedge.find(h);
      return found == m_branch_of_halfedge.end() ? nullptr : &found->second;
    }

  private:
    std::unordered_map<typename Transition_data<TriangleMesh>::Halfedge, Crossing> m_branch_of_halfedge;
  };

  // The crossings of a path, in order.
  template <typename Path>
  std::vector<typename Branch_finder::Crossing> crossings(const Path& path,
                                                          const Branch_finder& finder) const
  {
    std::vector<typename Branch_finder::Crossing> result;
    for(const auto h : path) {
      if(const auto* crossing = finder.find(h))
        result.push_back(*crossing);
      else if(const auto* turned = finder.find(opposite(h, m_sectors.mesh())))
        result.push_back({turned->branch, !turned->along});
    }
    return result;
  }

  // Eq. (6), the transitions composed: (R u(a) + t - u(b)) in one component, with t the sum of the branches'
  // translations as later transitions rotate them. Eqs. (7) and (9) are not needed.
  Row path_row(const Connection_constraint<TriangleMesh>& c, const Sector_index a, const Sector_index b,
               const Branch_finder& finder) const
  {
    const auto path = crossings(c.path, finder);
    const auto turn = [&](const typename Branch_finder::Crossing& crossing) {
      const int k = directed_rotation(*m_branches.cut.begin(crossing.branch));
      return crossing.along ? k : inverse_rotation(k);
    };
    int component = c.component;
    for(const auto& crossing : path)
      component = rotated_component(turn(crossing), component);
    const std::size_t l = std::size_t(component);
    Row row;
    int rotation = 0; // by the transitions behind
    for(auto crossing = path.rbegin(); crossing != path.rend(); ++crossing) {
      const int before = (rotation + turn(*crossing)) % number_of_rotations;
      if(crossing->along) // u' = R u + t
        append_translation(row, crossing->branch, rotation, l, 1);
      else                // u' = R^-1 (u - t)
        append_translation(row, crossing->branch, before, l, -1);
      rotation = before;
    }
    append_rotated(row, a, rotation, l, 1);
    append(row, b, l, -1);
    return row;
  }

  // A component of R u for a sector.
  void append_rotated(Row& row, const Sector_index s, const int k, const std::size_t c,
                      const std::int64_t factor) const
  {
    const Rotation& r = rotation_matrix(k);
    for(std::size_t d = 0; d < 2; ++d)
      if(r.m[c][d] != 0)
        append(row, s, d, factor * r.m[c][d]);
  }

  // A component of R t for the translation t of a branch: an unknown or, for a branch of one edge,
  // u- - R' u+ at its start.
  void append_translation(Row& row, const std::size_t b, const int k, const std::size_t c,
                          const std::int64_t factor) const
  {
    if(translation(b) < 0) {
      const Directed_cut first = *m_branches.cut.begin(b);
      const int turned = (k + directed_rotation(first)) % number_of_rotations;
      append_rotated(row, m_sectors.target_sector(opposite_cut(first)), k, c, factor);
      append_rotated(row, m_sectors.source_sector(first), turned, c, -factor);
      return;
    }
    const Rotation& r = rotation_matrix(k);
    for(std::size_t d = 0; d < 2; ++d)
      if(r.m[c][d] != 0)
        row.push_back({translation(b) + Column_index(d), factor * r.m[c][d]});
  }

  // The edge that a row comes from: an index into the transitions or the aligned edges.
  struct Origin { bool is_cut; std::size_t edge; };

  const Sectors& m_sectors;
  const Branches& m_branches;
  const Transition_data<TriangleMesh>& m_transitions;
  const Align_edges<TriangleMesh>& m_align_edges;
  const Coordinates& m_coordinates;
  Grid_point m_point;
  Row m_row; // under way
  std::vector<Origin> m_origins; // of the first rows; those of further constraints follow
  Any_system m_system;
  std::vector<Column_index> m_unknown_of_sector, m_translation_of_branch, m_coordinate_of_branch;
  std::vector<bool> m_is_in_row; // per unknown
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_REDUCED_SYSTEM_H
