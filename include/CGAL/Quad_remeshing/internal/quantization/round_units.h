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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_ROUND_UNITS_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_ROUND_UNITS_H

#include <CGAL/license/Quad_remeshing.h>

// Integer vectors for the edges of a complex, near real-valued ones: they close all triangles,
// match across edges, and keep walls on their isocurves. Not all triangles need be positive.

#include <CGAL/Linear_snapping/internal/linear/Linear_solver.h>
#include <CGAL/Quad_remeshing/internal/quantization/wanted_units.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: the constraints are eliminated.
class Unit_rounder
{
public:
  // \param scales units per step of the input's grid, for each connected part
  Unit_rounder(Intrinsic_complex& complex, const std::vector<double>& scales)
    : m_complex(complex), m_wanted(wanted_units(complex, scales)), m_columns(columns()),
      m_solver(system(), weights(), Number_format::of<double>(), m_number_of_columns, false)
  { }

  // Sets the units near the vectors wanted. Returns false if the solver finds none.
  bool round()
  {
    const Grid units(Number_format::of<double>(), 0);
    Linear_target target{std::vector<Grid>(m_solver.number_of_components(), units),
                         std::vector<Grid_value>(m_number_of_columns)};
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h))
        for(std::size_t c = 0; c < 2; ++c)
          target.values[std::size_t(column(h, c))] = units.split(m_wanted[std::size_t(h)][c]);
    Linear_solution solution;
    if(m_solver.solve(target, solution) >= 0)
      return false;
    for(const Grid& grid : solution.grids)
      if(grid.exponent() != 0)
        return false;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h)) {
        Intrinsic_corner& corner = m_complex.corners[std::size_t(h)];
        corner.units = {solution.x[std::size_t(column(h, 0))],
                        solution.x[std::size_t(column(h, 1))]};
        if(corner.opposite != no_index)
          m_complex.corners[std::size_t(corner.opposite)].units =
            negated(rotated(corner.rotation, corner.units));
      }
    return true;
  }

private:
  std::vector<Column_index> columns()
  {
    std::vector<Column_index> result(m_complex.corners.size());
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h)) {
        result[std::size_t(h)] = Column_index(m_number_of_columns);
        m_number_of_columns += 2;
      }
    return result;
  }

  Column_index column(const Corner_index key, const std::size_t component) const
  { return m_columns[std::size_t(key)] + Column_index(component); }

  Scaled_system system() const
  {
    System_builder builder(m_number_of_columns);
    Entries<std::int64_t> row;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      for(std::size_t c = 0; c < 2; ++c) {
        if(h % 3 == 0) {
          row.clear();
          for(Corner_index k = h; k < h + 3; ++k)
            row.push_back(entry(k, c));
          builder.add_row(row);
        }
        if(m_complex.represents_edge(h) && m_complex.corner(h).is_wall &&
           m_complex.corner(h).vector[c] == 0)
          builder.add_row({{column(h, c), 1}});
      }
    return builder.take();
  }

  // Component c of a halfedge's vector in terms of the halfedge that stands for its edge.
  Entry<std::int64_t> entry(const Corner_index h, const std::size_t c) const
  {
    const Corner_index key = m_complex.edge_key(h);
    if(key == h)
      return {column(h, c), 1};
    const auto& row = Quarter_turns::matrix(m_complex.corner(key).rotation)[c];
    const std::size_t d = row[0] != 0 ? 0 : 1;
    return {column(key, d), -row[d]};
  }

  std::vector<double> weights() const
  {
    std::vector<double> result(m_number_of_columns);
    for(Corner_index h = 0; h < m_complex.number_of_halfedges(); ++h)
      if(m_complex.represents_edge(h))
        for(std::size_t c = 0; c < 2; ++c)
          result[std::size_t(column(h, c))] = weight_of_edge(m_wanted[std::size_t(h)]);
    return result;
  }

  Intrinsic_complex& m_complex;
  std::vector<Wanted_vector> m_wanted; // per halfedge
  std::size_t m_number_of_columns = 0;
  std::vector<Column_index> m_columns; // per halfedge that stands for its edge: the first of two
  Linear_solver m_solver;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_ROUND_UNITS_H
