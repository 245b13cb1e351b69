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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FLAT_VOLUME_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FLAT_VOLUME_H

#include <CGAL/license/Seamless_snapping.h>

// The part of a parametrized tetrahedral mesh that constraints concern: cells with their
// corners in plain arrays, and the lists of facets and edges that constraints are about.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/transitions/Cube_rotations.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Facet_vectors = Side_vectors<Cube_rotations>;

// 4 c + i: corner i of cell c, and the facet of cell c opposite to it.
using Corner_index = std::int32_t;

// In place of the facet on the other side.
constexpr Corner_index no_facet = -1;        // there is no cell
constexpr Corner_index facet_elsewhere = -2; // the cell is not here, and both sides are the same

// The corners of a facet, in a fixed order.
inline std::array<Corner_index, 3> corners_of_facet(const Corner_index facet)
{
  const Corner_index i = facet % 4, first = facet - i;
  return {first + (i + 1) % 4, first + (i + 2) % 4, first + (i + 3) % 4};
}

// The ends of the edge that a facet has opposite to its corner `third`.
inline std::array<Corner_index, 2> edge_of_facet(const Corner_index facet, const Corner_index third)
{
  std::array<Corner_index, 2> result{{-1, -1}};
  for(const Corner_index corner : corners_of_facet(facet))
    if(corner != third)
      result[result[0] < 0 ? 0 : 1] = corner;
  return result;
}

// Cells that the caller lists in the other orientation than most cells around, and all cells of
// components that are mostly negative in the domain. Inside, their first two corners are exchanged,
// so that signs of volumes mean the same in all cells.
struct Turned_cells
{
  std::vector<char> is_turned; // per cell of the caller's; empty if none is

  // The caller's key of a corner.
  std::size_t key(const std::size_t corner) const
  {
    return !is_turned.empty() && is_turned[corner / 4] != 0 && corner % 4 < 2 ? corner ^ 1 : corner;
  }
};

// The images of the corners of a cell.
inline Uvw_tetrahedron uvw_of_cell(const std::vector<Uvw>& u, const std::size_t c)
{
  return {u[4 * c], u[4 * c + 1], u[4 * c + 2], u[4 * c + 3]};
}

// The cells that are not positive, exactly.
inline std::vector<std::size_t> nonpositive_cells(const std::vector<Uvw>& u)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < u.size() / 4; ++c)
    if(orientation(uvw_of_cell(u, c)) != CGAL::POSITIVE)
      result.push_back(c);
  return result;
}

// Six times the volume of a cell, in floating point.
inline double six_times_volume(const Uvw_tetrahedron& u)
{
  return inner_product(vector_to(u[0], u[1]),
                       vector_product(vector_to(u[0], u[2]), vector_to(u[0], u[3])));
}

// The normals of the facets opposite to the four corners, from three edges at the first corner: how
// six times the volume grows as a corner moves.
inline std::array<Uvw, 4> facet_normals(const std::array<Uvw, 3>& e)
{
  std::array<Uvw, 4> result{};
  for(std::size_t i = 0; i < 3; ++i) {
    result[i + 1] = vector_product(e[(i + 1) % 3], e[(i + 2) % 3]);
    for(std::size_t c = 0; c < 3; ++c)
      result[0][c] -= result[i + 1][c];
  }
  return result;
}

// The place of a problem, for messages: "facet 3, 4, 7".
inline Message name_of(const char* const what, const std::vector<std::int64_t>& vertices)
{
  Message result;
  for(const std::int64_t v : vertices)
    result += result.empty() ? name_of_vertex(std::size_t(v), what)
                             : ", " + name_of_vertex(std::size_t(v), "");
  return result;
}

// Invariants: the cells are all cells of the caller's mesh with a vertex that is not fixed.
// The sides of facets that are not open are the same to the bit.
struct Flat_volume
{
  struct Aligned_edge // as one of its cells sees it
  {
    Corner_index a, b;
    int direction = -1; // the coordinate that is not constant, where it is known
  };

  std::vector<std::int32_t> vertices;       // per corner
  std::vector<Uvw> coordinates;             // per corner
  std::vector<Corner_index> opposite;       // per facet: the other side
  std::vector<std::int32_t> cell_names;     // per cell: its place in the caller's range
  Turned_cells turned;                      // by these names
  std::vector<std::int64_t> vertex_names;   // per vertex: the caller's
  std::vector<char> is_fixed;               // per vertex: no constraint concerns it
  std::vector<Corner_index> open_facets;    // facets whose sides differ, seen from one cell
  std::vector<Corner_index> aligned_facets; // likewise
  std::vector<Aligned_edge> aligned_edges;
  double extent = 0; // coordinates of all cells of the mesh

  std::size_t number_of_cells() const { return cell_names.size(); }
  std::size_t number_of_vertices() const { return vertex_names.size(); }

  std::int32_t vertex(const Corner_index corner) const { return vertices[std::size_t(corner)]; }
  const Uvw& uvw(const Corner_index corner) const { return coordinates[std::size_t(corner)]; }

  // The caller's key of a corner.
  std::size_t key(const std::size_t corner) const
  {
    return turned.key(4 * std::size_t(cell_names[corner / 4]) + corner % 4);
  }

  // Per facet, seen from either side: its place in a list of facets, or -1.
  std::vector<std::int32_t> places_in(const std::vector<Corner_index>& facets) const
  {
    std::vector<std::int32_t> result(opposite.size(), -1);
    for(std::size_t i = 0; i < facets.size(); ++i)
      for(const Corner_index side : {facets[i], opposite[std::size_t(facets[i])]})
        if(side >= 0)
          result[std::size_t(side)] = std::int32_t(i);
    return result;
  }

  // The corner at the same vertex, in the cell on the other side of a facet.
  Corner_index across(const Corner_index facet, const Corner_index corner) const
  {
    const Corner_index other = opposite[std::size_t(facet)], first = other - other % 4;
    Corner_index result = first;
    while(vertex(result) != vertex(corner))
      ++result;
    return result;
  }

  Facet_sides sides(const Corner_index facet) const { return sides(facet, coordinates); }

  // The sides with other coordinates.
  Facet_sides sides(const Corner_index facet, const std::vector<Uvw>& u) const
  {
    Facet_sides result;
    const auto corners = corners_of_facet(facet);
    for(std::size_t i = 0; i < 3; ++i) {
      result.here[i] = u[std::size_t(corners[i])];
      result.there[i] = u[std::size_t(across(facet, corners[i]))];
    }
    return result;
  }

  // The translation across a facet with the rotation g.
  Uvw translation(const Corner_index facet, const Cube_rotations::Element g) const
  {
    const Corner_index corner = corners_of_facet(facet)[0];
    return vector_to(Cube_rotations::apply(g, uvw(corner)), uvw(across(facet, corner)));
  }

  Message name_of_facet(const Corner_index facet) const
  {
    std::vector<std::int64_t> names;
    for(const Corner_index corner : corners_of_facet(facet))
      names.push_back(vertex_names[std::size_t(vertex(corner))]);
    return name_of("facet", names);
  }

  Message name_of_edge(const Aligned_edge& edge) const
  {
    return name_of("edge", {vertex_names[std::size_t(vertex(edge.a))],
                            vertex_names[std::size_t(vertex(edge.b))]});
  }
};

// The differences of the coordinates of some corners.
template <std::size_t number>
Uvw spread(const Flat_volume& volume, const std::array<Corner_index, number>& corners)
{
  Uvw least = volume.uvw(corners[0]), largest = least;
  for(const Corner_index corner : corners)
    for(std::size_t c = 0; c < 3; ++c) {
      least[c] = (std::min)(least[c], volume.uvw(corner)[c]);
      largest[c] = (std::max)(largest[c], volume.uvw(corner)[c]);
    }
  return vector_to(least, largest);
}

// In a cell, between the facets opposite to two corners.
inline double dihedral_angle(const Flat_volume& volume, const Corner_index i, const Corner_index j)
{
  const std::array<Corner_index, 2> edge = edge_of_facet(i, j);
  const Uvw &a = volume.uvw(edge[0]), &b = volume.uvw(edge[1]);
  const auto normal = [&](const Corner_index corner) {
    return scaled_to_unit_size(vector_product(scaled_to_unit_size(vector_to(a, b)),
                                              scaled_to_unit_size(
                                                vector_to(a, volume.uvw(corner)))));
  };
  const Uvw m = normal(i), n = normal(j), x = vector_product(m, n);
  return std::atan2(std::sqrt(inner_product(x, x)), inner_product(m, n));
}

// Walks around an edge, from facet to facet. Invariant: `facet()` contains the edge, as the cell
// sees it that was entered.
class Facet_ring
{
public:
  // Begins inside the cell of `facet`, at the edge that the facet has opposite to its corner
  // `third`; the walk goes through that cell first.
  Facet_ring(const Flat_volume& volume, const Corner_index facet, const Corner_index third)
    : m_volume(volume), m_start(facet), m_start_other(volume.opposite[std::size_t(facet)]),
      m_facet(facet), m_third(third)
  { }

  // Goes to the other facet of the cell; that is seen from the same cell.
  void turn()
  {
    // the facet opposite to `third` contains the edge and the corner opposite to the former facet
    const Corner_index former = m_facet;
    m_facet = m_third;
    m_third = former;
  }

  // Whether there is a cell on the other side, and it is known.
  bool can_cross() const { return m_volume.opposite[std::size_t(m_facet)] >= 0; }

  // Enters the cell on the other side.
  void cross()
  {
    const Corner_index third = m_volume.across(m_facet, m_third);
    m_facet = m_volume.opposite[std::size_t(m_facet)];
    m_third = third;
  }

  Corner_index facet() const { return m_facet; }
  Corner_index third() const { return m_third; } // the corner of the facet opposite to the edge
  bool is_closed() const { return m_facet == m_start || m_facet == m_start_other; }

private:
  const Flat_volume& m_volume;
  Corner_index m_start, m_start_other, m_facet, m_third;
};

// Other charts for the cells, in which most facets are no cuts.
// In place of u, the system is about g u + shift, with the g and shift of the cell's chart. Turning
// and moving the chart of a cell changes nothing but what is called the transitions across its
// facets.
struct Volume_charts
{
  using Group = Cube_rotations;

  // Leaves all cells where they are.
  explicit Volume_charts(const std::size_t number_of_cells = 0)
    : chart_of_cell(number_of_cells, 0), elements(1, Group::identity()), shifts(1), roots(1, 0)
  { }

  std::vector<std::int32_t> chart_of_cell;
  std::vector<Group::Element> elements; // per chart
  std::vector<Uvw> shifts;              // per chart
  std::vector<std::int32_t> roots;      // per chart: one that is joined with it

  std::size_t chart(const std::size_t corner) const
  {
    return std::size_t(chart_of_cell[corner / 4]);
  }

  // A name of all charts that are joined with the chart of a corner.
  std::size_t root(const Corner_index corner) const
  {
    return std::size_t(roots[chart(std::size_t(corner))]);
  }

  // From the coordinates of the input to the coordinates of the system.
  Group::Element element(const std::size_t corner) const
  {
    return elements[chart(corner)];
  }

  double shift(const std::size_t corner, const std::size_t c) const
  {
    return shifts[chart(corner)][c];
  }

  // Coordinate c in the system of what has coordinates `u` in the input.
  double coordinate(const Uvw& u, const std::size_t corner, const std::size_t c) const
  {
    const Group::Element g = elements[chart(corner)];
    return Group::sign(g, c) * u[Group::source(g, c)] + shifts[chart(corner)][c];
  }

  // Which coordinate of the system coordinate c of the input becomes.
  std::size_t column(const std::size_t corner, const std::size_t c) const
  {
    return Group::source(Group::inverse(element(corner)), c);
  }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_FLAT_VOLUME_H
