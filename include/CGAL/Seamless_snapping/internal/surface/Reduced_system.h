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
#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>
#include <CGAL/Seamless_snapping/internal/surface/Branches.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>
#include <CGAL/Seamless_snapping/internal/surface/quarter_turns.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Grid_vector = std::array<std::int64_t, 2>;

// A real point relative to the grid.
struct Grid_uv
{
  Grid_vector base;
  Uv offset;
};

// The coordinates of all sectors on a grid. Sectors whose corners differ are represented by their mean.
template <typename TriangleMesh, typename HalfedgeUVMap>
std::vector<Grid_uv> sector_coordinates(const Sector_map<TriangleMesh, HalfedgeUVMap>& sectors,
                                        const HalfedgeUVMap& uv_map, const Grid& grid)
{
  std::vector<Grid_uv> result(sectors.number_of_sectors());
  for(std::size_t i = 0; i < result.size(); ++i) {
    const Sector_index s = Sector_index(i);
    const Sector& sector = sectors.sector(s);
    for(std::size_t c = 0; c < 2; ++c) {
      const Grid_value v = grid.split(sector.uv[c]);
      result[i].base[c] = v.base;
      result[i].offset[c] = v.offset;
      if(sector.is_uniform)
        continue;
      double sum = 0, count = 0;
      for(auto h = sectors.corners_begin(s); h != sectors.corners_end(s); ++h) {
        const Grid_value corner = grid.split(get_uv(uv_map, *h)[c]);
        sum += static_cast<double>(corner.base - v.base) + (corner.offset - v.offset);
        count += 1;
      }
      result[i].offset[c] += sum / count;
    }
  }
  return result;
}

// u- - R u+ - t for sectors beside a cut: exact in the bases.
inline Uv transition_gap(const Grid_uv& plus, const Grid_uv& minus, const Rotation& r,
                         const Grid_vector& t)
{
  const Grid_vector base = r(plus.base);
  const Uv offset = r(plus.offset);
  Uv gap;
  for(std::size_t c = 0; c < 2; ++c)
    gap[c] = static_cast<double>(minus.base[c] - base[c] - t[c]) + (minus.offset[c] - offset[c]);
  return gap;
}

// How two sectors of weights a and b share what separates them: the price per unit of squared gap.
inline double shared_weight(const double a, const double b) { return a * b / (a + b); }

template <typename TriangleMesh, typename HalfedgeUVMap>
class Reduced_system
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Row = std::vector<Entry<std::int64_t> >;

public:
  Reduced_system(const Sectors& sectors, const Branches& branches,
                 const Transition_data<TriangleMesh>& transitions,
                 const Align_edges<TriangleMesh>& align_edges, const std::vector<Grid_uv>& coordinates,
                 const Grid& grid)
    : m_sectors(sectors), m_transitions(transitions), m_align_edges(align_edges),
      m_coordinates(coordinates), m_point{grid, {}, {}, 0},
      m_unknown_of_sector(sectors.number_of_sectors(), -1),
      m_is_constrained(sectors.number_of_sectors(), {{false, false}})
  {
    add_node_unknowns(branches.is_node);
    m_point.number_of_representable_columns = m_point.values.size();
    for(std::size_t b = 0; b < branches.cut.size(); ++b)
      add_cut_branch(branches.cut.begin(b), branches.cut.end(b));
    for(std::size_t b = 0; b < branches.aligned.size(); ++b)
      add_align_branch(branches.aligned.begin(b), branches.aligned.end(b));
    m_system = Integer_system<std::int64_t>(m_point.values.size());
    for(const Row& row : m_rows)
      m_system.add_row(row, 0);
  }

  const Integer_system<std::int64_t>& system() const { return m_system; }
  const Grid_point& point() const { return m_point; }

  // The unknown that is component 0 of a node sector, or -1; component 1 is the next.
  Column_index unknown(const Sector_index s) const { return m_unknown_of_sector[std::size_t(s)]; }
  // The unknown that is component 0 of a cut branch's translation, or -1 for branches of one edge.
  Column_index translation(const std::size_t b) const { return m_translation_of_branch[b]; }
  // The unknown that is the constant coordinate of an align branch, or -1 for branches of one edge.
  Column_index coordinate(const std::size_t b) const { return m_coordinate_of_branch[b]; }
  // Which components of a node sector some row fixes.
  bool is_constrained(const Sector_index s, const std::size_t c) const
  { return m_is_constrained[std::size_t(s)][c]; }

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
        const Grid_uv& u = m_coordinates[std::size_t(s)];
        const double weight = m_sectors.sector(s).weight;
        m_unknown_of_sector[std::size_t(s)] = add_unknown({u.base[0], u.offset[0]}, weight);
        add_unknown({u.base[1], u.offset[1]}, weight);
      }
    }
  }

  // u- = R u+ + t at both ends.
  void add_cut_branch(const Directed_cut* first, const Directed_cut* last)
  {
    const int k = directed_rotation(*first);
    const Rotation& r = rotation_matrix(k);
    const Directed_cut back = *(last - 1);
    const Sector_index plus[2] = {m_sectors.source_sector(*first), m_sectors.target_sector(back)};
    const Sector_index minus[2] = {m_sectors.target_sector(opposite_cut(*first)),
                                   m_sectors.source_sector(opposite_cut(back))};
    const Column_index t = last - first > 1 ? add_translation(first, last, r) : -1;
    m_translation_of_branch.push_back(t);
    for(std::size_t c = 0; c < 2; ++c) {
      Row rows[2];
      for(std::size_t end = 0; end < 2; ++end) {
        const std::int64_t sign = t < 0 && end == 1 ? -1 : 1; // without t: the difference of both
        Row& row = rows[t < 0 ? 0 : end];
        append(row, minus[end], c, sign);
        for(std::size_t d = 0; d < 2; ++d)
          if(r.m[c][d] != 0)
            append(row, plus[end], d, -sign * r.m[c][d]);
        if(t >= 0)
          row.push_back({t + Column_index(c), -1});
      }
      add_row(rows[0]);
      if(t >= 0)
        add_row(rows[1]);
    }
  }

  // The pairs of sectors between the ends contribute 1/2 w |R u+ + t - u-|^2 each: together the branch
  // wants the weighted mean of their translations.
  Column_index add_translation(const Directed_cut* first, const Directed_cut* last, const Rotation& r)
  {
    Grid_vector base{{0, 0}};
    Uv sum{{0, 0}};
    double weights = 0;
    for(const Directed_cut* d = first; d != last - 1; ++d) {
      const Sector_index plus = m_sectors.target_sector(*d);
      const Sector_index minus = m_sectors.source_sector(opposite_cut(*d));
      const Grid_uv& a = m_coordinates[std::size_t(plus)];
      const Grid_uv& b = m_coordinates[std::size_t(minus)];
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

  // u|k = a at both ends, Eq. (5).
  void add_align_branch(const std::int32_t* first, const std::int32_t* last)
  {
    const std::size_t c = align_component(*first);
    const Sector_index start = align_sector(*first, false), end = align_sector(*(last - 1), true);
    Column_index a = -1;
    if(last - first > 1)
      a = add_coordinate(first, last, c);
    m_coordinate_of_branch.push_back(a);
    Row rows[2];
    append(rows[0], start, c, 1);
    if(a < 0) {
      append(rows[0], end, c, -1);
    } else {
      rows[0].push_back({a, -1});
      append(rows[1], end, c, 1);
      rows[1].push_back({a, -1});
      add_row(rows[1]);
    }
    add_row(rows[0]);
  }

  Column_index add_coordinate(const std::int32_t* first, const std::int32_t* last, const std::size_t c)
  {
    const std::int64_t base = m_coordinates[std::size_t(align_sector(*first, true))].base[c];
    double sum = 0, weights = 0;
    for(const std::int32_t* d = first; d != last - 1; ++d) {
      const Sector_index s = align_sector(*d, true);
      const Grid_uv& u = m_coordinates[std::size_t(s)];
      const double w = m_sectors.sector(s).weight;
      sum += w * (static_cast<double>(u.base[c] - base) + u.offset[c]);
      weights += w;
    }
    return add_unknown({base, sum / weights}, weights);
  }

  void append(Row& row, const Sector_index s, const std::size_t c, const std::int64_t coefficient)
  {
    m_is_constrained[std::size_t(s)][c] = true;
    row.push_back({m_unknown_of_sector[std::size_t(s)] + Column_index(c), coefficient});
  }

  void add_row(Row& row)
  {
    sort_and_sum(row);
    m_rows.push_back(row);
  }

  const Sectors& m_sectors;
  const Transition_data<TriangleMesh>& m_transitions;
  const Align_edges<TriangleMesh>& m_align_edges;
  const std::vector<Grid_uv>& m_coordinates;
  Grid_point m_point;
  std::vector<Row> m_rows;
  Integer_system<std::int64_t> m_system;
  std::vector<Column_index> m_unknown_of_sector, m_translation_of_branch, m_coordinate_of_branch;
  std::vector<std::array<bool, 2> > m_is_constrained;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_REDUCED_SYSTEM_H
